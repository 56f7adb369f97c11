//! The coefficients of a linear force with their derivatives in the parameters, and the flow with its
//! derivatives.

use core::f64::consts::TAU;

use smallvec::SmallVec;

use super::super::flow::AlongFlow;
use super::super::jet::{FIRST, Jet, SECOND, variable};
use super::super::oscillator::{Integrated, SmoothOscillator};
use super::propagator::Propagator;
use crate::jet::FlowJet;
use crate::scalar::{Function, Scalar};
use crate::state::State;

/// Smallest |k|/ω² of a stiffness other than zero, and of |c|/ω without stiffness, if they vary with the
/// parameters, and if they do not: the formulas divide by them, second derivatives by their cubes, and what
/// is left of large terms that cancel has that many digits fewer.
const WEAKEST: [f64; 2] = [0.03, 1e-3];
/// Smallest |k − c²/4| as a fraction of k + c²/4: next to critical damping both exponentials of the motion
/// are large, and cancel.
const CRITICAL: f64 = 1e-3;
/// Smallest share of |k − m²ω² + icmω|² in (|k| + m²ω²)²: the response is so large otherwise, its second derivatives above all, that
/// motion beside it loses digits.
const RESONANT: f64 = 1e-4;
/// Position and velocity at which the force is so large that its other part is below rounding of it.
const FAR: f64 = 1_073_741_824.0;

/// A cosine and a sine of a multiple of the phase, with derivatives in the parameters.
type Wave<const LENGTH: usize> = [Jet<LENGTH>; 2];

/// A harmonic of the forcing and the response to it.
#[derive(Clone, Debug)]
pub(super) struct Harmonic {
    /// The multiple m of the phase.
    pub(super) multiple: f64,
    /// The force, the position and the velocity.
    pub(super) force: Wave<SECOND>,
    pub(super) position: Wave<SECOND>,
    pub(super) velocity: Wave<SECOND>,
}

/// The force −k x − c ẋ + f₀ + Σ f_m(z).
#[derive(Clone, Debug)]
pub(super) struct LinearForce {
    pub(super) frequency: Jet<SECOND>,
    pub(super) stiffness: Jet<SECOND>,
    pub(super) damping: Jet<SECOND>,
    /// The constant f₀.
    pub(super) load: Jet<SECOND>,
    /// The position of rest f₀/k; `None` where k = 0.
    pub(super) rest: Option<Jet<SECOND>>,
    pub(super) harmonics: SmallVec<[Harmonic; 1]>,
}

impl LinearForce {
    /// The coefficients of an oscillator's force at its parameters; `None` where its flow has no closed
    /// form, or one that loses digits.
    pub(super) fn of<M: SmoothOscillator>(oscillator: &Integrated<M>) -> Option<Self> {
        let model = &oscillator.model;
        let multiples = model.harmonics()?;
        let [mu, eta] = oscillator.parameter_jets::<SECOND>();
        let frequency = model.forcing_frequency(mu, eta);
        let omega = frequency.value();
        let count = 2 * multiples + 1;
        let phases = (0..count).map(|k| TAU * f64::from(k) / f64::from(count));
        let force = |x: f64, y: f64, phase: f64| {
            let time = Jet::constant(phase) / frequency;
            model.force(Jet::constant(x), Jet::constant(y), time, mu, eta)
        };
        let samples: SmallVec<[(f64, Jet<SECOND>); 5]> =
            phases.map(|phase| (phase, force(0.0, 0.0, phase))).collect();
        let (_, at_wall) = samples[0];
        let stiffness = (at_wall - force(FAR, 0.0, 0.0)).scale(1.0 / FAR);
        let damping = (at_wall - force(0.0, FAR, 0.0)).scale(1.0 / FAR);
        let mean = |weight: &dyn Fn(f64) -> f64| {
            let zero = Jet::constant(0.0);
            samples.iter().fold(zero, |sum, (phase, force)| sum.plus(weight(*phase), force))
        };
        let share = 1.0 / f64::from(count);
        let load = mean(&|_| share);
        let [k, c] = [stiffness.value(), damping.value()];
        let square = omega * omega;
        let discriminant = k - 0.25 * c * c;
        let is_zero = |jet: &Jet<SECOND>| jet.0.iter().all(|entry| *entry == 0.0);
        let weakest = |jet: &Jet<SECOND>| {
            let varies = jet.0[1..].iter().any(|entry| *entry != 0.0);
            if varies { WEAKEST[0] } else { WEAKEST[1] }
        };
        let is_free = is_zero(&stiffness) && (is_zero(&damping) || c.abs() > weakest(&damping) * omega);
        let is_held = k.abs() > weakest(&stiffness) * square
            && discriminant.abs() > CRITICAL * (k.abs() + 0.25 * c * c);
        if !(omega > 0.0 && omega.is_finite() && (is_free || is_held)) {
            return None;
        }
        let mut harmonics = SmallVec::new();
        for m in (1..=multiples).map(f64::from) {
            let cosine = mean(&|phase| 2.0 * share * libm::cos(m * phase));
            let sine = mean(&|phase| 2.0 * share * libm::sin(m * phase));
            let [distance, loss] =
                [stiffness - frequency.square().scale(m * m), damping * frequency.scale(m)];
            let modulus = distance.square() + loss.square();
            let whole = k.abs() + m * m * square;
            let nearness = modulus.value() / (whole * whole);
            if nearness.is_nan() || nearness <= RESONANT {
                return None;
            }
            let position =
                [(cosine * distance - sine * loss) / modulus, (sine * distance + cosine * loss) / modulus];
            let rate = frequency.scale(m);
            let velocity = [rate * position[1], -(rate * position[0])];
            harmonics.push(Harmonic { multiple: m, force: [cosine, sine], position, velocity });
        }
        let is_finite =
            [stiffness, damping, load].iter().all(|jet| jet.0.iter().all(|entry| entry.is_finite()));
        let rest = (k != 0.0).then(|| load / stiffness);
        is_finite.then_some(Self { frequency, stiffness, damping, load, rest, harmonics })
    }

    /// The flow for a time, with derivatives: with w = (x, y), r the periodic response and E the flow without
    /// forcing, w(s) = E(s) (w₀ − r(z₀)) + r(z₀ + ωs).
    pub(super) fn flow_jet<const LENGTH: usize>(&self, from: State, duration: f64) -> FlowJet {
        let [stiffness, damping, frequency, load] =
            [self.stiffness, self.damping, self.frequency, self.load].map(|jet| part::<LENGTH>(&jet));
        let phase = Jet::constant(from.phase) + frequency.scale(duration);
        let (mut start, mut end) = ([Jet::constant(0.0); 2], [Jet::constant(0.0); 2]);
        let (mut forcing, mut forcing_rate) = (load, 0.0);
        let (mut beginning, mut beginning_rate) = (part::<FIRST>(&self.load), 0.0);
        for harmonic in &self.harmonics {
            let m = harmonic.multiple;
            let [position, velocity, force] = [&harmonic.position, &harmonic.velocity, &harmonic.force]
                .map(|wave| wave.map(|jet| part(&jet)));
            let (sin, cos) = libm::sincos(m * from.phase);
            let at_start = |wave: &Wave<LENGTH>| wave[0].scale(cos).plus(sin, &wave[1]);
            start = [start[0] + at_start(&position), start[1] + at_start(&velocity)];
            let at_first = harmonic.force.map(|jet| part::<FIRST>(&jet));
            beginning = beginning + at_first[0].scale(cos).plus(sin, &at_first[1]);
            beginning_rate += m * (cos * at_first[1].value() - sin * at_first[0].value());
            let turned = phase.scale(m);
            let [cos, sin] = [Function::Cos, Function::Sin].map(|function| turned.apply(function));
            let at_end = |wave: &Wave<LENGTH>| wave[0] * cos + wave[1] * sin;
            end = [end[0] + at_end(&position), end[1] + at_end(&velocity)];
            forcing = forcing + at_end(&force);
            forcing_rate += m * (cos.value() * force[1].value() - sin.value() * force[0].value());
        }
        let Propagator { cosine, sine } = Propagator::new(stiffness, damping, duration);
        let half = damping.scale(0.5) * sine;
        let still = match &self.rest {
            Some(rest) => [part(rest), Jet::constant(0.0)],
            None => [Jet::constant(0.0); 2],
        };
        let u = Jet::variable(variable::POSITION, from.position) - start[0] - still[0];
        let v = Jet::variable(variable::VELOCITY, from.velocity) - start[1] - still[1];
        let mut x = (cosine + half) * u + sine * v + end[0] + still[0];
        let mut y = (cosine - half) * v - stiffness * sine * u + end[1];
        if self.rest.is_none() {
            // From rest, under the load alone.
            let moved = match damping.value() == 0.0 {
                true => Jet::constant(0.5 * duration * duration),
                false => (Jet::constant(duration) - sine) / damping,
            };
            x = x + load * moved;
            y = y + load * sine;
        }
        let acceleration = forcing - stiffness * x - damping * y;
        let [k, c] = [stiffness.value(), damping.value()];
        let force = beginning
            - part::<FIRST>(&self.stiffness) * Jet::variable(variable::POSITION, from.position)
            - part::<FIRST>(&self.damping) * Jet::variable(variable::VELOCITY, from.velocity);
        AlongFlow {
            jerk: frequency.value() * forcing_rate - k * y.value() - c * acceleration.value(),
            end: [x, y],
            acceleration,
            frequency: part(&self.frequency),
            force,
            by_phase: beginning_rate,
        }
        .flow_jet(from)
    }
}

/// The jet to an order that may be lower.
fn part<const LENGTH: usize>(jet: &Jet<SECOND>) -> Jet<LENGTH> {
    Jet(core::array::from_fn(|entry| jet.0[entry]))
}
