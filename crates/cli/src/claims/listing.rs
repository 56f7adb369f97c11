//! Findings as lines on the terminal.

use std::fmt::Write;

use grazing_claims::audit::{ClaimVerdict, Finding};
use grazing_claims::errata;
use grazing_report::Counts;

/// The width of the column of labels.
const LABEL: usize = 38;

/// The verdicts, one line each, with details of claims that fail, or of all if `explain` is set.
pub(super) fn table(findings: &[Finding<'_>], explain: bool, coloured: bool) -> String {
    let mut text = String::new();
    for finding in findings {
        let claim = finding.claim;
        let (word, measured, against) = words(&finding.verdict);
        let word = format!("{word:9}");
        let word = if coloured { paint(&finding.verdict, &word) } else { word };
        let time = if finding.time.is_zero() {
            String::new()
        } else {
            format!("{:7.1} ms", 1e3 * finding.time.as_secs_f64())
        };
        let kind = claim.kind.name();
        let line = format!("{word} {:LABEL$} {kind:10} {measured:28} {against:18} {time:>10}", claim.label);
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{}", line.trim_end());
        if explain || finding.verdict.fails() {
            text.push_str(&explained(finding));
        }
    }
    text
}

fn words(verdict: &ClaimVerdict) -> (&'static str, String, String) {
    match verdict {
        ClaimVerdict::Measured(outcome) => {
            let (measured, against) = errata::words(&outcome.measure);
            let word = match (outcome.passes(), outcome.print.is_some()) {
                (true, false) => "holds",
                (true, true) => "corrected",
                (false, _) => "FAILS",
            };
            (word, measured, against)
        }
        ClaimVerdict::Broken(_) => ("BROKEN", "could not be computed".to_owned(), String::new()),
        ClaimVerdict::Numbers(numbers) => {
            let computed = numbers.iter().map(|number| match number.computed {
                Some(computed) => format!("{computed:.6}"),
                None => "not computed".to_owned(),
            });
            let printed = numbers.iter().map(|number| number.published.printed.clone());
            let list = |items: Vec<String>| items.join(", ");
            let word = if verdict.fails() { "FAILS" } else { "holds" };
            (word, list(computed.collect()), list(printed.collect()))
        }
        ClaimVerdict::Unchecked(_) => ("unchecked", String::new(), String::new()),
    }
}

/// The details under a claim: its place in the paper, its statement, the samples tested, and the code.
fn explained(finding: &Finding<'_>) -> String {
    let claim = finding.claim;
    let mut lines = vec![format!("{}: {}", claim.place, claim.says)];
    lines.extend(claim.formula.iter().map(|formula| formula.trim().to_owned()));
    match &finding.verdict {
        ClaimVerdict::Measured(outcome) => {
            lines.push(format!("looked at: {} samples: {}", outcome.samples, outcome.over));
            lines.extend(outcome.print.iter().map(|print| {
                let (measured, against) = errata::words(print);
                format!("as printed: {measured}, held against {against}")
            }));
        }
        ClaimVerdict::Broken(reason) => lines.push(format!("broken: {reason}")),
        ClaimVerdict::Unchecked(reason) => lines.push(format!("unchecked: {reason}")),
        ClaimVerdict::Numbers(_) => {}
    }
    if let Some(misprint) = &claim.misprint {
        lines.push(format!("printed: {}", misprint.printed.trim()));
        lines.push(format!("corrected: {}", misprint.corrected.trim()));
    }
    if !claim.holds.is_empty() {
        lines.push(format!("held by: {}", claim.holds.join(", ")));
    }
    lines.extend(claim.check_name().map(|check| format!("checked by: grazing_claims::checks::{check}")));
    if !claim.figures.is_empty() {
        lines.push(format!("shown in: {}", claim.figures.join(", ")));
    }
    lines.iter().map(|line| format!("          {line}\n")).collect()
}

fn paint(verdict: &ClaimVerdict, word: &str) -> String {
    let colour = match verdict {
        verdict if verdict.fails() => "1;31",
        ClaimVerdict::Unchecked(_) => "2",
        ClaimVerdict::Measured(outcome) if outcome.print.is_some() => "33",
        _ => "32",
    };
    format!("\x1b[{colour}m{word}\x1b[0m")
}

/// The line of counts at the end.
pub(super) fn summary(findings: &[Finding<'_>]) -> String {
    let Counts { passed, failed, unchecked, misprints, .. } = Counts::of(&[], findings);
    format!(
        "\n{} claims: {passed} hold ({misprints} of them not as printed), {failed} fail, {unchecked} cannot be tested by a \
         computation.\n",
        findings.len()
    )
}
