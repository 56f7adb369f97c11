//! What the checks of all sections share.

use std::ops::RangeInclusive;

use grazing_source::Source;
use toml::Spanned;

use super::ParameterError;
use super::range::Range;
use super::requirements::{LEAST_FREQUENCY, MOST_AMPLITUDE, MOST_FREQUENCY, MOST_LOOPS, requirement};

pub(super) type Checked<T> = Result<T, ParameterError>;

/// The refusal of a value with the key's requirement.
pub(super) fn refusal<T>(source: &Source<'_>, key: &str, place: &Spanned<T>) -> ParameterError {
    source.forbid(key, place, requirement(key).to_owned()).into()
}

/// The refusal of a value that is at odds with others in the same section.
pub(super) fn refused<T>(
    source: &Source<'_>,
    key: &str,
    place: &Spanned<T>,
    allowed: String,
) -> ParameterError {
    source.forbid(key, place, allowed).into()
}

/// The refusal of a value that another oscillator would allow.
pub(super) fn unfit<T>(
    source: &Source<'_>,
    key: &str,
    place: &Spanned<T>,
    allowed: String,
) -> ParameterError {
    ParameterError::Unfit(source.forbid(key, place, allowed))
}

/// A number that is finite and passes the test, or the refusal with the key's requirement.
pub(super) fn demand<T: Copy + Into<f64>>(
    source: &Source<'_>,
    key: &str,
    value: &Spanned<T>,
    holds: impl Fn(T) -> bool,
) -> Checked<T> {
    let number = *value.get_ref();
    if number.into().is_finite() && holds(number) { Ok(number) } else { Err(refusal(source, key, value)) }
}

/// A forcing frequency.
pub(super) fn frequency(source: &Source<'_>, key: &str, value: &Spanned<f64>) -> Checked<f64> {
    demand(source, key, value, |frequency| (LEAST_FREQUENCY..=MOST_FREQUENCY).contains(&frequency))
}

/// A range of quantities, none of which is beyond all amplitudes, whose lower end passes the test.
pub(super) fn range(
    source: &Source<'_>,
    key: &str,
    value: &Spanned<Vec<f64>>,
    holds: impl Fn(f64) -> bool,
) -> Checked<Range> {
    let range = match value.get_ref()[..] {
        [lower, upper] => Range::new(lower, upper),
        _ => None,
    };
    let possible = |range: &Range| range.lower() >= -MOST_AMPLITUDE && range.upper() <= MOST_AMPLITUDE;
    range.filter(|range| possible(range) && holds(range.lower())).ok_or_else(|| refusal(source, key, value))
}

/// A range of forcing amplitudes.
pub(super) fn amplitudes(source: &Source<'_>, key: &str, value: &Spanned<Vec<f64>>) -> Checked<Range> {
    range(source, key, value, |lower| lower >= 0.0)
}

/// A range inside another one, which is named in the refusal.
pub(super) fn range_inside(
    source: &Source<'_>,
    key: &str,
    value: &Spanned<Vec<f64>>,
    outer_key: &str,
    outer: &Range,
) -> Checked<Range> {
    let inner = range(source, key, value, f64::is_finite)?;
    if outer.encloses(&inner) {
        return Ok(inner);
    }
    let allowed = format!("the range must lie inside {outer_key} = [{}, {}]", outer.lower(), outer.upper());
    Err(refused(source, key, value, allowed))
}

/// A list of numbers of loops: some, none twice, each from 1 on.
pub(super) fn loops(source: &Source<'_>, key: &str, value: &Spanned<Vec<Spanned<u32>>>) -> Checked<Vec<u32>> {
    let mut numbers = Vec::new();
    for written in value.get_ref() {
        let p = demand(source, key, written, |p| (1..=MOST_LOOPS).contains(&p))?;
        if numbers.contains(&p) {
            let allowed = format!("{p} is listed twice: list each number once");
            return Err(refused(source, key, value, allowed));
        }
        numbers.push(p);
    }
    if numbers.is_empty() { Err(refusal(source, key, value)) } else { Ok(numbers) }
}

pub(super) fn bound_members<T>(
    source: &Source<'_>,
    key: &str,
    members: &Spanned<Vec<T>>,
    allowed: RangeInclusive<usize>,
) -> Checked<()> {
    if allowed.contains(&members.get_ref().len()) { Ok(()) } else { Err(refusal(source, key, members)) }
}
