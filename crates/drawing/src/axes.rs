//! A panel: a window of data space on a rectangle of the sheet, with its frame, ticks, numbers and axis titles.

use plotters::coord::types::RangedCoordf64;
use plotters::drawing::DrawingArea;
use plotters::prelude::Cartesian2d;

use crate::DrawingError;
use crate::canvas::{Canvas, Element, Ink};
use crate::clip::{Window, clip_polygon, clip_polyline, hatching};
use crate::font::Fonts;
use crate::markup::Label;
use crate::numbers::{Direction, Numbers};
use crate::plane::Plane;
use crate::sheet::{Bounds, Spot};
use crate::style::{
    BLACK, DISC_RADIUS, FRAME, HATCHING, MARKER, MARKER_RIM, MINOR_TICK_LENGTH, Paint, Pen, STAR_RADIUS,
    TICK, TICK_LENGTH, TICK_SIZE, TITLE_SIZE, TRIANGLE_SIZE,
};
use crate::svg_backend::{Anchor, PanelMark, SvgBackend};
use crate::svg_text::UNITS;

/// A window of data space laid over a rectangle of the sheet.
pub(crate) struct Panel<'c> {
    pub(crate) canvas: &'c Canvas,
    pub(crate) window: Window,
    pub(crate) bounds: Bounds,
    /// The tables whose rows it shows, and the column and number that its rows have, where others have other ones.
    rows: (Vec<&'static str>, Option<(&'static str, u32)>),
    /// The columns that hold what is across and up, where the titles do not say it.
    columns: Option<[String; 2]>,
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
/// Titles of vertical axes that are wider than this (points) are turned to read upwards.
const WIDEST_LEVEL_TITLE: f64 = 24.0;
/// Free space between a title and what is left of it, in points.
const SHEET_GAP: f64 = 3.0;
/// Titles too long for their axis are set smaller, down to this size (points).
const LEAST_TITLE_SIZE: f64 = 6.5;

impl<'c> Panel<'c> {
    pub(crate) fn new(canvas: &'c Canvas, window: Window, bounds: Bounds) -> Self {
        let units = |length: f64| (length * UNITS).round() as i32;
        let coordinates: Cartesian2d<RangedCoordf64, RangedCoordf64> = Cartesian2d::new(
            window.x[0]..window.x[1],
            window.y[0]..window.y[1],
            (units(bounds.left)..units(bounds.right), units(bounds.bottom)..units(bounds.top)),
        );
        let area = canvas.root().apply_coord_spec(coordinates);
        Panel { canvas, window, bounds, rows: (Vec::new(), None), columns: None, area }
    }

    /// The same panel, marked as showing rows of these tables, the most telling first.
    pub(crate) fn showing(self, tables: &[&'static str]) -> Self {
        Panel { rows: (tables.to_vec(), self.rows.1), ..self }
    }

    /// The same panel, marked as showing these parameters.
    pub(crate) fn over(self, plane: &Plane) -> Self {
        let columns = [&plane.across, &plane.up].map(|axis| axis.column.clone());
        Panel { columns: Some(columns), ..self }
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

    /// A filled area, clipped to the window, inside where its rings are crossed an odd number of times; returns its first ring on the
    /// sheet, if any of it shows.
    pub(crate) fn area(&self, rings: &[Vec<(f64, f64)>], paint: Paint) -> Result<Vec<Spot>, DrawingError> {
        let [border, holes @ ..] = rings else { return Ok(Vec::new()) };
        if holes.is_empty() {
            return self.fill(border, paint);
        }
        let clipped: Vec<_> = rings.iter().map(|ring| clip_polygon(&self.window, ring)).collect();
        let outline = clipped[0].iter().map(|&p| self.spot(p)).collect();
        let lengths = clipped.iter().map(Vec::len).collect();
        self.put(clipped.concat(), Ink::Area(paint, lengths))?;
        Ok(outline)
    }

    /// Hatching of such an area.
    pub(crate) fn hatch(&self, rings: &[Vec<(f64, f64)>], pen: Pen) -> Result<(), DrawingError> {
        let rings: Vec<Vec<Spot>> = rings
            .iter()
            .map(|ring| clip_polygon(&self.window, ring).into_iter().map(|point| self.spot(point)).collect())
            .collect();
        for line in hatching(&rings, HATCHING) {
            self.canvas.draw(&line, Ink::Line(pen))?;
        }
        Ok(())
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

    /// Frame, outward ticks, numbers and axis titles; an empty title is left out.
    pub(crate) fn axes(&self, x_title: &str, y_title: &str) -> Result<(), DrawingError> {
        self.axes_with(x_title, y_title, true)
    }

    /// Like [`Panel::axes`], the numbers of the vertical axis only if asked for.
    pub(crate) fn axes_with(
        &self,
        x_title: &str,
        y_title: &str,
        y_numbers_shown: bool,
    ) -> Result<(), DrawingError> {
        let Bounds { left, top, right, bottom } = self.bounds;
        self.canvas.mark(&PanelMark {
            window: &self.window,
            bounds: &self.bounds,
            titles: [x_title, y_title],
            tables: &self.rows.0,
            only: self.rows.1,
            columns: self.columns.as_ref().map(|columns| columns.each_ref().map(String::as_str)),
        });
        self.frame()?;
        let x_numbers = Numbers::along(self.canvas.fonts(), self.window.x, right - left, Direction::Across)?;
        for minor in &x_numbers.minor {
            let (x, _) = self.spot((minor.value, self.window.y[0]));
            self.canvas.draw(&[(x, bottom), (x, bottom + MINOR_TICK_LENGTH)], Ink::Line(TICK))?;
        }
        let baseline = bottom + TICK_LENGTH + TICK_GAP + 0.66 * TICK_SIZE;
        for tick in &x_numbers.ticks {
            let (x, _) = self.spot((tick.value, self.window.y[0]));
            self.canvas.draw(&[(x, bottom), (x, bottom + TICK_LENGTH)], Ink::Line(TICK))?;
            self.canvas.text((x, baseline), &tick.label, TICK_SIZE, Anchor::Middle, BLACK)?;
        }
        let y_numbers = Numbers::along(self.canvas.fonts(), self.window.y, bottom - top, Direction::Up)?;
        for minor in &y_numbers.minor {
            let (_, y) = self.spot((self.window.x[0], minor.value));
            self.canvas.draw(&[(left, y), (left - MINOR_TICK_LENGTH, y)], Ink::Line(TICK))?;
        }
        let reach = if y_numbers_shown { y_numbers.width } else { 0.0 };
        for tick in &y_numbers.ticks {
            let (_, y) = self.spot((self.window.x[0], tick.value));
            self.canvas.draw(&[(left, y), (left - TICK_LENGTH, y)], Ink::Line(TICK))?;
            if !y_numbers_shown {
                continue;
            }
            let spot = (left - TICK_LENGTH - TICK_GAP, y + 0.33 * TICK_SIZE);
            self.canvas.text(spot, &tick.label, TICK_SIZE, Anchor::End, BLACK)?;
        }
        let x_title = &x_numbers.title(x_title);
        let below = (0.5 * (left + right), baseline + 1.2 * TITLE_SIZE);
        let size = title_size(self.canvas, x_title, right - left)?;
        self.canvas.text(below, x_title, size, Anchor::Middle, BLACK)?;
        let y_title = &y_numbers.title(y_title);
        let edge = left - TICK_LENGTH - 2.0 * TICK_GAP - reach - 1.0;
        let extent = self.canvas.measure(&Label::parse(y_title)?, TITLE_SIZE)?;
        if extent.width > WIDEST_LEVEL_TITLE {
            let size = title_size(self.canvas, y_title, bottom - top)?;
            self.canvas.text_upwards((edge - extent.descent, 0.5 * (top + bottom)), y_title, size, BLACK)?;
        } else {
            let beside = (edge, 0.5 * (top + bottom) + 0.25 * TITLE_SIZE);
            self.canvas.text(beside, y_title, TITLE_SIZE, Anchor::End, BLACK)?;
        }
        Ok(())
    }

    /// The frame alone.
    pub(crate) fn frame(&self) -> Result<(), DrawingError> {
        let Bounds { left, top, right, bottom } = self.bounds;
        let corners = [(left, top), (right, top), (right, bottom), (left, bottom), (left, top), (right, top)];
        self.canvas.draw(&corners, Ink::Line(FRAME))
    }
}

/// The size at which a title fits on an axis of so many points.
fn title_size(canvas: &Canvas, title: &str, room: f64) -> Result<f64, DrawingError> {
    let width = canvas.measure(&Label::parse(title)?, TITLE_SIZE)?.width;
    Ok(if width > room { (TITLE_SIZE * room / width).max(LEAST_TITLE_SIZE) } else { TITLE_SIZE })
}

/// Points that ticks, numbers and title of a vertical axis take left of the frame; an empty title takes none.
pub(crate) fn room_beside(
    fonts: &Fonts,
    range: [f64; 2],
    height: f64,
    title: &str,
) -> Result<f64, DrawingError> {
    let numbers = Numbers::along(fonts, range, height, Direction::Up)?;
    let beside_title = TICK_LENGTH + 2.0 * TICK_GAP + numbers.width + 1.0;
    let extent = fonts.measure(&Label::parse(&numbers.title(title))?, TITLE_SIZE)?;
    let level = extent.width <= WIDEST_LEVEL_TITLE;
    Ok(beside_title + if level { extent.width } else { extent.height() } + SHEET_GAP)
}

/// Points by which the numbers of a horizontal axis reach beyond its right end, at least 0.
pub(crate) fn overhang(fonts: &Fonts, [low, high]: [f64; 2], width: f64) -> Result<f64, DrawingError> {
    let mut reach = 0.0_f64;
    for tick in Numbers::along(fonts, [low, high], width, Direction::Across)?.ticks {
        let half = 0.5 * fonts.measure(&Label::plain(&tick.label), TICK_SIZE)?.width;
        reach = reach.max(half - (high - tick.value) / (high - low) * width);
    }
    Ok(reach)
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
