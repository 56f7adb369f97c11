//! Generalised period doublings: where the criticality changes along a curve of period doublings.

use grazing_model::ThirdOrder;
use grazing_model::maps::MapError;

use super::{CriticalityError, PeriodDoubling, period_doubling};
use crate::curve::CurvePoint;
use crate::locate::{Condition, conditioned};
use crate::mps::{Formulation, LoopEquations, Memory, Unknowns, unknown};
use crate::newton::{self, NewtonFailure};

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

/// Newton's method starts within a step of the curve, and needs a few evaluations.
const LIMIT: usize = 25;

/// Evaluations of c; the Illinois method needs about ten, and near a pole all are in vain.
const EVALUATIONS: usize = 50;

/// y² c ends the search below this, a few roundings of terms of order one.
const ROUNDING: f64 = 1e-14;

/// y² c counts as zero below this, where the rounding is worse: c loses digits in proportion to 1/y.
const ZERO: f64 = 1e-9;

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
            let (unknowns, normal_form) = between(&equations, [a, b], [at_a, at_b])?;
            Ok(GeneralisedPeriodDoubling { unknowns, normal_form, index })
        })
        .collect()
}

/// The zero of c between two points of a curve with the values given, by the Illinois variant of regula falsi.
fn between<O: ThirdOrder>(
    equations: &LoopEquations<O>,
    [a, b]: [Unknowns; 2],
    values: [f64; 2],
) -> Result<(Unknowns, PeriodDoubling), NotDegenerate> {
    let chord = b - a;
    let at = |share: f64| -> Result<(Unknowns, PeriodDoubling), NotDegenerate> {
        let start = a + chord * share;
        let mut memory = Memory::default();
        let solution = newton::solve(start, LIMIT, |point| {
            let condition = Condition::PERIOD_DOUBLING;
            let (mut system, _) = conditioned(equations, condition, true, point, &mut memory)?;
            system.residual[3] = chord.dot(&(point - start));
            system.jacobian.set_row(3, &chord.transpose());
            Ok::<_, MapError>(system)
        })?;
        Ok((solution.point, period_doubling(equations, &solution.point)?))
    };
    let ([mut low, mut high], [mut at_low, mut at_high]) = ([0.0, 1.0], values);
    let mut coefficient = at_high;
    for evaluation in 1..=EVALUATIONS {
        let share = (low * at_high - high * at_low) / (at_high - at_low);
        let (unknowns, normal_form) = at(share)?;
        coefficient = normal_form.coefficient;
        let velocity = unknowns[unknown::VELOCITY];
        let size = (velocity * velocity * coefficient).abs();
        let last = evaluation == EVALUATIONS || share == high;
        if size < ROUNDING || (last && size < ZERO) {
            return Ok((unknowns, normal_form));
        }
        // The end that stays counts half, so that both ends come close.
        if coefficient * at_high < 0.0 {
            (low, at_low) = (high, at_high);
        } else {
            at_low *= 0.5;
        }
        (high, at_high) = (share, coefficient);
    }
    Err(NotDegenerate::NoZero { coefficient })
}
