//! The behaviour of an oscillator at one place: time series, phase portrait, impacts, and basins of
//! attraction.

use core::f64::consts::PI;

use grazing_results::kinds::{IRREGULAR, PERIODIC};
use grazing_results::place::{AtPlace, BasinState, PlaceAttractor, PlaceMotion};
use grazing_results::{Frame, span};

use crate::error::DrawingError;
use crate::geometry::clip::checked;
use crate::geometry::sheet::Bounds;
use crate::ink::canvas::{Anchor, Canvas};
use crate::ink::elements::{Disc, Stroke};
use crate::ink::legend;
use crate::ink::markup::Label;
use crate::ink::sheet::Sheet;
use crate::ink::style::{BLACK, GREY, Paint, Pen, SMALL_LABEL_SIZE, SheetWidth, WALL, branch_pen};
use crate::ink::svg::POINTS_PER_MM;
use crate::plot::axes::{Heading, Panel, room_beside};

/// The width in the paper, and the width below which all panels are drawn one above the other.
const WIDTH_MM: f64 = 156.0;
const WIDE_MM: f64 = 120.0;
/// The height of a row of panels, with room above for a line of words, below for numbers and titles, and
/// on both sides, in points.
const ROW: f64 = 150.0;
const LINE: f64 = 11.0;
const BELOW: f64 = 32.0;
const ABOVE: f64 = 5.0;
const LEFT: f64 = 38.0;
const RIGHT: f64 = 8.0;
const SWATCH: f64 = 16.0;
/// The least and the greatest number of forcing periods in the time series.
const SHORTEST: f64 = 4.0;
const LONGEST: f64 = 12.0;
/// Free space around the data, as a fraction of their extent.
const ROOM: f64 = 0.06;
const ORBIT: f64 = 0.8;
/// The thinner line width for many flights, and the number of points from which it is used.
const CROWDED: f64 = 0.3;
const MANY: usize = 5_000;
/// The radius of an impact's dot on the sheet.
const IMPACT_RADIUS: f64 = 1.3;

/// The pen of an attractor, by the number of loops if it has one.
fn pen(attractor: &PlaceAttractor, width: f64) -> Pen {
    match attractor.loops() {
        Some(p) => branch_pen(p, width),
        None if attractor.periods > 0.0 => Pen::solid(PERIODIC[0], width),
        None if attractor.exponent.is_finite() => Pen::solid(IRREGULAR[0], width),
        None => Pen::solid(GREY, width),
    }
}

/// The least interval that contains all values, with some room.
fn extent(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let [low, high] = span(values);
    let room = if high > low { ROOM * (high - low) } else { 1.0 };
    if low <= high { [low - room, high + room] } else { [-1.0, 1.0] }
}

/// Draws the results for a place; the tables of the heading are those of motion, impacts and basins.
///
/// # Errors
/// [`DrawingError`] if a frame is empty.
pub fn draw_place(figure: &AtPlace, heading: &Heading<'_>, width: SheetWidth) -> Result<Sheet, DrawingError> {
    let width = width.mm(WIDTH_MM);
    let narrow = width < WIDE_MM;
    let names = heading.names;
    let x = names.titled(if figure.from_the_wall { "$x$ from the wall" } else { "$x$" }, "length");
    let [y, velocity] = ["$y$", "impact velocity"].map(|title| names.titled(title, "length/time"));
    let share = |one: &PlaceAttractor| format!("{}: {:.0} %", one.words(), 100.0 * one.share);
    let mut words: Vec<_> = figure.attractors.iter().map(|one| (Some(one), share(one))).collect();
    if figure.undecided() > 0 {
        let counts = format!("{} of {}", figure.undecided(), figure.basins.len());
        words.push((None, format!("blank: {counts} states not settled")));
    }
    let rows = if narrow { 4.0 } else { 2.0 };
    let legend = LINE * words.len() as f64 + ABOVE;
    let canvas = Canvas::new(width, (legend + rows * ROW) / POINTS_PER_MM)?;
    for (k, (one, words)) in words.iter().enumerate() {
        let baseline = LINE * (k as f64 + 1.0);
        if let Some(one) = one {
            let (middle, pen) = (baseline - 0.3 * SMALL_LABEL_SIZE, pen(one, 2.0));
            canvas.draw(&Stroke::new([(LEFT, middle), (LEFT + SWATCH, middle)], pen))?;
            canvas.explain(&one.words(), legend::line(pen))?;
        }
        canvas.label(
            (LEFT + SWATCH + 5.0, baseline),
            &Label::parse(words)?,
            SMALL_LABEL_SIZE,
            Anchor::Start,
            BLACK,
        )?;
    }
    // The bounds of a panel, from its row, its number in the row and the number of panels in the row.
    let place = |row: f64, [number, count]: [f64; 2], frame: Frame, up: &str| {
        let top = legend + ROW * row + ABOVE;
        let bottom = top + ROW - ABOVE - BELOW;
        let whole = canvas.width / count;
        let left = whole * number + room_beside(&canvas.fonts, frame.y, bottom - top, up)?.max(LEFT);
        Ok::<_, DrawingError>(Bounds { left, top, right: whole * (number + 1.0) - RIGHT, bottom })
    };
    let beside = |number: f64| if narrow { (number + 1.0, [0.0, 1.0]) } else { (1.0, [number, 3.0]) };
    let [xs, ys] = [|point: &PlaceMotion| point.x, |point: &PlaceMotion| point.y]
        .map(|of| extent(figure.motion.iter().map(of).chain([0.0])));
    let flights = || figure.motion.chunk_by(|a, b| (a.attractor, a.flight) == (b.attractor, b.flight));
    let thin = |number: u32| {
        let count = figure.motion.iter().filter(|point| point.attractor == number).count();
        if count > MANY { CROWDED } else { ORBIT }
    };
    // Time series, each from the beginning of a forcing period.
    let turns = figure.attractors.iter().map(|one| 2.0 * one.periods);
    let turns = turns.fold(SHORTEST, f64::max).min(LONGEST);
    let frame = checked(Frame { x: [0.0, turns], y: xs }, "a time series")?;
    let bounds = place(0.0, [0.0, 1.0], frame, &x)?;
    let mut panel = Panel::new(&canvas, frame, bounds)?;
    panel.draw_series(panel.curve(&[(0.0, 0.0), (turns, 0.0)], WALL))?;
    for one in &figure.attractors {
        let own = || flights().filter(|points| points[0].attractor == one.attractor);
        let [mut from, mut to] = [f64::NAN; 2];
        for point in own().flatten() {
            (from, to) = (from.min(point.time), to.max(point.time));
        }
        let whole = libm::floor(from / figure.period) * figure.period;
        // Periodic motion is repeated.
        let repeats =
            if one.periods > 0.0 { libm::ceil(turns * figure.period / (to - from)) + 1.0 } else { 1.0 };
        for turn in -1..repeats.min(2.0 * LONGEST) as i32 {
            if turn < 0 && repeats < 2.0 {
                continue;
            }
            for points in own() {
                let shifted = |point: &PlaceMotion| {
                    ((point.time - whole + f64::from(turn) * (to - from)) / figure.period, point.x)
                };
                let (points, pen): (Vec<_>, _) =
                    (points.iter().map(shifted).collect(), pen(one, thin(one.attractor)));
                panel.draw_series(panel.curve(&points, pen))?;
            }
        }
    }
    panel.axes("$t/T$", &x)?;
    // The phase portrait.
    let frame = checked(Frame { x: xs, y: ys }, "a phase portrait")?;
    let (row, columns) = beside(0.0);
    let only = Some(("place", figure.place));
    let bounds = place(row, columns, frame, &y)?;
    let mut panel = Panel { tables: &heading.tables[..1], only, ..Panel::new(&canvas, frame, bounds)? };
    panel.draw_series(panel.curve(&[(0.0, ys[0]), (0.0, ys[1])], WALL))?;
    for points in flights() {
        let number = points[0].attractor;
        let Some(one) = figure.attractor(number) else { continue };
        let points: Vec<_> = points.iter().map(|point| (point.x, point.y)).collect();
        panel.draw_series(panel.curve(&points, pen(one, thin(number))))?;
    }
    panel.axes(&x, &y)?;
    // Impacts.
    let fastest = figure.impacts.iter().map(|impact| impact.impact_velocity.abs()).fold(0.0, f64::max);
    let top = if fastest > 0.0 { (1.0 + ROOM) * fastest } else { 1.0 };
    let frame = checked(Frame { x: [-PI, PI], y: [0.0, top] }, "the impacts")?;
    let (row, columns) = beside(1.0);
    let bounds = place(row, columns, frame, &velocity)?;
    let mut panel = Panel { tables: &heading.tables[1..2], only, ..Panel::new(&canvas, frame, bounds)? };
    panel.draw_series(figure.impacts.iter().filter_map(|impact| {
        let paint = Paint::opaque(pen(figure.attractor(impact.attractor)?, 1.0).colour);
        let at = (impact.impact_phase, impact.impact_velocity.abs());
        Some(Disc::new(at, IMPACT_RADIUS, paint, None))
    }))?;
    panel.axes("phase", &velocity)?;
    // Basins.
    let [phases, positions] = figure.lattice.map(f64::from);
    let deepest = figure.basins.iter().map(|state| state.start_x).fold(0.0, f64::min);
    let deepest = deepest / (1.0 - 0.5 / positions.max(1.0));
    let frame = Frame { x: [0.0, 2.0 * PI], y: [if deepest < 0.0 { deepest } else { -1.0 }, 0.0] };
    let frame = checked(frame, "the basins")?;
    let (row, columns) = beside(2.0);
    let start = format!("initial {x}, at rest");
    let bounds = place(row, columns, frame, &start)?;
    let mut panel = Panel { tables: &heading.tables[2..], only, ..Panel::new(&canvas, frame, bounds)? };
    let half = [PI / phases, 0.5 * deepest.abs() / positions];
    for one in &figure.attractors {
        // States that have not settled have the number 0, and stay blank.
        let own = |state: &&BasinState| state.attractor == one.attractor;
        let cells = figure.basins.iter().filter(own);
        let ring = |state: &BasinState| {
            let (z, x) = (state.start_phase, state.start_x);
            let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
            corners.map(|[across, up]| (z + across * half[0], x + up * half[1])).to_vec()
        };
        let paint = Paint { colour: pen(one, 1.0).colour, opacity: 0.8 };
        panel.draw_series(panel.area(&cells.map(ring).collect::<Vec<_>>(), paint))?;
    }
    panel.axes("initial phase", &start)?;
    canvas.finish(heading.name, heading.title, heading.description)
}

#[cfg(test)]
mod tests {
    use core::f64::consts::TAU;

    use grazing_results::place::{BasinState, PlaceImpact};
    use grazing_results::{Names, UnitNames};

    use super::*;
    use crate::tests::samples::WIDTHS;

    /// A sample place with an MPS of two loops and motion that is not periodic; `length` is the unit of
    /// length.
    fn sample(length: f64) -> AtPlace {
        let attractor = |attractor, motion, periods: f64, impacts| PlaceAttractor {
            place: 1,
            secondary: 0.8,
            primary: 0.9,
            attractor,
            states: 12,
            share: 0.5,
            motion,
            periods,
            impacts,
            second: f64::NAN,
            rests: 0.0,
            exponent: 0.01,
            exponent_error: 0.0,
        };
        let point = |k: u32| {
            let time = f64::from(k % 100) / 50.0;
            let x = -length * (1.0 - libm::cos(PI * time).abs());
            PlaceMotion { place: 1, attractor: 1 + k / 100, flight: 1, time, x, y: length * (time - 1.0) }
        };
        let impact = |attractor| PlaceImpact {
            place: 1,
            attractor,
            wall: 0,
            impact_phase: f64::from(attractor),
            impact_velocity: length,
        };
        let lattice = [6, 4];
        let state = |k: u32| BasinState {
            place: 1,
            start_phase: TAU * (f64::from(k / 4) + 0.5) / 6.0,
            start_x: -2.0 * length * (f64::from(k % 4) + 0.5) / 4.0,
            motion: ["periodic", "chaotic"][k as usize % 2],
            attractor: 1 + k % 2,
        };
        AtPlace {
            attractors: vec![attractor(1, "periodic", 2.0, 0.5), attractor(2, "chaotic", f64::NAN, 0.7)],
            solutions: Vec::new(),
            motion: (0..200).map(point).collect(),
            impacts: vec![impact(1), impact(2)],
            basins: (0..24).map(state).collect(),
            place: 1,
            at: [0.9, 0.8],
            states: 24,
            period: 1.0,
            from_the_wall: true,
            lattice,
        }
    }

    #[test]
    fn labels_keep_apart_at_any_width_and_basins_fill_their_panel() {
        let [length, time] = ["mm", "s"].map(|unit| Some(unit.to_owned()));
        let names = Names::new("A", "omega").with_units(UnitNames { length, time, ..UnitNames::default() });
        let tables = ["place_motion", "place_impacts", "place_basins"];
        let heading = Heading { name: "places", title: "", description: "", names: &names, tables: &tables };
        for (scale, width) in
            [1e-6, 1.0, 4e3].into_iter().flat_map(|scale| WIDTHS.map(|width| (scale, width)))
        {
            let sheet = draw_place(&sample(scale), &heading, width).unwrap();
            sheet.assert_well_placed(&(scale, width));
            let texts = sheet.texts();
            for text in ["MPS, $p=2$: 50 %", "chaotic: 50 %", "$y$ (mm/s)", "initial phase"] {
                assert!(texts.iter().any(|found| found.contains(text)), "{text}: {texts:?}");
            }
            // Half of the 24 cells for each attractor.
            let areas = sheet.short_body();
            let cells =
                areas.lines().filter(|line| line.contains("evenodd")).map(|line| line.matches('Z').count());
            assert_eq!(cells.collect::<Vec<_>>(), [12, 12]);
        }
    }

    #[test]
    fn chatter_and_rests_are_named_and_what_is_undecided_is_blank() {
        let mut figure = sample(1.0);
        let last = &mut figure.attractors[1];
        (last.motion, last.periods, last.impacts, last.rests) = ("periodic", 1.0, f64::INFINITY, 1.0);
        for (_, state) in figure.basins.iter_mut().enumerate().filter(|(k, _)| k % 2 == 1 && *k > 12) {
            (state.attractor, state.motion) = (0, "unsettled");
        }
        let names = Names::new("A", "omega");
        let tables = ["place_motion", "place_impacts", "place_basins"];
        let heading = Heading { name: "places", title: "", description: "", names: &names, tables: &tables };
        for width in WIDTHS {
            let sheet = draw_place(&figure, &heading, width).unwrap();
            sheet.assert_well_placed(&width);
            let texts = sheet.texts();
            for text in ["MPS, $p=2$: 50 %", "chatter and a rest in 1 period: 50 %", "6 of 24 states"] {
                assert!(texts.iter().any(|found| found.contains(text)), "{text}: {texts:?}");
            }
            let areas = sheet.short_body();
            let cells =
                areas.lines().filter(|line| line.contains("evenodd")).map(|line| line.matches('Z').count());
            assert_eq!(cells.collect::<Vec<_>>(), [12, 6]);
        }
    }
}
