//! Oscillators of the general class without pattern: a reset law that varies, and either parameter as the primary one.

use grazing_model::flow_variable::{PRIMARY, SECONDARY};
use grazing_model::{FlowJet, ImpactOscillator, LinearMotion, MapJet, ParameterJet, State};
use grazing_theorems::from_map::GrazingOrbit;
use nalgebra::Vector2;

use crate::sampling::Sampler;
use crate::specimen::{Exponential, VaryingReset};

type Failure = Box<dyn core::error::Error + Send + Sync>;

/// Φ and Ψ.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ResetLaw {
    restitution: Exponential,
    delay: Exponential,
}

/// An impact oscillator whose impacts take time.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Specimen {
    base: VaryingReset,
    /// The frequency is the primary parameter, the amplitude the secondary one, so that ω depends on μ.
    frequency_first: bool,
}

impl Specimen {
    /// The same oscillator with the frequency as its primary parameter.
    pub(crate) fn frequency_first(self) -> Self {
        Self { frequency_first: true, ..self }
    }

    /// A reset law with Φ between 0 and 1 and Ψ of either sign, for velocities y ≥ 0, amplitudes and frequencies up to 3.
    pub(crate) fn random_law(sampler: &mut Sampler) -> ResetLaw {
        let mut rates = || {
            [
                sampler.between(-0.4, -0.05),
                sampler.between(-0.15, 0.15),
                sampler.between(-0.05, 0.05),
                sampler.between(-0.05, 0.05),
            ]
        };
        let (restitution, delay) = (rates(), rates());
        let sign = sampler.one_of(&[1.0, -1.0]);
        ResetLaw {
            restitution: Exponential { size: sampler.between(0.4, 0.6), rates: restitution },
            delay: Exponential { size: sign * sampler.between(0.05, 0.25), rates: delay },
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
        let ResetLaw { restitution, delay } = law;
        let state = grazing_theorems::LinearOscillator::new(zeta, restitution.size)?.grazing(omega)?;
        let base = VaryingReset::new(zeta, restitution, delay, [state.amplitude(), omega])?;
        Ok((Self { base, frequency_first: false }, state.phase()))
    }

    /// One at its numerical grazing orbit, half of them with the frequency as the primary parameter.
    pub(crate) fn grazing_orbit(sampler: &mut Sampler) -> Result<GrazingOrbit<Self>, Failure> {
        let (specimen, phase) = Self::random(sampler)?;
        let specimen = if sampler.one_of(&[true, false]) { specimen } else { specimen.frequency_first() };
        Ok(GrazingOrbit::find(&specimen, phase)?)
    }

    /// Φ and Ψ at an impact.
    pub(crate) fn factors(&self, velocity: f64, phase: f64) -> [f64; 2] {
        let [amplitude, frequency] = self.base.parameters();
        let arguments = [velocity, libm::sin(phase), amplitude, frequency];
        [self.base.restitution, self.base.delay].map(|Exponential { size, rates }| {
            let exponent: f64 = rates.iter().zip(arguments).map(|(rate, argument)| rate * argument).sum();
            size * libm::exp(exponent)
        })
    }

    /// (amplitude, frequency) in the order of the parameters, or back: the exchange is its own inverse.
    fn order<T>(&self, [first, second]: [T; 2]) -> [T; 2] {
        if self.frequency_first { [second, first] } else { [first, second] }
    }
}

impl ImpactOscillator for Specimen {
    type Motion = LinearMotion;

    fn parameters(&self) -> [f64; 2] {
        self.order(self.base.parameters())
    }

    fn with_parameters(&self, parameters: [f64; 2]) -> Self {
        Self { base: self.base.with_parameters(self.order(parameters)), ..*self }
    }

    fn forcing_frequency(&self) -> ParameterJet {
        let mut jet = self.base.forcing_frequency();
        jet.gradient = Vector2::from(self.order(jet.gradient.into()));
        jet
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
        let mut jet = self.base.reset::<ORDER>(velocity, phase);
        if self.frequency_first {
            jet.jacobian.swap_columns(2, 3);
            for hessian in &mut jet.hessians {
                hessian.swap_columns(2, 3);
                hessian.swap_rows(2, 3);
            }
        }
        jet
    }

    fn motion(&self, from: State) -> LinearMotion {
        self.base.motion(from)
    }
}
