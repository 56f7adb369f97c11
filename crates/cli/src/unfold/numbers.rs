//! Numbers formatted for reading.

use grazing_results::brief;

/// The value with exactly this many significant digits, for a column.
pub(crate) fn significant(value: f64, digits: usize) -> String {
    if !value.is_finite() {
        return "-".to_owned();
    }
    let scientific = format!("{:.*e}", digits - 1, value + 0.0);
    let exponent: i32 =
        scientific.split_once('e').and_then(|(_, exponent)| exponent.parse().ok()).unwrap_or(0);
    let decimals = digits as i32 - 1 - exponent;
    match usize::try_from(decimals) {
        Ok(decimals) if exponent >= -4 => format!("{:.decimals$}", value + 0.0),
        _ => scientific,
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

#[cfg(test)]
mod tests {
    use super::*;

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
