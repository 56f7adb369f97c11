//! Formulas for the derivatives of a force, on tapes of their own.
//!
//! Jets carry every derivative through every instruction, though most of them are zero in most: a tape of
//! formulas, which share their parts, computes a third of that.

use grazing_model::smooth::{Partials, Scalar, Stop, partial};

use super::graph::{Graph, Term};
use super::{Expression, Slot, Tape, assemble, value, with_space};

/// The largest number of instructions of a force that is differentiated, and of those of its derivatives
/// for each of its own, so that they take no longer than jets of as many derivatives (empirical).
const LONGEST: usize = 256;
const FOR_EACH: usize = 20;

/// The numbers of variables of a force: all, and those that move.
const VARIABLES: usize = 5;
const MOVING: usize = 2;

/// Formulas for the derivatives of a force.
#[derive(Debug, PartialEq)]
pub(super) struct Formulas {
    /// F, F_x and F_y; the number of instructions that F takes of those that move.
    slopes: Tape,
    value_alone: usize,
    /// F and its derivatives that are not zero everywhere, by increasing order, with the place of each.
    all: Tape,
    places: Vec<usize>,
    /// The number of those that are not of second order, and that of the instructions that they take.
    lower: [usize; 2],
}

/// The number of instructions, after values up to a slot, up to the last of some results.
fn instructions(results: &[Slot], before: usize) -> usize {
    results.iter().map(|slot| (slot + 1).saturating_sub(before)).max().unwrap_or(0)
}

impl Formulas {
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
        let first = partial(&[VARIABLES - 1]);
        all.retain(|(place, term)| *place == 0 || !matches!(term, Term::Number(0.0)));
        let (places, terms): (Vec<usize>, Vec<Term<'_>>) = all.into_iter().unzip();
        let (nodes, results) = graph.parts(&terms);
        let all = assemble::tape(variables, VARIABLES, &nodes, &results);
        if all.whole.instructions.len() > FOR_EACH * itself.instructions().max(1) {
            return None;
        }
        let (nodes, results) = graph.parts(&[force, slopes[0], slopes[1]]);
        let slopes = assemble::tape(variables, MOVING, &nodes, &results);
        let value_alone = instructions(&slopes.rest.results[..1], MOVING + slopes.needed.len());
        let lower = places.iter().filter(|place| **place <= first).count();
        let lower = [lower, instructions(&all.whole.results[..lower], VARIABLES)];
        Some(Self { slopes, value_alone, all, places, lower })
    }
}

impl Expression {
    /// A force with its derivatives in position and velocity as a function of these, for values of time and
    /// parameters; if `false` is given, the force alone. `None` without formulas.
    pub(crate) fn hold_slopes<'a, S: Scalar>(
        &'a self,
        others: &[S],
    ) -> Option<impl FnMut(&[&S], bool) -> [S; 3] + use<'a, S>> {
        let Formulas { slopes, value_alone, .. } = &**self.1.as_ref()?;
        let mut list: Vec<S> = slopes.held(others);
        Some(move |moving: &[&S], wanted: bool| {
            if !wanted {
                slopes.run_rest(*value_alone, moving, &mut list);
                return [*slopes.rest_result(0, moving, &list); 3];
            }
            slopes.run_rest(slopes.rest.instructions.len(), moving, &mut list);
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
        let Formulas { all: Tape { whole, .. }, places, lower: [results, count], .. } = &**formulas;
        let (results, count) =
            if second { (places.len(), whole.instructions.len()) } else { (*results, *count) };
        with_space(count, |list| {
            whole.run(0..count, at, VARIABLES, (list, 0));
            for (place, slot) in places.iter().zip(&whole.results).take(results) {
                partials[*place] = *value(*slot, at, VARIABLES, list);
            }
        });
        true
    }
}
