//! Regions of stability as polygons in the plane of the two parameters (μ, η).
//!
//! The boundary of a region of stable MPSs is a chain of bifurcation curves that meet at codimension-two points: from a
//! resonance along PD to its end, along GZ, along SN back to the resonance. Where a chain leaves the window it goes on
//! along the edge of the window to the next curve that leaves it. The region of the non-impacting solution lies beside a
//! grazing curve that crosses the window.

use grazing_continuation::curve::{CurveEnd, Window};
use grazing_model::ImpactOscillator;

use crate::diagram::{Diagram, DiagramCurve, Kind};
use crate::grazing::{GrazingCurve, GrazingEnd};

/// A polygon, its vertices in order, as points (μ, η).
#[derive(Clone, Debug, PartialEq)]
pub struct Polygon {
    /// `non-impacting` or `mps`.
    pub kind: &'static str,
    /// Number of loops p; 0 for the non-impacting solution.
    pub loops: u32,
    /// The integer n of the resonance at which the polygon begins; 0 for the non-impacting solution.
    pub n: u32,
    /// The corners.
    pub vertices: Vec<[f64; 2]>,
}

/// All regions of a diagram.
pub fn all<O: ImpactOscillator>(diagram: &Diagram<O>) -> Vec<Polygon> {
    let window = diagram.scope.window;
    let mut polygons: Vec<_> =
        diagram.grazing.iter().filter_map(|curve| non_impacting(curve, window)).collect();
    polygons.extend(stable_mps(diagram));
    polygons
}

/// Where the non-impacting solution is stable, beside a grazing curve that crosses the window; none where it does not, or loses
/// its stability or another maximum touches the wall on the way.
fn non_impacting<O: ImpactOscillator>(curve: &GrazingCurve<O>, window: Window) -> Option<Polygon> {
    let crosses = curve.ends == [GrazingEnd::LeftWindow; 2];
    if !crosses || curve.states.iter().any(|state| !(state.stable && state.admissible)) {
        return None;
    }
    let mut vertices: Vec<[f64; 2]> = curve.parameters().collect();
    // For beta > 0 the solution keeps off the wall at smaller μ: to the left of a walk towards greater η.
    let beta = curve.states[0].orbit.grazing_point().map.transversality();
    let [start, end] = [vertices[0], vertices[vertices.len() - 1]];
    vertices.append(&mut Edge { window }.corners([end, start], beta < 0.0));
    Some(Polygon { kind: "non-impacting", loops: 0, n: 0, vertices })
}

/// Where a p-loop MPS is stable and admissible: one polygon for each chain of curves that closes.
fn stable_mps<O: ImpactOscillator>(diagram: &Diagram<O>) -> Vec<Polygon> {
    let mut used = vec![false; diagram.curves.len()];
    let mut polygons = Vec::new();
    for (index, curve) in diagram.curves.iter().enumerate() {
        if curve.kind != Kind::SaddleNode || used[index] {
            continue;
        }
        let edge = Edge { window: diagram.scope.window };
        let greater = exists_at_greater_primary(diagram, curve);
        let mut chain = Chain { curves: &diagram.curves, edge, taken: vec![index], vertices: Vec::new() };
        if chain.close(index, greater) {
            for index in chain.taken {
                used[index] = true;
            }
            polygons.push(Polygon { kind: "mps", loops: curve.loops, n: curve.n, vertices: chain.vertices });
        }
    }
    polygons
}

/// Beside the saddle-node curve MPSs exist on the side of greater μ: on the branch μ = k₂ y² + k₃ η y it is a minimum.
fn exists_at_greater_primary<O: ImpactOscillator>(diagram: &Diagram<O>, curve: &DiagramCurve) -> bool {
    let own =
        diagram.unfolding().find(|(resonance, _)| resonance.loops == curve.loops && resonance.n == curve.n);
    own.is_none_or(|(_, point)| point.theorem().branch().k_2 > 0.0)
}

/// A chain of curves that is being followed.
struct Chain<'a> {
    curves: &'a [DiagramCurve],
    edge: Edge,
    taken: Vec<usize>,
    vertices: Vec<[f64; 2]>,
}

/// Ends of curves closer than this meet there; they were located to about 10⁻¹⁰.
const MEET: f64 = 1e-7;

impl Chain<'_> {
    /// Walks from the far end of an SN curve back to its resonance and on, until the chain closes; false if it does not.
    ///
    /// `greater` says whether the MPS exists on the side of greater μ of the curve.
    fn close(&mut self, first: usize, greater: bool) -> bool {
        let mut points = self.curves[first].curve.parameters();
        points.reverse();
        let start = points[0];
        // Where the walk comes to the resonance, along the grazing curve, the side of greater μ lies to its right if η grows.
        let clockwise = match points.as_slice() {
            [.., before, resonance] => (resonance[1] > before[1]) == greater,
            _ => return false,
        };
        self.vertices = points;
        self.extend(start, clockwise)
    }

    /// Goes on from the last vertex to `start`, along curves that meet there or along the edge to the next curve that leads on.
    fn extend(&mut self, start: [f64; 2], clockwise: bool) -> bool {
        let here = self.vertices[self.vertices.len() - 1];
        if distance(here, start) < MEET {
            return true;
        }
        let ways = match self.curve_at(here) {
            Some((index, points)) => vec![(Some(index), points)],
            None if self.edge.meets(here) => self.along_edge(here, start, clockwise),
            None => Vec::new(),
        };
        ways.into_iter().any(|(index, mut points)| {
            let length = self.vertices.len();
            self.vertices.append(&mut points);
            self.taken.extend(index);
            let closed = self.extend(start, clockwise);
            if !closed {
                self.vertices.truncate(length);
                self.taken.truncate(self.taken.len() - usize::from(index.is_some()));
            }
            closed
        })
    }

    /// A curve of the same MPS that has an end here and is not taken yet, with its points from this end on.
    fn curve_at(&self, here: [f64; 2]) -> Option<(usize, Vec<[f64; 2]>)> {
        self.untaken().find_map(|(index, curve)| {
            let mut points = curve.curve.parameters();
            if distance(points[points.len() - 1], here) < MEET {
                points.reverse();
            }
            (distance(points[0], here) < MEET).then_some((index, points))
        })
    }

    fn untaken(&self) -> impl Iterator<Item = (usize, &DiagramCurve)> {
        let loops = self.curves[self.taken[0]].loops;
        let curves = self.curves.iter().enumerate();
        curves.filter(move |(index, curve)| curve.loops == loops && !self.taken.contains(index))
    }

    /// Ways along the edge to other ends on it, the nearest first: the corners passed, and that end.
    fn along_edge(
        &self,
        here: [f64; 2],
        start: [f64; 2],
        clockwise: bool,
    ) -> Vec<(Option<usize>, Vec<[f64; 2]>)> {
        let leaves = |curve: &DiagramCurve| matches!(curve.curve.end, CurveEnd::LeftWindow);
        let mut targets: Vec<[f64; 2]> = self
            .untaken()
            .filter(|(_, curve)| leaves(curve))
            .filter_map(|(_, curve)| curve.curve.parameters().last().copied())
            .collect();
        if leaves(&self.curves[self.taken[0]]) {
            targets.push(start);
        }
        let ahead = |point: &[f64; 2]| self.edge.way([here, *point], clockwise);
        targets.sort_by(|a, b| ahead(a).total_cmp(&ahead(b)));
        let path = |target: [f64; 2]| {
            let mut path = self.edge.corners([here, target], clockwise);
            path.push(target);
            (None, path)
        };
        targets.into_iter().map(path).collect()
    }
}

/// The edge of the window.
#[derive(Clone, Copy)]
struct Edge {
    window: Window,
}

impl Edge {
    fn meets(&self, [primary, secondary]: [f64; 2]) -> bool {
        let near =
            |[low, high]: [f64; 2], value: f64| (value - low).abs() < MEET || (value - high).abs() < MEET;
        near(self.window.primary, primary) || near(self.window.secondary, secondary)
    }

    /// The corners on the way from one point of the edge to another.
    fn corners(&self, [from, to]: [[f64; 2]; 2], clockwise: bool) -> Vec<[f64; 2]> {
        let ([left, right], [low, high]) = (self.window.primary, self.window.secondary);
        let ahead = |point: &[f64; 2]| self.way([from, *point], clockwise);
        let mut corners = vec![[left, high], [right, high], [right, low], [left, low]];
        corners.sort_by(|a, b| ahead(a).total_cmp(&ahead(b)));
        corners.retain(|corner| ahead(corner) < ahead(&to));
        corners
    }

    /// The way along the edge from one point to another, one unit a side.
    fn way(&self, [from, to]: [[f64; 2]; 2], clockwise: bool) -> f64 {
        let gap = self.perimeter(to) - self.perimeter(from);
        let gap = if clockwise { gap } else { -gap };
        gap - 4.0 * libm::floor(gap / 4.0)
    }

    /// Position along the edge, clockwise from the lower left corner, one unit a side.
    fn perimeter(&self, [primary, secondary]: [f64; 2]) -> f64 {
        let share = |[low, high]: [f64; 2], value: f64| (value - low) / (high - low);
        let across = share(self.window.primary, primary);
        let up = share(self.window.secondary, secondary);
        let distances = [across, 1.0 - up, 1.0 - across, up];
        let side = (0..4).min_by(|i, j| distances[*i].abs().total_cmp(&distances[*j].abs())).unwrap_or(0);
        match side {
            0 => up,
            1 => 1.0 + across,
            2 => 2.0 + (1.0 - up),
            _ => 3.0 + (1.0 - across),
        }
    }
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).abs().max((a[1] - b[1]).abs())
}
