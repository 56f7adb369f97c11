//! The discontinuity map, the linearised VIVID function and the emerging orbit, against direct composition of
//! maps.

use nalgebra::{Matrix2, Vector2};
use proptest::prelude::*;

use grazing_theorems::auxiliary::{lucas_sequence, scaled_visit_position};
use grazing_theorems::{GrazingPoint, LinearisedMap, TheoryError};

use super::{assert_close, assert_within, deterministic, grazing_points};

/// `P_global^p (P_virt o R) - P_virt` with every map replaced by its linear part, the global map applied `p`
/// times.
fn composed(point: &GrazingPoint, p: u32, y: f64, z: f64, mu: f64) -> Vector2<f64> {
    let after_reset = point.virtual_map_after_reset();
    let virtual_map = point.virtual_map();
    let mut visit = Vector2::new(0.0, z + after_reset.z_coefficient * y);
    for _ in 0..p {
        visit = point.map.a * visit + point.map.b * mu;
    }
    visit - Vector2::new(0.0, z + virtual_map.z_coefficient * y)
}

/// The size of the terms that the compositions add up.
fn scale(point: &GrazingPoint, p: u32) -> f64 {
    let LinearisedMap { a, b } = point.map.iterate(p);
    let shift = point.forcing_frequency / point.gamma * (1.0 + point.alpha().abs());
    (1.0 + shift) * (1.0 + a.amax() + b.amax()) * (1.0 + point.map.a.amax())
}

proptest! {
    #![proptest_config(deterministic(256))]

    #[test]
    fn linearised_vivid_function_is_the_composition_of_linear_parts(
        point in grazing_points(),
        p in 1_u32..9,
    ) {
        let vivid = point.vivid_linearisation(p);
        let directions = [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)];
        let [by_velocity, by_phase] = [0, 1].map(|index| vivid.by_impact.column(index).into_owned());
        let columns = [by_velocity, by_phase, vivid.by_parameter];
        for ((y, z, mu), column) in directions.into_iter().zip(columns) {
            let difference = composed(&point, p, y, z, mu) - column;
            // Tens of roundings in each route, in numbers of the size of the terms.
            prop_assert!(difference.amax() <= 1e-12 * scale(&point, p), "{}", difference);
        }
    }

    #[test]
    fn lemma_4_3_determinants(point in grazing_points(), p in 1_u32..9) {
        let vivid = point.vivid_linearisation(p);
        let size = scale(&point, p) * scale(&point, p);
        // The determinants cancel products of entries.
        assert_within(point.impact_jacobian_determinant(p), vivid.by_impact.determinant(), 1e-12 * size);
        let by_matrix = vivid.by_phase_and_parameter().determinant();
        assert_within(point.parameter_jacobian_determinant(p), by_matrix, 1e-12 * size);
        assert_within(point.parameter_jacobian_determinant_factored(p), by_matrix, 1e-12 * size);
        // The form in which eq:detJac1detJac2 prints det(K).
        let (tau, delta) = (point.map.trace(), point.map.determinant());
        let (s, s_next) = (lucas_sequence(p, tau, delta), lucas_sequence(p + 1, tau, delta));
        let b_p = point.map.iterate(p).b;
        let printed = (1.0 - s_next + point.map.a.m11 * s) * b_p.x + point.map.a.m12 * s * b_p.y;
        assert_within(point.parameter_jacobian_determinant(p), printed, 1e-12 * size);
    }

    #[test]
    fn discontinuity_map_leads_from_the_one_virtual_maximum_to_the_other(
        point in grazing_points(),
        y in 0.0..2.0_f64,
        z in -1.0..7.0_f64,
    ) {
        let hat = point.virtual_map().apply(y, z);
        let expected = point.virtual_map_after_reset().apply(y, z);
        let computed = point.discontinuity_map(hat.x, hat.y);
        // y is recovered from a square root; the phase adds numbers of order 30.
        assert_close(computed.x, expected.x, 1e-15);
        assert_within(computed.y, expected.y, 1e-14 * (1.0 + hat.y.abs() + expected.y.abs()));
    }

    #[test]
    fn emerging_orbit_is_a_zero_of_the_linearised_vivid_function(point in grazing_points(), p in 1_u32..9) {
        prop_assume!(point.impact_jacobian_determinant(p).abs() > 1e-3);
        let orbit = point.emerging_orbit(p).expect("det(J) is not zero");
        let (y, z) = (orbit.impact_velocity_slope, orbit.impact_phase_slope);
        let size = scale(&point, p) * (1.0 + y.abs() + z.abs());
        let residual = composed(&point, p, y, z, 1.0);
        // The slopes are quotients with a denominator of at least 1e-3.
        prop_assert!(residual.amax() <= 1e-10 * size, "{}", residual);
        // It starts where the recoil says and ends where the impact says.
        let start = Vector2::new(0.0, point.virtual_map_after_reset().apply(y, z).y);
        let end = Vector2::new(0.0, point.virtual_map().apply(y, z).y);
        prop_assert!((orbit.visit_slope(0) - start).amax() <= 1e-10 * size);
        prop_assert!((orbit.visit_slope(p) - end).amax() <= 1e-10 * size);
    }

    #[test]
    fn visits_are_images_of_each_other_and_scale_to_u(point in grazing_points(), p in 2_u32..9) {
        prop_assume!(point.impact_jacobian_determinant(p).abs() > 1e-3);
        let orbit = point.emerging_orbit(p).expect("det(J) is not zero");
        let (tau, delta, beta) = (point.map.trace(), point.map.determinant(), point.map.transversality());
        let s_p = lucas_sequence(p, tau, delta);
        for j in 0..=p {
            let visit = orbit.visit_slope(j);
            let size = scale(&point, p) * scale(&point, j) * (1.0 + visit.amax()) / s_p.abs().min(1.0);
            // eq:ujcodim1proof and eq:ujwj
            assert_within(visit.x, beta / s_p * scaled_visit_position(j, p, tau, delta), 1e-11 * size);
            if j > 0 {
                let image = point.map.a * orbit.visit_slope(j - 1) + point.map.b;
                prop_assert!((visit - image).amax() <= 1e-11 * size);
            }
        }
    }

    #[test]
    fn one_loop_orbit_has_the_short_forms(point in grazing_points()) {
        prop_assume!(point.impact_jacobian_determinant(1).abs() > 1e-3);
        let orbit = point.emerging_orbit(1).expect("det(J) is not zero");
        let GrazingPoint { map: LinearisedMap { a, b }, forcing_frequency, gamma, .. } = point;
        let alpha = point.alpha();
        // eq:yStar1codim1proof, eq:zStar1codim1proof
        let velocity = gamma * point.map.transversality() / (alpha * a.m12 * forcing_frequency);
        let phase = ((a.m22 * (1.0 - alpha) - 1.0) * b.x - a.m12 * (1.0 - alpha) * b.y) / (alpha * a.m12);
        // beta and the bracket cancel numbers of order ten.
        let size = scale(&point, 1) / (alpha * a.m12).abs();
        let velocity_size = size * (1.0 + gamma / forcing_frequency);
        assert_within(orbit.impact_velocity_slope, velocity, 1e-13 * velocity_size);
        assert_within(orbit.impact_phase_slope, phase, 1e-13 * size);
    }
}

#[test]
fn resonant_point_has_no_orbit_that_is_linear_in_the_parameter() {
    let map = LinearisedMap { a: Matrix2::new(0.2, 0.4, -1.0, -0.2), b: Vector2::new(0.5, 0.1) };
    let point = GrazingPoint { map, forcing_frequency: 1.0, gamma: 1.0, phi: 0.8, psi: 0.0 };
    assert_eq!(point.map.trace(), 0.0);
    assert_eq!(point.emerging_orbit(2), Err(TheoryError::SingularVividJacobian { determinant: 0.0 }));
    assert!(point.emerging_orbit(1).is_ok());
    assert!(point.emerging_orbit(3).is_ok());
    assert_eq!(point.emerging_orbit(0), Err(TheoryError::TooFewLoops { loops: 0, minimum: 1 }));
}

#[test]
fn impacts_that_take_no_time_have_alpha_one_plus_restitution() {
    let map = LinearisedMap { a: Matrix2::identity() * 0.5, b: Vector2::zeros() };
    let point = GrazingPoint { map, forcing_frequency: 2.0, gamma: 3.0, phi: 0.75, psi: 0.0 };
    assert_eq!(point.alpha(), 1.75);
    assert_eq!(GrazingPoint { psi: 0.5, ..point }.alpha(), 1.0);
}
