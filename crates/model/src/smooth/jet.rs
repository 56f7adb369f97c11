//! Jets in four variables: a value with its first, or first and second, derivatives.

use core::array::from_fn;
use core::ops::{Add, Div, Mul, Neg, Sub};

use super::scalar::{Function, Scalar};

/// The number of variables.
pub(super) const VARIABLES: usize = 4;
/// Length of a jet of first order: the value and the gradient.
pub(super) const FIRST: usize = 1 + VARIABLES;
/// Length of a jet of second order: with the upper triangle of the second derivatives.
pub(super) const SECOND: usize = FIRST + VARIABLES * (VARIABLES + 1) / 2;

/// The two variables of each second derivative, in the order in which they are stored; pairs of neighbours share one, which
/// lets products be taken two at a time.
const PAIRS: [[usize; 2]; SECOND - FIRST] =
    [[0, 0], [0, 1], [0, 2], [0, 3], [1, 1], [1, 2], [2, 2], [2, 3], [1, 3], [3, 3]];

/// Length of a jet without derivatives.
pub(super) const PLAIN: usize = 1;
/// Length of a jet of first order in two variables alone.
pub(super) const PLANAR: usize = 3;

/// A value with its derivatives; `LENGTH` is [`PLAIN`], [`PLANAR`], [`FIRST`] or [`SECOND`], and sets the order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Jet<const LENGTH: usize>([f64; LENGTH]);

impl<const LENGTH: usize> Jet<LENGTH> {
    /// A variable with its value.
    pub(super) fn variable(index: usize, value: f64) -> Self {
        let mut jet = Self::constant(value);
        jet.0[1 + index] = 1.0;
        jet
    }

    #[inline]
    pub(super) fn value(&self) -> f64 {
        self.0[0]
    }

    pub(super) fn first(&self, variable: usize) -> f64 {
        self.0[1 + variable]
    }

    /// The second derivative; zero in a jet of first order.
    pub(super) fn second(&self, a: usize, b: usize) -> f64 {
        if LENGTH < SECOND {
            return 0.0;
        }
        let place = PAIRS.iter().position(|&pair| pair == [a.min(b), a.max(b)]);
        place.map_or(f64::NAN, |k| self.0[FIRST + k])
    }

    /// Adds the multiple of another jet, of this length or less; derivatives that it has no place for are zero.
    #[inline(always)]
    pub(super) fn add_multiple<const OTHER: usize>(&mut self, factor: f64, other: &Jet<OTHER>) {
        for (sum, entry) in self.0.iter_mut().zip(&other.0) {
            *sum += factor * entry;
        }
    }

    /// The same without the derivatives that a jet of this length has no place for, or with zeros for those that it has
    /// and this one has not.
    #[inline]
    pub(super) fn resized<const OTHER: usize>(&self) -> Jet<OTHER> {
        Jet(from_fn(|i| if i < LENGTH { self.0[i] } else { 0.0 }))
    }

    /// The function whose value and derivatives at this jet's value are given.
    #[inline(always)]
    fn compose(&self, [value, slope, curvature]: [f64; 3]) -> Self {
        let p = &self.0;
        let mut jet = p.map(|entry| slope * entry);
        jet[0] = value;
        if LENGTH == SECOND {
            let bent: [f64; VARIABLES] = from_fn(|a| curvature * p[1 + a]);
            for (k, [a, b]) in PAIRS.into_iter().enumerate() {
                jet[FIRST + k] += bent[a] * p[1 + b];
            }
        }
        Self(jet)
    }
}

impl<const LENGTH: usize> Add for Jet<LENGTH> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self(from_fn(|i| self.0[i] + other.0[i]))
    }
}

impl<const LENGTH: usize> Sub for Jet<LENGTH> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self(from_fn(|i| self.0[i] - other.0[i]))
    }
}

impl<const LENGTH: usize> Neg for Jet<LENGTH> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self(self.0.map(|entry| -entry))
    }
}

impl<const LENGTH: usize> Mul for Jet<LENGTH> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let (p, q) = (&self.0, &other.0);
        let mut jet: [f64; LENGTH] = from_fn(|i| p[0] * q[i] + p[i] * q[0]);
        jet[0] = p[0] * q[0];
        if LENGTH == SECOND {
            for (k, [a, b]) in PAIRS.into_iter().enumerate() {
                jet[FIRST + k] += p[1 + a] * q[1 + b] + p[1 + b] * q[1 + a];
            }
        }
        Self(jet)
    }
}

impl<const LENGTH: usize> Div for Jet<LENGTH> {
    type Output = Self;

    #[inline]
    fn div(self, other: Self) -> Self {
        let inverse = 1.0 / other.0[0];
        let square = inverse * inverse;
        self * other.compose([inverse, -square, 2.0 * square * inverse])
    }
}

impl<const LENGTH: usize> Scalar for Jet<LENGTH> {
    #[inline(always)]
    fn constant(value: f64) -> Self {
        let mut jet = [0.0; LENGTH];
        jet[0] = value;
        Self(jet)
    }

    #[inline(always)]
    fn apply(self, function: Function) -> Self {
        self.compose(function.derivatives(self.0[0]))
    }

    #[inline(always)]
    fn scale(self, factor: f64) -> Self {
        Self(self.0.map(|entry| factor * entry))
    }

    #[inline(always)]
    fn square(self) -> Self {
        let value = self.0[0];
        self.compose([value * value, 2.0 * value, 2.0])
    }
}
