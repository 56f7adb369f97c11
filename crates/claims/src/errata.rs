//! `ERRATA.md`: the differences between print and mathematics, with the computations that decide them.

use askama::Template;

use crate::audit::{ClaimVerdict, Finding};
use crate::ledger::{Claim, Ledger, Misprint, MisprintKind};
use crate::outcome::{Measure, Outcome};

/// The kinds of misprints in the order of the page, with their headings.
const KINDS: [(MisprintKind, &str); 4] = [
    (MisprintKind::Formula, "Formulas, conditions and statements"),
    (MisprintKind::Observation, "An observation that does not hold"),
    (MisprintKind::Judged, "Missing or imprecise conditions and steps"),
    (MisprintKind::Wording, "Notation and wording"),
];

#[derive(Template)]
#[template(path = "errata.md", escape = "none")]
struct Page<'a> {
    sections: [(&'static str, Vec<Entry<'a>>); 4],
}

/// A misprint, with other places where it occurs.
struct Entry<'a> {
    number: usize,
    found: Found<'a>,
    others: Vec<Found<'a>>,
}

/// A misprint in one place.
#[derive(Clone)]
struct Found<'a> {
    claim: &'a Claim,
    misprint: &'a Misprint,
    /// The outcome that measured the print and its correction, with descriptions of both measurements.
    measured: Option<(&'a Outcome, [(String, String); 2])>,
}

impl<'a> Found<'a> {
    fn of(finding: &'a Finding<'_>) -> Option<Self> {
        let measured = match &finding.verdict {
            ClaimVerdict::Measured(outcome) => outcome.print.as_ref().zip(Some(outcome)),
            _ => None,
        };
        let measured = measured.map(|(print, outcome)| (outcome, [words(print), words(&outcome.measure)]));
        Some(Self { claim: finding.claim, misprint: finding.claim.misprint.as_ref()?, measured })
    }
}

/// The page, from the findings of the whole ledger.
///
/// # Panics
/// Never: writing to a string cannot fail.
pub fn page(findings: &[Finding<'_>]) -> String {
    let all: Vec<Found<'_>> = findings.iter().filter_map(Found::of).collect();
    let mut numbers = 1..;
    let sections = KINDS.map(|(kind, heading)| {
        let first =
            all.iter().filter(|found| found.misprint.kind == kind && found.misprint.same_as.is_none());
        let entries = first.zip(&mut numbers).map(|(found, number)| {
            let same = |other: &&Found<'_>| other.misprint.same_as.as_ref() == Some(&found.claim.label);
            Entry { number, found: found.clone(), others: all.iter().filter(same).cloned().collect() }
        });
        (heading, entries.collect())
    });
    Page { sections }.render().expect("writing to a string cannot fail")
}

/// The number of entries of the page: a misprint that stands in several places is one.
pub fn count(ledger: &Ledger) -> usize {
    ledger
        .claims
        .iter()
        .filter_map(|claim| claim.misprint.as_ref())
        .filter(|misprint| misprint.same_as.is_none())
        .count()
}

/// A measurement in words: the measured quantity, and the value that it is compared with.
pub fn words(measure: &Measure) -> (String, String) {
    match *measure {
        Measure::Deviation { largest, tolerance } => {
            let nothing = largest.is_nan();
            let measured = if nothing { "no number".to_owned() } else { format!("deviation {largest:.1e}") };
            (measured, format!("at most {tolerance:.0e}"))
        }
        Measure::Order { observed, stated, slack } => {
            let unseen = observed.is_infinite();
            let measured =
                if unseen { "remainder below rounding".to_owned() } else { format!("order {observed:.2}") };
            (measured, format!("order {stated} − {slack}"))
        }
        Measure::Margin { smallest } => (format!("margin {smallest:.1e}"), "above 0".to_owned()),
        Measure::Agreement { agreeing, cases } => (format!("{agreeing} of {cases} cases"), "all".to_owned()),
    }
}
