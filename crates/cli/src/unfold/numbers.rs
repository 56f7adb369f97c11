//! Numbers formatted for reading.

use grazing_results::{Names, Scientific, brief, with_unit};

/// The value with exactly this many significant digits, for a column.
pub(crate) fn significant(value: f64, digits: usize) -> String {
    if !value.is_finite() {
        return "-".to_owned();
    }
    let scientific = Scientific::rounded(value + 0.0, digits);
    let decimals = digits as i32 - 1 - scientific.exponent;
    match usize::try_from(decimals) {
        Ok(decimals) if scientific.exponent >= -4 => format!("{:.decimals$}", value + 0.0),
        _ => scientific.to_string(),
    }
}

/// The value with this many decimals, for a column of numbers of order one.
pub(super) fn fixed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    if text.chars().any(|digit| ('1'..='9').contains(&digit)) { text } else { format!("{:.decimals$}", 0.0) }
}

/// Both ends of a range.
pub(super) fn range([low, high]: [f64; 2]) -> String {
    format!("{} to {}", brief(low, 6), brief(high, 6))
}

/// The primary and the secondary parameter as heads of columns, with their units.
pub(crate) fn heads(names: &Names) -> [String; 2] {
    [(&names.primary, "{primary}"), (&names.secondary, "{secondary}")]
        .map(|(name, declared)| with_unit(name, names.named_unit(declared).as_deref()))
}

/// A value with its standard error, as `0.0181 ± 0.0012`: two significant digits of the error, and as many decimals of the value.
pub(crate) fn with_error(value: f64, error: f64) -> String {
    if !(error > 0.0 && error.is_finite() && value.is_finite()) {
        return format!("{} ± {}", brief(value, 8), if error == 0.0 { "0" } else { "not known" });
    }
    let exponent = Scientific::rounded(error, 2).exponent;
    let power = Scientific::of(value.abs().max(error)).exponent;
    if (-4..=5).contains(&power) && exponent <= 1 {
        let decimals = usize::try_from(1 - exponent).unwrap_or(0);
        return format!("{value:.decimals$} ± {error:.decimals$}");
    }
    let decimals = usize::try_from(power - exponent + 1).unwrap_or(0);
    let unit = libm::pow(10.0, f64::from(power));
    format!("({:.decimals$} ± {:.decimals$})e{power}", value / unit, error / unit)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_has_as_many_decimals_as_two_digits_of_its_error() {
        for (value, error, text) in [
            (0.018_123, 0.001_234, "0.0181 ± 0.0012"),
            (0.72, 0.009_96, "0.720 ± 0.010"),
            (8.04, 0.1, "8.04 ± 0.10"),
            (-1.25, 3.0, "-1.2 ± 3.0"),
            (152.0, 12.0, "152 ± 12"),
            (1_234_567.0, 1_200.0, "(1.2346 ± 0.0012)e6"),
            (2_345.0, 120.0, "(2.35 ± 0.12)e3"),
            (1.234e-6, 2e-8, "(1.234 ± 0.020)e-6"),
            (0.5, f64::NAN, "0.5 ± not known"),
        ] {
            assert_eq!(with_error(value, error), text);
        }
    }

    #[test]
    fn significant_numbers_have_all_their_digits() {
        for (value, text) in [
            (0.5, "0.50000"),
            (-12.0, "-12.000"),
            (123_456.0, "1.2346e5"),
            (1.5e-7, "1.5000e-7"),
            (f64::NAN, "-"),
        ] {
            assert_eq!(significant(value, 5), text);
        }
    }
}
