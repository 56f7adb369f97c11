//! Markers of points, composed of elements about a point.

use plotters::element::{DynElement, EmptyElement, IntoDynElement};
use plotters_backend::BackendCoord;

use crate::geometry::shapes::{star, triangle};
use crate::geometry::sheet::{Bounds, Spot, all_in_hundredths};
use crate::ink::canvas::Canvas;
use crate::ink::elements::{Area, Disc};
use crate::ink::style::{
    DISC_RADIUS, HOLLOW, HOLLOW_RIM, MARKER, MARKER_RIM, Pen, STAR_RADIUS, TRIANGLE_SIZE,
};

/// The kinds of markers in the paper.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Marker {
    /// A resonance.
    Triangle,
    /// Any other codimension-two point.
    Disc,
    /// A point of another figure.
    Star,
    /// The end of a curve that was followed no further.
    Ring,
}

/// The room for the rim of a marker, in points.
const RIM: f64 = 0.5;

impl Marker {
    /// The marker at a point.
    pub fn at<C: Clone + 'static>(self, point: C) -> DynElement<'static, Canvas, C> {
        self.rimmed(point, Some(MARKER_RIM))
    }

    /// The marker for a legend, without a rim, which separates it from curves.
    pub fn sample(self) -> impl Fn(BackendCoord) -> DynElement<'static, Canvas, BackendCoord> {
        let lower = if self == Marker::Triangle { 50 } else { 0 };
        move |(x, y)| self.rimmed((x + 1200, y + lower), None)
    }

    fn rimmed<C: Clone + 'static>(self, point: C, rim: Option<Pen>) -> DynElement<'static, Canvas, C> {
        let at = EmptyElement::at(point);
        let outline = |corners: &[Spot]| Area::ring(all_in_hundredths(corners), MARKER, rim);
        match self {
            Marker::Triangle => (at + outline(&triangle((0.0, 0.0), TRIANGLE_SIZE))).into_dyn(),
            Marker::Star => (at + outline(&star((0.0, 0.0), STAR_RADIUS))).into_dyn(),
            Marker::Disc => (at + Disc::new((0, 0), DISC_RADIUS, MARKER, rim)).into_dyn(),
            Marker::Ring => (at + Disc::new((0, 0), DISC_RADIUS, HOLLOW, Some(HOLLOW_RIM))).into_dyn(),
        }
    }

    /// The box of the marker about a spot, the rim included.
    pub fn around(self, spot: Spot) -> Bounds {
        let size = match self {
            Marker::Triangle => TRIANGLE_SIZE,
            Marker::Star => 2.0 * STAR_RADIUS,
            Marker::Disc | Marker::Ring => 2.0 * DISC_RADIUS,
        };
        Bounds::about(spot, size, size).grown(RIM)
    }
}
