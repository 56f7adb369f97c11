//! Polylines of curves that run close together, between which faces have their true order.
//!
//! Curves are drawn by chords that deviate from them by some 10⁻⁴ of the window. Where two curves
//! are closer than that, such as those that leave a resonance tangent to each other, chords with
//! vertices at different places would cross and cut the strip between them into pieces. Such curves
//! therefore get vertices at the same values of μ or η, and at those of the slices by which the
//! strip is judged; each is located by Newton's method.

use std::collections::HashMap;

use grazing_continuation::curve::Window;
use grazing_continuation::locate::{Condition, locate_within};
use grazing_continuation::mps::{LoopEquations, Unknowns, parameters, unknown};
use grazing_model::smooth::Purpose;
use nalgebra::Vector2;

use crate::curves::DiagramCurve;
use crate::faces::Point;
use crate::parallel;

/// Curves closer to each other than this, as a fraction of the ranges, run alongside; chords
/// deviate from them by less.
const ALONGSIDE: f64 = 1e-3;
/// A segment that rises by less than this fraction of the range of η for one of that of μ is flat:
/// its small deviation from the curve is large along a slice.
const FLAT: f64 = 0.1;
/// Chords deviate from their curves by no more than about this fraction of the ranges. In a window
/// that is long and narrow the chords by which curves are drawn may deviate by more.
const SAG: f64 = 1e-4;
/// The largest number of parts into which a chord is cut.
const MOST_PARTS: f64 = 20.0;
/// Vertices closer than this are one.
const SAME_LEVEL: f64 = 1e-9;

/// A place between two vertices of a curve at which it gets another vertex: the unknown (μ or η)
/// whose value is given, and the fraction of the segment.
#[derive(Clone, Copy)]
struct Place {
    segment: usize,
    unknown: usize,
    value: f64,
    way: f64,
}

/// A vertex of a curve, in fractions of the ranges.
struct Vertex {
    shares: Point,
    curve: usize,
}

/// The vertices of one curve that have been located: the segment, the unknown whose value is given, and
/// the value's bits; `None` where there is none.
type Located = HashMap<(usize, usize, u64), Option<Point>>;

/// The vertices that have been located, curve by curve: lines are drawn again whenever more is known.
#[derive(Default)]
pub(crate) struct Vertices(Vec<Located>);

/// Some of the curves, by their indices, as polylines with vertices at common places where they run alongside.
pub(crate) fn polylines(
    equations: &LoopEquations,
    curves: &[DiagramCurve],
    shown: &[usize],
    (window, levels): (Window, &[f64]),
    vertices: &mut Vertices,
) -> Vec<Vec<Point>> {
    vertices.0.resize_with(curves.len(), Located::new);
    let located = vertices.0.iter_mut().enumerate().filter(|(k, _)| shown.contains(k));
    let located: Vec<&mut Located> = located.map(|(_, located)| located).collect();
    let curves: Vec<&DiagramCurve> = shown.iter().map(|k| &curves[*k]).collect();
    let shares: Vec<Vec<Point>> = curves
        .iter()
        .map(|curve| curve.curve.parameters().into_iter().map(|at| window.shares(at)).collect())
        .collect();
    let mut places = beside_vertices(&shares, window);
    let bent = shares.iter().map(|points| where_bent(points, window));
    for ((of, more), bent) in places.iter_mut().zip(at_levels(&shares, window, levels)).zip(bent) {
        of.extend(more.into_iter().chain(bent));
    }
    let polyline = |((curve, places), located): ((&&DiagramCurve, Vec<Place>), &mut Located)| {
        refined(equations, curve, places, window, located)
    };
    parallel::map(curves.iter().zip(places).zip(located), polyline)
}

/// The fraction of the interval between two numbers at which a value lies, if it lies inside.
fn way([from, to]: [f64; 2], value: f64) -> Option<f64> {
    let way = (value - from) / (to - from);
    (SAME_LEVEL..=1.0 - SAME_LEVEL).contains(&way).then_some(way)
}

/// The unknown that is each of the two parameters.
const UNKNOWN: [usize; 2] = [unknown::PRIMARY, unknown::SECONDARY];

/// The places of each curve beside vertices of others.
fn beside_vertices(curves: &[Vec<Point>], window: Window) -> Vec<Vec<Place>> {
    let sorted = [0, 1].map(|axis| {
        let points = |(curve, points): (usize, &Vec<Point>)| {
            points.iter().map(move |shares| Vertex { shares: *shares, curve }).collect::<Vec<_>>()
        };
        let mut all: Vec<Vertex> = curves.iter().enumerate().flat_map(points).collect();
        all.sort_by(|a, b| a.shares[axis].total_cmp(&b.shares[axis]));
        all
    });
    let places = |(index, points): (usize, &Vec<Point>)| {
        let mut places = Vec::new();
        for (segment, pair) in points.windows(2).enumerate() {
            let [a, b] = [pair[0], pair[1]];
            // The parameter that changes more, in which the segment is a graph.
            let axis = usize::from((b[1] - a[1]).abs() >= (b[0] - a[0]).abs());
            let (low, high) = (a[axis].min(b[axis]), a[axis].max(b[axis]));
            let first = sorted[axis].partition_point(|vertex| vertex.shares[axis] <= low);
            for vertex in sorted[axis][first..].iter().take_while(|vertex| vertex.shares[axis] < high) {
                let Some(way) = way([a[axis], b[axis]], vertex.shares[axis]) else { continue };
                let other = 1 - axis;
                let aside = vertex.shares[other] - a[other] - (b[other] - a[other]) * way;
                if vertex.curve != index && aside.abs() < ALONGSIDE {
                    let value = window.parameters(vertex.shares)[axis];
                    places.push(Place { segment, unknown: UNKNOWN[axis], value, way });
                }
            }
        }
        places
    };
    curves.iter().enumerate().map(places).collect()
}

/// The places at which a curve deviates too much from its chords, estimated from the angles between
/// them: an eighth of their length times the angle.
fn where_bent(points: &[Point], window: Window) -> Vec<Place> {
    let chords: Vec<Vector2<f64>> =
        points.windows(2).map(|pair| Vector2::from(pair[1]) - Vector2::from(pair[0])).collect();
    let turn = |k: usize| chords.get(k).zip(chords.get(k + 1)).map_or(0.0, |(a, b)| a.angle(b));
    let places = chords.iter().enumerate().flat_map(|(segment, chord)| {
        let turn = turn(segment).max(segment.checked_sub(1).map_or(0.0, turn));
        let parts = libm::ceil((0.125 * chord.norm() * turn / SAG).sqrt()).clamp(1.0, MOST_PARTS);
        let axis = usize::from(chord[1].abs() >= chord[0].abs());
        let [from, to] = [points[segment], points[segment + 1]].map(|at| window.parameters(at)[axis]);
        (1..parts as u32).map(move |k| {
            let way = f64::from(k) / parts;
            Place { segment, unknown: UNKNOWN[axis], value: from + (to - from) * way, way }
        })
    });
    places.collect()
}

/// The places of each curve at levels of η where another curve is close, or where it is flat.
fn at_levels(curves: &[Vec<Point>], window: Window, levels: &[f64]) -> Vec<Vec<Place>> {
    let mut places: Vec<Vec<Place>> = vec![Vec::new(); curves.len()];
    for &value in levels {
        let [_, level] = window.shares([window.primary[0], value]);
        let mut crossings: Vec<(f64, usize, Place)> = Vec::new();
        for (index, points) in curves.iter().enumerate() {
            for (segment, pair) in points.windows(2).enumerate() {
                if let Some(way) = way([pair[0][1], pair[1][1]], level) {
                    let across = pair[0][0] + (pair[1][0] - pair[0][0]) * way;
                    let place = Place { segment, unknown: unknown::SECONDARY, value, way };
                    crossings.push((across, index, place));
                }
            }
        }
        crossings.sort_by(|a, b| a.0.total_cmp(&b.0));
        let flat = |(_, index, place): &(f64, usize, Place)| {
            let pair = &curves[*index][place.segment..];
            (pair[1][1] - pair[0][1]).abs() < FLAT * (pair[1][0] - pair[0][0]).abs()
        };
        let mut close: Vec<bool> = crossings.iter().map(flat).collect();
        for k in 1..crossings.len() {
            if crossings[k].0 - crossings[k - 1].0 < ALONGSIDE {
                (close[k - 1], close[k]) = (true, true);
            }
        }
        for ((_, index, place), _) in crossings.into_iter().zip(close).filter(|(_, close)| *close) {
            places[index].push(place);
        }
    }
    places
}

/// The polyline of a curve with vertices at further places, as far as these can be located.
fn refined(
    equations: &LoopEquations,
    curve: &DiagramCurve,
    mut places: Vec<Place>,
    window: Window,
    located: &mut Located,
) -> Vec<Point> {
    places.sort_by(|a, b| a.segment.cmp(&b.segment).then(a.way.total_cmp(&b.way)));
    places.dedup_by(|b, a| a.segment == b.segment && b.way - a.way < SAME_LEVEL);
    let mut places = places.into_iter().peekable();
    let points = &curve.curve.points;
    let mut line = Vec::with_capacity(points.len());
    for (index, point) in points.iter().enumerate() {
        line.push(point.solution.parameters());
        while let Some(place) = places.next_if(|place| place.segment == index) {
            let ends = [0, 1].map(|k| points[index + k].solution.unknowns.clone());
            let near: Unknowns = &ends[0] + (&ends[1] - &ends[0]) * place.way;
            let level = match place.unknown {
                unknown::PRIMARY => Condition::Primary(place.value),
                _ => Condition::Secondary(place.value),
            };
            let conditions = [curve.curve.condition, level];
            // The reach covers the deviation of the curve from its chord, but no more than the next
            // vertices.
            let reach = (&ends[1] - &ends[0]).norm();
            let locate = || {
                let found =
                    locate_within(reach, equations, conditions, near.clone(), &mut point.times.clone());
                found.ok().map(|found| {
                    let mut at = parameters(&found);
                    at[place.unknown - unknown::PRIMARY] = place.value;
                    at
                })
            };
            let key = (index, place.unknown, place.value.to_bits());
            let found = *located.entry(key).or_insert_with(|| Purpose::Vertices.during(locate));
            // A bent curve deviates from its chord by less than a quarter of its length.
            let [from, to] = ends.map(|end| Vector2::from(window.shares(parameters(&end))));
            let aside = ALONGSIDE.max(0.25 * (to - from).norm());
            let is_close = |at: &Point| {
                let [here, there] = [*at, parameters(&near)].map(|at| window.shares(at));
                [0, 1].iter().all(|&axis| (here[axis] - there[axis]).abs() < aside)
            };
            line.extend(found.filter(is_close));
        }
    }
    line
}
