//! A figure, read from its SVG with the figures' own fonts.

use std::sync::{Arc, OnceLock};

use grazing_drawing::FONT_FILES;
use resvg::usvg::fontdb::Database;
use resvg::usvg::{Options, Tree};

use crate::error::ExportError;
use crate::tree::ensure_glyphs;

/// User units to an inch: with 72 of them a unit is a point, as in the figures' view boxes.
const UNITS_PER_INCH: f32 = 72.0;

/// A figure that was read.
pub struct Drawing {
    pub(crate) tree: Tree,
}

impl Drawing {
    /// Reads an SVG.
    ///
    /// # Errors
    /// It is no SVG that can be drawn, or a label cannot be set in the figures' fonts.
    pub fn read(svg: &str) -> Result<Drawing, ExportError> {
        let options = Options { dpi: UNITS_PER_INCH, fontdb: fonts(), ..Options::default() };
        let drawing = Drawing { tree: Tree::from_str(svg, &options)? };
        ensure_glyphs(&drawing.tree)?;
        Ok(drawing)
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
    fn only_the_fonts_of_the_figures_are_known() {
        let mut families: Vec<String> = fonts().faces().map(|face| face.families[0].0.clone()).collect();
        families.sort();
        assert_eq!(families, ["STIX Two Math", "STIX Two Text", "STIX Two Text"]);
    }
}
