//! A figure, read from its SVG with the figures' own fonts.

use std::sync::{Arc, OnceLock};

use grazing_drawing::FONT_FILES;
use resvg::usvg::fontdb::Database;
use resvg::usvg::roxmltree::{Document, ParsingOptions};
use resvg::usvg::{Options, Tree};

use crate::error::ExportError;
use crate::tree::ensure_glyphs;

/// User units to an inch: with 72 of them a unit is a point, as in the figures' view boxes.
const UNITS_PER_INCH: f32 = 72.0;

/// The name space of the elements.
const SVG: &str = "http://www.w3.org/2000/svg";

/// A figure that was read.
pub struct Drawing {
    pub(crate) tree: Tree,
    title: String,
    description: String,
}

impl Drawing {
    /// Reads an SVG.
    ///
    /// # Errors
    /// It is no SVG that can be drawn, or a label cannot be set in the figures' fonts.
    pub fn read(svg: &str) -> Result<Drawing, ExportError> {
        let options = Options { dpi: UNITS_PER_INCH, fontdb: fonts(), ..Options::default() };
        let parsing = ParsingOptions { allow_dtd: true, ..ParsingOptions::default() };
        let document = Document::parse_with_options(svg, parsing).map_err(resvg::usvg::Error::from)?;
        let text = |element| {
            let found = document.descendants().find(|node| node.has_tag_name((SVG, element)));
            found.and_then(|node| node.text()).unwrap_or_default().to_owned()
        };
        let (title, description) = (text("title"), text("desc"));
        let figure = Drawing { tree: Tree::from_xmltree(&document, &options)?, title, description };
        ensure_glyphs(&figure.tree)?;
        Ok(figure)
    }

    /// The title that the SVG carries; empty if it carries none.
    pub fn title(&self) -> &str {
        &self.title
    }

    /// What it shows, in the words that the SVG carries for readers who cannot see it; empty if it carries none.
    pub fn description(&self) -> &str {
        &self.description
    }

    /// Width and height of the sheet, in points.
    pub fn size(&self) -> (f64, f64) {
        (f64::from(self.tree.size().width()), f64::from(self.tree.size().height()))
    }
}

/// The fonts of the figures and no others.
fn fonts() -> Arc<Database> {
    static FONTS: OnceLock<Arc<Database>> = OnceLock::new();
    let load = || {
        let mut fonts = Database::new();
        for (_, bytes) in FONT_FILES {
            fonts.load_font_data(bytes.to_vec());
        }
        Arc::new(fonts)
    };
    FONTS.get_or_init(load).clone()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_title_is_read_with_its_entities_and_may_be_missing() {
        let title = |content: &str| {
            let svg = format!("<svg xmlns=\"{SVG}\" width=\"9\" height=\"9\">{content}</svg>");
            Drawing::read(&svg).expect("an SVG").title().to_owned()
        };
        assert_eq!(title("<title>a &lt; b &amp;amp; c</title>"), "a < b &amp; c");
        assert_eq!(title(""), "");
    }

    #[test]
    fn only_the_fonts_of_the_figures_are_known() {
        let mut families: Vec<String> = fonts().faces().map(|face| face.families[0].0.clone()).collect();
        families.sort();
        assert_eq!(families, ["STIX Two Math", "STIX Two Text", "STIX Two Text"]);
    }
}
