//! `ERRATA.md`: where the print and the mathematics differ, with the computation that decides it.

use std::fmt::Write;

use crate::audit::{ClaimVerdict, Finding};
use crate::ledger::{Misprint, MisprintKind};
use crate::outcome::{Measure, Outcome};

const HEAD: &str = "\
# Errata

Where the print of *Resonant grazing bifurcations revisited* (D.J.W. Simpson and I. Ghosh, arXiv 2602.22797) and the mathematics differ.
Made by `cargo xtask claims --write-errata` from `expected/claims.toml`. Where there is something to measure, a check computes both forms:
the printed one has to fail and the corrected one to hold. None of them touches Theorems 2.2 to 2.5; the first is in Proposition 3.3, the third in
Lemmas 5.1 and 5.2.
";

/// The kinds in the order of the page, with their headings.
const KINDS: [(MisprintKind, &str); 4] = [
    (MisprintKind::Formula, "Formulas, conditions and statements"),
    (MisprintKind::Observation, "An observation that is not so"),
    (MisprintKind::Judged, "Judged as printed"),
    (MisprintKind::Wording, "Notation and wording"),
];

/// The page, from the findings of the whole ledger.
pub fn page(findings: &[Finding<'_>]) -> String {
    let mut page = HEAD.to_owned();
    let misprints = findings.iter().filter_map(|finding| Some((finding, finding.claim.misprint.as_ref()?)));
    let mut number = 0;
    for (kind, heading) in KINDS {
        // Writing to a string cannot fail.
        let _ = write!(page, "\n## {heading}\n");
        for (finding, misprint) in misprints.clone().filter(|(_, m)| m.kind == kind && m.same_as.is_none()) {
            number += 1;
            let same = |other: &Misprint| other.same_as.as_ref() == Some(&finding.claim.label);
            let others: Vec<_> = misprints.clone().filter(|(_, other)| same(other)).collect();
            let _ = write!(page, "\n{}", entry(number, finding, misprint, &others));
        }
    }
    page
}

fn entry(
    number: usize,
    finding: &Finding<'_>,
    misprint: &Misprint,
    others: &[(&Finding<'_>, &Misprint)],
) -> String {
    let claim = finding.claim;
    let more = match others.len() {
        0 => String::new(),
        1 => ", and one more place".to_owned(),
        count => format!(", and {count} more places"),
    };
    let mut entry = format!("### {number}. {} (`{}`){more}\n\n", claim.place, claim.label);
    let _ = writeln!(entry, "Printed: {}\n", misprint.printed.trim());
    let _ = writeln!(entry, "Corrected: {}\n", misprint.corrected.trim());
    let _ = writeln!(entry, "{}\n", misprint.reason.trim());
    let _ = writeln!(entry, "Decided by: {}", misprint.decided.trim());
    if let ClaimVerdict::Measured(Outcome { measure, print: Some(print), over, samples }) = &finding.verdict {
        let _ = writeln!(entry, "\n| | measured | held against |\n|---|---|---|");
        for (form, measure) in [("as printed", print), ("corrected", measure)] {
            let (measured, against) = told(measure);
            let _ = writeln!(entry, "| {form} | {measured} | {against} |");
        }
        let _ = writeln!(entry, "\n({samples} samples: {over}.)");
    }
    if !others.is_empty() {
        let _ = writeln!(
            entry,
            "\nThe same in other places:\n\n| place | printed | corrected | measured as printed | corrected | held against |\n|---|---|---|---|---|---|"
        );
    }
    for (finding, misprint) in others {
        let [printed, corrected, against] = match &finding.verdict {
            ClaimVerdict::Measured(Outcome { measure, print: Some(print), .. }) => {
                let (corrected, against) = told(measure);
                [told(print).0, corrected, against]
            }
            _ => [(); 3].map(|()| "–".to_owned()),
        };
        let (place, label) = (&finding.claim.place, &finding.claim.label);
        let (from, to) = (misprint.printed.trim(), misprint.corrected.trim());
        let _ =
            writeln!(entry, "| {place} (`{label}`) | {from} | {to} | {printed} | {corrected} | {against} |");
    }
    entry
}

/// A measurement in words: what was measured, and what it is held against.
pub fn told(measure: &Measure) -> (String, String) {
    match *measure {
        Measure::Deviation { largest, tolerance } if largest.is_nan() => {
            ("no number".to_owned(), format!("at most {tolerance:.0e}"))
        }
        Measure::Deviation { largest, tolerance } => {
            (format!("deviation {largest:.1e}"), format!("at most {tolerance:.0e}"))
        }
        Measure::Order { observed, stated, slack } if observed.is_infinite() => {
            ("remainder below rounding".to_owned(), format!("order {stated} − {slack}"))
        }
        Measure::Order { observed, stated, slack } => {
            (format!("order {observed:.2}"), format!("order {stated} − {slack}"))
        }
        Measure::Margin { smallest } => (format!("margin {smallest:.1e}"), "above 0".to_owned()),
        Measure::Agreement { agreeing, cases } => (format!("{agreeing} of {cases} cases"), "all".to_owned()),
    }
}
