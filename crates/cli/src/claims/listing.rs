//! Findings as lines on the terminal.

use grazing_claims::audit::{ClaimVerdict, Finding};
use grazing_claims::errata;
use grazing_report::Counts;

use crate::layout::Layout;

/// The verdicts as a table, with what is known about each claim under those that fail, or under all.
pub(super) fn table(layout: Layout, findings: &[Finding<'_>], explain: bool, coloured: bool) -> String {
    let row = |finding: &Finding<'_>| {
        let claim = finding.claim;
        let (word, measured, against) = words(&finding.verdict);
        let word = if coloured { paint(&finding.verdict, word) } else { word.to_owned() };
        let time = if finding.time.is_zero() {
            String::new()
        } else {
            format!("{:.1}", 1e3 * finding.time.as_secs_f64())
        };
        vec![word, claim.label.clone(), claim.kind.name().to_owned(), measured, against, time]
    };
    let header = ["<verdict", "<label", "<kind", "<measured", "<compared with", "time (ms)"];
    let text = layout.aligned(&header, findings.iter().map(row));
    if !explain && findings.iter().all(|finding| !finding.verdict.fails()) {
        return text;
    }
    let is_explained = |finding: &&Finding<'_>| explain || finding.verdict.fails();
    let explanations = findings.iter().filter(is_explained).map(|finding| explained(layout, finding));
    explanations.fold(text, |text, more| text + &more)
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
        ClaimVerdict::Numbers(numbers) | ClaimVerdict::Given(numbers) => {
            let computed = numbers.iter().map(|number| match number.computed {
                Some(computed) => format!("{computed:.6}"),
                None => "not computed".to_owned(),
            });
            let printed = numbers.iter().map(|number| number.published.printed.clone());
            let list = |items: Vec<String>| items.join(", ");
            let word = match verdict {
                verdict if verdict.fails() => "FAILS",
                ClaimVerdict::Given(_) => "parameter",
                _ => "holds",
            };
            (word, list(computed.collect()), list(printed.collect()))
        }
        ClaimVerdict::Unchecked(_) => ("unchecked", String::new(), String::new()),
    }
}

/// The paragraph about a claim: its place, its statement, its samples, and the code that tests it.
fn explained(layout: Layout, finding: &Finding<'_>) -> String {
    let claim = finding.claim;
    let mut lines = vec![format!("{}: {}", claim.place, claim.says)];
    lines.extend(claim.formula.iter().map(|formula| formula.trim().to_owned()));
    match &finding.verdict {
        ClaimVerdict::Measured(outcome) => {
            lines.push(format!("samples: {}, {}", outcome.samples, outcome.over));
            lines.extend(outcome.print.iter().map(|print| {
                let (measured, against) = errata::words(print);
                format!("as printed: {measured}, compared with {against}")
            }));
        }
        ClaimVerdict::Broken(reason) => lines.push(format!("could not be computed: {reason}")),
        ClaimVerdict::Unchecked(reason) => lines.push(format!("unchecked: {reason}")),
        ClaimVerdict::Given(_) => {
            lines.push("parameters that the paper chooses and the computation begins with".to_owned());
        }
        ClaimVerdict::Numbers(_) => {}
    }
    if let Some(misprint) = &claim.misprint {
        lines.push(format!("printed: {}", misprint.printed.trim()));
        lines.push(format!("corrected: {}", misprint.corrected.trim()));
    }
    if !claim.holds.is_empty() {
        lines.push(format!("computed by: {}", claim.holds.join(", ")));
    }
    lines.extend(claim.check_name().map(|check| format!("checked by: grazing_claims::checks::{check}")));
    if !claim.figures.is_empty() {
        lines.push(format!("shown in: {}", claim.figures.join(", ")));
    }
    let lines: String = lines.iter().map(|line| layout.wrapped("    ", line)).collect();
    format!("\n{}\n{lines}", claim.label)
}

fn paint(verdict: &ClaimVerdict, word: &str) -> String {
    let colour = match verdict {
        verdict if verdict.fails() => "1;31",
        ClaimVerdict::Given(_) | ClaimVerdict::Unchecked(_) => "2",
        ClaimVerdict::Measured(outcome) if outcome.print.is_some() => "33",
        _ => "32",
    };
    format!("\x1b[{colour}m{word}\x1b[0m")
}

/// The line of counts at the end.
pub(super) fn summary(findings: &[Finding<'_>]) -> String {
    let Counts { passed, failed, given, unchecked, errata, .. } = Counts::of(&[], findings);
    let errata = if errata == 1 { "1 erratum".to_owned() } else { format!("{errata} errata") };
    format!(
        "\n{}: {passed} hold ({errata}), {failed} fail, {given} give parameters, {unchecked} cannot be tested by a \
         computation.\n",
        if findings.len() == 1 { "1 claim".to_owned() } else { format!("{} claims", findings.len()) }
    )
}
