//! What is to be proved: constants and window, as the decimal numbers that were written.

use core::fmt;

use crate::ball::Ball;
use crate::orbit::Oscillator;

/// Greatest width of the tubes around grazing curves, in amplitude: 10^-`WIDTH_PLACES`.
pub const WIDTH_PLACES: u32 = 6;

/// A decimal number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Decimal {
    digits: i64,
    places: u32,
}

impl Decimal {
    /// The shortest decimal number that is read as this one; nothing if it has more digits than an
    /// integer of 63 bits, or is not finite.
    pub fn new(x: f64) -> Option<Self> {
        let text = format!("{x}");
        let places = text.split_once('.').map_or(0, |(_, places)| places.len());
        (places <= 18).then_some(Self { digits: text.replace('.', "").parse().ok()?, places: places as u32 })
    }

    /// The number.
    pub fn ball(self) -> Ball {
        Ball::ratio(self.digits, 10_i64.pow(self.places))
    }
}

impl fmt::Display for Decimal {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sign = if self.digits < 0 { "-" } else { "" };
        let (scale, digits) = (10_u64.pow(self.places), self.digits.unsigned_abs());
        write!(formatter, "{sign}{}", digits / scale)?;
        let places = self.places as usize;
        if places > 0 { write!(formatter, ".{:0places$}", digits % scale) } else { Ok(()) }
    }
}

/// What is to be proved.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Statement {
    /// The damping ratio.
    pub zeta: Decimal,
    /// The coefficient of restitution.
    pub epsilon: Decimal,
    /// The frequencies of the window.
    pub frequency: [Decimal; 2],
    /// Its greatest amplitude.
    pub amplitude: Decimal,
    /// The numbers of loops.
    pub loops: Vec<u32>,
}

impl Statement {
    /// Greatest width of a tube, in amplitude.
    pub fn width(&self) -> Ball {
        Ball::ratio(1, 10_i64.pow(WIDTH_PLACES))
    }

    /// The oscillator; nothing if it is not under-damped, or its restitution not positive.
    pub fn oscillator(&self) -> Option<Oscillator> {
        Oscillator::new(self.zeta.ball(), self.epsilon.ball())
    }
}
