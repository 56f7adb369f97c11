//! Jets in four variables: a value with its first, or first and second, derivatives.
//!
//! Coefficients are plain numbers, or numbers at all stages of a step.

use core::ops::{Div, Mul};

use crate::scalar::{Function, Scalar, SeriesCoefficient, entrywise, with_plain_numbers};

/// The variables of jets, by number.
///
/// The phase needs no place in the jets that are integrated: the flow's derivatives in z₀ follow
/// from the others. In jets without a position the phase has the number of the position.
pub(super) mod variable {
    pub(crate) const POSITION: usize = 0;
    pub(crate) const PHASE: usize = 0;
    pub(crate) const VELOCITY: usize = 1;
    pub(crate) const PRIMARY: usize = 2;
    pub(crate) const SECONDARY: usize = 3;
}

/// The number of variables.
pub(super) const VARIABLES: usize = 4;
/// Length of a jet of first order: the value and the gradient.
pub(super) const FIRST: usize = 1 + VARIABLES;
/// Length of a jet of second order: with the upper triangle of the second derivatives.
pub(super) const SECOND: usize = FIRST + VARIABLES * (VARIABLES + 1) / 2;

/// The two variables of each second derivative, in the order in which they are stored; pairs of
/// neighbours share one, which lets products be taken two at a time.
pub(super) const PAIRS: [[usize; 2]; SECOND - FIRST] =
    [[0, 0], [0, 1], [0, 2], [0, 3], [1, 1], [1, 2], [2, 2], [2, 3], [1, 3], [3, 3]];

/// The index of each second derivative in [`PAIRS`].
const PLACES: [[usize; VARIABLES]; VARIABLES] = {
    let mut places = [[0; VARIABLES]; VARIABLES];
    let mut k = 0;
    while k < PAIRS.len() {
        let [a, b] = PAIRS[k];
        places[a][b] = k;
        places[b][a] = k;
        k += 1;
    }
    places
};

/// Length of a jet of first order in two variables alone.
pub(super) const PLANAR: usize = 3;

/// A value with its derivatives; `LENGTH` is [`PLANAR`], [`FIRST`] or [`SECOND`], and sets the
/// order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Jet<const LENGTH: usize, C = f64>(pub(super) [C; LENGTH]);

impl<const LENGTH: usize, C: SeriesCoefficient> Jet<LENGTH, C> {
    /// A variable with its value.
    #[inline(always)]
    pub(super) fn variable(index: usize, value: C) -> Self {
        let mut jet = Self::fixed(value);
        jet.0[1 + index] = C::constant(1.0);
        jet
    }

    /// A value that does not depend on the variables.
    #[inline(always)]
    pub(super) fn fixed(value: C) -> Self {
        let mut jet = [C::constant(0.0); LENGTH];
        jet[0] = value;
        Self(jet)
    }

    #[inline]
    pub(super) fn value(&self) -> C {
        self.0[0]
    }

    #[inline]
    pub(super) fn first(&self, variable: usize) -> C {
        self.0[1 + variable]
    }

    /// The second derivative; zero in a jet of first order.
    #[inline]
    pub(super) fn second(&self, a: usize, b: usize) -> C {
        if LENGTH < SECOND {
            return C::constant(0.0);
        }
        self.0[FIRST + PLACES[a][b]]
    }

    /// The function whose value and derivatives at this jet's value are given.
    #[inline(always)]
    pub(super) fn compose(&self, [value, slope, curvature]: [C; 3]) -> Self {
        let p = &self.0;
        let mut jet = [value; LENGTH];
        for i in 1..LENGTH {
            jet[i] = slope * p[i];
        }
        if LENGTH == SECOND {
            for (k, [a, b]) in PAIRS.into_iter().enumerate() {
                jet[FIRST + k] = jet[FIRST + k] + curvature * p[1 + a] * p[1 + b];
            }
        }
        Self(jet)
    }
}

entrywise!([const LENGTH: usize, C: SeriesCoefficient] Jet<LENGTH, C>);

impl<const LENGTH: usize, C: SeriesCoefficient> Mul for Jet<LENGTH, C> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let (p, q) = (&self.0, &other.0);
        let mut jet = [p[0] * q[0]; LENGTH];
        for i in 1..LENGTH {
            jet[i] = p[0] * q[i] + p[i] * q[0];
        }
        if LENGTH == SECOND {
            for (k, [a, b]) in PAIRS.into_iter().enumerate() {
                jet[FIRST + k] = jet[FIRST + k] + (p[1 + a] * q[1 + b] + p[1 + b] * q[1 + a]);
            }
        }
        Self(jet)
    }
}

impl<const LENGTH: usize, C: SeriesCoefficient> Div for Jet<LENGTH, C> {
    type Output = Self;

    #[inline]
    fn div(self, other: Self) -> Self {
        let inverse = C::constant(1.0) / other.0[0];
        let square = inverse * inverse;
        self * other.compose([inverse, -square, (square * inverse).scale(2.0)])
    }
}

impl<const LENGTH: usize, C: SeriesCoefficient> From<C> for Jet<LENGTH, C> {
    #[inline(always)]
    fn from(value: C) -> Self {
        Self::fixed(value)
    }
}

with_plain_numbers!([const LENGTH: usize, C: SeriesCoefficient] Jet<LENGTH, C>);

impl<const LENGTH: usize, C: SeriesCoefficient> Scalar for Jet<LENGTH, C> {
    #[inline(always)]
    fn constant(value: f64) -> Self {
        Self::fixed(C::constant(value))
    }

    #[inline(always)]
    fn apply(self, function: Function) -> Self {
        self.compose(self.0[0].derivatives(function))
    }

    #[inline(always)]
    fn scale(mut self, factor: f64) -> Self {
        for entry in &mut self.0 {
            *entry = entry.scale(factor);
        }
        self
    }

    #[inline(always)]
    fn plus(mut self, factor: f64, other: &Self) -> Self {
        for (a, b) in self.0.iter_mut().zip(&other.0) {
            *a = a.plus(factor, b);
        }
        self
    }

    #[inline(always)]
    fn square(self) -> Self {
        let value = self.0[0];
        self.compose([value * value, value.scale(2.0), C::constant(2.0)])
    }
}
