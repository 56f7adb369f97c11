//! Formulas for the derivatives of a force, on tapes of their own.
//!
//! Jets carry every derivative through every instruction, though most of them are zero in most: a tape of
//! formulas, which share their parts, has three to fifteen instructions for each of the force's own in the examples.

use grazing_model::smooth::{Partials, Scalar, Stop, partial};

use super::graph::{Graph, Term};
use super::{Expression, Tape, assemble, value, with_space};

/// The numbers of variables of a force: all, and those that move.
const VARIABLES: usize = 5;
const MOVING: usize = 2;

/// The largest number of instructions of its derivatives for each of a force's own: as many as there are derivatives,
/// all of which jets carry through each.
const FOR_EACH: usize = 1 + partial(&[VARIABLES - 1, VARIABLES - 1]);
/// The largest number of instructions of a force that is differentiated: each takes a quarter of a millisecond to read.
const LONGEST: usize = 1000;

/// Formulas for the derivatives of a force.
#[derive(Debug, PartialEq)]
pub(super) struct ForceDerivatives {
    /// F, F_x and F_y.
    slopes: Tape,
    /// F and its derivatives that are not zero everywhere, by increasing order, with the place of each.
    all: Tape,
    places: Vec<usize>,
    /// The number of those that are not of second order.
    first_order: usize,
}

impl ForceDerivatives {
    /// The formulas for a force; `None` if they are long, or contain numbers too large for computation.
    pub(super) fn of(
        graph: &Graph,
        force: Term<'_>,
        itself: &Expression,
        variables: &[&str; VARIABLES],
        stop: &Stop,
    ) -> Option<Self> {
        if itself.instructions() > LONGEST {
            return None;
        }
        let slope = |of, variable| graph.derivative(of, variable, stop).ok();
        let slopes: Vec<Term<'_>> = (0..VARIABLES).map(|a| slope(force, a)).collect::<Option<_>>()?;
        let mut all = vec![(partial(&[]), force)];
        all.extend(slopes.iter().enumerate().map(|(a, of)| (partial(&[a]), *of)));
        for (a, of) in slopes.iter().enumerate() {
            for b in a..VARIABLES {
                all.push((partial(&[a, b]), slope(*of, b)?));
            }
        }
        all.retain(|(place, term)| *place == 0 || !matches!(term, Term::Number(0.0)));
        let (places, terms): (Vec<usize>, Vec<Term<'_>>) = all.into_iter().unzip();
        let (nodes, results) = graph.parts(&terms);
        let all = assemble::tape(variables, VARIABLES, &nodes, &results);
        if all.whole.instructions.len() > FOR_EACH * itself.instructions().max(1) {
            return None;
        }
        let (nodes, results) = graph.parts(&[force, slopes[0], slopes[1]]);
        let slopes = assemble::tape(variables, MOVING, &nodes, &results);
        let first_order = places.iter().filter(|place| **place < partial(&[0, 0])).count();
        Some(Self { slopes, all, places, first_order })
    }
}

impl Expression {
    /// A force with its derivatives in position and velocity as a function of these, for values of time and
    /// parameters; if `false` is given, the force alone. `None` without formulas.
    pub(crate) fn hold_slopes<'a, S: Scalar>(
        &'a self,
        others: &[S],
    ) -> Option<impl FnMut(&[&S], bool) -> [S; 3] + use<'a, S>> {
        let ForceDerivatives { slopes, .. } = &**self.1.as_ref()?;
        let mut list: Vec<S> = slopes.held(others);
        Some(move |moving: &[&S], wanted: bool| {
            slopes.run_rest(if wanted { 3 } else { 1 }, moving, &mut list);
            [0, 1, 2].map(|index| *slopes.rest_result(index, moving, &list))
        })
    }

    /// Writes a force with all its derivatives, or those of first order alone, those that are zero everywhere apart;
    /// returns whether there are formulas for them.
    pub(crate) fn partials<S: Scalar>(
        &self,
        at: &[S; VARIABLES],
        second: bool,
        Partials(partials): &mut Partials<S>,
    ) -> bool {
        let Some(formulas) = &self.1 else { return false };
        let ForceDerivatives { all: Tape { whole, .. }, places, first_order, .. } = &**formulas;
        let results = if second { places.len() } else { *first_order };
        let count = whole.needed_for(results, VARIABLES);
        with_space(count, |list| {
            whole.run(0..count, at, VARIABLES, (list, 0));
            for (place, slot) in places.iter().zip(&whole.results).take(results) {
                partials[*place] = *value(*slot, at, VARIABLES, list);
            }
        });
        true
    }
}
