//! Measured bifurcations, each associated with the curve that it lies on.

use grazing_continuation::bifurcation::Bifurcation;
use grazing_continuation::curve::Window;
use grazing_continuation::locate::Condition;
use grazing_continuation::mps::{EventTimes, PeriodicSolution, Unknowns, unknown};
use grazing_model::ImpactOscillator;
use grazing_model::smooth::Units;
use grazing_unfold::Diagram;
use grazing_unfold::diagram::DiagramCurve;
use grazing_unfold::sequences::Sequence;

use crate::read::{Behaviour, MeasuredWalls, Observation};

/// The assumed standard error, as a fraction of its range, of a parameter without a stated error when the
/// other one has one: it is known far better.
const EXACT: f64 = 1e-6;

/// The units in which differences in the parameter plane are measured: standard errors or, if none is
/// stated, the ranges.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Metric {
    pub(crate) scales: [f64; 2],
    /// Whether any error is stated.
    pub(crate) stated: bool,
}

impl Metric {
    pub(crate) fn new(errors: [f64; 2], window: &Window) -> Self {
        let (widths, stated) = (window.widths(), errors != [0.0; 2]);
        let scale = |k: usize| match (errors[k] > 0.0, stated) {
            (true, _) => errors[k],
            (false, true) => EXACT * widths[k],
            (false, false) => widths[k],
        };
        Self { scales: [0, 1].map(scale), stated }
    }

    /// A difference between two places in these units.
    pub(crate) fn counted(&self, from: [f64; 2], to: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|k| (to[k] - from[k]) / self.scales[k])
    }
}

/// The point of a curve that is nearest to a given place.
#[derive(Clone, Debug)]
pub(crate) struct Nearest {
    pub(crate) distance: f64,
    pub(crate) unknowns: Unknowns,
    of: Solutions,
    times: EventTimes,
    /// The unit direction of the curve.
    along: Unknowns,
}

/// A measured bifurcation on the curve with which it is associated.
#[derive(Clone, Debug)]
pub struct Located {
    /// The line of the file.
    pub line: u32,
    /// The kind of bifurcation, in words.
    pub quantity: String,
    /// The solutions of which the curve is.
    pub(crate) of: Solutions,
    /// A point of the curve nearby and the direction of the curve there; `times` are its event times.
    pub(crate) near: [Unknowns; 2],
    pub(crate) times: EventTimes,
    /// The measured place, dimensionless.
    pub(crate) at: [f64; 2],
    pub(crate) metric: Metric,
}

/// A point of a curve: the unknowns, its event times, and whether the solution is admissible.
type Point<'a> = (Unknowns, Option<&'a EventTimes>, bool);

/// Solutions that satisfy a condition: those along a curve.
#[derive(Clone, Debug)]
pub(crate) struct Solutions {
    pub(crate) condition: Condition,
    /// The number of loops, or of forcing periods; 0 without impacts.
    pub(crate) loops: u32,
    /// The stops that impacts hit, in their order, over and over; none if all are at the first.
    pub(crate) stops: Vec<usize>,
}

/// A curve of solutions.
type Points<'a> = (Solutions, Vec<Point<'a>>);

/// The curves that are known: those of a diagram as the first wall sees it and as the other of two does, and those of
/// solutions with several impacts, as far as these are known.
pub type KnownCurves<'a> = (&'a Diagram, Option<&'a Diagram>, &'a [Sequence]);

/// What is sought among known curves: their kind, the number of loops if it is given, and the walls.
pub(crate) type Sought = (Bifurcation, Option<u32>, MeasuredWalls);

/// The curves of solutions that hit both of two walls, of a kind and with a number of forcing periods; none of others.
fn at_both(found: &Sequence, sought: Sought) -> Vec<Points<'_>> {
    let both = found.hits_both();
    found.curves.iter().filter(|_| both).filter_map(|curve| points(curve, &found.stops, sought)).collect()
}

/// The points of a curve, if it is of this kind. Motion without impacts hits no wall of which anything could be said.
fn points<'a>(curve: &'a DiagramCurve, stops: &[usize], (kind, loops, walls): Sought) -> Option<Points<'a>> {
    let hits = curve.loops > 0 || walls == MeasuredWalls::Unsaid;
    (hits && curve.kind == kind && loops.is_none_or(|loops| loops == curve.loops)).then_some(())?;
    let points = curve.curve.points.iter().map(|point| {
        let admissible = point.solution.ceiling() <= PeriodicSolution::TOUCH;
        (point.solution.unknowns.clone(), Some(&point.times), admissible)
    });
    let stops = if curve.loops == 0 { Vec::new() } else { stops.to_vec() };
    Some((Solutions { condition: kind.condition(), loops: curve.loops, stops }, points.collect()))
}

/// The curves of a kind, as one wall sees it.
fn at_one(diagram: &Diagram, sought: Sought) -> Vec<Points<'_>> {
    let stops = if diagram.wall < 2 { Vec::new() } else { vec![1] };
    if sought.0 == Bifurcation::NonImpactingGrazing {
        let curve = |curve: &grazing_unfold::grazing::GrazingCurve| {
            let points = curve.states.iter().map(|state| {
                let [primary, secondary] = state.orbit.oscillator().parameters();
                (Unknowns::new(0.0, state.orbit.phase(), primary, secondary), None, state.admissible)
            });
            let condition = Condition::ImpactVelocity(0.0);
            (Solutions { condition, loops: 1, stops: stops.clone() }, points.collect())
        };
        return diagram.grazing.iter().map(curve).collect();
    }
    diagram.curves.iter().filter_map(|curve| points(curve, &stops, sought)).collect()
}

/// The known curves of a kind. Motion without impacts is the same to both walls, and its curves are those of the first.
pub(crate) fn curves<'a>((first, other, several): KnownCurves<'a>, sought: Sought) -> Vec<Points<'a>> {
    let (_, _, walls) = sought;
    let of_wall = |diagram: &&Diagram| walls.may_be(diagram.wall.max(1));
    let seen = Some(first).into_iter().filter(of_wall).flat_map(|diagram| at_one(diagram, sought));
    let others = other.into_iter().filter(of_wall).flat_map(|diagram| at_one(diagram, sought));
    let seen = seen.chain(others.filter(|(of, _)| of.loops > 0));
    let both = several.iter().filter(|_| walls.may_be_both()).flat_map(|found| at_both(found, sought));
    seen.chain(both).collect()
}

/// The point nearest to `at` on the admissible parts of curves.
pub(crate) fn nearest<'a>(
    curves: impl IntoIterator<Item = Points<'a>>,
    at: [f64; 2],
    metric: &Metric,
) -> Option<Nearest> {
    let place = |point: &Unknowns| [point[unknown::PRIMARY], point[unknown::SECONDARY]];
    let mut best: Option<Nearest> = None;
    for (of, points) in curves {
        for pair in points.windows(2).filter(|pair| pair[0].2 && pair[1].2) {
            let [from, to] = [0, 1].map(|k| metric.counted(at, place(&pair[k].0)));
            let chord = [to[0] - from[0], to[1] - from[1]];
            let square = chord[0] * chord[0] + chord[1] * chord[1];
            if square == 0.0 {
                continue;
            }
            let share = (-(from[0] * chord[0] + from[1] * chord[1]) / square).clamp(0.0, 1.0);
            let gap = [0, 1].map(|k| from[k] + share * chord[k]);
            let distance = (gap[0] * gap[0] + gap[1] * gap[1]).sqrt();
            if best.as_ref().is_none_or(|best| distance < best.distance) {
                let (unknowns, times) = (&pair[0].0 + (&pair[1].0 - &pair[0].0) * share, pair[0].1);
                let times = times.cloned().unwrap_or_default();
                let along = (&pair[1].0 - &pair[0].0).normalize();
                best = Some(Nearest { distance, unknowns, of: of.clone(), times, along });
            }
        }
    }
    best
}

/// Associates each measured bifurcation with the nearest curve of its kind.
///
/// # Errors
/// The line of the first bifurcation without such a curve, and a description of it.
pub fn associate(
    observations: &[Observation],
    known: KnownCurves<'_>,
    units: &Units,
) -> Result<Vec<Located>, (u32, String)> {
    let mut all = Vec::new();
    for Observation { line, at, errors, seen } in observations {
        let Behaviour::Bifurcation { kind, loops, walls } = *seen else { continue };
        let [at, errors] = [at, errors].map(|place| units.without_dimensions(*place));
        let metric = Metric::new(errors, &known.0.scope.window);
        let curves = curves(known, (kind, loops, walls));
        let near = nearest(curves, at, &metric).ok_or_else(|| (*line, seen.words()))?;
        all.push(Located {
            line: *line,
            quantity: seen.words(),
            of: near.of,
            near: [near.unknowns, near.along],
            times: near.times,
            at,
            metric,
        });
    }
    Ok(all)
}
