//! The normal form of a planar map defined by two other maps, L(X') = R(X), at a fixed point with
//! the multiplier −1.

use grazing_model::smooth::Taylor;
use nalgebra::{Matrix2, Vector2};

use super::PeriodDoubling;

/// A curve in the plane near one of its points: Taylor polynomials in its parameter s.
pub(super) type Germ = [Taylor; 2];

/// The map X ↦ X' with L(X') = R(X) near a point X₀ that it leaves fixed.
pub(super) struct ImplicitMap<F> {
    /// The fixed point X₀.
    pub(super) point: Vector2<f64>,
    /// The derivatives DR and DL at X₀.
    pub(super) derivatives: [Matrix2<f64>; 2],
    /// The maps R and L along a curve through X₀.
    pub(super) along: F,
}

impl<F: Fn(Germ) -> [Germ; 2]> ImplicitMap<F> {
    /// q and c with R(X(s)) = L(X(−s + c s³)) up to third order, X(s) = X₀ + q s + h s² + …, where
    /// the multiplier is −1 and simple and the other one is not 1.
    pub(super) fn flip(&self) -> PeriodDoubling {
        let [r, l] = self.derivatives;
        let [direction, covector] = self.null_vectors();
        // s²: DR h + R₂ = DL h + L₂, where R₂ and L₂ are the coefficients along the straight line.
        let [r2, l2] = self.coefficients(2, [direction, Vector2::zeros()]);
        let bend = solved(&(r - l), l2 - r2);
        // s³: DR k + R₃ = c DL q − DL k − L₃ for the third coefficient k of X(s); multiplication by
        // ℓ isolates c.
        let [r3, l3] = self.coefficients(3, [direction, bend]);
        PeriodDoubling { direction, coefficient: covector.dot(&(r3 + l3)) }
    }

    /// The vector q of length one with (DR + DL) q = 0, and ℓ with ℓᵀ(DR + DL) = 0 and ℓᵀ DL q = 1.
    fn null_vectors(&self) -> [Vector2<f64>; 2] {
        let [r, l] = self.derivatives;
        let m = r + l;
        // Perpendicular to the longer row, and to the longer column: the matrix is singular only to
        // rounding.
        let row = if m.row(0).norm() > m.row(1).norm() { m.row(0) } else { m.row(1) };
        let column = if m.column(0).norm() > m.column(1).norm() { m.column(0) } else { m.column(1) };
        let direction = Vector2::new(row[1], -row[0]).normalize();
        let direction = if direction[0] < 0.0 { -direction } else { direction };
        let covector = Vector2::new(column[1], -column[0]);
        [direction, covector / covector.dot(&(l * direction))]
    }

    /// The coefficients of a power of s in R and L along X₀ + q s + h s².
    fn coefficients(&self, power: usize, [q, h]: [Vector2<f64>; 2]) -> [Vector2<f64>; 2] {
        let curve = [0, 1].map(|i| Taylor::new([self.point[i], q[i], h[i], 0.0]));
        (self.along)(curve).map(|image| Vector2::from(image.map(|component| component.coefficients()[power])))
    }
}

/// The solution M⁻¹ b by Cramer's rule; not finite if M is singular.
fn solved(m: &Matrix2<f64>, b: Vector2<f64>) -> Vector2<f64> {
    let determinant = m[(0, 0)] * m[(1, 1)] - m[(0, 1)] * m[(1, 0)];
    Vector2::new(m[(1, 1)] * b[0] - m[(0, 1)] * b[1], m[(0, 0)] * b[1] - m[(1, 0)] * b[0]) / determinant
}

#[cfg(test)]
mod tests {
    use grazing_model::smooth::{Function, Scalar};

    use super::*;

    /// A pair of maps, written once for plain points and curves; the derivatives are read off
    /// curves along the axes.
    fn implicit<F: Fn(Germ) -> [Germ; 2]>(point: Vector2<f64>, along: F) -> ImplicitMap<F> {
        let mut derivatives = [Matrix2::zeros(); 2];
        for axis in 0..2 {
            let curve = [0, 1].map(|i| Taylor::new([point[i], f64::from(u8::from(i == axis)), 0.0, 0.0]));
            for (derivative, image) in derivatives.iter_mut().zip(along(curve)) {
                derivative
                    .set_column(axis, &Vector2::from(image.map(|component| component.coefficients()[1])));
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
}
