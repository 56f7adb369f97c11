//! What the page reads in the SVG of a figure, and how it shortens it.

use roxmltree::{Document, Node};
use svgtypes::{PathParser, PathSegment};

/// Attributes of the root that are kept on the page.
const INHERITED: [&str; 4] = ["font-family", "space", "stroke-linejoin", "fill"];
/// Hundredths are whole up to this: what is left of reading a decimal number is below 1e-9, a third decimal at least 0.1.
const DECIMALS_BEYOND: f64 = 1e-3;
/// Elements that are not drawn.
const APART: [&str; 3] = ["title", "desc", "style"];

/// A figure's file, read: what it says of itself beside what it draws.
pub(crate) struct SvgFile<'a> {
    source: &'a str,
    document: Document<'a>,
}

impl<'a> SvgFile<'a> {
    /// Reads a file.
    ///
    /// # Panics
    /// It is not well-formed XML: figures are what `grazing-drawing` writes.
    pub(crate) fn read(source: &'a str) -> Self {
        let document = Document::parse(source).expect("a figure is well-formed SVG");
        Self { source, document }
    }

    /// An attribute of the root.
    pub(crate) fn attribute(&self, name: &str) -> Option<&str> {
        self.document.root_element().attribute(name)
    }

    /// Those attributes of the root that all that it draws inherits, as they are written.
    pub(crate) fn inherited(&self) -> String {
        let attributes = self.document.root_element().attributes();
        let kept = attributes.filter(|attribute| INHERITED.contains(&attribute.name()));
        kept.map(|attribute| &self.source[attribute.range()]).collect::<Vec<_>>().join(" ")
    }

    /// The text of an element below the root; empty without one.
    pub(crate) fn text(&self, element: &str) -> &str {
        self.parts().find(|part| part.has_tag_name(element)).and_then(|part| part.text()).unwrap_or_default()
    }

    /// What it draws, as it is written.
    pub(crate) fn drawing(&self) -> String {
        let drawn = self.parts().filter(|part| !is_legend(part) && !APART.contains(&part.tag_name().name()));
        drawn.map(|part| &self.source[part.range()]).collect()
    }

    /// The samples of its legend, as they are written, and their meanings.
    pub(crate) fn legend(&self) -> Vec<(String, String)> {
        let entries = self.parts().filter(is_legend).flat_map(|legend| legend.children());
        let entry = |entry: Node<'_, '_>| {
            let sample = entry.children().map(|part| &self.source[part.range()]).collect();
            (sample, entry.attribute("aria-label").unwrap_or_default().to_owned())
        };
        entries.map(entry).collect()
    }

    /// Whether a panel shows rows of the table; one that names none may show any but regions, which are areas, not points.
    pub(crate) fn shows(&self, table: &str) -> bool {
        self.panels().any(|panel| match panel.attribute("data-tables") {
            Some(named) => named.split(' ').any(|name| name == table),
            None => !table.ends_with("_regions"),
        })
    }

    /// The values at the ends of the axes of all panels.
    pub(crate) fn ranges(&self) -> impl Iterator<Item = [f64; 2]> {
        let range = |panel: &Node<'_, '_>, name| {
            let (low, high) = panel.attribute(name)?.split_once(' ')?;
            Some([low.parse().ok()?, high.parse().ok()?])
        };
        self.panels().flat_map(move |panel| ["data-x", "data-y"].map(|name| range(&panel, name))).flatten()
    }

    fn parts(&self) -> impl Iterator<Item = Node<'_, 'a>> {
        self.document.root_element().children()
    }

    fn panels(&self) -> impl Iterator<Item = Node<'_, 'a>> {
        self.parts().filter(|part| part.attribute("class") == Some("panel"))
    }
}

fn is_legend(part: &Node<'_, '_>) -> bool {
    part.attribute("class") == Some("legend")
}

/// The same drawing with paths from point to point, each as far from the one before: half as long, and the same to a hundredth.
pub(crate) fn with_short_paths(body: &str) -> String {
    const START: &str = " d=\"";
    let mut short = String::with_capacity(body.len());
    let mut rest = body;
    while let Some(start) = rest.find(START) {
        let (before, path) = rest.split_at(start + START.len());
        let (path, after) = path.split_at(path.find('"').unwrap_or(path.len()));
        short.push_str(before);
        match short_path(path) {
            Some(shorter) => short.push_str(&shorter),
            None => short.push_str(path),
        }
        rest = after;
    }
    short + rest
}

/// The path if it is one of moves, lines and returns to points in hundredths.
fn short_path(path: &str) -> Option<String> {
    let mut short = String::new();
    let (mut last, mut in_line) = ((0, 0), false);
    for segment in PathParser::from(path) {
        let (spot, is_line) = match segment.ok()? {
            PathSegment::MoveTo { abs: true, x, y } => ((hundredths(x)?, hundredths(y)?), false),
            PathSegment::LineTo { abs: true, x, y } => ((hundredths(x)?, hundredths(y)?), true),
            PathSegment::ClosePath { .. } => {
                short.push('Z');
                in_line = false;
                continue;
            }
            _ => return None,
        };
        // A command that follows itself need not be repeated.
        match (is_line, in_line) {
            (false, _) => short.push('M'),
            (true, false) => short.push('l'),
            (true, true) => {}
        }
        push_pair(&mut short, if is_line { (spot.0 - last.0, spot.1 - last.1) } else { spot });
        (last, in_line) = (spot, is_line);
    }
    Some(short)
}

/// The hundredths in a number, if it is a whole number of them.
fn hundredths(number: f64) -> Option<i64> {
    let nearest = (100.0 * number).round();
    ((100.0 * number - nearest).abs() < DECIMALS_BEYOND).then_some(nearest as i64)
}

/// Two numbers, separated by a space only where no sign stands between them.
fn push_pair(text: &mut String, (x, y): (i64, i64)) {
    for number in [x, y] {
        let written = written(number);
        let after_number = text.ends_with(|c: char| c.is_ascii_digit());
        if after_number && !written.starts_with('-') {
            text.push(' ');
        }
        text.push_str(&written);
    }
}

/// Hundredths as a number without idle zeros.
fn written(hundredths: i64) -> String {
    let sign = if hundredths < 0 { "-" } else { "" };
    let (whole, parts) = (hundredths.unsigned_abs() / 100, hundredths.unsigned_abs() % 100);
    match (whole, parts) {
        (whole, 0) => format!("{sign}{whole}"),
        (0, parts) => format!("{sign}.{parts:02}").trim_end_matches('0').to_owned(),
        (whole, parts) => format!("{sign}{whole}.{parts:02}").trim_end_matches('0').to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_become_shorter_and_stay_the_same() {
        for (long, short) in [
            ("M24.4,83.84L24.4,82.89L23.4,83L30,-5Z", "M24.4 83.84l0-.95-1 .11 6.6-88Z"),
            ("M0.5,-0.25L0.5,0.25M1,1L2,2", "M.5-.25l0 .5M1 1l1 1"),
        ] {
            assert_eq!(short_path(long).as_deref(), Some(short));
        }
        for other in ["M1,2h0m3,4h0", "M1,2L3", "M1.234,5L2,3", "M1,2C1,2 3,4 5,6"] {
            assert_eq!(short_path(other), None, "{other}");
        }
    }

    #[test]
    fn only_paths_are_touched() {
        let body = "<path d=\"M1,1L2,2\" stroke=\"#fff\"/><text id=\"M1,1L2,2\">a</text><path d=\"M1,1h0\"/>";
        let short =
            "<path d=\"M1 1l1 1\" stroke=\"#fff\"/><text id=\"M1,1L2,2\">a</text><path d=\"M1,1h0\"/>";
        assert_eq!(with_short_paths(body), short);
    }

    #[test]
    fn diagrams_have_legends_of_what_they_show_and_sketches_have_none() {
        let legend = |name: &str| -> Vec<String> {
            let file =
                std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../../figures/{name}.svg"));
            let svg = std::fs::read_to_string(file).expect("the figures stand in the repository");
            SvgFile::read(&svg).legend().into_iter().map(|(_, meaning)| meaning).collect()
        };
        for sketch in ["fig01", "fig03", "fig06", "fig09", "fig10"] {
            assert!(legend(sketch).is_empty(), "{sketch}");
        }
        for (name, words, there) in [
            ("fig02", "unstable", true),
            ("fig02", "long-time behaviour", true),
            ("fig02", "$p=3$", true),
            ("fig02", "$p=6$", false),
            ("fig04", "$h_p$", true),
            ("fig04", "$p=6$", true),
            ("fig05", "period-doubling bifurcation", true),
            ("fig05", "(GZ)", false),
            ("fig05", "a maximal periodic solution is stable", true),
            ("fig07", "(GZ)", true),
            ("fig07", "where a one-parameter diagram runs", true),
            ("fig07", "quadratic approximation", false),
            ("fig07", "another codimension-two point", true),
            ("fig08", "quadratic approximation to PD", true),
            ("fig08", "the non-impacting solution is stable", true),
            ("fig08", "stability is not decided", false),
        ] {
            let found = legend(name).iter().any(|meaning| meaning.contains(words));
            assert_eq!(found, there, "{name}: {words}: {:?}", legend(name));
        }
    }
}
