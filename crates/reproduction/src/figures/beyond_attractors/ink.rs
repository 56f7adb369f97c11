//! The map, with the curves of Figure 7 on top.

use grazing_drawing::geometry::sheet::Bounds;
use grazing_drawing::ink::canvas::{Anchor, Canvas};
use grazing_drawing::ink::labels::Labels;
use grazing_drawing::ink::legend::Sample;
use grazing_drawing::ink::style::{BLACK, Colour, GREY, NON_IMPACTING_AREA, Paint, Pen, SMALL_LABEL_SIZE, branch_pen};
use grazing_drawing::plot::axes::Panel;
use grazing_drawing::plot::cloud::draw_cells;
use grazing_drawing::plot::kinds::{draw_curves, draw_points, shown_curves};
use grazing_results::kinds::{IRREGULAR, PERIODIC};

use super::{Attractors, Stretch};
use crate::figure::prelude::*;

/// Width and height in millimetres; room about the panel, and a line of the legend, in points.
const WIDTH_MM: f64 = 156.0;
const HEIGHT_MM: f64 = 136.0;
const LEFT: f64 = 42.0;
const RIGHT: f64 = 8.0;
const BELOW: f64 = 31.0;
const LINE: f64 = 13.0;
const SWATCH: f64 = 16.0;
const SWATCH_RIM: Pen = Pen::solid(GREY, 0.3);
/// Of finer maps not all places are drawn, but every so many across and up.
const DRAWN: u32 = 1000;

/// What is drawn alike, in words, in the order of the legend.
const CLASSES: [&str; 7] =
    ["no impacts", "$p=1$", "$p=2$", "$p=3$", "$p\\ge 4$", "periodic, more impacts", "irregular"];

/// The place of a stretch among these.
fn class(stretch: &Stretch) -> usize {
    match stretch.loops() {
        Some(p) => p.min(4) as usize,
        None if stretch.periods > 0 => 5,
        None => 6,
    }
}

fn colour(class: usize) -> Colour {
    match class {
        0 => NON_IMPACTING_AREA.colour,
        5 => PERIODIC[0],
        6 => IRREGULAR[0],
        p => branch_pen(p as u32, 1.0).colour,
    }
}

/// Draws the map.
pub(super) fn draw(figure: &Attractors, width: SheetWidth) -> Result<Sheet, DrawingError> {
    let canvas = Canvas::new(width.mm(WIDTH_MM), HEIGHT_MM)?;
    let step = figure.size.map(|count| count.div_ceil(DRAWN).max(1));
    let [columns, rows] = [0, 1].map(|k| figure.size[k].div_ceil(step[k]));
    let mut cells: [Vec<(i64, i64)>; CLASSES.len()] = Default::default();
    let by_row: Vec<_> = figure.stretches.chunk_by(|a, b| a.secondary == b.secondary).collect();
    // From the top down, as cells must be.
    for (row, stretches) in (0..).zip(by_row.iter().step_by(step[1] as usize)).collect::<Vec<_>>().into_iter().rev() {
        let mut column = 0;
        for group in stretches.chunk_by(|a, b| a.attractor < b.attractor) {
            let end = column + group[0].places;
            // Where several are seen, rows take turns.
            let class = class(&group[row as usize % group.len()]);
            let drawn = column.div_ceil(step[0])..end.div_ceil(step[0]);
            cells[class].extend(drawn.map(|column| (i64::from(rows - 1 - row), i64::from(column))));
            column = end;
        }
    }
    let seen: Vec<usize> = (0..CLASSES.len()).filter(|&class| !cells[class].is_empty()).collect();
    let bounds = Bounds { left: LEFT, top: 2.0 * LINE + 5.0, right: canvas.width - RIGHT, bottom: canvas.height - BELOW };
    let across = (bounds.right - bounds.left) / 4.0;
    for (&class, number) in seen.iter().zip(0..) {
        let (left, baseline) = (LEFT + across * f64::from(number % 4), LINE * (1.0 + f64::from(number / 4)));
        let paint = Paint::opaque(colour(class));
        let box_of = [(0.0, -6.5), (SWATCH, -6.5), (SWATCH, 0.5), (0.0, 0.5)].map(|(x, y)| (left + x, baseline + y));
        canvas.polygon(&box_of, paint, Some(SWATCH_RIM));
        canvas.text((left + SWATCH + 4.0, baseline), CLASSES[class], SMALL_LABEL_SIZE, Anchor::Start, BLACK)?;
        canvas.explain(CLASSES[class], Sample::Area(paint));
    }
    let mut panel = Panel::new(&canvas, figure.diagram.frame, bounds);
    panel.tables = &["beyond_attractors"];
    for &class in &seen {
        draw_cells(&panel, [columns, rows], &cells[class], colour(class));
    }
    let mut labels = Labels::new(&canvas, bounds);
    draw_curves(&panel, &mut labels, shown_curves(&figure.diagram.curves));
    draw_points(&panel, &mut labels, &figure.diagram.points);
    panel.axes(r"$\mathcal{A}$", r"$\omega$")?;
    canvas.finish(
        "beyond_attractors",
        "What motion comes to in the window of Figure 7",
        "Forcing amplitude across, forcing frequency up. Colour: what motion from four initial states comes to at each place; where they come to \
         different attractors, rows take turns. Curves and points as in Figure 7.",
    )
}
