//! Ranges, and what the checks of all sections share.

use std::ops::RangeInclusive;

use grazing_source::{Section, SourceError};
use grazing_theorems::{GrazingState, LinearOscillator};

use super::requirements::{LEAST_FREQUENCY, MOST_AMPLITUDE, MOST_FREQUENCY};

/// Whether a number lies in a range [lower, upper], its ends included; never for NaN.
pub fn contains([lower, upper]: [f64; 2], value: f64) -> bool {
    lower <= value && value <= upper
}

/// Whether a number lies in a range, its ends excluded.
pub fn strictly_contains([lower, upper]: [f64; 2], value: f64) -> bool {
    lower < value && value < upper
}

/// Whether all of the inner range lies in the outer one.
pub fn encloses(outer: [f64; 2], inner: [f64; 2]) -> bool {
    outer[0] <= inner[0] && inner[1] <= outer[1]
}

/// A damping ratio.
pub(super) fn damping_ratio(section: &Section<'_>) -> Result<f64, SourceError> {
    section.number("zeta", |zeta| strictly_contains([0.0, 1.0], zeta))
}

/// A coefficient of restitution.
pub(super) fn restitution(section: &Section<'_>) -> Result<f64, SourceError> {
    section.number("epsilon", |epsilon| 0.0 < epsilon && epsilon <= 1.0)
}

/// A forcing frequency.
pub(super) fn frequency(section: &Section<'_>) -> Result<f64, SourceError> {
    section.number("frequency", |frequency| contains([LEAST_FREQUENCY, MOST_FREQUENCY], frequency))
}

/// The grazing bifurcation at the section's forcing frequency.
pub(super) fn grazing(
    section: &Section<'_>,
    oscillator: &LinearOscillator,
    frequency: f64,
) -> Result<GrazingState, SourceError> {
    oscillator.grazing(frequency).map_err(|error| section.forbid("frequency", error.to_string()))
}

/// A range of quantities, none of which is beyond all amplitudes, that passes the test.
pub(super) fn range(
    section: &Section<'_>,
    name: &str,
    holds: impl Fn([f64; 2]) -> bool,
) -> Result<[f64; 2], SourceError> {
    const POSSIBLE: [f64; 2] = [-MOST_AMPLITUDE, MOST_AMPLITUDE];
    section.numbers(name, |range| range[0] < range[1] && encloses(POSSIBLE, range) && holds(range))
}

/// Any range of possible quantities.
pub(super) fn any(_: [f64; 2]) -> bool {
    true
}

/// A range that has 0 strictly inside.
pub(super) fn around_zero(section: &Section<'_>, name: &str) -> Result<[f64; 2], SourceError> {
    range(section, name, |range| strictly_contains(range, 0.0))
}

/// A range of forcing amplitudes.
pub(super) fn amplitudes(section: &Section<'_>, name: &str) -> Result<[f64; 2], SourceError> {
    range(section, name, |[lower, _]| lower >= 0.0)
}

/// A range inside another one, which is named in the refusal.
pub(super) fn range_inside(
    section: &Section<'_>,
    name: &str,
    outer_key: &str,
    outer: [f64; 2],
) -> Result<[f64; 2], SourceError> {
    let inner = range(section, name, any)?;
    if encloses(outer, inner) {
        return Ok(inner);
    }
    let [lower, upper] = outer;
    Err(section.forbid(name, format!("the range must lie inside {outer_key} = [{lower}, {upper}]")))
}

/// The tables of a list, as many as are allowed.
pub(super) fn tables<'d>(
    section: &Section<'d>,
    name: &str,
    allowed: RangeInclusive<usize>,
) -> Result<Vec<Section<'d>>, SourceError> {
    let tables = section.tables(name)?;
    if allowed.contains(&tables.len()) { Ok(tables) } else { Err(section.refusal(name)) }
}
