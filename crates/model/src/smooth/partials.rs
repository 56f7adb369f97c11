//! The derivatives of a force by formulas of its own.

use super::jet::variable::{PRIMARY, SECONDARY, VELOCITY};
use super::jet::{FIRST, Jet, PAIRS, SECOND, VARIABLES};
use crate::scalar::{Scalar, SeriesCoefficient};

/// The number of arguments of a force, and of its derivatives of up to second order, itself included.
const ARGUMENTS: usize = 5;
const ALL: usize = 1 + ARGUMENTS + ARGUMENTS * (ARGUMENTS + 1) / 2;

/// A force F(x, y, t; μ, η) and its derivatives, each at [its place](partial); arguments have numbers in this
/// order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Partials<S>(pub [S; ALL]);

/// The place of a derivative in no, one or two arguments, the first of which has the lower number.
pub const fn partial(arguments: &[usize]) -> usize {
    match *arguments {
        [] => 0,
        [a] => 1 + a,
        [a, b] => 1 + ARGUMENTS + a * (2 * ARGUMENTS - 1 - a) / 2 + b,
        _ => panic!("derivatives are of second order at most"),
    }
}

impl<S: Scalar> Partials<S> {
    /// A force that is zero everywhere.
    pub fn zero() -> Self {
        Self([S::constant(0.0); ALL])
    }

    /// Measures arguments in these units, and the force in the last.
    pub(super) fn convert(&mut self, units: [f64; ARGUMENTS], force: f64) {
        let mut scale = |place: usize, unit: f64| self.0[place] = self.0[place].scale(unit / force);
        scale(partial(&[]), 1.0);
        for (a, unit) in units.into_iter().enumerate() {
            scale(partial(&[a]), unit);
            for (b, other) in units.into_iter().enumerate().skip(a) {
                scale(partial(&[a, b]), unit * other);
            }
        }
    }
}

/// The number of the time among the arguments, and those of the variables of a jet.
const TIME: usize = 2;
const OF_VARIABLES: [usize; VARIABLES] = {
    let mut arguments = [0; VARIABLES];
    (arguments[VELOCITY], arguments[PRIMARY], arguments[SECONDARY]) = (1, 3, 4);
    arguments
};

impl<const LENGTH: usize, C: SeriesCoefficient> Jet<LENGTH, C> {
    /// A force in x, y, μ and η where the time depends on μ and η.
    pub(super) fn of_force(Partials(known): &Partials<C>, time: &Jet<LENGTH>) -> Self {
        let with_time = |a: usize| known[partial(&[a.min(TIME), a.max(TIME)])];
        let slope = known[partial(&[TIME])];
        let mut jet = Self::fixed(known[partial(&[])]);
        for (variable, argument) in OF_VARIABLES.into_iter().enumerate() {
            let mut entry = known[partial(&[argument])];
            if variable >= PRIMARY {
                entry = entry.plus(time.first(variable), &slope);
            }
            jet.0[1 + variable] = entry;
        }
        if LENGTH == SECOND {
            for (k, [a, b]) in PAIRS.into_iter().enumerate() {
                let [first, second] = [a, b].map(|variable| OF_VARIABLES[variable]);
                let mut entry = known[partial(&[first, second])];
                if b >= PRIMARY {
                    entry = entry.plus(time.first(b), &with_time(first));
                }
                if a >= PRIMARY {
                    entry = entry.plus(time.first(a), &with_time(second));
                    entry = entry.plus(time.first(a) * time.first(b), &with_time(TIME));
                    entry = entry.plus(time.second(a, b), &slope);
                }
                jet.0[FIRST + k] = entry;
            }
        }
        jet
    }
}
