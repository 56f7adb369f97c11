//! Numbers as people read them.

/// The value with this many significant digits at most, without zeros at the end, as `0.5` or `-1.25e-9`.
pub(super) fn brief(value: f64, digits: usize) -> String {
    let rounded: f64 = format!("{value:.*e}", digits - 1).parse().unwrap_or(value);
    // Adding zero turns -0 into 0.
    let rounded = rounded + 0.0;
    if rounded == 0.0 || (1e-4..1e7).contains(&rounded.abs()) {
        format!("{rounded}")
    } else {
        format!("{rounded:e}")
    }
}

/// The value with just this many significant digits, for a column.
pub(super) fn significant(value: f64, digits: usize) -> String {
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
    fn brief_numbers_have_no_zeros_at_the_end() {
        for (value, text) in
            [(0.5, "0.5"), (1.0, "1"), (-0.0, "0"), (0.123_456_789, "0.123457"), (1.25e-9, "1.25e-9")]
        {
            assert_eq!(brief(value, 6), text);
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
