//! The zero of a function of one variable between two values of opposite signs.

use crate::tolerances::FALSE_POSITIONS;

/// The result at the zero of a function on [0, 1], by the Illinois variant of regula falsi.
///
/// `at` returns a result with the function's value at a fraction of the interval, `values` are
/// those at both ends. The search ends as soon as `enough` returns true for a result and its value,
/// or when no evaluation is left.
///
/// # Errors
/// `at` fails.
pub fn zero_between<T, E>(
    values: [f64; 2],
    mut at: impl FnMut(f64) -> Result<(T, f64), E>,
    enough: impl Fn(&T, f64) -> bool,
) -> Result<T, E> {
    let ([mut low, mut high], [mut at_low, mut at_high]) = ([0.0, 1.0], values);
    let mut evaluation = 1;
    loop {
        let share = (low * at_high - high * at_low) / (at_high - at_low);
        let (found, value) = at(share)?;
        if enough(&found, value) || share == high || evaluation == FALSE_POSITIONS {
            return Ok(found);
        }
        // The value at the end that stays is halved, so that both ends come close.
        if value * at_high < 0.0 {
            (low, at_low) = (high, at_high);
        } else {
            at_low *= 0.5;
        }
        (high, at_high) = (share, value);
        evaluation += 1;
    }
}
