//! Further number types for the closed forms: `f64` for searches, and functions on an interval.

use core::array::from_fn;
use core::ops::{Add, Mul, Neg, Sub};

use crate::ball::{Ball, Number};

impl From<Ball> for f64 {
    fn from(x: Ball) -> Self {
        x.to_f64()
    }
}

impl Number for f64 {
    fn inverse(self) -> Self {
        1.0 / self
    }

    fn exp(self) -> Self {
        libm::exp(self)
    }

    fn turn(self) -> (Self, Self) {
        // Whole turns are subtracted exactly, and quarter turns are exact.
        let rest = self - libm::rint(self);
        libm::sincos(2.0 * core::f64::consts::PI * rest)
    }
}

/// A function f, by its Taylor coefficients `f(x)`, `f'(x)`, `f''(x)/2` and `f'''(x)/6`: at one x, and
/// over a whole interval. By Taylor's theorem, the first three at one x and the last over the interval
/// bound f throughout it. The variable may itself be counted in a unit, so that derivatives are of the
/// size of what f changes by within that.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Series(pub [[Ball; 4]; 2]);

impl Series {
    /// The independent variable, which derivatives count in multiples of a unit.
    pub fn variable(at: Ball, over_all: Ball, unit: Ball) -> Self {
        Self([at, over_all].map(|x| [x, unit, Ball::ZERO, Ball::ZERO]))
    }

    fn constants(values: [Ball; 2]) -> Self {
        Self(values.map(|x| [x, Ball::ZERO, Ball::ZERO, Ball::ZERO]))
    }

    /// The composition with an outer function, which has these coefficients at the values of this
    /// function.
    fn composed(self, outer: [[Ball; 4]; 2]) -> Self {
        let rest = Self(self.0.map(|[_, first, second, third]| [Ball::ZERO, first, second, third]));
        let term = |k: usize| Self::constants(outer.map(|coefficients| coefficients[k]));
        (0..4).rev().fold(Ball::ZERO.into(), |sum, k| sum * rest + term(k))
    }
}

/// Taylor coefficients from a value and three derivatives.
fn taylor([value, first, second, third]: [Ball; 4]) -> [Ball; 4] {
    [value, first, Ball::ratio(1, 2) * second, Ball::ratio(1, 6) * third]
}

impl From<Ball> for Series {
    fn from(x: Ball) -> Self {
        Self::constants([x; 2])
    }
}

impl Neg for Series {
    type Output = Self;

    fn neg(self) -> Self {
        Self(self.0.map(|coefficients| coefficients.map(Ball::neg)))
    }
}

impl Add for Series {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self(from_fn(|i| from_fn(|k| self.0[i][k] + other.0[i][k])))
    }
}

impl Sub for Series {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Series {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let terms = |i: usize, n: usize| (0..=n).map(move |k| self.0[i][k] * other.0[i][n - k]);
        Self(from_fn(|i| from_fn(|n| terms(i, n).fold(Ball::ZERO, Ball::add))))
    }
}

impl Number for Series {
    fn inverse(self) -> Self {
        let first = Self::constants(self.0.map(|[x, ..]| x.inverse()));
        first * (self * first).composed([[Ball::ONE, -Ball::ONE, Ball::ONE, -Ball::ONE]; 2])
    }

    fn exp(self) -> Self {
        self.composed(self.0.map(|[x, ..]| taylor([x.exp(); 4])))
    }

    fn turn(self) -> (Self, Self) {
        let begin = self.0.map(|[x, ..]| x.turn());
        let angle = self * Self::from(Ball::PI + Ball::PI);
        (
            angle.composed(begin.map(|(sine, cosine)| taylor([sine, cosine, -sine, -cosine]))),
            angle.composed(begin.map(|(sine, cosine)| taylor([cosine, -sine, -cosine, sine]))),
        )
    }
}
