//! Theorems 2.2 and 2.3: each hypothesis violated alone; conclusions are checked by the ledger of
//! claims.

use nalgebra::{Matrix2, Vector2};

use grazing_theorems::generic_theorem::Side;
use grazing_theorems::hypothesis::{HypothesesViolated, Quantity, Theorem};
use grazing_theorems::{GenericGrazing, GrazingPoint, LinearisedMap, TheoryError};

/// tau = 1/2, delta = 0.26, beta = 0.6: a generic point for which theorem 2.2 and theorem 2.3 with
/// p = 2 hold.
fn generic() -> GrazingPoint {
    with_matrix(Matrix2::new(0.3, 0.4, -0.5, 0.2))
}

fn with_matrix(a: Matrix2<f64>) -> GrazingPoint {
    let map = LinearisedMap { a, b: Vector2::new(0.7, 0.1) };
    GrazingPoint { map, forcing_frequency: 1.2, gamma: 0.8, phi: 0.75, psi: 0.0 }
}

fn violations(point: &GrazingPoint, p: u32) -> Vec<Quantity> {
    let violated: HypothesesViolated = GenericGrazing::check(point, p).expect_err("a hypothesis is violated");
    violated.violated().map(|hypothesis| hypothesis.quantity).collect()
}

#[test]
fn one_loop_emerges_on_the_side_of_the_sign_of_a12_beta() {
    let theorem = GenericGrazing::check(&generic(), 1).expect("the hypotheses hold");
    assert_eq!(theorem.side(), Side::Positive);
    assert!(theorem.hypotheses().iter().all(|hypothesis| hypothesis.holds()));
    let mirrored = with_matrix(Matrix2::new(0.3, -0.4, 0.5, 0.2));
    assert_eq!(GenericGrazing::check(&mirrored, 1).expect("the hypotheses hold").side(), Side::Negative);
}

#[test]
fn side_of_many_loops_changes_at_the_resonance() {
    // tau = 1/2 lies between g_2 = 0 and g_3 = sqrt(delta) = 0.51.
    let two = GenericGrazing::check(&generic(), 2).expect("the hypotheses hold");
    let three = GenericGrazing::check(&generic(), 3).expect("the hypotheses hold");
    assert_eq!((two.side(), three.side()), (Side::Positive, Side::Negative));
    // Reversing the direction of the parameter mirrors both.
    let mut reversed = generic();
    reversed.map.b = -reversed.map.b;
    assert_eq!(GenericGrazing::check(&reversed, 2).expect("the hypotheses hold").side(), Side::Negative);
    assert_eq!(GenericGrazing::check(&reversed, 3).expect("the hypotheses hold").side(), Side::Positive);
}

#[test]
fn each_violated_hypothesis_is_named_alone() {
    let base = generic();
    for p in [1, 2] {
        assert_eq!(
            violations(&GrazingPoint { forcing_frequency: -1.0, ..base }, p),
            [Quantity::ForcingFrequency]
        );
        assert_eq!(violations(&GrazingPoint { gamma: 0.0, ..base }, p), [Quantity::Deceleration]);
        assert_eq!(violations(&GrazingPoint { phi: -0.5, ..base }, p), [Quantity::Restitution]);
        assert_eq!(violations(&with_matrix(Matrix2::new(0.3, 0.4, -2.6, 0.2)), p), [Quantity::Contraction]);
        assert_eq!(
            violations(&with_matrix(Matrix2::new(1.5, 0.4, 0.0, 0.2)), p),
            [Quantity::StabilityMargin]
        );
    }
    assert_eq!(violations(&with_matrix(Matrix2::new(0.3, 0.4, 0.2, 0.2)), 1), [Quantity::Determinant]);
    // Without square root of delta, kappa_p and h_p have no value.
    assert_eq!(
        violations(&with_matrix(Matrix2::new(0.3, 0.4, 0.2, 0.2)), 2),
        [Quantity::Determinant, Quantity::TransversalityTimesDetuning]
    );
    let slow = GrazingPoint { psi: 4.0, ..base };
    assert_eq!(violations(&slow, 1), [Quantity::SquareRootFactor]);
    assert_eq!(violations(&slow, 2), [Quantity::OffDiagonalTimesSquareRootFactor]);
    // a12 < 0 violates only theorem 2.3.
    let mirrored = with_matrix(Matrix2::new(0.3, -0.4, 0.5, 0.2));
    assert_eq!(violations(&mirrored, 2), [Quantity::OffDiagonalTimesSquareRootFactor]);
    // tau = -1/2 < h_3 = -delta = -0.26
    assert_eq!(
        violations(&with_matrix(Matrix2::new(-0.7, 0.4, -1.0, 0.2)), 3),
        [Quantity::AdmissibilityMargin]
    );
    // The products that decide the side.
    let mut still = base;
    still.map.b = Vector2::zeros();
    assert_eq!(violations(&still, 1), [Quantity::OffDiagonalTimesTransversality]);
    assert_eq!(violations(&still, 2), [Quantity::TransversalityTimesDetuning]);
    assert_eq!(
        violations(&with_matrix(Matrix2::new(-0.2, 0.4, -0.5, 0.2)), 2),
        [Quantity::TransversalityTimesDetuning]
    );
}

#[test]
fn no_loop_is_not_a_periodic_solution() {
    assert!(violations(&generic(), 0).contains(&Quantity::Loops));
}

#[test]
fn violated_hypothesis_holds_its_number_and_reads_as_a_sentence() {
    let point = GrazingPoint { gamma: -0.25, ..generic() };
    let violated = GenericGrazing::check(&point, 2).expect_err("gamma is negative");
    assert_eq!(violated.theorem, Theorem::GenericMultiLoop);
    assert_eq!(violated.violated().map(|hypothesis| hypothesis.value).collect::<Vec<_>>(), [-0.25]);
    assert_eq!(
        violated.to_string(),
        "theorem 2.3 (generic grazing, p >= 2) does not apply: it needs gamma > 0, where gamma is -0.25"
    );
}

#[test]
fn not_a_number_never_passes() {
    for point in [
        GrazingPoint { gamma: f64::NAN, ..generic() },
        GrazingPoint { phi: f64::NAN, ..generic() },
        GrazingPoint { psi: f64::NAN, ..generic() },
        GrazingPoint { forcing_frequency: f64::INFINITY, ..generic() },
        with_matrix(Matrix2::new(0.3, f64::NAN, -0.5, 0.2)),
    ] {
        for p in [1, 2, 3] {
            assert!(GenericGrazing::check(&point, p).is_err());
        }
    }
}

#[test]
fn resonant_point_has_no_orbit_that_is_linear_in_the_parameter() {
    let point = with_matrix(Matrix2::new(0.2, 0.4, -1.0, -0.2));
    assert_eq!(point.map.trace(), 0.0);
    assert_eq!(point.emerging_orbit(2), Err(TheoryError::SingularVividJacobian { determinant: 0.0 }));
    assert!(point.emerging_orbit(1).is_ok() && point.emerging_orbit(3).is_ok());
    assert_eq!(point.emerging_orbit(0), Err(TheoryError::TooFewLoops { loops: 0, minimum: 1 }));
}
