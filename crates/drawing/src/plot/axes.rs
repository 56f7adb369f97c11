//! A panel: a rectangle of data space mapped to one of the sheet, with border, ticks, numbers and axis
//! titles.

use plotters::coord::CoordTranslate;
use plotters::coord::cartesian::Cartesian2d;
use plotters::coord::types::RangedCoordf64;

use grazing_results::{Frame, Names};

use crate::error::DrawingError;
use crate::geometry::clip::{clip_polygon, clip_polyline, hatching};
use crate::geometry::shapes::{star, triangle};
use crate::geometry::sheet::{Bounds, Spot, in_hundredths};
use crate::ink::canvas::{Anchor, Canvas};
use crate::ink::font::Fonts;
use crate::ink::labels::Labels;
use crate::ink::markup::Label;
use crate::ink::sheet::{Element, PanelMark};
use crate::ink::style::{
    BLACK, DISC_RADIUS, FRAME, HATCHING, HOLLOW, HOLLOW_RIM, MARKER, MARKER_RIM, MINOR_TICK_LENGTH, Paint,
    Pen, STAR_RADIUS, TICK, TICK_LENGTH, TICK_SIZE, TITLE_SIZE, TRIANGLE_SIZE,
};
use crate::plot::numbers::{Decades, Direction, Numbers};

/// The names, title and description of a figure of panels.
#[derive(Debug, Clone, Copy)]
pub struct Heading<'a> {
    /// The file name without extension, by which errors refer to the figure.
    pub name: &'static str,
    /// The title of the SVG, for screen readers.
    pub title: &'a str,
    /// The description of the SVG, for screen readers.
    pub description: &'a str,
    /// The names of the two parameters.
    pub names: &'a Names,
    /// The names of the tables that the SVG shows, in the order in which rows are searched for.
    pub tables: &'a [&'static str],
}

/// A rectangle of data space mapped to one of the sheet.
pub struct Panel<'c> {
    /// The sheet.
    pub canvas: &'c Canvas,
    /// The part of data space that the panel shows.
    pub frame: Frame,
    /// The bounds of the panel on the sheet.
    pub bounds: Bounds,
    /// The tables whose rows the panel shows, the most informative first; empty if any table with columns
    /// for the axes will do.
    pub tables: &'c [&'static str],
    /// The column and the number that distinguish the panel's rows from those of other panels.
    pub only: Option<(&'static str, u32)>,
    /// The columns of the two axes, unless these are those of their titles, as in the figures of the paper.
    pub columns: Option<[String; 2]>,
    /// Whether there are numbers along the vertical axis.
    pub numbers_beside: bool,
    /// The decades of the vertical axis, if its coordinate is a position on such an axis.
    pub(crate) decades: Option<Decades>,
}

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
/// The gap between ticks, numbers and titles, in points.
const TICK_GAP: f64 = 2.5;
/// Titles of vertical axes that are wider than this (points) are rotated to read upwards.
const WIDEST_LEVEL_TITLE: f64 = 18.0;
/// Free space to the left of a vertical title, in points.
const SHEET_GAP: f64 = 3.0;
/// Titles too long for their axis are set in a smaller size, down to this one (points).
const LEAST_TITLE_SIZE: f64 = 6.5;

impl<'c> Panel<'c> {
    /// A panel without tables.
    pub fn new(canvas: &'c Canvas, frame: Frame, bounds: Bounds) -> Self {
        let (tables, only, columns): (&[_], _, _) = (&[], None, None);
        Panel { canvas, frame, bounds, tables, only, columns, numbers_beside: true, decades: None }
    }

    /// The position of a data point on the sheet, truncated to whole hundredths of a point from the lower
    /// left corner.
    pub fn spot(&self, point: (f64, f64)) -> Spot {
        let (left, top) = in_hundredths((self.bounds.left, self.bounds.top));
        let (right, bottom) = in_hundredths((self.bounds.right, self.bounds.bottom));
        let Frame { x: [first, last], y: [low, high] } = self.frame;
        let axes: Cartesian2d<RangedCoordf64, RangedCoordf64> =
            Cartesian2d::new(first..last, low..high, (left..right, bottom..top));
        let (x, y) = axes.translate(&point);
        (f64::from(x) / 100.0, f64::from(y) / 100.0)
    }

    /// The data point at a position on the sheet.
    pub(crate) fn at(&self, (right, down): Spot) -> (f64, f64) {
        let Frame { x: [first, last], y: [low, high] } = self.frame;
        let Bounds { left, top, right: end, bottom } = self.bounds;
        let value = |share: f64, from: f64, to: f64| from + share * (to - from);
        let (across, up) = ((right - left) / (end - left), (bottom - down) / (bottom - top));
        (value(across, first, last), value(up, low, high))
    }

    fn spots(&self, points: &[(f64, f64)]) -> Vec<Spot> {
        points.iter().map(|&point| self.spot(point)).collect()
    }

    /// Draws a polyline, clipped to the frame with all of its ink; returns its pieces on the sheet.
    pub fn line(&self, points: &[(f64, f64)], pen: Pen) -> Vec<Vec<Spot>> {
        let pieces: Vec<_> =
            clip_polyline(&self.frame, points).iter().map(|piece| self.spots(piece)).collect();
        pieces.iter().for_each(|piece| self.canvas.line_within(&self.bounds, piece, pen));
        pieces
    }

    /// Draws a filled polygon, clipped to the frame; returns its outline on the sheet if any of it is
    /// visible.
    pub fn fill(&self, vertices: &[(f64, f64)], paint: Paint) -> Vec<Spot> {
        let clipped = clip_polygon(&self.frame, vertices);
        if clipped.len() < 3 {
            return Vec::new();
        }
        let outline = self.spots(&clipped);
        self.canvas.polygon(&outline, paint, None);
        outline
    }

    /// Draws an area filled by the even-odd rule, clipped to the frame; returns its first ring on the
    /// sheet if any of it is visible.
    pub(crate) fn area(&self, rings: &[Vec<(f64, f64)>], paint: Paint) -> Vec<Spot> {
        match rings {
            [] => Vec::new(),
            [border] => self.fill(border, paint),
            _ => {
                let mut rings = self.clipped(rings);
                self.canvas.area(&rings, paint);
                rings.swap_remove(0)
            }
        }
    }

    /// Hatches the area inside rings by the even-odd rule.
    pub(crate) fn hatch(&self, rings: &[Vec<(f64, f64)>], pen: Pen) {
        for line in hatching(&self.clipped(rings), HATCHING) {
            self.canvas.line(&line, pen);
        }
    }

    /// The parts of rings within the frame, on the sheet.
    fn clipped(&self, rings: &[Vec<(f64, f64)>]) -> Vec<Vec<Spot>> {
        rings.iter().map(|ring| self.spots(&clip_polygon(&self.frame, ring))).collect()
    }

    /// Draws a marker if its point is in the frame, and makes labels avoid it; returns its box, the rim
    /// included.
    pub fn marker(&self, labels: &mut Labels<'_>, point: (f64, f64), marker: Marker) -> Option<Bounds> {
        if !self.frame.contains(point) {
            return None;
        }
        let (canvas, centre) = (self.canvas, self.spot(point));
        let size = match marker {
            Marker::Triangle => {
                canvas.polygon(&triangle(centre, TRIANGLE_SIZE), MARKER, Some(MARKER_RIM));
                TRIANGLE_SIZE
            }
            Marker::Disc => {
                canvas.disc(centre, DISC_RADIUS, MARKER, Some(MARKER_RIM));
                2.0 * DISC_RADIUS
            }
            Marker::Ring => {
                canvas.disc(centre, DISC_RADIUS, HOLLOW, Some(HOLLOW_RIM));
                2.0 * DISC_RADIUS
            }
            Marker::Star => {
                canvas.polygon(&star(centre, STAR_RADIUS), MARKER, Some(MARKER_RIM));
                2.0 * STAR_RADIUS
            }
        };
        let taken = Bounds::about(centre, size, size).grown(RIM);
        labels.placer.block(taken);
        Some(taken)
    }

    /// Adds the mark that describes the position and contents of the panel.
    fn mark(&self, titles: [&str; 2]) {
        let Panel { frame, bounds, only, .. } = *self;
        let (tables, titles, columns) =
            (self.tables.to_vec(), titles.map(str::to_owned), self.columns.clone());
        let linear = self.decades.is_none();
        self.canvas.add(Element::Panel(PanelMark { bounds, frame, titles, tables, only, columns, linear }));
    }

    /// Draws border, outward ticks, numbers and axis titles; an empty title is omitted.
    pub fn axes(&self, x_title: &str, y_title: &str) -> Result<(), DrawingError> {
        let (Bounds { left, top, right, bottom }, canvas) = (self.bounds, self.canvas);
        self.mark([x_title, y_title]);
        canvas.line(
            &[(left, top), (right, top), (right, bottom), (left, bottom), (left, top), (right, top)],
            FRAME,
        );
        let x_numbers = Numbers::along(&canvas.fonts, self.frame.x, right - left, Direction::Across)?;
        let y_numbers = Numbers::up(&canvas.fonts, self.frame.y, bottom - top, self.decades)?;
        let baseline = bottom + TICK_LENGTH + TICK_GAP + 0.66 * TICK_SIZE;
        let x_tick = |value: f64, length: f64| {
            let (x, _) = self.spot((value, self.frame.y[0]));
            canvas.line(&[(x, bottom), (x, bottom + length)], TICK);
            (x, baseline)
        };
        let y_tick = |value: f64, length: f64| {
            let (_, y) = self.spot((self.frame.x[0], value));
            canvas.line(&[(left, y), (left - length, y)], TICK);
            (left - TICK_LENGTH - TICK_GAP, y + 0.33 * TICK_SIZE)
        };
        for minor in &x_numbers.minor {
            x_tick(*minor, MINOR_TICK_LENGTH);
        }
        for tick in &x_numbers.ticks {
            canvas.text(x_tick(tick.value, TICK_LENGTH), &tick.label, TICK_SIZE, Anchor::Middle, BLACK)?;
        }
        for minor in &y_numbers.minor {
            y_tick(*minor, MINOR_TICK_LENGTH);
        }
        let reach = if self.numbers_beside { y_numbers.width } else { 0.0 };
        for tick in &y_numbers.ticks {
            let spot = y_tick(tick.value, TICK_LENGTH);
            if self.numbers_beside {
                canvas.text(spot, &tick.label, TICK_SIZE, Anchor::End, BLACK)?;
            }
        }
        let x_title = &x_numbers.title(x_title);
        let below = (0.5 * (left + right), baseline + 1.2 * TITLE_SIZE);
        let size = title_size(canvas, x_title, right - left)?;
        canvas.text(below, x_title, size, Anchor::Middle, BLACK)?;
        let y_title = &y_numbers.title(y_title);
        let edge = left - TICK_LENGTH - 2.0 * TICK_GAP - reach - 1.0;
        let extent = canvas.fonts.measure(&Label::parse(y_title)?, TITLE_SIZE)?;
        let middle = 0.5 * (top + bottom);
        let (spot, size, anchor) = if extent.width > WIDEST_LEVEL_TITLE {
            ((edge - extent.descent, middle), title_size(canvas, y_title, bottom - top)?, Anchor::Upwards)
        } else {
            ((edge, middle + 0.25 * TITLE_SIZE), TITLE_SIZE, Anchor::End)
        };
        canvas.text(spot, y_title, size, anchor, BLACK)
    }
}

/// The font size at which a title fits on an axis of `room` points.
fn title_size(canvas: &Canvas, title: &str, room: f64) -> Result<f64, DrawingError> {
    let width = canvas.fonts.measure(&Label::parse(title)?, TITLE_SIZE)?.width;
    Ok(if width > room { (TITLE_SIZE * room / width).max(LEAST_TITLE_SIZE) } else { TITLE_SIZE })
}

/// The width in points of ticks, numbers and title of a vertical axis, left of the frame; an empty title
/// takes none.
pub(crate) fn room_beside(
    fonts: &Fonts,
    range: [f64; 2],
    height: f64,
    title: &str,
) -> Result<f64, DrawingError> {
    room_for(fonts, &Numbers::along(fonts, range, height, Direction::Up)?, title)
}

/// The width in points of ticks, these numbers and the title of a vertical axis, left of the frame.
pub(crate) fn room_for(fonts: &Fonts, numbers: &Numbers, title: &str) -> Result<f64, DrawingError> {
    let beside_title = TICK_LENGTH + 2.0 * TICK_GAP + numbers.width + 1.0;
    let extent = fonts.measure(&Label::parse(&numbers.title(title))?, TITLE_SIZE)?;
    let level = extent.width <= WIDEST_LEVEL_TITLE;
    Ok(beside_title + if level { extent.width } else { extent.height() } + SHEET_GAP)
}

/// The distance in points by which the numbers of a horizontal axis extend beyond its right end, at least
/// 0.
pub(crate) fn overhang(fonts: &Fonts, [low, high]: [f64; 2], width: f64) -> Result<f64, DrawingError> {
    let mut reach = 0.0_f64;
    for tick in Numbers::along(fonts, [low, high], width, Direction::Across)?.ticks {
        let half = 0.5 * fonts.measure(&Label::plain(&tick.label), TICK_SIZE)?.room();
        reach = reach.max(half - (high - tick.value) / (high - low) * width);
    }
    Ok(reach)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The mark of a panel with these titles that shows a plane with these names.
    fn marked(titles: [&str; 2], names: &Names) -> String {
        let canvas = Canvas::new(100.0, 100.0).unwrap();
        let bounds = Bounds { left: 10.0, top: 20.0, right: 90.5, bottom: 80.0 };
        let panel = Panel {
            tables: &["points", "curves"],
            only: Some(("panel", 2)),
            columns: names.columns(),
            ..Panel::new(&canvas, Frame { x: [-0.5, 1.25], y: [0.0, 3.0] }, bounds)
        };
        panel.mark(titles);
        let svg = canvas.finish("test", "", "").unwrap().svg();
        svg.lines().find(|line| line.contains("panel")).unwrap().to_owned()
    }

    #[test]
    fn a_mark_states_the_frame_and_its_place() {
        assert_eq!(
            marked([r"$\omega$", ""], &Names::of_the_paper()),
            "<rect class=\"panel\" x=\"10\" y=\"20\" width=\"80.5\" height=\"60\" data-x=\"-0.5 1.25\" data-y=\"0 3\" \
             data-x-title=\"$\\omega$\" data-y-title=\"\" data-tables=\"points curves\" data-only=\"panel 2\"/>"
        );
    }

    #[test]
    fn a_mark_names_its_columns_whatever_the_titles_say() {
        for columns in [["A", "omega"], ["F_0", "omega_2"], ["amplitude", "phi"]] {
            let names = Names::new(columns[0], columns[1]);
            let titles = names.titles();
            let mark = marked([&titles[0], &titles[1]], &names);
            assert!(mark.contains(&format!(" data-columns=\"{}\"/>", columns.join(" "))), "{mark}");
        }
    }

    #[test]
    fn no_name_makes_a_title_that_is_not_markup() {
        let alphabet = ["a", "omega", "mass", "_", "0", "12", "$", "{", "\\", "ω", " "];
        for first in alphabet {
            for second in alphabet {
                for third in alphabet {
                    let [title, _] = Names::new(&format!("{first}{second}{third}"), "omega").titles();
                    assert!(Label::parse(&title).is_ok(), "{title}");
                }
            }
        }
    }
}
