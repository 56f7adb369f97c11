//! Samples of drawn objects for legends. They are not drawn on the sheet; a figure carries its legend for
//! programs that display it.

use crate::geometry::shapes::triangle;
use crate::geometry::sheet::in_hundredths;
use crate::ink::measured::MeasuredMark;
use crate::ink::style::{DISC_RADIUS, HOLLOW, HOLLOW_RIM, MARKER, Paint, Pen, TRIANGLE_SIZE};
use crate::ink::svg::{fill, path_data, points, stroke};

/// A sample of a drawn object.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Sample {
    /// A line.
    Line(Pen),
    /// A filled area.
    Area(Paint),
    /// A hatched area.
    Hatching(Pen),
    /// The outline of a rectangle.
    Rectangle(Pen),
    /// A cloud of dots.
    Dots(Paint),
    /// The marker of a resonance.
    Triangle,
    /// The marker of another point.
    Disc,
    /// The marker of a curve's end.
    Ring,
    /// The mark of a measurement.
    Measured(MeasuredMark),
}

impl Sample {
    /// The sample drawn in a box of 24 by 10 points.
    pub(crate) fn element(self) -> String {
        match self {
            Sample::Line(pen) => format!("<path d=\"M0,5L24,5\"{}/>", stroke(Some(pen))),
            Sample::Area(paint) => format!("<rect width=\"24\" height=\"10\"{}/>", fill(paint)),
            Sample::Hatching(pen) => {
                format!("<path d=\"M2,9L10,1M8,9L16,1M14,9L22,1\"{}/>", stroke(Some(pen)))
            }
            Sample::Rectangle(pen) => {
                format!("<path d=\"M5,1L19,1L19,9L5,9Z\"{}/>", stroke(Some(pen)))
            }
            Sample::Dots(paint) => {
                let dots = [(4, 3), (9, 7), (12, 4), (17, 5), (20, 8)];
                let dot = |(x, y)| format!("<circle cx=\"{x}\" cy=\"{y}\" r=\"0.6\"{}/>", fill(paint));
                dots.into_iter().map(dot).collect()
            }
            Sample::Triangle => {
                let corners = triangle((12.0, 5.5), TRIANGLE_SIZE).map(in_hundredths);
                format!("<path d=\"{}\"{}/>", path_data(&corners, true), fill(MARKER))
            }
            Sample::Ring => {
                let (r, fill, rim) = (points(DISC_RADIUS), fill(HOLLOW), stroke(Some(HOLLOW_RIM)));
                format!("<circle cx=\"12\" cy=\"5\" r=\"{r}\"{fill}{rim}/>")
            }
            Sample::Disc => {
                format!("<circle cx=\"12\" cy=\"5\" r=\"{}\"{}/>", points(DISC_RADIUS), fill(MARKER))
            }
            Sample::Measured(mark) => mark.element(),
        }
    }
}
