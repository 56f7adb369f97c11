//! Figures: SVG inside the page, with the numbers in them.

use askama::Template;
use askama::filters::Safe;
use grazing_drawing::{POINTS_PER_MM, Sheet, style_sheet, unmarked};

use crate::formula::prose;
use crate::html::{Html, capitalised, csv_path, rendered};
use crate::oscillator::OscillatorEntry;
use crate::outputs::FigureEntry;
use crate::report::Report;
use crate::{data, ledger};

/// The magnification of figures where there is room, in units of the page's type for a millimetre:
/// the same factor for all, so that their labels have one size.
const REM_PER_MM: f64 = 0.34;
/// The families of the embedded fonts, which have names of their own on the page: the fonts are
/// reduced to what figures need, and must not replace complete ones of the reader's system.
const FAMILIES: [(&str, &str); 2] = [("STIX Two Text", "Figure Text"), ("STIX Two Math", "Figure Signs")];

/// The style sheet of the figures, if there are any: it holds the fonts.
pub(crate) fn styles(report: &Report<'_>) -> String {
    let sheet = report.all_figures().next().map(|_| own_fonts(style_sheet().trim_end()));
    sheet.unwrap_or_default()
}

/// A figure on the page.
#[derive(Template)]
#[template(path = "figure.html")]
struct FigureSection<'a> {
    /// The identifier of the figure on the page.
    id: &'a str,
    /// The name for screen readers.
    label: &'a str,
    heading: Html,
    sheet: &'a Sheet,
    /// Lines of links, each with a word before them.
    links: [(&'static str, Vec<Html>); 2],
    /// The tables for the scripts.
    data: String,
}

/// A figure of the paper.
pub(crate) fn of_the_paper(report: &Report<'_>, figure: &FigureEntry) -> Html {
    let words = prose(&capitalised(&figure.title.words));
    let heading = match figure.title.before() {
        Some(before) => format!("<span class=\"eyebrow\">{before}</span> {words}"),
        None => words.0,
    };
    let shown = report.claims.iter().filter(|finding| finding.claim.figures.contains(&figure.name));
    let claims = shown.map(|finding| ledger::link(&finding.claim.label)).collect();
    rendered(&FigureSection {
        id: &figure.name,
        label: &figure.title.to_string(),
        heading: Safe(format!("<h3>{heading}</h3>")),
        sheet: &figure.sheet,
        links: [("Files", report.links(&own_files(figure), false)), ("Claims", claims)],
        data: data::of_figure(figure),
    })
}

/// A figure of an oscillator.
pub(crate) fn of_oscillator(report: &Report<'_>, oscillator: &OscillatorEntry, figure: &FigureEntry) -> Html {
    let id = format!("{}-{}", oscillator.anchor(), figure.name);
    rendered(&FigureSection {
        label: &format!("{}: {}", oscillator.description.name(), unmarked(&figure.title.words)),
        heading: Safe(format!("<h4>{}</h4>", prose(&capitalised(&figure.title.words)))),
        sheet: &figure.sheet,
        links: [("Files", report.links(&own_files(figure), true)), ("", Vec::new())],
        data: data::of_figure(figure),
        id: &id,
    })
}

/// The paths of the figure's own files among all files.
fn own_files(figure: &FigureEntry) -> Vec<String> {
    let tables = figure.tables.iter().map(csv_path);
    std::iter::once(format!("{}.svg", figure.name)).chain(tables).collect()
}

impl FigureSection<'_> {
    /// The width where there is room, in units of the page's type.
    fn rem(&self) -> String {
        format!("{:.1}", self.sheet.size.0 / POINTS_PER_MM * REM_PER_MM)
    }

    /// The attributes that all elements inherit.
    fn inherited(&self) -> String {
        own_fonts(Sheet::INHERITED)
    }

    /// The elements of the drawing, with identifiers and fonts whose names no other part of the page has.
    fn body(&self) -> String {
        let references = [" id=\"", "url(#", "href=\"#"];
        references.into_iter().fold(own_fonts(&self.sheet.short_body()), |body, reference| {
            body.replace(reference, &format!("{reference}{}-", self.id))
        })
    }
}

/// The text with the page's names for the embedded fonts.
fn own_fonts(text: &str) -> String {
    FAMILIES.iter().fold(text.to_owned(), |text, (family, own)| text.replace(family, own))
}

#[cfg(test)]
mod tests {
    use super::*;

    use grazing_drawing::{Element, Path};

    #[test]
    fn identifiers_and_fonts_of_a_figure_are_its_own() {
        let path = |y, attributes: &str| {
            let pieces = vec![(vec![(0, 0), (1000, y)], false)];
            Element::Path(Path { pieces, attributes: attributes.to_owned() })
        };
        let elements = vec![
            Element::Markup("<clipPath id=\"c\"/>".to_owned()),
            path(50, " clip-path=\"url(#c)\""),
            Element::Markup("<use href=\"#c\" font-family=\"'STIX Two Math'\"/>".to_owned()),
        ];
        let sheet = &Sheet { size: (10.0, 10.0), elements, ..Sheet::default() };
        let (links, data) = (Default::default(), String::new());
        let heading = Safe(String::new());
        let section = FigureSection { id: "fig99", label: "", heading, sheet, links, data };
        assert_eq!(section.rem(), "1.2");
        assert!(section.inherited().starts_with("font-family=\"'Figure Text',"), "{}", section.inherited());
        assert_eq!(
            section.body(),
            "<rect width=\"10\" height=\"10\" fill=\"#ffffff\"/>\n<clipPath id=\"fig99-c\"/>\n\
             <path d=\"M0 0l10 .5\" clip-path=\"url(#fig99-c)\"/>\n\
             <use href=\"#fig99-c\" font-family=\"'Figure Signs'\"/>\n"
        );
    }
}
