//! The normal form of period doublings of MPSs: the orbits that they create, and on which side.
//!
//! The impacts (y, z) of orbits with p loops from each to the next follow a map U. The two maps of
//! a [`LoopPair`](crate::mps::LoopPair) define it implicitly: L(U(X)) = R(X), where R leads through recoil and loops to
//! the plane of constant phase and L straight on. The orbits of double period lie on an invariant
//! curve X(s) through the impact X₀ of the MPS, on which U is a map g of one variable: R(X(s)) =
//! L(X(g(s))). Both are found order by order in s from the derivatives of L and R along curves
//! ([`ThirdOrder`]), with g in normal form; neither U nor the inverse of DL is formed. With λ the
//! multiplier, to leading order in s and in λ + 1,
//!
//! ```text
//! g(s) = λ s + c s³,   c = ⅙ ⟨p, C(q, q, q)⟩ + ½ ⟨p, B(q, (I − A)⁻¹ B(q, q))⟩,
//! ```
//!
//! where A = DU, B = D²U, C = D³U at X₀, A q = −q, Aᵀp = −p and ⟨p, q⟩ = 1.
//!
//! Source: Yu. A. Kuznetsov, *Elements of Applied Bifurcation Theory*, chapter 5, centre manifolds
//! of maps. The paper mentions criticality without a formula, in section 6.
//!
//! **Domain.** y ≠ 0: towards a resonance the pair of maps stays smooth, but DL becomes singular
//! and all of U is compressed into |s| of the order of y, so that y² c tends to a limit, the limit
//! map's [`criticality`](grazing_theorems::LimitMap::criticality). Digits of c are then lost in
//! proportion to 1/y. The formulas include no impact but those of the MPS; where an orbit meets the
//! wall in between, as near a grazing bifurcation of the MPS, they hold for smaller s.

mod normal_form;

use grazing_model::ThirdOrder;
use nalgebra::Vector2;

use crate::arclength::zero_on;
use crate::curve::{Curve, CurvePoint, SolutionCurve};
use crate::locate::Condition;
use crate::mps::{Formulation, LoopEquations, PeriodicSolution, Round, Unknowns, planes, unknown};
use crate::newton::Solution;
use crate::tolerances::LOCATED;
pub use normal_form::{Germ, ImplicitMap};

/// The reason why the normal form of a period doubling was not found.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum CriticalityError {
    /// y = 0: an MPS has no multipliers there.
    #[error("the impact velocity is zero, where a maximal periodic solution has no multipliers")]
    Grazing,
    /// There are several impacts, for which no normal form is known here.
    #[error("the normal form is computed for solutions with one impact")]
    SeveralImpacts,
    /// The point is no zero of the equations.
    #[error(
        "there is no maximal periodic solution: the two ways to the plane of comparison end {distance:.1e} apart"
    )]
    NotPeriodic {
        /// The distance; NaN if a solution escapes.
        distance: f64,
    },
    /// The MPS does not have the multiplier −1.
    #[error("the multiplier next to -1 is {distance:.1e} away from it")]
    NotABifurcation {
        /// The distance of the nearest multiplier from −1, to leading order.
        distance: f64,
    },
    /// Both multipliers lie on the unit circle: a bifurcation of higher codimension.
    #[error("both multipliers lie on the unit circle: -1 and {other}")]
    Degenerate {
        /// The other multiplier.
        other: f64,
    },
}

/// The normal form of a period doubling: g(s) = λ s + c s³.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PeriodDoubling {
    /// The eigenvector q for the multiplier −1 in (y, z), of length one and with q_y ≥ 0.
    pub direction: Vector2<f64>,
    /// The coefficient c, positive where the bifurcation is supercritical.
    pub coefficient: f64,
}

impl PeriodDoubling {
    /// Whether stable orbits of double period are created beside the unstable MPS, rather than
    /// unstable ones beside the stable MPS.
    ///
    /// Stability is along the curve X(s): across it the other multiplier decides, in the same way
    /// for both.
    pub fn supercritical(&self) -> bool {
        self.coefficient > 0.0
    }
}

/// The points of a curve of period doublings at which criticality changes (generalised period
/// doublings), in the order of the curve. Two within one step are missed.
pub fn changes<O: ThirdOrder>(equations: &LoopEquations<O>, curve: &Curve) -> Vec<PeriodicSolution> {
    let equations = equations.with_formulation(Formulation::FixedPhase);
    let flips = SolutionCurve { equations: equations.clone(), condition: Condition::PERIOD_DOUBLING };
    let measure = |solution: Solution<Unknowns>| {
        let form = period_doubling(&equations, &solution.point).ok()?;
        let velocity = solution.point[unknown::VELOCITY] / form.direction[0];
        let value = velocity * velocity * form.coefficient;
        Some(((solution.point, value), value))
    };
    let change = |pair: &[CurvePoint]| {
        let ends = [0, 1].map(|k: usize| pair[k].solution.unknowns.clone());
        let (point, value) = zero_on(&flips, ends, measure, 0.0)?;
        // The coefficient may also change sign through infinity.
        (value.abs() < LOCATED).then(|| equations.solution(&point))
    };
    curve.points.windows(2).filter_map(change).collect()
}

/// The normal form of the period doubling of an MPS.
///
/// `point` is (y, z, μ, η), located with
/// [`Condition::PERIOD_DOUBLING`](crate::locate::Condition::PERIOD_DOUBLING) in either formulation.
///
/// # Errors
/// No MPS at the point, one without the multiplier −1, y = 0, or another multiplier ±1.
pub fn period_doubling<O: ThirdOrder>(
    equations: &LoopEquations<O>,
    point: &Unknowns,
) -> Result<PeriodDoubling, CriticalityError> {
    let maps = flipping(equations, point)?;
    let pair = maps.first();
    let oscillator = equations.oscillator_at(point);
    let plane = point[unknown::PHASE];
    let turns = f64::from(equations.loops()) * core::f64::consts::TAU;
    let map = ImplicitMap {
        point: Vector2::new(point[unknown::VELOCITY], plane),
        derivatives: [pair.round_trip.derivative(), pair.impact.derivative()],
        along: |[velocity, phase]: Germ| {
            let recoil = oscillator.reset_series(velocity, phase);
            [
                oscillator.to_phase_series(recoil, plane + turns),
                oscillator.to_phase_series([velocity, phase], plane),
            ]
        },
    };
    Ok(map.flip())
}

/// The maps at an MPS with a simple multiplier −1 and no other ±1.
fn flipping<O: ThirdOrder>(
    equations: &LoopEquations<O>,
    point: &Unknowns,
) -> Result<Round, CriticalityError> {
    if point[unknown::VELOCITY] == 0.0 {
        return Err(CriticalityError::Grazing);
    }
    if point.impacts() > 1 {
        return Err(CriticalityError::SeveralImpacts);
    }
    let maps = equations.fixed_phase_maps::<1>(point, &planes(point), &equations.flights(point));
    let distance = maps.distance();
    if distance.is_nan() || distance > LOCATED {
        return Err(CriticalityError::NotPeriodic { distance });
    }
    // With the multipliers λ₁ and λ₂: 1 + T + D is (1 + λ₁)(1 + λ₂).
    let multipliers = maps.multipliers();
    let other = -multipliers.determinant;
    if [1.0, -1.0].into_iter().any(|unit| (other - unit).abs() < LOCATED) {
        return Err(CriticalityError::Degenerate { other });
    }
    let product = 1.0 + multipliers.trace + multipliers.determinant;
    let distance = (product / (1.0 + other)).abs();
    if distance.is_nan() || distance > LOCATED {
        return Err(CriticalityError::NotABifurcation { distance });
    }
    Ok(maps)
}
