//! Measured bifurcations, and the curves that they lie on.

use grazing_continuation::bifurcation::Bifurcation;
use grazing_continuation::curve::Window;
use grazing_continuation::locate::Condition;
use grazing_continuation::mps::{EventTimes, PeriodicSolution, Unknowns, unknown};
use grazing_model::ImpactOscillator;
use grazing_model::smooth::Units;
use grazing_unfold::Diagram;

use crate::read::{Observation, Seen};

/// A parameter that is known far better than the other counts with an error of this share of its
/// range where none is stated.
const EXACT: f64 = 1e-6;

/// What differences from a place of the plane are counted in: standard errors, or, where none is
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

    /// A difference in these.
    pub(crate) fn counted(&self, from: [f64; 2], to: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|k| (to[k] - from[k]) / self.scales[k])
    }
}

/// The place of a curve that is nearest to another one.
#[derive(Clone, Debug)]
pub(crate) struct Nearest {
    pub(crate) distance: f64,
    pub(crate) unknowns: Unknowns,
    loops: u32,
    times: EventTimes,
    /// The direction of the curve, of length one.
    along: Unknowns,
}

/// A measured bifurcation on the curve that it is taken to lie on.
#[derive(Clone, Debug)]
pub struct Located {
    /// The line of the file.
    pub line: u32,
    /// What it is.
    pub quantity: String,
    /// What holds on the curve, and for how many loops.
    pub(crate) condition: Condition,
    pub(crate) loops: u32,
    /// A point of the curve nearby, with its direction and what is carried there.
    pub(crate) near: [Unknowns; 2],
    pub(crate) times: EventTimes,
    /// Where it was measured, without dimensions.
    pub(crate) at: [f64; 2],
    pub(crate) metric: Metric,
}

/// A point of a curve: the unknowns, what is carried there, and whether the solution is admissible.
type Point<'a> = (Unknowns, Option<&'a EventTimes>, bool);

/// The curves of a kind, by their numbers of loops.
fn curves(diagram: &Diagram, kind: Bifurcation, loops: Option<u32>) -> Vec<(u32, Vec<Point<'_>>)> {
    if kind == Bifurcation::NonImpactingGrazing {
        let curve = |curve: &grazing_unfold::grazing::GrazingCurve| {
            let points = curve.states.iter().map(|state| {
                let [primary, secondary] = state.orbit.oscillator().parameters();
                (Unknowns::new(0.0, state.orbit.phase(), primary, secondary), None, state.admissible)
            });
            (1, points.collect())
        };
        return diagram.grazing.iter().map(curve).collect();
    }
    let wanted = diagram.curves.iter();
    let wanted = wanted.filter(|curve| curve.kind == kind && loops.is_none_or(|loops| loops == curve.loops));
    let all = wanted.map(|curve| {
        let points = curve.curve.points.iter().map(|point| {
            let admissible = point.solution.ceiling() <= PeriodicSolution::TOUCH;
            (point.solution.unknowns, Some(&point.times), admissible)
        });
        (curve.loops, points.collect())
    });
    all.collect()
}

/// The place nearest to one, of what is admissible on the curves of a kind.
pub(crate) fn nearest(
    diagram: &Diagram,
    (kind, loops): (Bifurcation, Option<u32>),
    at: [f64; 2],
    metric: &Metric,
) -> Option<Nearest> {
    let place = |point: &Unknowns| [point[unknown::PRIMARY], point[unknown::SECONDARY]];
    let mut best: Option<Nearest> = None;
    for (loops, points) in curves(diagram, kind, loops) {
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
                let (unknowns, times) = (pair[0].0 + (pair[1].0 - pair[0].0) * share, pair[0].1);
                let times = times.cloned().unwrap_or_default();
                let along = (pair[1].0 - pair[0].0).normalize();
                best = Some(Nearest { distance, unknowns, loops, times, along });
            }
        }
    }
    best
}

/// The bifurcations among measurements, each on the nearest curve of its kind.
///
/// # Errors
/// The line and the words of one to which there is no curve.
pub fn associate(
    observations: &[Observation],
    diagram: &Diagram,
    units: &Units,
) -> Result<Vec<Located>, (u32, String)> {
    let mut all = Vec::new();
    for Observation { line, at, errors, seen } in observations {
        let Seen::Bifurcation { kind, loops } = *seen else { continue };
        let [at, errors] = [at, errors].map(|place| units.without_dimensions(*place));
        let metric = Metric::new(errors, &diagram.scope.window);
        let near = nearest(diagram, (kind, loops), at, &metric).ok_or_else(|| (*line, seen.words()))?;
        let condition = match kind {
            Bifurcation::NonImpactingGrazing => Condition::ImpactVelocity(0.0),
            other => other.condition(),
        };
        all.push(Located {
            line: *line,
            quantity: seen.words(),
            condition,
            loops: near.loops,
            near: [near.unknowns, near.along],
            times: near.times,
            at,
            metric,
        });
    }
    Ok(all)
}
