//! The ledger of claims on the page.

use std::collections::BTreeMap;

use askama::filters::Safe;
use grazing_claims::audit::{ClaimVerdict, Finding};
use grazing_claims::errata;
use grazing_claims::ledger::Claim;
use grazing_claims::outcome::Measure;
use grazing_claims::source::Location;
use grazing_results::Scientific;

use crate::html::{Html, escape, identifier, power};
use crate::report::Report;

/// The state of a claim after the tests.
pub(crate) fn state(verdict: &ClaimVerdict) -> &'static str {
    match verdict {
        ClaimVerdict::Unchecked(_) => "unchecked",
        verdict if verdict.fails() => "failed",
        ClaimVerdict::Given(_) => "parameter",
        _ => "passed",
    }
}

/// The part of the paper that contains a claim: its place up to the first comma.
pub(crate) fn part(place: &str) -> &str {
    place.split([',', ';']).next().unwrap_or(place).trim()
}

/// A link to a claim.
pub(crate) fn link(label: &str) -> Html {
    let id = escape(&identifier("claim", label));
    Safe(format!("<a href=\"#{id}\"><code>{}</code></a>", escape(label)))
}

/// A way to filter the claims: name, title, and values with the words for them.
type Filter<'a> = (&'static str, &'static str, Vec<(&'a str, &'a str)>);

/// By what the claims can be filtered.
pub(crate) fn filters<'a>(report: &'a Report<'_>) -> [Filter<'a>; 3] {
    let kinds = distinct(report.claims.iter().map(|finding| finding.claim.kind.name()));
    let parts = distinct(report.claims.iter().map(|finding| part(&finding.claim.place)));
    let states = [
        ("passed", "passed"),
        ("failed", "failed"),
        ("parameter", "parameter"),
        ("unchecked", "unchecked"),
        ("misprint", "erratum"),
    ];
    let own = |words: Vec<&'a str>| words.into_iter().map(|word| (word, word)).collect();
    [("kind", "Kind", own(kinds)), ("part", "Section", own(parts)), ("state", "Verdict", states.into())]
}

/// The words in the order in which they first occur.
fn distinct<'a>(words: impl Iterator<Item = &'a str>) -> Vec<&'a str> {
    let mut distinct = Vec::new();
    for word in words {
        if !distinct.contains(&word) {
            distinct.push(word);
        }
    }
    distinct
}

/// A measurement with the value that it is compared with.
pub(crate) fn measured(measure: &Measure) -> Html {
    let raised = |value: f64, digits: usize| match Scientific::rounded(value, digits) {
        Scientific { mantissa, exponent } if value.is_finite() => {
            format!("{mantissa} × {}", power(exponent))
        }
        Scientific { mantissa, .. } => mantissa,
    };
    let (measured, against) = errata::words_with(measure, &raised);
    Safe(format!("<b>{measured}</b>, required: {against}"))
}

/// Links to source files and figures, with a word before each kind.
pub(crate) fn references(report: &Report<'_>, claim: &Claim) -> [(&'static str, Vec<Html>); 3] {
    let sources = &report.sources;
    let held = claim.holds.iter().map(|name| source_link(report, name, sources.item(name))).collect();
    let tested = claim.check_name().map(|name| source_link(report, name, sources.check(name)));
    let seen = claim.figures.iter().map(|name| figure_link(report, name)).collect();
    [("Computed by", held), ("Tested by", tested.into_iter().collect()), ("Shown in", seen)]
}

fn figure_link(report: &Report<'_>, name: &str) -> Html {
    Safe(match report.paper_figures().find(|figure| figure.name == name) {
        Some(figure) => {
            let short = figure.title.before().unwrap_or_else(|| name.to_owned());
            format!("<a href=\"#{}\">{}</a>", escape(name), escape(&short))
        }
        None => escape(name),
    })
}

/// The item's name, as a link to its file if that is known.
fn source_link(report: &Report<'_>, name: &str, place: Option<Location>) -> Html {
    let name = format!("<code>{}</code>", escape(name).replace("::", "::<wbr>"));
    let Some(Location { file, line }) = place else { return Safe(name) };
    let file = escape(&file);
    Safe(match &report.root {
        Some(root) => {
            format!("<a href=\"{}{file}#L{line}\" title=\"{file}, line {line}\">{name}</a>", escape(root))
        }
        None => format!("<span title=\"{file}, line {line}\">{name}</span>"),
    })
}

/// The labels of claims by source file.
pub(crate) fn by_file<'a>(report: &'a Report<'_>) -> BTreeMap<String, Vec<&'a str>> {
    let mut files: BTreeMap<String, Vec<&str>> = BTreeMap::new();
    for Finding { claim, .. } in &report.claims {
        let held = claim.holds.iter().filter_map(|name| report.sources.item(name));
        let tested = claim.check_name().and_then(|name| report.sources.check(name));
        for place in held.chain(tested) {
            let labels = files.entry(place.file).or_default();
            if labels.last() != Some(&claim.label.as_str()) {
                labels.push(&claim.label);
            }
        }
    }
    files
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_place_begins_with_its_part() {
        assert_eq!(part("section 2.4, eq. (15)"), "section 2.4");
        assert_eq!(part("caption of Figure 8"), "caption of Figure 8");
    }

    #[test]
    fn measurements_stand_beside_what_is_required_of_them() {
        for (measure, shown) in [
            (
                Measure::Deviation { largest: 3.14e-15, tolerance: 1e-12 },
                "<b>deviation 3.1 × 10<sup>−15</sup></b>, required: at most 1 × 10<sup>−12</sup>",
            ),
            (
                Measure::Order { observed: 2.1, stated: 2.0, slack: 0.3 },
                "<b>order 2.10</b>, required: order 2 − 0.3",
            ),
        ] {
            assert_eq!(measured(&measure).0, shown);
        }
    }
}
