//! The hand-written flow and its derivatives, compared with the printed solution under automatic
//! differentiation.

use grazing_model::{ImpactOscillator, LinearOscillator, State};
use nalgebra::SVector;
use num_dual::hessian;
use proptest::prelude::*;

use crate::printed::printed_flow;

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, rng_seed: proptest::test_runner::RngSeed::Fixed(2), ..ProptestConfig::default() })]

    /// Tolerance: both sides are sums of terms of size up to 1e4 (second derivatives in ω) with
    /// relative errors of rounding.
    #[test]
    fn flow_and_its_derivatives_are_those_of_the_printed_solution(
        zeta in 0.005..0.6_f64, x in -2.0..0.5_f64, y in -2.0..2.0_f64, z in -4.0..4.0_f64,
        s in -3.0..9.0_f64, amplitude in 0.0..1.5_f64, omega in 0.3..0.9_f64,
    ) {
        let oscillator = LinearOscillator::new(zeta, 0.9, amplitude, omega).unwrap();
        let jet = oscillator.flow::<2>(State { position: x, velocity: y, phase: z }, s);
        let point = SVector::from([x, y, z, s, amplitude, omega]);
        for i in 0..2 {
            let (value, gradient, second) = hessian(|arguments| printed_flow(zeta, arguments.data.0[0])[i], &point);
            prop_assert!((jet.value[i] - value).abs() < 1e-11);
            for a in 0..6 {
                let (hand, dual) = (jet.jacobian[(i, a)], gradient[a]);
                prop_assert!((hand - dual).abs() < 1e-10 * (1.0 + dual.abs()), "d{i}/d{a}: {hand} {dual}");
                for b in 0..6 {
                    let (hand, dual) = (jet.hessians[i][(a, b)], second[(a, b)]);
                    prop_assert!((hand - dual).abs() < 1e-9 * (1.0 + dual.abs()), "d2{i}/d{a}d{b}: {hand} {dual}");
                }
            }
        }
    }
}

/// The periodic solution of eq:phip is a solution: the flow maps it to itself one phase later.
#[test]
fn flow_carries_the_non_impacting_solution_along() {
    let oscillator = LinearOscillator::new(0.02, 0.9, 0.3, 0.855).unwrap();
    for (phase, time) in [(0.0, 1.3), (2.0, 40.0), (-1.0, -3.0)] {
        let end = oscillator.flow::<1>(oscillator.non_impacting_solution(phase), time).value;
        let expected = oscillator.non_impacting_solution(phase + 0.855 * time);
        // Rounding of terms of order one, amplified by at most e^{0.06}.
        assert!((end[0] - expected.position).abs() < 1e-13);
        assert!((end[1] - expected.velocity).abs() < 1e-13);
    }
}

#[test]
fn flow_satisfies_the_equation_of_motion() {
    let oscillator = LinearOscillator::new(0.1, 0.9, 0.7, 0.5).unwrap();
    let from = State { position: -0.3, velocity: 0.2, phase: 0.4 };
    let jet = oscillator.flow::<2>(from, 2.5);
    let end = State { position: jet.value[0], velocity: jet.value[1], phase: 0.4 + 0.5 * 2.5 };
    let duration = grazing_model::flow_variable::DURATION;
    // dx/ds = y and dy/ds = F at the end, to rounding.
    assert!((jet.jacobian[(0, duration)] - end.velocity).abs() < 1e-14);
    assert!((jet.jacobian[(1, duration)] - oscillator.acceleration(end)).abs() < 1e-14);
    assert!((jet.hessians[0][(duration, duration)] - oscillator.acceleration(end)).abs() < 1e-14);
}

#[test]
fn parameters_outside_their_domains_are_rejected() {
    use grazing_model::OscillatorError::{Amplitude, DampingRatio, Frequency, Restitution};
    assert_eq!(LinearOscillator::new(1.0, 0.9, 0.3, 0.8), Err(DampingRatio(1.0)));
    assert_eq!(LinearOscillator::new(0.02, 0.0, 0.3, 0.8), Err(Restitution(0.0)));
    assert_eq!(LinearOscillator::new(0.02, f64::INFINITY, 0.3, 0.8), Err(Restitution(f64::INFINITY)));
    assert!(
        LinearOscillator::new(0.02, 1.1, 0.3, 0.8).is_ok(),
        "the class of systems asks for a positive one only"
    );
    assert_eq!(LinearOscillator::new(0.02, 0.9, f64::INFINITY, 0.8), Err(Amplitude(f64::INFINITY)));
    assert_eq!(LinearOscillator::new(0.02, 0.9, 0.3, -0.8), Err(Frequency(-0.8)));
}
