//! Oscillators of the general class to test with: the linear flow under a reset law whose Φ and Ψ vary with all their
//! arguments, and with either parameter as the primary one.

use grazing_model::flow_variable::{PRIMARY, SECONDARY};
use grazing_model::{FlowJet, ImpactOscillator, LinearMotion, LinearOscillator, MapJet, ParameterJet, State};
use grazing_theorems::from_map::GrazingOrbit;
use nalgebra::{Matrix2, Vector2};

use crate::sampling::Sampler;

type Failure = Box<dyn core::error::Error + Send + Sync>;

/// Φ = c₀ + c₁ sin y + c₂ sin z + c₃ω and Ψ = d₀ + d₁ sin y + d₂ sin z + d₃ω.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ResetLaw {
    pub(crate) restitution: [f64; 4],
    pub(crate) delay: [f64; 4],
}

impl ResetLaw {
    /// Φ and Ψ.
    pub(crate) fn factors(&self, velocity: f64, phase: f64, frequency: f64) -> [f64; 2] {
        [self.restitution, self.delay]
            .map(|[c0, c1, c2, c3]| c0 + c1 * libm::sin(velocity) + c2 * libm::sin(phase) + c3 * frequency)
    }
}

/// An impact oscillator whose impacts take time.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Specimen {
    base: LinearOscillator,
    pub(crate) law: ResetLaw,
    /// The frequency is the primary parameter, the amplitude the secondary one.
    frequency_first: bool,
}

impl Specimen {
    pub(crate) fn new(base: LinearOscillator, law: ResetLaw) -> Self {
        Self { base, law, frequency_first: false }
    }

    /// The same oscillator with the frequency as its primary parameter: then ω depends on μ.
    pub(crate) fn frequency_first(self) -> Self {
        Self { frequency_first: true, ..self }
    }

    /// A reset law without pattern, with Φ between 0 and 1 and |Ψ| below 0.7, whatever the velocity.
    pub(crate) fn random_law(sampler: &mut Sampler) -> ResetLaw {
        ResetLaw {
            restitution: [
                sampler.between(0.45, 0.65),
                sampler.between(-0.2, 0.2),
                sampler.between(-0.1, 0.1),
                sampler.between(-0.03, 0.03),
            ],
            delay: [
                sampler.between(-0.2, 0.2),
                sampler.between(-0.3, 0.3),
                sampler.between(-0.1, 0.1),
                sampler.between(-0.03, 0.03),
            ],
        }
    }

    /// The oscillator at grazing with a damping ratio, a frequency and a law without pattern, and its grazing phase.
    pub(crate) fn random(sampler: &mut Sampler) -> Result<(Self, f64), Failure> {
        let zeta = sampler.between(0.01, 0.25);
        let omega = sampler.between(0.35, 1.9);
        let law = Self::random_law(sampler);
        Self::grazing(zeta, omega, law)
    }

    /// The oscillator at grazing with this law, and its grazing phase.
    pub(crate) fn grazing(zeta: f64, omega: f64, law: ResetLaw) -> Result<(Self, f64), Failure> {
        // The restitution of the base is not used.
        let state = grazing_theorems::LinearOscillator::new(zeta, 1.0)?.grazing(omega)?;
        let base = LinearOscillator::new(zeta, 1.0, state.amplitude(), omega)?;
        Ok((Self::new(base, law), state.phase()))
    }

    /// One with a law and a choice of the primary parameter without pattern, at its numerical grazing orbit.
    pub(crate) fn grazing_orbit(sampler: &mut Sampler) -> Result<GrazingOrbit<Self>, Failure> {
        let (specimen, phase) = Self::random(sampler)?;
        let specimen = if sampler.between(0.0, 1.0) < 0.5 { specimen } else { specimen.frequency_first() };
        Ok(GrazingOrbit::find(&specimen, phase)?)
    }

    fn order<T>(&self, [amplitude, frequency]: [T; 2]) -> [T; 2] {
        if self.frequency_first { [frequency, amplitude] } else { [amplitude, frequency] }
    }
}

impl ImpactOscillator for Specimen {
    type Motion = LinearMotion;

    fn parameters(&self) -> [f64; 2] {
        self.order(self.base.parameters())
    }

    fn with_parameters(&self, parameters: [f64; 2]) -> Self {
        // The exchange is its own inverse.
        Self { base: self.base.with_parameters(self.order(parameters)), ..*self }
    }

    fn forcing_frequency(&self) -> ParameterJet {
        let gradient = Vector2::from(self.order([0.0, 1.0]));
        ParameterJet { value: self.base.frequency(), gradient, hessian: Matrix2::zeros() }
    }

    fn acceleration(&self, state: State) -> f64 {
        self.base.acceleration(state)
    }

    fn flow<const ORDER: usize>(&self, from: State, duration: f64) -> FlowJet {
        let mut jet = self.base.flow::<ORDER>(from, duration);
        if self.frequency_first {
            jet.jacobian.swap_columns(PRIMARY, SECONDARY);
            for hessian in &mut jet.hessians {
                hessian.swap_columns(PRIMARY, SECONDARY);
                hessian.swap_rows(PRIMARY, SECONDARY);
            }
        }
        jet
    }

    fn reset<const ORDER: usize>(&self, velocity: f64, phase: f64) -> MapJet {
        let frequency = self.base.frequency();
        let [restitution, delay] = self.law.factors(velocity, phase, frequency);
        let mut jet = MapJet::identity(Vector2::new(-velocity * restitution, phase + velocity * delay));
        let (sin, cos) = libm::sincos(phase);
        let (sin_y, cos_y) = libm::sincos(velocity);
        let omega = if self.frequency_first { 2 } else { 3 };
        // Both components are a constant times y times a factor: −yΦ, yΨ.
        for (i, sign, [_, c1, c2, c3], factor) in
            [(0, -1.0, self.law.restitution, restitution), (1, 1.0, self.law.delay, delay)]
        {
            jet.jacobian[(i, 0)] = sign * (factor + velocity * c1 * cos_y);
            jet.jacobian[(i, 1)] = sign * velocity * c2 * cos + if i == 1 { 1.0 } else { 0.0 };
            jet.jacobian[(i, omega)] = sign * velocity * c3;
            let hessian = &mut jet.hessians[i];
            let mut set = |a: usize, b: usize, entry: f64| {
                hessian[(a, b)] = sign * entry;
                hessian[(b, a)] = sign * entry;
            };
            set(0, 0, c1 * (2.0 * cos_y - velocity * sin_y));
            set(0, 1, c2 * cos);
            set(0, omega, c3);
            set(1, 1, -velocity * c2 * sin);
        }
        jet
    }

    fn motion(&self, from: State) -> LinearMotion {
        self.base.motion(from)
    }
}
