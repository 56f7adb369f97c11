//! The saddle-node and period-doubling curves that emanate from a resonant grazing bifurcation:
//! theorems 2.4 and 2.5 of the paper (section 2.6).

use crate::auxiliary::detuning;
use crate::generic_theorem::{Side, common_hypotheses};
use crate::hypothesis::{HypothesesViolated, Hypothesis, ImposedCondition, Quantity, Theorem, check};
use crate::unfolding::{BranchExpansion, ResonantPoint, Unfolding};

/// A curve in the `(eta, mu)` plane along which the maximal periodic solution bifurcates, to
/// leading order at the resonance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BifurcationCurve {
    /// The quadratic coefficient: `mu = coefficient eta^2 + O(eta^3)`.
    pub coefficient: f64,
    /// The sign of `eta` for which the solution is admissible.
    pub eta_side: Side,
    /// The impact velocity along the curve per unit of `eta`; it has the sign of `eta_side`.
    pub impact_velocity_slope: f64,
    /// The impact phase relative to `z_graz(eta)` along the curve, radians per unit of `eta`;
    /// section 5, eq. (23), `eq:admp7`.
    pub impact_phase_slope: f64,
}

impl BifurcationCurve {
    /// The quadratic approximation `mu = c eta^2` of the curve; `None` on the side where the
    /// solution is virtual.
    ///
    /// Paper: section 2, eq. (22), (23), (26) and (27), `eq:sn1`, `eq:pd1`, `eq:snp`, `eq:pdp`,
    /// without their `O(eta^3)`. `eta = 0`, the resonance itself, belongs to the curve.
    pub fn parameter(&self, eta: f64) -> Option<f64> {
        (eta * self.eta_side.signum() >= 0.0).then_some(self.coefficient * eta * eta)
    }
}

/// Theorems 2.4 and 2.5: a curve of saddle-node bifurcations and a curve where a stability
/// multiplier is -1 emanate from a resonant grazing bifurcation, tangent to the curve of grazing
/// bifurcations.
///
/// A value of this type exists only if the hypotheses hold. Paper: `th:codim21` for `p = 1`,
/// `th:codim2p` for `p >= 2`.
///
/// The smoothness of `F` and `R` and assumption 2.2 (grazing occurs at `mu = 0` for all `eta` near
/// 0) cannot be checked with numbers at one point and are up to the caller.
#[derive(Debug, Clone, PartialEq)]
pub struct ResonantGrazing {
    theorem: Theorem,
    hypotheses: Vec<Hypothesis>,
    branch: BranchExpansion,
    saddle_node: BifurcationCurve,
    period_doubling: BifurcationCurve,
}

impl ResonantGrazing {
    /// Checks the hypotheses of theorem 2.4 (for `p = 1`) or 2.5 (for `p >= 2`) and evaluates the
    /// conclusion.
    ///
    /// Theorem 2.4: `(tau, delta)` in the trapesium, `alpha > 0`, `beta != 0`, `a12 = 0`, `a12' !=
    /// 0`, `s_1^+- != 0`. Theorem 2.5: `p >= 2`, `(tau, delta)` in the trapesium, `a12 alpha > 0`,
    /// `beta != 0`, `kappa_p = 0`, `kappa_p' != 0`, `s_p^+- != 0`. Both also require what the class
    /// of systems implies: `omega > 0`, `gamma > 0`, `phi > 0`.
    ///
    /// `resonance_tolerance` is the largest `|a12|` (`p = 1`, position per radian) or `|kappa_p|`
    /// (`p >= 2`, dimensionless) that counts as zero. It should be the error with which the point
    /// is known: some 1e-12 for closed forms, otherwise the residual of the root-finding. The
    /// formulas are evaluated at the given point, so the coefficients are off by an amount
    /// proportional to it. Negative or NaN: no point passes.
    ///
    /// # Errors
    /// [`HypothesesViolated`] names each hypothesis that fails, with its value.
    pub fn check(point: &ResonantPoint, resonance_tolerance: f64) -> Result<Self, HypothesesViolated> {
        let map = &point.grazing.map;
        let stability = point.stability_coefficients();
        let resonance = ImposedCondition::Zero { tolerance: resonance_tolerance };
        let Unfolding { loops, derivative } = point.unfolding;
        let (theorem, at_resonance, unfolded) = if loops == 1 {
            (
                Theorem::ResonantOneLoop,
                Hypothesis::new(Quantity::OffDiagonal, map.a.m12, resonance),
                Hypothesis::non_zero(Quantity::OffDiagonalDerivative, derivative),
            )
        } else {
            let detuning = detuning(loops, map.trace(), map.determinant());
            (
                Theorem::ResonantMultiLoop,
                Hypothesis::new(Quantity::Detuning, detuning, resonance),
                Hypothesis::non_zero(Quantity::DetuningDerivative, derivative),
            )
        };
        let mut hypotheses = common_hypotheses(&point.grazing, theorem, loops);
        hypotheses.extend([
            Hypothesis::non_zero(Quantity::Transversality, map.transversality()),
            at_resonance,
            unfolded,
            Hypothesis::non_zero(Quantity::SaddleNodeStability, stability.plus),
            Hypothesis::non_zero(Quantity::PeriodDoublingStability, stability.minus),
        ]);
        let hypotheses = check(theorem, hypotheses)?;
        let branch = point.branch_expansion();
        let curve =
            |coefficient: f64, stability_coefficient: f64, impact_velocity_slope: f64| BifurcationCurve {
                coefficient,
                eta_side: Side::of(unfolded.value * stability_coefficient),
                impact_velocity_slope,
                impact_phase_slope: impact_velocity_slope * branch.k_1,
            };
        Ok(Self {
            theorem,
            hypotheses,
            branch,
            saddle_node: curve(
                point.saddle_node_coefficient(),
                stability.plus,
                point.saddle_node_velocity_slope(),
            ),
            period_doubling: curve(
                point.period_doubling_coefficient(),
                stability.minus,
                point.period_doubling_velocity_slope(),
            ),
        })
    }

    /// The theorem that applies.
    pub fn theorem(&self) -> Theorem {
        self.theorem
    }

    /// The hypotheses with their values; all of them hold.
    pub fn hypotheses(&self) -> &[Hypothesis] {
        &self.hypotheses
    }

    /// The branch of maximal periodic solutions near the resonance, to leading order.
    pub fn branch(&self) -> BranchExpansion {
        self.branch
    }

    /// The curve of saddle-node bifurcations: `sgn(eta) = sgn(a12' s_1^+)` or `sgn(kappa_p'
    /// s_p^+)`.
    pub fn saddle_node(&self) -> BifurcationCurve {
        self.saddle_node
    }

    /// The curve where a stability multiplier is -1, generically a curve of period-doubling
    /// bifurcations: `sgn(eta) = sgn(a12' s_1^-)` or `sgn(kappa_p' s_p^-)`.
    pub fn period_doubling(&self) -> BifurcationCurve {
        self.period_doubling
    }
}
