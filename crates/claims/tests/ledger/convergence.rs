//! The order at which remainders vanish.

use grazing_claims::convergence::order;

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
