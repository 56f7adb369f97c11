//! The variational equations of first and second order, along a step that has been solved.
//!
//! The derivatives are those of the numerical solution with its steps fixed. At the stages the
//! accelerations k of a step obey k = F, and each derivative of this is a system with the same
//! matrix, that of Newton's method:
//!
//! ```text
//! k_a  − F_x x_a  − F_y y_a  = F_a,
//! k_ab − F_x x_ab − F_y y_ab = the second derivatives of F on (x_a, y_a) and (x_b, y_b)
//! ```
//!
//! where x and y at a stage depend on all k linearly. So F is evaluated once at the stages, with
//! its derivatives in position, velocity and parameters, and all else is arithmetic.

use super::factors::Factors;
use super::integrator::{PositionVelocity, Step};
use super::jet::variable::{POSITION, PRIMARY, VELOCITY};
use super::jet::{FIRST, Jet, PAIRS, SECOND, VARIABLES};
use super::oscillator::{Integrated, SmoothOscillator};
use super::partials::Partials;
use super::stages::{Lanes, STAGES, Stages};
use super::tableau::{MATRIX, NODES, POSITION_WEIGHTS, SQUARE, WEIGHTS};
use crate::scalar::Scalar;

/// The arguments of F besides position and velocity, as jets: the shift of the time origin and the
/// parameters.
#[derive(Clone, Copy, Debug)]
pub(super) struct Surroundings<const LENGTH: usize> {
    pub(super) origin: Jet<LENGTH>,
    pub(super) parameters: [Jet<LENGTH>; 2],
}

/// Number of stages at which F is evaluated with jets at once: as many as one instruction takes
/// (empirical: more are slower).
const SIDE_BY_SIDE: usize = 2;

/// The linear system of a step.
struct Variation {
    length: f64,
    /// F_x and F_y at the stages.
    slopes: [Stages; 2],
    factors: Factors,
}

/// A derivative of the accelerations, positions and velocities at the stages.
struct Response {
    accelerations: Stages,
    states: PositionVelocity<Stages>,
}

impl Variation {
    /// The derivative whose value at the beginning of the step is (x, y), for this right-hand side
    /// of the system.
    #[inline(always)]
    fn response(&self, [x, y]: PositionVelocity<f64>, right: Stages) -> Response {
        let (h, [by_position, by_velocity]) = (self.length, self.slopes);
        let [straight, level] = [Stages::constant(x) + Lanes(NODES).scale(h * y), Stages::constant(y)];
        let accelerations = self.factors.solve(right + by_position * straight + by_velocity * level);
        let position = straight.plus(h * h, &accelerations.through(&SQUARE));
        let velocity = level.plus(h, &accelerations.through(&MATRIX));
        Response { accelerations, states: [position, velocity] }
    }

    /// The derivative at the end of the step.
    #[inline(always)]
    fn end(&self, [x, y]: PositionVelocity<f64>, accelerations: &Stages) -> PositionVelocity<f64> {
        let h = self.length;
        let position = x + h * (y + h * accelerations.weighted(&POSITION_WEIGHTS));
        [position, y + h * accelerations.weighted(&WEIGHTS)]
    }
}

impl<M: SmoothOscillator> Integrated<M> {
    /// The jets at the end of a step that has been solved.
    #[inline(never)]
    pub(super) fn jets_after<const LENGTH: usize>(
        &self,
        from: &PositionVelocity<Jet<LENGTH>>,
        time: f64,
        step: &Step,
        surroundings: &Surroundings<LENGTH>,
    ) -> PositionVelocity<Jet<LENGTH>> {
        let value = [from[0].value(), from[1].value()];
        let force = self.jets_at_stages(value, time, step, surroundings);
        let h = step.length;
        let slopes = [force.first(POSITION), force.first(VELOCITY)];
        let factors = Factors::new(&[slopes[0].scale(h * h), slopes[1].scale(h)]);
        let variation = Variation { length: h, slopes, factors };
        let mut end = *from;
        let mut set = |entry: usize, [x, y]: PositionVelocity<f64>| {
            end[0].0[entry] = x;
            end[1].0[entry] = y;
        };
        set(0, step.end(value));
        let entry = |index: usize| [from[0].0[index], from[1].0[index]];
        let mut first = [[Stages::constant(0.0); 2]; VARIABLES];
        for (a, states) in first.iter_mut().enumerate() {
            let right = if a >= PRIMARY { force.first(a) } else { Stages::constant(0.0) };
            let response = variation.response(entry(1 + a), right);
            set(1 + a, variation.end(entry(1 + a), &response.accelerations));
            *states = response.states;
        }
        if LENGTH == SECOND {
            let bends = bends(&force, &first);
            for (k, right) in bends.into_iter().enumerate() {
                let response = variation.response(entry(FIRST + k), right);
                set(FIRST + k, variation.end(entry(FIRST + k), &response.accelerations));
            }
        }
        end
    }

    /// F at the stages with its derivatives in position, velocity and parameters.
    #[inline(always)]
    fn jets_at_stages<const LENGTH: usize>(
        &self,
        from: PositionVelocity<f64>,
        time: f64,
        step: &Step,
        surroundings: &Surroundings<LENGTH>,
    ) -> Jet<LENGTH, Stages> {
        let [mu, eta] = surroundings.parameters;
        let ([x, y], times) = (step.stages(from), step.times(time));
        let origin = &surroundings.origin;
        let at = times + Stages::constant(origin.value());
        let [at_mu, at_eta] = self.parameters.map(Stages::constant);
        let mut partials = Partials::zero();
        if self.model.partials(&[x, y, at, at_mu, at_eta], LENGTH == SECOND, &mut partials) {
            return Jet::of_force(&partials, origin);
        }
        let mut all = Jet::<LENGTH, Stages>::constant(0.0);
        let [mu, eta] = [mu, eta].map(|jet| Jet(jet.0.map(Lanes::<SIDE_BY_SIDE>::constant)));
        let origin = Jet(origin.0.map(Lanes::constant));
        for first in (0..STAGES).step_by(SIDE_BY_SIDE) {
            let some = |stages: &Stages| Lanes(core::array::from_fn(|i| stages.0[first + i]));
            let [x, y] = [Jet::variable(POSITION, some(&x)), Jet::variable(VELOCITY, some(&y))];
            let t = origin + Jet::fixed(some(&times));
            let force = self.model.force(x, y, t, mu, eta);
            for (all, entry) in all.0.iter_mut().zip(force.0) {
                all.0[first..first + SIDE_BY_SIDE].copy_from_slice(&entry.0);
            }
        }
        all
    }
}

/// The second derivatives of F in the directions of each pair of variables.
#[inline(always)]
fn bends<const LENGTH: usize>(
    force: &Jet<LENGTH, Stages>,
    first: &[PositionVelocity<Stages>; VARIABLES],
) -> [Stages; PAIRS.len()] {
    let zero = Stages::constant(0.0);
    // Change of the gradient of F in the direction of each variable.
    let mut turned = [[zero; VARIABLES]; VARIABLES];
    for (b, (turned, [x, y])) in turned.iter_mut().zip(first).enumerate() {
        for (r, entry) in turned.iter_mut().enumerate() {
            *entry = force.second(r, POSITION) * *x + force.second(r, VELOCITY) * *y;
            if b >= PRIMARY {
                *entry = *entry + force.second(r, b);
            }
        }
    }
    let mut bends = [zero; PAIRS.len()];
    for (bend, [a, b]) in bends.iter_mut().zip(PAIRS) {
        let [x, y] = first[a];
        *bend = turned[b][POSITION] * x + turned[b][VELOCITY] * y;
        if a >= PRIMARY {
            *bend = *bend + turned[b][a];
        }
    }
    bends
}
