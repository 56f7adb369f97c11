//! The faces into which curves cut a rectangle, as rings of vertices: the first ring bounds a face,
//! the others are its holes.

use grazing_continuation::curve::Window;
use grazing_results::span;
use i_overlay::core::fill_rule::FillRule;
use i_overlay::float::simplify::SimplifyShape;
use i_overlay::float::slice::FloatSlice;

/// A point (μ, η).
pub(crate) type Point = [f64; 2];

/// Part of the plane: its rings, even-odd.
pub(crate) type Face = Vec<Vec<Point>>;

/// The faces into which polylines cut a window; a line that ends inside a face without cutting it
/// is left out.
///
/// Ends of polylines that meet must be equal.
pub(crate) fn cut(window: Window, lines: &[Vec<Point>]) -> Vec<Face> {
    let ([left, right], [low, high]) = (window.primary, window.secondary);
    let rectangle = vec![[left, low], [right, low], [right, high], [left, high]];
    let lines: Vec<Vec<Point>> = lines.iter().filter(|line| line.len() > 1).cloned().collect();
    part(&vec![rectangle], &lines)
}

/// The parts into which polylines that cross a face cut it.
pub(crate) fn part(face: &Face, lines: &[Vec<Point>]) -> Vec<Face> {
    if lines.is_empty() {
        vec![face.clone()]
    } else {
        face.slice_by_as::<i64>(&lines.to_vec(), FillRule::EvenOdd)
    }
}

/// The faces joined where they have a common border.
pub(crate) fn unite(faces: &[&Face]) -> Vec<Face> {
    let faces: Vec<Face> = faces.iter().map(|face| (*face).clone()).collect();
    if faces.is_empty() { Vec::new() } else { faces.simplify_shape_as::<i64>(FillRule::NonZero) }
}

/// The intervals of μ in which the line of constant η lies in a face, in order.
pub(crate) fn chords(face: &Face, secondary: f64) -> Vec<[f64; 2]> {
    let mut crossings: Vec<f64> = edges(face)
        .filter(|[a, b]| (a[1] > secondary) != (b[1] > secondary))
        .map(|[a, b]| a[0] + (b[0] - a[0]) * (secondary - a[1]) / (b[1] - a[1]))
        .collect();
    crossings.sort_by(f64::total_cmp);
    crossings.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect()
}

/// The least and the greatest η of a face, or of a line.
pub(crate) fn extent(face: &[Vec<Point>]) -> [f64; 2] {
    span(face.iter().flatten().map(|point| point[1]))
}

/// Whether a point lies in a face.
pub(crate) fn holds(face: &Face, [primary, secondary]: Point) -> bool {
    chords(face, secondary).iter().any(|[from, to]| *from < primary && primary < *to)
}

/// The area of a face; its holes turn the other way round.
pub(crate) fn area(face: &Face) -> f64 {
    0.5 * edges(face).map(|[a, b]| a[0] * b[1] - a[1] * b[0]).sum::<f64>().abs()
}

/// The length of all rings of a face.
pub(crate) fn perimeter(face: &Face) -> f64 {
    edges(face).map(|[a, b]| libm::hypot(b[0] - a[0], b[1] - a[1])).sum()
}

fn edges(face: &Face) -> impl Iterator<Item = [Point; 2]> {
    face.iter().flat_map(|ring| {
        let next = ring.iter().cycle().skip(1);
        ring.iter().zip(next).map(|(a, b)| [*a, *b])
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const WINDOW: Window = Window { primary: [0.0, 2.0], secondary: [0.0, 4.0] };

    #[test]
    fn faces_cover_the_window_and_holes_are_faces_of_their_own() {
        let ring = vec![[0.5, 1.0], [1.5, 1.0], [1.0, 3.0]];
        let back = vec![[1.0, 3.0], [0.5, 1.0]];
        let loose = vec![[0.1, 0.1], [0.2, 3.9]];
        let faces = cut(WINDOW, &[ring, back, loose]);
        let mut areas: Vec<f64> = faces.iter().map(area).collect();
        areas.sort_by(f64::total_cmp);
        assert_eq!(faces.len(), 2);
        // Coordinates are kept to 2⁻⁶⁰ of the window.
        assert!((areas[0] - 1.0).abs() < 1e-15 && (areas[1] - 7.0).abs() < 1e-15, "{areas:?}");
        let inner = faces.iter().find(|face| face.len() == 1).expect("one has no hole");
        assert!(holds(inner, [1.0, 2.0]) && !holds(inner, [0.3, 2.0]));
        let outer = faces.iter().find(|face| face.len() == 2).expect("one has a hole");
        assert!(holds(outer, [0.3, 2.0]) && !holds(outer, [1.0, 2.0]));
        assert_eq!(chords(outer, 2.0).len(), 2);
    }

    #[test]
    fn neighbours_are_joined_and_what_only_touches_is_not() {
        let lines = [vec![[1.0, 0.0], [1.0, 4.0]], vec![[0.0, 2.0], [2.0, 2.0]]];
        let faces = cut(WINDOW, &lines);
        assert_eq!(faces.len(), 4);
        let at = |point| faces.iter().find(|face| holds(face, point)).expect("faces cover the window");
        let [low, high, across] = [at([0.5, 1.0]), at([0.5, 3.0]), at([1.5, 3.0])];
        let joined = unite(&[low, high]);
        assert_eq!((joined.len(), joined[0].len()), (1, 1));
        assert_eq!(area(&joined[0]), 4.0);
        assert_eq!(unite(&[low, across]).iter().map(area).sum::<f64>(), 4.0);
        assert_eq!(unite(&[]), Vec::<Face>::new());
    }
}
