//! Drawing of the regions in which p-loop MPSs are admissible at generic grazing.

use grazing_drawing::geometry::placement::side_by_side;
use grazing_drawing::geometry::sheet::Bounds;
use grazing_drawing::ink::canvas::{Anchor, Canvas};
use grazing_drawing::ink::elements::Stroke;
use grazing_drawing::ink::legend;
use grazing_drawing::ink::style::{
    BLACK, GREY, LABEL_SIZE, NON_IMPACTING_AREA, Paint, Pen, SMALL_LABEL_SIZE, branch_pen,
};
use grazing_drawing::plot::axes::Panel;
use grazing_reproduction::prelude::*;
use grazing_results::Frame;

use super::{RegionLevel, Regions};

const WIDTH_MM: f64 = 165.0;
const HEIGHT_MM: f64 = 150.0;
const TRAPESIUM: Frame = Frame { x: [-2.05, 2.05], y: [0.0, 1.0] };
const CORNERS: [(f64, f64); 5] = [(-1.0, 0.0), (1.0, 0.0), (2.0, 1.0), (-2.0, 1.0), (-1.0, 0.0)];
const ROTATIONS: Frame = Frame { x: [0.0, 1.0], y: [0.7, 1.0] };
const OUTLINE: Pen = Pen::solid(BLACK, 0.8);
const LEADER: Pen = Pen::solid(GREY, 0.3);
/// The font size of the names, which are not numbers of an axis, in points.
const NAME_SIZE: f64 = 7.0;
/// Room above the panel of rotations for the names, in points.
const NAMES_ABOVE: f64 = 12.0;

/// The paint of a region. Those of Theorem 2.3 are also outlined.
const fn area(p: u32) -> Paint {
    Paint { colour: branch_pen(p, 1.0).colour, opacity: 0.3 }
}

fn outline(rows: &[RegionLevel], ends: impl Fn(&RegionLevel) -> [f64; 2]) -> Vec<(f64, f64)> {
    let side = |k: usize| rows.iter().map(move |row| (row, k));
    side(0).rev().chain(side(1)).map(|(row, k)| (ends(row)[k], row.delta)).collect()
}

/// Draws the figure.
pub(super) fn draw(figure: &Regions, width: SheetWidth) -> Result<Sheet, DrawingError> {
    let canvas = Canvas::new(width.mm(WIDTH_MM), HEIGHT_MM)?;
    let (middle, across) = (0.5 * canvas.width, 0.5 * canvas.height);
    let upper = |left: f64, right: f64| Bounds { left, top: 36.0, right, bottom: across - 32.0 };
    let [first, second] = [
        (upper(37.0, middle - 8.0), r"$a_{12}\,\alpha>0$"),
        (upper(middle + 37.0, canvas.width - 8.0), r"$a_{12}\,\alpha<0$"),
    ]
    .map(|(bounds, name)| Ok::<_, DrawingError>((Panel::new(&canvas, TRAPESIUM, bounds)?, name)));
    let mut trapesia = [first?, second?];
    let below =
        Bounds { left: 37.0, top: across + 22.0, right: canvas.width - 8.0, bottom: canvas.height - 30.0 };
    let mut rotations = Panel::new(&canvas, ROTATIONS, below)?;
    let regions: Vec<_> = figure.levels.chunk_by(|a, b| (a.loops, a.turns) == (b.loops, b.turns)).collect();

    for (panel, name) in &mut trapesia {
        panel.draw_series(panel.area(&[CORNERS.to_vec()], NON_IMPACTING_AREA))?;
        panel.draw_series(panel.curve(&CORNERS, OUTLINE))?;
        let middle = 0.5 * (panel.bounds.left + panel.bounds.right);
        canvas.text((middle, panel.bounds.top - 5.0), name, SMALL_LABEL_SIZE, Anchor::Middle, BLACK)?;
    }
    let mut names = Vec::new();
    for rows in &regions {
        let RegionLevel { loops, turns, .. } = rows[0];
        let pen = branch_pen(loops, if turns == 1 { 0.9 } else { 0.5 });
        let in_trapesium = outline(rows, |row| [row.low, row.high]);
        let in_rotations = outline(rows, |row| [row.left, row.right]);
        let (trapesium, _) = &mut trapesia[usize::from(2 * turns > loops)];
        for (panel, places) in [(trapesium, in_trapesium), (&mut rotations, in_rotations)] {
            let line = panel.curve(&places, pen);
            if turns > 1 {
                panel.draw_series(panel.area(&[places], area(loops)))?;
            }
            panel.draw_series(line)?;
        }
        let end = f64::from(turns) / f64::from(loops);
        names.push((rotations.spot((end, 1.0)), loops, pen));
    }
    // Only the names of the fewest loops are kept, as many as fit side by side.
    names.sort_by_key(|name| name.1);
    names.truncate(((below.right - below.left) / 9.5) as usize);
    names.sort_by(|a, b| a.0.0.total_cmp(&b.0.0));
    let boxes: Vec<(f64, f64)> = names.iter().map(|(spot, ..)| (spot.0, 8.0)).collect();
    for ((spot, loops, pen), x) in names.iter().zip(side_by_side(&boxes, 1.0)) {
        let leader = [(spot.0, spot.1 - 0.6), (x, below.top - NAMES_ABOVE + 2.0)];
        canvas.draw(&Stroke::new(leader, LEADER))?;
        canvas.text(
            (x, below.top - NAMES_ABOVE),
            &format!("${loops}$"),
            NAME_SIZE,
            Anchor::Middle,
            pen.colour,
        )?;
    }
    canvas.explain("Theorem 2.3", legend::line(branch_pen(2, 0.9)))?;
    canvas.explain("beyond $h_p$", legend::area(area(3)))?;
    for (panel, _) in &trapesia {
        panel.axes(r"$\tau$", r"$\delta$")?;
    }
    rotations.axes("$x$", r"$\delta$")?;
    let [(first, _), (second, _)] = &trapesia;
    for (panel, rise, letter) in
        [(first, 5.0, "(a)"), (second, 5.0, "(b)"), (&rotations, NAMES_ABOVE + 9.0, "(c)")]
    {
        let Bounds { left, top, .. } = panel.bounds;
        canvas.text((left, top - rise), letter, LABEL_SIZE, Anchor::Start, BLACK)?;
    }
    canvas.finish(
        "beyond_regions",
        "Where p-loop solutions are admissible at generic grazing",
        "(a), (b) Trace across, determinant up, for either sign of a12 alpha. (c) The rotation x of free motion in a forcing period \
         across. Outlined: the regions of Theorem 2.3; filled: all others. Numbers: p, over the end m/p of a region.",
    )
}
