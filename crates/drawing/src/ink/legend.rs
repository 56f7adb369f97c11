//! Samples of drawn objects for legends, in a box of 24 by 10 points, as plotters asks for them: elements at the middle of
//! the left side. They are not drawn on the sheet; a figure carries its legend for programs that display it.

use plotters::element::{DynElement, EmptyElement, IntoDynElement, Rectangle};
use plotters_backend::BackendCoord;

use crate::ink::canvas::Canvas;
use crate::ink::elements::{Area, Disc, Filling, Stroke};
use crate::ink::style::{Paint, Pen};

/// The corners of a box whose left side has its middle here, this far from the sides of the sample, in hundredths of a point.
fn corners((x, y): BackendCoord, beside: i32, above: i32) -> Vec<BackendCoord> {
    let (left, right, top, bottom) = (x + beside, x + 2400 - beside, y - 500 + above, y + 500 - above);
    vec![(left, top), (right, top), (right, bottom), (left, bottom)]
}

/// A line.
pub fn line(pen: Pen) -> impl Fn(BackendCoord) -> Stroke<BackendCoord> {
    move |(x, y)| Stroke::new([(x, y), (x + 2400, y)], pen)
}

/// A filled area.
pub fn area(paint: Paint) -> impl Fn(BackendCoord) -> Rectangle<BackendCoord> {
    move |(x, y)| Rectangle::new([(x, y - 500), (x + 2400, y + 500)], paint)
}

/// A hatched area.
pub fn hatching(pen: Pen) -> impl Fn(BackendCoord) -> Area<BackendCoord> {
    move |at| Area::new(vec![corners(at, 0, 0)], Filling::Hatching(pen))
}

/// The outline of a rectangle.
pub fn rectangle(pen: Pen) -> impl Fn(BackendCoord) -> Stroke<BackendCoord> {
    move |at| {
        let mut outline = corners(at, 500, 100);
        outline.push(outline[0]);
        Stroke::new(outline, pen)
    }
}

/// A cloud of dots.
pub fn dots(paint: Paint) -> impl Fn(BackendCoord) -> DynElement<'static, Canvas, BackendCoord> {
    let dot = move |right, down| Disc::new((right, down), 0.6, paint, None);
    move |at| {
        let left = EmptyElement::at(at) + dot(400, -200) + dot(900, 200) + dot(1200, -100);
        (left + dot(1700, 0) + dot(2000, 300)).into_dyn()
    }
}
