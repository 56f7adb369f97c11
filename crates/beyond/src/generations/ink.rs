//! Drawing of resonances of motion with impacts over Figure 7's window, and of magnifications.

use grazing_drawing::POINTS_PER_MM;
use grazing_drawing::geometry::sheet::Bounds;
use grazing_drawing::ink::canvas::{Anchor, Canvas};
use grazing_drawing::ink::labels::{Labels, Site};
use grazing_drawing::ink::legend;
use grazing_drawing::ink::markers::Marker;
use grazing_drawing::ink::markup::Label;
use grazing_drawing::ink::style::{BLACK, LABEL_SIZE, MAGNIFIED_TEXT, Pen, SMALL_LABEL_SIZE};
use grazing_drawing::plot::axes::Panel;
use grazing_drawing::plot::kinds::{Trace, TraceOf, draw_curves, draw_several, name_several};
use grazing_reproduction::prelude::*;
use grazing_results::plane::{CurveSource, PlanePoint};

use super::{Generations, LaterMagnified, LaterPoint};

const WIDTH_MM: f64 = 165.0;
/// Narrower sheets have two magnifications in a row.
const NARROW_MM: f64 = 120.0;
/// Room around panels, in points.
const LEFT: f64 = 38.0;
const RIGHT: f64 = 8.0;
const ABOVE: f64 = 17.0;
const BELOW: f64 = 31.0;
/// Room between magnifications for the numbers of their axes, in points.
const NUMBERS: f64 = 36.0;
/// Curves of Figure 7.
const KNOWN: Pen = Pen::solid([185, 185, 185], 0.8);
/// The letters of the magnifications.
const MAGNIFIED: [&str; 3] = ["(b)", "(c)", "(d)"];
/// The least length of a curve with a label, in points.
const NAMED_LENGTH: f64 = 40.0;
/// The distance of a letter from its triangle, in points.
const OFF_TRIANGLE: f64 = 5.4;

/// Draws the figure: above the window, below the magnifications.
pub(super) fn draw(figure: &Generations, width: SheetWidth) -> Result<Sheet, DrawingError> {
    let wide = width.mm(WIDTH_MM);
    let (window, each, in_a_row) = if wide < NARROW_MM { (77.0, 41.0, 2) } else { (103.0, 55.0, 3) };
    let panels: Vec<_> = figure.magnified.chunk_by(|a, b| a.panel == b.panel).zip(&figure.panels).collect();
    let rows = panels.len().div_ceil(in_a_row);
    let canvas = Canvas::new(wide, window + each * rows as f64)?;
    let [window, each] = [window, each].map(|mm| mm * POINTS_PER_MM);
    let right = canvas.width - RIGHT;
    let bounds = Bounds { left: LEFT, top: ABOVE, right, bottom: window - BELOW };
    draw_window(figure, &mut Panel::new(&canvas, figure.frame, bounds)?)?;
    canvas.text((LEFT, ABOVE - 5.0), "(a)", LABEL_SIZE, Anchor::Start, BLACK)?;
    let across = (right - LEFT - (in_a_row - 1) as f64 * NUMBERS) / in_a_row as f64;
    for (place, (rows, frame)) in panels.into_iter().enumerate() {
        let (row, column) = (place / in_a_row, place % in_a_row);
        let (left, top) = (LEFT + column as f64 * (across + NUMBERS), window + row as f64 * each);
        let bounds = Bounds { left, top: top + ABOVE, right: left + across, bottom: top + each - BELOW };
        let up = if column == 0 { r"$\omega$" } else { "" };
        draw_magnified(figure, rows, &mut Panel::new(&canvas, *frame, bounds)?, [MAGNIFIED[place], up])?;
    }
    canvas.finish(
        "beyond_generations",
        "Resonances of motion that already hits the wall",
        "Above: forcing amplitude across, frequency up. Grey: the curves of Figure 7. Triangles: resonances on the curves along which its \
         maximal periodic solutions graze; in colours, the curves of solutions with more impacts that leave them. Below: three of these \
         resonances magnified, with the quadratic approximations of the theorems dashed.",
    )
}

/// A curve of the table, where its solutions are admissible.
fn trace(rows: &[LaterPoint]) -> Trace {
    let spot = |row: &LaterPoint| match row.admissible || row.impact_velocity == 0.0 {
        true => (row.primary, row.secondary),
        false => (f64::NAN, f64::NAN),
    };
    Trace { kind: rows[0].kind, of: TraceOf::Bifurcation, points: rows.iter().map(spot).collect() }
}

fn draw_window(figure: &Generations, panel: &mut Panel<'_>) -> Result<(), DrawingError> {
    let mut labels = Labels::new(panel.canvas, panel.bounds);
    let several = draw_several(panel, &mut labels, &figure.regions)?;
    for curve in figure.known.chunk_by(|a, b| a.at.arc == b.at.arc) {
        let spot = |row: &PlanePoint| match row.at.admissible {
            true => (row.at.primary, row.at.secondary),
            false => (f64::NAN, f64::NAN),
        };
        let known = panel.draw_series(panel.curve(&curve.iter().map(spot).collect::<Vec<_>>(), KNOWN))?;
        let known = known.label("curves of Figure 7").legend(legend::line(KNOWN))?;
        known.pieces.iter().for_each(|piece| labels.placer.keep_off_nameless(piece));
    }
    let curves = figure.curves.chunk_by(|a, b| (a.number, a.arc) == (b.number, b.arc));
    let drawn = draw_curves(panel, &mut labels, curves.map(trace).collect())?;
    for row in &figure.resonances {
        let (marker, meaning) = match row.fails.is_empty() {
            true => (Marker::Triangle, "resonance of motion with impacts"),
            false => (Marker::Ring, "resonance at which no theorem applies"),
        };
        let mark = panel.mark(&mut labels, [(row.primary, row.secondary)], marker)?;
        mark.label(meaning).legend(marker.sample())?;
    }
    for (rows, letter) in figure.magnified.chunk_by(|a, b| a.panel == b.panel).zip(MAGNIFIED) {
        if let Some(row) = figure.resonances.iter().find(|row| row.number == rows[0].number) {
            let spots = [panel.spot((row.primary, row.secondary))];
            labels.add(letter, SMALL_LABEL_SIZE, MAGNIFIED_TEXT, &Site::Anyhow(&spots, OFF_TRIANGLE))?;
        }
    }
    name_several(&mut labels, panel.bounds, &several)?;
    labels.name_curves(drawn, NAMED_LENGTH, "grazing")?;
    labels.draw()?;
    panel.axes(r"$\mathcal{A}$", r"$\omega$")
}

fn draw_magnified(
    figure: &Generations,
    rows: &[LaterMagnified],
    panel: &mut Panel<'_>,
    [name, up]: [&str; 2],
) -> Result<(), DrawingError> {
    let mut labels = Labels::new(panel.canvas, panel.bounds);
    let trace = |run: &[LaterMagnified]| {
        let of = match run[0].source {
            CurveSource::Quadratic => TraceOf::Approximation,
            CurveSource::Continuation => TraceOf::Bifurcation,
        };
        Trace { kind: run[0].kind, of, points: run.iter().map(|row| (row.primary, row.secondary)).collect() }
    };
    let runs = rows.chunk_by(|a, b| (a.kind, a.source, a.arc) == (b.kind, b.source, b.arc));
    let drawn = draw_curves(panel, &mut labels, runs.map(trace).collect())?;
    let Some(row) = figure.resonances.iter().find(|row| row.number == rows[0].number) else { return Ok(()) };
    panel.mark(&mut labels, [(row.primary, row.secondary)], Marker::Triangle)?;
    labels.name_curves(drawn, 0.5 * NAMED_LENGTH, "grazing")?;
    labels.draw()?;
    let heading = format!("{name} $p={}$, $q={}$", row.base_loops, row.rounds);
    let canvas = panel.canvas;
    let wide = canvas.fonts.measure(&Label::parse(&heading)?, SMALL_LABEL_SIZE)?.width;
    let above = (panel.bounds.left.min(canvas.width - wide - 2.0), panel.bounds.top - 5.0);
    canvas.text(above, &heading, SMALL_LABEL_SIZE, Anchor::Start, BLACK)?;
    panel.axes(r"$\mathcal{A}$", up)
}
