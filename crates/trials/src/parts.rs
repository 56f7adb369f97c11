//! Compares diagrams of parts of a window with the diagram of the whole: the results must not depend on
//! the window.

use core::fmt;

use grazing_continuation::curve::Window;
use grazing_unfold::progress::Silent;
use grazing_unfold::{Diagram, Scope};

use crate::lines::CHORD;
use crate::random::Random;
use crate::regions::{Shown, shown};

type Point = [f64; 2];

/// The least length of a missing piece of a curve, in units of the part; shorter pieces occur where
/// curves end or leave the part.
const LEAST_LENGTH: f64 = 0.02;
/// Strips of stable solutions between curves that are thinner than this fraction of the whole window's
/// ranges are not searched for in any window; they are known only where they continue to wider parts.
const SLIVER: f64 = 1e-4;
/// Points this close to an edge of the part, as a fraction of it, may lie outside.
const EDGE: f64 = 0.01;

/// The diagram that has something the other one lacks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Has {
    /// The diagram of the whole window.
    Whole,
    /// The diagram of the part.
    Part,
}

/// A difference between two diagrams.
#[derive(Clone, Debug, PartialEq)]
pub enum Difference {
    /// A point that is shaded in one diagram and white in the other.
    Verdict(Has, u32, Point),
    /// A piece of a curve, or a point, with its name, a place and its length in units of the part.
    Missing(Has, String, Point, f64),
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Verdict(has, loops, at) => write!(f, "p = {loops} at {at:?}: shaded in the {has:?} alone"),
            Self::Missing(has, name, at, length) => {
                write!(f, "{name} at {at:?}, length {length:.3}: in the {has:?} alone")
            }
        }
    }
}

/// The result of comparing one part.
#[derive(Clone, Debug, Default)]
pub struct PartComparison {
    /// The number of points at which both are shaded, or both white.
    pub agreed: usize,
    /// The fraction of the points that is hatched in the part and not in the whole, for any p, and the
    /// converse.
    pub hatched: [f64; 2],
    /// The length of the curves in the part that both diagrams have, in units of the part.
    pub common: f64,
    /// All differences.
    pub differences: Vec<Difference>,
}

/// The curves and special points of a diagram, each with its p and a name; points are curves of one
/// point.
fn marks(diagram: &Diagram) -> Vec<(u32, String, Vec<Point>)> {
    let curve = |curve: &grazing_unfold::diagram::DiagramCurve| {
        let name = format!("{:?} curve, p = {}", curve.kind, curve.loops);
        (curve.loops, name, curve.curve.parameters())
    };
    let grazing = |curve: &grazing_unfold::grazing::GrazingCurve| {
        (0, "grazing curve".to_owned(), curve.parameters().collect())
    };
    let resonance = |resonance: &grazing_unfold::resonances::FoundResonance| {
        let [.., primary, secondary]: [f64; 4] = resonance.located.unknowns().into();
        let name = format!("resonance, p = {}, n = {}", resonance.loops, resonance.n);
        (resonance.loops, name, vec![[primary, secondary]])
    };
    let point = |point: &grazing_unfold::diagram::CodimensionTwoPoint| {
        let [.., primary, secondary]: [f64; 4] = point.unknowns().into();
        let name = format!("{:?} point, p = {}", point.kind, point.loops);
        (point.loops, name, vec![[primary, secondary]])
    };
    let curves = diagram.curves.iter().map(curve).chain(diagram.grazing.iter().map(grazing));
    let points = diagram.resonances.iter().map(resonance).chain(diagram.codimension_two.iter().map(point));
    curves.chain(points).collect()
}

/// The distance of a point from a polyline, in units of a window.
fn distance(window: Window, at: Point, line: &[Point]) -> f64 {
    let place = |point: &Point| {
        let [a, b] = [window.shares(*point), window.shares(at)];
        [a[0] - b[0], a[1] - b[1]]
    };
    let to_chord = |pair: &[Point]| {
        let [a, b] = [place(&pair[0]), place(&pair[pair.len() - 1])];
        let [u, v] = [b[0] - a[0], b[1] - a[1]];
        let along = (-(a[0] * u + a[1] * v) / (u * u + v * v)).clamp(0.0, 1.0);
        let along = if along.is_nan() { 0.0 } else { along };
        libm::hypot(a[0] + along * u, a[1] + along * v)
    };
    line.windows(line.len().min(2)).map(to_chord).fold(f64::INFINITY, f64::min)
}

/// The length of the curves that both diagrams have in a part of the window, and the curves and points of
/// one diagram that the other lacks.
fn lacking(
    whole: Window,
    part: Window,
    has: Has,
    one: &Diagram,
    other: Option<&Diagram>,
) -> (f64, Vec<Difference>) {
    let others = other.map(marks).unwrap_or_default();
    let inside = |at: &Point| part.shares(*at).iter().all(|share| (EDGE..1.0 - EDGE).contains(share));
    let (mut common, mut missing) = (0.0, Vec::new());
    let own = marks(one);
    for (loops, name, line) in &own {
        let same: Vec<&Vec<Point>> =
            others.iter().filter(|(_, other, _)| other == name).map(|(.., line)| line).collect();
        let is_known = |at: Point| same.iter().any(|line| distance(whole, at, line) < CHORD);
        let on_a_sliver = |at: Point| {
            let beside = own.iter().filter(|(p, other, line)| p == loops && other != name && line.len() > 1);
            beside.into_iter().any(|(.., line)| distance(whole, at, line) < SLIVER)
        };
        let (mut length, mut first) = (0.0, None);
        for pair in line.windows(2).filter(|pair| pair.iter().all(inside)) {
            let [a, b] = [part.shares(pair[0]), part.shares(pair[1])];
            let middle = [0, 1].map(|k| 0.5 * (pair[0][k] + pair[1][k]));
            let step = libm::hypot(b[0] - a[0], b[1] - a[1]);
            if is_known(middle) {
                common += step;
            } else if !on_a_sliver(middle) {
                length += step;
                first.get_or_insert(middle);
            }
        }
        let point = line.first().filter(|at| line.len() == 1 && inside(at) && !is_known(**at));
        if let Some(at) = first.filter(|_| length > LEAST_LENGTH).or(point.copied()) {
            missing.push(Difference::Missing(has, name.clone(), at, length));
        }
    }
    (common, missing)
}

/// The diagram of a part of another diagram's window; none if there is nothing to unfold.
pub fn part(whole: &Diagram, window: Window) -> Option<Diagram> {
    Diagram::compute(&whole.oscillator, &Scope { window, ..whole.scope.clone() }, &Silent).ok()
}

/// Compares a diagram with that of a part of its window, at `points` random points of the part.
pub fn compare(
    whole: &Diagram,
    window: Window,
    part: Option<&Diagram>,
    points: usize,
    random: &mut Random,
) -> PartComparison {
    let all = whole.scope.window;
    let mut outcome = PartComparison::default();
    let (common, missing) = lacking(all, window, Has::Whole, whole, part);
    outcome.common = common;
    outcome.differences = missing;
    outcome
        .differences
        .extend(part.map(|part| lacking(all, window, Has::Part, part, Some(whole)).1).unwrap_or_default());
    // If there is nothing to unfold, nothing is known about motion without impacts.
    let loops = whole.scope.loops.iter().copied().chain(part.map(|_| 0));
    let loops: Vec<u32> = loops.collect();
    for _ in 0..points {
        let point = window.parameters([random.uniform(0.0, 1.0), random.uniform(0.0, 1.0)]);
        let mut hatched = [false; 2];
        for &p in &loops {
            let there = part.map_or(Shown::White, |part| shown(part, p, point));
            let both = [shown(whole, p, point), there];
            match both {
                [Shown::Shaded, Shown::White] => {
                    outcome.differences.push(Difference::Verdict(Has::Whole, p, point));
                }
                [Shown::White, Shown::Shaded] => {
                    outcome.differences.push(Difference::Verdict(Has::Part, p, point));
                }
                [Shown::Shaded | Shown::White, Shown::Hatched] => hatched[0] = true,
                [Shown::Hatched, Shown::Shaded | Shown::White] => hatched[1] = true,
                [a, b] if a == b => outcome.agreed += 1,
                _ => {}
            }
        }
        for (share, hatched) in outcome.hatched.iter_mut().zip(hatched) {
            *share += if hatched { 1.0 / points as f64 } else { 0.0 };
        }
    }
    outcome
}
