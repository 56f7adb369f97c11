//! Elements for plotters with what its own lack: lines with dashes, round ends and all of their ink in a box,
//! areas with holes, rims and hatching, discs with rims.
//!
//! Like plotters' elements, they have the coordinates of the chart that they are drawn on, those of a sheet in points
//! ([`Canvas::draw`]), or those of the backend, hundredths of a point, where they are composed about a point:
//! `EmptyElement::at(point) + Disc::new((0, 0), 2.0, paint, None)`.

use core::iter::Flatten;
use core::slice::Iter;

use plotters::element::{Drawable, PointCollection};
use plotters::style::{RGBAColor, ShapeStyle};
use plotters_backend::{BackendCoord, DrawingErrorKind};

use crate::error::DrawingError;
use crate::geometry::clip::hatching;
use crate::geometry::sheet::{Bounds, Hundredths, all_in_hundredths, in_points};
use crate::ink::canvas::Canvas;
use crate::ink::style::{HATCHING, Paint, Pen};
use crate::ink::svg::{fill, stroke};

impl From<Pen> for ShapeStyle {
    /// A pen for plotters' own elements, without its dashes.
    fn from(Pen { colour: [red, green, blue], width, .. }: Pen) -> Self {
        let stroke_width = (100.0 * width).round() as u32;
        ShapeStyle { color: RGBAColor(red, green, blue, 1.0), filled: false, stroke_width }
    }
}

impl From<Paint> for ShapeStyle {
    fn from(Paint { colour: [red, green, blue], opacity }: Paint) -> Self {
        ShapeStyle { color: RGBAColor(red, green, blue, opacity), filled: true, stroke_width: 0 }
    }
}

/// How an element is drawn at the spots to which plotters maps its points.
pub trait Ink {
    /// Draws the element; the spots are in hundredths of a point.
    fn draw(&self, rings: Vec<Vec<Hundredths>>, canvas: &Canvas);
}

/// An element: points, as one or several rings, and their ink.
pub struct Shape<C, I> {
    rings: Vec<Vec<C>>,
    ink: I,
}

impl<'e, C, I> PointCollection<'e, C> for &'e Shape<C, I> {
    type Point = &'e C;
    type IntoIter = Flatten<Iter<'e, Vec<C>>>;

    fn point_iter(self) -> Self::IntoIter {
        self.rings.iter().flatten()
    }
}

impl<C, I: Ink> Drawable<Canvas> for Shape<C, I> {
    fn draw<S: Iterator<Item = BackendCoord>>(
        &self,
        mut spots: S,
        canvas: &mut Canvas,
        _: (u32, u32),
    ) -> Result<(), DrawingErrorKind<DrawingError>> {
        let rings = self.rings.iter().map(|ring| spots.by_ref().take(ring.len()).collect());
        self.ink.draw(rings.collect(), canvas);
        Ok(())
    }
}

impl<C, I> Shape<C, I> {
    /// An element at one point.
    pub(crate) fn at(point: C, ink: I) -> Self {
        Shape { rings: vec![vec![point]], ink }
    }
}

/// A line, closed if it ends where it begins; plotters' `PathElement` drawn with a pen.
pub type Stroke<C> = Shape<C, LineInk>;

/// The ink of a line.
pub struct LineInk {
    pen: Pen,
    within: Option<Bounds>,
}

impl<C> Stroke<C> {
    /// A line through points.
    pub fn new(points: impl Into<Vec<C>>, pen: Pen) -> Self {
        Shape { rings: vec![points.into()], ink: LineInk { pen, within: None } }
    }

    /// The line, no ink of which leaves a box of the sheet.
    pub(crate) fn within(mut self, bounds: Bounds) -> Self {
        self.ink.within = Some(bounds);
        self
    }
}

impl Ink for LineInk {
    fn draw(&self, rings: Vec<Vec<Hundredths>>, canvas: &Canvas) {
        for spots in rings {
            match &self.within {
                Some(bounds) => canvas.line_within(bounds, &spots, self.pen),
                None => canvas.line(&spots, stroke(Some(self.pen))),
            }
        }
    }
}

/// The area inside rings by the even-odd rule; plotters' `Polygon` with holes.
pub type Area<C> = Shape<C, Filling>;

/// The ink of an area.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Filling {
    /// Filled, with a rim if there is a pen.
    Paint(Paint, Option<Pen>),
    /// Hatched with parallel lines.
    Hatching(Pen),
}

impl From<Paint> for Filling {
    fn from(paint: Paint) -> Self {
        Filling::Paint(paint, None)
    }
}

impl<C> Area<C> {
    /// The area inside rings.
    pub fn new(rings: Vec<Vec<C>>, filling: impl Into<Filling>) -> Self {
        Shape { rings, ink: filling.into() }
    }

    /// The area inside one ring, with a rim if there is a pen.
    pub fn ring(corners: impl Into<Vec<C>>, paint: Paint, rim: Option<Pen>) -> Self {
        Area::new(vec![corners.into()], Filling::Paint(paint, rim))
    }

    /// The first ring.
    pub fn border(&self) -> &[C] {
        self.rings.first().map_or(&[], Vec::as_slice)
    }
}

impl Ink for Filling {
    fn draw(&self, rings: Vec<Vec<Hundredths>>, canvas: &Canvas) {
        match *self {
            Filling::Paint(paint, rim) => {
                let rule = if rings.len() > 1 { " fill-rule=\"evenodd\"" } else { "" };
                let attributes = format!("{rule}{}{}", fill(paint), stroke(rim));
                canvas.path(rings.into_iter().map(|ring| (ring, true)), attributes);
            }
            Filling::Hatching(pen) => {
                let spots = |ring: Vec<Hundredths>| ring.into_iter().map(in_points).collect();
                for line in hatching(&rings.into_iter().map(spots).collect::<Vec<_>>(), HATCHING) {
                    canvas.line(&all_in_hundredths(&line), stroke(Some(pen)));
                }
            }
        }
    }
}

/// A filled disc; plotters' `Circle` with a rim.
pub type Disc<C> = Shape<C, DiscInk>;

/// The ink of a disc.
pub struct DiscInk {
    radius: f64,
    attributes: String,
}

impl<C> Disc<C> {
    /// A disc with a radius in points, and a rim if there is a pen.
    pub fn new(centre: C, radius: f64, paint: Paint, rim: Option<Pen>) -> Self {
        Shape::at(centre, DiscInk { radius, attributes: fill(paint) + &stroke(rim) })
    }
}

impl Ink for DiscInk {
    fn draw(&self, rings: Vec<Vec<Hundredths>>, canvas: &Canvas) {
        let radius = (100.0 * self.radius).round() as u32;
        rings.iter().flatten().for_each(|centre| canvas.circle(*centre, radius, &self.attributes));
    }
}
