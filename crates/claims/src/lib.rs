//! The ledger of claims: what the paper states, label by label, and the checks that test each statement.
//!
//! `expected/claims.toml` lists every numbered equation, lemma, proposition, theorem and every number in text and captions
//! ([`ledger`]). Most name a check, a function here that measures how well the statement holds ([`outcome`]): the largest
//! deviation of an identity over its domain, the order at which a remainder vanishes, the smallest margin of an inequality
//! under adversarial search, the cases in which a theorem's conclusion is seen in the hybrid system. Where print and
//! mathematics differ, the check holds the print too, and passes only if the print fails.
//!
//! Expansions and theorems are measured on the paper's oscillator and on others, with nonlinear forces and reset laws that vary (`specimen`).
//!
//! Nothing here reads files or prints; sampling is seeded, so every run measures the same.

pub mod audit;
pub mod checks;
mod convergence;
mod differences;
mod eigenvalues;
pub mod errata;
pub mod ledger;
pub mod outcome;
pub mod published;
mod sampling;
mod solutions;
pub mod source;
mod specimen;
pub mod sweep;
mod tally;

use convergence::order;
use outcome::{CheckResult, Failure, Measure, Outcome};
use published::{printed, printed_at_resonances};
use sampling::{Sampler, drawn, sampled, smallest};
use tally::{Deviations, Smallest, Votes};
