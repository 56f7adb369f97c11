//! The backend of plotters that the figures are written by: SVG elements, in hundredths of a point.
//!
//! Its own SVG backend counts in whole pixels and knows neither dashes nor sub- and superscripts. So elements write themselves here, once plotters
//! has mapped their points to the sheet.

use std::convert::Infallible;

use plotters::element::{Drawable, PointCollection};
use plotters_backend::{BackendColor, BackendCoord, DrawingBackend, DrawingErrorKind};

use crate::ink::style::{Colour, Paint};
use crate::ink::svg::{fill, hundredths};

/// The elements drawn so far.
pub(crate) struct SvgBackend {
    /// Width and height in hundredths of a point.
    size: (u32, u32),
    body: String,
}

impl SvgBackend {
    pub(crate) fn new((width, height): (i32, i32)) -> Self {
        SvgBackend { size: (width.unsigned_abs(), height.unsigned_abs()), body: String::new() }
    }

    /// Adds an element, if there is one, on a line of its own.
    pub(crate) fn write(&mut self, element: &str) {
        if !element.is_empty() {
            self.body.push_str(element);
            self.body.push('\n');
        }
    }

    pub(crate) fn body(&self) -> &str {
        &self.body
    }
}

type Outcome = Result<(), DrawingErrorKind<Infallible>>;

impl DrawingBackend for SvgBackend {
    type ErrorType = Infallible;

    fn get_size(&self) -> (u32, u32) {
        self.size
    }

    fn ensure_prepared(&mut self) -> Outcome {
        Ok(())
    }

    fn present(&mut self) -> Outcome {
        Ok(())
    }

    /// A square of a hundredth of a point: what elements other than [`Element`] are made of.
    fn draw_pixel(&mut self, (x, y): BackendCoord, BackendColor { rgb, alpha }: BackendColor) -> Outcome {
        let paint = Paint { colour: Colour(rgb.0, rgb.1, rgb.2), opacity: alpha };
        let (x, y) = (hundredths(x), hundredths(y));
        self.write(&format!("<rect x=\"{x}\" y=\"{y}\" width=\"0.01\" height=\"0.01\"{}/>", fill(paint)));
        Ok(())
    }
}

/// An element for plotters: points in any coordinate system, and what is written once they are mapped to the sheet.
pub(crate) struct Element<C, W> {
    pub(crate) points: Vec<C>,
    pub(crate) write: W,
}

impl<'a, C: 'a, W> PointCollection<'a, C> for &'a Element<C, W> {
    type Point = &'a C;
    type IntoIter = std::slice::Iter<'a, C>;

    fn point_iter(self) -> Self::IntoIter {
        self.points.iter()
    }
}

impl<C, W: Fn(&[BackendCoord]) -> String> Drawable<SvgBackend> for Element<C, W> {
    fn draw<I: Iterator<Item = BackendCoord>>(
        &self,
        positions: I,
        backend: &mut SvgBackend,
        _: (u32, u32),
    ) -> Outcome {
        backend.write(&(self.write)(&positions.collect::<Vec<_>>()));
        Ok(())
    }
}
