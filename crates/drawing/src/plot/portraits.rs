//! The phase portraits above a one-parameter diagram: orbits in the (x, y) plane, and the wall.

use grazing_results::Frame;
use grazing_results::branches::{OneParameter, PortraitKind, PortraitPoint};

use crate::error::DrawingError;
use crate::geometry::clip::{checked, clip_polyline};
use crate::geometry::sheet::{Bounds, Spot};
use crate::ink::canvas::{Anchor, Canvas};
use crate::ink::markup::Label;
use crate::ink::style::{
    ATTRACTOR_ORBIT, BLACK, GUIDE, IMPACT, PERIODIC_ORBIT, SMALL_LABEL_SIZE, TICK_SIZE, WALL, WALL_FACE,
    WALL_HATCHING, branch_pen,
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
const GAP: f64 = 13.0;

/// The texts of phase portraits.
pub(crate) struct Caption<'a> {
    /// The name of the parameter on the diagram's horizontal axis.
    pub(crate) across: &'a str,
    /// The titles of the axes of a portrait.
    pub(crate) titles: [&'a str; 2],
    /// The table with the rows of the portraits.
    pub(crate) table: &'a [&'static str],
}

/// All portraits of a diagram.
pub(crate) fn portraits(figure: &OneParameter) -> Vec<Portrait<'_>> {
    figure.portraits.chunk_by(|a, b| a.portrait == b.portrait).collect()
}

/// The height of each of `rows` rows, in points.
pub(crate) fn row_height(rows: usize) -> f64 {
    if rows == 1 { SINGLE_ROW } else { ROW }
}

/// Draws the portraits in rows, all at the same scale.
pub(crate) fn draw_portraits(
    canvas: &Canvas,
    figure: &OneParameter,
    portraits: &[Portrait<'_>],
    caption: &Caption<'_>,
    rows: usize,
) -> Result<(), DrawingError> {
    let height = row_height(rows);
    let frame = checked(common_frame(portraits), "the phase portraits")?;
    let columns = portraits.len().div_ceil(rows.max(1)).max(1);
    let count = columns as f64;
    let first = room_beside(&canvas.fonts, frame.y, height - ABOVE - BELOW, caption.titles[1])?.max(LEFT);
    let width = (canvas.width - first - 6.0 - GAP * (count - 1.0)) / count;
    for (place, portrait) in portraits.iter().enumerate() {
        let PortraitPoint { portrait: number, loops, kind, .. } = portrait[0];
        let orbit: Vec<_> = portrait.iter().map(|point| (point.x, point.y)).collect();
        let (column, row) = (place % columns, place / columns);
        let left = first + (width + GAP) * column as f64;
        let top = height * row as f64 + ABOVE;
        let bottom = height * (row + 1) as f64 - BELOW;
        let bounds = Bounds { left, top, right: left + width - WALL_THICKNESS, bottom };
        let panel = Panel {
            tables: caption.table,
            only: Some(("portrait", number)),
            numbers_beside: column == 0,
            ..Panel::new(canvas, frame, bounds)
        };
        wall(&panel);
        let (pen, what) = match (kind, loops) {
            (PortraitKind::Attractor, _) => (ATTRACTOR_ORBIT, "attractor".to_owned()),
            (PortraitKind::Periodic, 0) => (branch_pen(0, PERIODIC_ORBIT.width), "no impacts".to_owned()),
            (PortraitKind::Periodic, p) => (branch_pen(p, PERIODIC_ORBIT.width), format!("$p={p}$")),
        };
        panel.line(&without_jumps(&orbit, at_wall(frame)), pen);
        let [x, y] = caption.titles;
        panel.axes(x, if column == 0 { y } else { "" })?;
        jump(&panel, &orbit);
        let at = equation(caption.across, &significant(figure.across(&portrait[0]), 4));
        let heading = format!("{} {at}, {what}", panel_letter(number));
        canvas.text((left, top - 5.0), &heading, TICK_SIZE, Anchor::Start, BLACK)?;
    }
    Ok(())
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
        panel.canvas.line(&guide, GUIDE);
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

/// Draws the impacts as one dashed line up the wall, from the fastest impact to the fastest recoil.
fn jump(panel: &Panel<'_>, orbit: &[(f64, f64)]) {
    let finite: Vec<(f64, f64)> =
        orbit.iter().copied().filter(|p| p.0.is_finite() && p.1.is_finite()).collect();
    // A periodic orbit may be given from recoil to impact, so that the jump closes it.
    let next = finite.iter().cycle().skip(1);
    let jumps: Vec<_> =
        finite.iter().zip(next).filter(|(from, to)| is_jump(**from, **to, at_wall(panel.frame))).collect();
    let arrival = jumps.iter().map(|(from, _)| from.1).fold(0.0, f64::max);
    let recoil = jumps.iter().map(|(_, to)| to.1).fold(0.0, f64::min);
    if arrival > recoil {
        let [from, to] = [panel.spot((0.0, arrival)), panel.spot((0.0, recoil))];
        let path = [(from.0 - 1.3, from.1), (to.0 - 1.3, to.1)];
        panel.canvas.line(&path, IMPACT);
    }
}

/// Draws the wall: a hatched strip to the right of x = 0.
fn wall(panel: &Panel<'_>) {
    let Bounds { top, right: left, bottom, .. } = panel.bounds;
    let right = left + WALL_THICKNESS;
    let canvas = panel.canvas;
    canvas.polygon(&[(left, top), (right, top), (right, bottom), (left, bottom)], WALL_FACE, None);
    let strip = Frame { x: [left, right], y: [top, bottom] };
    let mut start = top - WALL_THICKNESS;
    while start < bottom + WALL_THICKNESS {
        let stroke = [(left, start + WALL_THICKNESS), (right, start)];
        for piece in clip_polyline(&strip, &stroke) {
            canvas.line(&piece, WALL_HATCHING);
        }
        start += 3.5;
    }
    canvas.line(&[(left, top), (left, bottom)], WALL);
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
            jump(&Panel::new(&canvas, frame, bounds), orbit);
            canvas.finish("test", "", "").unwrap().svg().matches("stroke-dasharray").count()
        };
        assert_eq!(drawn(&[(0.0, -0.5), (-0.9, 0.0), (0.0, 0.6), (f64::NAN, f64::NAN)]), 1);
        assert_eq!(drawn(&[(0.0, 0.0), (-0.9, -0.5), (-0.9, 0.5), (0.0, 0.0)]), 0);
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
