//! Taylor polynomials of third degree in one variable, for third derivatives along a curve.

use core::ops::{Div, Mul};

use crate::scalar::{Function, Scalar, SeriesCoefficient, entrywise, with_plain_numbers};

/// c₀ + c₁ s + c₂ s² + c₃ s³ + O(s⁴): a number that moves along a curve with the parameter s.
///
/// The k-th derivative at s = 0 is k! c_k. A function of numbers on a curve moves along the image
/// of the curve, so that one evaluation of a map F at X + q s gives (1/6) D³F(q, q, q) as the
/// coefficient of s³, exactly to rounding.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Taylor([f64; Taylor::ORDER + 1]);

impl Taylor {
    /// The degree up to which coefficients are kept.
    pub const ORDER: usize = 3;

    /// The polynomial with these coefficients c₀, …, c₃.
    pub const fn new(coefficients: [f64; Self::ORDER + 1]) -> Self {
        Self(coefficients)
    }

    /// The coefficients c₀, …, c₃.
    pub const fn coefficients(&self) -> [f64; Self::ORDER + 1] {
        self.0
    }

    /// The value at s = 0.
    pub const fn value(&self) -> f64 {
        self.0[0]
    }

    /// The polynomial without its constant term: the displacement from the value at s = 0.
    pub fn movement(&self) -> Self {
        let mut movement = *self;
        movement.0[0] = 0.0;
        movement
    }

    /// The composition with a function whose value and derivatives up to the third at c₀ are given.
    fn compose(&self, [value, slope, curvature, third]: [f64; Self::ORDER + 1]) -> Self {
        let [_, c1, c2, c3] = self.0;
        Self([
            value,
            slope * c1,
            slope * c2 + 0.5 * curvature * c1 * c1,
            slope * c3 + curvature * c1 * c2 + third / 6.0 * c1 * c1 * c1,
        ])
    }
}

/// The third derivative of a function at x, from its value and the first two derivatives.
fn third_derivative(function: Function, x: f64, [value, slope, curvature]: [f64; 3]) -> f64 {
    match function {
        Function::Sin | Function::Cos => -slope,
        Function::Tan => 2.0 * slope * (slope + 2.0 * value * value),
        Function::Tanh => 2.0 * slope * (2.0 * value * value - slope),
        Function::Atan => 2.0 * slope * slope * (4.0 * x * x * slope - 1.0),
        Function::Exp => value,
        Function::Ln => -2.0 * curvature / x,
        Function::Sqrt => -1.5 * curvature / x,
    }
}

entrywise!([] Taylor);

impl Mul for Taylor {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        let ([a0, a1, a2, a3], [b0, b1, b2, b3]) = (self.0, other.0);
        Self([a0 * b0, a0 * b1 + a1 * b0, a0 * b2 + a1 * b1 + a2 * b0, a0 * b3 + a1 * b2 + a2 * b1 + a3 * b0])
    }
}

impl Div for Taylor {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let inverse = 1.0 / other.value();
        let square = inverse * inverse;
        self * other.compose([inverse, -square, 2.0 * square * inverse, -6.0 * square * square])
    }
}

with_plain_numbers!([] Taylor);

impl Scalar for Taylor {
    #[inline]
    fn constant(value: f64) -> Self {
        Self([value, 0.0, 0.0, 0.0])
    }

    #[inline]
    fn apply(self, function: Function) -> Self {
        let x = self.value();
        let known = x.derivatives(function);
        let [value, slope, curvature] = known;
        self.compose([value, slope, curvature, third_derivative(function, x, known)])
    }

    #[inline]
    fn scale(self, factor: f64) -> Self {
        Self(self.0.map(|c| factor * c))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_dual::{Dual3_64, DualNum, third_derivative};

    /// The function in dual numbers of third order.
    fn dual(function: Function, x: Dual3_64) -> Dual3_64 {
        match function {
            Function::Sin => x.sin(),
            Function::Cos => x.cos(),
            Function::Tan => x.tan(),
            Function::Tanh => x.tanh(),
            Function::Atan => x.atan(),
            Function::Exp => x.exp(),
            Function::Ln => x.ln(),
            Function::Sqrt => x.sqrt(),
        }
    }

    /// Compares every operation and function along a curved path with automatic differentiation by
    /// an independent library.
    #[test]
    fn coefficients_are_those_of_automatic_differentiation() {
        for function in Function::ALL {
            let s = Taylor::new([0.3, 1.0, 0.0, 0.0]);
            let inner = s.power(3) - s.scale(0.7) + 0.8;
            let outer = inner.apply(function);
            let computed = (outer * s.power(-2) - outer.square()) / (s + outer) + (-s).scale(0.4);

            let expected = third_derivative(
                |s| {
                    let inner = s * s * s - s * 0.7 + 0.8;
                    let outer = dual(function, inner);
                    (outer / (s * s) - outer * outer) / (s + outer) - s * 0.4
                },
                0.3,
            );
            let expected = [expected.0, expected.1, expected.2 / 2.0, expected.3 / 6.0];
            for (computed, expected) in computed.coefficients().into_iter().zip(expected) {
                // Roundings of a dozen operations on coefficients that grow by 1/0.3 with each
                // order.
                let tolerance = 1e-14 * (1e2 + expected.abs());
                assert!((computed - expected).abs() < tolerance, "{function:?}: {computed} {expected}");
            }
        }
    }
}
