//! Pairs of bifurcations that a curve has stepped over: signs are the same at both ends of a step.

use grazing_continuation::curve::{Curve, CurvePoint};
use grazing_continuation::locate::{Condition, locate, locate_within};
use grazing_continuation::mps::{EventTimes, LoopEquations, Multipliers, Unknowns, unknown};

use crate::tolerances::BETWEEN_BIFURCATIONS;

/// A bifurcation, its location, and the event times there.
pub(crate) type MissedBifurcation = (Condition, Unknowns, EventTimes);

/// The ways in which a stable, admissible solution can lose stability or admissibility.
const LOSSES: [Condition; 4] =
    [Condition::SADDLE_NODE, Condition::PERIOD_DOUBLING, Condition::TORUS, Condition::InteriorGrazing];

/// The functions that vanish at the [`LOSSES`]: 1 − T + D, 1 + T + D, 1 − D and the distance of the
/// highest maximum from the wall, all positive where a solution is stable and admissible.
fn margins(point: &CurvePoint) -> [f64; LOSSES.len()] {
    let Multipliers { trace, determinant } = point.solution.multipliers;
    [1.0 - trace + determinant, 1.0 + trace + determinant, 1.0 - determinant, -point.solution.ceiling()]
}

/// The bifurcations between which solutions are not stable and admissible within a step with
/// stable, admissible solutions at both ends. They are looked for where a margin, extrapolated
/// linearly through the points on either side of the step, would vanish on it: a convex margin lies
/// above that.
pub(crate) fn stepped_over(equations: &LoopEquations, branch: &Curve) -> Vec<MissedBifurcation> {
    let mut all = Vec::new();
    for four in branch.points.windows(4) {
        if ![1, 2].iter().all(|&end| four[end].solution.attracts()) {
            continue;
        }
        let margins = [0, 1, 2, 3].map(|k| margins(&four[k]));
        for (k, &condition) in LOSSES.iter().enumerate() {
            let values = margins.map(|margins| margins[k]);
            all.extend(pair(equations, [branch.condition, condition], four, values).into_iter().flatten());
        }
    }
    all
}

/// Solutions along a bifurcation curve that are admissible, within a step with inadmissible ones at
/// both ends.
pub(crate) fn come_up(equations: &LoopEquations, curve: &Curve) -> Vec<(Unknowns, EventTimes)> {
    let within = |four: &[CurvePoint]| {
        if [1, 2].iter().any(|&end| four[end].solution.admissible()) {
            return None;
        }
        let ceilings = [0, 1, 2, 3].map(|k| four[k].solution.ceiling());
        let conditions = [curve.condition, Condition::InteriorGrazing];
        let [first, last] = pair(equations, conditions, four, ceilings)?;
        let middle = (first.1 + last.1) * 0.5;
        let held = Condition::ImpactVelocity(middle[unknown::VELOCITY]);
        let mut times = first.2;
        let found = locate(equations, [curve.condition, held], middle, &mut times).ok()?;
        equations.solution(&found).admissible().then_some((found, times))
    };
    curve.points.windows(4).filter_map(within).collect()
}

/// The two zeros of the second condition's margin, which has these values at four points, on the
/// step between the second and the third.
fn pair(
    equations: &LoopEquations,
    [along, condition]: [Condition; 2],
    four: &[CurvePoint],
    values: [f64; 4],
) -> Option<[MissedBifurcation; 2]> {
    let length = |k: usize| equations.gap(&four[k].solution.unknowns, &four[k + 1].solution.unknowns).norm();
    let lengths = [0, 1, 2].map(length);
    if least(values, lengths) >= 0.0 {
        return None;
    }
    let first = from(equations, along, condition, &four[1], lengths[1])?;
    let last = from(equations, along, condition, &four[2], lengths[1])?;
    (equations.gap(&first.1, &last.1).norm() > BETWEEN_BIFURCATIONS).then_some([first, last])
}

/// The value at which the line through the first two of four points meets that through the last
/// two, if the first line falls, the second rises, and they meet between the points; infinite
/// otherwise.
fn least([a, b, c, d]: [f64; 4], [before, step, after]: [f64; 3]) -> f64 {
    let (fall, rise) = ((a - b) / before, (d - c) / after);
    let way = (b - c + rise * step) / (fall + rise);
    let meet = fall > 0.0 && rise > 0.0 && 0.0 < way && way < step;
    if meet { b - fall * way } else { f64::INFINITY }
}

/// The bifurcation on a branch that Newton's method finds from one end of a step, on the step.
fn from(
    equations: &LoopEquations,
    along: Condition,
    condition: Condition,
    end: &CurvePoint,
    step: f64,
) -> Option<MissedBifurcation> {
    let highest = end.solution.highest_interior_maximum.map_or(0.0, |maximum| maximum.time);
    let mut times = end.times.clone().touching(highest);
    let start = end.solution.unknowns.clone();
    let found = locate_within(step, equations, [along, condition], start, &mut times).ok()?;
    Some((condition, found, times))
}

#[cfg(test)]
mod tests {
    use grazing_continuation::arclength::StepControl;
    use grazing_continuation::bifurcation::Bifurcation;
    use grazing_continuation::curve::{Route, SolutionCurve, Window};
    use grazing_continuation::mps::Formulation;
    use grazing_model::{AnyOscillator, LinearOscillator};

    use super::*;
    use crate::curves::{DiagramCurve, route};
    use crate::progress::Silent;
    use crate::{Diagram, Scope};

    #[test]
    fn a_step_over_all_that_is_admissible_beyond_grazing_is_seen() {
        let window = Window { primary: [0.77, 1.2], secondary: [0.44, 0.5] };
        let linear = LinearOscillator::new(0.00767, 0.5847, 1.0, 0.47).expect("it is in the domain");
        let oscillator = AnyOscillator::new(linear);
        let scope = Scope { window, loops: vec![2], start: None };
        let diagram = Diagram::compute(&oscillator, &scope, &Silent).expect("it grazes");
        let doubling = |curve: &&DiagramCurve| curve.kind == Bifurcation::PeriodDoubling && curve.n > 0;
        let curve = &diagram.curves.iter().find(doubling).expect("from the resonance").curve;
        let [.., before, end] = curve.points.as_slice() else { panic!("a point") };
        let equations = LoopEquations::new(oscillator, 2, Formulation::FixedPhase);
        let beyond = SolutionCurve { equations: equations.clone(), condition: curve.condition };
        let start = end.solution.unknowns.clone();
        let route = Route { stop_at_events: false, ..route(window, StepControl::DRAWING) };
        let onwards = &start - &before.solution.unknowns;
        let mut beyond = beyond.follow(start, onwards, end.times.clone(), &route).expect("it goes on");
        let on_island = |point: &CurvePoint| {
            point.solution.admissible() && (0.495..0.497).contains(&point.solution.parameters()[1])
        };
        let before = beyond.points.len();
        beyond.points.retain(|point| !on_island(point));
        assert!(beyond.points.len() < before);
        let found = come_up(&equations, &beyond);
        let [(found, _)] = found.as_slice() else { panic!("{found:?}") };
        let solution = equations.solution(found);
        // With a clear margin.
        assert!(solution.ceiling() < -1e-5 && (0.496..0.4965).contains(&solution.parameters()[1]));
    }

    #[test]
    fn lines_through_the_points_beside_a_step_lie_below_what_is_convex() {
        let lengths = [1.0, 1.0, 1.0];
        let parabola = |bottom: f64| [-1.5, -0.5, 0.5, 1.5].map(|x: f64| x * x + bottom);
        assert!(least(parabola(0.0), lengths) < -0.5);
        assert!(least(parabola(1.0), lengths) > 0.0);
        // No line falls towards the step from both sides.
        assert_eq!(least([4.0, 3.0, 2.0, 1.0], lengths), f64::INFINITY);
        assert_eq!(least(parabola(0.0).map(|value| -value), lengths), f64::INFINITY);
    }
}
