//! The page as a whole.

use std::collections::BTreeMap;

use askama::Template;
use askama::filters::Safe;
use base64::prelude::{BASE64_STANDARD, Engine};
use grazing_claims::{audit, errata};
use grazing_drawing::FORMULA_FONT;
use grazing_results::kinds;

use crate::html::{Html, capitalised, escape, rendered};
use crate::ledger;
use crate::report::Report;

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
    include_str!("../assets/scales.js"),
    include_str!("../assets/gestures.js"),
    include_str!("../assets/panels.js"),
    include_str!("../assets/zoom.js"),
    include_str!("../assets/figures.js"),
    include_str!("../assets/tables.js"),
    include_str!("../assets/claims.js"),
    include_str!("../assets/formulas.js"),
    include_str!("../assets/navigation.js"),
];

/// The content policy of the page, which allows nothing but its own content.
const POLICY: &str =
    "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; font-src data:";

/// The style sheet that embeds the font of formulas, with a name of its own: it is reduced to what formulas
/// need, and must not replace the complete one of the reader's system.
fn formula_font() -> String {
    let data = BASE64_STANDARD.encode(FORMULA_FONT);
    format!("@font-face{{font-family:'Formulas';src:url(data:font/woff2;base64,{data})format('woff2')}}")
}

/// The page: one HTML text that needs nothing else.
pub fn page(report: &Report<'_>) -> String {
    // Templates omit the end of their last line.
    rendered(&Page { report }).0 + "\n"
}

#[derive(Template)]
#[template(path = "page.html")]
struct Page<'a> {
    report: &'a Report<'a>,
}

impl Page<'_> {
    /// The meanings of words in tables, for the scripts.
    fn kinds(&self) -> String {
        let meanings = kinds::meanings().into_iter().map(|(name, meaning)| (name, capitalised(meaning)));
        let meanings: BTreeMap<_, _> = meanings.collect();
        format!("const KINDS = {};\n", serde_json::json!(meanings))
    }

    /// Identifiers and titles of the sections that have something to show.
    fn sections(&self) -> Vec<(&'static str, &'static str)> {
        let Report { figures, tables, beyond, published, claims, oscillators, .. } = self.report;
        let sections = [
            (true, "summary", "Summary"),
            (!published.is_empty(), "published", "Values"),
            (!figures.is_empty(), "figures", "Figures"),
            (!tables.is_empty(), "tables", "Tables"),
            (!(beyond.figures.is_empty() && beyond.tables.is_empty()), "beyond", "Beyond the paper"),
            (!claims.is_empty(), "claims", "Claims"),
            (!claims.is_empty(), "errata", "Errata"),
            (oscillators.len() == 1, "oscillators", "Oscillator"),
            (oscillators.len() > 1, "oscillators", "Oscillators"),
            (true, "manifest", "Manifest"),
        ];
        sections.into_iter().filter(|(there, ..)| *there).map(|(_, id, title)| (id, title)).collect()
    }

    fn title(&self) -> &str {
        match self.report.oscillators.as_slice() {
            _ if self.report.is_of_the_paper() => "Resonant grazing bifurcations, reproduced",
            [oscillator] => oscillator.description.name(),
            _ => "Resonant grazing bifurcations",
        }
    }

    /// A label of the paper, as a link if the ledger has it.
    fn label(&self, label: &str) -> Html {
        if self.report.claims.iter().any(|finding| finding.claim.label == label) {
            ledger::link(label)
        } else {
            Safe(format!("<code>{}</code>", escape(label)))
        }
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::sample;

    /// The values of an attribute anywhere on the page, without scripts.
    fn values<'a>(html: &'a str, attribute: &str) -> Vec<&'a str> {
        let start = format!(" {attribute}=\"");
        html.match_indices(&start).filter_map(|(at, _)| html[at + start.len()..].split('"').next()).collect()
    }

    /// The page without its scripts, whose texts are not markup.
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

    /// Asserts that every link within the page and every reference has a target; returns the number of links.
    fn internal_links(markup: &str) -> usize {
        let ids: BTreeSet<&str> = values(markup, "id").into_iter().collect();
        for attribute in ["aria-labelledby", "aria-describedby", "data-filters"] {
            for id in values(markup, attribute) {
                assert!(ids.contains(id), "{attribute} {id} leads nowhere");
            }
        }
        let links = values(markup, "href").into_iter().filter_map(|href| href.strip_prefix('#'));
        links.inspect(|target| assert!(ids.contains(target), "#{target} leads nowhere")).count()
    }

    #[test]
    fn every_internal_link_and_reference_has_a_target() {
        let links = internal_links(&markup(&page(&sample::report())));
        assert!(links > 20, "{links}");
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
            "href=\"https://example.org/a/blob/HEAD/crates/theorems/src/auxiliary.rs#L1\"",
            "href=\"https://example.org/a/blob/HEAD/figures/data/fig98_points.csv\"",
        ] {
            assert!(html.contains(link), "{link}");
        }
    }

    #[test]
    fn a_page_without_an_address_has_links_within_it_only() {
        let mut report = sample::report();
        (report.root, report.manifest.folder) = (None, None);
        report.oscillators.iter_mut().for_each(|oscillator| oscillator.link = None);
        let html = page(&report);
        let markup = markup(&html);
        for href in values(&markup, "href") {
            assert!(href.starts_with('#') || href == "https://arxiv.org/abs/2602.22797", "{href}");
        }
        for named in ["crates/theorems/src/auxiliary.rs", "<code>data/fig98_points.csv</code>"] {
            assert!(markup.contains(named), "{named}");
        }
    }

    #[test]
    fn fonts_are_embedded_once() {
        let html = page(&sample::report());
        assert_eq!(html.matches("@font-face").count(), grazing_drawing::FONT_FILES.len() + 1);
    }

    #[test]
    fn a_page_about_oscillators_alone_has_no_empty_parts() {
        let html = page(&sample::oscillators_alone());
        let markup = markup(&html);
        for id in ["published", "figures", "tables", "claims", "errata"] {
            assert!(
                !markup.contains(&format!("id=\"{id}\"")) && !markup.contains(&format!("#{id}\"")),
                "{id}"
            );
        }
        assert!(html.contains("<title>Sample oscillator</title>"));
        assert!(markup.contains("<code>data/points.csv</code>"), "its own files are named");
        internal_links(&markup);
    }

    #[test]
    fn units_stand_in_headings_and_ranges() {
        let html = page(&sample::oscillators_alone());
        for text in ["</math> (N)</th>", "in N\"", "(N/A<sup>2</sup>)", "to 4 N</dd>"] {
            assert!(html.contains(text), "{text}");
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
        report.manifest.outputs.push(crate::FileDigest::of("data/coefficients.csv", b""));
        let html = page(&report);
        let part = &html[html.find("<section id=\"oscillators\"").expect("there are oscillators")..];
        let part = &part[..part.find("<section id=\"manifest\"").expect("the manifest follows")];
        assert!(part.contains("id=\"table-oscillator-one-coefficients\"") && !part.contains("/figures/"));
    }
}
