//! The statement to be proved: constants and window, as the decimal numbers that were written.

use core::fmt;

use crate::ball::Ball;
use crate::orbit::Oscillator;

/// Greatest width of the tubes around grazing curves, in amplitude: 10^-`WIDTH_PLACES`.
pub const WIDTH_PLACES: u32 = 6;

/// A number written with few decimal digits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Decimal(f64);

impl Decimal {
    /// The shortest decimal number that reads as `x`; nothing if it has more than 18 digits, or is not
    /// finite.
    pub fn new(x: f64) -> Option<Self> {
        (x.is_finite() && x.to_string().len() <= 19).then_some(Self(x))
    }

    /// The ball of the decimal number itself, rather than of its binary approximation.
    pub fn ball(self) -> Ball {
        let text = self.to_string();
        let places = text.split_once('.').map_or(0, |(_, places)| places.len());
        let digits = text.replace('.', "").parse();
        digits.map_or(Ball::ANY, |digits| Ball::ratio(digits, 10_i64.pow(places as u32)))
    }
}

impl fmt::Display for Decimal {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(formatter)
    }
}

/// The statement to be proved: constants, window and numbers of loops.
#[derive(Debug, Clone)]
pub struct Statement {
    /// The damping ratio.
    pub zeta: Decimal,
    /// The coefficient of restitution.
    pub epsilon: Decimal,
    /// The oscillator with these constants.
    pub oscillator: Oscillator,
    /// The least and the greatest frequency of the window.
    pub frequency: [Decimal; 2],
    /// The least and the greatest amplitude of the window.
    pub amplitude: [Decimal; 2],
    /// The numbers of loops, in increasing order.
    pub loops: Vec<u32>,
}

impl Statement {
    /// The statement for an oscillator in a window; nothing unless it is under-damped and 0 < ε ≤ 1.
    pub fn new(
        [zeta, epsilon]: [Decimal; 2],
        frequency: [Decimal; 2],
        amplitude: [Decimal; 2],
        mut loops: Vec<u32>,
    ) -> Option<Self> {
        let oscillator = Oscillator::new(zeta.ball(), epsilon.ball())?;
        loops.sort_unstable();
        Some(Self { zeta, epsilon, oscillator, frequency, amplitude, loops })
    }

    /// The greatest width of a tube, in amplitude.
    pub fn width() -> Ball {
        Ball::ratio(1, 10_i64.pow(WIDTH_PLACES))
    }
}
