//! Periodic motion of the oscillator without its wall.
//!
//! A periodic solution is a fixed point of the flow over one forcing period. The first ones are found by letting the motion
//! relax, as a damped oscillator does; then they are followed through the range of the primary parameter, folds included.
//! Where the highest point of the orbit comes to the wall there is grazing.

pub(crate) mod branch;
mod curves;
pub(crate) mod orbits;
pub(crate) mod regions;

use grazing_continuation::locate::Condition;
use grazing_model::ImpactOscillator;
use grazing_model::State;
use grazing_model::motion::Motion;
use grazing_theorems::from_map::GrazingOrbit;
use nalgebra::Vector2;

use crate::escape::Escape;
use crate::{Scope, search};
use branch::{Branch, Crossing};
use orbits::{FAR, OrbitPoint, PeriodicOrbits, SECONDARY};

/// What was seen of periodic motion without the wall at one η, and where it grazes.
#[derive(Clone, Debug)]
pub struct PeriodicMotion<O> {
    /// Grazing orbits, each touching the wall with its highest point.
    pub grazing: Vec<GrazingOrbit<O>>,
    /// Orbits that touch the wall without being turned back, with F ≥ 0 there.
    pub pushed: Vec<Height>,
    /// How motion from one of the starts ran away.
    pub ran_away: Option<Escape>,
    /// The branches of orbits.
    pub(crate) branches: Vec<Branch>,
}

/// The highest point of a periodic orbit without the wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Height {
    /// x.
    pub position: f64,
    /// The parameters (μ, η).
    pub parameters: [f64; 2],
    /// The acceleration there.
    pub acceleration: f64,
}

/// Where the search begins: shares of the range of μ, and positions at rest.
const SHARES: [f64; 3] = [0.0, 1.0, LAST_RESORT];
/// The share from which a search begins if there is nothing at the ends.
const LAST_RESORT: f64 = 0.5;
const POSITIONS: [f64; 3] = [-1.0, 0.0, -0.25];

/// Forcing periods for which motion is left to relax; Newton's method starts from wherever it is then.
const LONGEST_RELAXATION: usize = 200;
/// Newton's method takes over when a period changes the state by less than this.
const RELAXED: f64 = 1e-3;

/// Motion that relaxes this far from the wall, whose distance from rest is of order one, is looked at only where there is no other: a pendulum
/// may turn any number of times before it does, and motion about each of its rest positions is the same but for those turns.
const CARRIED_AWAY: f64 = 10.0;

/// Grazing orbits closer than this are one: Newton's method leaves far less.
const SAME: f64 = 1e-6;

/// Looks for grazing of periodic motion without the wall over the whole range of μ at η = `secondary`.
pub fn periodic_motion<O: ImpactOscillator>(
    oscillator: &O,
    scope: &Scope,
    secondary: f64,
) -> PeriodicMotion<O> {
    PeriodicOrbits { oscillator, scope, control: branch::STEPS }.motion(secondary, &[], &[0.0])
}

impl<O: ImpactOscillator> PeriodicOrbits<'_, O> {
    /// As [`periodic_motion`], in steps of one's own; with motion that comes from rest at some more positions, or has its highest point at one of some heights, should none
    /// of the rest lead to it.
    pub(crate) fn motion(&self, secondary: f64, positions: &[f64], heights: &[f64]) -> PeriodicMotion<O> {
        let (orbits, scope) = (self, self.scope);
        let share_of_secondary = scope.window.shares([scope.window.primary[0], secondary])[1];
        let mut branches: Vec<Branch> = Vec::new();
        let (mut ran_away, mut carried_away) = (None, None);
        for share in SHARES {
            if share == LAST_RESORT && !branches.is_empty() {
                break;
            }
            let positions = POSITIONS.iter().chain(positions).map(|position| [*position, 0.0]);
            for start in scope.start.into_iter().chain(positions) {
                match orbits.relaxed([share, share_of_secondary], Vector2::from(start)) {
                    Ok(Some(orbit)) if orbit[0].abs() > CARRIED_AWAY => {
                        carried_away = carried_away.or(Some(orbit))
                    }
                    Ok(Some(orbit)) => orbits.add_branch(&mut branches, &orbit),
                    Ok(None) => {}
                    Err(escape) => {
                        ran_away.get_or_insert(escape);
                    }
                }
            }
        }
        if branches.is_empty() {
            branches.extend(carried_away.and_then(|orbit| orbits.branch(&orbit, SECONDARY)));
        }
        for height in heights {
            let found = search::highest_at(self.oscillator, scope, secondary, *height);
            for start in found.iter().filter_map(|highest| orbits.through(highest)) {
                orbits.add_branch(&mut branches, &start);
            }
        }
        let mut motion = PeriodicMotion { grazing: Vec::new(), pushed: Vec::new(), ran_away, branches };
        motion.look_for_grazing(orbits);
        motion
    }

    /// The periodic orbit to which the motion from a state relaxes; `None` if it does not settle.
    fn relaxed(&self, shares: [f64; 2], start: Vector2<f64>) -> Result<Option<OrbitPoint>, Escape> {
        let oscillator = self.scope.oscillator_at(self.oscillator, shares);
        let period = oscillator.forcing_period();
        let mut state = start;
        for _ in 0..LONGEST_RELAXATION {
            let from = State { position: state[0], velocity: state[1], phase: 0.0 };
            let end = oscillator.motion(from).at(period);
            let next = Vector2::new(end.position, end.velocity);
            // NaN is far as well.
            if next.norm().is_nan() || next.norm() > FAR {
                return Err(Escape::of(&oscillator, state.into()));
            }
            let change = (next - state).norm();
            state = next;
            if change <= RELAXED {
                break;
            }
        }
        Ok(self.at(&OrbitPoint::new(state[0], state[1], shares[0], shares[1])))
    }
}

impl<O: ImpactOscillator> PeriodicMotion<O> {
    /// Takes down where the branches come to the wall.
    fn look_for_grazing(&mut self, orbits: &PeriodicOrbits<'_, O>) {
        for bifurcation in self.branches.iter().flat_map(|branch| &branch.bifurcations) {
            if let Crossing { condition: Condition::InteriorGrazing, near, .. } = bifurcation {
                match orbits.grazing(near, SECONDARY) {
                    Some(orbit) => {
                        let same = |other: &GrazingOrbit<O>| {
                            (other.primary() - orbit.primary()).abs()
                                <= SAME * orbits.scope.window.widths()[0]
                                && libm::cos(other.phase() - orbit.phase()) > 1.0 - SAME
                        };
                        let [left, right] = orbits.scope.window.primary;
                        let inside = left <= orbit.primary() && orbit.primary() <= right;
                        if inside && !self.grazing.iter().any(same) {
                            self.grazing.push(orbit);
                        }
                    }
                    None => self.pushed.push(near.height),
                }
            }
        }
    }
}
