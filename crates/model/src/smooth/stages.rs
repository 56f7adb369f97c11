//! Numbers at all stages of a step at once: each operation acts on all six, side by side.

use core::ops::{Div, Mul};

use crate::scalar::{Function, Scalar, SeriesCoefficient, entrywise, with_plain_numbers};

/// Numbers side by side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Lanes<const COUNT: usize>(pub(super) [f64; COUNT]);

/// Number of stages.
pub(super) const STAGES: usize = 6;

/// One number for each stage of a step.
pub(super) type Stages = Lanes<STAGES>;

/// A matrix that acts on numbers at the stages, by columns.
pub(super) struct Matrix(pub(super) [Stages; STAGES]);

impl Matrix {
    pub(super) const fn from_rows(rows: [[f64; STAGES]; STAGES]) -> Self {
        let mut columns = [Lanes([0.0; STAGES]); STAGES];
        let mut place = 0;
        while place < STAGES * STAGES {
            columns[place % STAGES].0[place / STAGES] = rows[place / STAGES][place % STAGES];
            place += 1;
        }
        Self(columns)
    }
}

impl Stages {
    /// The sum of the numbers with these weights.
    #[inline]
    pub(super) fn weighted(&self, weights: &[f64; STAGES]) -> f64 {
        weights.iter().zip(self.0).fold(0.0, |sum, (weight, value)| sum + weight * value)
    }

    /// The sums with the weights of each row of a matrix.
    #[inline(always)]
    pub(super) fn through(&self, Matrix(columns): &Matrix) -> Self {
        let mut sums = Self::constant(0.0);
        for (column, value) in columns.iter().zip(self.0) {
            sums = sums.plus(value, column);
        }
        sums
    }

    /// The largest modulus; NaN if one of the numbers is.
    #[inline]
    pub(super) fn modulus(&self) -> f64 {
        let larger = |a: f64, b: f64| if a > b { a } else { b };
        let [a, b, c, d, e, f] = self.0.map(f64::abs);
        // Comparisons lose NaN, and sums keep it.
        let [even, odd] = [a + c + e, b + d + f];
        let largest = larger(larger(larger(a, c), e), larger(larger(b, d), f));
        if (even + odd).is_nan() { f64::NAN } else { largest }
    }
}

entrywise!([const COUNT: usize] Lanes<COUNT>);

impl<const COUNT: usize> Mul for Lanes<COUNT> {
    type Output = Self;

    #[inline(always)]
    fn mul(mut self, other: Self) -> Self {
        for (a, b) in self.0.iter_mut().zip(other.0) {
            *a *= b;
        }
        self
    }
}

impl<const COUNT: usize> Div for Lanes<COUNT> {
    type Output = Self;

    #[inline(always)]
    fn div(mut self, other: Self) -> Self {
        for (a, b) in self.0.iter_mut().zip(other.0) {
            *a /= b;
        }
        self
    }
}

with_plain_numbers!([const COUNT: usize] Lanes<COUNT>);

impl<const COUNT: usize> Scalar for Lanes<COUNT> {
    #[inline(always)]
    fn constant(value: f64) -> Self {
        Self([value; COUNT])
    }

    fn apply(mut self, function: Function) -> Self {
        for value in &mut self.0 {
            *value = value.apply(function);
        }
        self
    }

    #[inline(always)]
    fn scale(mut self, factor: f64) -> Self {
        for value in &mut self.0 {
            *value *= factor;
        }
        self
    }

    #[inline(always)]
    fn plus(mut self, factor: f64, other: &Self) -> Self {
        for (a, b) in self.0.iter_mut().zip(&other.0) {
            *a += factor * b;
        }
        self
    }
}

impl<const COUNT: usize> SeriesCoefficient for Lanes<COUNT> {
    fn derivatives(self, function: Function) -> [Self; 3] {
        let mut all = [self; 3];
        for i in 0..COUNT {
            let derivatives = self.0[i].derivatives(function);
            for (stages, derivative) in all.iter_mut().zip(derivatives) {
                stages.0[i] = derivative;
            }
        }
        all
    }
}

#[cfg(test)]
mod tests {
    use super::super::jet::{Jet, SECOND};
    use super::*;

    /// Every operation and a function, of x, y, t and parameters.
    fn expression<S: Scalar>([x, y, t]: [S; 3], function: Function) -> S {
        let inner = (x * t - y.scale(0.3)).apply(function);
        -inner / (S::constant(1.5) + t.square()).plus(0.5, &y.power(3))
    }

    #[test]
    fn lanes_are_numbers_side_by_side() {
        let numbers = [0.3, 0.7, 1.1, 1.4, 1.9, 2.3];
        let arguments =
            |value: f64| [Jet::variable(0, value), Jet::variable(2, 0.4 * value), Jet::constant(1.7)];
        for function in [Function::Cos, Function::Tanh, Function::Exp, Function::Sqrt] {
            let lanes: [Jet<SECOND, Stages>; 3] = [
                Jet::variable(0, Lanes(numbers)),
                Jet::variable(2, Lanes(numbers).scale(0.4)),
                Jet::constant(1.7),
            ];
            let together = expression(lanes, function);
            for (i, value) in numbers.into_iter().enumerate() {
                let alone: Jet<SECOND> = expression(arguments(value), function);
                for (lanes, entry) in together.0.iter().zip(alone.0) {
                    assert_eq!(lanes.0[i].to_bits(), entry.to_bits(), "{function:?}");
                }
            }
        }
    }

    #[test]
    fn the_modulus_of_nan_is_nan() {
        for place in 0..STAGES {
            let mut stages = Stages::constant(-2.0);
            assert_eq!(stages.modulus(), 2.0);
            stages.0[place] = f64::NAN;
            assert!(stages.modulus().is_nan());
        }
    }
}
