//! Gauss's collocation of order 12 for ẍ = F(x, ẋ, t), with control of the step, on plain numbers and on jets.
//!
//! On a step the acceleration is a polynomial that agrees with F at the stages. Its values there solve a small system, for
//! which the derivatives of F are at hand; with jets the same system, whose plain part is solved, needs one more
//! iteration of Newton's method for each order of derivatives. So the derivatives are those of the numerical solution, its
//! steps held, and cost a few evaluations of F at six points a step.

mod taylor;

use super::jet::{FIRST, Jet, PLAIN, PLANAR, SECOND};
use super::scalar::Scalar;
use super::tableau::{BARYCENTRIC, LEGENDRE, MATRIX, NODES, POSITION_WEIGHTS, SQUARE, STAGES, WEIGHTS};
use super::{Integrated, SmoothOscillator};

/// Position and velocity.
pub(super) type Pair<S> = [S; 2];

/// A step that has been solved: its length and the accelerations at the stages.
#[derive(Clone, Copy, Debug)]
pub(super) struct Step {
    length: f64,
    accelerations: [f64; STAGES],
    /// The two highest coefficients of h² F_x and h F_y on the step, which the derivatives of the flow depend on.
    slope_roughness: f64,
}

/// A point of a solution, with the step that is proposed from there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node {
    pub(super) time: f64,
    pub(super) state: Pair<f64>,
    pub(super) proposal: f64,
    /// The step that led here.
    pub(super) last: Option<Step>,
}

/// What F depends on besides position and velocity, as jets: the time origin's shift and the parameters.
#[derive(Clone, Copy, Debug)]
pub(super) struct Surroundings<const LENGTH: usize> {
    pub(super) origin: Jet<LENGTH>,
    pub(super) parameters: [Jet<LENGTH>; 2],
}

/// Size of the two highest coefficients on a step that is allowed: of the acceleration, relative to 1 + the largest one, and of its
/// derivatives (empirical). Coefficients fall geometrically with the degree; an error at the end comes from those of degree
/// twelve and above, which are then 10⁻¹³ or so, and enter with a small factor. Tests hold flows to 10⁻¹².
const TOLERANCE: f64 = 5e-6;
/// The new step is this share of what the coefficients suggest, and changes by these factors at most (empirical).
const SAFETY: f64 = 0.9;
const SHRINK: f64 = 0.3;
const GROW: f64 = 2.0;
/// A step this short means that the solution is not smooth, or escapes: all times are of order one (dimensionless).
const SHORTEST: f64 = 1e-9;
/// The stages are solved for within this many iterations or the step is too long.
const ITERATIONS: usize = 12;
/// A correction this small, relative to 1 + the largest acceleration, lets the matrix stand; the next ones are smaller by about as much.
const NEAR: f64 = 1e-3;
/// A correction this small is the last.
const CONVERGED: f64 = 1e-12;

/// The factors of the matrix I − h² A² F_x − h A F_y of Newton's method, without pivots: it is close to the identity where
/// the step is not too long, and where it is not the iteration fails and the step is shortened.
struct Factors([[f64; STAGES]; STAGES]);

#[expect(clippy::needless_range_loop, reason = "indices as in the formulas")]
impl Factors {
    #[inline]
    fn new([by_position, by_velocity]: &[[f64; STAGES]; 2]) -> Self {
        let mut m = [[0.0; STAGES]; STAGES];
        for i in 0..STAGES {
            for j in 0..STAGES {
                m[i][j] = -by_position[i] * SQUARE[i][j] - by_velocity[i] * MATRIX[i][j];
            }
            m[i][i] += 1.0;
        }
        for k in 0..STAGES {
            let inverse = 1.0 / m[k][k];
            m[k][k] = inverse;
            for i in k + 1..STAGES {
                let factor = m[i][k] * inverse;
                m[i][k] = factor;
                for j in k + 1..STAGES {
                    m[i][j] -= factor * m[k][j];
                }
            }
        }
        Self(m)
    }

    #[inline(always)]
    fn solve(&self, b: &mut [f64; STAGES]) {
        for i in 0..STAGES {
            for k in 0..i {
                b[i] -= self.0[i][k] * b[k];
            }
        }
        for i in (0..STAGES).rev() {
            for k in i + 1..STAGES {
                b[i] -= self.0[i][k] * b[k];
            }
            b[i] *= self.0[i][i];
        }
    }

    #[inline(always)]
    fn solve_jets<const LENGTH: usize>(&self, b: &mut [Jet<LENGTH>; STAGES]) {
        for i in 0..STAGES {
            let mut sum = b[i];
            for k in 0..i {
                sum.add_multiple(-self.0[i][k], &b[k]);
            }
            b[i] = sum;
        }
        for i in (0..STAGES).rev() {
            let mut sum = b[i];
            for k in i + 1..STAGES {
                sum.add_multiple(-self.0[i][k], &b[k]);
            }
            b[i] = sum.scale(self.0[i][i]);
        }
    }
}

fn sum(weights: &[f64; STAGES], values: &[f64; STAGES]) -> f64 {
    let mut sum = 0.0;
    for j in 0..STAGES {
        sum += weights[j] * values[j];
    }
    sum
}

/// The two highest coefficients of a function in Legendre polynomials on a step, taken together.
fn highest(values: &[f64; STAGES]) -> f64 {
    let [a, b] = LEGENDRE.map(|weights| sum(&weights, values));
    a.abs() + 0.1 * b.abs()
}

impl Step {
    /// Position and velocity at a stage.
    #[inline(always)]
    fn stage(&self, [x, y]: Pair<f64>, i: usize) -> Pair<f64> {
        let h = self.length;
        let position = x + h * (NODES[i] * y + h * sum(&SQUARE[i], &self.accelerations));
        [position, y + h * sum(&MATRIX[i], &self.accelerations)]
    }

    /// Position and velocity at the end.
    pub(super) fn end(&self, [x, y]: Pair<f64>) -> Pair<f64> {
        let h = self.length;
        let position = x + h * (y + h * sum(&POSITION_WEIGHTS, &self.accelerations));
        [position, y + h * sum(&WEIGHTS, &self.accelerations)]
    }

    /// The accelerations at the stages of another step, which begins at a fraction of this one, by interpolation.
    fn guess(&self, begin: f64, length: f64) -> [f64; STAGES] {
        NODES.map(|node| {
            let at = begin + node * length / self.length;
            let (mut numerator, mut denominator) = (0.0, 0.0);
            for j in 0..STAGES {
                let gap = at - NODES[j];
                if gap == 0.0 {
                    return self.accelerations[j];
                }
                let weight = BARYCENTRIC[j] / gap;
                numerator += weight * self.accelerations[j];
                denominator += weight;
            }
            numerator / denominator
        })
    }

    /// 1 + the largest acceleration.
    fn scale(&self) -> f64 {
        1.0 + self.accelerations.iter().fold(0.0, |largest, k| k.abs().max(largest))
    }

    /// The two highest coefficients over what is allowed.
    fn roughness(&self) -> f64 {
        (highest(&self.accelerations) / self.scale() + self.slope_roughness) / TOLERANCE
    }
}

impl<M: SmoothOscillator> Integrated<M> {
    /// Solves for the accelerations of a step by Newton's method; `None` if it does not converge.
    #[expect(clippy::needless_range_loop, reason = "indices as in the formulas")]
    fn solve_step(&self, from: Pair<f64>, time: f64, guess: Step) -> Option<Step> {
        let mut step = guess;
        let mut factors = None;
        for _ in 0..ITERATIONS {
            let mut residual = [0.0; STAGES];
            let current = match factors.take() {
                Some(factors) => {
                    for i in 0..STAGES {
                        let [x, y] = step.stage(from, i);
                        residual[i] = self.force(x, y, time + NODES[i] * step.length) - step.accelerations[i];
                    }
                    factors
                }
                None => {
                    let (forces, factors, roughness) = self.linearised(from, time, &step);
                    step.slope_roughness = roughness;
                    for i in 0..STAGES {
                        residual[i] = forces[i] - step.accelerations[i];
                    }
                    factors
                }
            };
            current.solve(&mut residual);
            let mut correction = 0.0_f64;
            for i in 0..STAGES {
                step.accelerations[i] += residual[i];
                correction = if residual[i].abs() <= correction { correction } else { residual[i].abs() };
            }
            if !correction.is_finite() {
                return None;
            }
            let scale = step.scale();
            if correction <= CONVERGED * scale {
                return Some(step);
            }
            if correction <= NEAR * scale {
                factors = Some(current);
            }
        }
        None
    }

    /// The forces at the stages, and the factors of Newton's matrix.
    #[inline]
    fn linearised(&self, from: Pair<f64>, time: f64, step: &Step) -> ([f64; STAGES], Factors, f64) {
        let [mu, eta] = self.parameters.map(Jet::<PLANAR>::constant);
        let mut forces = [0.0; STAGES];
        let mut slopes = [[0.0; STAGES]; 2];
        for i in 0..STAGES {
            let [x, y] = step.stage(from, i);
            let t = Jet::constant(time + NODES[i] * step.length);
            let force = self.model.force(Jet::variable(0, x), Jet::variable(1, y), t, mu, eta);
            forces[i] = force.value();
            slopes[0][i] = step.length * step.length * force.first(0);
            slopes[1][i] = step.length * force.first(1);
        }
        (forces, Factors::new(&slopes), highest(&slopes[0]) + highest(&slopes[1]))
    }

    /// The node after this one, `longest` away at most in time; `None` if the solution cannot be continued.
    pub(super) fn next_node(&self, node: &Node, longest: f64) -> Option<Node> {
        let mut trial = if node.proposal.abs() < longest.abs() { node.proposal } else { longest };
        loop {
            let guess = match &node.last {
                Some(last) => last.guess(1.0, trial),
                None => [self.force(node.state[0], node.state[1], node.time); STAGES],
            };
            let solved = self.solve_step(
                node.state,
                node.time,
                Step { length: trial, accelerations: guess, slope_roughness: 0.0 },
            );
            let Some(step) = solved else {
                trial *= SHRINK;
                if trial.abs() < SHORTEST {
                    return None;
                }
                continue;
            };
            let roughness = step.roughness();
            // The highest coefficient is of order 5 in the step; 3/16 is a little less than 1/5, and takes roots alone.
            let eighth = roughness.sqrt().sqrt().sqrt();
            let factor = (SAFETY / (eighth * eighth.sqrt())).clamp(SHRINK, GROW);
            if roughness <= 1.0 || trial.abs() < SHORTEST {
                // A step that was cut at the end says nothing against the proposal.
                let cut = trial.abs() < node.proposal.abs() && factor >= 1.0;
                let proposal = if cut { node.proposal } else { trial * factor };
                let longest = self.longest_step();
                let proposal = if proposal.abs() < longest { proposal } else { longest.copysign(proposal) };
                return Some(Node {
                    time: node.time + trial,
                    state: step.end(node.state),
                    proposal,
                    last: Some(step),
                });
            }
            trial *= factor.min(SAFETY);
        }
    }

    /// The step from a node to a time on the way to the next one.
    pub(super) fn step_between(&self, node: &Node, next: &Node, time: f64) -> Option<Step> {
        let length = time - node.time;
        let accelerations = next.last.as_ref()?.guess(0.0, length);
        self.solve_step(node.state, node.time, Step { length, accelerations, slope_roughness: 0.0 })
    }

    /// The jets at the end of a step that has been solved.
    #[inline(never)]
    pub(super) fn jets_after<const LENGTH: usize>(
        &self,
        from: &Pair<Jet<LENGTH>>,
        time: f64,
        step: &Step,
        surroundings: &Surroundings<LENGTH>,
    ) -> Pair<Jet<LENGTH>> {
        let (_, factors, _) = self.linearised(from.each_ref().map(Jet::value), time, step);
        let reduced = Surroundings {
            origin: surroundings.origin.resized(),
            parameters: surroundings.parameters.each_ref().map(Jet::resized),
        };
        let plain = step.accelerations.map(Jet::<PLAIN>::constant);
        let first_order = from.each_ref().map(Jet::resized);
        let first: [Jet<FIRST>; STAGES] =
            self.corrected(&first_order, time, step.length, &reduced, &factors, &plain);
        let accelerations = if LENGTH == SECOND {
            self.corrected(from, time, step.length, surroundings, &factors, &first)
        } else {
            first.each_ref().map(Jet::resized)
        };
        let h = step.length;
        let [mut x, mut y] = *from;
        x.add_multiple(h, &from[1]);
        for j in 0..STAGES {
            x.add_multiple(h * h * POSITION_WEIGHTS[j], &accelerations[j]);
            y.add_multiple(h * WEIGHTS[j], &accelerations[j]);
        }
        [x, y]
    }

    /// One iteration of Newton's method with jets, from accelerations that are right to one order less.
    #[inline(always)]
    fn corrected<const LENGTH: usize, const LESS: usize>(
        &self,
        from: &Pair<Jet<LENGTH>>,
        time: f64,
        h: f64,
        surroundings: &Surroundings<LENGTH>,
        factors: &Factors,
        accelerations: &[Jet<LESS>; STAGES],
    ) -> [Jet<LENGTH>; STAGES] {
        let [mu, eta] = surroundings.parameters;
        let mut corrected = [Jet::constant(0.0); STAGES];
        for i in 0..STAGES {
            let [mut x, mut y] = *from;
            x.add_multiple(h * NODES[i], &from[1]);
            for j in 0..STAGES {
                x.add_multiple(h * h * SQUARE[i][j], &accelerations[j]);
            }
            for j in 0..STAGES {
                y.add_multiple(h * MATRIX[i][j], &accelerations[j]);
            }
            let t = surroundings.origin + Jet::constant(time + NODES[i] * h);
            corrected[i] = self.model.force(x, y, t, mu, eta);
            corrected[i].add_multiple(-1.0, &accelerations[i]);
        }
        factors.solve_jets(&mut corrected);
        for i in 0..STAGES {
            corrected[i].add_multiple(1.0, &accelerations[i]);
        }
        corrected
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::smooth::Function;

    /// A pendulum that is driven.
    #[derive(Clone)]
    struct Pendulum;

    impl SmoothOscillator for Pendulum {
        fn force<S: Scalar>(&self, x: S, y: S, t: S, amplitude: S, omega: S) -> S {
            amplitude * (omega * t).apply(Function::Cos) - x.apply(Function::Sin) - y.scale(0.1)
        }

        fn forcing_frequency<S: Scalar>(&self, _: S, omega: S) -> S {
            omega
        }

        fn restitution<S: Scalar>(&self, _: S, _: S, _: S, _: S) -> S {
            S::constant(1.0)
        }

        fn impact_duration<S: Scalar>(&self, _: S, _: S, _: S, _: S) -> S {
            S::constant(0.0)
        }
    }

    /// Position and velocity at time 6 by so many steps of one length.
    fn by_equal_steps(count: u32) -> Pair<f64> {
        let oscillator = Integrated::new(Pendulum, [0.4, 0.9]);
        let length = 6.0 / f64::from(count);
        (0..count).fold([-0.4, 0.7], |state, k| {
            let time = length * f64::from(k);
            let accelerations = [oscillator.force(state[0], state[1], time); STAGES];
            let guess = Step { length, accelerations, slope_roughness: 0.0 };
            oscillator.solve_step(state, time, guess).unwrap().end(state)
        })
    }

    #[test]
    fn method_has_order_twelve() {
        let exact = by_equal_steps(40);
        let error = |count: u32| {
            let state = by_equal_steps(count);
            (state[0] - exact[0]).abs().max((state[1] - exact[1]).abs())
        };
        let order = libm::log2(error(4) / error(8));
        // Between steps of 1.5 and 0.75, where errors are 1e-8 and 1e-12: not yet quite asymptotic.
        assert!((order - 12.0).abs() < 1.5, "{order}");
    }
}
