//! The two maps from an impact to the surface of comparison, and their consequences: the equations,
//! and the stability of their zeros.

use grazing_model::MapJet;
use nalgebra::{Matrix2, SMatrix, Vector2, Vector4};

use crate::solution::{Multipliers, Stability, Unknowns};

/// The two maps from (y, z; μ, η) to the surface of comparison.
#[derive(Clone, Copy, Debug)]
pub struct LoopPair {
    /// The map through recoil and loops: (x⁽ᵖ⁾, z⁽ᵖ⁾) = P_global^p ∘ P_virt ∘ R for VIVID.
    pub round_trip: MapJet,
    /// The map straight from the impact: (x̂, ẑ) = P_virt for VIVID.
    pub impact: MapJet,
}

impl LoopPair {
    /// The pair of two maps that lead to one surface.
    pub fn of<A, B>(round_trip: &MapJet<A, B>, impact: &MapJet<A, B>) -> Self {
        Self { round_trip: round_trip.plain(), impact: impact.plain() }
    }

    /// The difference V of the two maps and its derivatives in (y, z, μ, η): its zeros are MPSs.
    /// Paper: eq:V.
    pub fn difference(&self) -> (Vector2<f64>, SMatrix<f64, 2, 4>) {
        (self.round_trip.value - self.impact.value, self.round_trip.jacobian - self.impact.jacobian)
    }

    /// The determinant det(D round trip − λ D impact) and its gradient in the unknowns.
    ///
    /// Zero when λ is a stability multiplier: λ = 1 at a saddle-node, λ = −1 at a period-doubling
    /// bifurcation. In contrast to the multipliers it stays smooth through y = 0; up to a smooth
    /// factor it is y (1 − λT + D) for λ = ±1, the paper's y Ψ± (eq:Psi). The gradient needs jets
    /// of order 2.
    pub fn characteristic(&self, multiplier: f64) -> (f64, Vector4<f64>) {
        let m = self.round_trip.derivative() - self.impact.derivative() * multiplier;
        let change = |i: usize, j: usize, k: usize| {
            self.round_trip.hessians[i][(j, k)] - multiplier * self.impact.hessians[i][(j, k)]
        };
        determinant(&m, change)
    }

    /// The unit vector that the round trip stretches by a multiplier.
    pub fn direction(&self, multiplier: f64) -> Option<Vector2<f64>> {
        let m = self.round_trip.derivative() - self.impact.derivative() * multiplier;
        let across = [m.row(0), m.row(1)].map(|row| Vector2::new(-row[1], row[0]));
        let longest = across.into_iter().max_by(|a, b| a.norm().total_cmp(&b.norm()))?;
        longest.try_normalize(0.0)
    }

    /// The difference det(D round trip) − d det(D impact) and its gradient in the unknowns.
    ///
    /// Zero when the product of the multipliers is d; smooth through y = 0, as
    /// [`characteristic`](Self::characteristic) is, and of the same order there.
    pub fn product_less(&self, product: f64) -> (f64, Vector4<f64>) {
        let [round_trip, impact] = [&self.round_trip, &self.impact]
            .map(|jet| determinant(&jet.derivative(), |i, j, k| jet.hessians[i][(j, k)]));
        (round_trip.0 - product * impact.0, round_trip.1 - impact.1 * product)
    }

    /// The stability that follows from the two maps.
    pub(crate) fn stability(&self) -> Stability {
        let [saddle_node, period_doubling] = [1.0, -1.0].map(|multiplier| {
            (self.round_trip.derivative() - self.impact.derivative() * multiplier).determinant()
        });
        let [round_trip, impact] = [&self.round_trip, &self.impact].map(|jet| jet.derivative().determinant());
        let torus = round_trip - impact;
        let multipliers = self.multipliers();
        let violence = (self.round_trip.derivative() * adjugate(self.impact.derivative())).norm();
        Stability { multipliers, saddle_node, period_doubling, pitchfork: None, torus, violence }
    }

    /// Trace and determinant of U = D(P_global^p ∘ P_disc). Paper: eq:U, eq:TD.
    pub fn multipliers(&self) -> Multipliers {
        let (l, r) = (self.round_trip.derivative(), self.impact.derivative());
        // Both vanish in proportion to y.
        let (numerators, denominator) = ([(l * adjugate(r)).trace(), l.determinant()], r.determinant());
        Multipliers { trace: numerators[0] / denominator, determinant: numerators[1] / denominator }
    }

    /// Limits of trace and determinant at a point with y = 0, approached along a curve with the
    /// given tangent.
    ///
    /// Numerators and denominator vanish together at a resonance; the limits are the ratios of
    /// their derivatives along the curve. Jets of order 2.
    pub fn limiting_multipliers(&self, tangent: &Unknowns) -> Multipliers {
        let along = |jet: &MapJet| {
            Matrix2::from_fn(|i, j| (0..4).map(|k| jet.hessians[i][(j, k)] * tangent[k]).sum::<f64>())
        };
        let (l, r) = (self.round_trip.derivative(), self.impact.derivative());
        let (dl, dr) = (along(&self.round_trip), along(&self.impact));
        let denominator = (dr * adjugate(r)).trace();
        Multipliers {
            trace: (dl * adjugate(r) + l * adjugate(dr)).trace() / denominator,
            determinant: (dl * adjugate(l)).trace() / denominator,
        }
    }
}

/// The determinant of a derivative in the first two unknowns, and its gradient; `d` gives the
/// change of entry (i, j) with the k-th unknown.
fn determinant(m: &Matrix2<f64>, d: impl Fn(usize, usize, usize) -> f64) -> (f64, Vector4<f64>) {
    let determinant = m[(0, 0)] * m[(1, 1)] - m[(0, 1)] * m[(1, 0)];
    let gradient = Vector4::from_fn(|k, _| {
        d(0, 0, k) * m[(1, 1)] + m[(0, 0)] * d(1, 1, k) - d(0, 1, k) * m[(1, 0)] - m[(0, 1)] * d(1, 0, k)
    });
    (determinant, gradient)
}

fn adjugate(m: Matrix2<f64>) -> Matrix2<f64> {
    Matrix2::new(m[(1, 1)], -m[(0, 1)], -m[(1, 0)], m[(0, 0)])
}
