//! Proofs, in ball arithmetic over integers, of what Figure 7 shows of the paper's oscillator.
//!
//! For motion with one impact in p periods everything but one number is in closed form; that one,
//! the velocity up to which motion stays off the wall between impacts, is enclosed. [`prove`] cuts
//! the window into intervals of `nu = omega_1/omega` and finds for each what holds in all of it, with
//! witnesses; `expected/certificate/check.py` checks them with formulas of its own. `docs/proof.md` has
//! theorem, lemma, and what is trusted.

pub mod ball;
pub mod certificate;
pub mod orbit;
pub mod proof;
pub mod resonance;
pub mod row;
pub mod search;
pub mod series;
pub mod statement;
pub mod summary;

use rayon::prelude::*;

use row::{Base, Interval, Row};
use search::rows;
use statement::Statement;

/// Intervals of nu have width `2^-COARSEST` at first.
const COARSEST: u32 = 6;

/// How many intervals are tried within one of the coarsest at most. Figure 7 needs less than a quarter.
const MOST_TRIED: usize = 6_000;

/// The intervals that cover the window, in order, with what is proved of each. `step` is called when
/// one of so many parts is done; `begin` is told before how many there are.
pub fn prove(statement: &Statement, begin: impl Fn(u64), step: impl Fn() + Sync) -> Vec<Row> {
    let [lowest, highest] =
        statement.frequency.map(|frequency| statement.oscillator.omega_1_over(frequency.ball()));
    let parts = libm::scalbn(1.0, COARSEST as i32);
    let first = libm::floor(highest.bottom().to_f64() * parts) as i64;
    let end = libm::ceil(lowest.top().to_f64() * parts) as i64;
    // One part more at either end costs little, and no rounding can leave a gap.
    let intervals: Vec<Interval> = statement
        .loops
        .iter()
        .flat_map(|&p| (first.max(2) - 1..=end).map(move |left| (p, left)))
        .map(|(p, left)| Interval { p: p.into(), left, level: COARSEST, base: Base::Middle })
        .collect();
    begin(intervals.len() as u64);
    intervals
        .into_par_iter()
        .flat_map_iter(|interval| {
            let rows = rows(statement, interval, &mut MOST_TRIED.clone());
            step();
            rows
        })
        .collect()
}
