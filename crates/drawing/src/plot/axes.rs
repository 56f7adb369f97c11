//! A panel: a rectangle of data space mapped to one of the sheet, with border, ticks, numbers and axis
//! titles.

use core::borrow::Borrow;

use plotters::chart::{ChartBuilder, ChartContext, SeriesAnno};
use plotters::coord::cartesian::Cartesian2d;
use plotters::coord::types::RangedCoordf64;
use plotters::drawing::IntoDrawingArea;
use plotters::element::{Drawable, IntoDynElement, PointCollection};
use plotters_backend::BackendCoord;

use grazing_results::{Frame, Names};

use crate::error::DrawingError;
use crate::geometry::clip::{clip_polygon, clip_polyline};
use crate::geometry::sheet::{Bounds, Spot, in_hundredths, in_points};
use crate::ink::canvas::{Anchor, Canvas};
use crate::ink::elements::{Area, Filling, Stroke};
use crate::ink::font::Fonts;
use crate::ink::labels::Labels;
use crate::ink::markers::Marker;
use crate::ink::markup::Label;
use crate::ink::sheet::{Element, PanelMark};
use crate::ink::style::{BLACK, FRAME, MINOR_TICK_LENGTH, Pen, TICK, TICK_LENGTH, TICK_SIZE, TITLE_SIZE};
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

/// A rectangle of data space mapped to one of the sheet: a chart of plotters, with a frame of ours.
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
    /// The chart of plotters that the panel is.
    pub chart: Chart,
}

/// A chart of plotters on a sheet.
type Chart = ChartContext<'static, Canvas, Cartesian2d<RangedCoordf64, RangedCoordf64>>;

/// A series that has been drawn: plotters' annotation of it, and its place on the sheet.
pub struct DrawnSeries<'p> {
    canvas: &'p Canvas,
    annotation: &'p mut SeriesAnno<'static, Canvas>,
    meaning: String,
    /// The spots of each element.
    pub pieces: Vec<Vec<Spot>>,
}

impl DrawnSeries<'_> {
    /// The meaning of the series for the legend, in words with formulas between dollars.
    pub fn label(self, meaning: &str) -> Self {
        DrawnSeries { meaning: meaning.to_owned(), ..self }
    }

    /// Adds the label with its sample to the legend of the sheet, unless it is known or the series is empty, and to what
    /// the chart's `configure_series_labels` draws.
    ///
    /// # Errors
    /// As [`Canvas::draw`].
    pub fn legend<E>(self, sample: impl Fn(BackendCoord) -> E + 'static) -> Result<Self, DrawingError>
    where
        E: IntoDynElement<'static, Canvas, BackendCoord>,
    {
        if !self.pieces.is_empty() && self.canvas.explain(&self.meaning, |at| sample(at).into_dyn())? {
            self.annotation.label(self.meaning.clone()).legend(sample);
        }
        Ok(self)
    }
}

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
    ///
    /// # Errors
    /// As [`Canvas::draw`].
    pub fn new(canvas: &'c Canvas, frame: Frame, bounds: Bounds) -> Result<Self, DrawingError> {
        let (left, top) = in_hundredths((bounds.left, bounds.top));
        let (right, bottom) = in_hundredths((bounds.right, bounds.bottom));
        // A chart leaves out the last unit in both directions.
        let area =
            canvas.clone().into_drawing_area().shrink((left, top), (right - left + 1, bottom - top + 1));
        let Frame { x: [first, last], y: [low, high] } = frame;
        let chart = ChartBuilder::on(&area).build_cartesian_2d(first..last, low..high)?;
        let (tables, only, columns): (&[_], _, _) = (&[], None, None);
        Ok(Panel { canvas, frame, bounds, tables, only, columns, numbers_beside: true, decades: None, chart })
    }

    /// The position of a data point on the sheet, truncated to whole hundredths of a point from the lower
    /// left corner.
    pub fn spot(&self, point: (f64, f64)) -> Spot {
        in_points(self.chart.backend_coord(&point))
    }

    /// The positions of data points on the sheet.
    pub fn spots(&self, points: &[(f64, f64)]) -> Vec<Spot> {
        points.iter().map(|&point| self.spot(point)).collect()
    }

    /// The data point at a position on the sheet.
    pub(crate) fn at(&self, (right, down): Spot) -> (f64, f64) {
        let Frame { x: [first, last], y: [low, high] } = self.frame;
        let Bounds { left, top, right: end, bottom } = self.bounds;
        let value = |share: f64, from: f64, to: f64| from + share * (to - from);
        let (across, up) = ((right - left) / (end - left), (bottom - down) / (bottom - top));
        (value(across, first, last), value(up, low, high))
    }

    /// Draws a series of elements as `ChartContext::draw_series` does, which draws points beyond the frame at its edge:
    /// [`curve`](Self::curve) and [`area`](Self::area) clip what they are given.
    ///
    /// # Errors
    /// As [`Canvas::draw`].
    pub fn draw_series<E>(
        &mut self,
        series: impl IntoIterator<Item = E>,
    ) -> Result<DrawnSeries<'_>, DrawingError>
    where
        for<'e> &'e E: PointCollection<'e, (f64, f64)>,
        E: Drawable<Canvas>,
    {
        let elements: Vec<E> = series.into_iter().collect();
        let spots =
            |element: &E| element.point_iter().into_iter().map(|point| self.spot(*point.borrow())).collect();
        let pieces = elements.iter().map(spots).collect();
        let annotation = self.chart.draw_series(elements)?;
        Ok(DrawnSeries { canvas: self.canvas, annotation, meaning: String::new(), pieces })
    }

    /// A curve as lines, clipped to the frame with all of their ink.
    pub fn curve(&self, points: &[(f64, f64)], pen: Pen) -> Vec<Stroke<(f64, f64)>> {
        let pieces = clip_polyline(&self.frame, points).into_iter();
        pieces.map(|piece| Stroke::new(piece, pen).within(self.bounds)).collect()
    }

    /// The area inside rings by the even-odd rule, clipped to the frame; none if nothing of its only ring is visible.
    pub fn area(&self, rings: &[Vec<(f64, f64)>], filling: impl Into<Filling>) -> Option<Area<(f64, f64)>> {
        let rings: Vec<_> = rings.iter().map(|ring| clip_polygon(&self.frame, ring)).collect();
        let visible = rings.len() > 1 || rings.iter().any(|ring| ring.len() > 2);
        visible.then(|| Area::new(rings, filling))
    }

    /// Draws markers at the points that are in the frame, and makes labels avoid them.
    ///
    /// # Errors
    /// As [`Canvas::draw`].
    pub fn mark(
        &mut self,
        labels: &mut Labels<'_>,
        points: impl IntoIterator<Item = (f64, f64)>,
        marker: Marker,
    ) -> Result<DrawnSeries<'_>, DrawingError> {
        let frame = self.frame;
        let visible = points.into_iter().filter(|point| frame.contains(*point));
        let drawn = self.draw_series(visible.map(|point| marker.at(point)))?;
        drawn.pieces.iter().flatten().for_each(|spot| labels.placer.block(marker.around(*spot)));
        Ok(drawn)
    }

    /// Adds the mark that describes the position and contents of the panel.
    fn mark_frame(&self, titles: [&str; 2]) {
        let Panel { frame, bounds, only, .. } = *self;
        let (tables, titles, columns) =
            (self.tables.to_vec(), titles.map(str::to_owned), self.columns.clone());
        let linear = self.decades.is_none();
        self.canvas.add(Element::Panel(PanelMark { bounds, frame, titles, tables, only, columns, linear }));
    }

    /// Draws border, outward ticks, numbers and axis titles; an empty title is omitted.
    pub fn axes(&self, x_title: &str, y_title: &str) -> Result<(), DrawingError> {
        let (Bounds { left, top, right, bottom }, canvas) = (self.bounds, self.canvas);
        self.mark_frame([x_title, y_title]);
        let outline = [(left, top), (right, top), (right, bottom), (left, bottom), (left, top), (right, top)];
        canvas.draw(&Stroke::new(outline, FRAME))?;
        let x_numbers = Numbers::along(&canvas.fonts, self.frame.x, right - left, Direction::Across)?;
        let y_numbers = Numbers::up(&canvas.fonts, self.frame.y, bottom - top, self.decades)?;
        let baseline = bottom + TICK_LENGTH + TICK_GAP + 0.66 * TICK_SIZE;
        let x_tick = |value: f64, length: f64| {
            let (x, _) = self.spot((value, self.frame.y[0]));
            canvas.draw(&Stroke::new([(x, bottom), (x, bottom + length)], TICK))?;
            Ok::<_, DrawingError>((x, baseline))
        };
        let y_tick = |value: f64, length: f64| {
            let (_, y) = self.spot((self.frame.x[0], value));
            canvas.draw(&Stroke::new([(left, y), (left - length, y)], TICK))?;
            Ok::<_, DrawingError>((left - TICK_LENGTH - TICK_GAP, y + 0.33 * TICK_SIZE))
        };
        for minor in &x_numbers.minor {
            x_tick(*minor, MINOR_TICK_LENGTH)?;
        }
        for tick in &x_numbers.ticks {
            canvas.text(x_tick(tick.value, TICK_LENGTH)?, &tick.label, TICK_SIZE, Anchor::Middle, BLACK)?;
        }
        for minor in &y_numbers.minor {
            y_tick(*minor, MINOR_TICK_LENGTH)?;
        }
        let reach = if self.numbers_beside { y_numbers.width } else { 0.0 };
        for tick in &y_numbers.ticks {
            let spot = y_tick(tick.value, TICK_LENGTH)?;
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
    use crate::ink::legend::line;

    /// The mark of a panel with these titles that shows a plane with these names.
    fn marked(titles: [&str; 2], names: &Names) -> String {
        let canvas = Canvas::new(100.0, 100.0).unwrap();
        let bounds = Bounds { left: 10.0, top: 20.0, right: 90.5, bottom: 80.0 };
        let panel = Panel {
            tables: &["points", "curves"],
            only: Some(("panel", 2)),
            columns: names.columns(),
            ..Panel::new(&canvas, Frame { x: [-0.5, 1.25], y: [0.0, 3.0] }, bounds).unwrap()
        };
        panel.mark_frame(titles);
        let svg = canvas.finish("test", "", "").unwrap().svg();
        svg.lines().find(|line| line.contains("panel")).unwrap().to_owned()
    }

    #[test]
    fn what_is_not_seen_has_no_marker_and_no_entry_in_the_legend_and_a_meaning_has_one() {
        let canvas = Canvas::new(100.0, 100.0).unwrap();
        let bounds = Bounds { left: 10.0, top: 20.0, right: 90.5, bottom: 80.0 };
        let frame = Frame { x: [0.0, 1.0], y: [0.0, 1.0] };
        let mut panel = Panel::new(&canvas, frame, bounds).unwrap();
        assert_eq!(panel.spots(&[(0.0, 0.0), (1.0, 1.0)]), [(10.0, 80.0), (90.5, 20.0)]);
        let mut labels = Labels::new(&canvas, bounds);
        let mut drawn = |points: &[(f64, f64)], meaning| {
            let series = panel.draw_series(panel.curve(points, FRAME)).unwrap();
            series.label(meaning).legend(line(FRAME)).unwrap().pieces
        };
        assert!(drawn(&[(2.0, 0.0), (3.0, 1.0)], "beyond").is_empty());
        assert_eq!(drawn(&[(0.0, 0.0), (2.0, 2.0)], "line"), [[(10.0, 80.0), (90.5, 20.0)]]);
        assert_eq!(
            drawn(&[(0.0, 0.5), (0.5, 0.5), (f64::NAN, 0.5), (0.6, 0.5), (1.0, 0.5)], "line").len(),
            2
        );
        let marks = panel.mark(&mut labels, [(2.0, 0.5), (1.0, 1.0)], Marker::Disc).unwrap();
        assert_eq!(marks.label("disc").legend(Marker::Disc.sample()).unwrap().pieces, [[(90.5, 20.0)]]);
        let sheet = canvas.finish("test", "", "").unwrap();
        let meanings: Vec<&str> = sheet.legend.iter().map(|(meaning, _)| meaning.as_str()).collect();
        assert_eq!(meanings, ["line", "disc"]);
        assert_eq!(sheet.short_body().matches("<circle").count(), 1);
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
