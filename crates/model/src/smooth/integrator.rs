//! The method of Dormand and Prince of order 8 for ẍ = F(x, ẋ, t), on plain numbers with error control and on jets along the
//! same steps.

use super::jet::Jet;
use super::scalar::Scalar;
use super::tableau::{ERROR_3, ERROR_5, NODES, STAGES, WEIGHTS};

/// A number that slopes can be added up in.
pub(super) trait Linear: Scalar {
    fn add_multiple(&mut self, factor: f64, other: &Self);
}

impl Linear for f64 {
    #[inline]
    fn add_multiple(&mut self, factor: f64, other: &Self) {
        *self += factor * other;
    }
}

impl<const ORDER: usize> Linear for Jet<ORDER> {
    #[inline]
    fn add_multiple(&mut self, factor: f64, other: &Self) {
        Jet::add_multiple(self, factor, other);
    }
}

/// Position and velocity.
pub(super) type Pair<S> = [S; 2];

/// The slopes (ẋ, ẏ) at the stages of a step.
fn stages<S: Linear>(
    force: &impl Fn(S, S, f64) -> S,
    [x, y]: Pair<S>,
    time: f64,
    step: f64,
) -> [Pair<S>; STAGES] {
    let mut slopes = [[y, force(x, y, time)]; STAGES];
    for (stage, (fraction, weights)) in NODES.iter().enumerate().skip(1) {
        let mut at = [x, y];
        for (from, weight) in *weights {
            at[0].add_multiple(step * weight, &slopes[*from][0]);
            at[1].add_multiple(step * weight, &slopes[*from][1]);
        }
        slopes[stage] = [at[1], force(at[0], at[1], time + fraction * step)];
    }
    slopes
}

fn added<S: Linear>(
    [mut x, mut y]: Pair<S>,
    slopes: &[Pair<S>; STAGES],
    step: f64,
    weights: &[(usize, f64)],
) -> Pair<S> {
    for (from, weight) in weights {
        x.add_multiple(step * weight, &slopes[*from][0]);
        y.add_multiple(step * weight, &slopes[*from][1]);
    }
    [x, y]
}

/// One step, without an error estimate.
pub(super) fn step<S: Linear>(
    force: &impl Fn(S, S, f64) -> S,
    from: Pair<S>,
    time: f64,
    step: f64,
) -> Pair<S> {
    if step == 0.0 {
        return from;
    }
    added(from, &stages(force, from, time, step), step, &WEIGHTS)
}

/// A point of a solution, with the step that is proposed from there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node {
    pub(super) time: f64,
    pub(super) state: Pair<f64>,
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
/// A step this much shorter than the time scale of the forcing means that the solution is not smooth, or escapes.
const SHORTEST: f64 = 1e-9;

impl Node {
    /// The next node, `longest` away at most in time; `None` if the solution cannot be continued.
    pub(super) fn next(&self, force: &impl Fn(f64, f64, f64) -> f64, longest: f64) -> Option<Node> {
        let mut trial = if self.proposal.abs() < longest.abs() { self.proposal } else { longest };
        loop {
            let slopes = stages(force, self.state, self.time, trial);
            let state = added(self.state, &slopes, trial, &WEIGHTS);
            let error = error(&slopes, trial, self.state, state);
            if error.is_nan() && trial.abs() <= SHORTEST {
                return None;
            }
            // The step's error is of order 8 in it.
            let factor = if error > 0.0 { SAFETY * libm::pow(error, -0.125) } else { GROW };
            let factor = if factor.is_nan() { SHRINK } else { factor.clamp(SHRINK, GROW) };
            if error <= 1.0 {
                let proposal = trial * factor;
                // A step that was cut at the end says nothing against the proposal.
                let proposal =
                    if trial.abs() < self.proposal.abs() && factor >= 1.0 { self.proposal } else { proposal };
                return Some(Node { time: self.time + trial, state, proposal });
            }
            trial *= factor.min(0.9);
            if trial.abs() < SHORTEST {
                return None;
            }
        }
    }
}

/// The error estimate of a step over what is allowed.
fn error(slopes: &[Pair<f64>; STAGES], step: f64, from: Pair<f64>, to: Pair<f64>) -> f64 {
    let (mut fifth, mut third) = (0.0, 0.0);
    let [e5, e3] = [added([0.0; 2], slopes, 1.0, &ERROR_5), added([0.0; 2], slopes, 1.0, &ERROR_3)];
    for i in 0..2 {
        let scale = TOLERANCE * (1.0 + from[i].abs().max(to[i].abs()));
        fifth += e5[i] * e5[i] / (scale * scale);
        third += e3[i] * e3[i] / (scale * scale);
    }
    if fifth == 0.0 && third == 0.0 {
        return 0.0;
    }
    step.abs() * fifth / (2.0 * (fifth + 0.01 * third)).sqrt()
}
