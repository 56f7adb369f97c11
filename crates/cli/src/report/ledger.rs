//! The ledger with what came of every claim.

use std::collections::BTreeMap;

use grazing_claims::checks::Check;
use grazing_claims::ledger::{Claim, Ledger, Misprint, Test};
use grazing_claims::outcome::{CheckResult, Measure};
use grazing_claims::source::{Place, Sources};
use grazing_report::{ClaimEntry, Measured, MisprintEntry, PublishedEntry, Source, Verdict};
use grazing_reproduction::progress::Progress;
use rayon::prelude::*;

/// How the checks are called where progress is shown.
const WHAT: &str = "claims";

/// Tests every claim; the results do not depend on the number of threads.
pub(crate) fn entries(
    ledger: &Ledger,
    published: &[PublishedEntry],
    sources: &Sources,
    progress: &(dyn Progress + Sync),
) -> Vec<ClaimEntry> {
    // Several claims may share a check.
    let mut checks: Vec<&'static Check> = Vec::new();
    for claim in &ledger.claims {
        if let Test::Check(check) = claim.test()
            && !checks.iter().any(|known| known.name == check.name)
        {
            checks.push(check);
        }
    }
    progress.begin(WHAT, checks.len() as u64);
    let results: Vec<(&str, CheckResult)> = checks
        .par_iter()
        .map(|check| {
            let result = (check.run)();
            progress.step(WHAT);
            (check.name, result)
        })
        .collect();
    progress.end(WHAT);
    let results: BTreeMap<&str, CheckResult> = results.into_iter().collect();
    ledger
        .claims
        .iter()
        .map(|claim| {
            let (verdict, check) = match claim.test() {
                Test::Check(check) => {
                    let place = sources.check(check.name);
                    let verdict = results.get(check.name).map_or_else(not_run, checked);
                    (verdict, Some(source(check.name, place)))
                }
                Test::Published(ids) => (compared(ids, published), None),
                Test::Unchecked(reason) => (Verdict::Unchecked { reason: reason.to_owned() }, None),
            };
            entry(claim, verdict, check, sources)
        })
        .collect()
}

/// The claim as the page shows it.
fn entry(claim: &Claim, verdict: Verdict, check: Option<Source>, sources: &Sources) -> ClaimEntry {
    ClaimEntry {
        label: claim.label.clone(),
        place: claim.place.clone(),
        kind: claim.kind.to_string(),
        says: claim.says.clone(),
        formula: claim.formula.clone(),
        holds: claim.holds.iter().map(|path| source(path, sources.item(path))).collect(),
        check,
        figures: claim.figures.clone(),
        verdict,
        misprint: claim.misprint.as_ref().map(misprint),
    }
}

fn source(name: &str, place: Option<Place>) -> Source {
    Source { name: name.to_owned(), file: place.map(|place| (place.file, place.line)) }
}

fn misprint(misprint: &Misprint) -> MisprintEntry {
    MisprintEntry {
        printed: misprint.printed.clone(),
        corrected: misprint.corrected.clone(),
        reason: misprint.reason.clone(),
        decided: misprint.decided.clone(),
    }
}

fn not_run() -> Verdict {
    Verdict::Failed { error: "the check was not run".to_owned() }
}

fn checked(result: &CheckResult) -> Verdict {
    match result {
        Ok(outcome) => Verdict::Checked {
            passed: outcome.passes(),
            measured: measured(outcome.measure),
            print: outcome.print.map(measured),
            samples: outcome.samples,
            over: outcome.over.clone(),
        },
        Err(error) => Verdict::Failed { error: error.to_string() },
    }
}

fn measured(measure: Measure) -> Measured {
    match measure {
        Measure::Deviation { largest, tolerance } => Measured::Deviation { largest, tolerance },
        Measure::Order { observed, stated, slack } => Measured::Order { observed, stated, slack },
        Measure::Margin { smallest } => Measured::Margin { smallest },
        Measure::Agreement { agreeing, cases } => Measured::Agreement { agreeing, cases },
    }
}

/// The published values under these names; one that does not exist fails the claim.
fn compared(ids: &[String], published: &[PublishedEntry]) -> Verdict {
    let found = ids.iter().map(|id| published.iter().find(|entry| entry.id == *id).cloned().ok_or(id));
    match found.collect::<Result<Vec<_>, _>>() {
        Ok(values) => Verdict::Published { values },
        Err(id) => Verdict::Failed { error: format!("expected/published.toml has no value {id}") },
    }
}
