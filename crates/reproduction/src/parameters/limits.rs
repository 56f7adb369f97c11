//! Limits on the values in a parameter file, and kinds of values that several sections use.

use std::ops::RangeInclusive;

use grazing_input::kind::{Kind, above, interval, number, strictly};
use grazing_input::{Section, SourceError};
use grazing_theorems::{GrazingState, LinearOscillator};

/// The greatest number of loops: higher ones are unrelated to resonant grazing, and their curves cannot
/// be distinguished.
pub const MOST_LOOPS: u32 = 12;
/// The greatest integer n of a resonance; its frequency is already below a twentieth of the natural
/// frequency.
pub(crate) const MOST_N: u32 = 100;
/// The range of forcing frequencies. Below it, the block oscillates a hundred times in one forcing
/// period, which no figure resolves, and the work grows without bound; the highest resonance, of p = 12
/// and n = 0, is at 24.
pub(crate) const FREQUENCIES: RangeInclusive<f64> = 0.01..=100.0;
/// The greatest forcing amplitude: ten times that of grazing at the greatest frequency.
pub(crate) const MOST_AMPLITUDE: f64 = 1e5;

pub(crate) const ZETA: &str = "the damping ratio must be a number strictly between {} and {}";
pub(crate) const EPSILON: &str = "the coefficient of restitution must be a number above {} and at most {}";
pub(crate) const FREQUENCY: &str = "the forcing frequency must be a number from {} to {}";
pub(crate) const AMPLITUDES: &str =
    "the forcing amplitudes must be a range [lower, upper] with {} <= lower < upper <= {}";
pub(crate) const AROUND_ZERO: &str =
    "the range must be [lower, upper] with lower < 0 < upper, neither end beyond 100000";
pub(crate) const LOOPS: &str =
    "the numbers of loops must be a list of different whole numbers from {} to {}, as [1, 2, 3]";
pub(crate) const INDEX: &str =
    "the integer n of the resonance must be a whole number from 1 to 100, or 0 for two or more loops";

/// The kind of a damping ratio.
pub(crate) fn damping_ratio() -> Kind<f64> {
    number(strictly(0.0, 1.0))
}

/// The kind of a coefficient of restitution.
pub(crate) fn restitution() -> Kind<f64> {
    number(above(0.0, 1.0))
}

/// The kind of a range of forcing amplitudes.
pub(crate) fn amplitudes() -> Kind<[f64; 2]> {
    interval(0.0..=MOST_AMPLITUDE)
}

/// The kind of a range of any quantity, within the limit of amplitudes.
pub(crate) fn range() -> Kind<[f64; 2]> {
    interval(-MOST_AMPLITUDE..=MOST_AMPLITUDE)
}

/// The kind of a range that has 0 strictly inside.
pub(crate) fn around_zero() -> Kind<[f64; 2]> {
    range().such(|range| strictly_contains(*range, 0.0))
}

/// Whether a number lies in a range [lower, upper], including its ends; false for NaN.
pub fn contains([lower, upper]: [f64; 2], value: f64) -> bool {
    lower <= value && value <= upper
}

/// Whether a number lies in a range, excluding its ends.
pub fn strictly_contains([lower, upper]: [f64; 2], value: f64) -> bool {
    lower < value && value < upper
}

/// Whether all of the inner range lies in the outer one.
pub fn encloses(outer: [f64; 2], inner: [f64; 2]) -> bool {
    outer[0] <= inner[0] && inner[1] <= outer[1]
}

/// Returns an error for a range that is not inside another one, which the error names.
pub(crate) fn must_lie_inside(
    section: &Section<'_>,
    name: &str,
    range: [f64; 2],
    (outer_key, outer): (&str, [f64; 2]),
) -> Result<(), SourceError> {
    if encloses(outer, range) {
        return Ok(());
    }
    let [lower, upper] = outer;
    Err(section.forbid(name, format!("the range must lie inside {outer_key} = [{lower}, {upper}]")))
}

/// The grazing bifurcation at the section's forcing frequency.
pub(crate) fn grazing(
    section: &Section<'_>,
    oscillator: &LinearOscillator,
    frequency: f64,
) -> Result<GrazingState, SourceError> {
    oscillator.grazing(frequency).map_err(|error| section.forbid("frequency", error.to_string()))
}
