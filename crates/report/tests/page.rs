//! The page of a small report, used in a browser.

mod browser;
mod sample;

use browser::{Spot, assert_all_pass, checked, sheets_of_paper};
use grazing_report::page;

/// Ways to write parts of the formula of the sample, g_p(δ) = 2 √δ cos(π/p), with the label of its
/// claim.
const FORMULAS: [(&str, &str); 5] = [
    ("eq:holds", "eq:holds"),
    (r"g_p(\delta)", "eq:holds"),
    ("gp(δ) = 2", "eq:holds"),
    (r"2 \sqrt{\delta} \cos", "eq:holds"),
    (r"\frac{\pi}{p}", "eq:misprinted"),
];

#[test]
fn the_page_answers_to_pointer_keys_and_filters() {
    // The panel of the sample reaches from (20, 90) to (180, 10) on the sheet, from (0, -1) to
    // (4, 1) in the data.
    let told = |parts: &[&str]| parts.iter().map(|part| (*part).to_owned()).collect();
    let spots = [
        Spot {
            figure: "fig98",
            sheet: (101.0, 52.0),
            told: told(&["𝒜 = 2.025, ω = −0.05", "Saddle-node", "unstable", "admissible", "p1"]),
            hidden: false,
        },
        Spot { figure: "fig99", sheet: (20.0, 90.0), told: told(&["Saddle-node", "stable"]), hidden: false },
        // This row is inadmissible, so it is not drawn.
        Spot {
            figure: "fig99",
            sheet: (180.0, 10.0),
            told: told(&["𝒜 = 4, ω = 1", "Period-doubling", "inadmissible"]),
            hidden: true,
        },
        // The middle of the panel, in the columns of this oscillator.
        Spot {
            figure: "oscillator-one-diagram",
            sheet: (101.0, 52.0),
            told: told(&["F0 = 2.025 N, A = −0.05", "Resonant grazing"]),
            hidden: false,
        },
    ];
    if let Some(results) = checked(&page(&sample::report()), &spots, &FORMULAS) {
        assert_all_pass(&results);
    }
}

#[test]
fn errata_are_called_so_and_listed_in_the_order_of_their_file() {
    let report = sample::report();
    let page = page(&report);
    let sections = grazing_claims::errata::sections(&report.claims);
    let labels =
        sections.iter().flat_map(|section| &section.entries).map(|entry| entry.found.claim.label.as_str());
    // A formula comes before a word that stands before it in the paper.
    assert_eq!(labels.clone().collect::<Vec<_>>(), ["eq:misprinted", "eq:holds"]);
    let places: Vec<usize> = labels
        .zip(1..)
        .map(|(label, number)| format!("<h4>{number}. <a href=\"#claim-{}\">", label))
        .map(|heading| page.find(&heading).unwrap_or_else(|| panic!("there is no {heading}")))
        .collect();
    assert!(places.is_sorted());
    assert!(page.contains("<h2 id=\"errata-title\">Errata</h2>"));
    assert!(page.contains("href=\"#errata\"><b>2</b> <span>errata</span>"));
}

#[test]
fn links_lead_to_where_they_say() {
    let mut report = sample::report();
    // As long as the page about the paper.
    report.claims = (0..60).flat_map(|_| report.claims.clone()).collect();
    if let Some((lost, followed)) = browser::lost(&page(&report), &[1400, 768, 390], 4) {
        assert!(followed >= 3 * 8, "{followed}");
        assert!(lost.is_empty(), "{lost:#?}");
    }
}

#[test]
fn no_caption_and_no_text_is_cut_off_in_a_narrow_window() {
    let mut report = sample::report();
    let long = report.tables[0].title.words.repeat(4);
    report.tables[0].title = long.into();
    if let Some(cut) = browser::cut(&page(&report), 390) {
        assert!(cut.is_empty(), "{cut:#?}");
    }
}

#[test]
fn the_page_can_be_printed() {
    if let Some(sheets) = sheets_of_paper(&page(&sample::report())) {
        // Each of its eight sections begins on a new sheet; none is long.
        assert!((8..24).contains(&sheets), "{sheets}");
    }
}

#[test]
fn the_checks_notice_a_page_that_does_not_answer() {
    let deaf = page(&sample::report()).replace("addEventListener(\"pointermove\", point)", "focus()");
    let spot =
        Spot { figure: "fig98", sheet: (100.0, 50.0), told: vec!["Saddle-node".to_owned()], hidden: false };
    if let Some(results) = checked(&deaf, &[spot], &[]) {
        assert!(results.iter().any(|line| line.starts_with("FAILED: fig98 at 100, 50")), "{results:#?}");
    }
}

#[test]
fn a_page_about_an_oscillator_alone_answers_too() {
    let told = ["F0 = 4 N, A = 1", "Saddle-node and grazing"].map(str::to_owned).to_vec();
    let spot = Spot { figure: "oscillator-one-diagram", sheet: (180.0, 10.0), told, hidden: false };
    if let Some(results) = checked(&page(&sample::oscillators_alone()), &[spot], &[]) {
        assert_all_pass(&results);
    }
}
