//! Bifurcation curves beyond their ends on GZ curves: solutions along them may become admissible
//! again, beside islands so small that no slice may cross them.

use grazing_continuation::curve::{Curve, CurvePoint, Route, SolutionCurve};
use grazing_continuation::locate::Condition;
use grazing_continuation::mps::{EventTimes, LoopEquations, Unknowns};

use crate::missed_bifurcations;

/// A continued curve with this many points is lost.
const FARTHEST: usize = 2_000;

/// The pieces of a curve, beyond the end where its solutions graze, on which they are admissible
/// again. The last two points before that end give the direction.
pub(crate) fn admissible_again(
    equations: &LoopEquations,
    condition: Condition,
    [before, end]: [&CurvePoint; 2],
    route: &Route<'_>,
) -> Vec<Curve> {
    let curve = || SolutionCurve { equations: equations.clone(), condition };
    let start = end.solution.unknowns.clone();
    let onwards = &start - &before.solution.unknowns;
    let passing = Route { stop_at_events: false, step_limit: FARTHEST, ..*route };
    let Ok(beyond) = curve().follow(start, onwards.clone(), end.times.clone(), &passing) else {
        return Vec::new();
    };
    let mut inside: Vec<(Unknowns, EventTimes)> = Vec::new();
    // At the first point the highest maximum lies on the wall.
    let points = beyond.points.get(1..).unwrap_or_default();
    for run in points.chunk_by(|a, b| a.solution.admissible() == b.solution.admissible()) {
        let middle = &run[run.len() / 2];
        if middle.solution.admissible() {
            inside.push((middle.solution.unknowns.clone(), middle.times.clone()));
        }
    }
    inside.extend(missed_bifurcations::come_up(equations, &beyond));
    let through = |(at, times): (Unknowns, EventTimes)| {
        curve().follow_both_ways(at, onwards.clone(), &times, route).ok()
    };
    inside.into_iter().filter_map(through).collect()
}
