//! Jets in the initial state and the parameters.

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::scalar::{Function, Scalar};

/// The number of variables: x₀, y₀, z₀, μ, η.
pub(super) const VARIABLES: usize = 5;
/// Where the second derivatives begin.
const SECOND: usize = 1 + VARIABLES;
/// All coefficients of a jet of second order.
const ALL: usize = SECOND + VARIABLES * (VARIABLES + 1) / 2;

/// A value with its derivatives up to `ORDER` (1 or 2) in five variables: the value, the gradient, and the upper triangle of
/// the second derivatives row by row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Jet<const ORDER: usize>([f64; ALL]);

impl<const ORDER: usize> Jet<ORDER> {
    const LENGTH: usize = if ORDER >= 2 { ALL } else { SECOND };

    /// A variable with its value.
    pub(super) fn variable(index: usize, value: f64) -> Self {
        let mut jet = Self::constant(value);
        jet.0[1 + index] = 1.0;
        jet
    }

    pub(super) fn value(&self) -> f64 {
        self.0[0]
    }

    pub(super) fn first(&self, variable: usize) -> f64 {
        self.0[1 + variable]
    }

    /// The second derivative; zero in a jet of first order.
    pub(super) fn second(&self, a: usize, b: usize) -> f64 {
        let (row, column) = (a.min(b), a.max(b));
        self.0[SECOND + row * VARIABLES - row * (row + 1) / 2 + column]
    }

    /// Adds the multiple of another jet.
    #[inline]
    pub(super) fn add_multiple(&mut self, factor: f64, other: &Self) {
        for i in 0..Self::LENGTH {
            self.0[i] += factor * other.0[i];
        }
    }

    /// The function whose value and derivatives at this jet's value are given.
    #[inline]
    fn compose(&self, [value, slope, curvature]: [f64; 3]) -> Self {
        let mut jet = [0.0; ALL];
        jet[0] = value;
        for i in 1..Self::LENGTH {
            jet[i] = slope * self.0[i];
        }
        if ORDER >= 2 {
            let mut k = SECOND;
            for a in 1..SECOND {
                let bent = curvature * self.0[a];
                for b in a..SECOND {
                    jet[k] += bent * self.0[b];
                    k += 1;
                }
            }
        }
        Self(jet)
    }
}

impl<const ORDER: usize> Add for Jet<ORDER> {
    type Output = Self;

    #[inline]
    fn add(mut self, other: Self) -> Self {
        for i in 0..Self::LENGTH {
            self.0[i] += other.0[i];
        }
        self
    }
}

impl<const ORDER: usize> Sub for Jet<ORDER> {
    type Output = Self;

    #[inline]
    fn sub(mut self, other: Self) -> Self {
        for i in 0..Self::LENGTH {
            self.0[i] -= other.0[i];
        }
        self
    }
}

impl<const ORDER: usize> Neg for Jet<ORDER> {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        self.scale(-1.0)
    }
}

impl<const ORDER: usize> Mul for Jet<ORDER> {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        let (p, q) = (&self.0, &other.0);
        let mut jet = [0.0; ALL];
        jet[0] = p[0] * q[0];
        for i in 1..Self::LENGTH {
            jet[i] = p[0] * q[i] + p[i] * q[0];
        }
        if ORDER >= 2 {
            let mut k = SECOND;
            for a in 1..SECOND {
                for b in a..SECOND {
                    jet[k] += p[a] * q[b] + p[b] * q[a];
                    k += 1;
                }
            }
        }
        Self(jet)
    }
}

impl<const ORDER: usize> Div for Jet<ORDER> {
    type Output = Self;

    #[inline]
    fn div(self, other: Self) -> Self {
        let inverse = 1.0 / other.0[0];
        let square = inverse * inverse;
        self * other.compose([inverse, -square, 2.0 * square * inverse])
    }
}

impl<const ORDER: usize> Scalar for Jet<ORDER> {
    #[inline]
    fn constant(value: f64) -> Self {
        let mut jet = [0.0; ALL];
        jet[0] = value;
        Self(jet)
    }

    #[inline]
    fn apply(self, function: Function) -> Self {
        self.compose(function.derivatives(self.0[0]))
    }

    #[inline]
    fn scale(mut self, factor: f64) -> Self {
        for i in 0..Self::LENGTH {
            self.0[i] *= factor;
        }
        self
    }

    #[inline]
    fn square(self) -> Self {
        self * self
    }
}
