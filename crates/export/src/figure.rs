//! A figure, read from its SVG with the figures' own fonts.

use std::sync::{Arc, OnceLock};

use grazing_drawing::FONT_FILES;
use resvg::usvg::fontdb::Database;
use resvg::usvg::{Options, Tree};

use crate::{ExportError, geometry};

/// User units to an inch: with 72 of them a unit is a point, as in the figures' view boxes.
const UNITS_PER_INCH: f32 = 72.0;

/// A figure that was read.
pub struct Figure {
    pub(crate) tree: Tree,
    title: String,
}

impl Figure {
    /// Reads an SVG.
    ///
    /// # Errors
    /// [`ExportError::Unreadable`]; [`ExportError::Glyph`] if a label cannot be set in the figures' fonts.
    pub fn read(svg: &str) -> Result<Figure, ExportError> {
        let options = Options { dpi: UNITS_PER_INCH, fontdb: fonts(), ..Options::default() };
        let figure = Figure { tree: Tree::from_str(svg, &options)?, title: title(svg) };
        geometry::ensure_glyphs(&figure.tree)?;
        Ok(figure)
    }

    /// The title that the SVG carries; empty if it carries none.
    pub fn title(&self) -> &str {
        &self.title
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

/// The text of the first title element, as our figures write it: without markup, with the five XML entities.
fn title(svg: &str) -> String {
    let Some((_, rest)) = svg.split_once("<title>") else {
        return String::new();
    };
    let text = rest.split_once("</title>").map_or("", |(text, _)| text);
    let entities = [("&lt;", "<"), ("&gt;", ">"), ("&quot;", "\""), ("&#39;", "'"), ("&amp;", "&")];
    entities.into_iter().fold(text.to_owned(), |text, (entity, character)| text.replace(entity, character))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_title_is_read_with_its_entities_and_may_be_missing() {
        assert_eq!(title("<svg><title>a &lt; b &amp;amp; c</title></svg>"), "a < b &amp; c");
        assert_eq!(title("<svg></svg>"), "");
    }

    #[test]
    fn only_the_fonts_of_the_figures_are_known() {
        let mut families: Vec<String> = fonts().faces().map(|face| face.families[0].0.clone()).collect();
        families.sort();
        assert_eq!(families, ["STIX Two Math", "STIX Two Text", "STIX Two Text"]);
    }
}
