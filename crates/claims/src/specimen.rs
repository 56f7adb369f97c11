//! Oscillators to measure on: the linear one of the paper, and one whose reset law varies.
//!
//! The paper's oscillator has Φ = ε and Ψ = 0, so that α = 1 + ε: much of sections 4 and 5 is not seen by it. The class of
//! section 2.1 allows Φ and Ψ to depend on the velocity and the phase of the impact and on both parameters, and that is what
//! [`VaryingReset`] does.

use grazing_model::{
    FlowJet, ImpactOscillator, LinearMotion, LinearOscillator, MapJet, OscillatorError, ParameterJet, State,
};
use grazing_theorems::from_map::{GrazingOrbit, GrazingOrbitError};
use nalgebra::{Vector2, Vector4};
use thiserror::Error;

/// A function of an impact's velocity and phase and of the parameters that never changes its sign:
/// `size · exp(rates · (y, sin z, μ, η))`.
///
/// All dimensionless. Its derivatives of all orders are other than zero, unless a rate is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exponential {
    /// The factor in front, with the sign.
    pub size: f64,
    /// The coefficients of y, sin z, μ and η in the exponent.
    pub rates: [f64; 4],
}

impl Exponential {
    /// The value, the gradient and the entry of the matrix of second derivatives at (y, z; μ, η).
    fn jet(&self, [velocity, phase, primary, secondary]: [f64; 4]) -> Jet {
        let [by_velocity, by_sine, by_primary, by_secondary] = self.rates;
        let (sine, cosine) = libm::sincos(phase);
        let exponent =
            by_velocity * velocity + by_sine * sine + by_primary * primary + by_secondary * secondary;
        Jet {
            value: self.size * libm::exp(exponent),
            slope: Vector4::new(by_velocity, by_sine * cosine, by_primary, by_secondary),
            bend: -by_sine * sine,
        }
    }
}

/// An exponential at one point: its value, and the derivatives of its exponent, whose only second one is in z.
struct Jet {
    value: f64,
    slope: Vector4<f64>,
    bend: f64,
}

impl Jet {
    fn second(&self, a: usize, b: usize) -> f64 {
        let bend = if (a, b) == (1, 1) { self.bend } else { 0.0 };
        self.value * (self.slope[a] * self.slope[b] + bend)
    }
}

/// The linear oscillator with the reset law R = (−y Φ, z + y Ψ) in which Φ and Ψ vary.
///
/// Paper: eq:R. Φ is an [`Exponential`] of positive size, Ψ one of either sign; μ is the forcing amplitude 𝒜 and η the
/// forcing frequency ω, as for [`LinearOscillator`], whose own coefficient of restitution plays no part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VaryingReset {
    linear: LinearOscillator,
    /// Φ, whose size is positive.
    pub restitution: Exponential,
    /// Ψ.
    pub delay: Exponential,
}

impl VaryingReset {
    /// The oscillator with a damping ratio, a forcing amplitude and a forcing frequency, and this reset law.
    ///
    /// # Errors
    /// Parameters outside the domain of [`LinearOscillator::new`]; a size of Φ that is not positive.
    pub fn new(
        damping_ratio: f64,
        restitution: Exponential,
        delay: Exponential,
        [amplitude, frequency]: [f64; 2],
    ) -> Result<Self, OscillatorError> {
        let linear = LinearOscillator::new(damping_ratio, restitution.size, amplitude, frequency)?;
        Ok(Self { linear, restitution, delay })
    }

    /// The linear oscillator that moves between the impacts.
    pub fn linear(&self) -> &LinearOscillator {
        &self.linear
    }
}

impl ImpactOscillator for VaryingReset {
    type Motion = LinearMotion;

    fn parameters(&self) -> [f64; 2] {
        self.linear.parameters()
    }

    fn with_parameters(&self, parameters: [f64; 2]) -> Self {
        Self { linear: self.linear.with_parameters(parameters), ..*self }
    }

    fn forcing_frequency(&self) -> ParameterJet {
        self.linear.forcing_frequency()
    }

    fn acceleration(&self, state: State) -> f64 {
        self.linear.acceleration(state)
    }

    fn flow<const ORDER: usize>(&self, from: State, duration: f64) -> FlowJet {
        self.linear.flow::<ORDER>(from, duration)
    }

    fn reset<const ORDER: usize>(&self, velocity: f64, phase: f64) -> MapJet {
        let [primary, secondary] = self.parameters();
        let point = [velocity, phase, primary, secondary];
        let factors = [self.restitution.jet(point), self.delay.jet(point)];
        let mut jet =
            MapJet::identity(Vector2::new(-velocity * factors[0].value, phase + velocity * factors[1].value));
        jet.jacobian[(0, 0)] = 0.0;
        for (i, (factor, sign)) in factors.iter().zip([-1.0, 1.0]).enumerate() {
            // y Φ: the product rule, with y the first variable.
            let first = |a: usize| factor.value * factor.slope[a];
            for a in 0..4 {
                let own = if a == 0 { factor.value } else { 0.0 };
                jet.jacobian[(i, a)] += sign * (own + velocity * first(a));
                if ORDER >= 2 {
                    for b in 0..4 {
                        let mixed = if a == 0 { first(b) } else { 0.0 } + if b == 0 { first(a) } else { 0.0 };
                        jet.hessians[i][(a, b)] = sign * (mixed + velocity * factor.second(a, b));
                    }
                }
            }
        }
        jet
    }

    fn motion(&self, from: State) -> LinearMotion {
        self.linear.motion(from)
    }
}

/// A specimen could not be made.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum SpecimenError {
    /// The theory's oscillator does not exist there.
    #[error(transparent)]
    Theory(#[from] grazing_theorems::TheoryError),
    /// The model's oscillator does not exist there.
    #[error(transparent)]
    Oscillator(#[from] OscillatorError),
    /// Its grazing orbit was not found.
    #[error(transparent)]
    Orbit(#[from] GrazingOrbitError),
}

/// The linear oscillator with (ζ, ε, ω) at its grazing bifurcation.
///
/// # Errors
/// [`SpecimenError`].
pub fn linear_at_grazing(
    damping_ratio: f64,
    restitution: f64,
    frequency: f64,
) -> Result<GrazingOrbit<LinearOscillator>, SpecimenError> {
    let grazing = grazing_theorems::LinearOscillator::new(damping_ratio, restitution)?.grazing(frequency)?;
    let oscillator = LinearOscillator::new(damping_ratio, restitution, grazing.amplitude(), frequency)?;
    Ok(GrazingOrbit::find(&oscillator, grazing.phase())?)
}

/// The oscillator with damping ratio ζ and this reset law at its grazing bifurcation at the forcing frequency ω: the grazing
/// orbit is that of the linear oscillator, and so are P_global and the resonances.
///
/// # Errors
/// [`SpecimenError`].
pub fn varying_at_grazing(
    damping_ratio: f64,
    restitution: Exponential,
    delay: Exponential,
    frequency: f64,
) -> Result<GrazingOrbit<VaryingReset>, SpecimenError> {
    let grazing =
        grazing_theorems::LinearOscillator::new(damping_ratio, restitution.size)?.grazing(frequency)?;
    let oscillator = VaryingReset::new(damping_ratio, restitution, delay, [grazing.amplitude(), frequency])?;
    Ok(GrazingOrbit::find(&oscillator, grazing.phase())?)
}

/// A reset law without pattern: every derivative of Φ and Ψ is other than zero, and α > 0.
pub const RESTITUTION: Exponential = Exponential { size: 0.7, rates: [-0.4, 0.3, -0.2, 0.15] };
/// The Ψ that goes with [`RESTITUTION`].
pub const DELAY: Exponential = Exponential { size: 0.25, rates: [0.5, -0.35, 0.2, 0.3] };

#[cfg(test)]
mod tests {
    use super::*;

    fn specimen() -> VaryingReset {
        VaryingReset::new(0.05, RESTITUTION, DELAY, [0.9, 0.8]).unwrap()
    }

    #[test]
    fn derivatives_of_the_reset_law_are_limits_of_differences() {
        let point = [0.3, -0.7, 0.9, 0.8];
        let step = 1e-5;
        let at = |[velocity, phase, primary, secondary]: [f64; 4]| {
            specimen().with_parameters([primary, secondary]).reset::<2>(velocity, phase)
        };
        let jet = at(point);
        for a in 0..4 {
            let shifted = |sign: f64| {
                let mut moved = point;
                moved[a] += sign * step;
                at(moved)
            };
            let (ahead, behind) = (shifted(1.0), shifted(-1.0));
            let slope = (ahead.value - behind.value) / (2.0 * step);
            // Central differences: the step squared, and rounding over the step.
            assert!((slope - jet.jacobian.column(a)).amax() < 1e-9, "variable {a}");
            let bend = (ahead.jacobian - behind.jacobian) / (2.0 * step);
            for i in 0..2 {
                let difference = (bend.row(i) - jet.hessians[i].row(a)).amax();
                assert!(difference < 1e-9, "component {i}, variable {a}: {difference}");
            }
        }
    }

    #[test]
    fn impacts_recoil_and_the_tangency_set_stays() {
        let specimen = specimen();
        for phase in [-2.0, 0.1, 1.7] {
            assert_eq!(specimen.reset::<1>(0.0, phase).value, Vector2::new(0.0, phase));
            for velocity in [1e-6, 0.1, 3.0] {
                assert!(specimen.reset::<1>(velocity, phase).value[0] < 0.0);
            }
        }
    }

    #[test]
    fn the_square_root_factor_sees_the_delay() {
        let point = varying_at_grazing(0.05, RESTITUTION, DELAY, 0.8).unwrap().grazing_point();
        assert!(point.alpha() > 0.0 && point.psi > 0.1);
        assert!((point.alpha() - 1.0 - point.phi).abs() > 0.05);
    }

    #[test]
    fn without_variation_it_is_the_linear_oscillator() {
        let still = |size| Exponential { size, rates: [0.0; 4] };
        let plain = VaryingReset::new(0.05, still(0.8), still(0.0), [0.9, 0.8]).unwrap();
        let linear = LinearOscillator::new(0.05, 0.8, 0.9, 0.8).unwrap();
        assert_eq!(plain.reset::<2>(0.4, 1.0), linear.reset::<2>(0.4, 1.0));
        assert_eq!(plain.linear(), &linear);
    }
}
