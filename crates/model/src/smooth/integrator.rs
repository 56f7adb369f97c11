//! The method of Dormand and Prince of order 8 for ẍ = F(x, ẋ, t), with control of the error of plain position and velocity.
//!
//! Jets go through the same steps as plain numbers would: what comes out are the derivatives of the numerical solution with
//! its steps held, and so the solutions of the variational equations to the same order.

use super::jet::Jet;
use super::scalar::Scalar;
use super::tableau::{ERROR_3, ERROR_5, NODES, STAGES, WEIGHTS};

/// A number that slopes can be added up in.
pub(super) trait Linear: Scalar {
    /// This with `step` times the weighted sum of others added.
    fn combined(&self, others: &[Self], step: f64, weights: &[(usize, f64)]) -> Self;

    /// Without derivatives.
    fn plain(&self) -> f64;
}

impl Linear for f64 {
    #[inline(always)]
    fn combined(&self, others: &[Self], step: f64, weights: &[(usize, f64)]) -> Self {
        weights.iter().fold(*self, |sum, &(from, weight)| sum + step * weight * others[from])
    }

    #[inline(always)]
    fn plain(&self) -> f64 {
        *self
    }
}

impl<const LENGTH: usize> Linear for Jet<LENGTH> {
    #[inline(always)]
    fn combined(&self, others: &[Self], step: f64, weights: &[(usize, f64)]) -> Self {
        self.combined(others, step, weights)
    }

    #[inline(always)]
    fn plain(&self) -> f64 {
        self.value()
    }
}

/// Position and velocity.
pub(super) type Pair<S> = [S; 2];

/// The slopes ẋ and ẏ at the stages of a step.
struct Slopes<S> {
    velocities: [S; STAGES],
    accelerations: [S; STAGES],
}

impl<S: Linear> Slopes<S> {
    #[inline(always)]
    fn of_step(force: &impl Fn(S, S, f64) -> S, [x, y]: &Pair<S>, time: f64, step: f64) -> Self {
        let mut slopes =
            Self { velocities: [*y; STAGES], accelerations: [force(*x, *y, time); STAGES] };
        for (stage, (fraction, weights)) in NODES.iter().enumerate().skip(1) {
            let [x, y] = slopes.applied(&[*x, *y], step, weights);
            slopes.velocities[stage] = y;
            slopes.accelerations[stage] = force(x, y, time + fraction * step);
        }
        slopes
    }

    #[inline(always)]
    fn applied(&self, [x, y]: &Pair<S>, step: f64, weights: &[(usize, f64)]) -> Pair<S> {
        [x.combined(&self.velocities, step, weights), y.combined(&self.accelerations, step, weights)]
    }

    /// The error estimate of a step over what is allowed.
    #[inline(always)]
    fn error(&self, step: f64, from: &Pair<S>, to: &Pair<S>) -> f64 {
        let plain = Slopes {
            velocities: self.velocities.each_ref().map(S::plain),
            accelerations: self.accelerations.each_ref().map(S::plain),
        };
        let estimates = [&ERROR_5, &ERROR_3].map(|weights| plain.applied(&[0.0; 2], 1.0, weights));
        let mut squares = [0.0; 2];
        for i in 0..2 {
            let scale = TOLERANCE * (1.0 + from[i].plain().abs().max(to[i].plain().abs()));
            for (square, estimate) in squares.iter_mut().zip(&estimates) {
                let ratio = estimate[i] / scale;
                *square += ratio * ratio;
            }
        }
        let [fifth, third] = squares;
        if fifth == 0.0 && third == 0.0 {
            return 0.0;
        }
        step.abs() * fifth / (2.0 * (fifth + 0.01 * third)).sqrt()
    }
}

/// One step, without an error estimate.
#[inline]
pub(super) fn step<S: Linear>(
    force: &impl Fn(S, S, f64) -> S,
    from: &Pair<S>,
    time: f64,
    step: f64,
) -> Pair<S> {
    if step == 0.0 {
        return *from;
    }
    Slopes::of_step(force, from, time, step).applied(from, step, &WEIGHTS)
}

/// A point of a solution, with the step that is proposed from there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node<S> {
    pub(super) time: f64,
    pub(super) state: Pair<S>,
    pub(super) proposal: f64,
}

/// Error allowed in a step, relative to 1 + the modulus: a few roundings, so that derivatives of what is computed are those of
/// the flow to about ten digits at least.
const TOLERANCE: f64 = 1e-13;
/// The new step is this share of what the error estimate suggests, and changes by these factors at most (empirical, as usual
/// for this method).
const SAFETY: f64 = 0.9;
const SHRINK: f64 = 0.3;
const GROW: f64 = 3.0;
/// A step this short means that the solution is not smooth, or escapes: all times are of order one (dimensionless).
const SHORTEST: f64 = 1e-9;

impl<S: Linear> Node<S> {
    /// The next node, `longest` away at most in time; `None` if the solution cannot be continued.
    #[inline]
    pub(super) fn next(&self, force: &impl Fn(S, S, f64) -> S, longest: f64) -> Option<Self> {
        let mut trial = if self.proposal.abs() < longest.abs() { self.proposal } else { longest };
        loop {
            let slopes = Slopes::of_step(force, &self.state, self.time, trial);
            let state = slopes.applied(&self.state, trial, &WEIGHTS);
            let error = slopes.error(trial, &self.state, &state);
            // The step's error is of order 8 in it.
            let factor = if error > 0.0 { SAFETY / error.sqrt().sqrt().sqrt() } else { GROW };
            let factor = if error.is_nan() { SHRINK } else { factor.clamp(SHRINK, GROW) };
            if error <= 1.0 {
                let proposal = trial * factor;
                // A step that was cut at the end says nothing against the proposal.
                let proposal =
                    if trial.abs() < self.proposal.abs() && factor >= 1.0 { self.proposal } else { proposal };
                return Some(Self { time: self.time + trial, state, proposal });
            }
            trial *= factor.min(SAFETY);
            if trial.abs() < SHORTEST {
                return None;
            }
        }
    }
}
