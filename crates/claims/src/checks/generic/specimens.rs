//! What section 4 is measured on: oscillators at grazing, and first-order data without an oscillator behind them.

use std::error::Error;

use grazing_model::{
    FlowJet, ImpactOscillator, LinearMotion, LinearOscillator, MapJet, OscillatorError, ParameterJet, State,
};
use grazing_theorems::from_map::GrazingOrbit;
use grazing_theorems::{GrazingPoint, LinearisedMap};
use nalgebra::{Matrix2, Matrix6, Vector2};

use crate::convergence::order;
use crate::sampling::Sampler;
use crate::specimen::{DELAY, Exponential, RESTITUTION, VaryingReset};

/// One of three members of the class of section 2.1, under one type.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Specimen {
    /// The oscillator of section 3, with μ the forcing amplitude.
    Linear(LinearOscillator),
    /// The same with a reset law that varies.
    Varying(VaryingReset),
    /// This one with the roles of the parameters exchanged: μ is the forcing frequency, and ω varies with μ.
    FrequencyFirst(VaryingReset),
}

impl ImpactOscillator for Specimen {
    type Motion = LinearMotion;

    fn parameters(&self) -> [f64; 2] {
        match self {
            Self::Linear(oscillator) => oscillator.parameters(),
            Self::Varying(oscillator) => oscillator.parameters(),
            Self::FrequencyFirst(oscillator) => {
                let [amplitude, frequency] = oscillator.parameters();
                [frequency, amplitude]
            }
        }
    }

    fn with_parameters(&self, [primary, secondary]: [f64; 2]) -> Self {
        match self {
            Self::Linear(oscillator) => Self::Linear(oscillator.with_parameters([primary, secondary])),
            Self::Varying(oscillator) => Self::Varying(oscillator.with_parameters([primary, secondary])),
            Self::FrequencyFirst(oscillator) => {
                Self::FrequencyFirst(oscillator.with_parameters([secondary, primary]))
            }
        }
    }

    fn forcing_frequency(&self) -> ParameterJet {
        match self {
            Self::Linear(oscillator) => oscillator.forcing_frequency(),
            Self::Varying(oscillator) => oscillator.forcing_frequency(),
            Self::FrequencyFirst(oscillator) => {
                let mut jet = oscillator.forcing_frequency();
                jet.gradient.swap_rows(0, 1);
                jet.hessian.swap_rows(0, 1);
                jet.hessian.swap_columns(0, 1);
                jet
            }
        }
    }

    fn acceleration(&self, state: State) -> f64 {
        match self {
            Self::Linear(oscillator) => oscillator.acceleration(state),
            Self::Varying(oscillator) | Self::FrequencyFirst(oscillator) => oscillator.acceleration(state),
        }
    }

    fn flow<const ORDER: usize>(&self, from: State, duration: f64) -> FlowJet {
        match self {
            Self::Linear(oscillator) => oscillator.flow::<ORDER>(from, duration),
            Self::Varying(oscillator) => oscillator.flow::<ORDER>(from, duration),
            Self::FrequencyFirst(oscillator) => {
                let mut jet = oscillator.flow::<ORDER>(from, duration);
                jet.jacobian.swap_columns(4, 5);
                let exchange = |hessian: &mut Matrix6<f64>| {
                    hessian.swap_rows(4, 5);
                    hessian.swap_columns(4, 5);
                };
                jet.hessians.iter_mut().for_each(exchange);
                jet
            }
        }
    }

    fn reset<const ORDER: usize>(&self, velocity: f64, phase: f64) -> MapJet {
        match self {
            Self::Linear(oscillator) => oscillator.reset::<ORDER>(velocity, phase),
            Self::Varying(oscillator) => oscillator.reset::<ORDER>(velocity, phase),
            Self::FrequencyFirst(oscillator) => {
                let mut jet = oscillator.reset::<ORDER>(velocity, phase);
                jet.jacobian.swap_columns(2, 3);
                for hessian in &mut jet.hessians {
                    hessian.swap_rows(2, 3);
                    hessian.swap_columns(2, 3);
                }
                jet
            }
        }
    }

    fn motion(&self, from: State) -> LinearMotion {
        match self {
            Self::Linear(oscillator) => oscillator.motion(from),
            Self::Varying(oscillator) | Self::FrequencyFirst(oscillator) => oscillator.motion(from),
        }
    }
}

/// Why something could not be computed.
pub(crate) type Failure = Box<dyn Error + Send + Sync>;

/// A specimen at grazing.
pub(crate) type Grazing = GrazingOrbit<Specimen>;

/// The linear oscillator with (ζ, ε, ω) at grazing.
fn linear(zeta: f64, epsilon: f64, omega: f64) -> Result<Grazing, Failure> {
    let grazing = grazing_theorems::LinearOscillator::new(zeta, epsilon)?.grazing(omega)?;
    let oscillator = LinearOscillator::new(zeta, epsilon, grazing.amplitude(), omega)?;
    Ok(GrazingOrbit::find(&Specimen::Linear(oscillator), grazing.phase())?)
}

/// The oscillator with a varying reset law at grazing.
fn varying(
    zeta: f64,
    omega: f64,
    delay: Exponential,
    kind: fn(VaryingReset) -> Specimen,
) -> Result<Grazing, Failure> {
    let grazing = grazing_theorems::LinearOscillator::new(zeta, RESTITUTION.size)?.grazing(omega)?;
    let oscillator: Result<_, OscillatorError> =
        VaryingReset::new(zeta, RESTITUTION, delay, [grazing.amplitude(), omega]);
    Ok(GrazingOrbit::find(&kind(oscillator?), grazing.phase())?)
}

/// The specimens at grazing: three of each kind. α > 0 for all, a₁₂ > 0 for six and a₁₂ < 0 for three of them, and no p ≤ 4 is
/// near its resonance: |S_p| > 0.1 r^(p−1).
pub(crate) fn specimens() -> Result<Vec<Grazing>, Failure> {
    Ok(vec![
        linear(0.1, 0.8, 0.83)?,
        linear(0.03, 0.9, 0.87)?,
        linear(0.2, 0.5, 1.7)?,
        varying(0.05, 0.84, DELAY, Specimen::Varying)?,
        varying(0.12, 1.4, DELAY, Specimen::Varying)?,
        varying(0.02, 0.9, DELAY, Specimen::Varying)?,
        varying(0.08, 0.78, DELAY, Specimen::FrequencyFirst)?,
        varying(0.06, 0.9, DELAY, Specimen::FrequencyFirst)?,
        varying(0.1, 1.3, DELAY, Specimen::FrequencyFirst)?,
    ])
}

/// Specimens with Ψ so large that α < 0.
pub(crate) fn delayed() -> Result<Vec<Grazing>, Failure> {
    let delay = Exponential { size: 6.0, ..DELAY };
    Ok(vec![varying(0.05, 0.8, delay, Specimen::Varying)?, varying(0.12, 1.4, delay, Specimen::Varying)?])
}

/// First-order data of a global map with (τ, δ) in the trapesium and entries of order one; a₁₂ of either sign.
pub(crate) fn sampled_map(sampler: &mut Sampler) -> LinearisedMap {
    let (tau, delta) = sampler.trapesium();
    map_with(sampler, tau, delta)
}

/// First-order data of a global map with this trace and determinant.
pub(crate) fn map_with(sampler: &mut Sampler, tau: f64, delta: f64) -> LinearisedMap {
    let a11 = sampler.between(-1.5, 1.5);
    let a12 = sampler.between(0.2, 2.0) * sampler.one_of(&[-1.0, 1.0]);
    let a22 = tau - a11;
    LinearisedMap {
        a: Matrix2::new(a11, a12, (a11 * a22 - delta) / a12, a22),
        b: Vector2::new(sampler.between(-1.0, 1.0), sampler.between(-1.0, 1.0)),
    }
}

/// First-order data of a grazing point with this map; Ψ of either sign, so small that α > 0.
pub(crate) fn sampled_point(sampler: &mut Sampler, map: LinearisedMap) -> GrazingPoint {
    let forcing_frequency = sampler.between(0.2, 3.0);
    let gamma = sampler.between(0.2, 3.0);
    GrazingPoint {
        map,
        forcing_frequency,
        gamma,
        phi: sampler.between(0.1, 1.0),
        psi: sampler.between(-1.0, 1.0) * forcing_frequency / gamma,
    }
}

/// Directions in (y, z − z_graz, μ), or in more variables: without pattern, and along the axes.
pub(crate) fn directions<const N: usize>(sampler: &mut Sampler, number: usize) -> Vec<[f64; N]> {
    let axes = (0..N).map(|axis| core::array::from_fn(|i| f64::from(u8::from(i == axis))));
    let others: Vec<[f64; N]> =
        (0..number).map(|_| core::array::from_fn(|_| sampler.between(-1.0, 1.0))).collect();
    axes.chain(others).collect()
}

/// The order of a remainder that is bounded in all directions at once: of the largest in any of them at each size. Not a number
/// if the remainder does not exist near grazing.
pub(crate) fn uniform_order<const N: usize>(
    directions: &[[f64; N]],
    remainder: impl Fn([f64; N], f64) -> Option<(f64, f64)>,
) -> f64 {
    let largest = |h: f64| {
        let mut largest = (0.0_f64, 0.0_f64);
        for direction in directions {
            let (value, rounding) = remainder(*direction, h)?;
            if value.is_nan() {
                return Some((value, rounding));
            }
            largest = (largest.0.max(value.abs()), largest.1.max(rounding));
        }
        Some(largest)
    };
    if largest(libm::ldexp(1.0, -14)).is_none() {
        return f64::NAN;
    }
    order(largest)
}
