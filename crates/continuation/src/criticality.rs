//! Normal forms of saddle-node and period-doubling bifurcations of MPSs: what they create, and on which side.
//!
//! The impacts (y, z) of orbits with p loops from each to the next follow a map U. The two maps of a [`LoopPair`] define it
//! implicitly: L(U(X)) = R(X), where R leads through recoil and loops to the plane of constant phase and L straight on. What a
//! bifurcation creates lies on an invariant curve X(s) through the impact X₀ of the MPS, on which U is a map g of one variable:
//! R(X(s)) = L(X(g(s))). Both are found order by order in s from the derivatives of L and R along curves ([`ThirdOrder`]), with g
//! in normal form; neither U nor the inverse of DL is formed.
//!
//! | bifurcation | multiplier λ | g(s), to leading order in s and in the change δ of (μ, η) |
//! |---|---|---|
//! | saddle-node | 1 | s + b·δ + a s² |
//! | period doubling | −1 | (−1 + λ'·δ) s + c s³ |
//!
//! With A = DU, B = D²U, C = D³U at X₀, A q = λq, Aᵀp = λp and ⟨p, q⟩ = 1,
//!
//! ```text
//! a = ½ ⟨p, B(q, q)⟩,   c = ⅙ ⟨p, C(q, q, q)⟩ + ½ ⟨p, B(q, (I − A)⁻¹ B(q, q))⟩.
//! ```
//!
//! Source: Yu. A. Kuznetsov, *Elements of Applied Bifurcation Theory*, chapter 5, centre manifolds of maps. The paper speaks of
//! criticality without a formula, in section 6.
//!
//! **Domain.** y ≠ 0: towards a resonance the pair of maps stays smooth, but DL becomes singular and all of U is compressed into
//! |s| of the order of y, so that y a and y² c tend to limits. Digits of c are then lost in proportion to 1/y. The formulas
//! know of no impact but those of the MPS; where an orbit meets the wall in between, as near a grazing bifurcation of the MPS, they
//! hold for the smaller s.

mod at_resonance;
pub mod codimension_two;
mod normal_form;

pub use at_resonance::coefficient_at_resonance;

use grazing_model::{MapJet, ThirdOrder};
use nalgebra::{Matrix2, Vector2, Vector4};

use crate::mps::{LoopEquations, LoopPair, Unknowns, unknown};
use crate::tolerances::LOCATED;
use normal_form::{ImplicitMap, solved};

/// The normal form of a bifurcation was not found.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum CriticalityError {
    /// y = 0: an MPS has no multipliers there.
    #[error("the impact velocity is zero, where a maximal periodic solution has no multipliers")]
    Grazing,
    /// The point is no zero of the equations.
    #[error(
        "there is no maximal periodic solution: the two ways to the plane of comparison end {distance:e} apart"
    )]
    NotPeriodic {
        /// The distance; NaN if a solution escapes.
        distance: f64,
    },
    /// The MPS does not have the multiplier.
    #[error("the multiplier next to {multiplier} is {distance:e} away from it")]
    NotABifurcation {
        /// 1 or −1.
        multiplier: f64,
        /// How far the MPS's own is from it, to leading order.
        distance: f64,
    },
    /// Both multipliers lie on the unit circle: a bifurcation of higher codimension.
    #[error("both multipliers lie on the unit circle: {multiplier} and {other}")]
    Degenerate {
        /// 1 or −1.
        multiplier: f64,
        /// The other one.
        other: f64,
    },
}

/// The normal form of a period doubling: g(s) = (−1 + λ'·δ) s + c s³.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PeriodDoubling {
    /// q, the eigenvector to the multiplier −1 in (y, z), of length one and with q_y ≥ 0.
    pub direction: Vector2<f64>,
    /// h in X(s) = X₀ + q s + h s² + O(s³), the curve on which the impacts of the doubled orbits lie: h = ½ (I − A)⁻¹ B(q, q).
    pub bend: Vector2<f64>,
    /// c; positive where the bifurcation is supercritical.
    pub coefficient: f64,
    /// λ', the derivatives of the multiplier in μ and η along the family of MPSs. The doubled orbits are where s² = −λ'·δ/c.
    pub multiplier_slopes: Vector2<f64>,
}

impl PeriodDoubling {
    /// Stable orbits of double period are created beside the unstable MPS; otherwise unstable ones beside the stable MPS.
    ///
    /// Stability is along the curve X(s): across it the other multiplier decides, for both alike.
    pub fn supercritical(&self) -> bool {
        self.coefficient > 0.0
    }
}

/// The normal form of a saddle-node bifurcation: g(s) = s + b·δ + a s².
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SaddleNode {
    /// q, the eigenvector to the multiplier 1 in (y, z), of length one and with q_y ≥ 0.
    pub direction: Vector2<f64>,
    /// a, whose sign depends on that of q; zero at a cusp.
    pub coefficient: f64,
    /// b, in μ and η. There are two MPSs where a b·δ < 0, at s² = −b·δ/a, and none on the other side.
    pub parameter_slopes: Vector2<f64>,
}

/// The normal form of the period doubling of an MPS.
///
/// c = ⅙ ⟨p, C(q, q, q)⟩ + ½ ⟨p, B(q, (I − A)⁻¹ B(q, q))⟩ in the module's notation. `point` is (y, z, μ, η), located with
/// [`Condition::PERIOD_DOUBLING`](crate::locate::Condition::PERIOD_DOUBLING) in either formulation.
///
/// # Errors
/// No MPS at the point, one without the multiplier −1, y = 0, or another multiplier ±1.
pub fn period_doubling<O: ThirdOrder>(
    equations: &LoopEquations<O>,
    point: &Unknowns,
) -> Result<PeriodDoubling, CriticalityError> {
    let pair = bifurcation(equations, point, -1.0)?;
    let flip = implicit_map(equations, point, &pair).flip();
    let difference = pair.round_trip.derivative() - pair.impact.derivative();
    let multiplier_slopes = Vector2::from_fn(|k, _| {
        // The MPS moves by v with the parameter, (DR − DL) v = L' − R', and with both ℓᵀ(DR + DL) q, which is λ'.
        let parameter = unknown::PRIMARY + k;
        let column = |jet: &MapJet| jet.jacobian.column(parameter).into_owned();
        let moved = solved(&difference, column(&pair.impact) - column(&pair.round_trip));
        let mut along = Vector4::new(moved[0], moved[1], 0.0, 0.0);
        along[parameter] = 1.0;
        let turned = derivative_along(&pair.round_trip, &along) + derivative_along(&pair.impact, &along);
        flip.covector.dot(&(turned * flip.direction))
    });
    Ok(PeriodDoubling {
        direction: flip.direction,
        bend: flip.bend,
        coefficient: flip.coefficient,
        multiplier_slopes,
    })
}

/// The normal form of the saddle-node bifurcation of MPSs.
///
/// a = ½ ⟨p, B(q, q)⟩ and b = ⟨p, ∂U/∂(μ, η)⟩ in the module's notation. `point` is (y, z, μ, η), located with
/// [`Condition::SADDLE_NODE`](crate::locate::Condition::SADDLE_NODE) in either formulation.
///
/// # Errors
/// No MPS at the point, one without the multiplier 1, y = 0, or another multiplier ±1.
pub fn saddle_node<O: ThirdOrder>(
    equations: &LoopEquations<O>,
    point: &Unknowns,
) -> Result<SaddleNode, CriticalityError> {
    let pair = bifurcation(equations, point, 1.0)?;
    let fold = implicit_map(equations, point, &pair).fold();
    let parameter_slopes = Vector2::from_fn(|k, _| {
        let column = |jet: &MapJet| jet.jacobian.column(unknown::PRIMARY + k).into_owned();
        fold.covector.dot(&(column(&pair.round_trip) - column(&pair.impact)))
    });
    Ok(SaddleNode { direction: fold.direction, coefficient: fold.coefficient, parameter_slopes })
}

/// The pair of maps at an MPS with a simple multiplier ±1 and no other.
fn bifurcation<O: ThirdOrder>(
    equations: &LoopEquations<O>,
    point: &Unknowns,
    multiplier: f64,
) -> Result<LoopPair, CriticalityError> {
    if point[unknown::VELOCITY] == 0.0 {
        return Err(CriticalityError::Grazing);
    }
    let pair = equations.fixed_phase_pair::<2>(point, point[unknown::PHASE]);
    let distance = (pair.round_trip.value - pair.impact.value).norm();
    if distance.is_nan() || distance > LOCATED {
        return Err(CriticalityError::NotPeriodic { distance });
    }
    // With the multipliers λ and D/λ: (1 − λT + D) for λ = ±1 is (λ − λ₁)(λ − λ₂), which vanishes with λ − λ₁.
    let multipliers = pair.multipliers();
    let other = multiplier * multipliers.determinant;
    if [multiplier, -multiplier].into_iter().any(|unit| (other - unit).abs() < LOCATED) {
        return Err(CriticalityError::Degenerate { multiplier, other });
    }
    let product = 1.0 - multiplier * multipliers.trace + multipliers.determinant;
    let distance = (product / (multiplier - other)).abs();
    if distance.is_nan() || distance > LOCATED {
        return Err(CriticalityError::NotABifurcation { multiplier, distance });
    }
    Ok(pair)
}

/// U near the impact of an MPS: R and L along curves, with their derivatives.
fn implicit_map<O: ThirdOrder>(
    equations: &LoopEquations<O>,
    point: &Unknowns,
    pair: &LoopPair,
) -> ImplicitMap<impl Fn(normal_form::Germ) -> [normal_form::Germ; 2]> {
    let oscillator = equations.oscillator_at(point);
    let plane = point[unknown::PHASE];
    let turns = f64::from(equations.loops()) * core::f64::consts::TAU;
    ImplicitMap {
        point: Vector2::new(point[unknown::VELOCITY], plane),
        derivatives: [pair.round_trip.derivative(), pair.impact.derivative()],
        along: move |[velocity, phase]: normal_form::Germ| {
            let recoil = oscillator.reset_series(velocity, phase);
            [
                oscillator.to_phase_series(recoil, plane + turns),
                oscillator.to_phase_series([velocity, phase], plane),
            ]
        },
    }
}

/// The derivative, in the direction `along` of (y, z, μ, η), of a map's derivative in the coordinates.
fn derivative_along(jet: &MapJet, along: &Vector4<f64>) -> Matrix2<f64> {
    Matrix2::from_fn(|i, j| jet.hessians[i].row(j).dot(&along.transpose()))
}
