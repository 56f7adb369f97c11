//! Figures: SVG inside the page, with the numbers that are drawn.

use askama::Template;
use askama::filters::Safe;
use grazing_results::Table;

use crate::formula::prose;
use crate::html::{Html, escape, rendered};
use crate::svg::{Marks, attribute, with_short_paths};
use crate::{OscillatorEntry, Report, data, ledger, legend, table};

/// A figure with its data.
#[derive(Debug, Clone, PartialEq)]
pub struct FigureEntry {
    /// The name of its files, as `fig07`.
    pub name: String,
    /// What it shows, in one line: "Figure 7: two-parameter bifurcation diagram".
    pub title: String,
    /// The SVG file. Rectangles of class `panel` say where the axes are; without them the figure can be zoomed only.
    pub svg: String,
    /// The tables that are drawn.
    pub tables: Vec<Table>,
}

/// An SVG file taken apart: what goes into the page, and what the page keeps elsewhere.
struct Parts {
    /// The attributes of the root that the page needs.
    view_box: String,
    /// Millimetres.
    width: f64,
    attributes: String,
    description: String,
    style: String,
    body: String,
    /// Samples and meanings.
    legend: Vec<(Html, Html)>,
}

impl Parts {
    /// The width on the page where there is room, in units of the page's type.
    fn rem(&self) -> String {
        format!("{:.1}", self.width * SCALE)
    }
}

/// How much larger than on paper figures are shown where there is room, in units of the page's type for a millimetre: all
/// by the same factor, so that their labels are of one size.
const SCALE: f64 = 0.34;
/// The width, in millimetres, of a figure that does not say it.
const WIDEST: f64 = 160.0;

/// The families of the embedded fonts have names of their own on the page: the fonts are cut down to what figures need,
/// and must not stand in for whole ones of the reader's system.
const FAMILIES: [(&str, &str); 2] = [("STIX Two Text", "Figure Text"), ("STIX Two Math", "Figure Signs")];

/// The style sheets of all figures, each once: they hold the fonts.
pub(crate) fn styles(report: &Report<'_>) -> String {
    let mut styles: Vec<String> = Vec::new();
    for figure in report.all_figures() {
        // Each rule stands on a line of its own.
        for rule in parts(&figure.svg, &figure.name).style.lines() {
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
struct Framed<'a> {
    /// The identifier of the figure.
    id: &'a str,
    /// The name for those who do not see it.
    label: &'a str,
    heading: Html,
    parts: Parts,
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
    rendered(&Framed {
        id: &figure.name,
        label: &figure.title,
        heading: Safe(format!("<h3>{heading}</h3>")),
        parts: parts(&figure.svg, &figure.name),
        links: [("Files", report.links(&own_files(figure), false)), ("Claims", claims)],
        data: data::of_figure(&figure.tables, &Marks::of(&figure.svg)),
    })
}

/// A figure of an oscillator.
pub(crate) fn of_oscillator(report: &Report<'_>, oscillator: &OscillatorEntry, figure: &FigureEntry) -> Html {
    let id = format!("{}-{}", oscillator.anchor(), figure.name);
    rendered(&Framed {
        label: &format!("{}: {}", oscillator.description.name(), figure.title),
        heading: Safe(format!("<h4>{}</h4>", prose(&capitalised(&figure.title)))),
        parts: parts(&figure.svg, &id),
        links: [("Files", report.links(&own_files(figure), true)), ("", Vec::new())],
        data: data::of_figure(&figure.tables, &Marks::of(&figure.svg)),
        id: &id,
    })
}

/// The paths that the figure's own files have among all.
fn own_files(figure: &FigureEntry) -> Vec<String> {
    let tables = figure.tables.iter().map(table::path);
    std::iter::once(format!("{}.svg", figure.name)).chain(tables).collect()
}

pub(crate) fn capitalised(text: &str) -> String {
    let mut characters = text.chars();
    characters.next().map_or_else(String::new, |first| first.to_uppercase().chain(characters).collect())
}

/// Takes an SVG file apart, and gives its identifiers and fonts names that no other part of the page has.
fn parts(svg: &str, name: &str) -> Parts {
    let start = svg.find("<svg").map_or(0, |start| start + "<svg".len());
    let head_end = svg[start..].find('>').map_or(svg.len(), |end| start + end);
    let head = &svg[start..head_end];
    let end = svg.rfind("</svg>").unwrap_or(svg.len()).max(head_end);
    let (legend, mut body) = legend::cut_out(svg.get(head_end + 1..end).unwrap_or_default());
    let description = take(&mut body, "desc");
    let _ = take(&mut body, "title");
    let mut style = take(&mut body, "style");
    let mut attributes = String::new();
    for kept in ["font-family", "xml:space", "stroke-linejoin", "fill"] {
        if let Some(value) = attribute(head, kept) {
            attributes.push_str(&format!("{kept}=\"{value}\" "));
        }
    }
    for (family, own) in FAMILIES {
        for text in [&mut body, &mut style, &mut attributes] {
            *text = text.replace(family, own);
        }
    }
    for (reference, own) in [
        (" id=\"", format!(" id=\"{name}-")),
        ("url(#", format!("url(#{name}-")),
        ("href=\"#", format!("href=\"#{name}-")),
    ] {
        body = body.replace(reference, &own);
    }
    Parts {
        width: attribute(head, "width")
            .and_then(|width| width.strip_suffix("mm"))
            .and_then(|width| width.parse().ok())
            .unwrap_or(WIDEST),
        view_box: attribute(head, "viewBox").unwrap_or("0 0 100 100").to_owned(),
        attributes: attributes.trim_end().to_owned(),
        description: unescaped(&description),
        style,
        body: with_short_paths(&body),
        legend: legend::entries(legend),
    }
}

/// Cuts the first element of that name out of the text and returns its content.
fn take(text: &mut String, element: &str) -> String {
    let (opening, closing) = (format!("<{element}>"), format!("</{element}>"));
    let (Some(start), Some(end)) = (text.find(&opening), text.find(&closing)) else {
        return String::new();
    };
    let content = text[start + opening.len()..end].to_owned();
    text.replace_range(start..end + closing.len(), "");
    content
}

pub(crate) fn unescaped(text: &str) -> String {
    [("&lt;", "<"), ("&gt;", ">"), ("&quot;", "\""), ("&#39;", "'"), ("&amp;", "&")]
        .iter()
        .fold(text.to_owned(), |text, (escaped, plain)| text.replace(escaped, plain))
}

#[cfg(test)]
mod tests {
    use super::*;

    const SVG: &str = "<?xml version=\"1.0\"?>\n<svg xmlns=\"x\" width=\"1mm\" viewBox=\"0 0 10 10\" font-family=\"'STIX Two Text',serif\" \
         fill=\"none\">\n<title>T</title><desc>a &lt; b</desc><style>@font-face{font-family:'STIX Two Text'}</style>\n\
         <clipPath id=\"c\"/><path clip-path=\"url(#c)\"/><use href=\"#c\"/></svg>\n";

    #[test]
    fn a_file_is_taken_apart_and_its_identifiers_are_its_own() {
        let parts = parts(SVG, "fig99");
        assert_eq!(parts.view_box, "0 0 10 10");
        assert_eq!(parts.width, 1.0);
        assert_eq!(parts.description, "a < b");
        assert_eq!(parts.style, "@font-face{font-family:'Figure Text'}");
        assert_eq!(parts.attributes, "font-family=\"'Figure Text',serif\" fill=\"none\"");
        assert_eq!(
            parts.body.trim(),
            "<clipPath id=\"fig99-c\"/><path clip-path=\"url(#fig99-c)\"/><use href=\"#fig99-c\"/>"
        );
    }
}
