//! The normal form of a period doubling, compared with maps of which it is known.

use grazing_continuation::criticality::{Germ, ImplicitMap};
use grazing_model::smooth::{Function, Scalar, Taylor};
use nalgebra::{Matrix2, Vector2};

/// A pair of maps, written once for plain points and curves; the derivatives are read off
/// curves along the axes.
fn implicit<F: Fn(Germ) -> [Germ; 2]>(point: Vector2<f64>, along: F) -> ImplicitMap<F> {
    let mut derivatives = [Matrix2::zeros(); 2];
    for axis in 0..2 {
        let curve = [0, 1].map(|i| Taylor::new([point[i], f64::from(u8::from(i == axis)), 0.0, 0.0]));
        for (derivative, image) in derivatives.iter_mut().zip(along(curve)) {
            derivative.set_column(axis, &Vector2::from(image.map(|component| component.coefficients()[1])));
        }
    }
    ImplicitMap { point, derivatives, along }
}

/// The map u ↦ r u (1 − u) beside v ↦ v/2 + u²: its period doubling at r = 3 has c = ¼ f''² =
/// 9, as f''' = 0.
fn logistic(r: f64) -> impl Fn(Germ) -> Germ {
    move |[u, v]| [(u * (Taylor::constant(1.0) - u)).scale(r), v.scale(0.5) + u.square()]
}

const LOGISTIC_FIXED: [f64; 2] = [2.0 / 3.0, 8.0 / 9.0];

#[test]
fn logistic_map_has_its_known_coefficient() {
    let map = logistic(3.0);
    let flip = implicit(Vector2::from(LOGISTIC_FIXED), |x| [map(x), x]).flip();
    // Along q = (1, m): −m = m/2 + 2u, so that |q|² = 1 + m² and c, which is measured along q,
    // is smaller by this factor.
    let slope: f64 = -2.0 * LOGISTIC_FIXED[0] / 1.5;
    let expected = 9.0 / (1.0 + slope * slope);
    assert!((flip.coefficient - expected).abs() < 1e-14 * expected, "{flip:?}");
    assert!((flip.direction[1] / flip.direction[0] - slope).abs() < 1e-15);
}

#[test]
fn a_cubic_turns_the_period_doubling_subcritical() {
    // u ↦ −u + k u³ has c = k.
    for k in [-2.0, 0.5] {
        let flip =
            implicit(Vector2::zeros(), |[u, v]| [[u.power(3).scale(k) - u, v.scale(0.3)], [u, v]]).flip();
        assert!((flip.coefficient - k).abs() < 1e-15);
    }
}

/// A change of coordinates that changes all second and third derivatives.
fn bent([u, v]: Germ) -> Germ {
    let w = v + u.square().scale(0.7) - u.scale(0.4);
    [u + (w - u).apply(Function::Sin).scale(0.3), w.apply(Function::Exp).scale(0.6) + u * w]
}

#[test]
fn coefficients_do_not_depend_on_coordinates() {
    let (r, at) = (3.0, Vector2::new(0.3, -0.2));
    // U in coordinates X = bent(Y) + shift, so that Y = `at` is the fixed point; and L, R
    // followed by another map.
    let moved = bent([0, 1].map(|i| Taylor::constant(at[i])));
    let shift = [0, 1].map(|i| Taylor::constant(LOGISTIC_FIXED[i]) - moved[i]);
    let coordinates = |y: Germ| {
        let [u, v] = bent(y);
        [u + shift[0], v + shift[1]]
    };
    let map = logistic(r);
    let plain = implicit(Vector2::from(LOGISTIC_FIXED), |x| [map(x), x]).flip();
    let other = implicit(at, |y| {
        let x = coordinates(y);
        [bent(map(x)), bent(x)]
    });
    let flip = other.flip();
    // s is length along q, and lengths change by |D bent q|: c is the same once both are
    // measured in one length.
    let q = [0, 1].map(|i| Taylor::new([at[i], flip.direction[i], 0.0, 0.0]));
    let image = Vector2::from(coordinates(q).map(|component| component.coefficients()[1]));
    let expected = plain.coefficient * image.norm_squared();
    // Two dozen roundings of terms up to ten times the result.
    assert!((flip.coefficient - expected).abs() < 1e-13 * expected, "{} {expected}", flip.coefficient);
    assert!(flip.coefficient > 0.0);
}
