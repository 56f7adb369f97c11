//! The curves that leave a resonance in straightened coordinates: their distance from the grazing
//! curve divided by η², for η over many orders of magnitude.
//!
//! All these curves are tangent to the grazing curve, so that near the resonance they can be
//! neither distinguished nor computed as a difference of places. In the coordinates (μ −
//! μ_graz(η))/η² against η each tends to a constant of its own, which theory gives. Near the
//! resonance the distance comes from interpolants in the impact velocity ([`Straightened`]), which
//! keep their digits at any scale; farther out it is a difference of solutions. Both come with an
//! estimate of their error; the smaller decides, and where they differ by more than both the
//! difference is the error.

use grazing_continuation::bifurcation::{Bifurcation, Pair};
use grazing_continuation::curve::CurvePoint;
use grazing_continuation::fit::{CoefficientError, Estimate, Straightened};
use grazing_continuation::locate::{Condition, locate, same_point};
use grazing_continuation::mps::{Formulation, LoopEquations, unknown};
use grazing_continuation::resonance::{LeavingCurve, ResonantGrazingPoint};
use grazing_model::ImpactOscillator;
use grazing_results::Frame;
use grazing_results::plane::{MagnifiedPanel, StraightenedCurves, StraightenedPoint};
use grazing_theorems::from_map::GrazingPlace;

use crate::diagram::Diagram;
use crate::resonances::FoundResonance;

/// Number of roundings in the difference of two places, each found by Newton's method.
const ROUNDINGS: f64 = 16.0;

/// The curves that bound the stable MPSs beside a resonance and leave it, each at those of the
/// given |η|, in increasing order, that it reaches before it ends or turns back, and at its end. They are numbered from 1,
/// and in no panel yet.
///
/// These are the SN and PD curves of the resonance's own p, whose interpolants are given, and at a
/// resonance of p = 1 the SN, PD and GZ curves of solutions with more loops
/// ([`leaving_iterated`](grazing_continuation::resonance::LocatedResonance::leaving_iterated)). A
/// curve that is not in the diagram is left out.
pub fn straighten(
    diagram: &Diagram,
    (resonance, point): (&FoundResonance, &ResonantGrazingPoint),
    own: &Pair<Result<Straightened, CoefficientError>>,
    etas: &[f64],
) -> Vec<StraightenedPoint> {
    let leaving = Pair::CONDITIONS.map(|condition| point.leaving(condition));
    let own = leaving.zip(own.clone()).into_array().into_iter();
    let more = diagram.scope.loops.iter().filter(|&&loops| loops > 1);
    let iterated = more.flat_map(|&loops| point.leaving_iterated(loops)).map(|curve| {
        let near = curve.straightened();
        (curve, near)
    });
    let curves =
        own.chain(iterated).filter_map(|(curve, near)| along(diagram, &curve, near.ok().as_ref(), etas));
    let n = resonance.n;
    let points = (1..)
        .zip(curves)
        .flat_map(|(arc, curve)| curve.into_iter().map(move |point| StraightenedPoint { n, arc, ..point }));
    points.collect()
}

/// The points of a curve from the resonance on, not yet numbered.
fn along(
    diagram: &Diagram,
    curve: &LeavingCurve<'_>,
    near: Option<&Straightened>,
    etas: &[f64],
) -> Option<Vec<StraightenedPoint>> {
    let loops = curve.equations.loops();
    let kind = Bifurcation::of(curve.condition, loops)?;
    let row = |eta, Estimate { value, error }| StraightenedPoint {
        panel: 0,
        loops,
        n: 0,
        kind,
        arc: 0,
        eta,
        distance: value,
        error: error / value.abs(),
        limit: curve.leading.coefficient,
    };
    let side = curve.leading.eta_side.signum();
    let [_, origin] = curve.resonance.orbit().oscillator().parameters();
    let outwards = outwards(diagram, curve)?;
    let eta = |point: &CurvePoint| point.solution.parameters()[1] - origin;
    let last = eta(outwards[outwards.len() - 1]).abs();
    let (mut points, mut place) = (Vec::new(), curve.resonance.orbit().place());
    for eta in etas.iter().filter(|eta| **eta < last).map(|eta| eta * side).chain([last * side]) {
        let known = near.and_then(|near| near.at(eta));
        let least = known.map_or(f64::INFINITY, |known| known.error);
        let found = match rounding(curve, eta) < least {
            true => far(curve, &outwards, eta, &mut place),
            false => None,
        };
        let distance = match (known, found) {
            (Some(known), Some(found)) => {
                let [mut best, other] =
                    if found.error < known.error { [found, known] } else { [known, found] };
                let difference = (best.value - other.value).abs();
                if difference > best.error + other.error {
                    best.error = difference;
                }
                Some(best)
            }
            (known, found) => known.or(found),
        };
        points.extend(distance.map(|distance| row(eta, distance)));
    }
    Some(points)
}

/// Effect of rounding: of places on their difference divided by η², and of η* on η.
fn rounding(curve: &LeavingCurve<'_>, eta: f64) -> f64 {
    let orbit = curve.resonance.orbit();
    let [primary, secondary] = orbit.oscillator().parameters();
    let place = primary.abs() + (orbit.primary_slope() * secondary).abs();
    let origin = 2.0 * (curve.leading.coefficient * eta * secondary).abs();
    ROUNDINGS * f64::EPSILON * (place + origin) / (eta * eta)
}

/// The points of the diagram's curve from the resonance to where it ends or turns back in η.
fn outwards<'a>(diagram: &'a Diagram, curve: &LeavingCurve<'_>) -> Option<Vec<&'a CurvePoint>> {
    let (start, side) = (curve.resonance.unknowns(), curve.leading.eta_side.signum());
    let away =
        |point: &CurvePoint| side * (point.solution.unknowns[unknown::SECONDARY] - start[unknown::SECONDARY]);
    let candidates = diagram
        .curves
        .iter()
        .filter(|other| other.loops == curve.equations.loops() && other.curve.condition == curve.condition);
    candidates.into_iter().find_map(|other| {
        let points = &other.curve.points;
        let begins = |point: Option<&CurvePoint>| {
            point.is_some_and(|point| same_point(&point.solution.unknowns, &start))
        };
        let ordered: Vec<&CurvePoint> = match (begins(points.first()), begins(points.last())) {
            (true, _) => points.iter().collect(),
            (false, true) => points.iter().rev().collect(),
            (false, false) => return None,
        };
        let monotone = 1 + ordered.windows(2).take_while(|pair| away(pair[1]) > away(pair[0])).count();
        (monotone > 1).then(|| ordered[..monotone].to_vec())
    })
}

/// The distance as a difference of places; its error consists of rounding and of the change under
/// integration in shorter steps. `near` is a place on the grazing curve, and becomes that at η.
fn far(
    curve: &LeavingCurve<'_>,
    outwards: &[&CurvePoint],
    eta: f64,
    near: &mut GrazingPlace,
) -> Option<Estimate> {
    let secondary = curve.resonance.orbit().oscillator().parameters()[1] + eta;
    let beyond = |point: &CurvePoint| point.solution.parameters()[1] - secondary;
    let pair = outwards.windows(2).find(|pair| beyond(pair[0]) * beyond(pair[1]) <= 0.0)?;
    let way = beyond(pair[0]) / (beyond(pair[0]) - beyond(pair[1]));
    let [from, to] = [pair[0], pair[1]].map(|point| point.solution.unknowns.clone());
    let conditions = [curve.condition, Condition::Secondary(secondary)];
    let mut distance = |equations: &LoopEquations| {
        // The maximum that touches the wall has no time at the resonance, but has one at the next
        // point.
        let mut times = pair[1].times.clone();
        let found = locate(equations, conditions, &from + (&to - &from) * way, &mut times).ok()?;
        *near = near.moved(&equations.oscillator_at(&found), secondary).ok()?;
        Some((found[unknown::PRIMARY] - near.parameters[0]) / (eta * eta))
    };
    let equations = curve.equations.with_formulation(Formulation::FixedPhase);
    let finer = equations.finely().map(|finer| distance(&finer));
    let value = distance(&equations)?;
    let integration = finer.map_or(Some(0.0), |fine| Some((fine? - value).abs()))?;
    Some(Estimate { value, error: rounding(curve, eta) + integration })
}

/// The leading digits of the |η| at which curves are straightened, for each decade.
const PER_DECADE: [f64; 5] = [1.0, 1.6, 2.5, 4.0, 6.3];
/// The number of decades.
const DECADES: i32 = 8;

/// Values of |η| over eight decades up to the largest power of ten within a range of the secondary
/// parameter, all in the parameter's own unit, in which they are round numbers.
pub fn etas([low, high]: [f64; 2]) -> Vec<f64> {
    let top = libm::floor(libm::log10(high - low)) as i32;
    let decade = |power: i32| PER_DECADE.map(|digits| round(digits, power));
    (top - DECADES..top).flat_map(decade).chain([round(1.0, top)]).collect()
}

/// The number `digits`·10^`power`, correctly rounded.
fn round(digits: f64, power: i32) -> f64 {
    format!("{digits}e{power}").parse().unwrap_or(f64::NAN)
}

/// Margin of a panel as a fraction of the extent of the limits.
const MARGIN: f64 = 0.25;

/// Curves in straightened coordinates, with a panel for each resonance that has curves; the frames of the
/// panels are chosen here. All in the oscillator's own units.
pub fn panels<'a>(
    panels: impl IntoIterator<Item = (MagnifiedPanel, &'a [StraightenedPoint])>,
) -> StraightenedCurves {
    let (mut rows, mut shown) = (Vec::new(), Vec::new());
    for (panel, points) in panels {
        rows.extend(points.iter().map(|point| StraightenedPoint { panel: panel.panel, ..point.clone() }));
        let limits = || points.iter().map(|point| point.limit);
        let [low, high] = [limits().fold(0.0, f64::min), limits().fold(0.0, f64::max)];
        let margin = MARGIN * (high - low);
        let farthest = points.iter().map(|point| point.eta.abs()).fold(0.0, f64::max);
        if farthest > 0.0 && margin > 0.0 {
            let frame = Frame { x: [low - margin, high + margin], y: [-farthest, farthest] };
            shown.push(MagnifiedPanel { frame, ..panel });
        }
    }
    StraightenedCurves { curves: rows, panels: shown }
}
