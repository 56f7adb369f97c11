//! Quadratic coefficients measured on the continued curves.

use grazing_model::ImpactOscillator;
use grazing_theorems::from_map::{GrazingOrbit, GrazingOrbitError};

use crate::locate::{Condition, LocateFailure, locate};
use crate::mps::{Memory, Unknowns, unknown};
use crate::resonance::ResonantGrazingPoint;

/// A coefficient could not be measured.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum FitError {
    /// A point of the curve was not found.
    #[error("no point of the curve at impact velocity {velocity}: {failure}")]
    NoPoint {
        /// The impact velocity asked for.
        velocity: f64,
        /// What happened.
        failure: LocateFailure,
    },
    /// The grazing orbit at the point's η was not found.
    #[error(transparent)]
    GrazingOrbit(#[from] GrazingOrbitError),
}

/// An extrapolated limit with an estimate of its error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// The limit.
    pub value: f64,
    /// Estimated absolute error: the difference of the last two extrapolations, or the rounding noise if that is larger.
    pub error: f64,
}

/// Points per fit. Each halves the impact velocity of the one before.
const LEVELS: usize = 9;

/// Impact velocities of the first point: small against the velocities (order one) at which the curves end, and smaller for forces
/// that change on shorter scales.
const FIRST_VELOCITIES: [f64; 6] = [0.04, 0.02, 0.01, 0.005, 0.0025, 0.00125];

/// Extrapolations from which the best one is taken.
const ATTEMPTS: usize = 3;

/// lim μ/η² along the SN or PD curve as it runs into the resonance.
///
/// The curve's equations are solved at a sequence of impact velocities that fall by halves, μ = primary − primary_graz(η)
/// and η are read off, and μ/η² is extrapolated to y = 0 by Neville's scheme, whose best entry is kept. The sequence is begun
/// at several velocities, and nearer to the resonance where the curve does not reach that far.
///
/// # Errors
/// A point of the curve or its grazing orbit was not found, even close to the resonance.
pub fn quadratic_coefficient<O: ImpactOscillator>(
    resonance: &ResonantGrazingPoint<O>,
    condition: Condition,
) -> Result<Estimate, FitError> {
    let mut best: Result<Estimate, FitError> = extrapolated_from(resonance, condition, FIRST_VELOCITIES[0]);
    let mut successes = usize::from(best.is_ok());
    for first in &FIRST_VELOCITIES[1..] {
        if successes == ATTEMPTS {
            break;
        }
        let next = extrapolated_from(resonance, condition, *first);
        successes += usize::from(next.is_ok());
        best = match (best, next) {
            (Ok(best), Ok(next)) => Ok(if next.error < best.error { next } else { best }),
            (Ok(best), Err(_)) => Ok(best),
            (Err(_), next) => next,
        };
    }
    best
}

/// The coefficient from impact velocities `first`, `first`/2, ….
fn extrapolated_from<O: ImpactOscillator>(
    resonance: &ResonantGrazingPoint<O>,
    condition: Condition,
    first: f64,
) -> Result<Estimate, FitError> {
    let origin = resonance.unknowns();
    let mut direction = resonance.direction(condition);
    direction /= direction[unknown::VELOCITY];
    let mut velocities = [first; LEVELS];
    for k in 1..LEVELS {
        velocities[k] = 0.5 * velocities[k - 1];
    }
    let mut ratios = [Estimate { value: 0.0, error: 0.0 }; LEVELS];
    for (velocity, ratio) in velocities.iter().zip(&mut ratios) {
        *ratio = ratio_at(resonance, condition, origin + direction * *velocity, *velocity)?;
    }
    Ok(extrapolate(&velocities, &ratios))
}

/// μ/η² at one point of the curve, with its rounding error.
fn ratio_at<O: ImpactOscillator>(
    resonance: &ResonantGrazingPoint<O>,
    condition: Condition,
    near: Unknowns,
    velocity: f64,
) -> Result<Estimate, FitError> {
    let equations = resonance.equations();
    let conditions = [condition, Condition::ImpactVelocity(velocity)];
    let point = locate(equations, conditions, near, &mut Memory::default())
        .map_err(|failure| FitError::NoPoint { velocity, failure })?;
    let orbit = GrazingOrbit::find(&equations.oscillator_at(&point), resonance.orbit().phase())?;
    let eta = point[unknown::SECONDARY] - resonance.unknowns()[unknown::SECONDARY];
    let mu = point[unknown::PRIMARY] - orbit.primary();
    let value = mu / (eta * eta);
    let relative = |scale: f64, size: f64| 4.0 * f64::EPSILON * scale.abs() / size.abs();
    let noise = relative(orbit.primary(), mu) + 2.0 * relative(point[unknown::SECONDARY], eta);
    Ok(Estimate { value, error: value.abs() * noise })
}

/// Neville's extrapolation to zero; the entry with the least estimated error.
fn extrapolate(at: &[f64; LEVELS], values: &[Estimate; LEVELS]) -> Estimate {
    let mut best = Estimate { error: f64::INFINITY, ..values[0] };
    let mut column = *values;
    for order in 1..LEVELS {
        let mut next = column;
        for i in order..LEVELS {
            let weight = at[i] / (at[i - order] - at[i]);
            let value = column[i].value + weight * (column[i].value - column[i - 1].value);
            let noise = (1.0 + weight) * column[i].error + weight * column[i - 1].error;
            let difference = (value - column[i].value).abs().max((value - column[i - 1].value).abs());
            next[i] = Estimate { value, error: noise };
            if difference.max(noise) < best.error {
                best = Estimate { value, error: difference.max(noise) };
            }
        }
        column = next;
    }
    best
}
