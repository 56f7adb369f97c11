//! Where labels and lines come to lie, read from the finished figure and not from what was meant.

use grazing_drawing::Bounds;
use resvg::tiny_skia::Rect;
use resvg::usvg::{Node, Tree};
use ttf_parser::Face;

use crate::figure::Drawing;
use crate::tree::{around, for_each};

/// A label as it is set.
#[derive(Debug, Clone, PartialEq)]
pub struct Text {
    /// Its characters.
    pub text: String,
    /// The size of its line, in points.
    pub size: f64,
    /// The size of its smallest characters, which may be sub- or superscripts, in points.
    pub smallest: f64,
    /// The box of each character's ink.
    pub glyphs: Vec<Bounds>,
}

impl Text {
    /// The box of all its ink; `None` if it has none.
    pub fn bounds(&self) -> Option<Bounds> {
        self.glyphs.iter().copied().reduce(Bounds::joined)
    }

    /// True if ink of one label lies over ink of the other by more than `slack` points, character
    /// by character.
    pub fn overlaps(&self, other: &Text, slack: f64) -> bool {
        let over = |own: &Bounds, foreign: &Bounds| own.grown(-slack).overlaps(foreign);
        self.glyphs.iter().any(|own| other.glyphs.iter().any(|foreign| over(own, foreign)))
    }
}

/// A line or an area.
#[derive(Debug, Clone, PartialEq)]
pub struct Shape {
    /// The box of its ink, as far as a clip path leaves it.
    pub bounds: Bounds,
    /// The width of its stroke in points; `None` if it is only filled.
    pub stroke: Option<f64>,
    /// The corners and ends of its pieces, in points of the sheet, in order.
    pub points: Vec<(f64, f64)>,
    /// Whether an area is filled, not only a line drawn.
    pub filled: bool,
}

impl Drawing {
    /// All labels, in the order in which they are drawn.
    pub fn texts(&self) -> Vec<Text> {
        let mut texts = Vec::new();
        for_each(self.tree.root(), None, &mut |node, _| {
            if let Node::Text(text) = node {
                texts.push(read_text(&self.tree, text));
            }
        });
        texts
    }

    /// All lines and areas, in the order in which they are drawn.
    pub fn shapes(&self) -> Vec<Shape> {
        let mut shapes = Vec::new();
        for_each(self.tree.root(), None, &mut |node, clip| {
            if let Node::Path(path) = node {
                let transform = path.abs_transform();
                // Our transforms are turns and even scalings, so one factor serves all directions.
                let scale = f64::from(transform.get_scale().0);
                let mut points = path.data().points().to_vec();
                transform.map_points(&mut points);
                let ink = around(path.stroke_bounding_box(), transform);
                shapes.push(Shape {
                    bounds: clip.map_or(ink, |clip| clip.common(ink)),
                    filled: path.fill().is_some(),
                    stroke: path.stroke().map(|stroke| scale * f64::from(stroke.width().get())),
                    points: points.iter().map(|point| (f64::from(point.x), f64::from(point.y))).collect(),
                });
            }
        });
        shapes
    }
}

fn read_text(tree: &Tree, text: &resvg::usvg::Text) -> Text {
    let sizes = || text.chunks().iter().flat_map(|chunk| chunk.spans()).map(|span| span.font_size().get());
    let scale = text.abs_transform().get_scale().0;
    let mut glyphs = Vec::new();
    for glyph in text.layouted().iter().flat_map(|span| &span.positioned_glyphs) {
        let ink = tree.fontdb().with_face_data(glyph.font, |data, index| {
            Face::parse(data, index).ok().and_then(|face| face.glyph_bounding_box(glyph.id))
        });
        let corners = ink.flatten().map(|ink| [ink.x_min, ink.y_min, ink.x_max, ink.y_max].map(f32::from));
        if let Some(rectangle) =
            corners.and_then(|[left, low, right, high]| Rect::from_ltrb(left, low, right, high))
        {
            let transform = text.abs_transform().pre_concat(glyph.outline_transform());
            glyphs.push(around(rectangle, transform));
        }
    }
    Text {
        text: text.chunks().iter().map(|chunk| chunk.text()).collect(),
        size: f64::from(scale * sizes().fold(0.0, f32::max)),
        smallest: f64::from(scale * sizes().fold(f32::INFINITY, f32::min)),
        glyphs,
    }
}
