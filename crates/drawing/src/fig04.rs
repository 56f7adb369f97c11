//! Figure 4: the boundaries g_p and h_p in the trapesium.

use grazing_results::Frame;
use grazing_results::sketches::{Boundary, BoundaryPoint, Figure4};

use crate::DrawingError;
use crate::axes::{Marker, Panel};
use crate::canvas::{Anchor, Canvas};
use crate::labels::{Labels, Wanted};
use crate::legend::Sample;
use crate::markup::Label;
use crate::placement::side_by_side;
use crate::sheet::{Bounds, Spot};
use crate::style::{
    BLACK, CURVE_LEADER, LABEL_SIZE, LIMIT, NON_IMPACTING_AREA, OUTLINE, Pen, SMALL_LABEL_SIZE, SheetWidth,
    admissibility_pen, resonance_pen,
};

struct BoundaryCurve {
    family: Boundary,
    p: u32,
    points: Vec<(f64, f64)>,
}

impl BoundaryCurve {
    fn pen(&self) -> Pen {
        match self.family {
            Boundary::Trapesium => OUTLINE,
            Boundary::Limit => LIMIT,
            Boundary::Resonance => resonance_pen(self.p),
            Boundary::Admissibility => admissibility_pen(self.p),
        }
    }

    fn label(&self) -> String {
        match self.family {
            Boundary::Trapesium => String::new(),
            Boundary::Limit => r"$2\,\sqrt\delta$".to_owned(),
            Boundary::Resonance => format!("$g_{{{}}}$", self.p),
            Boundary::Admissibility => format!("$h_{{{}}}$", self.p),
        }
    }
}

/// Width in the paper.
const WIDTH_MM: f64 = 120.0;
const HEIGHT_MM: f64 = 74.0;
/// The trapesium with a little room at its sharp corners.
const SHOWN: Frame = Frame { x: [-2.12, 2.12], y: [0.0, 1.0] };
/// Room above the panel: leaders, and the names of the curves.
const NAMES_ABOVE: f64 = 10.0;
/// Least gap between two names, in points.
const NAME_GAP: f64 = 3.0;

/// Draws Figure 4. Paper: fig:D.
pub fn draw_fig04(figure: &Figure4, width: SheetWidth) -> Result<String, DrawingError> {
    let curves = shown_curves(&figure.curves);

    let canvas = Canvas::new(width.mm(WIDTH_MM), HEIGHT_MM)?;
    let bounds = Bounds { left: 37.0, top: 23.0, right: canvas.width - 12.0, bottom: canvas.height - 30.0 };
    let panel = Panel::new(&canvas, SHOWN, bounds);
    let mut labels = Labels::new(&canvas, bounds);

    for curve in curves.iter().filter(|curve| curve.family == Boundary::Trapesium) {
        panel.fill(&curve.points, NON_IMPACTING_AREA);
    }
    canvas.explain("$g_p$", Sample::Line(resonance_pen(0)));
    canvas.explain("$h_p$", Sample::Line(admissibility_pen(0)));
    for curve in &curves {
        if curve.family == Boundary::Resonance {
            canvas.explain(&format!("$p={}$", curve.p), Sample::Line(curve.pen()));
        }
        for piece in panel.line(&curve.points, curve.pen()) {
            labels.placer.keep_off(&piece);
        }
    }
    panel.axes(r"$\tau$", r"$\delta$")?;
    name_above(&panel, &curves)?;
    for point in figure.points.iter().map(|point| (point.tau, point.delta)) {
        if let Some(taken) = panel.marker(point, Marker::Star) {
            labels.placer.block(taken);
            let reach = 0.5 * (taken.right - taken.left);
            labels.add("Fig. 2", SMALL_LABEL_SIZE, BLACK, &Wanted::Around(panel.spot(point), reach))?;
        }
    }
    for curve in curves.iter().filter(|curve| curve.family == Boundary::Trapesium) {
        // Of the sides, the slanted ones say what they are; the others are read off the axis.
        for side in curve.points.windows(2).filter(|side| side[0].1 != side[1].1) {
            let text = if side[0].0 > 0.0 { r"$\tau=\delta+1$" } else { r"$\tau=-\delta-1$" };
            let edge = [panel.spot(side[0]), panel.spot(side[1])];
            labels.add(text, SMALL_LABEL_SIZE, BLACK, &Wanted::Beside(&edge))?;
        }
    }
    labels.draw()?;
    canvas.finish(
        "fig04",
        "The boundaries g_p and h_p in the trapesium",
        "Trace across, determinant up. Solid: tau = g_p(delta), where the p-loop solution is in resonance. Dashed: tau = \
         h_p(delta), beyond which it is known to be admissible. Star: the grazing bifurcation of Figure 2.",
    )
}

/// Names the curves in a row above their upper ends.
fn name_above(panel: &Panel<'_>, curves: &[BoundaryCurve]) -> Result<(), DrawingError> {
    let mut ends: Vec<(Spot, f64, &BoundaryCurve)> = Vec::new();
    for curve in curves.iter().filter(|curve| curve.family != Boundary::Trapesium) {
        if let Some(&end) = curve.points.last().filter(|&&end| panel.frame.contains(end)) {
            // Of curves that end in one point, where they come from tells which is to the left.
            let before = curve.points[curve.points.len() * 19 / 20];
            ends.push((panel.spot(end), panel.spot(before).0, curve));
        }
    }
    ends.sort_by(|a, b| (a.0.0 + a.1).total_cmp(&(b.0.0 + b.1)));
    let mut boxes = Vec::new();
    for (end, _, curve) in &ends {
        let extent = panel.canvas.fonts.measure(&Label::parse(&curve.label())?, LABEL_SIZE)?;
        boxes.push((end.0, extent.width));
    }
    for ((end, _, curve), x) in ends.iter().zip(side_by_side(&boxes, NAME_GAP)) {
        let top = panel.bounds.top;
        let leader = [(end.0, end.1 - 0.6), (x, top - NAMES_ABOVE + 2.5)];
        panel.canvas.line(&leader, CURVE_LEADER);
        let spot = (x, top - NAMES_ABOVE);
        panel.canvas.text(spot, &curve.label(), LABEL_SIZE, Anchor::Middle, curve.pen().colour)?;
    }
    Ok(())
}

fn shown_curves(points: &[BoundaryPoint]) -> Vec<BoundaryCurve> {
    let curve = |points: &[BoundaryPoint]| BoundaryCurve {
        family: points[0].kind,
        p: points[0].loops,
        points: points.iter().map(|point| (point.tau, point.delta)).collect(),
    };
    points.chunk_by(|a, b| (a.kind, a.loops) == (b.kind, b.loops)).map(curve).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples::study;

    #[test]
    fn every_curve_is_named_and_families_differ_without_colour() {
        let figure = study().fig04().unwrap();
        let svg = draw_fig04(&figure, SheetWidth::Paper).unwrap();
        let svg = svg.split("<defs").next().unwrap();
        let curves = shown_curves(&figure.curves);
        for (kind, family) in [(Boundary::Resonance, "g"), (Boundary::Admissibility, "h")] {
            let own = curves.iter().filter(|curve| curve.family == kind);
            assert_eq!(svg.matches(&format!(">{family}</tspan>")).count(), own.clone().count());
            for BoundaryCurve { p, .. } in own {
                assert!(svg.contains(&format!(">{p}</tspan>")), "{p}");
            }
        }
        assert!(svg.contains(">Fig. 2<") && svg.contains('√'));
        // Both slanted sides: δ + 1 and −δ − 1, besides the axis titles and the limit.
        assert_eq!(svg.matches(">δ</tspan>").count(), 4);
        let families = svg.matches("stroke-width=\"1.1\"").count();
        assert_eq!(2 * svg.matches("stroke-width=\"1.1\" stroke-dasharray").count(), families);
    }
}
