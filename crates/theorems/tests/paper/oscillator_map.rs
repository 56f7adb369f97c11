//! The oscillator at grazing, closed forms against automatic differentiation of the return map.

use nalgebra::{Matrix2, Vector2};
use num_dual::{
    Dual2_64, Dual64, DualNum, HyperDual64, first_derivative, second_derivative, second_partial_derivative,
};

use grazing_theorems::{GrazingState, LinearOscillator, TheoryError};

use super::oscillator_flow::{Flow, grazing_amplitude, grazing_phase};
use super::{assert_close, assert_within};

/// Damping ratio and forcing frequency: weak and strong damping, below and above the natural frequency,
/// resonant or not.
const STATES: [(f64, f64); 7] =
    [(0.03, 0.71), (0.03, 1.4), (0.1, 0.48), (0.1, 1.9), (0.35, 0.9), (0.6, 1.1), (0.9, 2.5)];

fn state(zeta: f64, omega: f64) -> GrazingState {
    LinearOscillator::new(zeta, 0.8).expect("valid").grazing(omega).expect("valid")
}

#[test]
fn grazing_amplitude_phase_and_their_slopes_are_those_of_the_periodic_solution() {
    for (zeta, omega) in STATES {
        let state = state(zeta, omega);
        let (amplitude, amplitude_derivative) =
            first_derivative(|w: Dual64| grazing_amplitude(zeta, w), omega);
        let (phase, phase_derivative) = first_derivative(|w: Dual64| grazing_phase(zeta, w), omega);
        // A handful of roundings each; the arc cosine loses some digits where the phase is near 0 or pi.
        assert_close(state.amplitude(), amplitude, 1e-15);
        assert_close(state.amplitude_derivative(), amplitude_derivative, 1e-13);
        assert_close(state.phase(), phase, 1e-12);
        assert_close(state.phase_derivative(), phase_derivative, 1e-11);
        // At this amplitude and phase the periodic solution touches the wall: it returns to where it started.
        let (x, z) = Flow::near_grazing(zeta, omega, 0.0).returned(1, 0.0, state.phase());
        assert_within(x, 0.0, 1e-14);
        assert_within(z, state.phase(), 1e-14);
    }
}

#[test]
fn proposition_3_1_first_derivatives_of_the_return_map() {
    for (zeta, omega) in STATES {
        let state = state(zeta, omega);
        let derivative = |direction: [f64; 3]| {
            let [x, z, mu] = direction;
            let flow = Flow::near_grazing(zeta, Dual64::from(omega), Dual64::new(0.0, mu));
            let (x, z) = flow.returned(1, Dual64::new(0.0, x), Dual64::new(state.phase(), z));
            Vector2::new(x.eps, z.eps)
        };
        let a = Matrix2::from_columns(&[derivative([1.0, 0.0, 0.0]), derivative([0.0, 1.0, 0.0])]);
        let b = derivative([0.0, 0.0, 1.0]);
        let map = state.linearised_map();
        // Rounding of the angle 2 pi omega_1 / omega, up to 13, and of the quotients by omega_1 and A_graz,
        // as small as 0.4 and 0.4.
        assert!((map.a - a).amax() < 1e-13, "{} and {a}", map.a);
        assert!((map.b - b).amax() < 1e-12, "{} and {b}", map.b);
        assert_within(state.trace(), a.trace(), 1e-13);
        assert_within(state.determinant(), a.determinant(), 1e-13);
        assert_within(state.transversality(), map.transversality(), 1e-13 * (1.0 + map.b.amax()));
        assert_within(state.determinant(), map.determinant(), 1e-15 * (1.0 + a.amax() * a.amax()));
        assert_close(state.decay(1) * state.decay(1), state.determinant(), 1e-15);
        assert_close(state.decay_complement(1), 1.0 - state.decay(1), 1e-14);
    }
}

#[test]
fn non_impacting_solution_moves_to_the_wall_in_proportion_to_the_amplitude() {
    // x* = -1 + A / A_graz, so d x* / d mu = 1 / A_graz; the phase of the maximum does not depend on A.
    for (zeta, omega) in STATES {
        let state = state(zeta, omega);
        let map = state.linearised_map();
        let slope = map.fixed_point_slope().expect("1 is not an eigenvalue");
        // det(I - A) is as small as 0.02 for weak damping.
        assert_close(slope.x, 1.0 / state.amplitude(), 1e-12);
        assert_within(slope.y, 0.0, 1e-12 / state.amplitude());
    }
}

#[test]
fn second_phase_derivative_is_that_of_the_iterated_return_map() {
    for (zeta, omega) in STATES {
        let state = state(zeta, omega);
        for p in 1..=4 {
            let (_, first, second) = second_derivative(
                |z: Dual2_64| {
                    let flow = Flow::near_grazing(zeta, Dual2_64::from(omega), Dual2_64::from(0.0));
                    flow.returned(p, Dual2_64::from(0.0), z).0
                },
                state.phase(),
            );
            // Angles up to 50 radians are rounded to 1e-14.
            assert_within(state.second_phase_derivative(p), second, 1e-12);
            assert_within(state.linearised_map().iterate(p).a.m12, first, 1e-12);
        }
    }
}

#[test]
fn unfolding_derivatives_are_those_along_the_grazing_curve() {
    for (zeta, omega) in STATES {
        let state = state(zeta, omega);
        // d/d omega of the (1, 2) entry of A, with the grazing phase z_graz(omega) followed.
        let entry = |shift: HyperDual64, omega: HyperDual64| {
            let flow = Flow::near_grazing(zeta, omega, HyperDual64::from(0.0));
            flow.returned(1, HyperDual64::from(0.0), grazing_phase(zeta, omega) + shift).0
        };
        let (_, off_diagonal, _, derivative) = second_partial_derivative(|(z, w)| entry(z, w), (0.0, omega));
        // Angles up to 13 radians, divided by omega twice.
        assert_within(state.linearised_map().a.m12, off_diagonal, 1e-12);
        assert_within(state.off_diagonal_derivative(), derivative, 1e-10);
        for p in 2..=4 {
            // kappa_p from the eigenvalues exp(2 pi (-zeta +- i omega_1) / omega), differentiated.
            let omega_1 = (1.0 - zeta * zeta).sqrt();
            let cosine = libm::cos(core::f64::consts::PI / f64::from(p));
            let (value, derivative) = first_derivative(
                |w: Dual64| {
                    let radians = w.recip() * (2.0 * core::f64::consts::PI);
                    let modulus = (radians * -zeta).exp();
                    modulus * 2.0 * ((radians * omega_1).cos() - cosine)
                },
                omega,
            );
            // A dozen roundings of numbers of order ten.
            assert_within(state.detuning(p), value, 1e-14);
            assert_within(state.detuning_derivative(p), derivative, 1e-12);
        }
    }
}

#[test]
fn f_p_is_the_derivative_along_the_grazing_curve_and_not_at_fixed_phase() {
    let oscillator = LinearOscillator::new(0.1, 0.8).expect("valid");
    for (p, n) in [(1, 1), (1, 2), (2, 1), (3, 2)] {
        let resonance = oscillator.resonance(p, n).expect("valid");
        let grazing = resonance.grazing();
        let omega = resonance.forcing_frequency();
        let position = |z: HyperDual64, omega: HyperDual64| {
            let flow = Flow::near_grazing(0.1, omega, HyperDual64::from(0.0));
            flow.returned(p, HyperDual64::from(0.0), z).0
        };
        let (_, _, _, followed) =
            second_partial_derivative(|(shift, w)| position(grazing_phase(0.1, w) + shift, w), (0.0, omega));
        let (_, _, _, fixed) = second_partial_derivative(|(z, w)| position(z, w), (grazing.phase(), omega));
        let f_p = resonance.resonant_point().off_diagonal_slope();
        // Angles up to 50 radians, magnified by the derivative in omega.
        assert_close(f_p, followed, 1e-10);
        let drift = resonance.second_phase_derivative() * grazing.phase_derivative();
        assert_within(fixed, followed - drift, 1e-10);
        // The difference is no rounding matter.
        assert!(drift.abs() > 0.005, "p = {p}, n = {n}: {drift}");
    }
}

#[test]
fn virtual_maxima_have_errors_of_third_and_second_order() {
    // eq:xHatzHat and eq:x0z0: halving y, z - z_graz and mu together divides the errors by 8 (position) and 4
    // (phase).
    let epsilon = 0.8;
    for (zeta, omega) in STATES {
        let state = state(zeta, omega);
        let point = state.grazing_point();
        let errors = |size: f64| {
            let flow = Flow::near_grazing(zeta, omega, 0.3 * size);
            let (y, z) = (size, state.phase() + 0.7 * size);
            let hat = flow.virtual_maximum(y, z);
            let start = flow.virtual_maximum(-epsilon * y, z);
            let (hat_leading, start_leading) =
                (point.virtual_map().apply(y, z), point.virtual_map_after_reset().apply(y, z));
            [
                hat.0 - hat_leading.x,
                hat.1 - hat_leading.y,
                start.0 - start_leading.x,
                start.1 - start_leading.y,
            ]
        };
        // At this size the next order is at most some per cent of the leading error, and rounding 1e-16
        // against 1e-11.
        let (coarse, fine) = (errors(4e-4), errors(2e-4));
        for (index, order) in [8.0, 4.0, 8.0, 4.0].into_iter().enumerate() {
            let ratio = coarse[index] / fine[index];
            assert!(
                (ratio / order - 1.0).abs() < 0.05,
                "zeta = {zeta}, omega = {omega}: {ratio} for {order}"
            );
        }
    }
}

#[test]
fn frequencies_that_are_not_positive_are_refused() {
    let oscillator = LinearOscillator::new(0.1, 1.0).expect("valid");
    for omega in [0.0, -1.0, f64::INFINITY] {
        assert_eq!(oscillator.grazing(omega), Err(TheoryError::ForcingFrequency { omega }));
    }
    assert!(oscillator.grazing(f64::NAN).is_err());
}

#[test]
fn parameters_outside_their_intervals_are_refused() {
    for zeta in [0.0, 1.0, -0.1, f64::INFINITY] {
        assert_eq!(LinearOscillator::new(zeta, 0.5), Err(TheoryError::DampingRatio { zeta }));
    }
    for epsilon in [0.0, -0.5, f64::INFINITY] {
        let expected = TheoryError::CoefficientOfRestitution { epsilon };
        assert_eq!(LinearOscillator::new(0.5, epsilon), Err(expected));
    }
    assert!(LinearOscillator::new(f64::NAN, 0.5).is_err());
    assert!(LinearOscillator::new(0.5, f64::NAN).is_err());
    let lively = LinearOscillator::new(0.6, 1.5).expect("the theorems ask for a positive phi only");
    assert_eq!((lively.damping_ratio(), lively.coefficient_of_restitution()), (0.6, 1.5));
    assert_close(lively.damped_natural_frequency(), 0.8, 1e-16);
}
