//! A figure, read from its SVG with the figures' own fonts.

use std::sync::{Arc, OnceLock};

use grazing_drawing::FONT_FILES;
use resvg::usvg::fontdb::Database;
use resvg::usvg::{Group, Node, Options, Text, Tree, WriteOptions};

use super::error::FormatError;

/// User units to an inch: with 72 of them a unit is a point, as in the figures' view boxes.
const UNITS_PER_INCH: f32 = 72.0;

/// Decimals of coordinates in outlines: thousandths of a point.
const DECIMALS: u8 = 3;

/// A figure that has been read.
pub struct Drawing {
    pub(crate) tree: Tree,
}

impl Drawing {
    /// Reads an SVG.
    ///
    /// # Errors
    /// The text is no SVG that can be drawn, or a label cannot be set in the figures' fonts.
    pub fn read(svg: &str) -> Result<Drawing, FormatError> {
        let options = Options { dpi: UNITS_PER_INCH, fontdb: fonts(), ..Options::default() };
        let drawing = Drawing { tree: Tree::from_str(svg, &options)? };
        ensure_glyphs(&drawing.tree)?;
        Ok(drawing)
    }

    /// The elements of the figure, as they are drawn.
    pub fn tree(&self) -> &Tree {
        &self.tree
    }

    /// The figure as SVG without text: every glyph is a path, for systems that ignore embedded fonts.
    pub fn outlines(&self) -> String {
        self.tree.to_string(&WriteOptions { coordinates_precision: DECIMALS, ..WriteOptions::default() })
    }

    /// Width and height of the sheet, in points.
    pub fn size(&self) -> (f64, f64) {
        (f64::from(self.tree.size().width()), f64::from(self.tree.size().height()))
    }
}

/// All labels in a group.
fn labels(group: &Group) -> Vec<&Text> {
    let mut found = Vec::new();
    for node in group.children() {
        match node {
            Node::Group(inner) => found.extend(labels(inner)),
            Node::Text(text) => found.push(text.as_ref()),
            _ => {}
        }
    }
    found
}

/// Checks that every character has a glyph.
fn ensure_glyphs(tree: &Tree) -> Result<(), FormatError> {
    for text in labels(tree.root()) {
        let glyphs = || text.layouted().iter().flat_map(|span| &span.positioned_glyphs);
        let label: String = text.chunks().iter().map(|chunk| chunk.text()).collect();
        // A font's glyph 0 stands for all characters that it lacks.
        if glyphs().any(|glyph| glyph.id.0 == 0) || (glyphs().next().is_none() && !label.trim().is_empty()) {
            return Err(FormatError(format!(
                "label `{label}` needs a character that the embedded fonts do not have"
            )));
        }
    }
    Ok(())
}

/// The fonts of the figures, and no others.
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
