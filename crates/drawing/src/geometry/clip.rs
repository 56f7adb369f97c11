//! Clipping in data space: a curve leaves the frame exactly where it crosses the edge, with its own
//! slope.

use grazing_results::{Frame, span};

use crate::error::DrawingError;
use crate::geometry::sheet::fractions_inside;

/// Returns the frame if both its ranges are finite and increasing; errors call it `name`.
pub fn checked(frame: Frame, name: &str) -> Result<Frame, DrawingError> {
    for (axis, [low, high]) in [("horizontal", frame.x), ("vertical", frame.y)] {
        // Written so that NaN fails too, and so does a range wider than the greatest number.
        if !(low < high && (high - low).is_finite()) {
            return Err(DrawingError(format!(
                "{axis} range of {name} must be finite and increasing, but it is {low} to {high}"
            )));
        }
    }
    Ok(frame)
}

/// The part of a segment inside the frame, if any; ends inside are preserved exactly, so that consecutive
/// segments join.
fn clip_segment(frame: &Frame, a: (f64, f64), b: (f64, f64)) -> Option<((f64, f64), (f64, f64))> {
    let (enter, leave) = fractions_inside(frame.x, frame.y, a, b)?;
    let at = |t: f64| (a.0 + t * (b.0 - a.0), a.1 + t * (b.1 - a.1));
    Some((if enter == 0.0 { a } else { at(enter) }, if leave == 1.0 { b } else { at(leave) }))
}

/// The pieces of a polyline inside the frame, split at its edge and at points that are not finite.
pub(crate) fn clip_polyline(frame: &Frame, points: &[(f64, f64)]) -> Vec<Vec<(f64, f64)>> {
    let mut pieces: Vec<Vec<(f64, f64)>> = Vec::new();
    let mut current: Vec<(f64, f64)> = Vec::new();
    for pair in points.windows(2) {
        let finite = pair.iter().all(|p| p.0.is_finite() && p.1.is_finite());
        let Some((from, to)) = (if finite { clip_segment(frame, pair[0], pair[1]) } else { None }) else {
            pieces.push(std::mem::take(&mut current));
            continue;
        };
        if current.last() != Some(&from) {
            pieces.push(std::mem::take(&mut current));
            current.push(from);
        }
        current.push(to);
    }
    pieces.push(current);
    pieces.retain(|piece| piece.len() > 1);
    pieces
}

/// Parallel lines at 45°, this distance apart, inside the rings by the even-odd rule.
pub(crate) fn hatching(rings: &[Vec<(f64, f64)>], distance: f64) -> Vec<[(f64, f64); 2]> {
    // Along a line u = y + x is constant, and v = y − x varies.
    let turned = |&(x, y): &(f64, f64)| (y + x, y - x);
    let back = |u: f64, v: f64| (0.5 * (u - v), 0.5 * (u + v));
    let edges: Vec<[(f64, f64); 2]> = rings
        .iter()
        .flat_map(|ring| ring.iter().zip(ring.iter().cycle().skip(1)).map(|(a, b)| [turned(a), turned(b)]))
        .collect();
    let [low, high] = span(edges.iter().map(|[(u, _), _]| *u));
    let step = distance * std::f64::consts::SQRT_2;
    let mut lines = Vec::new();
    // The first line lies inside: a line through a corner would have no length.
    let mut u = ((low / step).floor() + 1.0) * step;
    while u < high {
        let mut crossings: Vec<f64> = edges
            .iter()
            .filter(|[a, b]| (a.0 > u) != (b.0 > u))
            .map(|[a, b]| a.1 + (b.1 - a.1) * (u - a.0) / (b.0 - a.0))
            .collect();
        crossings.sort_by(f64::total_cmp);
        lines.extend(crossings.chunks_exact(2).map(|pair| [back(u, pair[0]), back(u, pair[1])]));
        u += step;
    }
    lines
}

/// The part of a polygon inside the frame (Sutherland–Hodgman), as vertices in order; empty if there is
/// none.
///
/// If the part consists of several pieces, they are joined along the edge, which is right for filling but
/// not for outlines. Vertices that are not finite are omitted.
pub(crate) fn clip_polygon(frame: &Frame, vertices: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let mut kept: Vec<(f64, f64)> =
        vertices.iter().copied().filter(|p| p.0.is_finite() && p.1.is_finite()).collect();
    type Side = fn(&Frame, (f64, f64)) -> f64;
    let sides: [Side; 4] =
        [|f, p| p.0 - f.x[0], |f, p| f.x[1] - p.0, |f, p| p.1 - f.y[0], |f, p| f.y[1] - p.1];
    for inside in sides {
        let Some(&last) = kept.last() else { break };
        let mut previous = last;
        let mut next = Vec::with_capacity(kept.len() + 4);
        for &vertex in &kept {
            let (before, after) = (inside(frame, previous), inside(frame, vertex));
            if (before < 0.0) != (after < 0.0) {
                let t = before / (before - after);
                next.push((
                    previous.0 + t * (vertex.0 - previous.0),
                    previous.1 + t * (vertex.1 - previous.1),
                ));
            }
            if after >= 0.0 {
                next.push(vertex);
            }
            previous = vertex;
        }
        kept = next;
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::sheet::area;

    #[test]
    fn hatching_lies_inside_and_spares_holes() {
        let square = |low: f64, high: f64| vec![(low, low), (high, low), (high, high), (low, high)];
        let rings = [square(0.0, 10.0), square(4.0, 6.0)];
        let lines = hatching(&rings, 1.0);
        let length: f64 =
            lines.iter().map(|[a, b]| ((b.0 - a.0) * (b.0 - a.0) + (b.1 - a.1) * (b.1 - a.1)).sqrt()).sum();
        // The lines have the length of the area over their distance, to within one line at either side.
        assert!((length - 96.0).abs() < 15.0, "{length}");
        for [a, b] in lines {
            let middle = (0.5 * (a.0 + b.0), 0.5 * (a.1 + b.1));
            let within =
                |low: f64, high: f64| low < middle.0 && middle.0 < high && low < middle.1 && middle.1 < high;
            assert!(within(0.0, 10.0) && !within(4.0, 6.0), "{middle:?}");
        }
    }

    const UNIT: Frame = Frame { x: [0.0, 1.0], y: [0.0, 1.0] };

    #[test]
    fn a_line_leaves_the_frame_at_its_own_slope() {
        // Slope 3 through (0.5, 0.5): the line crosses y = 0 and y = 1 at x = 1/3 and 2/3, to one
        // rounding error.
        let pieces = clip_polyline(&UNIT, &[(-0.5, -2.5), (1.5, 3.5)]);
        assert_eq!(pieces.len(), 1);
        let [from, to] = pieces[0][..] else { panic!("one segment expected") };
        assert!((from.0 - 1.0 / 3.0).abs() < 1e-15 && from.1.abs() < 1e-15);
        assert!((to.0 - 2.0 / 3.0).abs() < 1e-15 && (to.1 - 1.0).abs() < 1e-15);
    }

    #[test]
    fn a_line_falls_into_the_pieces_that_are_inside_and_numbers() {
        let (nan, infinite) = ((f64::NAN, f64::NAN), (f64::INFINITY, 0.4));
        for (line, pieces) in [
            // Preserved exactly.
            (vec![(0.1, 0.2), (1.0, 0.3), (0.7, 0.0)], vec![vec![(0.1, 0.2), (1.0, 0.3), (0.7, 0.0)]]),
            // Leaves and returns at slopes of 8 and -8.
            (
                vec![(0.125, 0.5), (0.25, 1.5), (0.75, 1.5), (0.875, 0.5)],
                vec![vec![(0.125, 0.5), (0.1875, 1.0)], vec![(0.8125, 1.0), (0.875, 0.5)]],
            ),
            // Passes beside a corner.
            (vec![(-0.2, 0.9), (0.2, 1.3)], vec![]),
            (
                vec![(0.1, 0.1), (0.2, 0.2), nan, (0.3, 0.3), (0.4, 0.4), infinite],
                vec![vec![(0.1, 0.1), (0.2, 0.2)], vec![(0.3, 0.3), (0.4, 0.4)]],
            ),
        ] {
            assert_eq!(clip_polyline(&UNIT, &line), pieces);
        }
    }

    #[test]
    fn a_polygon_is_cut_along_the_edge() {
        // A diamond of half-diagonal 0.75 about the centre loses four corner triangles of height
        // 0.25: its area falls from 1.125 to 1.125 - 4 * 0.0625.
        let diamond = [(0.5, -0.25), (1.25, 0.5), (0.5, 1.25), (-0.25, 0.5)];
        let cut = clip_polygon(&UNIT, &diamond);
        assert_eq!(cut.len(), 8);
        assert!((area(&cut) - 0.875).abs() < 1e-15);
    }

    #[test]
    fn a_polygon_around_the_frame_becomes_the_frame_and_one_beside_it_nothing() {
        let around = [(-1.0, -1.0), (3.0, -1.0), (3.0, 2.0), (-1.0, 2.0)];
        assert!((area(&clip_polygon(&UNIT, &around)) - 1.0).abs() < 1e-15);
        assert!(clip_polygon(&UNIT, &[(2.0, 0.0), (3.0, 0.0), (3.0, 1.0)]).is_empty());
    }

    #[test]
    fn a_reversed_or_infinite_frame_is_refused() {
        let reversed = checked(Frame { x: [1.0, 0.0], y: [0.0, 1.0] }, "the panel").unwrap_err();
        assert_eq!(
            reversed.to_string(),
            "horizontal range of the panel must be finite and increasing, but it is 1 to 0"
        );
        assert!(checked(Frame { x: [0.0, 1.0], y: [0.0, f64::NAN] }, "the panel").is_err());
        assert!(checked(Frame { x: [-1e308, 1e308], y: [0.0, 1.0] }, "the panel").is_err());
    }
}
