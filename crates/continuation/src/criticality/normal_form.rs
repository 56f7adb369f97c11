//! The normal form of a planar map defined by two other maps, L(X') = R(X), at a fixed point with
//! the multiplier −1.

use grazing_model::smooth::Taylor;
use nalgebra::{Matrix2, Vector2};

use super::PeriodDoubling;

/// A curve in the plane near one of its points: Taylor polynomials in its parameter s.
pub type Germ = [Taylor; 2];

/// The map X ↦ X' with L(X') = R(X) near a point X₀ that it leaves fixed.
pub struct ImplicitMap<F> {
    /// The fixed point X₀.
    pub point: Vector2<f64>,
    /// The derivatives DR and DL at X₀.
    pub derivatives: [Matrix2<f64>; 2],
    /// The maps R and L along a curve through X₀.
    pub along: F,
}

impl<F: Fn(Germ) -> [Germ; 2]> ImplicitMap<F> {
    /// q and c with R(X(s)) = L(X(−s + c s³)) up to third order, X(s) = X₀ + q s + h s² + …, where
    /// the multiplier is −1 and simple and the other one is not 1.
    pub fn flip(&self) -> PeriodDoubling {
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
