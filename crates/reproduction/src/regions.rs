//! Regions of stability as polygons in the plane of amplitude and frequency.
//!
//! The boundary of a region of stable MPSs is a chain of bifurcation curves that meet at codimension-two points: from a
//! resonance along PD to its end, along GZ, along SN back to the resonance. Where a chain leaves the window it goes on
//! along the edge of the window to the next curve that leaves it.

use grazing_continuation::curve::CurveEnd;

use crate::diagram::{Diagram, Kind};
use crate::grazing_curve::GrazingCurve;
use crate::parameters::Rectangle;

/// A polygon, its vertices in order, as points (amplitude, frequency).
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Polygon {
    pub(crate) kind: &'static str,
    pub(crate) loops: u32,
    pub(crate) n: u32,
    pub(crate) vertices: Vec<[f64; 2]>,
}

/// Where the non-impacting solution is stable: amplitudes below grazing.
pub(crate) fn non_impacting(grazing: &GrazingCurve, window: Rectangle) -> Polygon {
    let left = window.amplitude().lower();
    let curve = grazing.states.iter().map(|state| [state.amplitude(), state.forcing_frequency()]);
    let edge = [[left, window.frequency().upper()], [left, window.frequency().lower()]];
    Polygon { kind: "non-impacting", loops: 0, n: 0, vertices: curve.chain(edge).collect() }
}

/// Where a p-loop MPS is stable and admissible: one polygon for each chain of curves that closes.
pub(crate) fn stable_mps(diagram: &Diagram, window: Rectangle) -> Vec<Polygon> {
    let mut used = vec![false; diagram.curves.len()];
    let mut polygons = Vec::new();
    for (index, curve) in diagram.curves.iter().enumerate() {
        if curve.kind != Kind::SaddleNode || used[index] {
            continue;
        }
        let mut chain = Chain { diagram, window, taken: vec![index], vertices: Vec::new() };
        if chain.close(index) {
            for index in chain.taken {
                used[index] = true;
            }
            polygons.push(Polygon { kind: "mps", loops: curve.loops, n: curve.n, vertices: chain.vertices });
        }
    }
    polygons
}

/// A chain of curves that is being followed.
struct Chain<'a> {
    diagram: &'a Diagram,
    window: Rectangle,
    taken: Vec<usize>,
    vertices: Vec<[f64; 2]>,
}

/// Ends of curves closer than this meet there; they were located to about 10⁻¹⁰.
const MEET: f64 = 1e-7;

impl Chain<'_> {
    /// Walks from the far end of an SN curve back to its resonance and on, until the chain closes; false if it does not.
    fn close(&mut self, first: usize) -> bool {
        let mut points = self.diagram.curves[first].curve.parameters();
        points.reverse();
        let start = points[0];
        // At the resonance the MPS exists on the side of greater amplitude: to the right of a walk towards higher
        // frequency, and to the left otherwise.
        let clockwise = points[points.len() - 1][1] > start[1];
        let leaves = matches!(self.diagram.curves[first].curve.end, CurveEnd::LeftWindow);
        self.vertices = points;
        loop {
            let here = self.vertices[self.vertices.len() - 1];
            if let Some(mut next) = self.curve_at(here) {
                self.vertices.append(&mut next);
            } else if self.on_edge(here) {
                let Some(mut next) = self.along_edge(here, start, leaves, clockwise) else {
                    return false;
                };
                self.vertices.append(&mut next);
            } else {
                return false;
            }
            let here = self.vertices[self.vertices.len() - 1];
            if distance(here, start) < MEET {
                return true;
            }
        }
    }

    /// The points of a curve of the same MPS that has an end here and is not taken yet, from this end on.
    fn curve_at(&mut self, here: [f64; 2]) -> Option<Vec<[f64; 2]>> {
        let loops = self.diagram.curves[self.taken[0]].loops;
        for (index, curve) in self.diagram.curves.iter().enumerate() {
            if curve.loops != loops || self.taken.contains(&index) {
                continue;
            }
            let mut points = curve.curve.parameters();
            if distance(points[points.len() - 1], here) < MEET {
                points.reverse();
            }
            if distance(points[0], here) < MEET {
                self.taken.push(index);
                return Some(points);
            }
        }
        None
    }

    fn on_edge(&self, [amplitude, frequency]: [f64; 2]) -> bool {
        let window = self.window;
        let near = |a: f64, b: f64| (a - b).abs() < MEET;
        near(amplitude, window.amplitude().lower())
            || near(amplitude, window.amplitude().upper())
            || near(frequency, window.frequency().lower())
            || near(frequency, window.frequency().upper())
    }

    /// Along the edge to the nearest other end on it: the corners passed, and that end.
    fn along_edge(
        &self,
        here: [f64; 2],
        start: [f64; 2],
        back_to_start: bool,
        clockwise: bool,
    ) -> Option<Vec<[f64; 2]>> {
        let loops = self.diagram.curves[self.taken[0]].loops;
        let mut targets: Vec<[f64; 2]> = Vec::new();
        for (index, curve) in self.diagram.curves.iter().enumerate() {
            if curve.loops == loops
                && !self.taken.contains(&index)
                && matches!(curve.curve.end, CurveEnd::LeftWindow)
            {
                targets.extend(curve.curve.parameters().last());
            }
        }
        if back_to_start {
            targets.push(start);
        }
        let origin = self.perimeter(here);
        let ahead = |point: [f64; 2]| {
            let gap = self.perimeter(point) - origin;
            let gap = if clockwise { gap } else { -gap };
            gap - 4.0 * libm::floor(gap / 4.0)
        };
        let target = targets.into_iter().min_by(|a, b| ahead(*a).total_cmp(&ahead(*b)))?;
        let (amplitude, frequency) = (self.window.amplitude(), self.window.frequency());
        let mut corners = [
            [amplitude.lower(), frequency.upper()],
            [amplitude.upper(), frequency.upper()],
            [amplitude.upper(), frequency.lower()],
            [amplitude.lower(), frequency.lower()],
        ];
        corners.sort_by(|a, b| ahead(*a).total_cmp(&ahead(*b)));
        let mut path: Vec<_> = corners.into_iter().filter(|corner| ahead(*corner) < ahead(target)).collect();
        path.push(target);
        Some(path)
    }

    /// Position along the edge, clockwise from the lower left corner, one unit a side.
    fn perimeter(&self, [amplitude, frequency]: [f64; 2]) -> f64 {
        let (a, f) = (self.window.amplitude(), self.window.frequency());
        let across = (amplitude - a.lower()) / a.width();
        let up = (frequency - f.lower()) / f.width();
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
