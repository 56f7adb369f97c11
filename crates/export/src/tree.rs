//! What is drawn in a figure, element by element, and whether its characters can be.

use grazing_drawing::Bounds;
use resvg::tiny_skia::{Rect, Transform};
use resvg::usvg::{Group, Node, Tree};

use crate::error::ExportError;

/// The box around a transformed rectangle.
pub(crate) fn around(rectangle: Rect, transform: Transform) -> Bounds {
    let [left, top, right, bottom] = rectangle.transform(transform).map_or([f64::NAN; 4], |turned| {
        [turned.left(), turned.top(), turned.right(), turned.bottom()].map(f64::from)
    });
    Bounds { left, top, right, bottom }
}

/// Visits what is drawn, with the box that clip paths leave of it.
pub(crate) fn for_each<'a>(
    group: &'a Group,
    clip: Option<Bounds>,
    visit: &mut impl FnMut(&'a Node, Option<Bounds>),
) {
    let own = group.clip_path().map(|clip| around(clip.root().bounding_box(), group.abs_transform()));
    let clip = own.map(|own| clip.map_or(own, |outer| outer.common(own))).or(clip);
    for node in group.children() {
        match node {
            Node::Group(inner) => for_each(inner, clip, visit),
            other => visit(other, clip),
        }
    }
}

/// Every character has a glyph.
pub(crate) fn ensure_glyphs(tree: &Tree) -> Result<(), ExportError> {
    let mut lacking = None;
    for_each(tree.root(), None, &mut |node, _| {
        if let Node::Text(text) = node {
            let glyphs = || text.layouted().iter().flat_map(|span| &span.positioned_glyphs);
            let label: String = text.chunks().iter().map(|chunk| chunk.text()).collect();
            // A font's glyph 0 stands for all characters that it lacks.
            if glyphs().any(|glyph| glyph.id.0 == 0)
                || (glyphs().next().is_none() && !label.trim().is_empty())
            {
                lacking.get_or_insert(label);
            }
        }
    });
    match lacking {
        None => Ok(()),
        Some(label) => {
            Err(ExportError(format!("label `{label}` needs a character that the embedded fonts do not have")))
        }
    }
}
