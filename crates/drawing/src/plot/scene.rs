//! Scenes in phase space, as in Figures 1, 3 and 9: translucent surfaces, curves, points.
//!
//! The rows contain the projected coordinates and the order of painting; here they are scaled to the
//! sheet. Where two curves cross on the sheet, the farther one is interrupted.

use grazing_results::space::{CurveKind, Mark, Scene, SurfaceKind, Vertex};
use grazing_results::{Frame, span};

use crate::error::DrawingError;
use crate::geometry::clip::checked;
use crate::geometry::passing::{SpaceCurve, interrupted};
use crate::geometry::sheet::{Bounds, Spot, length};
use crate::ink::arrow::{arrow, head_on};
use crate::ink::canvas::Canvas;
use crate::ink::elements::{Area, Disc, Stroke};
use crate::ink::labels::{Labels, Site};
use crate::ink::sheet::Sheet;
use crate::ink::style::{
    BLACK, CIRCLE, Colour, FACE_EDGE, FLOW, INCOMING_FACE, OPEN_SPOT, OUTGOING_FACE, PERIODIC_FLOW, Paint,
    Pen, RESET, RETURN, SECTION_FACE, SPACE_AXIS, SPOT, SPOT_RADIUS, SPOT_RIM, SheetWidth, TANGENCY,
    TITLE_SIZE, VIRTUAL_FLOW,
};
use crate::ink::svg::POINTS_PER_MM;

/// The pen of a kind of curve.
fn pen(kind: CurveKind) -> Pen {
    match kind {
        CurveKind::Orbit => FLOW,
        CurveKind::Virtual => VIRTUAL_FLOW,
        CurveKind::Periodic => PERIODIC_FLOW,
        CurveKind::Reset => RESET,
        CurveKind::Global => RETURN,
    }
}

/// Whether the curve follows the flow; false for arrows of maps.
fn flows(kind: CurveKind) -> bool {
    matches!(kind, CurveKind::Orbit | CurveKind::Virtual | CurveKind::Periodic)
}

/// The paint of a kind of surface; none for a line on a surface.
fn face(kind: SurfaceKind) -> Option<Paint> {
    match kind {
        SurfaceKind::Incoming => Some(INCOMING_FACE),
        SurfaceKind::Outgoing => Some(OUTGOING_FACE),
        SurfaceKind::Section => Some(SECTION_FACE),
        _ => None,
    }
}

/// The name of an axis.
fn axis(kind: SurfaceKind) -> Option<&'static str> {
    match kind {
        SurfaceKind::AxisX => Some("$x$"),
        SurfaceKind::AxisY => Some("$y$"),
        SurfaceKind::AxisZ => Some("$z$"),
        _ => None,
    }
}

/// A curve or surface, or the part of one that lies in one layer, on the sheet.
struct Piece<K> {
    kind: K,
    number: u32,
    layer: u32,
    /// Coordinates to the right, downwards and away from the viewer.
    course: SpaceCurve,
}

impl<K> Piece<K> {
    fn spots(&self) -> Vec<Spot> {
        self.course.iter().map(|&[x, y, _]| (x, y)).collect()
    }

    /// The length of the piece on the sheet.
    fn length(&self) -> f64 {
        length(&self.spots())
    }
}

/// The properties of a figure in phase space other than its rows.
pub struct SpaceSheet {
    /// The name by which errors refer to the figure.
    pub name: &'static str,
    /// The title of the SVG, for screen readers.
    pub title: &'static str,
    /// The description of the SVG, for screen readers.
    pub description: &'static str,
    /// The width of the figure in the paper.
    pub width_mm: f64,
    /// Room around the scene, in points from each edge of the sheet.
    pub margin: Bounds,
    /// A function that gives the name of a point, if it has one.
    pub mark: fn(&Mark) -> Option<String>,
    /// The font size of these names.
    pub mark_size: f64,
    /// Further named parts, in the order in which positions are chosen; each with its name, size and
    /// colour.
    pub names: &'static [(NamedPart, &'static str, f64, Colour)],
}

/// A part of a scene that has a name.
pub enum NamedPart {
    /// Every curve of a kind.
    Curves(CurveKind),
    /// The first surface of a kind, with its name on it.
    Face(SurfaceKind),
    /// The first line of a kind.
    Line(SurfaceKind),
    /// The first line of a kind that lies on named surfaces: a leader leads to it.
    Border(SurfaceKind),
}

impl SpaceSheet {
    /// Draws the scene.
    ///
    /// # Errors
    /// A coordinate is not finite.
    pub fn draw(&self, figure: &Scene, width: SheetWidth) -> Result<Sheet, DrawingError> {
        let (shown, canvas) = OnSheet::fit(figure, self.name, width.mm(self.width_mm), &self.margin)?;
        shown.paint(&canvas)?;
        let mut labels = shown.labels(&canvas)?;
        for (spot, mark) in &shown.points {
            if let Some(name) = (self.mark)(mark) {
                labels.add(&name, self.mark_size, BLACK, &Site::Around(*spot, SPOT_RADIUS + 0.5))?;
            }
        }
        for &(ref named, text, size, colour) in self.names {
            let first = |kind| shown.surfaces.iter().find(|piece| piece.kind == kind).map(Piece::spots);
            match *named {
                NamedPart::Curves(kind) => {
                    for index in shown.longest(|piece| piece.kind == kind) {
                        let line = shown.curves[index].spots();
                        labels.add(text, size, colour, &Site::Pieces(&[&line]))?;
                    }
                }
                NamedPart::Face(kind) => {
                    if let Some(outline) = first(kind) {
                        labels.add(text, size, colour, &Site::Within(&outline))?;
                    }
                }
                NamedPart::Line(kind) => {
                    if let Some(line) = first(kind) {
                        labels.add(text, size, colour, &Site::Pieces(&[&line]))?;
                    }
                }
                NamedPart::Border(kind) => {
                    if let Some(line) = first(kind) {
                        labels.add(text, size, colour, &Site::Led(&line))?;
                    }
                }
            }
        }
        labels.draw()?;
        canvas.finish(self.name, self.title, self.description)
    }
}

/// All objects of a figure in phase space, on the sheet.
struct OnSheet {
    curves: Vec<Piece<CurveKind>>,
    surfaces: Vec<Piece<SurfaceKind>>,
    /// The points that are marked.
    points: Vec<(Spot, Mark)>,
}

impl OnSheet {
    /// Scales the scene so that it fills a sheet of the given width, which determines the height; returns
    /// it with the empty sheet.
    fn fit(
        figure: &Scene,
        name: &'static str,
        width_mm: f64,
        margin: &Bounds,
    ) -> Result<(Self, Canvas), DrawingError> {
        let curves = figure.curves.iter().map(|vertex| vertex.place);
        let surfaces = figure.surfaces.iter().map(|vertex| vertex.place);
        let marks = figure.points.iter().map(|mark| [mark.across, mark.up, mark.depth]);
        let places: Vec<[f64; 3]> = curves.chain(surfaces).chain(marks).collect();
        // If any coordinate is not finite, there is no frame.
        let whole = places.iter().flatten().all(|coordinate| coordinate.is_finite());
        let range = |k: usize| {
            if whole { span(places.iter().map(|place| place[k])) } else { [f64::NAN; 2] }
        };
        let frame = checked(Frame { x: range(0), y: range(1) }, name)?;
        let width = width_mm * POINTS_PER_MM;
        let scale = (width - margin.left - margin.right) / (frame.x[1] - frame.x[0]);
        let on_sheet = |[across, up, depth]: [f64; 3]| {
            let right = margin.left + scale * (across - frame.x[0]);
            [right, margin.top + scale * (frame.y[1] - up), scale * depth]
        };
        let spotted = |mark: &Mark| {
            let [right, down, _] = on_sheet([mark.across, mark.up, mark.depth]);
            ((right, down), mark.clone())
        };
        let height = margin.top + margin.bottom + scale * (frame.y[1] - frame.y[0]);
        let scene = OnSheet {
            curves: pieces(&figure.curves, on_sheet),
            surfaces: pieces(&figure.surfaces, on_sheet),
            points: figure.points.iter().map(spotted).collect(),
        };
        Ok((scene, Canvas::new(width_mm, height / POINTS_PER_MM)?))
    }

    /// Paints everything, layer by layer; within a layer: faces, lines on them, curves from far to near,
    /// points.
    fn paint(&self, canvas: &Canvas) -> Result<(), DrawingError> {
        let mut layers: Vec<u32> = self.curves.iter().map(|piece| piece.layer).collect();
        layers.extend(self.surfaces.iter().map(|piece| piece.layer));
        layers.extend(self.points.iter().map(|(_, mark)| mark.layer));
        layers.sort_unstable();
        layers.dedup();
        let flowing: Vec<&SpaceCurve> =
            self.curves.iter().filter(|c| flows(c.kind)).map(|piece| &piece.course).collect();
        let headed = self.headed();
        for layer in layers {
            let here: Vec<_> = self.surfaces.iter().filter(|piece| piece.layer == layer).collect();
            for piece in &here {
                if let Some(paint) = face(piece.kind) {
                    canvas.draw(&Area::ring(piece.spots(), paint, Some(FACE_EDGE)))?;
                }
            }
            for piece in &here {
                self.line(canvas, piece)?;
            }
            let mut curves: Vec<usize> =
                (0..self.curves.len()).filter(|&i| self.curves[i].layer == layer).collect();
            curves.sort_by(|&a, &b| depth(&self.curves[b].course).total_cmp(&depth(&self.curves[a].course)));
            for index in curves {
                self.curve(canvas, index, &flowing, headed.contains(&index))?;
            }
            for (spot, mark) in self.points.iter().filter(|(_, mark)| mark.layer == layer) {
                // No orbit of the full system goes beyond the wall.
                let paint = if mark.x > 0.0 { OPEN_SPOT } else { SPOT };
                canvas.draw(&Disc::new(*spot, SPOT_RADIUS, paint, Some(SPOT_RIM)))?;
            }
        }
        Ok(())
    }

    /// Draws a line on a surface; the last piece of an axis ends in a head.
    fn line(&self, canvas: &Canvas, piece: &Piece<SurfaceKind>) -> Result<(), DrawingError> {
        let pen = match piece.kind {
            SurfaceKind::Tangency => TANGENCY,
            SurfaceKind::Circle => CIRCLE,
            kind if axis(kind).is_none() => return Ok(()),
            _ if last_of(&self.surfaces, piece) => return arrow(canvas, &piece.spots(), 0.0, SPACE_AXIS),
            _ => SPACE_AXIS,
        };
        canvas.draw(&Stroke::new(piece.spots(), pen))
    }

    fn curve(
        &self,
        canvas: &Canvas,
        index: usize,
        flowing: &[&SpaceCurve],
        headed: bool,
    ) -> Result<(), DrawingError> {
        let piece = &self.curves[index];
        let pen = pen(piece.kind);
        if !flows(piece.kind) {
            let spots = piece.spots();
            return if last_of(&self.curves, piece) {
                arrow(canvas, &spots, SPOT_RADIUS + 0.8, pen)
            } else {
                canvas.draw(&Stroke::new(spots, pen))
            };
        }
        for part in interrupted(&piece.course, flowing) {
            canvas.draw(&Stroke::new(part, pen))?;
        }
        if headed {
            let spots = piece.spots();
            let places: &[f64] = if length(&spots) > TWO_HEADS { &[0.3, 0.72] } else { &[0.58] };
            for share in places {
                head_on(canvas, &spots, *share, pen)?;
            }
        }
        Ok(())
    }

    /// The longest piece of each curve, in the order of the curves, among the wanted pieces.
    fn longest(&self, wanted: impl Fn(&Piece<CurveKind>) -> bool) -> Vec<usize> {
        let mut longest: Vec<usize> = Vec::new();
        for index in (0..self.curves.len()).filter(|&index| wanted(&self.curves[index])) {
            let piece = &self.curves[index];
            match longest.iter_mut().find(|other| self.curves[**other].number == piece.number) {
                Some(other) if self.curves[*other].length() < piece.length() => *other = index,
                Some(_) => {}
                None => longest.push(index),
            }
        }
        longest
    }

    /// The pieces with a head that shows the direction of time: the longest piece of each curve if it is
    /// long enough, and every very long piece.
    fn headed(&self) -> Vec<usize> {
        let long = |least: f64| move |piece: &Piece<CurveKind>| flows(piece.kind) && piece.length() >= least;
        let mut headed = self.longest(long(HEADED_LENGTH));
        headed.extend((0..self.curves.len()).filter(|&index| long(OWN_HEAD)(&self.curves[index])));
        headed
    }

    /// Labels for this scene, which avoid its curves, lines and points; the axes are already labelled.
    fn labels<'c>(&self, canvas: &'c Canvas) -> Result<Labels<'c>, DrawingError> {
        let mut labels = Labels::new(canvas, canvas.sheet().grown(-1.0));
        for piece in &self.curves {
            labels.placer.keep_off(&piece.spots());
        }
        for piece in &self.surfaces {
            let mut spots = piece.spots();
            if face(piece.kind).is_some() {
                spots.extend(spots.first().copied());
            }
            labels.placer.keep_off(&spots);
        }
        for (spot, _) in &self.points {
            // A box inside the disc, so that a leader may reach the disc's rim from any side.
            labels.placer.block(Bounds::about(*spot, 1.6 * SPOT_RADIUS, 1.6 * SPOT_RADIUS));
        }
        for piece in &self.surfaces {
            if let (Some(name), true) = (axis(piece.kind), last_of(&self.surfaces, piece)) {
                let spots = piece.spots();
                if let Some(&tip) = spots.last() {
                    labels.add(name, TITLE_SIZE, BLACK, &Site::Around(tip, 2.0))?;
                }
            }
        }
        Ok(labels)
    }
}

/// Curves shorter than this (points) have no head.
const HEADED_LENGTH: f64 = 24.0;
/// Pieces longer than this have a head in any case.
const OWN_HEAD: f64 = 130.0;
/// Pieces longer than this have two heads.
const TWO_HEADS: f64 = 240.0;

/// Whether no later piece belongs to the same curve.
fn last_of<K>(pieces: &[Piece<K>], piece: &Piece<K>) -> bool {
    pieces
        .iter()
        .rev()
        .find(|other| other.number == piece.number)
        .is_some_and(|last| std::ptr::eq(last, piece))
}

/// The mean distance from the viewer.
fn depth(course: &SpaceCurve) -> f64 {
    course.iter().map(|point| point[2]).sum::<f64>() / course.len() as f64
}

fn pieces<K: Copy>(vertices: &[Vertex<K>], on_sheet: impl Fn([f64; 3]) -> [f64; 3]) -> Vec<Piece<K>> {
    let pieces = vertices.chunk_by(|a, b| (a.number, a.piece) == (b.number, b.piece));
    let piece = |vertices: &[Vertex<K>]| {
        let Vertex { kind, number, layer, .. } = vertices[0];
        Piece { kind, number, layer, course: vertices.iter().map(|vertex| on_sheet(vertex.place)).collect() }
    };
    pieces.map(piece).collect()
}
