//! The harmonically forced linear oscillator, section 3 of the paper.

mod flow;
mod motion;
mod series;

pub use motion::LinearMotion;

use nalgebra::{Matrix2, Vector2};

use crate::jet::{FlowJet, MapJet, ParameterJet};
use crate::oscillator::{ImpactOscillator, State};

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
/// Paper: eq:oscf, eq:oscResetLaw. As a member of the general class its primary parameter is the forcing amplitude 𝒜 and
/// its secondary parameter the forcing frequency ω; Φ = ε and Ψ = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinearOscillator {
    damping_ratio: f64,
    restitution: f64,
    amplitude: f64,
    frequency: f64,
    /// ω₁ = √(1 − ζ²).
    natural_frequency: f64,
    response: Response,
    stride: motion::Stride,
}

impl LinearOscillator {
    /// The oscillator with damping ratio ζ, coefficient of restitution ε, forcing amplitude 𝒜 and frequency ω.
    ///
    /// A wall that returns more than it takes, ε > 1, is allowed: the class of systems asks for Φ > 0 only (eq:R).
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
            stride: motion::Stride::new(damping_ratio, natural_frequency, frequency),
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

impl ImpactOscillator for LinearOscillator {
    type Motion = LinearMotion;

    fn parameters(&self) -> [f64; 2] {
        [self.amplitude, self.frequency]
    }

    fn with_parameters(&self, [amplitude, frequency]: [f64; 2]) -> Self {
        if frequency == self.frequency {
            return Self { amplitude, ..*self };
        }
        Self {
            amplitude,
            frequency,
            response: Response::new(self.damping_ratio, frequency),
            stride: motion::Stride::new(self.damping_ratio, self.natural_frequency, frequency),
            ..*self
        }
    }

    fn forcing_frequency(&self) -> ParameterJet {
        ParameterJet { value: self.frequency, gradient: Vector2::new(0.0, 1.0), hessian: Matrix2::zeros() }
    }

    fn acceleration(&self, state: State) -> f64 {
        self.amplitude * libm::cos(state.phase)
            - 2.0 * self.damping_ratio * state.velocity
            - state.position
            - 1.0
    }

    fn flow<const ORDER: usize>(&self, from: State, duration: f64) -> FlowJet {
        flow::flow::<ORDER>(self, from, duration)
    }

    fn reset<const ORDER: usize>(&self, velocity: f64, phase: f64) -> MapJet {
        let mut jet = MapJet::identity(Vector2::new(-self.restitution * velocity, phase));
        jet.jacobian[(0, 0)] = -self.restitution;
        jet
    }

    fn motion(&self, from: State) -> LinearMotion {
        LinearMotion::new(self, from)
    }
}

/// The periodic response to forcing of unit amplitude as a function of phase and frequency.
///
/// With H = 1/(1 − ω² + 2iζω) the position is Re(H e^{iz}) and the velocity Re(iωH e^{iz}); stored are these two complex
/// numbers and their first two derivatives in ω, so that an evaluation costs one sine and one cosine.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Response {
    /// `re[k][i] + i·im[k][i]` is the k-th derivative in ω of the coefficient of component i.
    re: [Vector2<f64>; 3],
    im: [Vector2<f64>; 3],
}

/// Value and derivatives of the unit response (position, velocity) at one phase.
#[derive(Clone, Copy, Debug)]
struct ResponseJet {
    value: Vector2<f64>,
    d_phase: Vector2<f64>,
    d_frequency: Vector2<f64>,
    d_phase_frequency: Vector2<f64>,
    d_frequency_frequency: Vector2<f64>,
}

impl Response {
    fn new(damping_ratio: f64, frequency: f64) -> Self {
        let stiffness = 1.0 - frequency * frequency;
        let loss = 2.0 * damping_ratio * frequency;
        let modulus = stiffness * stiffness + loss * loss;
        let h = [stiffness / modulus, -loss / modulus];
        // H' = −(−2ω + 2iζ) H² and H'' = 2H² + 2 (2ω − 2iζ) H H'.
        let rate = [2.0 * frequency, -2.0 * damping_ratio];
        let h1 = multiply(rate, multiply(h, h));
        let square = multiply(h, h);
        let mixed = multiply(rate, multiply(h, h1));
        let h2 = [2.0 * (square[0] + mixed[0]), 2.0 * (square[1] + mixed[1])];
        // Velocity: iωH, iH + iωH', 2iH' + iωH''.
        let v = [-frequency * h[1], frequency * h[0]];
        let v1 = [-h[1] - frequency * h1[1], h[0] + frequency * h1[0]];
        let v2 = [-2.0 * h1[1] - frequency * h2[1], 2.0 * h1[0] + frequency * h2[0]];
        let pair = |position: [f64; 2], velocity: [f64; 2], part: usize| {
            Vector2::new(position[part], velocity[part])
        };
        Self {
            re: [pair(h, v, 0), pair(h1, v1, 0), pair(h2, v2, 0)],
            im: [pair(h, v, 1), pair(h1, v1, 1), pair(h2, v2, 1)],
        }
    }

    fn at(&self, phase: f64) -> ResponseJet {
        let (sin, cos) = libm::sincos(phase);
        let real = |k: usize| self.re[k] * cos - self.im[k] * sin;
        let minus_imaginary = |k: usize| -(self.re[k] * sin + self.im[k] * cos);
        ResponseJet {
            value: real(0),
            d_phase: minus_imaginary(0),
            d_frequency: real(1),
            d_phase_frequency: minus_imaginary(1),
            d_frequency_frequency: real(2),
        }
    }
}

fn multiply(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]]
}
