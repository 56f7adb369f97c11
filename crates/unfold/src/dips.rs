//! Pairs of bifurcations that a branch has stepped over: signs at both ends of a step are the same.

use grazing_continuation::curve::{Curve, CurvePoint};
use grazing_continuation::locate::{Condition, locate_within};
use grazing_continuation::mps::{EventTimes, LoopEquations, Multipliers, Unknowns};

use crate::tolerances::BETWEEN_BIFURCATIONS;

/// A bifurcation, where it is, and the event times there.
pub(crate) type Located = (Condition, Unknowns, EventTimes);

/// What may happen to a stable, admissible solution,
const LOSSES: [Condition; 4] =
    [Condition::SADDLE_NODE, Condition::PERIOD_DOUBLING, Condition::TORUS, Condition::InteriorGrazing];

/// and what vanishes there: 1 − T + D, 1 + T + D, 1 − D and the distance of the highest maximum
/// from the wall, all positive where a solution is stable and admissible.
fn margins(point: &CurvePoint) -> [f64; LOSSES.len()] {
    let Multipliers { trace, determinant } = point.solution.multipliers;
    [1.0 - trace + determinant, 1.0 + trace + determinant, 1.0 - determinant, -point.solution.ceiling()]
}

/// The bifurcations between which solutions are not stable and admissible within a step with such
/// solutions at both ends. They are looked for where a margin, taken on straight through the points
/// to either side of the step, would vanish on it: a convex one lies above that.
pub(crate) fn stepped_over(equations: &LoopEquations, branch: &Curve) -> Vec<Located> {
    let mut all = Vec::new();
    for four in branch.points.windows(4) {
        if ![1, 2].iter().all(|&end| four[end].solution.attracts()) {
            continue;
        }
        let values = [0, 1, 2, 3].map(|k| margins(&four[k]));
        let lengths = [0, 1, 2].map(|k| length(equations, &four[k], &four[k + 1]));
        for (k, &condition) in LOSSES.iter().enumerate() {
            if least(values.map(|values| values[k]), lengths) < 0.0 {
                let ends =
                    [1, 2].map(|end| from(equations, branch.condition, condition, &four[end], lengths[1]));
                if let [Some(first), Some(last)] = ends
                    && equations.gap(&first.1, &last.1).norm() > BETWEEN_BIFURCATIONS
                {
                    all.extend([first, last]);
                }
            }
        }
    }
    all
}

fn length(equations: &LoopEquations, from: &CurvePoint, to: &CurvePoint) -> f64 {
    equations.gap(&from.solution.unknowns, &to.solution.unknowns).norm()
}

/// The value at which the line through the first two of four points meets that through the last two,
/// if the one falls and the other rises, and they meet between the points; infinite otherwise.
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
) -> Option<Located> {
    let highest = end.solution.highest_interior_maximum.map_or(0.0, |maximum| maximum.time);
    let mut times = end.times.clone().touching(highest);
    let start = end.solution.unknowns;
    let found = locate_within(step, equations, [along, condition], start, &mut times).ok()?;
    Some((condition, found, times))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_through_the_points_beside_a_step_lie_below_what_is_convex() {
        let lengths = [1.0, 1.0, 1.0];
        let parabola = |bottom: f64| [-1.5, -0.5, 0.5, 1.5].map(|x: f64| x * x + bottom);
        assert!(least(parabola(0.0), lengths) < -0.5);
        assert!(least(parabola(1.0), lengths) > 0.0);
        // Nothing falls to it from both sides.
        assert_eq!(least([4.0, 3.0, 2.0, 1.0], lengths), f64::INFINITY);
        assert_eq!(least(parabola(0.0).map(|value| -value), lengths), f64::INFINITY);
    }
}
