//! The auxiliary functions at points where their values are known; lemmas and appendix A are
//! checked by the ledger of claims.

use core::f64::consts::PI;

use grazing_theorems::auxiliary::{
    admissibility_sum, detuning, geometric_sum_determinant, lucas_partial_sum, lucas_sequence,
    resonance_boundary,
};

use super::assert_within;

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
        // p to infinity: 2 sqrt(delta), the right edge of the complex eigenvalues, approached like
        // pi^2 / (2 p^2).
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
