//! A panel: a window of data space on a rectangle of the sheet, with its frame, ticks, numbers and axis titles.

use plotters::coord::types::RangedCoordf64;
use plotters::drawing::DrawingArea;
use plotters::prelude::Cartesian2d;

use crate::DrawingError;
use crate::canvas::{Canvas, Element, Ink};
use crate::clip::{Window, clip_polygon, clip_polyline};
use crate::markup::Label;
use crate::sheet::{Bounds, Spot};
use crate::style::{
    BLACK, DISC_RADIUS, FRAME, MARKER, MARKER_RIM, MINOR_TICK_LENGTH, Paint, Pen, STAR_RADIUS, TICK,
    TICK_LENGTH, TICK_SIZE, TITLE_SIZE, TRIANGLE_SIZE,
};
use crate::svg_backend::{Anchor, PanelMark, SvgBackend};
use crate::svg_text::UNITS;
use crate::ticks::{Step, Tick};

/// A window of data space laid over a rectangle of the sheet.
pub(crate) struct Panel<'c> {
    pub(crate) canvas: &'c Canvas,
    pub(crate) window: Window,
    pub(crate) bounds: Bounds,
    /// The tables whose rows it shows, and the column and number that its rows have, where others have other ones.
    rows: (&'static [&'static str], Option<(&'static str, u32)>),
    area: DrawingArea<SvgBackend, Cartesian2d<RangedCoordf64, RangedCoordf64>>,
}

/// Which of the paper's markers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Marker {
    /// A resonance.
    Triangle,
    /// Any other codimension-two point.
    Disc,
    /// A point of another figure.
    Star,
}

/// Room that the largest tick labels and the gaps around them take, in points.
const TICK_GAP: f64 = 2.5;
/// Least distance between the numbers along an axis, in points.
const NUMBER_GAP: f64 = 9.0;

impl<'c> Panel<'c> {
    pub(crate) fn new(canvas: &'c Canvas, window: Window, bounds: Bounds) -> Self {
        let units = |length: f64| (length * UNITS).round() as i32;
        let coordinates: Cartesian2d<RangedCoordf64, RangedCoordf64> = Cartesian2d::new(
            window.x[0]..window.x[1],
            window.y[0]..window.y[1],
            (units(bounds.left)..units(bounds.right), units(bounds.bottom)..units(bounds.top)),
        );
        Panel { canvas, window, bounds, rows: (&[], None), area: canvas.root().apply_coord_spec(coordinates) }
    }

    /// The same panel, marked as showing rows of these tables, the most telling first.
    pub(crate) fn showing(self, tables: &'static [&'static str]) -> Self {
        Panel { rows: (tables, self.rows.1), ..self }
    }

    /// The same panel, marked as showing only rows with this number in this column.
    pub(crate) fn only(self, column: &'static str, number: u32) -> Self {
        Panel { rows: (self.rows.0, Some((column, number))), ..self }
    }

    /// Where a data point lies on the sheet.
    pub(crate) fn spot(&self, point: (f64, f64)) -> Spot {
        let (x, y) = self.area.map_coordinate(&point);
        (f64::from(x) / UNITS, f64::from(y) / UNITS)
    }

    fn put(&self, points: Vec<(f64, f64)>, ink: Ink<'_>) -> Result<(), DrawingError> {
        self.area.draw(&Element { points, ink }).map_err(|_| DrawingError::SurfaceInUse)
    }

    /// A polyline, clipped to the window; returns its pieces on the sheet.
    pub(crate) fn line(&self, points: &[(f64, f64)], pen: Pen) -> Result<Vec<Vec<Spot>>, DrawingError> {
        let mut drawn = Vec::new();
        for piece in clip_polyline(&self.window, points) {
            drawn.push(piece.iter().map(|&p| self.spot(p)).collect());
            self.put(piece, Ink::Line(pen))?;
        }
        Ok(drawn)
    }

    /// A filled polygon, clipped to the window; returns its outline on the sheet, if any of it shows.
    pub(crate) fn fill(&self, vertices: &[(f64, f64)], paint: Paint) -> Result<Vec<Spot>, DrawingError> {
        let clipped = clip_polygon(&self.window, vertices);
        if clipped.len() < 3 {
            return Ok(Vec::new());
        }
        let outline = clipped.iter().map(|&p| self.spot(p)).collect();
        self.put(clipped, Ink::Polygon(paint, None))?;
        Ok(outline)
    }

    /// A marker, if its point is in the window; returns the box it takes.
    pub(crate) fn marker(&self, point: (f64, f64), marker: Marker) -> Result<Option<Bounds>, DrawingError> {
        if !self.window.contains(point) {
            return Ok(None);
        }
        let (ink, size) = match marker {
            Marker::Triangle => (Ink::Triangle(TRIANGLE_SIZE, MARKER, Some(MARKER_RIM)), TRIANGLE_SIZE),
            Marker::Disc => (Ink::Disc(DISC_RADIUS, MARKER, Some(MARKER_RIM)), 2.0 * DISC_RADIUS),
            Marker::Star => {
                let centre = self.spot(point);
                self.canvas.draw(&star(centre, STAR_RADIUS), Ink::Polygon(MARKER, Some(MARKER_RIM)))?;
                return Ok(Some(Bounds::about(centre, 2.0 * STAR_RADIUS, 2.0 * STAR_RADIUS)));
            }
        };
        self.put(vec![point], ink)?;
        Ok(Some(Bounds::about(self.spot(point), size, size)))
    }

    /// Path data in units of bins from the panel's top left corner.
    pub(crate) fn bins(&self, bin: f64, data: &str, paint: Paint) -> Result<(), DrawingError> {
        self.canvas.draw(&[(self.bounds.left, self.bounds.top)], Ink::Bins(bin, data, paint))
    }

    /// The finest round step whose numbers keep their distance.
    fn step(&self, horizontal: bool) -> Result<(Vec<Tick>, Step), DrawingError> {
        let ([low, high], room) = if horizontal {
            (self.window.x, self.bounds.right - self.bounds.left)
        } else {
            (self.window.y, self.bounds.bottom - self.bounds.top)
        };
        let mut coarsest = None;
        for step in Step::round_steps(high - low) {
            // A step so fine that its ticks would touch needs no measuring.
            if (high - low) / step.size() * 4.0 > room {
                continue;
            }
            let ticks = step.multiples(low, high);
            let mut widest = 0.0_f64;
            for tick in &ticks {
                let extent = self.canvas.measure(&Label::plain(&tick.label), TICK_SIZE)?;
                widest = widest.max(if horizontal { extent.width } else { extent.height() });
            }
            let pitch = step.size() / (high - low) * room;
            let fits = pitch >= widest + NUMBER_GAP + if horizontal { 4.0 } else { 6.0 };
            if fits && ticks.len() >= 2 {
                return Ok((ticks, step));
            }
            if ticks.len() >= 2 {
                coarsest = Some((ticks, step));
            }
        }
        Ok(coarsest
            .unwrap_or_else(|| (Vec::new(), Step::round_steps(high - low).last().unwrap_or(Step::ONE))))
    }

    /// Frame, outward ticks, numbers and axis titles; an empty title is left out.
    pub(crate) fn axes(&self, x_title: &str, y_title: &str) -> Result<(), DrawingError> {
        self.axes_with(x_title, y_title, true)
    }

    /// Like [`Panel::axes`], the numbers of the vertical axis only if asked for.
    pub(crate) fn axes_with(
        &self,
        x_title: &str,
        y_title: &str,
        y_numbers: bool,
    ) -> Result<(), DrawingError> {
        let Bounds { left, top, right, bottom } = self.bounds;
        self.canvas.mark(&PanelMark {
            window: &self.window,
            bounds: &self.bounds,
            titles: [x_title, y_title],
            tables: self.rows.0,
            only: self.rows.1,
        });
        self.frame()?;
        let (x_ticks, x_step) = self.step(true)?;
        for minor in x_step.minor().multiples(self.window.x[0], self.window.x[1]) {
            let (x, _) = self.spot((minor.value, self.window.y[0]));
            self.canvas.draw(&[(x, bottom), (x, bottom + MINOR_TICK_LENGTH)], Ink::Line(TICK))?;
        }
        let baseline = bottom + TICK_LENGTH + TICK_GAP + 0.66 * TICK_SIZE;
        for tick in &x_ticks {
            let (x, _) = self.spot((tick.value, self.window.y[0]));
            self.canvas.draw(&[(x, bottom), (x, bottom + TICK_LENGTH)], Ink::Line(TICK))?;
            self.canvas.text((x, baseline), &tick.label, TICK_SIZE, Anchor::Middle, BLACK)?;
        }
        let (y_ticks, y_step) = self.step(false)?;
        for minor in y_step.minor().multiples(self.window.y[0], self.window.y[1]) {
            let (_, y) = self.spot((self.window.x[0], minor.value));
            self.canvas.draw(&[(left, y), (left - MINOR_TICK_LENGTH, y)], Ink::Line(TICK))?;
        }
        let mut reach = 0.0_f64;
        for tick in &y_ticks {
            let (_, y) = self.spot((self.window.x[0], tick.value));
            self.canvas.draw(&[(left, y), (left - TICK_LENGTH, y)], Ink::Line(TICK))?;
            if !y_numbers {
                continue;
            }
            let label = Label::plain(&tick.label);
            let extent = self.canvas.measure(&label, TICK_SIZE)?;
            reach = reach.max(extent.width);
            let spot = (left - TICK_LENGTH - TICK_GAP, y + 0.33 * TICK_SIZE);
            self.canvas.text(spot, &tick.label, TICK_SIZE, Anchor::End, BLACK)?;
        }
        let below = (0.5 * (left + right), baseline + 1.2 * TITLE_SIZE);
        self.canvas.text(below, x_title, TITLE_SIZE, Anchor::Middle, BLACK)?;
        let beside =
            (left - TICK_LENGTH - 2.0 * TICK_GAP - reach - 1.0, 0.5 * (top + bottom) + 0.25 * TITLE_SIZE);
        self.canvas.text(beside, y_title, TITLE_SIZE, Anchor::End, BLACK)?;
        Ok(())
    }

    /// The frame alone.
    pub(crate) fn frame(&self) -> Result<(), DrawingError> {
        let Bounds { left, top, right, bottom } = self.bounds;
        let corners = [(left, top), (right, top), (right, bottom), (left, bottom), (left, top), (right, top)];
        self.canvas.draw(&corners, Ink::Line(FRAME))
    }
}

/// The outline of an upright star with five points.
fn star((x, y): Spot, radius: f64) -> Vec<Spot> {
    // Sines and cosines of multiples of 36 degrees, clockwise from the top; the inner corners are those of the pentagram.
    const INNER: f64 = 0.381_97;
    const TURNS: [Spot; 10] = [
        (0.0, 1.0),
        (0.587_79, 0.809_02),
        (0.951_06, 0.309_02),
        (0.951_06, -0.309_02),
        (0.587_79, -0.809_02),
        (0.0, -1.0),
        (-0.587_79, -0.809_02),
        (-0.951_06, -0.309_02),
        (-0.951_06, 0.309_02),
        (-0.587_79, 0.809_02),
    ];
    let corner = |(index, &(right, up)): (usize, &Spot)| {
        let reach = if index % 2 == 0 { radius } else { INNER * radius };
        (x + reach * right, y - reach * up)
    };
    TURNS.iter().enumerate().map(corner).collect()
}
