//! Drawing of Figure 4: the boundaries g_p and h_p in the trapesium.

use grazing_drawing::geometry::placement::side_by_side;
use grazing_drawing::geometry::sheet::{Bounds, Spot};
use grazing_drawing::ink::canvas::{Anchor, Canvas};
use grazing_drawing::ink::elements::Stroke;
use grazing_drawing::ink::labels::{Labels, Site};
use grazing_drawing::ink::legend;
use grazing_drawing::ink::markers::Marker;
use grazing_drawing::ink::markup::Label;
use grazing_drawing::ink::style::{
    BLACK, GREY, LABEL_SIZE, NON_IMPACTING_AREA, Pen, SMALL_LABEL_SIZE, branch_pen,
};
use grazing_drawing::plot::axes::Panel;
use grazing_results::Frame;

use super::{Boundaries, Boundary, BoundaryPoint};
use crate::figure::prelude::*;

/// The pen of a boundary g_p: solid, in the colour of the branch with the same p.
const fn resonance_pen(p: u32) -> Pen {
    branch_pen(p, 1.1)
}

/// The pen of a boundary h_p: the colour of g_p, with short dashes.
const fn admissibility_pen(p: u32) -> Pen {
    Pen { dashes: &[2.6, 1.3], ..branch_pen(p, 1.1) }
}

/// The pen of the limit of both families of boundaries.
const LIMIT: Pen = Pen::solid(BLACK, 0.6);
/// The pen of the outline of the trapesium.
const OUTLINE: Pen = Pen::solid(BLACK, 0.8);
/// The pen of the line from a curve's end to its label.
const CURVE_LEADER: Pen = Pen::solid(GREY, 0.4);

/// The pen of the curve to which a point belongs, and its name.
fn pen_and_name(BoundaryPoint { kind, loops: p, .. }: &BoundaryPoint) -> (Pen, String) {
    match kind {
        Boundary::Trapesium => (OUTLINE, String::new()),
        Boundary::Limit => (LIMIT, r"$2\,\sqrt\delta$".to_owned()),
        Boundary::Resonance => (resonance_pen(*p), format!("$g_{{{p}}}$")),
        Boundary::Admissibility => (admissibility_pen(*p), format!("$h_{{{p}}}$")),
    }
}

/// The coordinates of a point in the panel.
fn place(point: &BoundaryPoint) -> (f64, f64) {
    (point.tau, point.delta)
}

/// The width of this figure in the paper.
const WIDTH_MM: f64 = 120.0;
const HEIGHT_MM: f64 = 74.0;
/// The trapesium with a little room at its sharp corners.
const TRAPESIUM_FRAME: Frame = Frame { x: [-2.12, 2.12], y: [0.0, 1.0] };
/// Room above the panel for leaders and the names of the curves.
const NAMES_ABOVE: f64 = 10.0;
/// The least gap between two names, in points.
const NAME_GAP: f64 = 3.0;

/// Draws Figure 4.
pub(super) fn draw(figure: &Boundaries, width: SheetWidth) -> Result<Sheet, DrawingError> {
    let curves: Vec<_> = figure.curves.chunk_by(|a, b| (a.kind, a.loops) == (b.kind, b.loops)).collect();
    let (outlines, others): (Vec<_>, Vec<_>) =
        curves.iter().copied().partition(|curve| curve[0].kind == Boundary::Trapesium);

    let canvas = Canvas::new(width.mm(WIDTH_MM), HEIGHT_MM)?;
    let bounds = Bounds { left: 37.0, top: 23.0, right: canvas.width - 12.0, bottom: canvas.height - 30.0 };
    let mut panel = Panel::new(&canvas, TRAPESIUM_FRAME, bounds)?;
    let mut labels = Labels::new(&canvas, bounds);

    for outline in &outlines {
        let corners = outline.iter().map(place).collect();
        panel.draw_series(panel.area(&[corners], NON_IMPACTING_AREA))?;
    }
    canvas.explain("$g_p$", legend::line(resonance_pen(0)))?;
    canvas.explain("$h_p$", legend::line(admissibility_pen(0)))?;
    for curve in &curves {
        let (pen, _) = pen_and_name(&curve[0]);
        let mut drawn = panel.draw_series(panel.curve(&curve.iter().map(place).collect::<Vec<_>>(), pen))?;
        if curve[0].kind == Boundary::Resonance {
            drawn = drawn.label(&format!("$p={}$", curve[0].loops)).legend(legend::line(pen))?;
        }
        drawn.pieces.iter().for_each(|piece| labels.placer.keep_off(piece));
    }
    panel.axes(r"$\tau$", r"$\delta$")?;
    name_above(&panel, &others)?;
    let points = figure.points.iter().map(|point| (point.tau, point.delta));
    for spot in panel.mark(&mut labels, points, Marker::Star)?.pieces.concat() {
        let taken = Marker::Star.around(spot);
        let reach = 0.5 * (taken.right - taken.left);
        labels.add("Fig. 2", SMALL_LABEL_SIZE, BLACK, &Site::Around(spot, reach))?;
    }
    for outline in &outlines {
        // Only the slanted sides are labelled; the others can be read off the axis.
        for side in outline.windows(2).filter(|side| side[0].delta != side[1].delta) {
            let text = if side[0].tau > 0.0 { r"$\tau=\delta+1$" } else { r"$\tau=-\delta-1$" };
            let edge = [0, 1].map(|end| panel.spot(place(&side[end])));
            labels.add(text, SMALL_LABEL_SIZE, BLACK, &Site::Beside(&edge))?;
        }
    }
    labels.draw()?;
    canvas.finish(
        "fig04",
        "The boundaries g_p and h_p in the trapesium",
        "Trace across, determinant up. Solid: tau = g_p(delta), where the p-loop solution is in resonance. Dashed: tau = \
         h_p(delta), beyond which it is known to be admissible. Star: the grazing bifurcation of Figure~2.",
    )
}

/// Labels the curves in a row above their upper ends.
fn name_above(panel: &Panel<'_>, curves: &[&[BoundaryPoint]]) -> Result<(), DrawingError> {
    let mut ends: Vec<(Spot, f64, (Pen, String))> = Vec::new();
    for curve in curves {
        if let Some(end) = curve.last().map(place).filter(|&end| panel.frame.contains(end)) {
            // For curves that end in the same point, the direction of approach decides which is on the
            // left.
            let before = place(&curve[curve.len() * 19 / 20]);
            ends.push((panel.spot(end), panel.spot(before).0, pen_and_name(&curve[0])));
        }
    }
    ends.sort_by(|a, b| (a.0.0 + a.1).total_cmp(&(b.0.0 + b.1)));
    let mut boxes = Vec::new();
    for (end, _, (_, name)) in &ends {
        let extent = panel.canvas.fonts.measure(&Label::parse(name)?, LABEL_SIZE)?;
        boxes.push((end.0, extent.width));
    }
    for ((end, _, (pen, name)), x) in ends.iter().zip(side_by_side(&boxes, NAME_GAP)) {
        let top = panel.bounds.top;
        let leader = [(end.0, end.1 - 0.6), (x, top - NAMES_ABOVE + 2.5)];
        panel.canvas.draw(&Stroke::new(leader, CURVE_LEADER))?;
        panel.canvas.text((x, top - NAMES_ABOVE), name, LABEL_SIZE, Anchor::Middle, pen.colour)?;
    }
    Ok(())
}
