//! Curves of the diagram on which MPSs have a requested property: an impact velocity, a modulus of
//! the multipliers, a distance from the wall at a phase of the forcing.
//!
//! They are followed in the same way as bifurcation curves. Each begins where a branch of a slice
//! or of a column, or a bifurcation curve, has the property between two of its points. They bound
//! no regions, and continue where solutions are unstable or inadmissible.

use core::f64::consts::TAU;
use core::mem::discriminant;

use grazing_continuation::arclength::StepControl;
use grazing_continuation::curve::{Curve, CurveEnd, CurvePoint, Event, Route, SolutionCurve, Window};
use grazing_continuation::locate::{Condition, LocateFailure, locate_within};
use grazing_continuation::mps::{EventTimes, LoopEquations, PeriodicSolution, Unknowns, parameters, unknown};
use grazing_input::OwnCurve;
use grazing_results::plane::Property;

use crate::curves::route;
use crate::parallel;
use crate::progress::Progress;
use crate::slices::{CARRIED_OFF, Slicer};

/// Impacts slower than this are not searched (empirical: multipliers grow like 1/y towards
/// grazing).
const BESIDE_GRAZING: f64 = 1e-4;

/// A curve that was requested.
#[derive(Clone, Debug)]
pub struct FoundCurve {
    /// The index of the request in the list.
    pub request: usize,
    /// Number of loops p.
    pub loops: u32,
    /// The curve.
    pub curve: Curve,
}

/// A point on a requested curve that was not located.
#[derive(Clone, Debug, PartialEq)]
pub struct LostPoint {
    /// The index of the request in the list.
    pub request: usize,
    /// Number of loops p.
    pub loops: u32,
    /// The approximate parameters (μ, η).
    pub near: [f64; 2],
    /// The reason.
    pub reason: LocateFailure,
}

/// The requested curves that were found.
#[derive(Clone, Debug, Default)]
pub struct FoundCurves {
    /// The curves.
    pub curves: Vec<FoundCurve>,
    /// The points that were not located.
    pub lost: Vec<LostPoint>,
}

impl FoundCurves {
    /// Adds what else was found.
    pub(crate) fn extend(&mut self, more: Self) {
        self.curves.extend(more.curves);
        self.lost.extend(more.lost);
    }
}

/// A crossing: between two points of a curve its solutions have the property.
struct Crossing<'a> {
    along: Condition,
    condition: Condition,
    near: Unknowns,
    length: f64,
    times: &'a EventTimes,
}

/// The conditions under which solutions near this one may have a property.
fn conditions(property: Property, equations: &LoopEquations, about: &PeriodicSolution) -> Vec<Condition> {
    match property {
        Property::ImpactVelocity(velocity) => vec![Condition::ImpactVelocity(velocity)],
        Property::Modulus(modulus) => vec![
            Condition::Multiplier(modulus),
            Condition::Multiplier(-modulus),
            Condition::Product(modulus * modulus),
        ],
        Property::Distance { phase, distance } => {
            let recoil = equations.departure(&about.unknowns).phase;
            let before = phase + TAU * libm::floor((recoil - phase) / TAU);
            let turns = (0..=equations.loops() + 1).map(|turn| before + TAU * f64::from(turn));
            turns.map(|phase| Condition::Position { phase, position: -distance }).collect()
        }
    }
}

/// The margin by which a solution has a property under a condition: negative where another
/// multiplier is larger, or multipliers are real.
fn margin(property: Property, condition: Condition, solution: &PeriodicSolution) -> f64 {
    let multipliers = &solution.multipliers;
    match (property, condition) {
        (Property::Modulus(modulus), Condition::Product(_)) => 2.0 * modulus - multipliers.trace.abs(),
        (Property::Modulus(modulus), _) => modulus * modulus - multipliers.determinant.abs(),
        _ => f64::INFINITY,
    }
}

/// The condition that also holds where the margin vanishes.
fn corner(property: Property, condition: Condition, solution: &PeriodicSolution) -> Option<Condition> {
    let Property::Modulus(modulus) = property else { return None };
    let multipliers = &solution.multipliers;
    Some(match condition {
        Condition::Product(_) => Condition::Multiplier(modulus.copysign(multipliers.trace)),
        _ => Condition::Product((modulus * modulus).copysign(multipliers.determinant)),
    })
}

/// The function that vanishes where a condition holds.
fn excess(equations: &LoopEquations, condition: Condition, solution: &PeriodicSolution) -> f64 {
    let (point, multipliers) = (&solution.unknowns, &solution.multipliers);
    match condition {
        Condition::ImpactVelocity(velocity) => point[unknown::VELOCITY] - velocity,
        Condition::Multiplier(multiplier) => {
            multiplier * (multiplier - multipliers.trace) + multipliers.determinant
        }
        Condition::Product(product) => multipliers.determinant - product,
        Condition::Position { phase, position } => {
            let recoil = equations.departure(point).phase;
            let impact = point[unknown::PHASE] + TAU * f64::from(equations.loops());
            // At the beginning and the end of the flight the position is that of the wall.
            let flies = (recoil..impact).contains(&phase);
            if flies { equations.position_at(point, phase).0 - position } else { -position }
        }
        _ => f64::NAN,
    }
}

/// Whether both conditions belong to pieces of one kind.
fn alike(one: Condition, other: Condition) -> bool {
    match (one, other) {
        (Condition::Multiplier(one), Condition::Multiplier(other)) => one == other,
        _ => discriminant(&one) == discriminant(&other),
    }
}

/// The curves of a request among the solutions of a slicer, found from the curves that cross them.
pub(crate) fn find(
    slicer: &Slicer,
    sources: &[&Curve],
    route: &Route<'_>,
    (number, request): (usize, &OwnCurve),
    progress: &dyn Progress,
) -> FoundCurves {
    let (equations, property) = (&slicer.equations, request.property);
    let crossings: Vec<Vec<Crossing<'_>>> =
        parallel::map(sources, |source| crossed(equations, source, property));
    let mut found = FoundCurves::default();
    let loops = equations.loops();
    for Crossing { along, condition, near, length, times } in crossings.into_iter().flatten() {
        if progress.stopped() {
            break;
        }
        if is_known(&found.curves, slicer, condition, &near) {
            continue;
        }
        let mut times = times.clone();
        match locate_within(length, equations, [condition, along], near.clone(), &mut times) {
            Ok(start) if margin(property, condition, &equations.solution(&start)) >= 0.0 => {
                let begun = (condition, start, times);
                let curves = followed(slicer, route, property, begun, &found.curves);
                found.curves.extend(curves.into_iter().map(|curve| FoundCurve {
                    request: number,
                    loops,
                    curve,
                }));
            }
            Ok(_) => {}
            Err(reason) => {
                found.lost.push(LostPoint { request: number, loops, near: parameters(&near), reason });
            }
        }
    }
    // Points that other crossings have reached are not missing.
    let FoundCurves { curves, lost } = &mut found;
    lost.retain(|lost| !curves.iter().any(|known| passes_near(&known.curve, lost.near, slicer)));
    found
}

/// The curve in a window through a solution of these equations, on which the property has its value
/// at the solution, in pieces.
pub fn through(
    equations: &LoopEquations,
    window: Window,
    (start, times): (Unknowns, EventTimes),
    property: Property,
) -> Vec<Curve> {
    let slicer = Slicer::new(equations.clone(), window, StepControl::DRAWING);
    let route = Route { stop_at_events: false, ..route(window, StepControl::DRAWING) };
    let conditions = conditions(property, equations, &equations.solution(&start));
    let begun = conditions.into_iter().map(|condition| (condition, start.clone(), times.clone()));
    begun.flat_map(|begun| followed(&slicer, &route, property, begun, &[])).collect()
}

/// Whether a solution lies on a known piece.
fn is_known(known: &[FoundCurve], slicer: &Slicer, condition: Condition, at: &Unknowns) -> bool {
    let mut same = known.iter().filter(|known| alike(known.curve.condition, condition));
    same.any(|known| slicer.passes(&known.curve, at))
}

/// The curve through a solution, and the pieces that begin where it ends, without those that are
/// known.
fn followed(
    slicer: &Slicer,
    route: &Route<'_>,
    property: Property,
    begun: (Condition, Unknowns, EventTimes),
    known: &[FoundCurve],
) -> Vec<Curve> {
    let equations = &slicer.equations;
    let (mut begun, mut all) = (vec![begun], Vec::<Curve>::new());
    while let Some((condition, start, times)) = begun.pop() {
        let mut new = all.iter().filter(|curve| alike(curve.condition, condition));
        if new.any(|curve| slicer.passes(curve, &start)) || is_known(known, slicer, condition, &start) {
            continue;
        }
        let curve = SolutionCurve { equations: equations.clone(), condition };
        let follow = |unknown| {
            let way = start.along(unknown);
            curve.clone().follow_both_ways(start.clone(), way, &times, route).ok()
        };
        let whole = follow(unknown::SECONDARY).or_else(|| follow(unknown::PRIMARY));
        for part in whole.into_iter().flat_map(|whole| parts(equations, property, with_events(whole))) {
            for end in [part.beginning.as_ref(), Some(&part.end)] {
                if let Some(CurveEnd::Event(corner)) = end {
                    begun.push((corner.condition, corner.solution.unknowns.clone(), corner.times.clone()));
                }
            }
            all.push(part);
        }
    }
    all
}

/// The points between which a curve has a property.
fn crossed<'a>(equations: &LoopEquations, source: &'a Curve, property: Property) -> Vec<Crossing<'a>> {
    let mut crossings = Vec::new();
    for pair in source.points.windows(2) {
        let ends =
            [[0, 1], [1, 0]].map(|[k, other]| off_grazing(equations, source, [&pair[k], &pair[other]]));
        let [Some(from), Some(to)] = &ends else { continue };
        for condition in conditions(property, equations, from) {
            let [before, after] = [from, to].map(|solution| excess(equations, condition, solution));
            if before * after > 0.0 || !(before - after).is_normal() {
                continue;
            }
            let chord = &to.unknowns - &from.unknowns;
            crossings.push(Crossing {
                along: source.condition,
                condition,
                near: &from.unknowns + &chord * (before / (before - after)),
                length: chord.norm(),
                times: &pair[0].times,
            });
        }
    }
    crossings
}

/// The solution at a point of a curve or, if that has no impact velocity and so no multipliers, one
/// close to it on the way to the next.
fn off_grazing(
    equations: &LoopEquations,
    along: &Curve,
    [at, next]: [&CurvePoint; 2],
) -> Option<PeriodicSolution> {
    if at.solution.impact_velocity() > 0.0 {
        return Some(at.solution.clone());
    }
    let chord = &next.solution.unknowns - &at.solution.unknowns;
    let near = &at.solution.unknowns + &chord * (BESIDE_GRAZING / chord[unknown::VELOCITY]);
    let conditions = [along.condition, Condition::ImpactVelocity(BESIDE_GRAZING)];
    let beside = locate_within(chord.norm(), equations, conditions, near, &mut next.times.clone());
    beside.ok().map(|beside| equations.solution(&beside))
}

/// The curve with its events inserted among its points.
fn with_events(mut curve: Curve) -> Curve {
    for Event { solution, index, times, .. } in curve.events.drain(..).rev() {
        curve.points.insert(index.min(curve.points.len()), CurvePoint { solution, times });
    }
    curve
}

/// The parts of a curve on which its solutions have the property, each up to its end.
fn parts(equations: &LoopEquations, property: Property, whole: Curve) -> Vec<Curve> {
    let condition = whole.condition;
    let inside = |point: &CurvePoint| margin(property, condition, &point.solution) >= 0.0;
    let Curve { points, end, beginning, .. } = whole;
    let begin = |beginning| Curve {
        condition,
        points: Vec::new(),
        events: Vec::new(),
        end: CurveEnd::StepLimit,
        beginning,
    };
    let mut parts: Vec<Curve> = Vec::new();
    let mut part: Option<Curve> = None;
    for (k, point) in points.iter().enumerate() {
        let corner = points[..k].last().filter(|before| inside(before) != inside(point));
        let corner =
            corner.and_then(|before| corner_between(equations, property, condition, [before, point]));
        if inside(point) {
            let part = part.get_or_insert_with(|| begin(if k == 0 { beginning.clone() } else { None }));
            if let Some((place, end)) = corner {
                part.points.extend(place);
                part.beginning = Some(end);
            }
            part.points.push(point.clone());
        } else if let Some(mut part) = part.take() {
            if let Some((place, end)) = corner {
                part.points.extend(place);
                part.end = end;
            }
            parts.push(part);
        }
    }
    parts.extend(part.map(|part| Curve { end, ..part }));
    parts.retain(|part| part.points.len() > 1);
    parts
}

/// The corner between two points of a curve of which one has the property, and the event there;
/// `None` where it was not located.
fn corner_between(
    equations: &LoopEquations,
    property: Property,
    condition: Condition,
    [before, after]: [&CurvePoint; 2],
) -> Option<(Option<CurvePoint>, CurveEnd)> {
    let other = corner(property, condition, &before.solution)?;
    let [from, to] = [before, after].map(|point| margin(property, condition, &point.solution));
    let chord = &after.solution.unknowns - &before.solution.unknowns;
    let near = &before.solution.unknowns + chord * (from / (from - to));
    let mut times = before.times.clone();
    Some(match locate_within(CARRIED_OFF, equations, [condition, other], near, &mut times) {
        Ok(corner) => {
            let solution = equations.solution(&corner);
            let event =
                Event { condition: other, solution: solution.clone(), index: 0, times: times.clone() };
            (Some(CurvePoint { solution, times }), CurveEnd::Event(Box::new(event)))
        }
        Err(failure) => (None, CurveEnd::EventNotLocated { condition: other, failure }),
    })
}

/// Whether a curve passes a place within the accuracy of drawing.
fn passes_near(curve: &Curve, place: [f64; 2], slicer: &Slicer) -> bool {
    /// The distance as a fraction of the ranges.
    const NEAR: f64 = 1e-2;
    let [x, y] = slicer.window.shares(place);
    curve.parameters().iter().any(|at| {
        let [to_x, to_y] = slicer.window.shares(*at);
        libm::hypot(to_x - x, to_y - y) < NEAR
    })
}
