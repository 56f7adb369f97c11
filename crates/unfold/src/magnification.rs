//! The diagram close to one resonance, with the quadratic approximations of the theorem.

use grazing_continuation::arclength::StepControl;
use grazing_continuation::bifurcation::Bifurcation;
use grazing_continuation::curve::{Curve, Window};
use grazing_continuation::locate::same_point;
use grazing_continuation::resonance::{ResonanceError, ResonantGrazingPoint};
use grazing_model::ImpactOscillator;
use grazing_results::plane::{CurveSource, MagnifiedPoint};
use grazing_results::span;
use grazing_theorems::resonant_theorem::BifurcationCurve;

use crate::diagram::{Diagram, DiagramCurve, route};
use crate::grazing::{GrazingCurve, interpolated};
use crate::resonances::FoundResonance;

/// Short steps, for curves at thirty times the scale of the diagram.
const MAGNIFIED: StepControl =
    StepControl { first: 1e-4, longest: 4e-3, shortest: 1e-6, turn: 0.02, ..StepControl::DRAWING };

/// Number of samples of a quadratic approximation from the resonance to the edge of the window, and
/// of the grazing curve across it.
const SAMPLES: u32 = 100;

/// The curves in a window about a resonance, numbered from 1 and in no panel yet: grazing, the resonance's own, its
/// neighbours', quadratic approximations.
///
/// # Errors
/// The resonance's curves could not be followed.
pub fn magnify(
    diagram: &Diagram,
    resonance: &FoundResonance,
    point: &ResonantGrazingPoint,
    window: Window,
) -> Result<Vec<MagnifiedPoint>, ResonanceError> {
    let own = [resonance.loops, resonance.n];
    let continued = |kind, of, points| line(kind, CurveSource::Continuation, of, points);
    let mut list: Vec<_> = diagram
        .grazing
        .iter()
        .map(|curve| continued(Bifurcation::NonImpactingGrazing, [0, 0], close_to(curve, window)))
        .collect();
    list.retain(|line| line.len() > 1);

    let unfolded = point.unfold(&route(window, MAGNIFIED))?;
    let unfolding = |curve: &Curve| {
        Some(continued(Bifurcation::of(curve.condition, resonance.loops)?, own, curve.parameters()))
    };
    list.extend(unfolded.curves().filter_map(unfolding));
    // The resonance's own curves are included already; one of them may begin outside and enter
    // again.
    let start = |curve: &Curve| (curve.condition, curve.points[0].solution.unknowns.clone());
    let starts: Vec<_> = unfolded.curves().map(start).collect();
    let shown = |curve: &DiagramCurve| {
        let begins = |end| {
            starts
                .iter()
                .any(|(condition, start)| *condition == curve.curve.condition && same_point(start, end))
        };
        curve.loops == resonance.loops && curve.ends().iter().any(begins)
    };
    for other in diagram.curves.iter().filter(|curve| !shown(curve)) {
        let points = other.curve.parameters();
        if points.iter().any(|point| window.contains(*point)) {
            list.push(continued(other.kind, [other.loops, other.n], points));
        }
    }

    for (kind, curve) in point.leading().named() {
        let points = approximation(point, curve, window);
        list.push(line(kind, CurveSource::Quadratic, own, points));
    }
    let numbered = (1..).zip(list);
    let points =
        numbered.flat_map(|(arc, line)| line.into_iter().map(move |point| MagnifiedPoint { arc, ..point }));
    Ok(points.collect())
}

/// The points of a curve, not yet numbered.
fn line(
    kind: Bifurcation,
    source: CurveSource,
    [loops, n]: [u32; 2],
    points: Vec<[f64; 2]>,
) -> Vec<MagnifiedPoint> {
    let row = |[primary, secondary]: [f64; 2]| MagnifiedPoint {
        panel: 0,
        loops,
        n,
        kind,
        source,
        arc: 0,
        secondary,
        primary,
    };
    points.into_iter().map(row).collect()
}

/// The part of a grazing curve with η in the window, with points spaced for it.
fn close_to(curve: &GrazingCurve, window: Window) -> Vec<[f64; 2]> {
    let [low, high] = window.secondary;
    let spacing = (high - low) / f64::from(SAMPLES);
    let mut points: Vec<[f64; 2]> = Vec::new();
    for pair in curve.states.windows(2) {
        let [a, b] = [&pair[0], &pair[1]].map(|state| state.orbit.oscillator().parameters());
        if a[1].max(b[1]) < low || a[1].min(b[1]) > high {
            continue;
        }
        let ends = [a[1].clamp(low, high), b[1].clamp(low, high)];
        // One part where the window is so low that the quotient is NaN.
        let parts = libm::ceil((ends[1] - ends[0]).abs() / spacing).max(1.0).min(f64::from(SAMPLES)) as u32;
        for part in 0..=parts {
            let share = f64::from(part) / f64::from(parts);
            let secondary = ends[0] * (1.0 - share) + ends[1] * share;
            let point = interpolated(pair, secondary).map(|place| place.parameters);
            points.extend(point.filter(|point| points.last() != Some(point)));
        }
    }
    points
}

/// The parabola primary = primary_graz(η) + c η² from the resonance to the edge of the window, on
/// the side of η given by theory.
pub fn approximation(point: &ResonantGrazingPoint, curve: BifurcationCurve, window: Window) -> Vec<[f64; 2]> {
    let [_, origin] = point.orbit().oscillator().parameters();
    let edge = if curve.eta_side.signum() < 0.0 { window.secondary[0] } else { window.secondary[1] };
    let mut points = Vec::new();
    let oscillator = point.orbit().oscillator();
    let mut near = point.orbit().place();
    for k in 0..=SAMPLES {
        let secondary = origin + (edge - origin) * f64::from(k) / f64::from(SAMPLES);
        let Ok(place) = near.moved(oscillator, secondary) else { break };
        near = place;
        let Some(mu) = curve.parameter(secondary - origin) else { continue };
        let primary = near.parameters[0] + mu;
        points.push([primary, secondary]);
        if !window.contains([primary, secondary]) {
            break;
        }
    }
    points
}

/// A window about a resonance in which the curves and their approximations can be distinguished and
/// compared.
///
/// Its half-height in η is where the terms beyond the quadratic one are some fifth of it on the
/// curve that bends sooner, or slightly beyond, but not more than half the way to the next
/// resonance of the same p; its width holds everything that is drawn, with a margin.
pub fn window_about(diagram: &Diagram, resonance: &FoundResonance, point: &ResonantGrazingPoint) -> Window {
    let whole = diagram.scope.window;
    let [_, origin] = point.orbit().oscillator().parameters();
    let mut reach = 0.25 * whole.widths()[1];
    for (other, at) in diagram.unfolding() {
        let gap = (at.orbit().oscillator().parameters()[1] - origin).abs();
        if other.loops == resonance.loops && gap > 0.0 {
            reach = reach.min(0.5 * gap);
        }
    }
    // The SN and PD curves with an end at the resonance, from there on.
    let start = point.unknowns();
    let leaving = |curve: &DiagramCurve| {
        let mut points = curve.curve.parameters();
        match curve.ends().map(|end| same_point(&start, &end)) {
            [true, _] => {}
            [_, true] => points.reverse(),
            _ => return None,
        }
        let is_own = curve.loops == resonance.loops && curve.kind != Bifurcation::Grazing;
        is_own.then_some((curve.kind, points))
    };
    let own: Vec<_> = diagram.curves.iter().filter_map(leaving).collect();
    let faithful = own.iter().map(|(kind, points)| faithful(point, *kind, points));
    let [least, most] = faithful
        .fold([f64::INFINITY, 0.0], |[least, most], reach| [f64::min(least, reach), f64::max(most, reach)]);
    // Between both curves, nearer to the one that bends sooner: little of it would be visible
    // beside a much steeper one.
    let middle = libm::cbrt(least * least * most);
    reach = reach.min(1.2 * middle);
    let secondary = [(origin - reach).max(whole.secondary[0]), (origin + reach).min(whole.secondary[1])];
    let shown = Window { primary: [f64::NEG_INFINITY, f64::INFINITY], secondary };
    let curves = own.into_iter().map(|(_, points)| points);
    let grazing = diagram.grazing.iter().map(|curve| close_to(curve, shown));
    let inside = curves.chain(grazing).flatten().filter(|at| shown.contains(*at));
    let extent = span(inside.map(|[primary, _]| primary));
    let margin = 0.05 * (extent[1] - extent[0]);
    let [least, most] = whole.primary;
    Window { primary: [(extent[0] - margin).max(least), (extent[1] + margin).min(most)], secondary }
}

/// The distance from the resonance in η within which a curve stays within a fifth of its quadratic
/// approximation, or the extent of the curve if that is less.
fn faithful(point: &ResonantGrazingPoint, kind: Bifurcation, curve: &[[f64; 2]]) -> f64 {
    let [BifurcationCurve { coefficient, .. }, _] = point.leading().starting_with(kind);
    let [_, origin] = point.orbit().oscillator().parameters();
    let mut reached = 0.0;
    let oscillator = point.orbit().oscillator();
    let mut near = point.orbit().place();
    for [primary, secondary] in curve.iter().skip(1) {
        let eta = secondary - origin;
        let Ok(place) = near.moved(oscillator, *secondary) else { break };
        near = place;
        let difference = primary - near.parameters[0] - coefficient * eta * eta;
        if difference.abs() > 0.2 * (coefficient * eta * eta).abs() {
            break;
        }
        reached = eta.abs();
    }
    // A curve that bends at once is shown over its first steps.
    f64::max(reached, curve.get(1).map_or(0.0, |first| (first[1] - origin).abs()))
}

/// Curves of magnifications, panel by panel from 1.
pub fn numbered<'a>(panels: impl IntoIterator<Item = &'a Vec<MagnifiedPoint>>) -> Vec<MagnifiedPoint> {
    let panels = (1..).zip(panels);
    panels
        .flat_map(|(panel, points)| points.iter().map(move |point| MagnifiedPoint { panel, ..point.clone() }))
        .collect()
}
