//! Drawing of the map, with the curves of Figure 7 on top.

use grazing_drawing::geometry::sheet::Bounds;
use grazing_drawing::ink::canvas::{Anchor, Canvas};
use grazing_drawing::ink::elements::Area;
use grazing_drawing::ink::labels::Labels;
use grazing_drawing::ink::legend;
use grazing_drawing::ink::markup::Label;
use grazing_drawing::ink::style::{
    BLACK, Colour, GREY, NON_IMPACTING_AREA, Paint, Pen, SMALL_LABEL_SIZE, WHITE, branch_pen,
};
use grazing_drawing::plot::axes::Panel;
use grazing_drawing::plot::cloud::draw_cells;
use grazing_drawing::plot::kinds::{draw_curves, draw_points, shown_curves};
use grazing_reproduction::prelude::*;
use grazing_results::kinds::{IRREGULAR, PERIODIC};

use super::{Attractors, Stretch, groups};

/// The width and height in millimetres; room around the panel, and the height of a line of the legend, in
/// points.
const WIDTH_MM: f64 = 156.0;
const HEIGHT_MM: f64 = 136.0;
const LEFT: f64 = 42.0;
const RIGHT: f64 = 8.0;
const BELOW: f64 = 31.0;
const LINE: f64 = 13.0;
const SWATCH: f64 = 16.0;
const GAP: f64 = 14.0;
/// The colour of periodic motion with more impacts over more than one period: between that over one
/// period and that of irregular motion, also in lightness.
const LONGER: Colour = [120, 118, 100];
/// The pen of the rim that separates curves from the map.
const CASING: Pen = Pen::solid(WHITE, 2.7);
const SWATCH_RIM: Pen = Pen::solid(GREY, 0.3);
/// The greatest number of places drawn in either direction; of finer maps, only every second, third, …
/// place is drawn.
const DRAWN: u32 = 1000;

/// The descriptions of classes of motion with equal colours, in the order of the legend.
const CLASSES: [&str; 8] = [
    "no impacts",
    "$p=1$",
    "$p=2$",
    "$p=3$",
    "$p\\ge 4$",
    "multi-impact, period 1",
    r"multi-impact, period $\ge 2$",
    "irregular",
];
const SEVERAL: &str = "stripes: several coexist";

/// The index of a stretch's class.
fn class(stretch: &Stretch) -> usize {
    match (stretch.loops(), stretch.periods) {
        (Some(p), _) => p.min(4) as usize,
        (None, 0) => 7,
        (None, 1) => 5,
        (None, _) => 6,
    }
}

fn colour(class: usize) -> Colour {
    match class {
        0 => NON_IMPACTING_AREA.colour,
        5 => PERIODIC[0],
        6 => LONGER,
        7 => IRREGULAR[0],
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
    // Cells must be sorted, from the top down.
    for (row, stretches) in
        (0..).zip(by_row.iter().step_by(step[1] as usize)).collect::<Vec<_>>().into_iter().rev()
    {
        let mut column = 0;
        for group in groups(stretches) {
            let end = column + group[0].places;
            // Where several attractors are seen, rows alternate between them.
            let class = class(&group[row as usize % group.len()]);
            let drawn = column.div_ceil(step[0])..end.div_ceil(step[0]);
            cells[class].extend(drawn.map(|column| (i64::from(rows - 1 - row), i64::from(column))));
            column = end;
        }
    }
    let seen: Vec<usize> = (0..CLASSES.len()).filter(|&class| !cells[class].is_empty()).collect();
    // The legend is written from left to right, line by line.
    let (mut left, mut baseline) = (LEFT, LINE);
    let swatches = seen.iter().map(|&class| (CLASSES[class], Some(Paint::opaque(colour(class)))));
    for (words, paint) in swatches.chain([(SEVERAL, None)]) {
        let before = if paint.is_some() { SWATCH + 4.0 } else { 0.0 };
        let width = before + canvas.fonts.measure(&Label::parse(words)?, SMALL_LABEL_SIZE)?.width;
        if left + width > canvas.width - RIGHT {
            (left, baseline) = (LEFT, baseline + LINE);
        }
        if let Some(paint) = paint {
            let (right, top, bottom) = (left + SWATCH, baseline - 6.5, baseline + 0.5);
            let corners = [(left, top), (right, top), (right, bottom), (left, bottom)];
            canvas.draw(&Area::ring(corners, paint, Some(SWATCH_RIM)))?;
            canvas.explain(words, legend::area(paint))?;
        }
        canvas.text((left + before, baseline), words, SMALL_LABEL_SIZE, Anchor::Start, BLACK)?;
        left += width + GAP;
    }
    let bounds = Bounds {
        left: LEFT,
        top: baseline + 8.0,
        right: canvas.width - RIGHT,
        bottom: canvas.height - BELOW,
    };
    let mut panel = Panel::new(&canvas, figure.diagram.frame, bounds)?;
    panel.tables = &["beyond_attractors"];
    for &class in &seen {
        draw_cells(&mut panel, [columns, rows], &cells[class], colour(class))?;
    }
    let mut labels = Labels::new(&canvas, bounds);
    for curve in shown_curves(&figure.diagram.curves) {
        panel.draw_series(panel.curve(&curve.points, CASING))?;
    }
    draw_curves(&mut panel, &mut labels, shown_curves(&figure.diagram.curves))?;
    draw_points(&mut panel, &mut labels, &figure.diagram.points)?;
    panel.axes(r"$\mathcal{A}$", r"$\omega$")?;
    canvas.finish(
        "beyond_attractors",
        "Long-term behaviour in the window of Figure 7",
        "Forcing amplitude across, forcing frequency up. Colour: the attractor that motion from four initial states reaches at each place; where they reach \
         different attractors, rows alternate between these. Curves and points as in Figure~7.",
    )
}
