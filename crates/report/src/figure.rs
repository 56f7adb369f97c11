//! Figures: SVG inside the page, with the numbers that are drawn.

use grazing_results::Table;

use crate::html::{escape, identifier, json_string, put};
use crate::{OscillatorEntry, Report, data, ledger, prose, table};

/// A figure with its data.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
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
#[derive(Debug, PartialEq)]
struct Parts {
    /// The attributes of the root that the page needs.
    view_box: String,
    /// Millimetres.
    width: f64,
    attributes: String,
    description: String,
    style: String,
    body: String,
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
pub(crate) fn styles(report: &Report) -> String {
    let mut styles: Vec<String> = Vec::new();
    let of_oscillators = report.oscillators.iter().flat_map(|oscillator| &oscillator.figures);
    for figure in report.figures.iter().chain(of_oscillators) {
        // Each rule stands on a line of its own.
        for rule in parts(&figure.svg, &figure.name).style.lines() {
            if !rule.trim().is_empty() && !styles.iter().any(|known| known == rule) {
                styles.push(rule.to_owned());
            }
        }
    }
    styles.join("\n")
}

/// How figures are used.
pub(crate) const USE: &str = "<p class=\"lead scripted\">Point at a figure to read values off it; the nearest computed point is shown \
     with its row of the data. Click into a figure, or Tab to it, and the wheel or <kbd>+</kbd> <kbd>−</kbd> zoom, arrows move, \
     <kbd>0</kbd> shows all, <kbd>n</kbd> and <kbd>p</kbd> step through the computed points.</p>\n";

pub(crate) fn section(report: &Report) -> String {
    let mut html = format!(
        "<section id=\"figures\" aria-labelledby=\"figures-title\">\n<h2 id=\"figures-title\">Figures</h2>\n{USE}"
    );
    for figure in &report.figures {
        html.push_str(&one(report, figure));
    }
    html.push_str("</section>\n");
    html
}

fn one(report: &Report, figure: &Figure) -> String {
    let heading = match figure.title.split_once(": ") {
        Some((number, rest)) => {
            format!("<span class=\"eyebrow\">{}</span> {}", escape(number), prose(&capitalised(rest)))
        }
        None => escape(&figure.title),
    };
    let own = own_files(figure);
    let outputs = report.manifest.outputs.iter().filter(|file| own.contains(&file.path));
    let files: Vec<String> = outputs.map(|file| report.manifest.link(&file.path)).collect();
    let shown: Vec<&str> = report
        .claims
        .iter()
        .filter(|claim| claim.figures.contains(&figure.name))
        .map(|claim| claim.label.as_str())
        .collect();
    let mut links = linked("Files", &files);
    if !shown.is_empty() {
        links.push_str(&linked("Claims", &[ledger::links(&shown)]));
    }
    let frame =
        Frame { id: &figure.name, label: &figure.title, heading: format!("<h3>{heading}</h3>"), links };
    frame.around(figure)
}

/// A figure of an oscillator.
pub(crate) fn of_oscillator(oscillator: &OscillatorEntry, figure: &Figure) -> String {
    let own = own_files(figure);
    let files = oscillator.files.iter().filter(|path| own.contains(path));
    let files: Vec<String> =
        files.map(|path| format!("<a href=\"{0}\"><code>{0}</code></a>", escape(path))).collect();
    let frame = Frame {
        id: &format!("{}-{}", oscillator.anchor(), figure.name),
        label: &format!("{}: {}", oscillator.name, figure.title),
        heading: format!("<h4>{}</h4>", prose(&capitalised(&figure.title))),
        links: linked("Files", &files),
    };
    frame.around(figure)
}

/// What surrounds a figure on the page.
struct Frame<'a> {
    /// The identifier of the figure.
    id: &'a str,
    /// The name for those who do not see it.
    label: &'a str,
    /// HTML.
    heading: String,
    links: String,
}

impl Frame<'_> {
    fn around(&self, figure: &Figure) -> String {
        let Parts { view_box, width, attributes, description, body, .. } = parts(&figure.svg, self.id);
        let width = width * SCALE;
        let (name, title, heading) = (escape(self.id), escape(self.label), &self.heading);
        format!(
            "<figure id=\"{name}\" class=\"figure\">\n{heading}\n<div class=\"workbench\">\n\
             <div class=\"sheet\" tabindex=\"0\" role=\"group\" aria-roledescription=\"zoomable figure\" aria-label=\"{title}\" \
             aria-describedby=\"{name}-caption\">\n\
             <svg viewBox=\"{view_box}\" style=\"max-width:{width:.1}rem\" {attributes} role=\"img\" aria-label=\"{title}\">{body}</svg>\n</div>\n\
             <div class=\"side\">\n<div class=\"tools scripted\" role=\"toolbar\" aria-label=\"Zoom of {title}\">\
             <button type=\"button\" data-zoom=\"in\" aria-label=\"Zoom in\">+</button>\
             <button type=\"button\" data-zoom=\"out\" aria-label=\"Zoom out\">−</button>\
             <button type=\"button\" data-zoom=\"all\">Whole figure</button></div>\n\
             <div class=\"readout scripted\" aria-live=\"off\"></div>\n</div>\n</div>\n\
             <figcaption id=\"{name}-caption\"><p>{}</p>\n{}</figcaption>\n{}</figure>\n",
            prose(&description),
            self.links,
            tables(figure, self.id),
        )
    }
}

/// The paths that the figure's own files have among all.
fn own_files(figure: &Figure) -> Vec<String> {
    let tables = figure.tables.iter().map(table::path);
    std::iter::once(format!("{}.svg", figure.name)).chain(tables).collect()
}

/// A line of links with a word before them; nothing if there are none.
fn linked(word: &str, links: &[String]) -> String {
    match links {
        [] => String::new(),
        _ => format!("<p class=\"links\"><span>{word}</span> {}</p>\n", links.join(" ")),
    }
}

pub(crate) fn capitalised(text: &str) -> String {
    let mut characters = text.chars();
    characters.next().map_or_else(String::new, |first| first.to_uppercase().chain(characters).collect())
}

/// The tables for the scripts.
fn tables(figure: &Figure, id: &str) -> String {
    let mut json = String::from("{");
    for (index, table) in figure.tables.iter().enumerate() {
        let comma = if index == 0 { "" } else { ",\n" };
        put!(json, "{comma}{}:{}", json_string(table.name), json_string(&data::compact(table)));
    }
    json.push('}');
    let id = identifier("data", id);
    format!("<script type=\"application/json\" id=\"{}\">{json}</script>\n", escape(&id))
}

/// Takes an SVG file apart, and gives its identifiers and fonts names that no other part of the page has.
fn parts(svg: &str, name: &str) -> Parts {
    let start = svg.find("<svg").map_or(0, |start| start + "<svg".len());
    let head_end = svg[start..].find('>').map_or(svg.len(), |end| start + end);
    let head = &svg[start..head_end];
    let end = svg.rfind("</svg>").unwrap_or(svg.len()).max(head_end);
    let mut body = svg.get(head_end + 1..end).unwrap_or_default().to_owned();
    let description = take(&mut body, "desc");
    let _ = take(&mut body, "title");
    let mut style = take(&mut body, "style");
    let mut attributes = String::new();
    for kept in ["font-family", "xml:space", "stroke-linejoin", "fill"] {
        if let Some(value) = attribute(head, kept) {
            put!(attributes, "{kept}=\"{value}\" ");
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
        body,
    }
}

/// The value of an attribute in a start tag.
fn attribute<'a>(tag: &'a str, name: &str) -> Option<&'a str> {
    let start = tag.find(&format!(" {name}=\""))? + name.len() + 3;
    tag[start..].split('"').next()
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

fn unescaped(text: &str) -> String {
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
