//! The page as a whole.

use crate::html::{escape, put};
use crate::{Report, columns, figure, ledger, manifest, misprints, published, summary, table};

const STYLE: &[&str] = &[
    include_str!("../assets/base.css"),
    include_str!("../assets/figures.css"),
    include_str!("../assets/tables.css"),
    include_str!("../assets/claims.css"),
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

const SECTIONS: [(&str, &str); 7] = [
    ("summary", "Summary"),
    ("published", "Values"),
    ("figures", "Figures"),
    ("tables", "Tables"),
    ("claims", "Claims"),
    ("misprints", "Misprints"),
    ("manifest", "Manifest"),
];

/// The page: one HTML text that needs nothing else.
pub fn page(report: &Report) -> String {
    let mut html = format!(
        "<!DOCTYPE html>\n<html lang=\"en-GB\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n\
         <title>Resonant grazing bifurcations, reproduced</title>\n<style>\n{}\n{}</style>\n<script>\n{THEME}</script>\n</head>\n<body>\n",
        escape(POLICY),
        figure::styles(report),
        STYLE.concat(),
    );
    html.push_str("<a class=\"skip\" href=\"#content\">Skip to the content</a>\n<header class=\"bar\">\n<nav aria-label=\"Sections\"><ul>\n");
    for (id, title) in SECTIONS {
        put!(html, "<li><a href=\"#{id}\">{title}</a></li>\n");
    }
    html.push_str(
        "</ul></nav>\n<button type=\"button\" id=\"theme\" class=\"scripted\">Theme</button>\n</header>\n<main id=\"content\" tabindex=\"-1\">\n",
    );
    for section in [
        summary::section,
        published::section,
        figure::section,
        table::section,
        ledger::section,
        misprints::section,
        manifest::section,
    ] {
        html.push_str(&section(report));
    }
    put!(
        html,
        "</main>\n<footer><p>{}. Licence: MIT or Apache-2.0; embedded fonts: SIL Open Font License.</p></footer>\n\
         <script type=\"application/json\" id=\"columns\">{}</script>\n<script>\n{}</script>\n</body>\n</html>\n",
        escape(&report.manifest.program),
        columns::json(),
        SCRIPTS.concat(),
    );
    html
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
}
