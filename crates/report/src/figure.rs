//! Figures: SVG inside the page, with the numbers that are drawn.

use askama::Template;
use askama::filters::Safe;

use crate::formula::prose;
use crate::html::{Html, capitalised, csv_path, escape, rendered};
use crate::oscillator::OscillatorEntry;
use crate::outputs::FigureEntry;
use crate::report::Report;
use crate::svg::{SvgFile, with_short_paths};
use crate::{data, ledger};

/// What the page has of an SVG file.
struct PageDrawing {
    view_box: String,
    /// Millimetres.
    width: f64,
    attributes: String,
    description: String,
    body: String,
    /// Samples and meanings.
    legend: Vec<(Html, Html)>,
}

impl PageDrawing {
    /// The width on the page where there is room, in units of the page's type.
    fn rem(&self) -> String {
        format!("{:.1}", self.width * REM_PER_MM)
    }
}

/// How much larger than on paper figures are shown where there is room, in units of the page's type for a millimetre: all
/// by the same factor, so that their labels are of one size.
const REM_PER_MM: f64 = 0.34;
/// The width, in millimetres, of a figure that does not say it.
const DEFAULT_WIDTH_MM: f64 = 160.0;

/// The families of the embedded fonts have names of their own on the page: the fonts are cut down to what figures need,
/// and must not stand in for whole ones of the reader's system.
const FAMILIES: [(&str, &str); 2] = [("STIX Two Text", "Figure Text"), ("STIX Two Math", "Figure Signs")];

/// The style sheets of all figures, each once: they hold the fonts.
pub(crate) fn styles(report: &Report<'_>) -> String {
    let mut styles: Vec<String> = Vec::new();
    for figure in report.all_figures() {
        // Each rule stands on a line of its own.
        for rule in own_fonts(SvgFile::read(&figure.svg).text("style").to_owned()).lines() {
            if !rule.trim().is_empty() && !styles.iter().any(|known| known == rule) {
                styles.push(rule.to_owned());
            }
        }
    }
    styles.join("\n")
}

/// A figure on the page.
#[derive(Template)]
#[template(path = "figure.html")]
struct FigureSection<'a> {
    /// The identifier of the figure.
    id: &'a str,
    /// The name for those who do not see it.
    label: &'a str,
    heading: Html,
    parts: PageDrawing,
    /// Lines of links with a word before them.
    links: [(&'static str, Vec<Html>); 2],
    /// The tables for the scripts.
    data: String,
}

/// A figure of the paper.
pub(crate) fn of_the_paper(report: &Report<'_>, figure: &FigureEntry) -> Html {
    let heading = match figure.title.split_once(": ") {
        Some((number, rest)) => {
            format!("<span class=\"eyebrow\">{}</span> {}", escape(number), prose(&capitalised(rest)))
        }
        None => escape(&figure.title),
    };
    let shown = report.claims.iter().filter(|finding| finding.claim.figures.contains(&figure.name));
    let claims = shown.map(|finding| ledger::link(&finding.claim.label)).collect();
    let file = SvgFile::read(&figure.svg);
    rendered(&FigureSection {
        id: &figure.name,
        label: &figure.title,
        heading: Safe(format!("<h3>{heading}</h3>")),
        parts: parts(&file, &figure.name),
        links: [("Files", report.links(&own_files(figure), false)), ("Claims", claims)],
        data: data::of_figure(&figure.tables, &file),
    })
}

/// A figure of an oscillator.
pub(crate) fn of_oscillator(report: &Report<'_>, oscillator: &OscillatorEntry, figure: &FigureEntry) -> Html {
    let id = format!("{}-{}", oscillator.anchor(), figure.name);
    let file = SvgFile::read(&figure.svg);
    rendered(&FigureSection {
        label: &format!("{}: {}", oscillator.description.name(), figure.title),
        heading: Safe(format!("<h4>{}</h4>", prose(&capitalised(&figure.title)))),
        parts: parts(&file, &id),
        links: [("Files", report.links(&own_files(figure), true)), ("", Vec::new())],
        data: data::of_figure(&figure.tables, &file),
        id: &id,
    })
}

/// The paths that the figure's own files have among all.
fn own_files(figure: &FigureEntry) -> Vec<String> {
    let tables = figure.tables.iter().map(csv_path);
    std::iter::once(format!("{}.svg", figure.name)).chain(tables).collect()
}

/// Takes an SVG file apart, and gives its identifiers and fonts names that no other part of the page has.
fn parts(file: &SvgFile<'_>, name: &str) -> PageDrawing {
    let references = [" id=\"", "url(#", "href=\"#"];
    let body = references.into_iter().fold(own_fonts(file.drawing()), |body, reference| {
        body.replace(reference, &format!("{reference}{name}-"))
    });
    let entry = |(sample, meaning): (String, String)| {
        let sample = format!("<svg viewBox=\"0 0 24 10\" fill=\"none\" aria-hidden=\"true\">{sample}</svg>");
        (Safe(sample), prose(&meaning))
    };
    let width = file.attribute("width").and_then(|width| width.strip_suffix("mm"));
    PageDrawing {
        width: width.and_then(|width| width.parse().ok()).unwrap_or(DEFAULT_WIDTH_MM),
        view_box: file.attribute("viewBox").unwrap_or("0 0 100 100").to_owned(),
        attributes: own_fonts(file.inherited()),
        description: file.text("desc").to_owned(),
        body: with_short_paths(&body),
        legend: file.legend().into_iter().map(entry).collect(),
    }
}

/// The text with the page's names for the embedded fonts.
fn own_fonts(text: String) -> String {
    FAMILIES.iter().fold(text, |text, (family, own)| text.replace(family, own))
}

#[cfg(test)]
mod tests {
    use super::*;

    const SVG: &str = "<?xml version=\"1.0\"?>\n<svg xmlns=\"x\" width=\"1mm\" viewBox=\"0 0 10 10\" font-family=\"'STIX Two Text',serif\" \
         fill=\"none\">\n<title>T</title><desc>a &lt; b</desc><style>@font-face{font-family:'STIX Two Text'}</style>\n\
         <clipPath id=\"c\"/><path clip-path=\"url(#c)\"/><use href=\"#c\"/></svg>\n";

    #[test]
    fn a_file_is_taken_apart_and_its_identifiers_are_its_own() {
        let file = SvgFile::read(SVG);
        let parts = parts(&file, "fig99");
        assert_eq!(parts.view_box, "0 0 10 10");
        assert_eq!(parts.width, 1.0);
        assert_eq!(parts.description, "a < b");
        assert_eq!(own_fonts(file.text("style").to_owned()), "@font-face{font-family:'Figure Text'}");
        assert_eq!(parts.attributes, "font-family=\"'Figure Text',serif\" fill=\"none\"");
        assert_eq!(
            parts.body.trim(),
            "<clipPath id=\"fig99-c\"/><path clip-path=\"url(#fig99-c)\"/><use href=\"#fig99-c\"/>"
        );
    }
}
