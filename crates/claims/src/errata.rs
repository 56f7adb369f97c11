//! `ERRATA.md`: the differences between print and mathematics, with the computations that decide them.

use std::collections::BTreeSet;

use askama::Template;

use crate::audit::{ClaimVerdict, Finding};
use crate::ledger::{Claim, Misprint, MisprintKind};
use crate::outcome::{Measure, Outcome};

/// The kinds of misprints in the order of the page, with their headings.
const KINDS: [(MisprintKind, &str); 4] = [
    (MisprintKind::Observation, "Statements that do not hold"),
    (MisprintKind::Formula, "Formulas and conditions"),
    (MisprintKind::Judged, "Missing or imprecise conditions and steps"),
    (MisprintKind::Wording, "Notation and wording"),
];

#[derive(Template)]
#[template(path = "errata.md", escape = "none")]
struct Page<'a> {
    sections: [ErrataSection<'a>; 4],
}

/// The errata of one kind.
pub struct ErrataSection<'a> {
    /// The heading.
    pub heading: &'static str,
    /// The errata, in the order of the paper.
    pub entries: Vec<Entry<'a>>,
}

/// A misprint, with other places where it occurs.
pub struct Entry<'a> {
    /// The number of the erratum.
    pub number: usize,
    /// The place where it is described.
    pub found: FoundMisprint<'a>,
    /// The other places.
    pub others: Vec<FoundMisprint<'a>>,
}

impl<'a> Entry<'a> {
    /// All places where the misprint occurs; the first is where it is described.
    pub fn places(&self) -> impl Iterator<Item = &FoundMisprint<'a>> {
        core::iter::once(&self.found).chain(&self.others)
    }
}

/// A misprint in one place.
#[derive(Clone)]
pub struct FoundMisprint<'a> {
    /// The claim.
    pub claim: &'a Claim,
    /// The misprint.
    pub misprint: &'a Misprint,
    /// The outcome that measured the print and its correction.
    pub measured: Option<&'a Outcome>,
}

impl<'a> FoundMisprint<'a> {
    fn of(finding: &'a Finding<'_>) -> Option<Self> {
        let measured = match &finding.verdict {
            ClaimVerdict::Measured(outcome) => Some(outcome).filter(|outcome| outcome.print.is_some()),
            _ => None,
        };
        Some(Self { claim: finding.claim, misprint: finding.claim.misprint.as_ref()?, measured })
    }

    /// The measurements of the print and of its correction in words.
    fn words(&self) -> Option<[(String, String); 2]> {
        let outcome = self.measured?;
        Some([words(outcome.print.as_ref()?), words(&outcome.measure)])
    }
}

/// The errata among the findings, in the order of all pages that list them: the most substantial kind
/// first, and then in the order of the paper.
pub fn sections<'a>(findings: &'a [Finding<'_>]) -> [ErrataSection<'a>; 4] {
    let all: Vec<FoundMisprint<'_>> = findings.iter().filter_map(FoundMisprint::of).collect();
    let mut numbers = 1..;
    KINDS.map(|(kind, heading)| {
        let first =
            all.iter().filter(|found| found.misprint.kind == kind && found.misprint.same_as.is_none());
        let entries = first.zip(&mut numbers).map(|(found, number)| {
            let same =
                |other: &&FoundMisprint<'_>| other.misprint.same_as.as_ref() == Some(&found.claim.label);
            Entry { number, found: found.clone(), others: all.iter().filter(same).cloned().collect() }
        });
        ErrataSection { heading, entries: entries.collect() }
    })
}

/// The page, from the findings of the whole ledger.
///
/// # Panics
/// Never: writing to a string cannot fail.
pub fn page(findings: &[Finding<'_>]) -> String {
    Page { sections: sections(findings) }.render().expect("writing to a string cannot fail")
}

/// The number of errata among claims: one that occurs in several places is counted once.
pub fn count<'a>(claims: impl IntoIterator<Item = &'a Claim>) -> usize {
    let described = |claim: &'a Claim| {
        claim.misprint.as_ref().map(|misprint| misprint.same_as.as_ref().unwrap_or(&claim.label))
    };
    claims.into_iter().filter_map(described).collect::<BTreeSet<_>>().len()
}

/// A measurement in words: the measured quantity, and the value that it is compared with.
pub fn words(measure: &Measure) -> (String, String) {
    words_with(measure, &|value, digits| format!("{value:.*e}", digits - 1))
}

/// The same, with numbers of any magnitude as `scientific` writes them with so many digits.
pub fn words_with(measure: &Measure, scientific: &dyn Fn(f64, usize) -> String) -> (String, String) {
    match *measure {
        Measure::Deviation { largest, tolerance } => {
            let nothing = largest.is_nan();
            let measured = if nothing {
                "no number".to_owned()
            } else {
                format!("deviation {}", scientific(largest, 2))
            };
            (measured, format!("at most {}", scientific(tolerance, 1)))
        }
        Measure::Order { observed, stated, slack } => {
            let unseen = observed.is_infinite();
            let measured =
                if unseen { "remainder below rounding".to_owned() } else { format!("order {observed:.2}") };
            (measured, format!("order {stated} − {slack}"))
        }
        Measure::Margin { smallest } => (format!("margin {}", scientific(smallest, 2)), "above 0".to_owned()),
        Measure::Agreement { agreeing, cases } => (format!("{agreeing} of {cases} cases"), "all".to_owned()),
    }
}
