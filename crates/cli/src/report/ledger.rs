//! Claims and what came of them, as the page shows them.

use grazing_claims::audit::{Finding, PrintedNumber, Verdict as Found};
use grazing_claims::ledger::Misprint;
use grazing_claims::outcome::Measure;
use grazing_claims::source::{Place, Sources};
use grazing_report::{ClaimEntry, Measured, MisprintEntry, PublishedEntry, Source, Verdict};

/// The finding as the page shows it.
pub(crate) fn entry(finding: &Finding<'_>, published: &[PublishedEntry], sources: &Sources) -> ClaimEntry {
    let claim = finding.claim;
    ClaimEntry {
        label: claim.label.clone(),
        place: claim.place.clone(),
        kind: claim.kind.to_string(),
        says: claim.says.clone(),
        formula: claim.formula.clone(),
        holds: claim.holds.iter().map(|path| source(path, sources.item(path))).collect(),
        check: claim.check_name().map(|name| source(name, sources.check(name))),
        figures: claim.figures.clone(),
        verdict: verdict(&finding.verdict, published),
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
        typographic: misprint.measured() == Some(false),
    }
}

fn verdict(found: &Found, published: &[PublishedEntry]) -> Verdict {
    match found {
        Found::Measured(outcome) => Verdict::Checked {
            passed: outcome.passes(),
            measured: measured(outcome.measure),
            print: outcome.print.map(measured),
            samples: outcome.samples,
            over: outcome.over.clone(),
        },
        Found::Broken(error) => Verdict::Failed { error: error.clone() },
        Found::Numbers(numbers) => Verdict::Published { values: values(numbers, published) },
        Found::Unchecked(reason) => Verdict::Unchecked { reason: reason.clone() },
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

/// The published values that a claim names.
fn values(numbers: &[PrintedNumber], published: &[PublishedEntry]) -> Vec<PublishedEntry> {
    let named = |number: &PrintedNumber| published.iter().find(|entry| entry.id == number.id).cloned();
    numbers.iter().filter_map(named).collect()
}
