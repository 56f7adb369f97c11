//! Lemmas 2.1, 4.2, A.1 and the closed forms of appendix A, on the functions of module `auxiliary`.

use core::f64::consts::PI;

use nalgebra::Complex;
use proptest::prelude::*;

use grazing_theorems::auxiliary::{
    admissibility_sum, detuning, geometric_sum_determinant, lucas_partial_sum, lucas_sequence, modulus_power,
    resonance_boundary, scaled_visit_position,
};

use super::{admissible, assert_close, assert_within, deterministic, trapesium};

/// The eigenvalues as complex numbers, by eq. (13) of section 2.
fn complex_eigenvalues(tau: f64, delta: f64) -> (Complex<f64>, Complex<f64>) {
    let discriminant = tau * tau - 4.0 * delta;
    let root = discriminant.abs().sqrt();
    let root = if discriminant < 0.0 { Complex::new(0.0, root) } else { Complex::new(root, 0.0) };
    ((root + tau) * 0.5, (-root + tau) * 0.5)
}

/// `lambda^k` by repeated multiplication.
fn power(lambda: Complex<f64>, k: u32) -> Complex<f64> {
    (0..k).fold(Complex::new(1.0, 0.0), |product, _| product * lambda)
}

/// The sums of the moduli of the terms in the definitions of S_j, T_p and H_p: rounding errors are small
/// compared to these.
struct Majorants {
    s: f64,
    t: f64,
    h: f64,
}

fn majorants(p: u32, tau: f64, delta: f64) -> Majorants {
    let (lambda_1, lambda_2) = complex_eigenvalues(tau, delta);
    let (tau, delta) = (lambda_1.norm() + lambda_2.norm(), lambda_1.norm() * lambda_2.norm());
    Majorants {
        s: lucas_sequence(p, tau, delta),
        t: lucas_partial_sum(p, tau, delta),
        h: admissibility_sum(p, tau, delta),
    }
}

/// The closed forms divide by `lambda_1 - lambda_2` and by `1 - lambda`; at these distances they keep twelve
/// digits.
fn closed_forms_are_accurate(tau: f64, delta: f64) -> bool {
    (tau * tau - 4.0 * delta).abs() > 0.01 && delta - tau + 1.0 > 0.02
}

proptest! {
    #![proptest_config(deterministic(512))]

    #[test]
    fn recurrences_agree_with_the_sums_over_eigenvalues((tau, delta) in trapesium(), p in 0_u32..16) {
        let (lambda_1, lambda_2) = complex_eigenvalues(tau, delta);
        let s = |j: u32| (1..=j).map(|k| power(lambda_1, j - k) * power(lambda_2, k - 1)).sum::<Complex<f64>>();
        let t = (1..p).map(s).sum::<Complex<f64>>();
        let h = (1..p)
            .flat_map(|j| (1..=j).map(move |k| (power(lambda_1, j - k) * power(lambda_2, k - 1)).finv()))
            .sum::<Complex<f64>>();
        // p^2 terms and as many roundings; the eigenvalues lose digits near the double one, but the sums are
        // symmetric in them.
        let Majorants { s: s_size, t: t_size, h: h_size } = majorants(p, tau, delta);
        assert_within(lucas_sequence(p, tau, delta), s(p).re, 1e-13 * s_size);
        assert_within(lucas_partial_sum(p, tau, delta), t.re, 1e-13 * t_size);
        assert_within(admissibility_sum(p, tau, delta), h.re, 1e-12 * h_size);
    }

    #[test]
    fn recurrences_agree_with_the_quotients_of_powers((tau, delta) in trapesium(), p in 2_u32..16) {
        prop_assume!(closed_forms_are_accurate(tau, delta));
        let (lambda_1, lambda_2) = complex_eigenvalues(tau, delta);
        let one = Complex::new(1.0, 0.0);
        let difference = lambda_1 - lambda_2;
        let (top_1, top_2) = (power(lambda_1, p), power(lambda_2, p));
        let (low_1, low_2) = (power(lambda_1, p - 1), power(lambda_2, p - 1));
        let product = (one - lambda_1) * (one - lambda_2) * difference;
        // eq:Sp2, eq:Tp2, eq:Tp3, eq:Hp2, eq:Hp3
        let s = (top_1 - top_2) / difference;
        let t_sum = (1..p).map(|j| power(lambda_1, j) - power(lambda_2, j)).sum::<Complex<f64>>() / difference;
        let t = (difference - (top_1 - top_2) + (low_1 - low_2) * delta) / product;
        let h_sum = (1..p).map(|j| power(lambda_2, j).finv() - power(lambda_1, j).finv()).sum::<Complex<f64>>()
            * delta
            / difference;
        let h = (low_1 * low_2 * difference - (top_1 - top_2) + (low_1 - low_2))
            / (product * power(lambda_1 * lambda_2, p - 2));
        // Division by |lambda_1 - lambda_2| >= 0.1 and (1 - lambda_1)(1 - lambda_2) >= 0.02 magnifies
        // roundings by up to 500.
        let Majorants { s: s_size, t: t_size, h: h_size } = majorants(p, tau, delta);
        assert_within(lucas_sequence(p, tau, delta), s.re, 1e-12 * (1.0 + s_size));
        assert_within(lucas_partial_sum(p, tau, delta), t_sum.re, 1e-12 * (1.0 + t_size));
        assert_within(lucas_partial_sum(p, tau, delta), t.re, 1e-11 * (1.0 + t_size));
        assert_within(admissibility_sum(p, tau, delta), h_sum.re, 1e-11 * (1.0 + h_size));
        assert_within(admissibility_sum(p, tau, delta), h.re, 1e-10 * (1.0 + h_size));
        // eq:detJac2
        let factor = (one - top_1) * (one - top_2) / ((one - lambda_1) * (one - lambda_2));
        assert_within(geometric_sum_determinant(p, tau, delta), factor.re, 1e-11 * (1.0 + t_size * t_size));
    }

    #[test]
    fn recurrences_agree_with_the_polar_forms(
        delta in 0.001..0.999_f64,
        theta in 0.05..3.09_f64,
        p in 2_u32..16,
    ) {
        let r = delta.sqrt();
        let tau = 2.0 * r * libm::cos(theta);
        prop_assume!(delta - tau + 1.0 > 0.02);
        let sine = |k: u32| libm::sin(f64::from(k) * theta);
        let raised = |k: i32| libm::pow(r, f64::from(k));
        let (order, gap) = (p as i32, delta - tau + 1.0);
        // eq:Sp3, eq:Tp6, eq:Tp4, eq:Tp5 with the factored Xi, eq:Hp4, eq:Hp5
        let s = raised(order - 1) * sine(p) / sine(1);
        let t = (sine(1) - raised(order - 1) * sine(p) + raised(order) * sine(p - 1)) / (gap * sine(1));
        let t_sum = (1..p).map(|j| raised(j as i32 - 1) * sine(j)).sum::<f64>() / sine(1);
        let half = |k: u32| libm::sin(0.5 * f64::from(k) * theta);
        let xi = 4.0 * half(1) * half(p - 1) * half(p);
        let t_grouped = (raised(order - 1) * xi - raised(order - 1) * (1.0 - r) * sine(p - 1)
            + (1.0 - raised(order - 1)) * sine(1))
            / (gap * sine(1));
        let h_sum = (1..p).map(|j| raised(1 - j as i32) * sine(j)).sum::<f64>() / sine(1);
        let h = (raised(order) * sine(1) - r * sine(p) + sine(p - 1)) / (gap * raised(order - 2) * sine(1));
        // Division by sin(theta) >= 0.05 and the gap >= 0.02 magnifies roundings by up to 1000.
        let Majorants { s: s_size, t: t_size, h: h_size } = majorants(p, tau, delta);
        assert_within(lucas_sequence(p, tau, delta), s, 1e-12 * (1.0 + s_size));
        assert_within(lucas_partial_sum(p, tau, delta), t_sum, 1e-12 * (1.0 + t_size));
        assert_within(lucas_partial_sum(p, tau, delta), t, 1e-11 * (1.0 + t_size));
        assert_within(lucas_partial_sum(p, tau, delta), t_grouped, 1e-11 * (1.0 + t_size));
        assert_within(admissibility_sum(p, tau, delta), h_sum, 1e-12 * (1.0 + h_size));
        assert_within(admissibility_sum(p, tau, delta), h, 1e-10 * (1.0 + h_size));
    }

    #[test]
    fn admissibility_sum_is_a_difference_of_products((tau, delta) in trapesium(), p in 1_u32..16) {
        // eq:Hp9, multiplied by delta^{p-2} so that small delta does no harm.
        let (s, s_before) = (lucas_sequence(p, tau, delta), lucas_sequence(p - 1, tau, delta));
        let (t, t_before) = (lucas_partial_sum(p, tau, delta), lucas_partial_sum(p - 1, tau, delta));
        let scaled = admissibility_sum(p, tau, delta) * libm::pow(delta, f64::from(p) - 2.0);
        let Majorants { s: s_size, t: t_size, h: h_size } = majorants(p, tau, delta);
        let size = s_size * t_size + h_size * libm::pow(delta, f64::from(p) - 2.0);
        // Some tens of roundings in each of the three.
        assert_within(s_before * t - s * t_before, scaled, 1e-13 * (1.0 + size));
    }

    #[test]
    fn lemma_4_2_a_sign_of_s_is_the_sign_of_the_detuning((p, tau, delta) in admissible(2..=24)) {
        let kappa = detuning(p, tau, delta);
        // At a distance 1e-9 the sign is far above the rounding of S_p, some p^2 times 1e-16 of the same
        // scale.
        prop_assume!(kappa.abs() > 1e-9);
        prop_assert!(lucas_sequence(p, tau, delta) * kappa > 0.0);
    }

    #[test]
    fn lemma_4_2_b_values_at_the_resonance(p in 2_u32..24, delta in 0.001..0.999_f64) {
        let tau = resonance_boundary(f64::from(p), delta);
        let modulus = modulus_power(p, delta);
        let Majorants { s: s_size, t: t_size, .. } = majorants(p + 1, tau, delta);
        // tau is rounded, and S_{p+1}, T_p change by at most p times their majorants over sqrt(delta) per
        // unit of tau.
        let slack = 1e-14 * f64::from(p) / delta.sqrt();
        assert_within(lucas_sequence(p, tau, delta), 0.0, slack * s_size);
        assert_within(lucas_sequence(p + 1, tau, delta), -modulus, slack * s_size);
        let t_p = (1.0 + modulus) / (delta - tau + 1.0);
        assert_within(lucas_partial_sum(p, tau, delta), t_p, slack * t_size);
    }

    #[test]
    fn lemma_4_2_c_t_is_positive_from_half_the_resonance_on(
        p in 2_u32..24,
        delta in 0.001..0.999_f64,
        share in 0.0..=1.0_f64,
    ) {
        let lowest = resonance_boundary(0.5 * f64::from(p), delta);
        let tau = lowest + share * (delta + 1.0 - lowest);
        prop_assert!(lucas_partial_sum(p, tau, delta) > 0.0);
    }

    #[test]
    fn all_visits_between_the_impacts_stay_below_the_wall_above_the_admissibility_boundary(
        (p, tau, delta) in admissible(2..=24),
    ) {
        for j in 1..p {
            prop_assert!(scaled_visit_position(j, p, tau, delta) < 0.0, "j = {}", j);
        }
        assert_within(scaled_visit_position(0, p, tau, delta), 0.0, 0.0);
        assert_within(scaled_visit_position(p, p, tau, delta), 0.0, 0.0);
    }

    #[test]
    fn first_and_last_visit_have_their_short_forms((tau, delta) in trapesium(), p in 2_u32..16) {
        // eq:u1codim1proof, eq:upm1codim1proof
        prop_assert_eq!(scaled_visit_position(1, p, tau, delta), -lucas_partial_sum(p, tau, delta));
        let last = -libm::pow(delta, f64::from(p) - 2.0) * admissibility_sum(p, tau, delta);
        let Majorants { s: s_size, t: t_size, h: h_size } = majorants(p, tau, delta);
        let size = s_size * t_size + h_size * libm::pow(delta, f64::from(p) - 2.0);
        // As for the difference of products above.
        assert_within(scaled_visit_position(p - 1, p, tau, delta), last, 1e-13 * (1.0 + size));
    }

    #[test]
    fn visits_at_a_unit_eigenvalue_have_a_closed_form(delta in 0.001..0.99_f64, p in 2_u32..24) {
        // eq:ujeig1 at tau = delta + 1, and lemma A.1 on its numerator
        let tau = delta + 1.0;
        let raised = |k: u32| libm::pow(delta, f64::from(k));
        for j in 1..p {
            let numerator = f64::from(j) * (1.0 - raised(p)) - f64::from(p) * (1.0 - raised(j));
            prop_assert!(numerator < 0.0, "lemma A.1 with j = {}", j);
            let expected = numerator / ((1.0 - delta) * (1.0 - delta));
            // The numerator cancels terms of order p, and is divided by at least 1e-4; S and T reach p and
            // p^2.
            let slack = 1e-15 * f64::from(p) / ((1.0 - delta) * (1.0 - delta)) + 1e-13 * f64::from(p * p * p);
            assert_within(scaled_visit_position(j, p, tau, delta), expected, slack);
        }
        let determinant = f64::from(p) * (1.0 - raised(p)) / (1.0 - delta);
        assert_close(geometric_sum_determinant(p, tau, delta), determinant, 1e-10);
    }

    #[test]
    fn determinant_of_the_geometric_sum_is_positive_in_the_trapesium(
        (tau, delta) in trapesium(),
        p in 1_u32..24,
    ) {
        prop_assert!(geometric_sum_determinant(p, tau, delta) > 0.0);
    }
}

#[test]
fn short_sums_are_exact() {
    let (tau, delta) = (0.5, 0.25);
    assert_eq!([0, 1, 2, 3].map(|j| lucas_sequence(j, tau, delta)), [0.0, 1.0, tau, tau * tau - delta]);
    assert_eq!([0, 1, 2, 3].map(|p| lucas_partial_sum(p, tau, delta)), [0.0, 0.0, 1.0, 1.0 + tau]);
    assert_eq!([0, 1, 2, 3].map(|p| admissibility_sum(p, tau, delta)), [0.0, 0.0, 1.0, 1.0 + tau / delta]);
    assert_eq!([0, 1].map(|p| geometric_sum_determinant(p, tau, delta)), [0.0, 1.0]);
    // det(I + A) = 1 + tau + delta
    assert_eq!(geometric_sum_determinant(2, tau, delta), 1.0 + tau + delta);
}

#[test]
fn resonance_boundary_is_the_scaled_cosine() {
    for delta in [0.04, 0.25, 0.81_f64] {
        let r = delta.sqrt();
        assert_eq!(resonance_boundary(1.0, delta), -2.0 * r);
        assert_eq!(resonance_boundary(2.0, delta), 0.0);
        for p in [1.25, 1.5, 2.5, 3.0, 4.0, 7.0, 40.0] {
            // Both forms of the cosine are off by a few units in the last place of 1.
            assert_within(resonance_boundary(p, delta), 2.0 * r * libm::cos(PI / p), 1e-15);
        }
        // p to infinity: 2 sqrt(delta), the right edge of the complex eigenvalues, approached like pi^2 / (2
        // p^2).
        assert_within(resonance_boundary(1e6, delta), 2.0 * r, 2.0 * r * 5e-12);
    }
    assert!(resonance_boundary(3.0, -0.1).is_nan());
}

#[test]
fn detuning_vanishes_at_the_resonance_only() {
    let delta = 0.49;
    for p in 2..9 {
        let boundary = resonance_boundary(f64::from(p), delta);
        assert_eq!(detuning(p, boundary, delta), 0.0);
        assert!(detuning(p, boundary + 0.01, delta) > 0.0);
        assert!(detuning(p, boundary - 0.01, delta) < 0.0);
    }
}
