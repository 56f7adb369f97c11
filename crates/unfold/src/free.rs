//! Periodic motion of the oscillator without its wall, at one value of the secondary parameter.
//!
//! A periodic solution is a fixed point of the flow over one forcing period. The first ones are found by letting the motion
//! relax, as a damped oscillator does; then they are followed through the range of the primary parameter, folds included.
//! Where the highest point of the orbit comes to the wall there is grazing.

use core::f64::consts::TAU;

use grazing_continuation::arclength::{Continuation, CurveEquations, StepControl};
use grazing_continuation::newton::{self, Linearisation};
use grazing_model::motion::{Motion, highest_maximum};
use grazing_model::{ImpactOscillator, State, flow_variable as flow};
use grazing_theorems::from_map::GrazingOrbit;
use nalgebra::{Matrix2, Matrix3, Vector2, Vector3};

use crate::Scope;
use crate::escape::Escape;

/// The free motion ceases to exist, or has run away.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("the motion without the wall runs away")]
pub struct RunsAway;

/// What was seen of free periodic motion, and where it grazes.
#[derive(Clone, Debug)]
pub struct Survey<O> {
    /// Grazing orbits, each touching the wall with its highest point.
    pub grazing: Vec<GrazingOrbit<O>>,
    /// The lowest and the highest of the highest points of all orbits, with the parameters; `None` without an orbit.
    pub extremes: Option<[Height; 2]>,
    /// Orbits that touch the wall without being turned back, with F ≥ 0 there.
    pub pushed: Vec<Height>,
    /// How motion from one of the starts ran away.
    pub ran_away: Option<Escape>,
}

/// The highest point of a free periodic orbit.
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
/// Motion this far away, the wall's distance from rest being of order one, has run away.
const FAR: f64 = 1e6;
/// Steps in (x, y, share of the range of μ) that do not jump over the highest point's changes (empirical).
const STEPS: StepControl = StepControl { first: 1e-3, longest: 0.1, shortest: 1e-6, turn: 0.2 };
/// A branch of this many points goes nowhere.
const STEP_LIMIT: usize = 4000;

/// Looks for grazing of free periodic motion over the whole range of μ at η = `secondary`.
pub fn survey<O: ImpactOscillator>(oscillator: &O, scope: &Scope, secondary: f64) -> Survey<O> {
    let orbits = FreeOrbits { oscillator, scope, secondary };
    let mut survey = Survey { grazing: Vec::new(), extremes: None, pushed: Vec::new(), ran_away: None };
    // Orbits at the ends of the range that have been followed, or come to.
    let mut known: Vec<Vector3<f64>> = Vec::new();
    for share in SHARES {
        if share == LAST_RESORT && !known.is_empty() {
            break;
        }
        let usual = POSITIONS.map(|position| [position, 0.0]);
        for start in scope.start.into_iter().chain(usual) {
            match orbits.relaxed(share, Vector2::from(start)) {
                Ok(Some(orbit)) if known.iter().all(|other| (other - orbit).norm() > SAME) => {
                    known.push(orbit);
                    let up = Vector3::new(0.0, 0.0, 1.0);
                    for direction in [up, -up] {
                        known.extend(orbits.follow(orbit, direction, &mut survey));
                    }
                }
                Ok(_) => {}
                Err(escape) => {
                    survey.ran_away.get_or_insert(escape);
                }
            }
        }
    }
    survey
}

/// Motion through less than this is rest: maxima of what rounding leaves are none.
const REST: f64 = 1e-9;
/// Instants of a period at which rest is seen: no motion is slow at all of them.
const INSTANTS: u32 = 32;

/// Orbits closer than this are one: Newton's method leaves far less.
const SAME: f64 = 1e-6;

/// The equations of free periodic orbits: unknowns are x and y at phase zero and the share of the range of μ.
struct FreeOrbits<'a, O> {
    oscillator: &'a O,
    scope: &'a Scope,
    secondary: f64,
}

impl<O: ImpactOscillator> CurveEquations<3> for FreeOrbits<'_, O> {
    type Memory = ();
    type Failure = RunsAway;

    fn evaluate(&self, point: &Vector3<f64>, (): &mut ()) -> Result<Linearisation<3>, RunsAway> {
        let oscillator = self.oscillator_at(point[2]);
        let frequency = oscillator.forcing_frequency();
        let period = TAU / frequency.value;
        let jet = oscillator.flow::<1>(State { position: point[0], velocity: point[1], phase: 0.0 }, period);
        if !jet.value.norm().is_finite() || jet.value.norm() > FAR {
            return Err(RunsAway);
        }
        let width = self.scope.widths()[0];
        let mut system = Linearisation { residual: Vector3::zeros(), jacobian: Matrix3::zeros() };
        for i in 0..2 {
            system.residual[i] = jet.value[i] - point[i];
            system.jacobian[(i, 0)] = jet.jacobian[(i, flow::POSITION)];
            system.jacobian[(i, 1)] = jet.jacobian[(i, flow::VELOCITY)];
            system.jacobian[(i, i)] -= 1.0;
            // The period varies with μ if ω does.
            let by_period =
                jet.jacobian[(i, flow::DURATION)] * -period * frequency.gradient[0] / frequency.value;
            system.jacobian[(i, 2)] = (jet.jacobian[(i, flow::PRIMARY)] + by_period) * width;
        }
        Ok(system)
    }
}

impl<O: ImpactOscillator> FreeOrbits<'_, O> {
    fn parameters(&self, share: f64) -> [f64; 2] {
        [self.scope.parameters([share, 0.0])[0], self.secondary]
    }

    fn oscillator_at(&self, share: f64) -> O {
        self.oscillator.with_parameters(self.parameters(share))
    }

    /// The periodic orbit to which the motion from a state relaxes; `None` if it does not settle.
    fn relaxed(&self, share: f64, start: Vector2<f64>) -> Result<Option<Vector3<f64>>, Escape> {
        let oscillator = self.oscillator_at(share);
        let period = oscillator.forcing_period();
        let mut state = start;
        for _ in 0..LONGEST_RELAXATION {
            let from = State { position: state[0], velocity: state[1], phase: 0.0 };
            let end = oscillator.motion(from).at(period);
            let next = Vector2::new(end.position, end.velocity);
            // Not a number is far as well.
            if next.norm().is_nan() || next.norm() > FAR {
                return Err(Escape::of(&oscillator, state.into()));
            }
            let change = (next - state).norm();
            state = next;
            if change <= RELAXED {
                break;
            }
        }
        Ok(self.at(share, state))
    }

    /// The periodic orbit near a state at a share of the range of μ.
    fn at(&self, share: f64, near: Vector2<f64>) -> Option<Vector3<f64>> {
        let solution = newton::solve(near, 20, |state| {
            let system = self.evaluate(&Vector3::new(state[0], state[1], share), &mut ())?;
            let jacobian: Matrix2<f64> = system.jacobian.fixed_view::<2, 2>(0, 0).into_owned();
            Ok::<_, RunsAway>(Linearisation {
                residual: system.residual.fixed_rows::<2>(0).into_owned(),
                jacobian,
            })
        });
        solution.ok().map(|solution| Vector3::new(solution.point[0], solution.point[1], share))
    }

    /// Follows an orbit through the range of μ and adds what is seen to the survey; the orbit at the end of the range.
    fn follow(
        &self,
        start: Vector3<f64>,
        direction: Vector3<f64>,
        survey: &mut Survey<O>,
    ) -> Option<Vector3<f64>> {
        let mut walker = Continuation::new(self, STEPS, start, direction, ()).ok()?;
        let mut before = (start, self.highest(&start));
        survey.note(before.1.0);
        for _ in 0..STEP_LIMIT {
            let station = walker.advance().ok()?;
            let after = (station.point, self.highest(&station.point));
            if before.1.0.position.is_sign_negative() != after.1.0.position.is_sign_negative() {
                self.touch(before, after, survey);
            }
            if !(0.0..=1.0).contains(&after.0[2]) {
                let edge = after.0[2].clamp(0.0, 1.0);
                let way = (edge - before.0[2]) / (after.0[2] - before.0[2]);
                let near = before.0 + (after.0 - before.0) * way;
                let last = self.at(edge, near.fixed_rows::<2>(0).into_owned())?;
                survey.note(self.highest(&last).0);
                return Some(last);
            }
            survey.note(after.1.0);
            before = after;
        }
        None
    }

    /// The highest point of an orbit, and its phase.
    fn highest(&self, point: &Vector3<f64>) -> (Height, f64) {
        let oscillator = self.oscillator_at(point[2]);
        let motion = oscillator.motion(State { position: point[0], velocity: point[1], phase: 0.0 });
        let frequency = oscillator.forcing_frequency().value;
        let period = TAU / frequency;
        let at_rest = (0..=INSTANTS).all(|instant| {
            let here = motion.at(period * f64::from(instant) / f64::from(INSTANTS));
            here.velocity.abs() * period <= REST && here.acceleration.abs() * period * period <= REST
        });
        // A little more than a period, so that a maximum at phase zero lies inside.
        let highest = if at_rest { None } else { highest_maximum(&motion, 1.25 * period) };
        let (position, time) = highest.map_or((point[0], 0.0), |maximum| (maximum.position, maximum.time));
        let height = Height {
            position,
            parameters: self.parameters(point[2]),
            acceleration: motion.at(time).acceleration,
        };
        (height, time * frequency)
    }

    /// Locates the grazing orbit between two orbits, one on either side of the wall.
    fn touch(
        &self,
        before: (Vector3<f64>, (Height, f64)),
        after: (Vector3<f64>, (Height, f64)),
        survey: &mut Survey<O>,
    ) {
        let (a, b) = (before.1.0.position, after.1.0.position);
        let weight = a / (a - b);
        let near = if weight < 0.5 { before } else { after };
        let share = before.0[2] + (after.0[2] - before.0[2]) * weight;
        match GrazingOrbit::find(&self.oscillator_at(share), near.1.1) {
            Ok(orbit) => {
                let same = |other: &GrazingOrbit<O>| {
                    (other.primary() - orbit.primary()).abs() <= SAME * self.scope.widths()[0]
                        && libm::cos(other.phase() - orbit.phase()) > 1.0 - SAME
                };
                if self.scope.window.primary[0] <= orbit.primary()
                    && orbit.primary() <= self.scope.window.primary[1]
                    && !survey.grazing.iter().any(same)
                {
                    survey.grazing.push(orbit);
                }
            }
            Err(_) => survey.pushed.push(near.1.0),
        }
    }
}

impl<O> Survey<O> {
    fn note(&mut self, height: Height) {
        let [lowest, highest] = self.extremes.get_or_insert([height, height]);
        if height.position < lowest.position {
            *lowest = height;
        }
        if height.position > highest.position {
            *highest = height;
        }
    }
}
