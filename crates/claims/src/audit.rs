//! Runs the checks of claims and collects the results.

use std::collections::BTreeMap;
use std::time::{Duration, Instant};

use rayon::prelude::*;

use crate::ledger::{Claim, Test};
use crate::outcome::Outcome;
use crate::published::PublishedComparison;

/// The result of testing a claim.
#[derive(Debug, Clone, PartialEq)]
pub enum ClaimVerdict<'a> {
    /// The outcome measured by a check.
    Measured(Outcome),
    /// The check could not be carried out, for this reason.
    Broken(String),
    /// Printed numbers, compared with the computed ones.
    Numbers(Vec<PublishedComparison<'a>>),
    /// Parameters that the paper chooses, with those of the computation.
    Given(Vec<PublishedComparison<'a>>),
    /// The claim cannot be tested by computation, for this reason.
    Unchecked(String),
}

impl ClaimVerdict<'_> {
    /// Whether the result counts as a failure.
    pub fn fails(&self) -> bool {
        match self {
            Self::Measured(outcome) => !outcome.passes(),
            Self::Broken(_) => true,
            Self::Numbers(numbers) | Self::Given(numbers) => {
                numbers.is_empty() || numbers.iter().any(|number| !number.is_met())
            }
            Self::Unchecked(_) => false,
        }
    }
}

/// A claim with its verdict.
#[derive(Debug, Clone, PartialEq)]
pub struct Finding<'a> {
    /// The claim.
    pub claim: &'a Claim,
    /// The result of testing the claim.
    pub verdict: ClaimVerdict<'a>,
    /// The time that the check took; claims with the same check share one run.
    pub time: Duration,
}

/// Tests the claims, running each check once, in parallel; the findings are in the order of the claims.
///
/// Numbers are taken from `published`; `done` is called after each check.
pub fn audit<'a>(
    claims: &[&'a Claim],
    published: &[PublishedComparison<'a>],
    done: impl Fn() + Sync,
) -> Vec<Finding<'a>> {
    let mut checks = BTreeMap::new();
    for claim in claims {
        if let Test::Check(check) = claim.test() {
            checks.insert(check.name, check.run);
        }
    }
    let runs: Vec<_> = checks.into_iter().collect();
    let measured: BTreeMap<_, _> = runs
        .par_iter()
        .map(|(name, run)| {
            let start = Instant::now();
            let verdict = match run() {
                Ok(outcome) => ClaimVerdict::Measured(outcome),
                Err(error) => ClaimVerdict::Broken(error.to_string()),
            };
            done();
            (*name, (verdict, start.elapsed()))
        })
        .collect();
    let find = |claim: &'a Claim| {
        let (verdict, time) = match claim.test() {
            Test::Check(check) => measured[check.name].clone(),
            Test::Unchecked(reason) => (ClaimVerdict::Unchecked(reason.to_owned()), Duration::ZERO),
            Test::Published(ids) | Test::Given(ids) => {
                let number =
                    |id: &String| published.iter().find(|number| number.published.id == *id).copied();
                let numbers: Option<Vec<_>> = ids.iter().map(number).collect();
                let unknown =
                    || ClaimVerdict::Broken(format!("{ids:?} is not all in expected/published.toml"));
                let verdict = match claim.test() {
                    Test::Given(_) => ClaimVerdict::Given,
                    _ => ClaimVerdict::Numbers,
                };
                (numbers.map_or_else(unknown, verdict), Duration::ZERO)
            }
        };
        Finding { claim, verdict, time }
    };
    claims.iter().map(|claim| find(claim)).collect()
}
