//! Ranges, and what the checks of all sections share.

use std::ops::RangeInclusive;

use grazing_source::{Section, SourceError};
use grazing_theorems::{GrazingState, LinearOscillator};
use toml::Spanned;

use super::requirements::{LEAST_FREQUENCY, MOST_AMPLITUDE, MOST_FREQUENCY, MOST_LOOPS};

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

/// A number that is finite and passes the test.
pub(super) fn number(
    section: &Section<'_>,
    name: &str,
    holds: impl Fn(f64) -> bool,
) -> Result<f64, SourceError> {
    let number: f64 = section.value(name)?;
    if number.is_finite() && holds(number) { Ok(number) } else { Err(section.refusal(name)) }
}

/// A whole number.
pub(super) fn count(
    section: &Section<'_>,
    name: &str,
    allowed: RangeInclusive<u32>,
) -> Result<u32, SourceError> {
    let count = section.value(name)?;
    if allowed.contains(&count) { Ok(count) } else { Err(section.refusal(name)) }
}

/// A damping ratio.
pub(super) fn damping_ratio(section: &Section<'_>) -> Result<f64, SourceError> {
    number(section, "zeta", |zeta| strictly_contains([0.0, 1.0], zeta))
}

/// A coefficient of restitution.
pub(super) fn restitution(section: &Section<'_>) -> Result<f64, SourceError> {
    number(section, "epsilon", |epsilon| 0.0 < epsilon && epsilon <= 1.0)
}

/// A forcing frequency.
pub(super) fn frequency(section: &Section<'_>) -> Result<f64, SourceError> {
    number(section, "frequency", |frequency| contains([LEAST_FREQUENCY, MOST_FREQUENCY], frequency))
}

/// The grazing bifurcation at the section's forcing frequency.
pub(super) fn grazing(
    section: &Section<'_>,
    oscillator: &LinearOscillator,
    frequency: f64,
) -> Result<GrazingState, SourceError> {
    oscillator.grazing(frequency).map_err(|error| section.forbid("frequency", error.to_string()))
}

/// A list of N finite numbers that passes the test.
pub(super) fn numbers<const N: usize>(
    section: &Section<'_>,
    name: &str,
    holds: impl Fn([f64; N]) -> bool,
) -> Result<[f64; N], SourceError> {
    // For an array the reader would take the first N numbers and drop the rest.
    let written: Vec<f64> = section.value(name)?;
    <[f64; N]>::try_from(written)
        .ok()
        .filter(|list| list.iter().all(|number| number.is_finite()) && holds(*list))
        .ok_or_else(|| section.refusal(name))
}

/// A range of quantities, none of which is beyond all amplitudes, that passes the test.
pub(super) fn range(
    section: &Section<'_>,
    name: &str,
    holds: impl Fn([f64; 2]) -> bool,
) -> Result<[f64; 2], SourceError> {
    const POSSIBLE: [f64; 2] = [-MOST_AMPLITUDE, MOST_AMPLITUDE];
    numbers(section, name, |range| range[0] < range[1] && encloses(POSSIBLE, range) && holds(range))
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

/// The numbers of loops that a section lists: some, none twice, each from `least` on.
pub(super) fn loops(section: &Section<'_>, least: u32) -> Result<Vec<u32>, SourceError> {
    const NAME: &str = "loops";
    let mut numbers = Vec::new();
    for written in section.value::<Vec<Spanned<u32>>>(NAME)? {
        let p = *written.get_ref();
        if !(least..=MOST_LOOPS).contains(&p) {
            return Err(section.refusal_of(NAME, &written));
        }
        if numbers.contains(&p) {
            return Err(section.forbid(NAME, format!("{p} is listed twice: list each number once")));
        }
        numbers.push(p);
    }
    if numbers.is_empty() { Err(section.refusal(NAME)) } else { Ok(numbers) }
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
