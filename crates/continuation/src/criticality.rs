//! The normal form of period doublings of solutions with impacts: the orbits that they create, and on which side.
//!
//! The impacts (y, z) of orbits with p loops from each to the next follow a map U. The two maps of
//! a [`LoopPair`](crate::mps::LoopPair) define it implicitly: L(U(X)) = R(X), where R leads through recoil and loops to
//! the plane of constant phase and L straight on. The orbits of double period lie on an invariant
//! curve X(s) through the impact X₀ of the MPS, on which U is a map g of one variable: R(X(s)) =
//! L(X(g(s))). Both are found order by order in s from the derivatives of L and R along curves
//! ([`ThirdOrder`]), with g in normal form; neither U nor the inverse of DL is formed. With several impacts
//! X is the first of them, R leads from it through all flights to the end of the last, and the impacts in
//! between are found order by order as well. With λ the multiplier, to leading order in s and in λ + 1,
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
//! proportion to 1/y. The formulas include no impact but those of the solution; where an orbit meets the
//! wall in between, as near a grazing bifurcation of the MPS, they hold for smaller s.

mod normal_form;

use grazing_model::ThirdOrder;
use grazing_model::smooth::{Scalar, Taylor};
use nalgebra::{Matrix2, Vector2};

use crate::arclength::zero_on;
use crate::curve::{Curve, CurvePoint, SolutionCurve};
use crate::locate::Condition;
use crate::mps::{Formulation, LoopEquations, PeriodicSolution, Round, Unknowns, planes, unknown};
use crate::newton::Root;
use crate::tolerances::LOCATED;
pub use normal_form::{Germ, ImplicitMap};

/// The reason why the normal form of a period doubling was not found.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum CriticalityError {
    /// y = 0: a solution has no multipliers there.
    #[error("the impact velocity is zero, where a periodic solution has no multipliers")]
    Grazing,
    /// The point is no zero of the equations.
    #[error(
        "there is no periodic solution: the two ways to the plane of comparison end {distance:.1e} apart"
    )]
    NotPeriodic {
        /// The distance; NaN if a solution escapes.
        distance: f64,
    },
    /// The solution does not have the multiplier −1.
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
    /// The eigenvector q for the multiplier −1 in (y, z) of the first impact, of length one and with q_y ≥ 0.
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
    let measure = |solution: Root<Unknowns>| {
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

/// The normal form of the period doubling of a solution with impacts.
///
/// `point` is (y, z, μ, η, y₂, …), located with
/// [`Condition::PERIOD_DOUBLING`](crate::locate::Condition::PERIOD_DOUBLING) in either formulation.
///
/// # Errors
/// No solution at the point, one without the multiplier −1, an impact without velocity, or another multiplier ±1.
pub fn period_doubling<O: ThirdOrder>(
    equations: &LoopEquations<O>,
    point: &Unknowns,
) -> Result<PeriodDoubling, CriticalityError> {
    let maps = flipping(equations, point)?;
    let oscillator = equations.oscillator_at(point);
    let planes = planes(point);
    let turns = f64::from(equations.loops()) * core::f64::consts::TAU;
    let derivatives: Vec<[Matrix2<f64>; 2]> = maps.derivatives().collect();
    let last = derivatives.len() - 1;
    let straight = |impact: Germ, index: usize| oscillator.to_phase_series(impact, planes[index]);
    let around = |[velocity, phase]: Germ, target: f64| {
        oscillator.to_phase_series(oscillator.reset_series(velocity, phase), target)
    };
    let mut product = Matrix2::identity();
    let mut inverses = Vec::with_capacity(last);
    for (index, [round_trip, impact]) in derivatives.iter().enumerate() {
        if index > 0 {
            let inverse = impact.try_inverse().ok_or(CriticalityError::Grazing)?;
            product = inverse * product;
            inverses.push(inverse);
        }
        product = round_trip * product;
    }
    let map = ImplicitMap {
        point: Vector2::new(point[unknown::VELOCITY], planes[0]),
        derivatives: [product, derivatives[0][1]],
        along: |first: Germ| {
            let mut here = first;
            for (index, inverse) in (1..).zip(&inverses) {
                let there = around(here, planes[index]);
                let near = [unknown::velocity(index), unknown::phase(index)];
                here = preimage(near.map(|it| point[it]), inverse, there, |impact| straight(impact, index));
            }
            [around(here, planes[0] + turns), straight(first, 0)]
        },
    };
    Ok(map.flip())
}

/// The curve whose image under a map with an inverse derivative is a given one, through a given point: each
/// step of Newton's method with that derivative makes one more order right.
fn preimage(at: [f64; 2], inverse: &Matrix2<f64>, image: Germ, map: impl Fn(Germ) -> Germ) -> Germ {
    let mut found = at.map(Taylor::constant);
    for _ in 0..Taylor::ORDER {
        let reached = map(found);
        let [x, y] = [0, 1].map(|k| (image[k] - reached[k]).movement());
        found = [0, 1].map(|k| found[k] + x.scale(inverse[(k, 0)]) + y.scale(inverse[(k, 1)]));
    }
    found
}

/// The maps at a solution with a simple multiplier −1 and no other ±1.
fn flipping<O: ThirdOrder>(
    equations: &LoopEquations<O>,
    point: &Unknowns,
) -> Result<Round, CriticalityError> {
    if (0..point.impacts()).any(|impact| point[unknown::velocity(impact)] == 0.0) {
        return Err(CriticalityError::Grazing);
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
