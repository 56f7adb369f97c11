//! The unfolding of a resonance against solutions of the equations that it expands, and against itself for
//! iterates.

use nalgebra::{Vector2, Vector3};
use proptest::prelude::*;

use grazing_theorems::auxiliary::modulus_power;
use grazing_theorems::{GrazingPoint, ResonantGrazing, ResonantPoint, Unfolding};

use super::truncated_system::{Multiplier, TruncatedSystem, multi_loop, one_loop};
use super::{assert_close, assert_within, deterministic, grazing_points};

/// Resonant systems with multipliers of both signs, real and complex.
fn systems() -> Vec<(u32, TruncatedSystem)> {
    vec![
        (1, one_loop(0.6, 0.35)),
        (1, one_loop(-0.5, -0.7)),
        (2, multi_loop(2, 0.45, 0.3, 0.5)),
        (2, multi_loop(2, 0.2, -0.4, 0.9)),
        (3, multi_loop(3, 0.5, 0.2, 0.6)),
        (4, multi_loop(4, 0.6, 0.7, 0.4)),
    ]
}

/// The values at 0 of the polynomials through values at `step / 2^k`: Neville's scheme, component by
/// component.
fn extrapolated<const N: usize>(values: &[[f64; N]]) -> [f64; N] {
    let mut column = values.to_vec();
    let mut power = 1.0;
    while column.len() > 1 {
        power *= 2.0;
        column = column
            .windows(2)
            .map(|pair| {
                core::array::from_fn(|index| (power * pair[1][index] - pair[0][index]) / (power - 1.0))
            })
            .collect();
    }
    column[0]
}

/// `step / 2^k` for k from 0 to 5.
fn halvings(step: f64) -> impl Iterator<Item = f64> {
    (0..6).scan(step, |size, _| {
        let current = *size;
        *size *= 0.5;
        Some(current)
    })
}

#[test]
fn branch_expansion_is_the_limit_of_solutions_of_the_vivid_function() {
    for (p, system) in systems() {
        let branch = system.resonant_point(p).branch_expansion();
        for (velocity, share) in [(1.0, 0.0), (1.0, 0.8), (0.6, -1.0)] {
            let expected = Vector2::new(branch.k_1 * velocity, branch.parameter(velocity, share));
            let values: Vec<[f64; 2]> = halvings(0.02)
                .map(|size| system.on_branch(p, size, velocity, share, expected).into())
                .collect();
            let [phase, parameter] = extrapolated(&values);
            // Six halvings from 0.02 leave a truncation error of order 1e-13; Newton stops at 1e-12, scaled
            // quantities of order one.
            assert_within(phase, expected.x, 1e-9 * (1.0 + expected.x.abs()));
            assert_within(parameter, expected.y, 1e-9 * (1.0 + expected.y.abs()));
        }
    }
}

#[test]
fn bifurcation_curves_have_the_coefficients_and_directions_of_the_theorem() {
    for (p, system) in systems() {
        let point = system.resonant_point(p);
        let theorem = ResonantGrazing::check(&point, 1e-14).expect("the hypotheses hold");
        for (curve, multiplier) in
            [(theorem.saddle_node(), Multiplier::One), (theorem.period_doubling(), Multiplier::MinusOne)]
        {
            let side = curve.eta_side.signum();
            let expected =
                Vector3::new(curve.impact_velocity_slope, curve.impact_phase_slope, curve.coefficient);
            let values: Vec<[f64; 3]> = halvings(0.004)
                .map(|eta| system.bifurcation(p, side * eta, multiplier, expected).into())
                .collect();
            // The impact velocity eta Y is positive: the solution exists on this side.
            assert!(values.iter().all(|value| value[0] * side > 0.0));
            let limit = extrapolated(&values);
            let size = expected.amax();
            for index in 0..3 {
                // As for the branch, with more amplification since the bifurcation point is ill-conditioned
                // in y.
                assert_within(limit[index], expected[index], 1e-8 * size);
            }
            // The error of the quadratic approximation is O(eta^3), so that of mu / eta^2 halves with eta.
            let ratio = (values[3][2] - expected.z) / (values[4][2] - expected.z);
            assert!((1.7..2.3).contains(&ratio), "p = {p}: errors shrink by {ratio}");
        }
    }
}

#[test]
fn wrong_sign_of_eta_makes_the_bifurcating_solution_virtual() {
    for (p, system) in systems() {
        let theorem = ResonantGrazing::check(&system.resonant_point(p), 1e-14).expect("the hypotheses hold");
        let curve = theorem.saddle_node();
        let guess = Vector3::new(curve.impact_velocity_slope, curve.impact_phase_slope, curve.coefficient);
        let eta = -0.001 * curve.eta_side.signum();
        let solution = system.bifurcation(p, eta, Multiplier::One, guess);
        assert!(eta * solution.x < 0.0, "p = {p}: impact velocity {}", eta * solution.x);
        assert_eq!(curve.parameter(eta), None);
        assert_eq!(curve.parameter(-eta), Some(curve.coefficient * eta * eta));
        assert_eq!(curve.parameter(0.0), Some(0.0));
    }
}

/// The same resonance seen as one of one loop, of the p-th iterate of the global map.
fn as_one_loop(point: &ResonantPoint) -> ResonantPoint {
    ResonantPoint {
        grazing: GrazingPoint { map: point.grazing.map.iterate(point.loops()), ..point.grazing },
        unfolding: Unfolding::OneLoop { off_diagonal_derivative: point.off_diagonal_slope() },
        ..*point
    }
}

proptest! {
    #![proptest_config(deterministic(256))]

    #[test]
    fn many_loops_are_one_loop_of_the_iterate(
        p in 2_u32..8,
        delta in 0.05..0.95_f64,
        a11 in -1.0..1.0_f64,
        a12 in 0.2..1.5_f64,
        xi in -2.0..2.0_f64,
        detuning_derivative in 0.1..2.0_f64,
    ) {
        let grazing = multi_loop(p, delta, a11, a12).point;
        let unfolding = Unfolding::MultiLoop { loops: p, detuning_derivative };
        let point = ResonantPoint { grazing, second_phase_derivative: xi, unfolding };
        let other = as_one_loop(&point);
        let (here, there) = (point.stability_coefficients(), other.stability_coefficients());
        // The iterate is exact up to some tens of roundings of numbers of order ten; small s and beta magnify
        // these.
        assert_within(here.plus, there.plus, 1e-11);
        assert_within(here.minus, there.minus, 1e-11);
        prop_assume!(here.plus.abs() > 0.01 && here.minus.abs() > 0.01);
        prop_assume!(grazing.map.transversality().abs() > 0.01);
        assert_close(point.saddle_node_coefficient(), other.saddle_node_coefficient(), 1e-8);
        assert_within(
            point.period_doubling_coefficient(),
            other.period_doubling_coefficient(),
            1e-8 * point.period_doubling_coefficient().abs().max(point.saddle_node_coefficient().abs()),
        );
        assert_close(point.saddle_node_velocity_slope(), other.saddle_node_velocity_slope(), 1e-8);
        assert_close(point.period_doubling_velocity_slope(), other.period_doubling_velocity_slope(), 1e-8);
        let (here, there) = (point.branch_expansion(), other.branch_expansion());
        assert_within(here.k_1, there.k_1, 1e-10);
        assert_close(here.k_2, there.k_2, 1e-8);
        assert_close(here.k_3, there.k_3, 1e-8);
    }

    #[test]
    fn curves_lie_on_the_branch(point in grazing_points(), xi in -2.0..2.0_f64, derivative in 0.1..2.0_f64) {
        // mu = k_2 y^2 + k_3 eta y at y = Upsilon eta, for one loop: a12 is made zero.
        let mut grazing = point;
        grazing.map.a.m12 = 0.0;
        prop_assume!(grazing.map.transversality().abs() > 1e-3);
        let unfolding = Unfolding::OneLoop { off_diagonal_derivative: derivative };
        let point = ResonantPoint { grazing, second_phase_derivative: xi, unfolding };
        let stability = point.stability_coefficients();
        prop_assume!(stability.plus.abs() > 1e-3 && stability.minus.abs() > 1e-3);
        let branch = point.branch_expansion();
        let fold = point.saddle_node_velocity_slope();
        // The fold is where mu is extreme: k_2 y^2 + k_3 y at y = -k_3 / (2 k_2) would be the extremum of a
        // parabola, and it is.
        assert_close(fold, -branch.k_3 / (2.0 * branch.k_2), 1e-12);
        let terms = (branch.k_3 * fold).abs();
        assert_within(point.saddle_node_coefficient(), branch.parameter(fold, 1.0), 1e-12 * terms);
        let flip = point.period_doubling_velocity_slope();
        let terms = (branch.k_3 * flip).abs() + (branch.k_2 * flip * flip).abs();
        assert_within(point.period_doubling_coefficient(), branch.parameter(flip, 1.0), 1e-12 * terms);
    }
}

#[test]
fn slope_of_the_off_diagonal_entry_is_the_derivative_of_the_iterate() {
    for (p, system) in systems() {
        let point = system.resonant_point(p);
        // Central differences: the truncation error is of order step^2 = 1e-10, the rounding error 1e-16 /
        // step = 1e-11.
        let step = 1e-5;
        let entry = |eta: f64| {
            let mut map = system.point.map;
            map.a += system.drift * eta;
            map.iterate(p).a.m12
        };
        assert_within(point.off_diagonal_slope(), (entry(step) - entry(-step)) / (2.0 * step), 1e-9);
    }
}

#[test]
fn modulus_power_is_the_modulus_of_the_eigenvalues_of_the_iterate() {
    for (p, system) in systems().into_iter().filter(|(p, _)| *p >= 2) {
        let iterate = system.point.map.iterate(p);
        // At the resonance A^p = -delta^{p/2} I up to the off-diagonal entry a21 S_p = 0; tens of roundings.
        let modulus = modulus_power(p, system.point.map.determinant());
        assert_within(iterate.a.m11, -modulus, 1e-14);
        assert_within(iterate.a.m22, -modulus, 1e-14);
    }
}
