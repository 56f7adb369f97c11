//! Gauss's collocation of order 12 for ẍ = F(x, ẋ, t), with control of the step, on plain numbers
//! and on jets.
//!
//! On a step the acceleration is a polynomial that agrees with F at the stages. Its values there
//! solve a small system by Newton's method, whose matrix is that of the variational equations as
//! well ([`variational`](super::variational)). F is evaluated at all six stages at once.

mod taylor;

use super::factors::Factors;
use super::jet::{Jet, PLANAR};
use super::oscillator::{Accuracy, Integrated, SmoothOscillator};
use super::stages::{Lanes, Stages};
use super::tableau::{LEGENDRE, MATRIX, NODES, POSITION_WEIGHTS, POWERS, SQUARE, WEIGHTS};
use crate::motion::DerivativeBounds;
use crate::scalar::Scalar;
use crate::state::State;

/// Position and velocity.
pub(super) type PositionVelocity<S> = [S; 2];

/// A step, solved or guessed: its length and the accelerations at the stages.
#[derive(Clone, Copy, Debug)]
pub(super) struct Step {
    pub(super) length: f64,
    pub(super) accelerations: Stages,
}

/// A point of a solution, with the step that is proposed from there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node {
    pub(super) time: f64,
    pub(super) state: PositionVelocity<f64>,
    pub(super) proposal: f64,
    /// The step that led here.
    pub(super) last: Option<Step>,
}

/// Size that is allowed of the two highest coefficients on a step: of the acceleration, relative to
/// the motion's scale, and of h² F_x and h F_y. Gauss's points make the error at the end of a step
/// a product of two neglected coefficients, of degree six and above: of the acceleration, or its
/// derivative, and of the solution of the variational equations. Coefficients fall fast, so both
/// are some 10⁻⁷ or less then, and each error is 10⁻¹³ or less (empirical; tests hold flows to
/// 10⁻¹²).
const TOLERANCE: f64 = 1e-5;
/// Size that is allowed of a coefficient of degree twelve, of the acceleration relative to the
/// motion's scale and of h² F_x and h F_y, the first that is neglected by itself and not in a
/// product, as far as the lower ones show ([`tail`]). It matters where coefficients are small but
/// fall slowly: the force comes in pulses, or bends by little and within a short way, as drag that
/// reverses at v = 0, and derivatives of second order are the first to be wrong (empirical: with
/// this size those are right to 10⁻¹¹ under tanh(50 ẋ), and to 10⁻⁸ under drag with a branch point
/// 0.1 beside the real velocities, whose coefficients fall so slowly beside larger ones that no six
/// values show them).
const TAIL: f64 = 3e-14;
/// The largest h r on a step, r being the fastest rate at which neighbouring motion turns or
/// decays: where F_x and F_y are constant nothing else shows how fast the variational equations
/// are. Their error is then that of Padé's approximation of the exponential function, (6!)²/(12!
/// 13!) (h r)¹³: 2·10⁻¹⁴ here.
const SWING: f64 = 0.85;
/// A step is solved again if h r is larger by more than this share: its error is four times as
/// large.
const OVERSWING: f64 = 0.1;
/// A step is solved again if it is rougher by more than this share: its error is then two and a
/// half times as large.
const OVERROUGH: f64 = 0.6;
/// The new step is this share of what the coefficients suggest, and changes by these factors at
/// most (empirical).
const SAFETY: f64 = 0.9;
const SHRINK: f64 = 0.3;
const GROW: f64 = 2.0;
/// Smallest factor by which h r may shorten a step: slopes far from the motion, where a step that
/// is too long ends, mean little.
const PLUNGE: f64 = 0.1;
/// A step this short, in units of 1/ω, means that the solution is not smooth, or escapes. It is
/// taken without control, which leads past a place where the force bends; where steps become
/// shorter still by this factor, as on the way into a pole, the solution ends.
const SHORTEST: f64 = 1e-9;
const VANISHING: f64 = 1e-3;
/// A step that must end this much sooner than the proposed one needs no control, at the start of a motion, where
/// less is known, by the second factor: all that is left of a very short step's coefficients is rounding.
const SHORT: f64 = 0.1;
const SHORT_AT_START: f64 = 1e-3;
/// The stages are solved for within this many iterations or the step is too long.
const ITERATIONS: usize = 12;
/// A correction this small, relative to the terms of which F is a sum, leaves the matrix unchanged;
/// the next corrections are smaller by about as much, and cost less than a matrix (empirical).
const NEAR: f64 = 0.2;
/// A correction is the last if it is this small, or if the next one would be below rounding.
const CONVERGED: f64 = 1e-12;
const ROUNDING: f64 = 1e-15;
/// Rough motion is allowed coefficients this many times as large, and a larger swing: with order 12
/// its errors are some 10⁶ times as large, about 10⁻⁷, and the stages are solved to correspondingly
/// fewer digits.
const ROUGHER: f64 = 200.0;
const WIDER: f64 = 2.5;
const LOOSER: f64 = 1e5;
/// Factor of the step of fine motion: with steps two thirds as long, coefficients of order five are
/// smaller by the fifth power of this, and errors of order twelve by 10⁻².
const NARROWER: f64 = 2.0 / 3.0;
const FINER: f64 = NARROWER * NARROWER * NARROWER * NARROWER * NARROWER;

/// Factor by which bounds on a rough step exceed those of its polynomial of degree five, to allow
/// for the part of the acceleration and of its derivatives that it leaves out (its last
/// coefficients are 2 · 10⁻³ of the whole or little more; a test samples motion).
const ROOM: f64 = 1.1;

/// The coefficients of degrees five and four of a function in Legendre polynomials on a step, taken
/// together, and those of degrees three and two.
fn highest(values: &Stages) -> [f64; 2] {
    let size = |k: usize| values.weighted(&LEGENDRE[k]).abs();
    [size(0) + 0.1 * size(1), size(2) + 0.1 * size(3)]
}

/// The coefficient of degree twelve, extrapolated from the rate at which coefficients fall here.
fn tail([high, low]: [f64; 2]) -> f64 {
    // Zero over zero is NaN, which counts as one.
    let fall = (high / low).min(1.0);
    high * fall * fall * fall * fall.sqrt()
}

/// The larger of a size of order 5 in the step, and of one of order 12 converted to order 5.
fn of_order_five(five: f64, twelve: f64) -> f64 {
    // Roots take time, and most tails are far too small to matter.
    if twelve < (five * five * five).min(1.0) {
        return five;
    }
    let third = twelve.sqrt().sqrt();
    five.max(third * third.sqrt() * third.sqrt().sqrt())
}

/// F_x and F_y on a step, with their spread and the rate of motion that they imply.
#[derive(Clone, Copy, Debug)]
struct Slopes {
    /// F_x and F_y at the stages.
    both: [Stages; 2],
    length: f64,
    /// By how much h² F_x and h F_y differ between stages.
    spread: f64,
    /// The fastest rate at which neighbouring motion turns or decays.
    rate: f64,
}

impl Slopes {
    fn new(both: [Stages; 2], length: f64) -> Self {
        let spread = |values: Stages| (values - Stages::constant(values.0[0])).modulus();
        let [by_position, by_velocity] = both;
        Self {
            both,
            length,
            spread: together([spread(by_position), spread(by_velocity)], length),
            rate: fastest_rate(by_position.modulus(), by_velocity.modulus()),
        }
    }

    /// The highest coefficients of h² F_x and h F_y, and those of degree twelve, as far as they are
    /// known.
    fn coefficients(&self) -> [f64; 2] {
        let [x, y] = [highest(&self.both[0]), highest(&self.both[1])];
        [together([x[0], y[0]], self.length), together([tail(x), tail(y)], self.length)]
    }
}

/// The sum of a size of F_x times h² and the same size of F_y times h.
fn together([by_position, by_velocity]: [f64; 2], length: f64) -> f64 {
    by_position * length * length + by_velocity * length.abs()
}

/// Upper bound of the zeros of r² − F_y r − F_x, for these moduli of F_x and F_y.
fn fastest_rate(stiffness: f64, loss: f64) -> f64 {
    0.5 * (loss + (loss * loss + 4.0 * stiffness).sqrt())
}

impl Step {
    /// The times of the stages.
    pub(super) fn times(&self, start: f64) -> Stages {
        Lanes(NODES).scale(self.length) + Stages::constant(start)
    }

    /// Position and velocity at the stages.
    #[inline(always)]
    pub(super) fn stages(&self, [x, y]: PositionVelocity<f64>) -> PositionVelocity<Stages> {
        let h = self.length;
        let straight = Stages::constant(x) + Lanes(NODES).scale(h * y);
        let position = straight.plus(h * h, &self.accelerations.through(&SQUARE));
        [position, Stages::constant(y).plus(h, &self.accelerations.through(&MATRIX))]
    }

    /// Position and velocity at the end.
    pub(super) fn end(&self, [x, y]: PositionVelocity<f64>) -> PositionVelocity<f64> {
        let h = self.length;
        let position = x + h * (y + h * self.accelerations.weighted(&POSITION_WEIGHTS));
        [position, y + h * self.accelerations.weighted(&WEIGHTS)]
    }

    /// The accelerations at the stages of another step, which begins at a fraction of this one, by
    /// interpolation.
    fn guess(&self, begin: f64, length: f64) -> Stages {
        let at = Lanes(NODES).scale(2.0 * length / self.length) + Stages::constant(2.0 * begin - 1.0);
        let [lower @ .., highest] = self.accelerations.through(&POWERS).0;
        let from = Stages::constant(highest);
        lower.into_iter().rev().fold(from, |value, coefficient| value * at + Stages::constant(coefficient))
    }

    /// Bounds of the derivatives of x on the step: those of its polynomial, widened for the part
    /// that the polynomial leaves out.
    pub(super) fn bounds(&self) -> DerivativeBounds {
        let sizes = self.accelerations.through(&POWERS).0.map(f64::abs);
        let slope = 2.0 / self.length.abs();
        let [mut acceleration, mut jerk, mut snap] = [0.0; 3];
        for (k, size) in sizes.into_iter().enumerate() {
            let k = k as f64;
            acceleration += ROOM * size;
            jerk += ROOM * size * k * slope;
            snap += ROOM * size * k * (k - 1.0) * slope * slope;
        }
        DerivativeBounds { acceleration, jerk, snap }
    }

    /// The size of accelerations where motion at this rate turns the state at which the step
    /// begins.
    ///
    /// An acceleration far below it has no effect, and may be no more than rounding: near rest the
    /// terms of F cancel.
    fn scale(&self, [x, y]: PositionVelocity<f64>, rate: f64) -> f64 {
        self.accelerations.modulus() + rate * (y.abs() + rate * x.abs())
    }
}

/// A size relative to a scale, zero where both vanish.
fn relative(size: f64, scale: f64) -> f64 {
    if size == 0.0 { 0.0 } else { size / scale }
}

impl<M: SmoothOscillator> Integrated<M> {
    /// The start of an integration in the direction of time of `duration`.
    pub(super) fn first_node(&self, from: State, duration: f64) -> Node {
        Node {
            time: from.phase / self.frequency,
            state: [from.position, from.velocity],
            proposal: (0.5 * self.longest_step()).copysign(duration),
            last: None,
        }
    }

    /// Solves for the accelerations of a step by Newton's method, and returns F_x and F_y on it;
    /// `None` if the iteration does not converge.
    fn solve(&self, from: PositionVelocity<f64>, time: f64, step: &mut Step) -> Option<Slopes> {
        let h = step.length;
        let ([mu, eta], times) = (self.parameters.map(Stages::constant), step.times(time));
        let (mut known, mut jets) = (self.model.slopes_at(times, mu, eta), None);
        // F, F_x and F_y at the stages, the last two if they are wanted.
        let mut force = |step: &Step, slopes: bool| {
            let [x, y] = step.stages(from);
            match &mut known {
                Some(force) => force(x, y, slopes),
                None => {
                    let force = jets.get_or_insert_with(|| self.model.force_at(times, mu, eta));
                    force(Jet::<PLANAR, Stages>::variable(0, x), Jet::variable(1, y)).0
                }
            }
        };
        let looser = if self.accuracy == Accuracy::Rough { LOOSER } else { 1.0 };
        let mut before = 1.0;
        let mut iterations = 0..ITERATIONS;
        loop {
            let [mut value, by_position, by_velocity] = force(step, true);
            let slopes = [by_position, by_velocity];
            let factors = Factors::new(&[slopes[0].scale(h * h), slopes[1].scale(h)]);
            let slopes = Slopes::new(slopes, h);
            // The matrix is kept once the iterate is near.
            loop {
                iterations.next()?;
                let correction = factors.solve(value - step.accelerations);
                step.accelerations = step.accelerations + correction;
                let scale = step.scale(from, slopes.rate.max(self.frequency));
                let size = relative(correction.modulus(), scale);
                if !size.is_finite() {
                    return None;
                }
                // The next one would be smaller than this one by the factor by which this one is
                // smaller than the last, or by more; and by what the slopes have changed since,
                // less than over the whole step. So one is enough where F is linear.
                let next = size * if size <= NEAR { slopes.spread.min(size / before) } else { size / before };
                if size <= CONVERGED * looser || next <= ROUNDING * looser {
                    return Some(slopes);
                }
                before = size;
                if size > NEAR {
                    break;
                }
                [value, ..] = force(step, false);
            }
        }
    }

    /// The slopes h² F_x and h F_y at the stages of a step.
    fn slopes(&self, from: PositionVelocity<f64>, time: f64, step: &Step) -> [Stages; 2] {
        let h = step.length;
        let parameters = self.parameters.map(Jet::<PLANAR, Stages>::constant);
        let ([x, y], [mu, eta]) = (step.stages(from), parameters);
        let time = Jet::fixed(step.times(time));
        let force = self.model.force(Jet::variable(0, x), Jet::variable(1, y), time, mu, eta);
        [force.first(0).scale(h * h), force.first(1).scale(h)]
    }

    /// A part of a step that has been solved: it begins at the fraction `begin` of the step and is
    /// as long as the fraction `share`.
    fn part(
        &self,
        from: PositionVelocity<f64>,
        time: f64,
        step: &Step,
        [begin, share]: [f64; 2],
    ) -> Option<Step> {
        let length = step.length * share;
        let mut part = Step { length, accelerations: step.guess(begin, length) };
        self.solve(from, time + begin * step.length, &mut part).map(|_| part)
    }

    /// The node after this one, at most `longest` away in time; `None` if the solution cannot be
    /// continued.
    pub(super) fn next_node(&self, node: &Node, longest: f64) -> Option<Node> {
        let mut trial = if node.proposal.abs() <= longest.abs() { node.proposal } else { longest };
        // Far from any solution Newton's method may try a frequency below zero.
        let shortest = SHORTEST / self.frequency.abs();
        if node.proposal.abs() < VANISHING * shortest {
            return None;
        }
        let [rougher, wider] = match self.accuracy {
            Accuracy::Rough => [ROUGHER, WIDER],
            Accuracy::Usual => [1.0; 2],
            Accuracy::Fine => [FINER, NARROWER],
        };
        let share = if node.last.is_some() { SHORT } else { SHORT_AT_START };
        let is_short = longest.abs() < share * node.proposal.abs();
        loop {
            let accelerations = match &node.last {
                Some(last) => last.guess(1.0, trial),
                None => {
                    let (acceleration, rate) = self.start(node);
                    let longest = wider * SWING / rate;
                    trial = if trial.abs() < longest { trial } else { longest.copysign(trial) };
                    Stages::constant(acceleration)
                }
            };
            let mut step = Step { length: trial, accelerations };
            let Some(slopes) = self.solve(node.state, node.time, &mut step) else {
                trial *= SHRINK;
                // Shortening does not help NaN and infinity.
                if !(shortest..f64::INFINITY).contains(&trial.abs()) {
                    return None;
                }
                continue;
            };
            let scale = step.scale(node.state, self.frequency);
            let of_motion = highest(&step.accelerations).map(|size| relative(size, scale));
            let of_slopes = slopes.coefficients();
            let [five, twelve] = [of_motion[0] + of_slopes[0], tail(of_motion) + of_slopes[1]];
            let roughness = of_order_five(five / TOLERANCE, twelve / TAIL) / rougher;
            let swing = slopes.rate * trial.abs() / (wider * SWING);
            // The highest coefficient is of order 5 in the step; 3/16 is a little less than 1/5,
            // and takes roots alone.
            let eighth = roughness.sqrt().sqrt().sqrt();
            let factor = (SAFETY / (eighth * eighth.sqrt())).clamp(SHRINK, GROW).min(1.0 / swing).max(PLUNGE);
            let is_good = roughness <= 1.0 + OVERROUGH && swing <= 1.0 + OVERSWING;
            if is_good || is_short || trial.abs() < shortest {
                // A step that was cut at the end is no evidence against the proposal.
                let cut =
                    trial == longest && longest.abs() < node.proposal.abs() && (factor >= 1.0 || is_short);
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

    /// The acceleration at a node, and the fastest rate there.
    fn start(&self, node: &Node) -> (f64, f64) {
        let [[x, y], [mu, eta]] = [node.state, self.parameters];
        let [mu, eta] = [mu, eta].map(Jet::<PLANAR>::constant);
        let force =
            self.model.force(Jet::variable(0, x), Jet::variable(1, y), Jet::constant(node.time), mu, eta);
        (force.value(), fastest_rate(force.first(0).abs(), force.first(1).abs()))
    }

    /// The step from a node to a time on the way to the next one.
    pub(super) fn step_between(&self, node: &Node, next: &Node, time: f64) -> Option<Step> {
        let length = time - node.time;
        let mut step = Step { length, accelerations: next.last.as_ref()?.guess(0.0, length) };
        self.solve(node.state, node.time, &mut step).map(|_| step)
    }
}

#[cfg(test)]
mod tests {
    use core::f64::consts::TAU;

    use super::*;
    use crate::motion::Motion;
    use crate::oscillator::ImpactOscillator;
    use crate::scalar::Function;
    use crate::state::State;

    /// Forcing in pulses, narrower with increasing sharpness: a pendulum, or a linear spring.
    #[derive(Clone)]
    struct Driven {
        sharpness: f64,
        pendulum: bool,
    }

    impl SmoothOscillator for Driven {
        fn force<S: Scalar>(&self, x: S, y: S, t: S, amplitude: S, omega: S) -> S {
            let pulse = ((omega * t).apply(Function::Cos) - 1.0).scale(self.sharpness).apply(Function::Exp);
            let spring = if self.pendulum { x.apply(Function::Sin) } else { x };
            amplitude * pulse - spring - y.scale(0.1)
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

    /// Position and velocity at a time by `count` steps of equal length.
    fn by_equal_steps(oscillator: &Integrated<Driven>, end: f64, count: u32) -> PositionVelocity<f64> {
        let length = end / f64::from(count);
        (0..count).fold([-0.4, 0.7], |state, k| {
            let time = length * f64::from(k);
            let accelerations = Stages::constant(oscillator.force(state[0], state[1], time));
            let mut step = Step { length, accelerations };
            oscillator.solve(state, time, &mut step).unwrap();
            step.end(state)
        })
    }

    #[test]
    fn method_has_order_twelve() {
        let oscillator = Integrated::new(Driven { sharpness: 0.5, pendulum: true }, [0.4, 0.9]);
        let exact = by_equal_steps(&oscillator, 6.0, 40);
        let error = |count: u32| {
            let state = by_equal_steps(&oscillator, 6.0, count);
            (state[0] - exact[0]).abs().max((state[1] - exact[1]).abs())
        };
        let order = libm::log2(error(4) / error(8));
        // Between steps of 1.5 and 0.75, where errors are 1e-8 and 1e-12: not yet quite asymptotic.
        assert!((order - 12.0).abs() < 1.5, "{order}");
    }

    #[test]
    fn steps_are_short_enough_for_pulses_and_finer_ones_make_errors_smaller() {
        let usual = Integrated::new(Driven { sharpness: 6.0, pendulum: false }, [1.0, 0.5]);
        let fine = usual.finely().unwrap();
        let period = usual.forcing_period();
        let exact = by_equal_steps(&usual, period, 400);
        // The second of two ways in turn begins steps at all phases, so that no error is small by
        // chance.
        let error = |oscillator: &Integrated<Driven>| {
            let parted = |k: u32| {
                let share = f64::from(k) / 50.0;
                let from = State { position: -0.4, velocity: 0.7, phase: 0.0 };
                let middle = oscillator.motion(from).at(period * share);
                let from = State { position: middle.position, velocity: middle.velocity, phase: TAU * share };
                let end = oscillator.motion(from).at(period * (1.0 - share));
                (end.position - exact[0]).abs().max((end.velocity - exact[1]).abs())
            };
            (1..50).map(parted).fold(0.0, f64::max)
        };
        let [usual, fine] = [error(&usual), error(&fine)];
        // Without the check of the acceleration's own tail the first is 7.9e-14, with it 2.9e-14;
        // the remainder of the second is rounding.
        assert!(usual < 5e-14 && fine < 0.5 * usual, "{usual:e} {fine:e}");
    }
}
