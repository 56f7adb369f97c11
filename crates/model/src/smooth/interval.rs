//! Intervals that hold the range of a function; bounds are right to rounding.

use core::f64::consts::{FRAC_PI_2, PI, TAU};
use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::scalar::{Function, Scalar, SeriesCoefficient, with_plain_numbers};

/// All numbers from `lower` to `upper`; with a bound that is NaN, nothing is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Interval {
    pub(super) lower: f64,
    pub(super) upper: f64,
}

/// The interval that excludes nothing.
const UNKNOWN: Interval = Interval { lower: f64::NEG_INFINITY, upper: f64::INFINITY };

impl Interval {
    pub(super) fn new(a: f64, b: f64) -> Self {
        if a.is_nan() || b.is_nan() {
            return UNKNOWN;
        }
        Self { lower: least(a, b), upper: greatest(a, b) }
    }

    /// The largest modulus.
    pub(super) fn modulus(&self) -> f64 {
        self.lower.abs().max(self.upper.abs())
    }

    pub(super) fn holds(&self, inner: &Self) -> bool {
        self.lower <= inner.lower && inner.upper <= self.upper
    }

    /// The smallest interval that holds both.
    pub(super) fn joined(&self, other: &Self) -> Self {
        Self { lower: self.lower.min(other.lower), upper: self.upper.max(other.upper) }
    }

    /// The interval grown by a share of its width, and by slightly more than rounding, as its width
    /// may be zero.
    pub(super) fn grown(&self, share: f64) -> Self {
        let by = share * (self.upper - self.lower) + 1e-12 * self.modulus();
        Self { lower: self.lower - by, upper: self.upper + by }
    }

    /// The range of a function that is monotone on the interval.
    fn monotone(self, function: impl Fn(f64) -> f64) -> Self {
        Self::new(function(self.lower), function(self.upper))
    }

    /// The range of the cosine.
    fn cosine(self) -> Self {
        let width = self.upper - self.lower;
        if width >= TAU || width.is_nan() {
            return Self { lower: -1.0, upper: 1.0 };
        }
        let ends = self.monotone(libm::cos);
        // A multiple of 2π, or an odd multiple of π, inside.
        let passes =
            |start: f64| libm::floor((self.upper - start) / TAU) >= libm::ceil((self.lower - start) / TAU);
        let upper = if passes(0.0) { 1.0 } else { ends.upper };
        let lower = if passes(PI) { -1.0 } else { ends.lower };
        Self { lower, upper }
    }
}

impl Add for Interval {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { lower: self.lower + other.lower, upper: self.upper + other.upper }
    }
}

impl Sub for Interval {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self { lower: self.lower - other.upper, upper: self.upper - other.lower }
    }
}

impl Neg for Interval {
    type Output = Self;

    fn neg(self) -> Self {
        Self { lower: -self.upper, upper: -self.lower }
    }
}

impl Mul for Interval {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        let (a, b) = (self.lower * other.lower, self.lower * other.upper);
        let (c, d) = (self.upper * other.lower, self.upper * other.upper);
        // This includes sums of infinities of both signs, about which nothing is known either.
        if (a + b + c + d).is_nan() {
            return UNKNOWN;
        }
        Self { lower: least(least(a, b), least(c, d)), upper: greatest(greatest(a, b), greatest(c, d)) }
    }
}

/// The lesser of two numbers that are not NaN: one instruction.
#[inline(always)]
fn least(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

/// The greater of two numbers that are not NaN: one instruction.
#[inline(always)]
fn greatest(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

impl Div for Interval {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        if other.lower <= 0.0 && other.upper >= 0.0 {
            return UNKNOWN;
        }
        self * Self::new(1.0 / other.lower, 1.0 / other.upper)
    }
}

with_plain_numbers!([] Interval);

impl Scalar for Interval {
    fn constant(value: f64) -> Self {
        Self::new(value, value)
    }

    fn apply(self, function: Function) -> Self {
        let quarter = Self::constant(FRAC_PI_2);
        match function {
            Function::Cos => self.cosine(),
            Function::Sin => (self - quarter).cosine(),
            Function::Tan => {
                let branch = |x: f64| libm::floor(x / PI + 0.5);
                if branch(self.lower) == branch(self.upper) { self.monotone(libm::tan) } else { UNKNOWN }
            }
            Function::Tanh => self.monotone(libm::tanh),
            Function::Atan => self.monotone(libm::atan),
            Function::Exp => self.monotone(libm::exp),
            Function::Ln => self.monotone(libm::log),
            Function::Sqrt => self.monotone(f64::sqrt),
        }
    }

    #[inline]
    fn scale(self, factor: f64) -> Self {
        Self::new(self.lower * factor, self.upper * factor)
    }

    #[inline]
    fn square(self) -> Self {
        let range = self.monotone(|x| x * x);
        if self.lower < 0.0 && self.upper > 0.0 { Self { lower: 0.0, ..range } } else { range }
    }
}

impl SeriesCoefficient for Interval {
    fn derivatives(self, function: Function) -> [Self; 3] {
        function.derivatives(self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Intervals of many sizes and places, and points of each.
    fn samples() -> impl Iterator<Item = (Interval, [f64; 9])> {
        let ends = (0..40).map(|k| (-3.0 + 0.31 * f64::from(k), 0.05 + 0.17 * f64::from(k % 11)));
        ends.map(|(start, width)| {
            let points = core::array::from_fn(|i| start + width * i as f64 / 8.0);
            (Interval::new(start, start + width), points)
        })
    }

    #[track_caller]
    fn assert_holds(range: Interval, value: f64) {
        // Bounds are right to rounding.
        let slack = 1e-14 * (1.0 + value.abs());
        assert!(
            value.is_nan() || (range.lower - slack <= value && value <= range.upper + slack),
            "{range:?} {value}"
        );
    }

    #[test]
    fn ranges_of_functions_and_of_their_derivatives_are_held() {
        for function in Function::ALL {
            for (interval, points) in samples() {
                let ranges = interval.derivatives(function);
                assert_eq!(ranges[0], interval.apply(function));
                for point in points {
                    for (range, value) in ranges.into_iter().zip(point.derivatives(function)) {
                        assert_holds(range, value);
                    }
                }
            }
        }
    }

    #[test]
    fn ranges_of_operations_are_held() {
        for (a, first) in samples() {
            for (b, second) in samples() {
                for x in first {
                    assert_holds(a.square(), x * x);
                    assert_holds(a.scale(-2.0) - b, -2.0 * x - second[0]);
                    for y in second {
                        assert_holds(a * b, x * y);
                        assert_holds(a / b, x / y);
                        assert_holds(-a + b, y - x);
                    }
                }
            }
        }
    }

    #[test]
    fn ranges_of_the_cosine_are_exact_where_it_turns() {
        let across = Interval::new(3.0, 3.5).apply(Function::Cos);
        assert_eq!((across.lower, across.upper), (-1.0, libm::cos(3.5)));
        let wide = Interval::new(-1.0, 6.0).apply(Function::Cos);
        assert_eq!((wide.lower, wide.upper), (-1.0, 1.0));
    }

    #[test]
    fn nothing_is_known_of_nan() {
        let zero = Interval::constant(0.0);
        assert_eq!(UNKNOWN * zero, UNKNOWN);
        assert_eq!(zero / Interval::new(-1.0, 1.0), UNKNOWN);
        assert_eq!(Interval::new(-1.0, 1.0).apply(Function::Ln), UNKNOWN);
    }
}
