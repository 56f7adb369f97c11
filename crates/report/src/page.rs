//! The page as a whole.

use grazing_results::Table;

use crate::html::{escape, put};
use crate::{Report, columns, figure, ledger, manifest, misprints, oscillators, published, summary, table};

const STYLE: &[&str] = &[
    include_str!("../assets/base.css"),
    include_str!("../assets/figures.css"),
    include_str!("../assets/tables.css"),
    include_str!("../assets/claims.css"),
    include_str!("../assets/oscillators.css"),
    include_str!("../assets/print.css"),
];
const THEME: &str = include_str!("../assets/theme.js");
const SCRIPTS: &[&str] = &[
    include_str!("../assets/data.js"),
    include_str!("../assets/zoom.js"),
    include_str!("../assets/figures.js"),
    include_str!("../assets/tables.js"),
    include_str!("../assets/claims.js"),
    include_str!("../assets/formulas.js"),
];

/// What the page may load: nothing but what stands in it.
const POLICY: &str =
    "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; font-src data:";

/// A part of the page.
struct Section {
    id: &'static str,
    /// Its name in the bar.
    title: &'static str,
    html: fn(&Report) -> String,
}

/// The parts that have something to show.
fn sections(report: &Report) -> Vec<Section> {
    let ledger = !report.claims.is_empty();
    let oscillators = if report.oscillators.len() == 1 { "Oscillator" } else { "Oscillators" };
    [
        (true, "summary", "Summary", summary::section as fn(&Report) -> String),
        (!report.published.is_empty(), "published", "Values", published::section),
        (!report.figures.is_empty(), "figures", "Figures", figure::section),
        (!report.tables.is_empty(), "tables", "Tables", table::section),
        (ledger, "claims", "Claims", ledger::section),
        (ledger, "misprints", "Misprints", misprints::section),
        (!report.oscillators.is_empty(), "oscillators", oscillators, oscillators::section),
        (true, "manifest", "Manifest", manifest::section),
    ]
    .into_iter()
    .filter(|(there, ..)| *there)
    .map(|(_, id, title, html)| Section { id, title, html })
    .collect()
}

/// The page: one HTML text that needs nothing else.
pub fn page(report: &Report) -> String {
    let mut html = format!(
        "<!DOCTYPE html>\n<html lang=\"en-GB\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n\
         <title>{}</title>\n<style>\n{}\n{}</style>\n<script>\n{THEME}</script>\n</head>\n<body>\n",
        escape(POLICY),
        escape(summary::title(report)),
        figure::styles(report),
        STYLE.concat(),
    );
    html.push_str("<a class=\"skip\" href=\"#content\">Skip to the content</a>\n<header class=\"bar\">\n<nav aria-label=\"Sections\"><ul>\n");
    let sections = sections(report);
    for Section { id, title, .. } in &sections {
        put!(html, "<li><a href=\"#{id}\">{title}</a></li>\n");
    }
    html.push_str(
        "</ul></nav>\n<button type=\"button\" id=\"theme\" class=\"scripted\">Theme</button>\n</header>\n<main id=\"content\" tabindex=\"-1\">\n",
    );
    for section in sections {
        html.push_str(&(section.html)(report));
    }
    put!(
        html,
        "</main>\n<footer><p>{}. Licence: MIT or Apache-2.0; embedded fonts: SIL Open Font License.</p></footer>\n\
         <script type=\"application/json\" id=\"columns\">{}</script>\n<script>\n{}</script>\n</body>\n</html>\n",
        escape(&report.manifest.program),
        columns::json(drawn(report)),
        SCRIPTS.concat(),
    );
    html
}

/// The tables of all figures.
fn drawn(report: &Report) -> impl Iterator<Item = &Table> {
    let of_oscillators = report.oscillators.iter().flat_map(|oscillator| &oscillator.figures);
    report.figures.iter().chain(of_oscillators).flat_map(|figure| &figure.tables)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::sample;

    /// The values of an attribute anywhere on the page, scripts aside.
    fn values<'a>(html: &'a str, attribute: &str) -> Vec<&'a str> {
        let start = format!(" {attribute}=\"");
        html.match_indices(&start).filter_map(|(at, _)| html[at + start.len()..].split('"').next()).collect()
    }

    /// The page without its scripts, whose texts are no markup.
    fn markup(html: &str) -> String {
        let mut markup = String::new();
        for (index, piece) in html.split("<script").enumerate() {
            let after =
                if index == 0 { piece } else { piece.split_once("</script>").map_or("", |(_, after)| after) };
            markup.push_str(after);
            // The identifiers of data for scripts count too.
            if index > 0 {
                markup.push_str(&format!("<script{}>", piece.split('>').next().unwrap_or_default()));
            }
        }
        markup
    }

    #[test]
    fn nothing_is_loaded_from_anywhere() {
        let html = page(&sample::report());
        let markup = markup(&html);
        assert_eq!(values(&markup, "src"), Vec::<&str>::new());
        assert!(!markup.contains("<link") && !markup.contains("<img") && !markup.contains("@import"));
        for (at, _) in html.match_indices("url(") {
            let rest = &html[at + 4..];
            assert!(rest.starts_with("data:") || rest.starts_with('#'), "{}", &rest[..rest.len().min(40)]);
        }
        for script in ["fetch(", "XMLHttpRequest", "import(", "WebSocket", "sendBeacon"] {
            assert!(!html.contains(script), "{script}");
        }
        for href in values(&markup, "href").iter().filter(|href| href.contains("//")) {
            assert!(markup.contains(&format!("<a href=\"{href}\"")), "{href} is a link to follow");
        }
    }

    #[test]
    fn identifiers_are_unique() {
        let html = markup(&page(&sample::report()));
        let mut seen = BTreeSet::new();
        let ids = values(&html, "id");
        assert!(ids.len() > 20, "{ids:?}");
        for id in ids {
            assert!(seen.insert(id), "{id} stands there twice");
        }
    }

    #[test]
    fn every_internal_link_and_reference_has_a_target() {
        let html = markup(&page(&sample::report()));
        let ids: BTreeSet<&str> = values(&html, "id").into_iter().collect();
        let mut links = 0;
        for target in values(&html, "href").iter().filter_map(|href| href.strip_prefix('#')) {
            assert!(ids.contains(target), "#{target} leads nowhere");
            links += 1;
        }
        assert!(links > 20, "{links}");
        for attribute in ["aria-labelledby", "aria-describedby", "data-filters"] {
            for id in values(&html, attribute) {
                assert!(ids.contains(id), "{attribute} {id} leads nowhere");
            }
        }
    }

    #[test]
    fn text_of_the_ledger_cannot_become_markup() {
        let html = page(&sample::report());
        assert!(!html.contains(sample::HOSTILE), "{}", sample::HOSTILE);
        let escaped = escape(sample::HOSTILE);
        assert!(html.matches(&escaped).count() >= 8, "it is shown as text wherever it was given");
    }

    #[test]
    fn equal_reports_give_equal_bytes() {
        assert_eq!(page(&sample::report()), page(&sample::report()));
    }

    #[test]
    fn figures_claims_and_files_lead_to_each_other() {
        let html = page(&sample::report());
        for link in [
            "href=\"#claim-eq:holds\"",
            "href=\"#fig98\"",
            "href=\"#misprint-eq:misprinted\"",
            "href=\"#value-a\"",
            "href=\"../crates/theorems/src/auxiliary.rs\"",
            "href=\"../figures/data/fig98_points.csv\"",
        ] {
            assert!(html.contains(link), "{link}");
        }
    }

    #[test]
    fn fonts_are_embedded_once() {
        let html = page(&sample::report());
        assert_eq!(html.matches("@font-face").count(), 1);
    }

    #[test]
    fn a_page_about_oscillators_alone_has_no_empty_parts() {
        let html = page(&sample::oscillators_alone());
        let markup = markup(&html);
        for id in ["published", "figures", "tables", "claims", "misprints"] {
            assert!(
                !markup.contains(&format!("id=\"{id}\"")) && !markup.contains(&format!("#{id}\"")),
                "{id}"
            );
        }
        assert!(html.contains("<title>Sample oscillator</title>"));
        assert!(markup.contains("href=\"data/points.csv\""), "its own files are linked");
        for attribute in ["href", "aria-labelledby", "aria-describedby", "data-filters"] {
            let ids: BTreeSet<&str> = values(&markup, "id").into_iter().collect();
            let targets = values(&markup, attribute).into_iter();
            for target in targets.filter_map(|value| match attribute {
                "href" => value.strip_prefix('#'),
                _ => Some(value),
            }) {
                assert!(ids.contains(target), "{attribute} {target} leads nowhere");
            }
        }
    }

    #[test]
    fn a_page_without_oscillators_does_not_mention_any() {
        let report = Report { oscillators: Vec::new(), ..sample::report() };
        assert!(!markup(&page(&report)).contains("scillators\""));
    }

    #[test]
    fn tables_of_oscillators_do_not_lead_to_files_of_the_paper() {
        // Both have a table of this name.
        let mut report = sample::report();
        report.manifest.outputs.push(crate::OutputFile::of("data/coefficients.csv", b""));
        let html = page(&report);
        let part = &html[html.find("<section id=\"oscillators\"").expect("there are oscillators")..];
        let part = &part[..part.find("<section id=\"manifest\"").expect("the manifest follows")];
        assert!(
            part.contains("id=\"table-oscillator-one-coefficients\"") && !part.contains("href=\"../figures/")
        );
    }
}
