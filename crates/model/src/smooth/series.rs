//! Series in time to second order, with one perturbation, for the derivatives of a motion.

use core::ops::{Div, Mul};

use crate::scalar::{Function, Scalar, SeriesCoefficient, entrywise, with_plain_numbers};

/// The series c₀ + c₁ t + c₂ t² + c₃ ε, with products of t and ε left out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Series<C>(pub(super) [C; 4]);

entrywise!([C: SeriesCoefficient] Series<C>);

impl<C: SeriesCoefficient> Mul for Series<C> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let ([a0, a1, a2, a3], [b0, b1, b2, b3]) = (self.0, other.0);
        Self([a0 * b0, a0 * b1 + a1 * b0, a0 * b2 + a1 * b1 + a2 * b0, a0 * b3 + a3 * b0])
    }
}

impl<C: SeriesCoefficient> Div for Series<C> {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let ([a0, a1, a2, a3], [b0, b1, b2, b3]) = (self.0, other.0);
        let q0 = a0 / b0;
        let q1 = (a1 - q0 * b1) / b0;
        Self([q0, q1, (a2 - q0 * b2 - q1 * b1) / b0, (a3 - q0 * b3) / b0])
    }
}

with_plain_numbers!([C: SeriesCoefficient] Series<C>);

impl<C: SeriesCoefficient> Scalar for Series<C> {
    fn constant(value: f64) -> Self {
        let zero = C::constant(0.0);
        Self([C::constant(value), zero, zero, zero])
    }

    fn apply(self, function: Function) -> Self {
        let [c0, c1, c2, c3] = self.0;
        let [value, slope, curvature] = c0.derivatives(function);
        let bent = (curvature * c1.square()).scale(0.5);
        Self([value, slope * c1, slope * c2 + bent, slope * c3])
    }

    fn scale(self, factor: f64) -> Self {
        Self(self.0.map(|c| c.scale(factor)))
    }

    fn square(self) -> Self {
        let [c0, c1, c2, c3] = self.0;
        Self([c0.square(), (c0 * c1).scale(2.0), (c0 * c2).scale(2.0) + c1.square(), (c0 * c3).scale(2.0)])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Compares the coefficients of a series with the derivatives of a function of t, computed by
    /// differences at t = 0.
    #[test]
    fn coefficients_are_derivatives() {
        fn expression<S: Scalar>(t: S, function: Function) -> S {
            let inner = S::constant(0.4) + t.scale(0.7) - t.square().scale(0.3);
            let bent = inner.apply(function) / (S::constant(1.5) + t * inner);
            -bent.power(3) + bent.square() * t
        }
        // Fourth derivatives of up to 1e3 times h²/12, and rounding 1e-16/h².
        let (step, tolerance) = (1e-4, 1e-5);
        let list = [Function::Sin, Function::Cos, Function::Tan, Function::Tanh];
        for function in list.into_iter().chain([Function::Atan, Function::Exp, Function::Ln, Function::Sqrt])
        {
            let Series([value, slope, bend, other]) = expression(Series([0.0, 1.0, 0.0, 2.0]), function);
            let [below, here, above] = [-step, 0.0, step].map(|t| expression(t, function));
            assert!((value - here).abs() < 1e-15, "{function:?}");
            assert!((slope - (above - below) / (2.0 * step)).abs() < tolerance, "{function:?}");
            assert!(
                (2.0 * bend - (above - 2.0 * here + below) / (step * step)).abs() < tolerance,
                "{function:?}"
            );
            // Twice the slope, to rounding.
            assert!((other - 2.0 * slope).abs() < 1e-14, "{function:?}");
        }
    }
}
