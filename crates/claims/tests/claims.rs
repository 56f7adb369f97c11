//! Runs each claim with a check as a test of its own, named by its label:
//! `cargo test -p grazing-claims --test claims -- eq:alpha`.
//!
//! If labels are given only these are run, otherwise all.
#![expect(clippy::print_stdout, reason = "a test harness says what it does")]

use std::process::ExitCode;

use grazing_claims::audit::{ClaimVerdict, Finding, audit};
use grazing_claims::ledger::{Claim, Ledger, Test};

/// The failure of a claim, if any: its check fails, or the check did not decide a misprint that has
/// values.
fn wrong(finding: &Finding<'_>) -> Option<String> {
    let has_print = finding.claim.misprint.as_ref().map_or(Some(false), |misprint| misprint.measured());
    let decided = matches!(&finding.verdict,
        ClaimVerdict::Measured(outcome) if has_print.is_none_or(|has_print| outcome.print.is_some() == has_print));
    (finding.verdict.fails() || !decided).then(|| format!("{:?}", finding.verdict))
}

fn main() -> ExitCode {
    let labels: Vec<String> =
        std::env::args().skip(1).filter(|argument| !argument.starts_with('-')).collect();
    let ledger = Ledger::of_the_paper();
    let asked = |claim: &&Claim| {
        matches!(claim.test(), Test::Check(_)) && (labels.is_empty() || labels.contains(&claim.label))
    };
    let claims: Vec<&Claim> = ledger.claims.iter().filter(asked).collect();
    if std::env::args().any(|argument| argument == "--list") {
        claims.iter().for_each(|claim| println!("{}: test", claim.label));
        return ExitCode::SUCCESS;
    }
    let mut failures = 0;
    for finding in audit(&claims, &[], || {}) {
        let wrong = wrong(&finding);
        println!("test {} ... {}", finding.claim.label, if wrong.is_some() { "FAILED" } else { "ok" });
        if let Some(reason) = wrong {
            println!("    {reason}");
            failures += 1;
        }
    }
    println!("\ntest result: {} claims, {failures} failed", claims.len());
    if failures > 0 || claims.is_empty() { ExitCode::FAILURE } else { ExitCode::SUCCESS }
}
