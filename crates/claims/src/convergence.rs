//! The order at which remainders vanish.

/// Sizes fall by halves from two to the minus this.
const FIRST: i32 = 6;
/// The number of sizes.
const SIZES: i32 = 16;
/// How many times its rounding a remainder must be to count.
const RESOLVED: f64 = 100.0;

/// The observed order of a remainder in a size: log₂ of the ratio at the two smallest sizes, a factor two apart, at which it
/// stands a hundredfold above its rounding.
///
/// `remainder` gives, for a size, the remainder and its rounding, or `None` where the size is too large for it to exist.
/// Infinite if the remainder is never resolved twice: then there is none to be seen. Not a number if it does not exist down to the
/// smallest size that was looked at.
pub(crate) fn order(mut remainder: impl FnMut(f64) -> Option<(f64, f64)>) -> f64 {
    let mut resolved: Vec<f64> = Vec::new();
    let mut exists = false;
    for k in FIRST..FIRST + SIZES {
        let found = remainder(libm::ldexp(1.0, -k));
        exists = found.is_some();
        match found {
            Some((value, rounding)) if value.abs() > RESOLVED * rounding => resolved.push(value.abs()),
            // What is not a number is not small.
            Some((value, _)) if value.is_nan() => return f64::NAN,
            // Below rounding once, below rounding from there on.
            Some(_) => break,
            None => resolved.clear(),
        }
    }
    match resolved[..] {
        [.., coarse, fine] => libm::log2(coarse / fine),
        _ if !exists => f64::NAN,
        _ => f64::INFINITY,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_order_of_a_power_is_seen_also_where_nothing_exists_at_first() {
        let with_a_higher_term = order(|h| Some((h * h * h * (1.0 + h), 1e-16)));
        assert!((with_a_higher_term - 3.0).abs() < 0.01, "{with_a_higher_term}");
        let near_zero = order(|h| (h < 0.004).then_some((h * h, 1e-16)));
        assert!((near_zero - 2.0).abs() < 1e-9);
    }

    #[test]
    fn what_is_below_rounding_or_not_a_number_has_no_order() {
        assert_eq!(order(|_| Some((1e-17, 1e-16))), f64::INFINITY);
        assert!(order(|h| Some((if h < 0.001 { f64::NAN } else { h }, 1e-16))).is_nan());
        assert!(order(|h| (h > 0.001).then_some((h, 1e-16))).is_nan());
    }
}
