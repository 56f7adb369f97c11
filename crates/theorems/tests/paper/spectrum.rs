//! Eigenvalues of the linearised map where digits could be lost, and where there is no result; the
//! rest is checked by the ledger of claims.

use nalgebra::{Matrix2, Vector2};
use proptest::prelude::*;

use grazing_theorems::spectrum::{Eigenvalues, in_trapesium};
use grazing_theorems::{LinearisedMap, TheoryError};

use super::{assert_close, assert_within, deterministic};

/// First-order global maps with `(tau, delta)` in the trapesium and entries of order one.
fn maps() -> impl Strategy<Value = LinearisedMap> {
    // Up to a relative distance 1e-6 from the slanted sides.
    let trapesium = (-0.999_999..0.999_999_f64, 0.001..0.999_f64);
    (trapesium, -1.5..1.5_f64, 0.2..2.0_f64, proptest::bool::ANY).prop_map(
        |((share, delta), a11, size, flip)| {
            let a12 = if flip { -size } else { size };
            let a22 = share * (delta + 1.0) - a11;
            let a21 = (a11 * a22 - delta) / a12;
            LinearisedMap { a: Matrix2::new(a11, a12, a21, a22), b: Vector2::zeros() }
        },
    )
}

proptest! {
    #![proptest_config(deterministic(256))]

    #[test]
    fn the_matrix_and_its_invariants_have_the_same_eigenvalues(map in maps()) {
        let from_invariants = Eigenvalues::from_trace_and_determinant(map.trace(), map.determinant());
        // The discriminant is formed in two ways, from terms of order ten; near zero its square
        // root loses half of the digits.
        match (map.eigenvalues(), from_invariants) {
            (
                Eigenvalues::Real { lambda_1, lambda_2 },
                Eigenvalues::Real { lambda_1: other_1, lambda_2: other_2 },
            ) => {
                assert_within(lambda_1, other_1, 1e-7);
                assert_within(lambda_2, other_2, 1e-7);
            }
            (
                Eigenvalues::ComplexPair { modulus, argument },
                Eigenvalues::ComplexPair { modulus: other_modulus, argument: other_argument },
            ) => {
                assert_within(modulus, other_modulus, 1e-14);
                assert_within(argument, other_argument, 1e-6);
            }
            (one, other) => prop_assert!(false, "{one:?} and {other:?}"),
        }
    }
}

#[test]
fn double_eigenvalue_of_a_jordan_block_is_exact() {
    let map = LinearisedMap { a: Matrix2::new(0.7, 0.3, 0.0, 0.7), b: Vector2::zeros() };
    assert_eq!(map.eigenvalues(), Eigenvalues::Real { lambda_1: 0.7, lambda_2: map.determinant() / 0.7 });
}

#[test]
fn small_eigenvalue_keeps_its_digits() {
    // The naive difference (tau - sqrt(tau^2 - 4 delta)) / 2 has no correct digit here.
    let Eigenvalues::Real { lambda_1, lambda_2 } = Eigenvalues::from_trace_and_determinant(0.5, 1e-17) else {
        panic!("the discriminant is positive");
    };
    assert_close(lambda_1, 0.5, 1e-15);
    assert_close(lambda_2, 2e-17, 1e-15);
    let Eigenvalues::Real { lambda_1, lambda_2 } = Eigenvalues::from_trace_and_determinant(-0.5, 1e-17)
    else {
        panic!("the discriminant is positive");
    };
    assert_close(lambda_1, -2e-17, 1e-15);
    assert_close(lambda_2, -0.5, 1e-15);
}

#[test]
fn nilpotent_matrix_has_zero_eigenvalues() {
    let map = LinearisedMap { a: Matrix2::new(0.0, 1.0, 0.0, 0.0), b: Vector2::zeros() };
    assert_eq!(map.eigenvalues(), Eigenvalues::Real { lambda_1: 0.0, lambda_2: 0.0 });
}

#[test]
fn non_impacting_orbit_has_no_slope_at_a_unit_eigenvalue() {
    let map = LinearisedMap { a: Matrix2::new(1.0, 0.5, 0.0, 0.25), b: Vector2::new(1.0, 1.0) };
    let expected = TheoryError::UnitEigenvalue { determinant: 0.0 };
    assert_eq!(map.fixed_point_slope(), Err(expected));
    assert_eq!(map.fixed_point_position_slope(), Err(expected));
}

#[test]
fn boundary_and_nan_are_outside_the_trapesium() {
    assert!(in_trapesium(0.0, 0.5));
    for (tau, delta) in [(1.5, 0.5), (-1.5, 0.5), (0.0, 1.0), (0.0, 0.0), (f64::NAN, 0.5), (0.0, f64::NAN)] {
        assert!(!in_trapesium(tau, delta), "({tau}, {delta})");
    }
}
