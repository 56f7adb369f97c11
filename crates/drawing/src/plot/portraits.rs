//! The phase portraits above a one-parameter diagram: orbits in the (x, y) plane, and the wall.

use grazing_results::Frame;
use grazing_results::branches::{OneParameter, PortraitKind, PortraitPoint};

use crate::error::DrawingError;
use crate::geometry::clip::{checked, clip_polyline};
use crate::geometry::sheet::{Bounds, Spot};
use crate::ink::canvas::{Anchor, Canvas};
use crate::ink::elements::{Area, Stroke};
use crate::ink::font::Fonts;
use crate::ink::markup::Label;
use crate::ink::style::{
    ATTRACTOR_ORBIT, BLACK, Colour, GUIDE, IMPACT, PERIODIC_ORBIT, Pen, SMALL_LABEL_SIZE, TICK_SIZE, WALL,
    WALL_FACE, WALL_GAP, WALL_HATCHING, branch_pen,
};
use crate::plot::axes::{Panel, room_beside};
use crate::plot::magnified::panel_letter;
use crate::plot::ticks::significant;

/// The points of one phase portrait: consecutive points with its number.
pub(crate) type Portrait<'a> = &'a [PortraitPoint];

/// The thickness of the wall on the sheet, in points.
const WALL_THICKNESS: f64 = 7.0;
/// The height of a row with headings, numbers and axis titles, in points: for a single row, and for one
/// of several.
const SINGLE_ROW: f64 = 140.0;
const ROW: f64 = 104.0;
/// Room above and below the frames of a row.
const ABOVE: f64 = 17.0;
const BELOW: f64 = 28.0;
const LEFT: f64 = 38.0;
const RIGHT: f64 = 6.0;
const GAP: f64 = 13.0;

/// The distance between the lines of a heading, in points, and the least size of its text.
const LEADING: f64 = 9.5;
const LEAST_SIZE: f64 = 6.0;

/// The texts of phase portraits.
pub(crate) struct PortraitTexts<'a> {
    /// The name of the parameter on the diagram's horizontal axis.
    pub(crate) across: &'a str,
    /// The titles of the axes of a portrait.
    pub(crate) titles: [&'a str; 2],
    /// The columns of the axes of a portrait, unless these are those of their titles.
    pub(crate) columns: Option<[String; 2]>,
    /// The table with the rows of the portraits.
    pub(crate) table: &'a [&'static str],
}

/// All portraits of a diagram in rows, at the same scale.
pub(crate) struct Portraits<'a> {
    figure: &'a OneParameter,
    pub(crate) shown: Vec<Portrait<'a>>,
    caption: PortraitTexts<'a>,
    columns: usize,
    frame: Frame,
    /// The left edge of the first portrait of a row, and the width of each with its wall, in points.
    left: f64,
    width: f64,
    /// The lines of each heading, and their size.
    headings: Vec<Vec<String>>,
    size: f64,
}

impl<'a> Portraits<'a> {
    /// The portraits of a diagram, `in_a_row` side by side on a sheet of this width in points.
    pub(crate) fn new(
        fonts: &Fonts,
        figure: &'a OneParameter,
        caption: PortraitTexts<'a>,
        in_a_row: usize,
        sheet: f64,
    ) -> Result<Self, DrawingError> {
        let shown: Vec<_> = figure.portraits.chunk_by(|a, b| a.portrait == b.portrait).collect();
        let columns = shown.len().div_ceil(shown.len().div_ceil(in_a_row).max(1)).max(1);
        let frame = common_frame(&shown);
        let mut portraits = Portraits {
            figure,
            shown,
            caption,
            columns,
            frame,
            left: 0.0,
            width: 0.0,
            headings: Vec::new(),
            size: TICK_SIZE,
        };
        if portraits.shown.is_empty() {
            return Ok(portraits);
        }
        checked(frame, "the phase portraits")?;
        let height = portraits.bare_row_height() - ABOVE - BELOW;
        portraits.left = room_beside(fonts, frame.y, height, portraits.caption.titles[1])?.max(LEFT);
        let gaps = GAP * (columns as f64 - 1.0);
        portraits.width = (sheet - portraits.left - RIGHT - gaps) / columns as f64;
        portraits.set_headings(fonts)?;
        Ok(portraits)
    }

    /// Breaks headings into as few lines as fit over a portrait, the same number for all, and sets them
    /// smaller if a line still does not fit.
    fn set_headings(&mut self, fonts: &Fonts) -> Result<(), DrawingError> {
        for lines in 1..=3 {
            self.headings = self.shown.iter().map(|portrait| self.heading(portrait, lines)).collect();
            self.size = TICK_SIZE;
            for (place, heading) in self.headings.iter().enumerate() {
                let last = (place + 1).is_multiple_of(self.columns);
                let room = self.width + if last { RIGHT } else { GAP } - 1.0;
                for line in heading {
                    let width = fonts.measure(&Label::parse(line)?, TICK_SIZE)?.room();
                    self.size = self.size.min(TICK_SIZE * room / width);
                }
            }
            if self.size == TICK_SIZE {
                break;
            }
        }
        self.size = self.size.max(LEAST_SIZE);
        Ok(())
    }

    /// The heading of a portrait in so many lines: its letter, the parameter's value, and what it shows.
    fn heading(&self, portrait: Portrait<'_>, lines: usize) -> Vec<String> {
        let what = match (portrait[0].kind, portrait[0].loops) {
            (PortraitKind::Attractor, _) => "attractor".to_owned(),
            (PortraitKind::Periodic, 0) => "no impacts".to_owned(),
            (PortraitKind::Periodic, p) => format!("$p={p}$"),
        };
        let (letter, value) =
            (panel_letter(portrait[0].portrait), significant(self.figure.across(&portrait[0]), 4));
        let (across, at) = (self.caption.across, equation(self.caption.across, &value));
        match lines {
            1 => vec![format!("{letter} {at}, {what}")],
            2 => vec![format!("{letter} {at},"), what],
            _ => vec![format!("{letter} {across}"), format!("= {value},"), what],
        }
    }

    fn rows(&self) -> usize {
        self.shown.len().div_ceil(self.columns)
    }

    /// The height of a row with headings of one line.
    fn bare_row_height(&self) -> f64 {
        if self.rows() == 1 { SINGLE_ROW } else { ROW }
    }

    /// The room that headings take beyond one line.
    fn further(&self) -> f64 {
        self.headings.first().map_or(0.0, |lines| LEADING * (lines.len() as f64 - 1.0))
    }

    /// The height of all rows, in points.
    pub(crate) fn height(&self) -> f64 {
        self.rows() as f64 * (self.bare_row_height() + self.further())
    }

    /// Draws the portraits.
    pub(crate) fn draw(&self, canvas: &Canvas) -> Result<(), DrawingError> {
        let Self { caption, frame, .. } = self;
        let pitch = self.bare_row_height() + self.further();
        for (place, (portrait, heading)) in self.shown.iter().zip(&self.headings).enumerate() {
            let PortraitPoint { portrait: number, loops, kind, .. } = portrait[0];
            let orbit: Vec<_> = portrait.iter().map(|point| (point.x, point.y)).collect();
            let (column, row) = (place % self.columns, place / self.columns);
            let left = self.left + (self.width + GAP) * column as f64;
            let top = pitch * row as f64 + self.further() + ABOVE;
            let bottom = pitch * (row + 1) as f64 - BELOW;
            let bounds = Bounds { left, top, right: left + self.width - WALL_THICKNESS, bottom };
            let mut panel = Panel {
                tables: caption.table,
                columns: caption.columns.clone(),
                only: Some(("portrait", number)),
                numbers_beside: column == 0,
                ..Panel::new(canvas, *frame, bounds)?
            };
            wall(&panel)?;
            let pen = match kind {
                PortraitKind::Attractor => ATTRACTOR_ORBIT,
                PortraitKind::Periodic => branch_pen(loops, PERIODIC_ORBIT.width),
            };
            panel.draw_series(panel.curve(&without_jumps(&orbit, at_wall(*frame)), pen))?;
            let [x, y] = caption.titles;
            panel.axes(x, if column == 0 { y } else { "" })?;
            jump(&mut panel, &orbit, pen.colour)?;
            for (above, line) in heading.iter().rev().enumerate() {
                let baseline = top - 5.0 - LEADING * above as f64;
                canvas.text((left, baseline), line, self.size, Anchor::Start, BLACK)?;
            }
        }
        Ok(())
    }
}

/// The extent of all orbits, ending at the wall and symmetric in y, with some room.
fn common_frame(portraits: &[Portrait<'_>]) -> Frame {
    let points = || portraits.iter().copied().flatten().filter(|p| p.x.is_finite() && p.y.is_finite());
    let least = points().map(|p| p.x).fold(0.0, f64::min);
    let fastest = points().map(|p| p.y.abs()).fold(0.0, f64::max);
    Frame { x: [1.06 * least, 0.0], y: [-1.1 * fastest, 1.1 * fastest] }
}

/// A title of an axis, set equal to a value of the parameter.
pub(crate) fn equation(title: &str, value: &str) -> String {
    match title.strip_suffix('$') {
        Some(symbol) => format!("{symbol}={value}$"),
        None => format!("{title} = {value}"),
    }
}

/// Draws the portraits' letters above the diagram, each over a guide at its amplitude; returns the
/// guides.
pub(crate) fn letters(
    panel: &Panel<'_>,
    figure: &OneParameter,
    portraits: &[Portrait<'_>],
) -> Result<Vec<Vec<Spot>>, DrawingError> {
    let mut marks: Vec<(f64, String)> = Vec::new();
    for portrait in portraits {
        let number = portrait[0].portrait;
        let (x, _) = panel.spot((figure.across(&portrait[0]), panel.frame.y[0]));
        if x < panel.bounds.left || x > panel.bounds.right {
            continue;
        }
        match marks.iter_mut().find(|mark| mark.0 == x) {
            Some((_, text)) => text.push_str(&panel_letter(number)),
            None => marks.push((x, panel_letter(number))),
        }
    }
    marks.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut free_from = f64::NEG_INFINITY;
    let mut guides = Vec::new();
    for (x, text) in &marks {
        let label = Label::plain(text);
        let half = 0.5 * panel.canvas.fonts.measure(&label, SMALL_LABEL_SIZE)?.room();
        let middle = x.max(free_from + half);
        free_from = middle + half + 2.0;
        let (top, bottom) = (panel.bounds.top, panel.bounds.bottom);
        let guide = vec![(*x, bottom), (*x, top), (middle, top - 4.0)];
        panel.canvas.draw(&Stroke::new(guide.clone(), GUIDE))?;
        guides.push(guide);
        panel.canvas.text((middle, top - 6.0), text, SMALL_LABEL_SIZE, Anchor::Middle, BLACK)?;
    }
    Ok(guides)
}

/// Whether the step is an impact: at the wall, from motion towards it to motion away from it.
fn is_jump(from: (f64, f64), to: (f64, f64), at_wall: f64) -> bool {
    from.0.abs() < at_wall && to.0.abs() < at_wall && from.1 > 0.0 && to.1 < 0.0
}

/// The distance within which a point is at the wall: impacts are located by root finding, which leaves an
/// error of a few roundings in x.
fn at_wall(frame: Frame) -> f64 {
    1e-6 * (frame.x[1] - frame.x[0])
}

/// The orbit with a break at each impact.
fn without_jumps(orbit: &[(f64, f64)], at_wall: f64) -> Vec<(f64, f64)> {
    let mut broken = Vec::with_capacity(orbit.len());
    for (index, &point) in orbit.iter().enumerate() {
        if index > 0 && is_jump(orbit[index - 1], point, at_wall) {
            broken.push((f64::NAN, f64::NAN));
        }
        broken.push(point);
    }
    broken
}

/// Draws the impacts as one dashed line in the wall's, from the fastest impact to the fastest recoil.
fn jump(panel: &mut Panel<'_>, orbit: &[(f64, f64)], colour: Colour) -> Result<(), DrawingError> {
    let finite: Vec<(f64, f64)> =
        orbit.iter().copied().filter(|p| p.0.is_finite() && p.1.is_finite()).collect();
    // A periodic orbit may be given from recoil to impact, so that the jump closes it.
    let next = finite.iter().cycle().skip(1);
    let jumps: Vec<_> =
        finite.iter().zip(next).filter(|(from, to)| is_jump(**from, **to, at_wall(panel.frame))).collect();
    let arrival = jumps.iter().map(|(from, _)| from.1).fold(0.0, f64::max);
    let recoil = jumps.iter().map(|(_, to)| to.1).fold(0.0, f64::min);
    if arrival > recoil {
        let pens = [WALL_GAP, Pen { colour, ..IMPACT }];
        panel.draw_series(pens.map(|pen| Stroke::new([(0.0, arrival), (0.0, recoil)], pen)))?;
    }
    Ok(())
}

/// Draws the wall: a hatched strip to the right of x = 0.
fn wall(panel: &Panel<'_>) -> Result<(), DrawingError> {
    let Bounds { top, right: left, bottom, .. } = panel.bounds;
    let right = left + WALL_THICKNESS;
    let canvas = panel.canvas;
    let face = [(left, top), (right, top), (right, bottom), (left, bottom)];
    canvas.draw(&Area::ring(face, WALL_FACE, None))?;
    let strip = Frame { x: [left, right], y: [top, bottom] };
    let mut start = top - WALL_THICKNESS;
    while start < bottom + WALL_THICKNESS {
        let stroke = [(left, start + WALL_THICKNESS), (right, start)];
        for piece in clip_polyline(&strip, &stroke) {
            canvas.draw(&Stroke::new(piece, WALL_HATCHING))?;
        }
        start += 3.5;
    }
    canvas.draw(&Stroke::new([(left, top), (left, bottom)], WALL))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_impact_breaks_the_line_and_a_fast_crossing_of_the_axis_does_not() {
        let orbit = [(-0.1, 1.0), (0.0, 0.9), (0.0, -0.8), (-0.1, -0.9), (-0.2, 0.1)];
        let broken = without_jumps(&orbit, 1e-6);
        assert_eq!(broken.len(), 6);
        assert!(broken[2].0.is_nan());
        assert_eq!(&broken[3..], &orbit[2..]);
    }

    #[test]
    fn the_jump_that_closes_a_periodic_orbit_is_drawn_dashed_and_a_graze_leaves_none() {
        let frame = Frame { x: [-1.0, 0.0], y: [-1.0, 1.0] };
        let bounds = Bounds { left: 10.0, top: 10.0, right: 90.0, bottom: 90.0 };
        let drawn = |orbit: &[(f64, f64)]| {
            let canvas = Canvas::new(40.0, 40.0).unwrap();
            jump(&mut Panel::new(&canvas, frame, bounds).unwrap(), orbit, BLACK).unwrap();
            let svg = canvas.finish("test", "", "").unwrap().svg();
            let dashed = svg.lines().filter(|line| line.contains("stroke-dasharray"));
            dashed.map(|line| line.split('"').nth(1).unwrap().to_owned()).collect::<Vec<_>>()
        };
        let dashed = drawn(&[(0.0, -0.5), (-0.9, 0.0), (0.0, 0.6), (f64::NAN, f64::NAN)]);
        // The wall, x = 0, is at the right edge; y from -0.5 to 0.6 spans 44 of 80 points.
        assert_eq!(dashed, ["M90,26L90,70"]);
        assert!(drawn(&[(0.0, 0.0), (-0.9, -0.5), (-0.9, 0.5), (0.0, 0.0)]).is_empty());
    }

    #[test]
    fn the_frame_ends_at_the_wall_and_holds_every_orbit() {
        let point = |x, y| PortraitPoint {
            diagram: 1,
            portrait: 1,
            loops: 0,
            secondary: 0.855,
            primary: 1.0,
            kind: PortraitKind::Periodic,
            time: 0.0,
            x,
            y,
        };
        let frame = common_frame(&[&[point(-2.0, 0.3), point(f64::NAN, 9.0)], &[point(-1.0, -0.7)]]);
        assert_eq!(frame.x[1], 0.0);
        assert!(frame.x[0] < -2.0 && frame.y[0] < -0.7 && frame.y[1] == -frame.y[0]);
    }
}
