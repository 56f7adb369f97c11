//! The positions of labels and lines, read from the finished figure and not from its source.

use grazing_drawing::Bounds;
use grazing_report::Drawing;
use resvg::tiny_skia::{Path, PathSegment, Rect, Transform};
use resvg::usvg::{Group, Node, Tree};
use ttf_parser::Face;

/// A label as it is drawn.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Text {
    /// The characters of the label.
    pub(crate) text: String,
    /// The size of the line, in points.
    pub(crate) size: f64,
    /// The size of the smallest characters, which may be sub- or superscripts, in points.
    pub(crate) smallest: f64,
    /// The box of each character's ink.
    pub(crate) glyphs: Vec<Bounds>,
}

impl Text {
    /// The box of all ink; `None` without ink.
    pub(crate) fn bounds(&self) -> Option<Bounds> {
        self.glyphs.iter().copied().reduce(Bounds::joined)
    }

    /// Whether ink of one label lies over ink of the other by more than `slack` points, character
    /// by character.
    #[allow(dead_code)] // Where only what is exported is tested.
    pub(crate) fn overlaps(&self, other: &Text, slack: f64) -> bool {
        let over = |own: &Bounds, foreign: &Bounds| own.grown(-slack).overlaps(foreign);
        self.glyphs.iter().any(|own| other.glyphs.iter().any(|foreign| over(own, foreign)))
    }
}

/// A line or an area.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Shape {
    /// The box of the ink, as far as a clip path shows it.
    pub(crate) bounds: Bounds,
    /// The width of its stroke in points; `None` if it is only filled.
    pub(crate) stroke: Option<f64>,
    /// The corners and ends of each piece, in points of the sheet, in order.
    #[allow(dead_code)] // Likewise.
    pub(crate) pieces: Vec<Vec<(f64, f64)>>,
    /// Whether an area is filled, not only a line drawn.
    pub(crate) filled: bool,
}

/// The labels and shapes that a reader of a figure sees.
pub(crate) trait Reading {
    /// All labels, in the order in which they are drawn.
    fn texts(&self) -> Vec<Text>;

    /// All lines and areas, in the order in which they are drawn.
    fn shapes(&self) -> Vec<Shape>;
}

impl Reading for Drawing {
    fn texts(&self) -> Vec<Text> {
        let mut texts = Vec::new();
        for_each(self.tree().root(), None, &mut |node, _| {
            if let Node::Text(text) = node {
                texts.push(read_text(self.tree(), text));
            }
        });
        texts
    }

    fn shapes(&self) -> Vec<Shape> {
        let mut shapes = Vec::new();
        for_each(self.tree().root(), None, &mut |node, clip| {
            if let Node::Path(path) = node {
                let transform = path.abs_transform();
                // All transforms here are rotations and uniform scalings, so one factor serves all
                // directions.
                let scale = f64::from(transform.get_scale().0);
                let ink = around(path.stroke_bounding_box(), transform);
                shapes.push(Shape {
                    bounds: clip.map_or(ink, |clip| clip.common(ink)),
                    filled: path.fill().is_some(),
                    stroke: path.stroke().map(|stroke| scale * f64::from(stroke.width().get())),
                    pieces: pieces(path.data(), transform),
                });
            }
        });
        shapes
    }
}

/// The pieces of a path, closed ones with their first spot at the end; curves by their control points.
fn pieces(path: &Path, transform: Transform) -> Vec<Vec<(f64, f64)>> {
    let mut pieces: Vec<Vec<(f64, f64)>> = Vec::new();
    for segment in path.segments() {
        let further = match segment {
            PathSegment::MoveTo(at) => {
                pieces.push(Vec::new());
                vec![at]
            }
            PathSegment::LineTo(at) => vec![at],
            PathSegment::QuadTo(a, at) => vec![a, at],
            PathSegment::CubicTo(a, b, at) => vec![a, b, at],
            PathSegment::Close => Vec::new(),
        };
        let piece = pieces.last_mut().expect("a path begins with a move");
        if further.is_empty() {
            piece.extend(piece.first().copied());
        }
        piece.extend(further.into_iter().map(|mut at| {
            transform.map_point(&mut at);
            (f64::from(at.x), f64::from(at.y))
        }));
    }
    pieces
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

/// The box around a transformed rectangle.
fn around(rectangle: Rect, transform: Transform) -> Bounds {
    let [left, top, right, bottom] = rectangle.transform(transform).map_or([f64::NAN; 4], |turned| {
        [turned.left(), turned.top(), turned.right(), turned.bottom()].map(f64::from)
    });
    Bounds { left, top, right, bottom }
}

/// Visits all elements, each with the box that clip paths leave visible.
fn for_each<'a>(group: &'a Group, clip: Option<Bounds>, visit: &mut impl FnMut(&'a Node, Option<Bounds>)) {
    let own = group.clip_path().map(|clip| around(clip.root().bounding_box(), group.abs_transform()));
    let clip = own.map(|own| clip.map_or(own, |outer| outer.common(own))).or(clip);
    for node in group.children() {
        match node {
            Node::Group(inner) => for_each(inner, clip, visit),
            other => visit(other, clip),
        }
    }
}
