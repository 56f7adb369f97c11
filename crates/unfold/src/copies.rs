//! Curves of solutions with several impacts without what repeats itself along them.
//!
//! Where a solution with an even number of impacts becomes one that recurs after half the time, its curve
//! passes on to the same solutions, whose impacts are then numbered from half-way. Only one side of such
//! points is kept.

use grazing_continuation::curve::{Curve, CurveEnd, CurvePoint};
use grazing_continuation::locate::{Condition, locate};
use grazing_continuation::mps::{EventTimes, LoopEquations, Unknowns, unknown};

/// Points closer than this to a solution of half the time are left out: a multiplier differs from 1 by no more
/// than the square.
const BESIDE: f64 = 3e-3;

/// The longest part of a curve between points at which solutions recur after half the time.
pub(crate) fn without_copies(equations: &LoopEquations, curve: Curve) -> Curve {
    let apart = |point: &CurvePoint| equations.after_a_part(&point.solution.unknowns, 2);
    let Some(half) = equations.of_half_the_time() else { return curve };
    let passed = |pair: &[CurvePoint]| {
        let ends = apart(&pair[0]).zip(apart(&pair[1]));
        ends.is_some_and(|(before, after)| before.dot(&after) < 0.0)
    };
    let passages =
        (1..).zip(curve.points.windows(2)).filter(|(_, pair)| passed(pair)).map(|(after, _)| after);
    let passages: Vec<usize> = passages.collect();
    if passages.is_empty() {
        return curve;
    }
    let bounds = [vec![0], passages, vec![curve.points.len()]].concat();
    let Some([mut first, mut end]) =
        bounds.windows(2).map(|pair| [pair[0], pair[1]]).max_by_key(|[first, end]| end - first)
    else {
        return curve;
    };
    let (begins, ends) = (first > 0, end < curve.points.len());
    let beside = |index: usize| apart(&curve.points[index]).is_some_and(|apart| apart.norm() < BESIDE);
    while begins && first + 1 < end && beside(first) {
        first += 1;
    }
    while ends && first + 1 < end && beside(end - 1) {
        end -= 1;
    }
    let symmetric = |point: &CurvePoint| passing(equations, &half, curve.condition, point);
    let before = begins.then(|| symmetric(&curve.points[first])).flatten();
    let after = ends.then(|| symmetric(&curve.points[end - 1])).flatten();
    let shift = usize::from(before.is_some());
    let mut events = curve.events;
    events.retain(|event| first < event.index && event.index < end);
    events.iter_mut().for_each(|event| event.index = event.index - first + shift);
    let inner = curve.points[first..end].iter().cloned();
    Curve {
        points: before.into_iter().chain(inner).chain(after).collect(),
        events,
        end: if ends { CurveEnd::Halved } else { curve.end },
        beginning: if begins { Some(CurveEnd::Halved) } else { curve.beginning },
        ..curve
    }
}

/// The solution of half the time that a curve passes beside one of its points.
fn passing(
    equations: &LoopEquations,
    half: &LoopEquations,
    along: Condition,
    point: &CurvePoint,
) -> Option<CurvePoint> {
    let here = &point.solution.unknowns;
    let middle = here + &equations.after_a_part(here, 2)? * 0.5;
    let near = middle.first_impacts(here.impacts() / 2);
    let held = match along {
        Condition::Primary(_) => along,
        _ => Condition::Secondary(near[unknown::SECONDARY]),
    };
    let conditions = [Condition::PERIOD_DOUBLING, held];
    let found: Unknowns = locate(half, conditions, near, &mut EventTimes::default()).ok()?;
    let twice = found.followed_by(&found, half.loops());
    Some(CurvePoint { solution: equations.solution(&twice), times: EventTimes::default() })
}
