//! Numbers in scientific notation.

use core::fmt::{self, Display, Formatter};

/// A number in scientific notation, as `-1.25e-9`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Scientific {
    /// The number without its power of ten: one digit, and the others after a point.
    pub mantissa: String,
    /// The power of ten; 0 for what is no finite number.
    pub exponent: i32,
}

impl Scientific {
    /// The number with as few digits as tell it from any other.
    pub fn of(value: f64) -> Self {
        Self::read(format!("{value:e}"))
    }

    /// The number rounded to so many significant digits, zeros among them.
    pub fn rounded(value: f64, digits: usize) -> Self {
        Self::read(format!("{value:.*e}", digits.saturating_sub(1)))
    }

    /// A number as the standard library writes it, which knows no other way to its digits.
    fn read(written: String) -> Self {
        match written.split_once('e') {
            Some((mantissa, exponent)) => {
                Self { mantissa: mantissa.to_owned(), exponent: exponent.parse().unwrap_or(0) }
            }
            None => Self { mantissa: written, exponent: 0 },
        }
    }
}

impl Display for Scientific {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> fmt::Result {
        write!(formatter, "{}e{}", self.mantissa, self.exponent)
    }
}
