//! Numbers with twice the digits of `f64`, as unevaluated sums of two.

use core::ops::{Add, Div, Mul, Neg, Sub};

/// The number high + low, where |low| is at most half a unit in the last place of high.
#[derive(Clone, Copy, Debug)]
pub(super) struct Double {
    high: f64,
    low: f64,
}

impl Double {
    pub(super) const TAU: Self = Self { high: core::f64::consts::TAU, low: 2.449_293_598_294_706_4e-16 };

    /// The sum of a number and a smaller one.
    fn renormalised(high: f64, low: f64) -> Self {
        let sum = high + low;
        Self { high: sum, low: low - (sum - high) }
    }

    pub(super) fn sqrt(self) -> Self {
        let near = Self::from(libm::sqrt(self.high));
        // A step of Newton's method doubles the digits.
        near + (self - near * near) / (near + near)
    }

    /// The exponential e^x, by Taylor's series for x/2¹⁰.
    pub(super) fn exp(self) -> Self {
        let mut power = (self.halved(10)).series(1.0, |k| k);
        for _ in 0..10 {
            power = power * power;
        }
        power
    }

    /// The sine and cosine of x, by Taylor's series for x/2¹⁰: 1 − cos is doubled, which keeps its
    /// digits.
    pub(super) fn sin_cos(self) -> (Self, Self) {
        let one = Self::from(1.0);
        let turns = libm::round(self.high / Self::TAU.high);
        let small = (self - Self::TAU * turns.into()).halved(10);
        let square = -(small * small);
        let mut sine = small * square.series(1.0, |k| 2.0 * k * (2.0 * k + 1.0));
        let mut less = one - square.series(1.0, |k| (2.0 * k - 1.0) * 2.0 * k);
        for _ in 0..10 {
            // sin 2x = 2 sin x cos x, 1 − cos 2x = 2 sin² x.
            let cosine = one - less;
            (sine, less) = ((sine * cosine) * 2.0.into(), sine * sine * 2.0.into());
        }
        (sine, one - less)
    }

    fn halved(self, times: i32) -> Self {
        Self { high: libm::ldexp(self.high, -times), low: libm::ldexp(self.low, -times) }
    }

    /// The sum of terms, the k-th of which is the previous one times x over `divisor`(k).
    fn series(self, first: f64, divisor: impl Fn(f64) -> f64) -> Self {
        let (mut term, mut sum) = (Self::from(first), Self::from(first));
        for k in 1..20 {
            term = term * self / divisor(f64::from(k)).into();
            sum = sum + term;
        }
        sum
    }
}

impl From<f64> for Double {
    fn from(high: f64) -> Self {
        Self { high, low: 0.0 }
    }
}

impl From<Double> for f64 {
    fn from(double: Double) -> Self {
        double.high
    }
}

impl Add for Double {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let sum = self.high + other.high;
        let part = sum - self.high;
        let lost = (self.high - (sum - part)) + (other.high - part);
        Self::renormalised(sum, lost + self.low + other.low)
    }
}

impl Neg for Double {
    type Output = Self;

    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

impl Sub for Double {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Double {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let product = self.high * other.high;
        let lost = libm::fma(self.high, other.high, -product);
        Self::renormalised(product, lost + (self.high * other.low + self.low * other.high))
    }
}

impl Div for Double {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let first = Self::from(self.high / other.high);
        let rest = self - first * other;
        first + Self::from(rest.high / other.high)
    }
}
