//! Closed forms and limits of `h_p`; lemma 2.1 is checked by the ledger of claims.

use core::f64::consts::PI;

use proptest::prelude::*;

use grazing_theorems::TheoryError;
use grazing_theorems::admissibility_boundary::admissibility_boundary;

use super::{assert_within, deterministic};

fn boundary(p: u32, delta: f64) -> f64 {
    admissibility_boundary(p, delta).expect("p >= 2 and 0 < delta < 1")
}

proptest! {
    #![proptest_config(deterministic(512))]

    #[test]
    fn boundary_is_explicit_for_three_and_four_loops(delta in 1e-9..0.999_999_f64) {
        // H_3 = 1 + tau / delta; delta^2 H_4 = tau^2 + delta tau + delta^2 - delta. A few roundings
        // of 2 sqrt(delta).
        let scale = 2.0 * delta.sqrt();
        assert_within(boundary(3, delta), -delta, 4e-16 * scale);
        let four = 0.5 * (delta * (4.0 - 3.0 * delta)).sqrt() - 0.5 * delta;
        assert_within(boundary(4, delta), four, 8e-16 * scale);
    }

    #[test]
    fn boundary_is_a_root_of_the_cubic_for_five_loops(delta in 1e-3..0.999_f64) {
        // delta^3 H_5 = tau^3 + delta tau^2 + (delta^2 - 2 delta) tau + delta^3 - delta^2
        let tau = boundary(5, delta);
        let cubic = ((tau + delta) * tau + delta * (delta - 2.0)) * tau + delta * delta * (delta - 1.0);
        let slope = (3.0 * tau + 2.0 * delta) * tau + delta * (delta - 2.0);
        // One more Newton step moves the root by no more than the rounding of the terms.
        prop_assert!((cubic / slope).abs() <= 4e-15 * delta.sqrt());
    }
}

#[test]
fn two_loops_have_the_double_negative_eigenvalue_as_boundary() {
    for delta in [1e-12, 0.3, 0.999_f64] {
        assert_eq!(admissibility_boundary(2, delta), Ok(-2.0 * delta.sqrt()));
    }
}

#[test]
fn boundary_tends_to_the_ends_of_its_bracket() {
    for p in [3_u32, 4, 7, 50, 1000] {
        let loops = f64::from(p);
        // No contraction: towards g_{p/2}, at distance of order 1 - delta times p.
        let nearly_one = 1.0 - 1e-13;
        assert_within(boundary(p, nearly_one), 2.0 * libm::cos(2.0 * PI / loops), 1e-12);
        // Strong contraction: towards g_{p-1}, at a relative distance of order sqrt(delta).
        let tiny = 1e-26;
        assert_within(boundary(p, tiny), 2e-13 * libm::cos(PI / (loops - 1.0)), 1e-25);
    }
}

#[test]
fn boundary_exists_over_the_whole_range_of_doubles() {
    for p in [3_u32, 5, 200, 5000] {
        for delta in [f64::MIN_POSITIVE, 1e-200, 1e-20, 0.5, 1.0 - f64::EPSILON] {
            let scaled = boundary(p, delta) / (2.0 * delta.sqrt());
            let (low, high) = (libm::cos(2.0 * PI / f64::from(p)), libm::cos(PI / (f64::from(p) - 1.0)));
            // One unit in the last place on either side.
            assert!(
                low - 2.3e-16 <= scaled && scaled <= high + 2.3e-16,
                "p = {p}, delta = {delta:e}: {scaled}"
            );
        }
    }
}

#[test]
fn arguments_outside_the_domain_are_refused() {
    assert_eq!(admissibility_boundary(1, 0.5), Err(TheoryError::TooFewLoops { loops: 1, minimum: 2 }));
    for delta in [0.0, 1.0, -0.2, f64::INFINITY] {
        assert_eq!(
            admissibility_boundary(3, delta),
            Err(TheoryError::DeterminantOutsideUnitInterval { delta })
        );
    }
    assert!(admissibility_boundary(3, f64::NAN).is_err());
}
