//! The sheet a figure is drawn on: plotters' drawing area over our backend, in points from the top left corner.

use std::cell::RefCell;
use std::rc::Rc;

use plotters::coord::Shift;
use plotters::drawing::DrawingArea;
use plotters::element::{Drawable, PointCollection};
use plotters_backend::{BackendCoord, DrawingErrorKind};

use crate::DrawingError;
use crate::font::{Extent, Fonts};
use crate::markup::Label;
use crate::sheet::{Bounds, Spot};
use crate::style::{Colour, Paint, Pen, SIZE_LIMIT, hat_pen};
use crate::svg_backend::{Anchor, POINTS_PER_MM, PanelMark, SvgBackend};
use crate::svg_text::UNITS;

/// What an element puts on the sheet.
pub(crate) enum Ink<'a> {
    Line(Pen),
    Polygon(Paint, Option<Pen>),
    /// Rings of so many points each, inside where they are crossed an odd number of times.
    Area(Paint, Vec<usize>),
    Disc(f64, Paint, Option<Pen>),
    Triangle(f64, Paint, Option<Pen>),
    Label(&'a Label, f64, Anchor, Colour),
    /// A label that reads upwards, centred.
    Upwards(&'a Label, f64, Colour),
    Bins(f64, &'a str, Paint),
}

/// An element for plotters: points in any coordinate system, and the ink that joins or marks them.
pub(crate) struct Element<'a, C> {
    pub(crate) points: Vec<C>,
    pub(crate) ink: Ink<'a>,
}

impl<'a, C: 'a> PointCollection<'a, C> for &'a Element<'_, C> {
    type Point = &'a C;
    type IntoIter = std::slice::Iter<'a, C>;

    fn point_iter(self) -> Self::IntoIter {
        self.points.iter()
    }
}

impl<C> Drawable<SvgBackend> for Element<'_, C> {
    fn draw<I: Iterator<Item = BackendCoord>>(
        &self,
        mut positions: I,
        backend: &mut SvgBackend,
        _parent: (u32, u32),
    ) -> Result<(), DrawingErrorKind<std::convert::Infallible>> {
        match &self.ink {
            Ink::Line(pen) => backend.line(positions, pen),
            Ink::Polygon(paint, outline) => backend.polygon(positions, paint, outline.as_ref()),
            Ink::Area(paint, lengths) => backend.area(positions, lengths, paint),
            ink => {
                let Some((x, y)) = positions.next() else {
                    return Ok(());
                };
                match ink {
                    Ink::Disc(radius, paint, rim) => backend.disc((x, y), *radius, paint, rim.as_ref()),
                    Ink::Triangle(side, paint, rim) => {
                        // Equilateral, its centroid on the point: heights 1/sqrt(3) above and 1/(2 sqrt(3)) below.
                        let units = |length: f64| (length * UNITS).round() as i32;
                        let (up, down) = (units(side * 0.577_35), units(side * 0.288_68));
                        let half = units(side * 0.5);
                        let corners = [(x, y - up), (x + half, y + down), (x - half, y + down)];
                        backend.polygon(corners, paint, rim.as_ref())
                    }
                    Ink::Label(label, size, anchor, colour) => {
                        backend.label((x, y), label, *size, *anchor, *colour)
                    }
                    Ink::Upwards(label, size, colour) => backend.label_upwards((x, y), label, *size, *colour),
                    Ink::Bins(bin, data, paint) => backend.bins((x, y), *bin, data, paint),
                    Ink::Line(_) | Ink::Polygon(..) | Ink::Area(..) => Ok(()),
                }
            }
        }
    }
}

/// A sheet under way.
pub(crate) struct Canvas {
    backend: Rc<RefCell<SvgBackend>>,
    root: DrawingArea<SvgBackend, Shift>,
    fonts: Fonts,
    pub(crate) width: f64,
    pub(crate) height: f64,
    /// Every label drawn so far and the box of its ink.
    texts: RefCell<Vec<(String, Bounds)>>,
}

impl Canvas {
    pub(crate) fn new(width_mm: f64, height_mm: f64) -> Result<Self, DrawingError> {
        let (width, height) = (width_mm * POINTS_PER_MM, height_mm * POINTS_PER_MM);
        let backend = Rc::new(RefCell::new(SvgBackend::new(width, height)));
        let root = DrawingArea::from(&backend);
        Ok(Canvas { backend, root, fonts: Fonts::load()?, width, height, texts: RefCell::default() })
    }

    pub(crate) fn root(&self) -> &DrawingArea<SvgBackend, Shift> {
        &self.root
    }

    /// Draws in points of the sheet.
    pub(crate) fn draw(&self, spots: &[Spot], ink: Ink<'_>) -> Result<(), DrawingError> {
        let points =
            spots.iter().map(|s| ((s.0 * UNITS).round() as i32, (s.1 * UNITS).round() as i32)).collect();
        self.root.draw(&Element { points, ink }).map_err(|_| DrawingError::SurfaceInUse)
    }

    /// Says for programs where a panel is and what it shows; puts no ink on the sheet.
    pub(crate) fn mark(&self, mark: &PanelMark<'_>) {
        self.backend.borrow_mut().mark(mark);
    }

    pub(crate) fn fonts(&self) -> &Fonts {
        &self.fonts
    }

    pub(crate) fn measure(&self, label: &Label, size: f64) -> Result<Extent, DrawingError> {
        self.fonts.measure(label, size)
    }

    /// A label with its baseline at the spot; returns the box of its ink.
    pub(crate) fn text(
        &self,
        spot: Spot,
        source: &str,
        size: f64,
        anchor: Anchor,
        colour: Colour,
    ) -> Result<Bounds, DrawingError> {
        self.set(spot, &Label::parse(source)?, size, anchor, colour)
    }

    fn set(
        &self,
        (x, y): Spot,
        label: &Label,
        size: f64,
        anchor: Anchor,
        colour: Colour,
    ) -> Result<Bounds, DrawingError> {
        let extent = self.measure(label, size)?;
        let left = match anchor {
            Anchor::Start => x,
            Anchor::Middle => x - 0.5 * extent.width,
            Anchor::End => x - extent.width,
        };
        let (top, bottom) = (y - extent.ascent, y + extent.descent);
        let taken = Bounds { left, top, right: left + extent.width, bottom };
        if label.runs.is_empty() {
            return Ok(taken);
        }
        self.texts.borrow_mut().push((label.source.clone(), taken));
        self.draw(&[(x, y)], Ink::Label(label, size, anchor, colour))?;
        for hat in self.fonts.hats(label, size)? {
            self.draw(&hat.map(|(right, down)| (left + right, y + down)), Ink::Line(hat_pen(size, colour)))?;
        }
        Ok(taken)
    }

    /// A label that reads upwards, the middle of its baseline at the spot; returns the box of its ink.
    pub(crate) fn text_upwards(
        &self,
        (x, y): Spot,
        source: &str,
        size: f64,
        colour: Colour,
    ) -> Result<Bounds, DrawingError> {
        let label = Label::parse(source)?;
        let Extent { width, ascent, descent } = self.measure(&label, size)?;
        let (top, bottom) = (y - 0.5 * width, y + 0.5 * width);
        let taken = Bounds { left: x - ascent, top, right: x + descent, bottom };
        self.texts.borrow_mut().push((label.source.clone(), taken));
        self.draw(&[(x, y)], Ink::Upwards(&label, size, colour))?;
        for hat in self.fonts.hats(&label, size)? {
            self.draw(
                &hat.map(|(right, down)| (x + down, bottom - right)),
                Ink::Line(hat_pen(size, colour)),
            )?;
        }
        Ok(taken)
    }

    /// A label whose ink is centred in a box of its own extent.
    pub(crate) fn text_in(
        &self,
        bounds: &Bounds,
        label: &Label,
        size: f64,
        colour: Colour,
    ) -> Result<Bounds, DrawingError> {
        let extent = self.measure(label, size)?;
        let (x, y) = bounds.centre();
        let baseline = y + 0.5 * (extent.ascent - extent.descent);
        self.set((x, baseline), label, size, Anchor::Middle, colour)
    }

    /// The labels as they were written, in the order of drawing.
    #[cfg(test)]
    pub(crate) fn texts(&self) -> Vec<String> {
        self.texts.borrow().iter().map(|(source, _)| source.clone()).collect()
    }

    /// The labels that overlap another one or leave the sheet: none, in a good figure.
    #[cfg(test)]
    pub(crate) fn misplaced_texts(&self) -> Vec<(String, Bounds)> {
        let texts = self.texts.borrow();
        let sheet = Bounds { left: 0.0, top: 0.0, right: self.width, bottom: self.height };
        let spoilt = |i: usize| {
            !sheet.holds(&texts[i].1)
                || texts.iter().enumerate().any(|(j, other)| i != j && other.1.overlaps(&texts[i].1))
        };
        (0..texts.len()).filter(|&i| spoilt(i)).map(|i| texts[i].clone()).collect()
    }

    /// The document, if it is light enough.
    pub(crate) fn finish(
        self,
        figure: &'static str,
        title: &str,
        description: &str,
    ) -> Result<String, DrawingError> {
        let document = self.backend.borrow().finish(title, description);
        if document.len() > SIZE_LIMIT {
            return Err(DrawingError::TooLarge { figure, bytes: document.len(), limit: SIZE_LIMIT });
        }
        Ok(document)
    }
}
