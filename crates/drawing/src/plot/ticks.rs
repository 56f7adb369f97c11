//! Round steps for ticks, including both ends of the axis if they are round, and numbers as printed.

use grazing_results::Scientific;

/// A step: `mantissa` times ten to the power of `exponent`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct TickStep {
    mantissa: i128,
    exponent: i32,
}

impl TickStep {
    pub(crate) const ONE: TickStep = TickStep { mantissa: 1, exponent: 0 };

    /// The step as a number.
    pub(crate) fn size(self) -> f64 {
        self.value(1)
    }

    /// The exponent of the power of ten of which the step is a small multiple.
    pub(crate) fn exponent(self) -> i32 {
        self.exponent
    }

    /// The number `index * step`, correctly rounded because it is parsed from its decimal digits.
    fn value(self, index: i128) -> f64 {
        format!("{}e{}", index * self.mantissa, self.exponent).parse().unwrap_or(f64::NAN)
    }

    /// The multiples of the step in a range, where ends count within a billionth of the step: in units of
    /// ten to the step's exponent, and as numbers.
    pub(crate) fn multiples(self, [low, high]: [f64; 2]) -> impl Iterator<Item = (i128, f64)> {
        let step = self.value(1);
        let indices = (low / step - 1e-9).ceil() as i128..=(high / step + 1e-9).floor() as i128;
        indices.map(move |index| (index * self.mantissa, self.value(index)))
    }

    /// The step of the smaller ticks in between: a fifth; for a mantissa of two a quarter, which is half
    /// of the unit.
    pub(crate) fn minor(self) -> TickStep {
        let mantissa = match self.mantissa {
            2 => 5,
            5 => 10,
            _ => 2,
        };
        TickStep { mantissa, exponent: self.exponent - 1 }
    }

    /// Round steps (1, 2, 5 times a power of ten) from fine to coarse, suitable for an axis of the given
    /// length.
    pub(crate) fn round_steps(length: f64) -> impl Iterator<Item = TickStep> {
        // The exponent in scientific notation is the floor of the decimal logarithm, obtained without
        // computing one.
        let Scientific { exponent, .. } = Scientific::of(length);
        (exponent - 2..=exponent + 1)
            .flat_map(|exponent| [1, 2, 5].map(|mantissa| TickStep { mantissa, exponent }))
    }
}

/// `units` times ten to the power of `exponent`, written exactly.
pub(crate) fn decimal(units: i128, exponent: i32) -> String {
    let sign = if units < 0 { "−" } else { "" };
    let digits = units.unsigned_abs().to_string();
    if units == 0 || exponent >= 0 {
        let zeros = if units == 0 { 0 } else { exponent as usize };
        return format!("{sign}{digits}{}", "0".repeat(zeros));
    }
    let decimals = exponent.unsigned_abs() as usize;
    let padded = format!("{digits:0>width$}", width = decimals + 1);
    let (whole, fraction) = padded.split_at(padded.len() - decimals);
    format!("{sign}{whole}.{fraction}")
}

/// `units` times ten to the power of `exponent` without trailing zeros, in markup within `$`; with a
/// power of ten where there would be many zeros.
pub(crate) fn scientific(mut units: i128, mut exponent: i32) -> String {
    while units != 0 && units % 10 == 0 {
        (units, exponent) = (units / 10, exponent + 1);
    }
    let further = units.unsigned_abs().to_string().len() as i32 - 1;
    if (-4..=6).contains(&(exponent + further)) && exponent <= 3 {
        return decimal(units, exponent);
    }
    format!(r"{}\,\times\,10^{{{}}}", decimal(units, -further), exponent + further)
}

/// A number with this many significant digits in markup within `$`: plain between a thousandth and a
/// hundred thousand, with a power of ten beyond.
pub(crate) fn measured(value: f64, digits: usize) -> String {
    let Scientific { mantissa, exponent } = Scientific::rounded(value.abs(), digits);
    if (-3..=4).contains(&exponent) {
        return significant(value, digits);
    }
    let sign = if value < 0.0 { "−" } else { "" };
    format!(r"{sign}{mantissa}\,\times\,10^{{{exponent}}}")
}

/// A number with this many significant digits, as printed in running text (with a true minus sign).
pub(crate) fn significant(value: f64, digits: usize) -> String {
    let Scientific { exponent, .. } = Scientific::rounded(value.abs(), digits);
    let decimals = (digits as i64 - 1 - i64::from(exponent)).max(0) as usize;
    let sign = if value < 0.0 { "−" } else { "" };
    format!("{sign}{:.decimals$}", value.abs())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn step(mantissa: i128, exponent: i32) -> TickStep {
        TickStep { mantissa, exponent }
    }

    #[test]
    fn both_ends_carry_a_tick_though_they_are_not_exact_in_binary() {
        // 0.1 + 0.2 exceeds 0.3 by one rounding, and 1.3 / 0.1 falls short of 13.
        let ticks: Vec<_> = step(1, -1).multiples([0.1 + 0.2, 1.3]).collect();
        assert_eq!((ticks.len(), ticks[0], ticks[4], ticks[10]), (11, (3, 0.3), (7, 0.7), (13, 1.3)));
    }

    #[test]
    fn numbers_are_written_exactly() {
        assert_eq!(decimal(35, -2), "0.35");
        assert_eq!(decimal(0, -1), "0");
        assert_eq!(decimal(-6, -1), "−0.6");
        assert_eq!(decimal(8, 3), "8000");
        assert_eq!(decimal(10, -1), "1.0");
    }

    #[test]
    fn minor_ticks_fall_on_the_major_ones_and_between() {
        for major in [step(1, 0), step(2, -1), step(5, -2)] {
            let minor = major.minor();
            let ratio = major.value(1) / minor.value(1);
            assert!((ratio - ratio.round()).abs() < 1e-12 && ratio > 3.0, "{major:?} {ratio}");
        }
    }

    #[test]
    fn steps_run_from_fine_to_coarse_around_the_length() {
        let steps: Vec<f64> = TickStep::round_steps(0.67).map(|s| s.value(1)).collect();
        assert!(steps.is_sorted());
        assert!(steps[0] < 0.67 / 100.0 && steps[steps.len() - 1] > 0.67);
    }

    #[test]
    fn significant_digits_are_counted_seen_from_first() {
        assert_eq!(significant(-123.456, 4), "−123.5");
        assert_eq!(significant(9.8765, 4), "9.877");
        assert_eq!(significant(0.012345, 3), "0.0123");
        assert_eq!(significant(99.996, 4), "100.0");
        assert_eq!(significant(4321.7, 4), "4322");
    }

    #[test]
    fn coefficients_of_any_magnitude_keep_their_digits() {
        assert_eq!(measured(-271.83, 4), "−271.8");
        assert_eq!(measured(0.001_234_5, 3), "0.00123");
        assert_eq!(measured(-1.234_56e8, 4), r"−1.235\,\times\,10^{8}");
        assert_eq!(measured(9.999_96e-5, 4), r"1.000\,\times\,10^{-4}");
        assert_eq!(measured(0.0, 2), "0.0");
    }

    #[test]
    fn round_numbers_are_written_without_needless_zeros() {
        assert_eq!(scientific(432_100, -6), "0.4321");
        assert_eq!(scientific(-120, 0), "−120");
        assert_eq!(scientific(1_230, 9), r"1.23\,\times\,10^{12}");
        assert_eq!(scientific(5, -9), r"5\,\times\,10^{-9}");
        assert_eq!(scientific(0, -3), "0");
    }
}
