//! Generalised period doublings: where the criticality changes along a curve of period doublings.

use grazing_model::ThirdOrder;
use grazing_model::maps::MapError;

use super::{CriticalityError, PeriodDoubling, period_doubling};
use crate::curve::CurvePoint;
use crate::locate::{Condition, across_chord};
use crate::mps::{Formulation, LoopEquations, Unknowns, unknown};
use crate::newton::NewtonFailure;
use crate::regula_falsi::zero_between;
use crate::tolerances::{NO_COEFFICIENT, NO_COEFFICIENT_AT_LAST};

/// A point of codimension two at which c = 0: a curve of saddle-nodes of doubled orbits ends there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GeneralisedPeriodDoubling {
    /// (y, z, μ, η).
    pub unknowns: Unknowns,
    /// The normal form there, with c zero to rounding.
    pub normal_form: PeriodDoubling,
    /// Index of the first point of the curve beyond.
    pub index: usize,
}

/// c changes its sign between two points, and no zero was found.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum NotDegenerate {
    /// No period doubling was found on the way.
    #[error(transparent)]
    Newton(#[from] NewtonFailure<MapError>),
    /// There is no normal form on the way, as where the other multiplier becomes ±1.
    #[error(transparent)]
    Criticality(#[from] CriticalityError),
    /// The coefficient does not become small, as at a pole.
    #[error("the coefficient changes its sign, and is {coefficient} where it should be zero")]
    NoZero {
        /// c where the search ended.
        coefficient: f64,
    },
}

/// The generalised period doublings between successive points of a curve of period doublings, where c changes its sign.
///
/// `points` are those of a [`Curve`](crate::curve::Curve) with [`Condition::PERIOD_DOUBLING`]; points without a normal form, such as
/// the resonance at which the curve begins, are passed over. In between the curve is met with planes across the chord. Two changes of
/// sign within one step are not seen.
pub fn generalised_period_doublings<O: ThirdOrder>(
    equations: &LoopEquations<O>,
    points: &[CurvePoint],
) -> Vec<Result<GeneralisedPeriodDoubling, NotDegenerate>> {
    let equations = equations.with_formulation(Formulation::FixedPhase);
    let coefficients: Vec<(usize, Unknowns, f64)> = points
        .iter()
        .enumerate()
        .filter_map(|(index, point)| {
            let unknowns = point.solution.unknowns;
            Some((index, unknowns, period_doubling(&equations, &unknowns).ok()?.coefficient))
        })
        .collect();
    coefficients
        .windows(2)
        .filter(|ends| ends[0].2 * ends[1].2 < 0.0)
        .map(|ends| {
            let [(_, a, at_a), (index, b, at_b)] = [ends[0], ends[1]];
            let (unknowns, normal_form) = zero_of_coefficient(&equations, [a, b], [at_a, at_b])?;
            Ok(GeneralisedPeriodDoubling { unknowns, normal_form, index })
        })
        .collect()
}

/// The zero of c between two points of a curve with the values given.
fn zero_of_coefficient<O: ThirdOrder>(
    equations: &LoopEquations<O>,
    ends: [Unknowns; 2],
    values: [f64; 2],
) -> Result<(Unknowns, PeriodDoubling), NotDegenerate> {
    let at = |share: f64| -> Result<_, NotDegenerate> {
        let point = across_chord(equations, Condition::PERIOD_DOUBLING, ends, share)?.point;
        let normal_form = period_doubling(equations, &point)?;
        Ok(((point, normal_form), normal_form.coefficient))
    };
    let size = |point: &Unknowns, coefficient: f64| {
        let velocity = point[unknown::VELOCITY];
        (velocity * velocity * coefficient).abs()
    };
    let enough = |(point, _): &(Unknowns, _), value: f64| size(point, value) < NO_COEFFICIENT;
    let (point, normal_form) = zero_between(values, at, enough)?;
    let coefficient = normal_form.coefficient;
    if size(&point, coefficient) < NO_COEFFICIENT_AT_LAST {
        return Ok((point, normal_form));
    }
    Err(NotDegenerate::NoZero { coefficient })
}
