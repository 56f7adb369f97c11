//! The sides of the edges of the path in the proof of theorem 2.3 on which its other vertices lie.

use grazing_theorems::auxiliary::{admissibility_sum, lucas_partial_sum};
use nalgebra::{Matrix2, Vector2};

/// Points of which each is the image of the one before under a map with this trace and determinant. Other
/// such maps differ by an affine change of coordinates.
fn path(p: u32, tau: f64, delta: f64) -> Vec<Vector2<f64>> {
    let map =
        |point: &Vector2<f64>| Some(Matrix2::new(tau, 1.0, -delta, 0.0) * point + Vector2::new(0.3, 0.8));
    std::iter::successors(Some(Vector2::new(0.2, -0.5)), map).take(p as usize + 1).collect()
}

fn cross(a: Vector2<f64>, b: Vector2<f64>) -> f64 {
    a.x * b.y - a.y * b.x
}

#[test]
fn sides_of_the_edges_are_told_by_t_and_h() {
    let (p, tau, delta) = (7, 0.9, 0.6);
    let vertices = path(p, tau, delta);
    let edge = |i: usize| vertices[i + 1] - vertices[i];
    let unit = cross(edge(0), edge(1));
    for i in 0..p as usize {
        for (k, vertex) in vertices.iter().enumerate().filter(|(k, _)| *k != i && *k != i + 1) {
            let factor = if k > i {
                libm::pow(delta, i as f64) * lucas_partial_sum((k - i) as u32, tau, delta)
            } else {
                libm::pow(delta, i as f64 - 1.0) * admissibility_sum((i - k + 1) as u32, tau, delta)
            };
            // Entries of order one, with a few roundings for each vertex.
            assert!((cross(edge(i), vertex - vertices[i]) - factor * unit).abs() < 1e-14, "{i} {k}");
        }
    }
}
