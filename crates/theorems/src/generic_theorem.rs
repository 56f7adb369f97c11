//! The side of a generic grazing bifurcation on which the maximal periodic solutions exist:
//! theorems 2.2 and 2.3 of the paper (section 2.5).

use crate::admissibility_boundary::admissibility_boundary;
use crate::auxiliary::detuning;
use crate::grazing::GrazingPoint;
use crate::hypothesis::{HypothesesViolated, Hypothesis, ImposedCondition, Quantity, Theorem, check};

/// A side of the bifurcation, as the sign of a parameter.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Side {
    /// The parameter is negative.
    Negative,
    /// The parameter is positive.
    Positive,
}

impl Side {
    /// The side on which a number other than zero lies.
    pub fn of(number: f64) -> Self {
        if number > 0.0 { Self::Positive } else { Self::Negative }
    }

    /// 1 or -1.
    pub fn signum(self) -> f64 {
        match self {
            Self::Negative => -1.0,
            Self::Positive => 1.0,
        }
    }
}

/// Theorems 2.2 and 2.3: a unique, unstable `p`-loop maximal periodic solution emanates from the
/// grazing bifurcation, on a known side of it.
///
/// A value of this type exists only if the hypotheses hold. Paper: `th:codim11` for `p = 1`,
/// `th:codim1p` for `p >= 2`.
///
/// The smoothness of `F` and `R` and assumption 2.1 (a periodic orbit that touches the wall once
/// per period) cannot be checked with numbers at one point and are up to the caller.
#[derive(Debug, Clone, PartialEq)]
pub struct GenericGrazing {
    hypotheses: Vec<Hypothesis>,
    side: Side,
}

impl GenericGrazing {
    /// Checks the hypotheses of theorem 2.2 (for `p = 1`) or 2.3 (otherwise).
    ///
    /// Theorem 2.2: `(tau, delta)` in the trapesium, `alpha > 0`, `a12 beta != 0`. Theorem 2.3:
    /// `p >= 2`, `(tau, delta)` in the trapesium, `a12 alpha > 0`, `tau > h_p(delta)`,
    /// `beta kappa_p != 0`. Both also require what the class of systems implies: `omega > 0`,
    /// `gamma > 0`, `phi > 0`.
    ///
    /// # Errors
    /// [`HypothesesViolated`] names each hypothesis that fails, with its value. `tau > h_p(delta)`
    /// is left out of the list where `h_p` has no value (`delta` outside (0, 1), or `p < 2`), which
    /// is then a violation itself.
    pub fn check(point: &GrazingPoint, p: u32) -> Result<Self, HypothesesViolated> {
        let a12 = point.map.a.m12;
        let beta = point.map.transversality();
        let (tau, delta) = (point.map.trace(), point.map.determinant());
        let (theorem, deciding) = if p == 1 {
            (
                Theorem::GenericOneLoop,
                Hypothesis::non_zero(Quantity::OffDiagonalTimesTransversality, a12 * beta),
            )
        } else {
            (
                Theorem::GenericMultiLoop,
                Hypothesis::non_zero(Quantity::TransversalityTimesDetuning, beta * detuning(p, tau, delta)),
            )
        };
        let mut hypotheses = common_hypotheses(point, theorem, p);
        if let (2.., Ok(boundary)) = (p, admissibility_boundary(p, delta)) {
            hypotheses.push(Hypothesis::positive(Quantity::AdmissibilityMargin, tau - boundary));
        }
        hypotheses.push(deciding);
        let hypotheses = check(theorem, hypotheses)?;
        Ok(Self { hypotheses, side: Side::of(deciding.value) })
    }

    /// The hypotheses with their values; all of them hold.
    pub fn hypotheses(&self) -> &[Hypothesis] {
        &self.hypotheses
    }

    /// The sign of `mu` for which the maximal periodic solution exists: that of `a12 beta` if `p =
    /// 1`, that of `beta kappa_p` if `p >= 2`.
    pub fn side(&self) -> Side {
        self.side
    }
}

/// The hypotheses that the four theorems share: the class of systems, the trapesium, the number of
/// loops for `p >= 2`, and the sign of `alpha` (`p = 1`) or of `a12 alpha` (`p >= 2`).
pub(crate) fn common_hypotheses(point: &GrazingPoint, theorem: Theorem, loops: u32) -> Vec<Hypothesis> {
    let (tau, delta) = (point.map.trace(), point.map.determinant());
    let alpha = point.alpha();
    let mut hypotheses = vec![
        Hypothesis::positive(Quantity::ForcingFrequency, point.forcing_frequency),
        Hypothesis::positive(Quantity::Deceleration, point.gamma),
        Hypothesis::positive(Quantity::Restitution, point.phi),
        Hypothesis::positive(Quantity::Determinant, delta),
        Hypothesis::positive(Quantity::Contraction, 1.0 - delta),
        Hypothesis::positive(Quantity::StabilityMargin, delta + 1.0 - tau.abs()),
    ];
    match theorem {
        Theorem::GenericOneLoop | Theorem::ResonantOneLoop => {
            hypotheses.push(Hypothesis::positive(Quantity::SquareRootFactor, alpha));
        }
        Theorem::GenericMultiLoop | Theorem::ResonantMultiLoop => hypotheses.extend([
            Hypothesis::new(Quantity::Loops, f64::from(loops), ImposedCondition::AtLeast(2)),
            Hypothesis::positive(Quantity::OffDiagonalTimesSquareRootFactor, point.map.a.m12 * alpha),
        ]),
    }
    hypotheses
}
