//! Proofs, in ball arithmetic over integers, of Figure 7's results for the paper's oscillator.
//!
//! For motion with one impact in p periods, everything but one number has a closed form; this number, the
//! velocity up to which motion does not touch the wall between impacts, is enclosed. [`prove`] divides
//! the window into intervals of `nu = omega_1/omega` and proves for each a statement that holds
//! throughout it, with witnesses; `expected/certificate/check.py` checks them with independent formulas.
//! `docs/proof.md` has the theorem, the lemma, and the assumptions.

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

use row::{Base, CertificateRow, Interval};
use search::rows;
use statement::Statement;

/// The initial intervals of nu have width `2^-COARSEST`.
const COARSEST: u32 = 6;

/// The intervals that cover the window, in order, each with the proved statement. `begin` receives the
/// number of parts first, and `step` is called when one of them is done. Once `stopped`, nothing more is
/// tried: the rest is undecided.
pub fn prove(
    statement: &Statement,
    begin: impl Fn(u64),
    step: impl Fn() + Sync,
    stopped: impl Fn() -> bool + Sync,
) -> Vec<CertificateRow> {
    let [lowest, highest] =
        statement.frequency.map(|frequency| statement.oscillator.omega_1_over(frequency.ball()));
    let parts = libm::scalbn(1.0, COARSEST as i32);
    let first = libm::floor(highest.bottom().to_f64() * parts) as i64;
    let end = libm::ceil(lowest.top().to_f64() * parts) as i64;
    // One part more at either end costs little, and rules out gaps due to rounding.
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
            let rows = rows(statement, interval, &stopped);
            step();
            rows
        })
        .collect()
}
