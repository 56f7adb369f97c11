//! Curves that enter a window from resonances outside of it.
//!
//! A sheet of solutions that only reaches into the window may lie between two slices, and nothing in the window
//! leads to it. What bounds it leaves a resonance, as everything else does: so the grazing curve is followed
//! beyond the window, and the curves of the nearest resonances there back to it.

use grazing_continuation::arclength::StepControl;
use grazing_continuation::bifurcation::Bifurcation;
use grazing_continuation::curve::{Curve, CurvePoint, Event, Route, Window};
use grazing_continuation::mps::LoopEquations;
use grazing_model::ImpactOscillator;

use crate::Scope;
use crate::curves::{DiagramCurve, Net, drawn};
use crate::grazing::{GrazingCurve, GrazingEnd};
use crate::progress::Silent;
use crate::resonances::{self, FoundResonance};

/// The most resonances outside a window whose curves are followed, those nearest to it.
const NEAREST: usize = 4;

/// The least room to either side of a range of μ, as a share of its values: resonances lie along the grazing
/// curve, on which μ changes by as much as its value while η does (empirical: of 1,680 random windows two needed a
/// quarter and a half).
const LEAST_ROOM: f64 = 0.75;

/// The scope with as much room again on every side, in μ with more if the range is narrow, but not as far as zero.
pub(crate) fn about(scope: &Scope) -> Scope {
    let wider = |[low, high]: [f64; 2], least: f64| {
        let room = (high - low).max(least * low.abs().max(high.abs()));
        let [below, above] = [low - room, high + room];
        [
            if low > 0.0 { below.max(0.5 * low) } else { below },
            if high < 0.0 { above.min(0.5 * high) } else { above },
        ]
    };
    let Window { primary, secondary } = scope.window;
    let window = Window { primary: wider(primary, LEAST_ROOM), secondary: wider(secondary, 0.0) };
    Scope { window, ..scope.clone() }
}

/// The grazing curves that leave a window, beyond it.
pub(crate) fn followed(curves: &[GrazingCurve], about: &Scope) -> Vec<GrazingCurve> {
    let leaving = |curve: &&GrazingCurve| {
        curve.periods == 1 && curve.ends.iter().any(|end| matches!(end, GrazingEnd::LeftWindow))
    };
    let further = curves.iter().filter(leaving).filter_map(|curve| {
        let state = curve.states.get(curve.states.len() / 2)?;
        GrazingCurve::through(&state.orbit, about, curve.periods).ok()
    });
    further.collect()
}

/// The bifurcations inside the window, one on each piece, of curves that enter it from the nearest resonances outside.
pub(crate) fn entering(
    equations: &LoopEquations,
    scope: &Scope,
    about: &Scope,
    grazing: &[GrazingCurve],
) -> Vec<Event> {
    let loops = equations.loops();
    let own = Scope { loops: vec![loops], ..about.clone() };
    let found = grazing.iter().flat_map(|curve| resonances::on_curve(curve, &own, &Silent).0).collect();
    let mut outside: Vec<(f64, FoundResonance)> = resonances::distinct(found, about.window)
        .into_iter()
        .map(|resonance| {
            (distance(scope.window, resonance.located.orbit().oscillator().parameters()), resonance)
        })
        .filter(|(away, resonance)| *away > 0.0 && !resonance.is_forgotten(loops))
        .collect();
    outside.sort_by(|a, b| a.0.total_cmp(&b.0));
    outside.truncate(NEAREST);
    let route = leading(about.window);
    let mut net = Net::new(equations.clone());
    for (_, resonance) in &outside {
        let Some(unfolded) = resonance.theorem.as_ref().ok().and_then(|point| point.unfold(&route).ok())
        else {
            continue;
        };
        for curve in unfolded.curves() {
            if let Some(kind) = Bifurcation::of(curve.condition, loops) {
                net.add(DiagramCurve { kind, loops, n: resonance.n, curve: curve.clone() });
            }
        }
    }
    net.grow(&route);
    let inside = |curve: &DiagramCurve| curve.within(scope.window);
    net.curves.iter().flat_map(inside).filter_map(|piece| middle(&piece.curve, scope.window)).collect()
}

/// The route of curves that only lead into the window, and are not drawn.
fn leading(window: Window) -> Route<'static> {
    let route = drawn(window);
    let StepControl { longest, turn, .. } = route.control;
    let control = StepControl { longest: LONGER * longest, turn: LONGER * turn, ..route.control };
    Route { control, ..route }
}

/// How much longer steps are there (empirical: in 1,680 random windows they lead to the same regions).
const LONGER: f64 = 3.0;

/// How far parameters are from a window, as a fraction of its ranges; 0 inside.
fn distance(window: Window, parameters: [f64; 2]) -> f64 {
    let beyond = |share: f64| (-share).max(share - 1.0).max(0.0);
    window.shares(parameters).into_iter().map(beyond).fold(0.0, f64::max)
}

/// The middle one of the points of a curve that lie in a window.
fn middle(curve: &Curve, window: Window) -> Option<Event> {
    let inside = |point: &&CurvePoint| window.contains(point.solution.parameters());
    let points: Vec<&CurvePoint> = curve.points.iter().filter(inside).collect();
    let CurvePoint { solution, times } = points.get(points.len() / 2)?;
    Some(Event { condition: curve.condition, solution: solution.clone(), index: 0, times: times.clone() })
}
