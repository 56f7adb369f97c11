//! Drawing of the proofs over Figure 7's window, and of magnified tubes near points.

use grazing_drawing::geometry::sheet::Bounds;
use grazing_drawing::ink::canvas::{Anchor, Canvas};
use grazing_drawing::ink::labels::{Labels, Site};
use grazing_drawing::ink::legend;
use grazing_drawing::ink::markers::Marker;
use grazing_drawing::ink::markup::Label;
use grazing_drawing::ink::style::{
    BLACK, DISC_RADIUS, GREY, LABEL_SIZE, MAGNIFIED_TEXT, NON_IMPACTING_AREA, Paint, Pen, SMALL_LABEL_SIZE,
    branch_pen,
};
use grazing_drawing::plot::axes::Panel;
use grazing_drawing::plot::kinds::{Trace, TraceOf, draw_curves, shade};
use grazing_reproduction::prelude::*;
use grazing_results::Frame;
use grazing_results::kinds::CurveLook;
use grazing_results::plane::RegionKind;

use super::{Bifurcation, CodimensionTwo, ProofEnds, ProofMagnified, ProofPart, Proofs, REACH};

const WIDTH_MM: f64 = 165.0;
const HEIGHT_MM: f64 = 158.0;
/// Room around panels, in points.
const LEFT: f64 = 36.0;
const RIGHT: f64 = 8.0;
const ABOVE: f64 = 17.0;
const BELOW: f64 = 31.0;
const GAP: f64 = 14.0;
/// Room between magnifications for the numbers of their axes, in points.
const NUMBERS: f64 = 30.0;
/// The factor that allows for rounding in tubes that end at a box.
const ROUNDING: f64 = 1.0 + 1e-6;
/// The fractions of the sheet that the window takes: of the height, and of the width beside the panel of
/// the tubes' widths.
const SHARES: [f64; 2] = [0.64, 0.68];
/// The range of log₁₀ of the widths.
const WIDTHS: [f64; 2] = [-12.0, -5.5];
const GREEN: [u8; 3] = CurveLook::of(Bifurcation::Grazing).colours[0];
const TUBE: Paint = Paint { colour: GREEN, opacity: 0.4 };
const SIDE: Pen = Pen::solid(GREEN, 0.6);
const BOX: Pen = Pen::solid(BLACK, 0.8);
const GOAL: Pen = Pen::dashed(GREY, 0.5, &[3.0, 2.0]);
/// The letters of the magnifications.
const MAGNIFIED: [&str; 3] = ["(c)", "(d)", "(e)"];
/// The least area of a region with a label, in square points.
const NAMED: f64 = 60.0;
/// The least length of a grazing curve with a label, in points.
const NAMED_LENGTH: f64 = 40.0;

/// Draws the figure.
pub(super) fn draw(figure: &Proofs, width: SheetWidth) -> Result<Sheet, DrawingError> {
    let canvas = Canvas::new(width.mm(WIDTH_MM), HEIGHT_MM)?;
    let right = canvas.width - RIGHT;
    let parting = LEFT + SHARES[1] * (right - LEFT - GAP);
    let height = SHARES[0] * canvas.height;
    let upper = |left, right| Bounds { left, top: ABOVE, right, bottom: height - BELOW };
    draw_window(figure, &mut Panel::new(&canvas, figure.frame, upper(LEFT, parting))?)?;
    let widths = Frame { x: WIDTHS, y: figure.frame.y };
    let mut widths = Panel::new(&canvas, widths, upper(parting + GAP, right))?;
    widths.numbers_beside = false;
    let (mut labels, mut named) = (Labels::new(&canvas, widths.bounds), Vec::new());
    let goal = widths.curve(&[(-6.0, figure.frame.y[0]), (-6.0, figure.frame.y[1])], GOAL);
    for piece in widths.draw_series(goal)?.pieces {
        labels.placer.keep_off_nameless(&piece);
    }
    for run in figure.ends.chunk_by(|a, b| a.arc == b.arc).filter(|run| run[0].loops > 0) {
        let pen = branch_pen(run[0].loops, 0.9);
        let seen: Vec<_> = run.iter().filter(|ends| ends.log_width.is_finite()).collect();
        let places: Vec<_> = seen.iter().map(|ends| (ends.log_width, ends.omega)).collect();
        let drawn = widths.draw_series(widths.curve(&places, pen))?;
        let drawn = drawn.label(&format!("width of the tube, p = {}", run[0].loops));
        for piece in drawn.legend(legend::line(pen))?.pieces {
            labels.placer.keep_off(&piece);
            named.push((run[0].loops, pen.colour, piece));
        }
    }
    for (loops, colour, piece) in &named {
        labels.add(&format!("${loops}$"), SMALL_LABEL_SIZE, *colour, &Site::Beside(piece))?;
    }
    labels.draw()?;
    widths.axes(r"$\mathrm{log}_{10}$ of width in $\mathcal{A}$", "")?;
    let panels: Vec<_> = figure.magnified.chunk_by(|a, b| a.panel == b.panel).collect();
    let each = (right - LEFT - 2.0 * NUMBERS) / 3.0;
    for (place, rows) in panels.iter().enumerate() {
        let left = LEFT + place as f64 * (each + NUMBERS);
        let bounds = Bounds { left, top: height + ABOVE, right: left + each, bottom: canvas.height - BELOW };
        draw_magnified(&canvas, rows, bounds, place)?;
    }
    for (name, left) in [("(a)", LEFT), ("(b)", parting + GAP)] {
        canvas.text((left, ABOVE - 5.0), name, LABEL_SIZE, Anchor::Start, BLACK)?;
    }
    canvas.finish(
        "beyond_proofs",
        "What is proved about Figure 7",
        "Upper left: forcing amplitude across, frequency up. Grey: stable admissible motion is proved to exist, in the darker area with impacts; \
         white: it is proved that there is none with one, two or three loops. Upper right: width in amplitude of the tubes in which GZ curves are \
         proved to lie. Below: tubes near three points, and boxes in which exactly one such point is proved to lie.",
    )
}

/// A run of rows as the boundary of its region; where motion ends beyond the window, with an amplitude
/// beyond the greatest.
fn outline(run: &[ProofEnds], greatest: f64) -> Vec<(f64, f64)> {
    let begins = run.iter().map(|ends| (ends.begins, ends.omega));
    let last = |ends: &ProofEnds| if ends.upper.is_nan() { 2.0 * greatest } else { ends.lower };
    begins.chain(run.iter().rev().map(|ends| (last(ends), ends.omega))).collect()
}

fn draw_window(figure: &Proofs, panel: &mut Panel<'_>) -> Result<(), DrawingError> {
    let [_, greatest] = figure.frame.x;
    let mut labels = Labels::new(panel.canvas, panel.bounds);
    let (mut traces, mut names) = (Vec::new(), Vec::new());
    for run in figure.ends.chunk_by(|a, b| a.arc == b.arc) {
        if run[0].loops == 0 {
            let [first, last] = figure.frame.y;
            let grazing: Vec<_> = run.iter().map(|ends| (ends.begins, ends.omega)).collect();
            let area: Vec<_> = grazing.iter().copied().chain([(0.0, last), (0.0, first)]).collect();
            let drawn = panel.draw_series(panel.area(&[area], NON_IMPACTING_AREA))?;
            let drawn = drawn.label("proved: motion without impacts is stable");
            drawn.legend(legend::area(NON_IMPACTING_AREA))?;
            traces.push(trace(Bifurcation::NonImpactingGrazing, grazing));
            continue;
        }
        names.push((run[0].loops, shade(panel, &[outline(run, greatest)], RegionKind::Mps)?));
        let limits = run.chunk_by(|a, b| a.at == b.at);
        traces
            .extend(limits.map(|part| trace(part[0].at, part.iter().map(|e| (e.begins, e.omega)).collect())));
        let tube = run.iter().filter(|ends| !ends.upper.is_nan());
        traces.push(trace(Bifurcation::Grazing, tube.map(|ends| (ends.upper, ends.omega)).collect()));
    }
    let drawn = draw_curves(panel, &mut labels, traces)?;
    for item in figure.items.iter().filter(|item| item.object == "point") {
        let (marker, what) = if item.kind == "resonance" {
            (Marker::Triangle, "resonance")
        } else {
            (Marker::Disc, "other codimension-two point")
        };
        let omega = 0.5 * (item.from + item.to);
        let mark = panel.mark(&mut labels, [(item.amplitude, omega)], marker)?;
        mark.label(&format!("proved: {what}")).legend(marker.sample())?;
    }
    // The letter of a magnification stands at its point.
    for (rows, letter) in figure.magnified.chunk_by(|a, b| a.panel == b.panel).zip(MAGNIFIED) {
        let at = panel.spot((rows[0].primary, rows[0].secondary));
        labels.add(letter, SMALL_LABEL_SIZE, MAGNIFIED_TEXT, &Site::Around(at, DISC_RADIUS + 1.5))?;
    }
    for (loops, seen) in names {
        let shoelace = seen.iter().zip(seen.iter().cycle().skip(1)).map(|(a, b)| a.0 * b.1 - a.1 * b.0);
        if (0.5 * shoelace.sum::<f64>()).abs() > NAMED {
            labels.add(&format!("${loops}$"), SMALL_LABEL_SIZE, BLACK, &Site::Within(&seen))?;
        }
    }
    labels.name_curves(drawn, NAMED_LENGTH, "grazing")?;
    labels.draw()?;
    panel.axes(r"$\mathcal{A}$", r"$\omega$")
}

fn trace(kind: Bifurcation, points: Vec<(f64, f64)>) -> Trace {
    Trace { kind, of: TraceOf::Bifurcation, points }
}

fn draw_magnified(
    canvas: &Canvas,
    rows: &[ProofMagnified],
    bounds: Bounds,
    place: usize,
) -> Result<(), DrawingError> {
    let ProofMagnified { kind, loops, .. } = rows[0];
    let (boxed, tubes): (Vec<_>, Vec<_>) = rows.iter().partition(|row| row.part == ProofPart::Box);
    let high = boxed[0].omega.abs();
    // The box is clearly visible, and so are tubes that end at it.
    let beside = tubes.iter().filter(|row| row.omega.abs() <= ROUNDING * high);
    let sides = beside.flat_map(|row| [row.lower.abs(), row.upper.abs()]);
    let (across, up) = (REACH * sides.fold(boxed[0].upper, f64::max), 2.0 * REACH * high);
    let mut panel = Panel::new(canvas, Frame { x: [-across, across], y: [-up, up] }, bounds)?;
    for run in tubes.chunk_by(|a, b| a.arc == b.arc) {
        let side = |of: fn(&ProofMagnified) -> f64| run.iter().map(move |row| (of(row), row.omega));
        let between = |one: fn(&ProofMagnified) -> f64, other: fn(&ProofMagnified) -> f64| -> Vec<_> {
            side(one).chain(side(other).rev()).collect()
        };
        shade(&mut panel, &[between(|row| row.begins, |row| row.lower)], RegionKind::Mps)?;
        let tube = panel.draw_series(panel.area(&[between(|row| row.lower, |row| row.upper)], TUBE))?;
        tube.label("tube in which the GZ curve lies").legend(legend::area(TUBE))?;
        for of in [(|row| row.lower) as fn(&ProofMagnified) -> f64, |row| row.upper] {
            panel.draw_series(panel.curve(&side(of).collect::<Vec<_>>(), SIDE))?;
        }
        let limit = match kind {
            CodimensionTwo::PeriodDoublingGrazing => Bifurcation::PeriodDoubling,
            _ => Bifurcation::SaddleNode,
        };
        let look = CurveLook::of(limit);
        let limit: Vec<_> = side(|row| row.begins).collect();
        panel.draw_series(panel.curve(&limit, Pen::solid(look.colours[0], look.width)))?;
    }
    let [low, high] = [boxed[0], boxed[1]].map(|row| row.omega);
    let [left, right] = [boxed[0].lower, boxed[0].upper];
    let outline = [(left, low), (right, low), (right, high), (left, high), (left, low)];
    let drawn = panel.draw_series(panel.curve(&outline, BOX))?;
    drawn.label("box in which exactly one point lies").legend(legend::rectangle(BOX))?;
    let name = MAGNIFIED[place];
    let heading = format!("{name} {}, $p={loops}$", kind.name());
    let wide = canvas.fonts.measure(&Label::parse(&heading)?, SMALL_LABEL_SIZE)?.width;
    let above = (bounds.left.min(canvas.width - wide - 2.0), bounds.top - 5.0);
    canvas.text(above, &heading, SMALL_LABEL_SIZE, Anchor::Start, BLACK)?;
    panel.axes(r"$10^6\,\Delta\mathcal{A}$", if place == 0 { r"$10^9\,\Delta\omega$" } else { "" })
}
