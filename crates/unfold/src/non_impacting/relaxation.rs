//! Periodic motion of the oscillator without its wall, at one value of η.
//!
//! A periodic solution is a fixed point of the flow over one forcing period. The first ones are
//! found by letting the motion relax, as a damped oscillator does; then they are followed through
//! the range of the primary parameter, folds included. Grazing occurs where the highest point of
//! the orbit reaches the wall.

use grazing_continuation::curve::{Curve, CurveEnd};
use grazing_continuation::locate::{Condition, locate};
use grazing_continuation::mps::{EventTimes, LoopEquations, PeriodicSolution, Unknowns};
use grazing_continuation::tolerances::FAR;
use grazing_model::motion::Motion;
use grazing_model::smooth::Purpose;
use grazing_model::{AnyOscillator, ImpactOscillator, State};
use grazing_results::dimensioned;
use grazing_theorems::from_map::GrazingOrbit;
use nalgebra::Vector2;

use super::rest;
use crate::escape::Escape;
use crate::slices::{FREE_STEPS, Slice, Slicer};
use crate::tolerances::BETWEEN_GRAZING_ORBITS;
use crate::{Scope, search};

/// Periodic motion without the wall at one η, and its grazing.
#[derive(Clone, Debug)]
pub struct PeriodicMotion {
    /// Grazing orbits, each touching the wall with its highest point.
    pub grazing: Vec<GrazingOrbit>,
    /// Orbits that touch the wall without being turned back, with F ≥ 0 there.
    pub pushed: Vec<Height>,
    /// The end of motion from one of the starts that ran away.
    pub ran_away: Option<Escape>,
    /// The branches of solutions.
    pub(crate) branches: Vec<Curve>,
}

/// The highest point of a periodic orbit without the wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Height {
    /// The position x.
    pub position: f64,
    /// The parameters (μ, η).
    pub parameters: [f64; 2],
    /// The acceleration there.
    pub acceleration: f64,
}

dimensioned! {
    Height, |own| {
        own.position => "length",
        own.parameters[0] => "{primary}",
        own.parameters[1] => "{secondary}",
        own.acceleration => "length/time^2",
    }
}

impl Height {
    /// The highest point of a solution without impacts.
    pub(crate) fn of(equations: &LoopEquations, solution: &PeriodicSolution) -> Self {
        let point = &solution.unknowns;
        let motion = equations.oscillator_at(point).motion(equations.departure(point));
        let time = solution.highest_interior_maximum.map_or(0.0, |maximum| maximum.time);
        let acceleration = motion.at(time).acceleration;
        Self { position: solution.ceiling(), parameters: solution.parameters(), acceleration }
    }
}

/// Starts of the search: fractions of the range of μ, and positions at rest, in addition to the
/// oscillator's own rest positions, which may be in a well that contains none of these.
const SHARES: [f64; 3] = [0.0, 1.0, LAST_RESORT];
/// The fraction from which a search begins if nothing is found at the ends.
const LAST_RESORT: f64 = 0.5;
const POSITIONS: [f64; 3] = [-1.0, 0.0, -0.25];

/// Number of forcing periods for which motion is left to relax; Newton's method then starts from
/// the state reached.
const LONGEST_RELAXATION: usize = 200;
/// Newton's method takes over when a period changes the state by less than this.
const RELAXED: f64 = 1e-3;

/// Motion that relaxes this far from the wall, whose distance from rest is of order one, is
/// ignored, whether or not there is other motion: a pendulum may turn any number of times before it
/// relaxes, and motion about each of its rest positions is the same except for those turns.
const CARRIED_AWAY: f64 = 10.0;
/// Motion from a start that is itself far off is not carried away within this multiple of its
/// distance.
const AS_FAR: f64 = 2.0;

/// Finds grazing of periodic motion without the wall over the whole range of μ at η = `secondary`.
pub fn periodic_motion(oscillator: &AnyOscillator, scope: &Scope, secondary: f64) -> PeriodicMotion {
    let equations = super::equations(oscillator, scope.window);
    let slicer = Slicer::new(equations, scope.window, FREE_STEPS);
    motion(oscillator, scope, &slicer, secondary, &[], &[0.0])
}

/// Like [`periodic_motion`], with the steps of a given slicer; motion may also start from rest at
/// more positions, or have its highest point at one of some heights, in case the other starts do
/// not lead to it.
pub(crate) fn motion(
    oscillator: &AnyOscillator,
    scope: &Scope,
    slicer: &Slicer,
    secondary: f64,
    positions: &[f64],
    heights: &[f64],
) -> PeriodicMotion {
    let mut slice = Slice::new(secondary, Vec::new());
    let add =
        |slice: &mut Slice, start: &Unknowns| slicer.add(slice, start.clone(), &EventTimes::default(), true);
    let mut ran_away = None;
    for share in SHARES {
        if share == LAST_RESORT && !slice.branches.is_empty() {
            break;
        }
        let [primary, _] = scope.window.parameters([share, 0.0]);
        let rests = rest::positions(&oscillator.with_parameters([primary, secondary]));
        let positions = POSITIONS.iter().chain(positions).chain(&rests).map(|position| [*position, 0.0]);
        for start in scope.start.into_iter().chain(positions) {
            let settled = || relaxed(&slicer.equations, [primary, secondary], Vector2::from(start));
            match Purpose::Relaxation.during(settled) {
                Ok(Some(orbit)) if orbit[0].abs() <= CARRIED_AWAY.max(AS_FAR * start[0].abs()) => {
                    add(&mut slice, &orbit)
                }
                Ok(_) => {}
                Err(escape) => {
                    ran_away.get_or_insert(escape);
                }
            }
        }
    }
    for height in heights {
        let found = search::highest_at(oscillator, scope, secondary, *height);
        for start in found.iter().filter_map(|highest| slicer.with_highest(highest)) {
            add(&mut slice, &start);
        }
    }
    let (grazing, pushed) = (Vec::new(), Vec::new());
    let mut motion = PeriodicMotion { grazing, pushed, ran_away, branches: slice.branches };
    motion.look_for_grazing(&slicer.equations, scope);
    motion
}

/// The periodic solution to which the motion from a state relaxes; `None` if it does not settle.
fn relaxed(
    equations: &LoopEquations,
    [primary, secondary]: [f64; 2],
    start: Vector2<f64>,
) -> Result<Option<Unknowns>, Escape> {
    let oscillator = equations.oscillator_at(&Unknowns::new(0.0, 0.0, primary, secondary));
    let period = oscillator.forcing_period();
    let mut state = start;
    for _ in 0..LONGEST_RELAXATION {
        let from = State { position: state[0], velocity: state[1], phase: 0.0 };
        let end = oscillator.motion(from).at(period);
        let next = Vector2::new(end.position, end.velocity);
        // NaN counts as far away as well.
        if next.norm().is_nan() || next.norm() > FAR {
            return Err(Escape::of(&oscillator, state.into()));
        }
        let change = (next - state).norm();
        state = next;
        if change <= RELAXED {
            break;
        }
    }
    let near = Unknowns::new(state[0], state[1], primary, secondary);
    Ok(locate(equations, Condition::beside(equations, &near), near, &mut EventTimes::default()).ok())
}

/// Whether a branch was followed to the edges of the range in both directions.
pub(crate) fn is_whole(branch: &Curve) -> bool {
    let mut ends = [branch.beginning.as_ref(), Some(&branch.end)].into_iter().flatten();
    ends.all(|end| matches!(end, CurveEnd::LeftWindow | CurveEnd::Closed))
}

impl PeriodicMotion {
    /// Records where the branches reach the wall.
    fn look_for_grazing(&mut self, equations: &LoopEquations, scope: &Scope) {
        for branch in &self.branches {
            for (index, pair) in (1..).zip(branch.points.windows(2)) {
                if pair[0].solution.admissible() == pair[1].solution.admissible() {
                    continue;
                }
                let located = branch
                    .events
                    .iter()
                    .find(|event| event.index == index && event.condition == Condition::InteriorGrazing);
                let near = located.map_or(&pair[0].solution, |event| &event.solution);
                if equations.is_nearest_to_other_stop(near) {
                    continue;
                }
                let [_, phase] = equations.impact(near);
                let Ok(orbit) = GrazingOrbit::find(&equations.oscillator_at(&near.unknowns), phase) else {
                    self.pushed.push(Height::of(equations, near));
                    continue;
                };
                let same = |other: &GrazingOrbit| {
                    (other.primary() - orbit.primary()).abs()
                        <= BETWEEN_GRAZING_ORBITS * scope.window.widths()[0]
                        && libm::cos(other.phase() - orbit.phase()) > 1.0 - BETWEEN_GRAZING_ORBITS
                };
                let [left, right] = scope.window.primary;
                let inside = left <= orbit.primary() && orbit.primary() <= right;
                if inside && !self.grazing.iter().any(same) {
                    self.grazing.push(orbit);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use grazing_continuation::curve::{CurvePoint, Window};

    use super::*;

    #[test]
    fn motion_that_has_gone_over_the_top_is_not_looked_at_even_where_there_is_no_other() {
        let pendulum = crate::specimens::forced("-0.04*v - 4*sin(x/4 + 0.4)", 0.8).oscillator([1.45, 0.87]);
        let window = Window { primary: [1.43, 1.49], secondary: [0.8, 0.95] };
        let scope = Scope { window, loops: vec![1], start: None };
        let points = |scope: &Scope| -> Vec<CurvePoint> {
            let branches = periodic_motion(&pendulum, scope, 0.87).branches;
            branches.into_iter().flat_map(|branch| branch.points).collect()
        };
        let settles = |point: &CurvePoint| point.solution.attracts();
        assert!(!points(&scope).iter().any(settles));
        let wide = Scope { window: Window { primary: [0.1, 1.49], ..window }, ..scope };
        assert!(points(&wide).iter().any(settles));
    }
}
