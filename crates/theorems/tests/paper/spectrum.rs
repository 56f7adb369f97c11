//! Eigenvalues, iterates and the fixed point of the linearised map.

use nalgebra::{Matrix2, Vector2};
use proptest::prelude::*;

use grazing_theorems::auxiliary::geometric_sum_determinant;
use grazing_theorems::spectrum::{Eigenvalues, in_trapesium};
use grazing_theorems::{LinearisedMap, TheoryError};

use super::{assert_close, assert_within, deterministic, maps, trapesium};

proptest! {
    #![proptest_config(deterministic(256))]

    #[test]
    fn eigenvalues_have_the_given_sum_and_product((tau, delta) in trapesium()) {
        let (sum, product) = match Eigenvalues::from_trace_and_determinant(tau, delta) {
            Eigenvalues::Real { lambda_1, lambda_2 } => {
                prop_assert!(lambda_1 >= lambda_2);
                (lambda_1 + lambda_2, lambda_1 * lambda_2)
            }
            Eigenvalues::ComplexPair { modulus, argument } => {
                (2.0 * modulus * libm::cos(argument), modulus * modulus)
            }
        };
        // A few roundings of numbers of order one.
        assert_within(sum, tau, 4e-15);
        assert_within(product, delta, 4e-15);
    }

    #[test]
    fn the_matrix_and_its_invariants_have_the_same_eigenvalues(map in maps()) {
        let from_invariants = Eigenvalues::from_trace_and_determinant(map.trace(), map.determinant());
        // The discriminant is formed in two ways, from terms of order ten; near zero its square root loses
        // half of the digits.
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

    #[test]
    fn trapesium_is_where_both_multipliers_lie_inside_the_unit_circle_and_orientation_is_kept(
        tau in -3.0..3.0_f64,
        delta in -1.5..1.5_f64,
    ) {
        // No case within rounding of the boundary is drawn: the distances below are checked to be large.
        let margins = [delta.abs(), (delta - 1.0).abs(), (delta + 1.0 - tau.abs()).abs()];
        prop_assume!(margins.iter().all(|margin| *margin > 1e-9));
        let radius = Eigenvalues::from_trace_and_determinant(tau, delta).spectral_radius();
        prop_assert_eq!(in_trapesium(tau, delta), delta > 0.0 && radius < 1.0);
    }

    #[test]
    fn iterate_is_the_repeated_map(map in maps(), p in 0_u32..12) {
        let (mut a, mut b) = (Matrix2::identity(), Vector2::zeros());
        // Entries of A reach 10 in modulus; the powers are compared against the largest of them.
        let mut largest = 1.0_f64;
        for _ in 0..p {
            b = map.a * b + map.b;
            a = map.a * a;
            largest = largest.max(a.amax()).max(b.amax());
        }
        let iterate = map.iterate(p);
        let scale = largest * (1.0 + map.a.amax());
        prop_assert!((iterate.a - a).amax() <= 1e-12 * scale, "{} and {}", iterate.a, a);
        prop_assert!((iterate.b - b).amax() <= 1e-12 * scale, "{} and {}", iterate.b, b);
    }

    #[test]
    fn geometric_sum_determinant_is_the_determinant_of_the_sum_of_the_powers(map in maps(), p in 0_u32..12) {
        let (mut power, mut sum) = (Matrix2::identity(), Matrix2::zeros());
        for _ in 0..p {
            sum += power;
            power *= map.a;
        }
        let computed = geometric_sum_determinant(p, map.trace(), map.determinant());
        // The determinant of the matrix cancels products of its entries.
        let slack = 1e-12 * (1.0 + sum.amax() * sum.amax()) * (1.0 + map.a.amax());
        assert_within(computed, sum.determinant(), slack);
    }

    #[test]
    fn fixed_point_slope_solves_its_equation(map in maps()) {
        // A fixed point that moves infinitely fast has no digits.
        prop_assume!(map.characteristic_polynomial_at_one() > 1e-4);
        let slope = map.fixed_point_slope().expect("1 is not an eigenvalue");
        let residual = (Matrix2::identity() - map.a) * slope - map.b;
        prop_assert!(residual.amax() <= 1e-13 * (1.0 + map.a.amax()) * (1.0 + slope.amax()));
        assert_close(map.fixed_point_position_slope().expect("1 is not an eigenvalue"), slope.x, 1e-14);
    }

    #[test]
    fn characteristic_polynomial_at_one_is_made_of_the_invariants(map in maps()) {
        let expected = map.determinant() - map.trace() + 1.0;
        // Products of entries of A, at most 16 in modulus each, cancel on both sides.
        let slack = 1e-14 * (1.0 + map.a.amax() * map.a.amax());
        assert_within(map.characteristic_polynomial_at_one(), expected, slack);
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
