//! The periodic response to forcing, and strides along a motion: complex numbers that rotate.

use nalgebra::Vector2;

/// The periodic response to forcing of unit amplitude as a function of phase and frequency.
///
/// With H = 1/(1 − ω² + 2iζω) the position is Re(H e^{iz}) and the velocity Re(iωH e^{iz}); stored
/// are these two complex numbers and their first two derivatives in ω, so that an evaluation costs
/// one sine and one cosine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Response {
    /// `re[k][i] + i·im[k][i]` is the k-th derivative in ω of the coefficient of component i.
    pub(super) re: [Vector2<f64>; 3],
    pub(super) im: [Vector2<f64>; 3],
}

/// Value and derivatives of the unit response (position, velocity) at one phase.
#[derive(Clone, Copy, Debug)]
pub(super) struct ResponseJet {
    pub(super) value: Vector2<f64>,
    pub(super) d_phase: Vector2<f64>,
    pub(super) d_frequency: Vector2<f64>,
    pub(super) d_phase_frequency: Vector2<f64>,
    pub(super) d_frequency_frequency: Vector2<f64>,
}

impl Response {
    pub(super) fn new(damping_ratio: f64, frequency: f64) -> Self {
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

    #[inline]
    pub(super) fn at(&self, phase: f64) -> ResponseJet {
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

/// The product of two complex numbers.
#[inline]
pub(super) fn multiply(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]]
}

/// A stride of the walk along a motion; computed once per oscillator.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Stride {
    pub(super) length: f64,
    /// The factors e^{(−ζ+iω₁)h} and e^{iωh}.
    pub(super) turn: [[f64; 2]; 2],
}

impl Stride {
    /// An eighth of the shorter of the two periods keeps the undecided cells few (empirical; any
    /// length finds the same events).
    pub(super) fn new(damping_ratio: f64, natural_frequency: f64, frequency: f64) -> Self {
        let length = core::f64::consts::TAU / (8.0 * frequency.max(natural_frequency));
        let decay = libm::exp(-damping_ratio * length);
        let (sin, cos) = libm::sincos(natural_frequency * length);
        let (forced_sin, forced_cos) = libm::sincos(frequency * length);
        Self { length, turn: [[decay * cos, decay * sin], [forced_cos, forced_sin]] }
    }
}
