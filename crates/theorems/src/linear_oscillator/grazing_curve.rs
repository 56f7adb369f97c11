//! The linear oscillator on its curve of grazing bifurcations, at any forcing frequency.

use core::f64::consts::PI;

use nalgebra::{Matrix2, Vector2};

use super::LinearOscillator;
use crate::error::TheoryError;
use crate::grazing::GrazingPoint;
use crate::spectrum::LinearisedMap;

/// The linear oscillator at the grazing bifurcation of its non-impacting periodic solution.
///
/// Computed by [`LinearOscillator::grazing`]. All quantities are non-dimensional.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GrazingState {
    oscillator: LinearOscillator,
    omega: f64,
}

impl GrazingState {
    pub(super) fn new(oscillator: LinearOscillator, omega: f64) -> Result<Self, TheoryError> {
        if !(0.0 < omega && omega.is_finite()) {
            return Err(TheoryError::ForcingFrequency { omega });
        }
        Ok(Self { oscillator, omega })
    }

    /// The oscillator.
    pub fn oscillator(&self) -> LinearOscillator {
        self.oscillator
    }

    /// The forcing frequency, omega, radians per unit of time.
    pub fn forcing_frequency(&self) -> f64 {
        self.omega
    }

    /// The forcing amplitude at which the non-impacting periodic solution grazes the wall.
    ///
    /// `A_graz = sqrt((1 - omega^2)^2 + 4 zeta^2 omega^2)`. Paper: section 3, eq. (5), `eq:Agraz`.
    pub fn amplitude(&self) -> f64 {
        libm::hypot(self.stiffness_deficit(), 2.0 * self.oscillator.zeta * self.omega)
    }

    /// The oscillator with the forcing amplitude and frequency at grazing, for simulation and
    /// continuation.
    ///
    /// This is the only conversion from this crate's oscillator, which has no forcing, to that of
    /// `grazing_model`, which has.
    ///
    /// # Panics
    /// The forcing amplitude is infinite, as it is beyond `omega = 1e154`.
    pub fn model(&self) -> grazing_model::LinearOscillator {
        let LinearOscillator { zeta, epsilon } = self.oscillator;
        let oscillator = grazing_model::LinearOscillator::new(zeta, epsilon, self.amplitude(), self.omega);
        oscillator.expect("both crates have the same domains of zeta, epsilon and omega")
    }

    /// The slope of the grazing curve in the `(omega, A)` plane.
    ///
    /// `d A_graz / d omega = 2 omega (omega^2 - 1 + 2 zeta^2) / A_graz`, from section 3, eq. (5),
    /// `eq:Agraz`.
    pub fn amplitude_derivative(&self) -> f64 {
        let zeta = self.oscillator.zeta;
        2.0 * self.omega * (2.0 * zeta * zeta - self.stiffness_deficit()) / self.amplitude()
    }

    /// The phase at which the non-impacting periodic solution grazes the wall, in (0, pi), radians.
    ///
    /// `sin(z_graz) = 2 zeta omega / A_graz`, `cos(z_graz) = (1 - omega^2) / A_graz`. Paper:
    /// section 3, eq. (6).
    pub fn phase(&self) -> f64 {
        libm::atan2(2.0 * self.oscillator.zeta * self.omega, self.stiffness_deficit())
    }

    /// How fast the grazing phase varies along the grazing curve.
    ///
    /// `d z_graz / d omega = 2 zeta (1 + omega^2) / A_graz^2`, from section 3, eq. (6).
    pub fn phase_derivative(&self) -> f64 {
        let amplitude = self.amplitude();
        2.0 * self.oscillator.zeta * (1.0 + self.omega * self.omega) / (amplitude * amplitude)
    }

    /// The decay over `p` forcing periods.
    ///
    /// `E_p = exp(-2 pi p zeta / omega) = delta^{p/2}`. Paper: section 3, eq. (14), `eq:Ep`.
    pub fn decay(&self, p: u32) -> f64 {
        libm::exp(-self.decay_exponent(p))
    }

    /// `1 - E_p` without cancellation. Paper: section 3, eq. (14), `eq:Ep`.
    pub fn decay_complement(&self, p: u32) -> f64 {
        -libm::expm1(-self.decay_exponent(p))
    }

    /// The global map at grazing, to first order, with `mu = A - A_graz(omega)`.
    ///
    /// `A = E_1 [cos + (zeta/omega_1) sin, (omega/omega_1) sin;
    ///           -sin / (omega_1 omega), cos - (zeta/omega_1) sin]`
    /// with the argument `2 pi omega_1 / omega`, and `b = (1 - a11, -a21) / A_graz`.
    /// Paper: section 3, eq. (9) and (10), `eq:oscA`, `eq:oscb` (proposition 3.1, `pr:oscAb`).
    pub fn linearised_map(&self) -> LinearisedMap {
        let omega_1 = self.oscillator.damped_natural_frequency();
        let (sine, cosine) = self.free_rotation(1);
        let skew = self.oscillator.zeta / omega_1 * sine;
        let a = Matrix2::new(
            cosine + skew,
            self.omega / omega_1 * sine,
            -sine / (omega_1 * self.omega),
            cosine - skew,
        ) * self.decay(1);
        LinearisedMap { a, b: Vector2::new(1.0 - a.m11, -a.m21) / self.amplitude() }
    }

    /// The trace of `A`.
    ///
    /// `tau = 2 exp(-2 pi zeta / omega) cos(2 pi omega_1 / omega)`. Paper: section 3, eq. (11),
    /// `eq:osctaudelta`.
    pub fn trace(&self) -> f64 {
        2.0 * self.decay(1) * self.free_rotation(1).1
    }

    /// The determinant of `A`.
    ///
    /// `delta = exp(-4 pi zeta / omega)`. Paper: section 3, eq. (11), `eq:osctaudelta`.
    pub fn determinant(&self) -> f64 {
        self.decay(2)
    }

    /// The transversality coefficient.
    ///
    /// `beta = (delta - tau + 1) / A_graz`. Paper: section 3.3, after eq. (11), `eq:osctaudelta`.
    /// Positive.
    pub fn transversality(&self) -> f64 {
        (self.determinant() - self.trace() + 1.0) / self.amplitude()
    }

    /// The quantities of the grazing point that enter the theorems.
    ///
    /// `phi = epsilon`, `psi = 0`, `gamma = omega^2`, so that `alpha = 1 + epsilon`. Paper: section
    /// 3, eq. (7) and (8), `eq:oscphipsigamma`, `eq:oscalpha`.
    pub fn grazing_point(&self) -> GrazingPoint {
        GrazingPoint {
            map: self.linearised_map(),
            forcing_frequency: self.omega,
            gamma: self.omega * self.omega,
            phi: self.oscillator.epsilon,
            psi: 0.0,
        }
    }

    /// The second derivative in the phase of the position after `p` returns.
    ///
    /// `xi_p = E_p^2 (cos - (zeta/omega_1) sin)^2 - E_p (cos - (3 zeta/omega_1) sin)` with the
    /// argument `2 pi p omega_1 / omega`. Paper: section B, eq. (6) and (10), `eq:xi1proof2`,
    /// `eq:xipproof2`.
    pub fn second_phase_derivative(&self, p: u32) -> f64 {
        let decay = self.decay(p);
        let (sine, cosine) = self.free_rotation(p);
        let skew = self.oscillator.zeta / self.oscillator.damped_natural_frequency() * sine;
        let entry = decay * (cosine - skew);
        entry * entry - decay * (cosine - 3.0 * skew)
    }

    /// The derivative of `a12` along the grazing curve.
    ///
    /// `d a12 / d omega = (E_1 / omega_1) ((1 + 2 pi zeta / omega) sin - (2 pi omega_1 / omega)
    /// cos)` with the argument `2 pi omega_1 / omega`, from section 3, eq. (9), `eq:oscA`. At a
    /// resonance with `p = 1` this is `a12'`.
    pub fn off_diagonal_derivative(&self) -> f64 {
        let omega_1 = self.oscillator.damped_natural_frequency();
        let (sine, cosine) = self.free_rotation(1);
        let radians = 2.0 * PI / self.omega;
        self.decay(1) / omega_1 * ((1.0 + radians * self.oscillator.zeta) * sine - radians * omega_1 * cosine)
    }

    /// The derivative of `kappa_p` along the grazing curve.
    ///
    /// `d kappa_p / d omega = (4 pi / omega^2) E_1 (zeta cos + omega_1 sin - zeta cos(pi / p))`
    /// with the argument `2 pi omega_1 / omega`. Paper: section B, before eq. (13), `eq:xipproof5`.
    /// At a resonance with this `p` it is `kappa_p'`.
    pub fn detuning_derivative(&self, p: u32) -> f64 {
        let LinearOscillator { zeta, .. } = self.oscillator;
        let (sine, cosine) = self.free_rotation(1);
        let bracket = zeta * (cosine - libm::cos(PI / f64::from(p)))
            + self.oscillator.damped_natural_frequency() * sine;
        4.0 * PI * self.decay(1) * bracket / (self.omega * self.omega)
    }

    /// `1 - omega^2`.
    fn stiffness_deficit(&self) -> f64 {
        (1.0 - self.omega) * (1.0 + self.omega)
    }

    /// `2 pi p zeta / omega`.
    fn decay_exponent(&self, p: u32) -> f64 {
        2.0 * PI * f64::from(p) * self.oscillator.zeta / self.omega
    }

    /// The sine and the cosine of `2 pi p omega_1 / omega`.
    fn free_rotation(&self, p: u32) -> (f64, f64) {
        libm::sincos(2.0 * PI * f64::from(p) * self.oscillator.damped_natural_frequency() / self.omega)
    }
}
