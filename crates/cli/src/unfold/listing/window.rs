//! Better ranges for a diagram that fills little of its own.

use grazing_results::Dimensioned;

use crate::layout::{KEPT, Layout};
use grazing_results::brief;
use grazing_unfold::unfolded::Unfolded;

/// Ranges that would show more, as the command line takes them.
pub(super) fn suggested(layout: Layout, unfolded: &Unfolded) -> String {
    let Some(suggested) = unfolded.diagram.suggested_window() else { return String::new() };
    let units = &unfolded.axes.units;
    let (now, then) =
        (unfolded.diagram.scope.window.with_dimensions(units), suggested.with_dimensions(units));
    let setting = |key: &str, now: [f64; 2], then: [f64; 2]| {
        let [low, high] = rounded(now, then).map(|value| brief(value, 12));
        format!("--set{KEPT}{key}.range=[{low},{high}]")
    };
    let content = format!(
        "the results fill a tenth of a range or less; narrower ranges show more: {}",
        [setting("primary", now.primary, then.primary), setting("secondary", now.secondary, then.secondary)]
            .join(" ")
    );
    layout.headed("Ranges", [("  ".to_owned(), content)])
}

/// The suggested range rounded outwards to two significant digits of its width; ends that stay the
/// same are not rounded.
fn rounded([lowest, highest]: [f64; 2], [low, high]: [f64; 2]) -> [f64; 2] {
    let unit = libm::pow(10.0, libm::floor(libm::log10(high - low)) - 1.0);
    let least = if low <= lowest { lowest } else { (libm::floor(low / unit) * unit).max(lowest) };
    let greatest = if high >= highest { highest } else { (libm::ceil(high / unit) * unit).min(highest) };
    [least, greatest]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_are_rounded_outwards_to_two_digits_of_their_width_within_those_that_are_there() {
        for (now, then, wanted) in [
            ([0.0, 40.0], [0.0, 1.234], [0.0, 1.3]),
            ([0.0, 40.0], [0.0361, 0.0784], [0.036, 0.079]),
            ([0.0, 5e6], [100.234, 100.871], [100.23, 100.88]),
            ([-3.0, 900.0], [-2.46, 17.8], [-3.0, 18.0]),
            ([0.6, 1.1], [0.6, 1.1], [0.6, 1.1]),
        ] {
            for (rounded, wanted) in rounded(now, then).into_iter().zip(wanted) {
                assert!((rounded - wanted).abs() <= 1e-12 * wanted.abs(), "{rounded} {wanted}");
            }
        }
    }
}
