//! The linear oscillator with the quantities that are computed once for it.

use super::response::{Response, Stride};
use crate::state::State;

/// A parameter of the oscillator lies outside its domain.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum OscillatorError {
    /// ζ must lie in (0, 1): the oscillator is under-damped.
    #[error("the damping ratio is {0}, and must lie strictly between 0 and 1")]
    DampingRatio(f64),
    /// ε must be positive and finite.
    #[error("the coefficient of restitution is {0}, and must be positive and finite")]
    Restitution(f64),
    /// ω must be positive and finite.
    #[error("the forcing frequency is {0}, and must be positive and finite")]
    Frequency(f64),
    /// 𝒜 must be finite.
    #[error("the forcing amplitude is {0}, and must be finite")]
    Amplitude(f64),
}

/// ẍ + 2ζẋ + x + 1 = 𝒜 cos(ωt) with a wall at x = 0 and the reset law y ↦ −εy.
///
/// Paper: eq:oscf, eq:oscResetLaw. As a member of the general class its primary parameter is the
/// forcing amplitude 𝒜 and its secondary parameter the forcing frequency ω; Φ = ε and Ψ = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinearOscillator {
    pub(super) damping_ratio: f64,
    pub(super) restitution: f64,
    pub(super) amplitude: f64,
    pub(super) frequency: f64,
    /// ω₁ = √(1 − ζ²).
    pub(super) natural_frequency: f64,
    pub(super) response: Response,
    pub(super) stride: Stride,
}

impl LinearOscillator {
    /// The oscillator with damping ratio ζ, coefficient of restitution ε, forcing amplitude 𝒜 and
    /// frequency ω.
    ///
    /// A wall that adds energy, ε > 1, is allowed: the class of systems requires only Φ > 0 (eq:R).
    ///
    /// # Errors
    /// ζ outside (0, 1), ε or ω not positive and finite, or 𝒜 not finite.
    pub fn new(
        damping_ratio: f64,
        restitution: f64,
        amplitude: f64,
        frequency: f64,
    ) -> Result<Self, OscillatorError> {
        if !(damping_ratio > 0.0 && damping_ratio < 1.0) {
            return Err(OscillatorError::DampingRatio(damping_ratio));
        }
        if !(restitution > 0.0 && restitution.is_finite()) {
            return Err(OscillatorError::Restitution(restitution));
        }
        if !(frequency > 0.0 && frequency.is_finite()) {
            return Err(OscillatorError::Frequency(frequency));
        }
        if !amplitude.is_finite() {
            return Err(OscillatorError::Amplitude(amplitude));
        }
        let natural_frequency = (1.0 - damping_ratio * damping_ratio).sqrt();
        Ok(Self {
            damping_ratio,
            restitution,
            amplitude,
            frequency,
            natural_frequency,
            response: Response::new(damping_ratio, frequency),
            stride: Stride::new(damping_ratio, natural_frequency, frequency),
        })
    }

    /// The damping ratio ζ.
    pub fn damping_ratio(&self) -> f64 {
        self.damping_ratio
    }

    /// The coefficient of restitution ε.
    pub fn restitution(&self) -> f64 {
        self.restitution
    }

    /// The forcing amplitude 𝒜.
    pub fn amplitude(&self) -> f64 {
        self.amplitude
    }

    /// The forcing frequency ω.
    pub fn frequency(&self) -> f64 {
        self.frequency
    }

    /// The damped natural frequency ω₁ = √(1 − ζ²).
    pub fn natural_frequency(&self) -> f64 {
        self.natural_frequency
    }

    /// Position and velocity of the non-impacting periodic solution φ_p at a phase.
    ///
    /// φ_p = −1 + 𝒜 ((1−ω²) cos z + 2ζω sin z) / ((1−ω²)² + 4ζ²ω²). Paper: eq:phip.
    pub fn non_impacting_solution(&self, phase: f64) -> State {
        let forced = self.response.at(phase);
        State {
            position: self.amplitude * forced.value[0] - 1.0,
            velocity: self.amplitude * forced.value[1],
            phase,
        }
    }
}
