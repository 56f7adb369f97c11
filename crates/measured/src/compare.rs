//! Comparison of measurements with the regions and curves of a diagram.

use std::collections::BTreeMap;

use grazing_continuation::mps::unknown;
use grazing_model::ImpactOscillator;
use grazing_model::smooth::Stop;
use grazing_results::brief;
use grazing_results::measured::{Agreement, Comparison, MeasuredCount, MeasuredPoint};
use grazing_results::place::{briefly, struck};
use grazing_unfold::described::Axes;
use grazing_unfold::long_time::{Fate, MotionKind};
use grazing_unfold::place::{Place, Starts};
use grazing_unfold::plane::counts;
use grazing_unfold::progress::Progress;
use grazing_unfold::regions::Region;
use grazing_unfold::sequences::Sequence;
use grazing_unfold::{Diagram, Scope};

use crate::associate::{KnownCurves, Metric, curves, nearest};
use crate::read::{Behaviour, Observation};

/// Standard errors within which measurements agree: about 95 of 100 lie there.
const WITHIN: f64 = 2.0;
/// Number of random initial states of simulations where the regions do not answer. Motion that does not
/// settle takes a long time.
const STATES: u32 = 8;
/// Directions in which places within two standard errors are tried; [`SHARES`] are the fractions of that
/// distance.
const AROUND: [[f64; 2]; 8] = {
    const DIAGONAL: f64 = core::f64::consts::FRAC_1_SQRT_2;
    [
        [1.0, 0.0],
        [-1.0, 0.0],
        [0.0, 1.0],
        [0.0, -1.0],
        [DIAGONAL, DIAGONAL],
        [-DIAGONAL, DIAGONAL],
        [DIAGONAL, -DIAGONAL],
        [-DIAGONAL, -DIAGONAL],
    ]
};
const SHARES: [f64; 4] = [0.25, 0.5, 0.75, 1.0];

/// The reason given where simulation was stopped early.
pub const NOT_FINISHED: &str = "not finished";

/// The result of comparing a measurement, and the reason for it.
type Verdict = (Agreement, String);

/// The name of the stage.
const STAGE: &str = "comparison with measurements";

/// Compares all measurements with a diagram, as the first wall sees it and as the other of two does, and with
/// regions of solutions with several impacts, if any are known; `stop` ends simulation, and the remaining
/// measurements are undecided.
pub fn compare(
    observations: &[Observation],
    axes: &Axes,
    (diagram, other, several): KnownCurves<'_>,
    progress: &dyn Progress,
    stop: &Stop,
) -> Comparison {
    let beside = Beside { axes, diagram, other, several, stop };
    let point = |one: &Observation| {
        let point = beside.point(one);
        progress.step(STAGE);
        point
    };
    let points: Vec<MeasuredPoint> =
        progress.during(STAGE, observations.len() as u64, || observations.iter().map(point).collect());
    let mut counts: BTreeMap<(u32, String, u32), MeasuredCount> = BTreeMap::new();
    for (row, one) in points.iter().zip(observations) {
        for key in beside.counted_in(one) {
            let (region, kind, loops) = key.clone();
            let none = MeasuredCount {
                region,
                kind,
                loops,
                points: 0,
                agree: 0,
                within_error: 0,
                disagree: 0,
                undecided: 0,
                silent: 0,
            };
            counts.entry(key).or_insert(none).count(row.agreement);
        }
    }
    Comparison { points, counts: counts.into_values().collect() }
}

/// Comparison of another program's curves of one kind with those of a diagram.
#[derive(Clone, Debug, PartialEq)]
pub struct Apart {
    /// The kind of the curves.
    pub curve: Behaviour,
    /// The number of points within the ranges.
    pub points: u32,
    /// The number of points outside the ranges, which are not compared.
    pub outside: u32,
    /// The number of points that are too far from every curve of this kind.
    pub far: u32,
    /// The greatest distance of a point from the nearest curve of this kind, as a fraction of the ranges,
    /// and the line of the point; infinite if there is no such curve.
    pub farthest: (f64, u32),
}

/// Compares the points of another program's curves with the admissible parts of the curves of a diagram,
/// kind by kind; `within` is the greatest distance that counts as near, as a fraction of the ranges.
pub fn apart(points: &[Observation], axes: &Axes, known: KnownCurves<'_>, within: f64) -> Vec<Apart> {
    let window = &known.0.scope.window;
    let mut all: BTreeMap<String, Apart> = BTreeMap::new();
    for &Observation { line, at, seen, .. } in points {
        let Behaviour::Bifurcation { kind, loops, walls } = seen else { continue };
        let none = Apart { curve: seen, points: 0, outside: 0, far: 0, farthest: (0.0, line) };
        let of = all.entry(seen.words()).or_insert(none);
        let at = axes.units.without_dimensions(at);
        if !window.contains(at) {
            of.outside += 1;
            continue;
        }
        let near = nearest(curves(known, (kind, loops, walls)), at, &Metric::new([0.0; 2], window));
        let distance = near.map_or(f64::INFINITY, |near| near.distance);
        of.points += 1;
        of.far += u32::from(distance > within);
        if distance > of.farthest.0 {
            of.farthest = (distance, line);
        }
    }
    all.into_values().collect()
}

struct Beside<'a> {
    axes: &'a Axes,
    diagram: &'a Diagram,
    other: Option<&'a Diagram>,
    several: &'a [Sequence],
    stop: &'a Stop,
}

impl Beside<'_> {
    /// The regions that contain a place, with their numbers. Motion without impacts is the same to both walls.
    fn regions(&self, at: [f64; 2]) -> impl Iterator<Item = (u32, &Region)> {
        let others = self.other.iter().flat_map(|other| &other.regions);
        let all = self.diagram.regions.iter().map(|region| (region, true));
        let all = all.chain(others.map(|region| (region, counts(region.loops, 2))));
        let numbered = (1..).zip(all).filter(|(_, (_, counts))| *counts);
        numbered.map(|(number, (region, _))| (number, region)).filter(move |(_, region)| region.contains(at))
    }

    /// The solutions with several impacts that are stable at a place, as far as their regions are known.
    fn several(&self, at: [f64; 2]) -> impl Iterator<Item = &Sequence> {
        let holds = move |region: &Region| region.doubt.is_none() && region.contains(at);
        self.several.iter().filter(move |found| found.regions.iter().any(holds))
    }

    /// The groups in which a measurement is counted: region, kind and number of loops.
    fn counted_in(&self, one: &Observation) -> Vec<(u32, String, u32)> {
        if let Behaviour::Bifurcation { kind, loops, .. } = one.seen {
            return vec![(0, kind.name().to_owned(), loops.unwrap_or(0))];
        }
        let at = self.axes.units.without_dimensions(one.at);
        let named =
            |(number, region): (u32, &Region)| (number, region.kind().name().to_owned(), region.loops);
        let held: Vec<_> = self.regions(at).map(named).collect();
        if held.is_empty() { vec![(0, "none".to_owned(), 0)] } else { held }
    }

    fn point(&self, one: &Observation) -> MeasuredPoint {
        let at = self.axes.units.without_dimensions(one.at);
        let inside = self.diagram.scope.window.contains(at);
        let mut distance = f64::NAN;
        let (agreement, reason) = match one.seen {
            _ if !inside => (Agreement::Silent, "it lies outside the ranges".to_owned()),
            Behaviour::Bifurcation { .. } => self.bifurcation(one, at, &mut distance),
            Behaviour::Periodic { periods: 1, impacts: 0 } => self.motion(one, at, 0),
            Behaviour::Periodic { periods, impacts: 1 } if self.diagram.scope.loops.contains(&periods) => {
                self.motion(one, at, periods)
            }
            // Where no region of several impacts holds, there may be one that is not known.
            Behaviour::Periodic { periods, impacts }
                if self.several(at).any(|it| (it.impacts as u32, it.periods) == (impacts, periods)) =>
            {
                (Agreement::Agrees, String::new())
            }
            _ => self.simulated(one.seen, at),
        };
        let decided = self.regions(at).filter(|(_, region)| region.doubt.is_none()).map(stable);
        let several = self.several(at).map(|found| briefly([found.impacts as u32, found.periods]));
        let stable: Vec<String> = decided.chain(several).collect();
        let theory = match stable.as_slice() {
            _ if !inside => String::new(),
            [] => "no solution of these p".to_owned(),
            stable => stable.join("; "),
        };
        let regions = self.regions(at).map(|(number, _)| number.to_string()).collect::<Vec<_>>().join(" ");
        let stated = |error: f64| if error > 0.0 { error } else { f64::NAN };
        MeasuredPoint {
            line: one.line,
            secondary: one.at[1],
            secondary_error: stated(one.errors[1]),
            primary: one.at[0],
            primary_error: stated(one.errors[0]),
            kind: one.seen.kind(),
            seen: one.seen.words(),
            agreement,
            theory,
            regions,
            distance,
            reason,
        }
    }

    /// The verdict of the regions at a place on motion with p loops.
    fn at(&self, at: [f64; 2], loops: u32) -> Verdict {
        let mut undecided = None;
        for (_, region) in self.regions(at).filter(|(_, region)| region.loops == loops) {
            match &region.doubt {
                None => return (Agreement::Agrees, String::new()),
                Some(doubt) => undecided = Some(doubt.to_string()),
            }
        }
        match undecided {
            Some(doubt) => (Agreement::Undecided, doubt),
            None if loops == 0 => (
                Agreement::Disagrees,
                "motion without impacts is not stable there, or hits the wall".to_owned(),
            ),
            None => {
                (Agreement::Disagrees, format!("no solution of p = {loops} is stable and admissible there"))
            }
        }
    }

    fn motion(&self, one: &Observation, at: [f64; 2], loops: u32) -> Verdict {
        let here = self.at(at, loops);
        let errors = self.axes.units.without_dimensions(one.errors);
        if here.0 == Agreement::Agrees || errors == [0.0; 2] {
            return here;
        }
        let around =
            AROUND.into_iter().flat_map(|way| SHARES.map(|share| way.map(|part| WITHIN * share * part)));
        let places = around.map(|step| [0, 1].map(|k| at[k] + step[k] * errors[k]));
        let near = places.filter(|place| self.diagram.scope.window.contains(*place));
        match near.map(|place| self.at(place, loops)).find(|(there, _)| *there == Agreement::Agrees) {
            Some(_) => (Agreement::WithinError, here.1),
            None => here,
        }
    }

    fn bifurcation(&self, one: &Observation, at: [f64; 2], distance: &mut f64) -> Verdict {
        let Behaviour::Bifurcation { kind, loops, walls } = one.seen else {
            return (Agreement::Silent, String::new());
        };
        let metric = Metric::new(self.axes.units.without_dimensions(one.errors), &self.diagram.scope.window);
        let curves = curves((self.diagram, self.other, self.several), (kind, loops, walls));
        let Some(near) = nearest(curves, at, &metric) else {
            let asked = loops.is_none_or(|loops| loops == 0 || self.diagram.scope.loops.contains(&loops));
            let verdict = if asked { Agreement::Disagrees } else { Agreement::Silent };
            return (verdict, format!("there is no curve of {}", one.seen.words()));
        };
        let place = [near.unknowns[unknown::PRIMARY], near.unknowns[unknown::SECONDARY]];
        let [primary, secondary] = self.axes.units.parameters(place).map(|value| brief(value, 6));
        let names = &self.axes.names;
        let where_ = format!(
            "the nearest point of the curve is {} = {primary}, {} = {secondary}",
            names.primary, names.secondary
        );
        if !metric.stated {
            return (Agreement::Undecided, format!("the measurement states no error; {where_}"));
        }
        *distance = near.distance;
        let agrees = near.distance <= WITHIN;
        (if agrees { Agreement::Agrees } else { Agreement::Disagrees }, where_)
    }

    /// The verdict of simulation on motion that the regions do not cover.
    fn simulated(&self, seen: Behaviour, at: [f64; 2]) -> Verdict {
        let starts = Starts { states: STATES, ..Starts::default() };
        let here = self.diagram.oscillator.with_parameters(at);
        let no_loops = Scope { loops: Vec::new(), ..self.diagram.scope.clone() };
        let Some(found) = Place::compute(&here, &no_loops, &starts, self.stop) else {
            return (Agreement::Undecided, NOT_FINISHED.to_owned());
        };
        let total: u32 = found.attractors.iter().map(|attractor| attractor.states).sum();
        let like = found.attractors.iter().filter(|attractor| is_seen(&attractor.fate, seen));
        match like.map(|attractor| attractor.states).sum::<u32>() {
            0 => {
                let kinds: Vec<String> =
                    found.attractors.iter().map(|attractor| words(&attractor.fate)).collect();
                let all = kinds.join("; ");
                (
                    Agreement::Undecided,
                    format!("the regions do not decide; {total} simulated states reach: {all}"),
                )
            }
            states => (Agreement::Agrees, format!("by simulation: {states} of {total} states reach it")),
        }
    }
}

/// The solution that is stable in a region, in words.
fn stable((_, region): (u32, &Region)) -> String {
    if region.loops == 0 { "no impacts".to_owned() } else { format!("p = {}", region.loops) }
}

/// The forcing periods in the period of an attractor, and the impacts in them, ∞ where they accumulate;
/// none unless it is periodic.
fn impacts(fate: &Fate) -> Option<(u32, f64)> {
    fate.periods.map(|periods| (periods, fate.impacts * f64::from(periods)))
}

/// Whether an attractor matches the measured behaviour.
fn is_seen(fate: &Fate, seen: Behaviour) -> bool {
    match seen {
        Behaviour::Periodic { periods, impacts: count } => impacts(fate)
            .is_some_and(|(own, impacts)| own == periods && (impacts - f64::from(count)).abs() < 0.5),
        Behaviour::Irregular => fate.kind == MotionKind::Chaotic,
        Behaviour::Bifurcation { .. } => false,
    }
}

/// An attractor in words.
fn words(fate: &Fate) -> String {
    match impacts(fate) {
        Some((periods, _)) if fate.rests > 0.0 => struck(f64::from(periods), [fate.impacts, fate.rests]),
        Some((periods, impacts)) => format!("{impacts:.0} impacts in {periods} periods"),
        None => fate.kind.name().to_owned(),
    }
}
