//! Whether bifurcations on branches lie on known curves, and the curves that begin at those that do
//! not.

use grazing_continuation::bifurcation::Bifurcation;
use grazing_continuation::curve::{Curve, CurveEnd, Event, Route, SolutionCurve, Window};
use grazing_continuation::locate::{Condition, locate};
use grazing_continuation::mps::{Unknowns, unknown};

use crate::curves::{DiagramCurve, Net};
use crate::segments::{Border, segments};
use crate::tolerances::BETWEEN_BIFURCATIONS;

/// Extent of good solutions, as a fraction of the ranges and about the accuracy of drawn curves,
/// below which no curve is looked for that bounds them, and nothing is left undecided without it:
/// beside the way over a hill of the potential there is any number of such slivers, each thinner
/// than the last. Where they are wider other slices see them.
const SLIVER: f64 = 1e-4;
/// A bifurcation this close to a chord between two points of a curve may belong to the curve.
const NEAR_CURVE: f64 = 0.05;
/// One this close in the plane, as a fraction of the range, may be that of a copy of the solutions on the curve: chords of
/// drawn curves deviate from them by less.
const AT_ONE_PLACE: f64 = 1e-3;

/// Whether the good solutions beside a border have an extent that can be drawn, or grazing bounds
/// them.
pub(super) fn is_wide(border: &Border<'_>, window: Window) -> bool {
    let widths = window.widths();
    border.reach.is_none_or(|reach| [0, 1].iter().any(|&k| reach[k] > SLIVER * widths[k]))
}

/// The bifurcations on a branch that bound good solutions in the window; and all grazing of doubled motion without
/// impacts, at which branches begin.
pub(super) fn bounding(net: &Net, branch: &Curve, window: Window, doubled: bool) -> Vec<Event> {
    let (_, borders) = segments(&net.equations, branch);
    let wide = borders.into_iter().filter(|border| is_wide(border, window));
    let grazing = |event: &&Event| doubled && event.condition == Condition::InteriorGrazing;
    let bounds = wide.filter_map(|border| border.event);
    let inside = |event: &&Event| window.contains(event.solution.parameters());
    bounds.chain(branch.events.iter().filter(grazing)).filter(inside).cloned().collect()
}

/// Whether a bifurcation on a slice or a column lies on a known curve, or is that of a copy of the solutions along it
/// at the same place of the plane: their mirror image, the same motion some forcing periods later, or with another of
/// its impacts first.
pub(super) fn explained(net: &Net, kind: Bifurcation, event: &Event, window: Window) -> bool {
    let here = event.solution.unknowns.clone();
    let secondary = here[unknown::SECONDARY];
    let aside = |point: &Unknowns| (point[unknown::PRIMARY] - here[unknown::PRIMARY]) / window.widths()[0];
    let distance = |point: &Unknowns| {
        let mut gap = net.equations.gap(&here, point);
        gap[unknown::PRIMARY] = aside(point);
        gap[unknown::SECONDARY] = 0.0;
        gap.norm()
    };
    net.curves.iter().filter(|curve| curve.kind == kind).any(|curve| {
        curve.curve.points.windows(2).any(|pair| {
            let [a, b] = [pair[0].solution.unknowns.clone(), pair[1].solution.unknowns.clone()];
            let [from, to] = [a[unknown::SECONDARY] - secondary, b[unknown::SECONDARY] - secondary];
            if from * to > 0.0 {
                return false;
            }
            let way = if from == to { 0.0 } else { from / (from - to) };
            let mut near = &a + (b - &a) * way;
            near[unknown::SECONDARY] = secondary;
            let is_copy = distance(&near) > NEAR_CURVE;
            if is_copy && aside(&near).abs() > AT_ONE_PLACE {
                return false;
            }
            let mut times = pair[0].times.clone();
            let conditions = [event.condition, Condition::Secondary(secondary)];
            let found = locate(&net.equations, conditions, near.clone(), &mut times);
            let apart = |found: &Unknowns| if is_copy { aside(found).abs() } else { distance(found) };
            found.is_ok_and(|found| apart(&found) < BETWEEN_BIFURCATIONS)
                || distance(&near) < BETWEEN_BIFURCATIONS
        })
    })
}

/// Follows the curve through a bifurcation that lies on no known curve.
pub(super) fn start(net: &mut Net, kind: Bifurcation, event: &Event, route: &Route<'_>) {
    let curve = SolutionCurve { equations: net.equations.clone(), condition: event.condition };
    // Across the slice, except where the curve runs along it.
    let here = &event.solution.unknowns;
    let upwards = here.along(unknown::SECONDARY) * if net.equations.has_impacts() { 1.0 } else { -1.0 };
    let follow =
        |direction| curve.clone().follow_both_ways(here.clone(), direction, &event.times, route).ok();
    if let Some(curve) = follow(upwards).or_else(|| follow(here.along(unknown::PRIMARY)))
        && (net.equations.has_impacts() || !stalls(&curve))
    {
        net.add(DiagramCurve { kind, loops: net.loops(), n: 0, curve });
        net.grow(route);
    }
}

/// Whether a curve stalls: then it begins at no fold but where two branches meet, for instance
/// because of a symmetry.
fn stalls(curve: &Curve) -> bool {
    let mut ends = [curve.beginning.as_ref(), Some(&curve.end)].into_iter().flatten();
    ends.any(|end| matches!(end, CurveEnd::Stalled(_)))
}
