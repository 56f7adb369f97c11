//! The ledger of claims, as the page shows it.

use std::collections::BTreeMap;

use crate::formula::{prose, shown};
use crate::html::{counted, escape, identifier, put};
use crate::{ClaimEntry, Report, Source, Verdict};

/// The part of the paper that a claim stands in: its place up to the first comma.
pub(crate) fn part(place: &str) -> &str {
    place.split([',', ';']).next().unwrap_or(place).trim()
}

/// Links to claims.
pub(crate) fn links(labels: &[&str]) -> String {
    let link = |label: &&str| {
        format!("<a href=\"#{}\"><code>{}</code></a>", escape(&identifier("claim", label)), escape(label))
    };
    labels.iter().map(link).collect::<Vec<_>>().join(" ")
}

pub(crate) fn section(report: &Report) -> String {
    let claims = &report.claims;
    let mut html = String::from(
        "<section id=\"claims\" aria-labelledby=\"claims-title\">\n<h2 id=\"claims-title\">Claims</h2>\n\
         <p class=\"lead\">Every numbered equation, lemma, proposition and theorem of the paper and every number in its text and \
         captions, with the function that holds it and the computation that tests it.</p>\n",
    );
    if claims.is_empty() {
        html.push_str("<p>The ledger is empty.</p>\n</section>\n");
        return html;
    }
    html.push_str("<form class=\"filters scripted\" id=\"claim-filters\" aria-label=\"Filter claims\">\n");
    let kinds = distinct(claims.iter().map(|claim| claim.kind.as_str()));
    let parts = distinct(claims.iter().map(|claim| part(&claim.place)));
    html.push_str(&select("kind", "Kind", &kinds));
    html.push_str(&select("part", "Section", &parts));
    html.push_str(&select("state", "Verdict", &["passed", "failed", "unchecked", "misprint"]));
    put!(
        html,
        "<label>Label or words <input type=\"search\" name=\"text\" placeholder=\"eq:gp\"></label>\n\
         <button type=\"reset\">All</button> <output aria-live=\"polite\">{}</output>\n</form>\n",
        counted(claims.len(), "claim", "claims")
    );
    html.push_str("<ol class=\"claims\">\n");
    for claim in claims {
        html.push_str(&one(report, claim));
    }
    html.push_str("</ol>\n");
    html.push_str(&by_file(report));
    html.push_str("</section>\n");
    html
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

fn select(name: &str, title: &str, options: &[&str]) -> String {
    let mut html = format!("<label>{title} <select name=\"{name}\"><option value=\"\">all</option>");
    for option in options {
        put!(html, "<option>{}</option>", escape(option));
    }
    html.push_str("</select></label>\n");
    html
}

fn one(report: &Report, claim: &ClaimEntry) -> String {
    let state = claim.verdict.state();
    let label = escape(&claim.label);
    let misprint = if claim.misprint.is_some() { " data-misprint" } else { "" };
    let mut html = format!(
        "<li class=\"claim {0}\" id=\"{1}\" data-kind=\"{2}\" data-part=\"{3}\" data-state=\"{0}\"{misprint}>\n\
         <div class=\"what\"><h3><a href=\"#{1}\"><code>{label}</code></a></h3>\n<p class=\"place\">{4} · {2}</p></div>\n<div class=\"statement\"><p>{5}</p>\n",
        state.word(),
        escape(&identifier("claim", &claim.label)),
        escape(&claim.kind),
        escape(part(&claim.place)),
        escape(&claim.place),
        prose(&claim.says),
    );
    if let Some(formula) = &claim.formula {
        put!(
            html,
            "<div class=\"formula\" tabindex=\"0\" role=\"group\" aria-label=\"formula of {label}\">{}</div>\n",
            shown(formula, true)
        );
    }
    html.push_str(&references(report, claim));
    put!(html, "</div>\n<div class=\"outcome\"><p><span class=\"verdict {0}\">{0}</span>", state.word());
    if claim.misprint.is_some() {
        put!(
            html,
            " <a class=\"verdict misprint\" href=\"#{}\">misprint</a>",
            escape(&identifier("misprint", &claim.label))
        );
    }
    put!(html, "</p>\n{}</div>\n</li>\n", outcome(&claim.verdict));
    html
}

fn outcome(verdict: &Verdict) -> String {
    match verdict {
        Verdict::Checked { measured, print, samples, over, .. } => {
            let mut html = format!("<p>{}</p>\n", measured.html());
            if let Some(print) = print {
                put!(html, "<p>as printed: {}</p>\n", print.html());
            }
            put!(html, "<p class=\"samples\">{samples} {}</p>\n", prose(over));
            html
        }
        Verdict::Failed { error } => format!("<p>{}</p>\n", escape(error)),
        Verdict::Published { values } => {
            let mut html = String::from("<ul class=\"values\">\n");
            for value in values {
                put!(
                    html,
                    "<li><a href=\"#{}\">{}</a>: printed {}, computed <b>{}</b></li>\n",
                    escape(&identifier("value", &value.id)),
                    crate::published::symbols(&value.quantity),
                    escape(&value.printed.replace('-', "−")),
                    value.computed.map_or_else(|| "nothing".to_owned(), crate::published::computed),
                );
            }
            html.push_str("</ul>\n");
            html
        }
        Verdict::Unchecked { reason } => format!("<p class=\"samples\">{}</p>\n", prose(reason)),
    }
}

/// Links to source files and figures.
fn references(report: &Report, claim: &ClaimEntry) -> String {
    let mut lines = Vec::new();
    if !claim.holds.is_empty() {
        let held: Vec<String> = claim.holds.iter().map(|source| source_link(report, source)).collect();
        lines.push(format!("<span>Held by</span> {}", held.join(" ")));
    }
    if let Some(check) = &claim.check {
        lines.push(format!("<span>Tested by</span> {}", source_link(report, check)));
    }
    if !claim.figures.is_empty() {
        let figures: Vec<String> = claim.figures.iter().map(|name| figure_link(report, name)).collect();
        lines.push(format!("<span>Seen in</span> {}", figures.join(" ")));
    }
    lines.iter().map(|line| format!("<p class=\"links\">{line}</p>\n")).collect()
}

fn figure_link(report: &Report, name: &str) -> String {
    match report.figures.iter().find(|figure| figure.name == name) {
        Some(figure) => {
            let short = figure.title.split(':').next().unwrap_or(name);
            format!("<a href=\"#{}\">{}</a>", escape(name), escape(short))
        }
        None => escape(name),
    }
}

/// The item's name without the crate, as a link to its file where that is known.
fn source_link(report: &Report, source: &Source) -> String {
    let name = format!("<code>{}</code>", escape(&source.name).replace("::", "::<wbr>"));
    match (&source.file, &report.root) {
        (Some((file, line)), Some(root)) => {
            format!("<a href=\"{}{}\" title=\"{1}, line {line}\">{name}</a>", escape(root), escape(file))
        }
        (Some((file, line)), None) => format!("<span title=\"{}, line {line}\">{name}</span>", escape(file)),
        (None, _) => name,
    }
}

/// From source files back to claims.
fn by_file(report: &Report) -> String {
    let mut files: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for claim in &report.claims {
        for (file, _) in claim.holds.iter().chain(&claim.check).filter_map(|source| source.file.as_ref()) {
            let labels = files.entry(file).or_default();
            if labels.last() != Some(&claim.label.as_str()) {
                labels.push(&claim.label);
            }
        }
    }
    if files.is_empty() {
        return String::new();
    }
    let mut html = String::from(
        "<details class=\"files\" id=\"files\"><summary>From source files to claims</summary>\n<dl>\n",
    );
    for (file, labels) in files {
        let link = match &report.root {
            Some(root) => format!("<a href=\"{}{}\">{1}</a>", escape(root), escape(file)),
            None => escape(file),
        };
        put!(html, "<dt>{link}</dt><dd>{}</dd>\n", links(&labels));
    }
    html.push_str("</dl></details>\n");
    html
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_place_begins_with_its_part() {
        assert_eq!(part("section 2.4, eq. (15)"), "section 2.4");
        assert_eq!(part("caption of Figure 8"), "caption of Figure 8");
    }
}
