//! The linear oscillator: the resonances in a window, and parameters outside their domains; its
//! closed forms are checked by the ledger of claims.

use proptest::prelude::*;

use grazing_theorems::{LinearOscillator, TheoryError};

use super::{assert_close, deterministic};

proptest! {
    #![proptest_config(deterministic(1024))]

    #[test]
    fn window_holds_exactly_the_resonances_that_lie_in_it(
        zeta in 0.01..0.9_f64,
        lowest in 0.1..1.5_f64,
        width in 0.0..6.0_f64,
    ) {
        let oscillator = LinearOscillator::new(zeta, 0.85).expect("valid");
        let highest = lowest + width;
        let listed = oscillator.resonances(&[3, 1, 2, 1], lowest, highest).expect("a window");
        let mut expected = Vec::new();
        for (p, n) in (1..=3).flat_map(|p| (0..60).map(move |n| (p, n))) {
            if let Ok(resonance) = oscillator.resonance(p, n)
                && (lowest..=highest).contains(&resonance.forcing_frequency())
            {
                expected.push(resonance);
            }
        }
        expected.sort_by(|a, b| a.forcing_frequency().total_cmp(&b.forcing_frequency()));
        prop_assert_eq!(listed, expected);
    }
}

#[test]
fn resonance_frequencies_are_fractions_of_the_damped_natural_frequency() {
    // omega_1 = 0.8
    let oscillator = LinearOscillator::new(0.6, 0.85).expect("valid");
    for (p, n, ratio) in
        [(1, 1, 0.5), (1, 2, 1.0), (1, 7, 3.5), (2, 0, 0.25), (2, 1, 1.25), (5, 3, 3.1), (4, 2, 2.125)]
    {
        let resonance = oscillator.resonance(p, n).expect("valid");
        assert_eq!((resonance.loops(), resonance.index()), (p, n));
        assert_close(resonance.forcing_frequency(), 0.8 / ratio, 4e-16);
    }
    assert_close(oscillator.virtual_resonance_frequency(4, 2).expect("valid"), 0.8 / 1.875, 4e-16);
}

#[test]
fn window_is_closed_at_both_ends() {
    let oscillator = LinearOscillator::new(0.05, 0.85).expect("valid");
    let (low, high) =
        (oscillator.resonance(3, 2).expect("valid"), oscillator.resonance(1, 2).expect("valid"));
    let found = oscillator
        .resonances(&[1, 2, 3], low.forcing_frequency(), high.forcing_frequency())
        .expect("a window");
    let names: Vec<(u32, u32)> =
        found.iter().map(|resonance| (resonance.loops(), resonance.index())).collect();
    // omega_1 / omega = 13/6, 2, 3/2, 5/4, 7/6, 1
    assert_eq!(names, [(3, 2), (1, 4), (1, 3), (2, 1), (3, 1), (1, 2)]);
    let single =
        oscillator.resonances(&[3], low.forcing_frequency(), low.forcing_frequency()).expect("a window");
    assert_eq!(single, [low]);
    assert_eq!(oscillator.resonances(&[2], 0.81, 0.9), Ok(Vec::new()));
    assert_eq!(oscillator.resonances(&[], 0.1, 10.0), Ok(Vec::new()));
}

#[test]
fn windows_and_indices_outside_the_domain_are_refused() {
    let oscillator = LinearOscillator::new(0.05, 0.85).expect("valid");
    for (lowest, highest) in [(0.0, 1.0), (-1.0, 1.0), (1.0, 0.5), (0.5, f64::INFINITY)] {
        let expected = TheoryError::FrequencyWindow { lowest, highest };
        assert_eq!(oscillator.resonances(&[1], lowest, highest), Err(expected));
    }
    assert!(oscillator.resonances(&[1], f64::NAN, 1.0).is_err());
    assert!(oscillator.resonances(&[1], 0.5, f64::NAN).is_err());
    assert_eq!(
        oscillator.resonances(&[0, 1], 0.5, 1.0),
        Err(TheoryError::TooFewLoops { loops: 0, minimum: 1 })
    );
    for lowest in [1e-6, 1e-300] {
        assert!(matches!(
            oscillator.resonances(&[2], lowest, 1.0),
            Err(TheoryError::TooManyResonances { loops: 2, .. })
        ));
    }
    assert_eq!(oscillator.resonance(0, 1), Err(TheoryError::TooFewLoops { loops: 0, minimum: 1 }));
    assert_eq!(
        oscillator.resonance(1, 0),
        Err(TheoryError::ResonanceIndex { loops: 1, index: 0, minimum: 1 })
    );
    assert_eq!(
        oscillator.virtual_resonance_frequency(1, 1),
        Err(TheoryError::TooFewLoops { loops: 1, minimum: 2 })
    );
    assert_eq!(
        oscillator.virtual_resonance_frequency(2, 0),
        Err(TheoryError::ResonanceIndex { loops: 2, index: 0, minimum: 1 })
    );
}

#[test]
fn elastic_impacts_without_much_damping_keep_their_digits() {
    // 1 - E_p cancels in the general formulas; the closed forms are compared with their own limit
    // for small zeta: E_p = 1 - x, x = 2 pi p zeta / omega, so that c_SN tends to -(2 pi^2 p^2
    // A_graz / omega^2) / x^2 for epsilon = 1.
    let zeta = 1e-9;
    let oscillator = LinearOscillator::new(zeta, 1.0).expect("valid");
    let resonance = oscillator.resonance(2, 1).expect("valid");
    let grazing = resonance.grazing();
    let limit = -grazing.amplitude() / (2.0 * zeta * zeta);
    // Relative corrections are of order x = 1e-8.
    assert_close(resonance.saddle_node_coefficient(), limit, 1e-7);
    assert_close(
        resonance.stability_coefficients().plus,
        -libm::pow(grazing.decay_complement(2), 2.0),
        1e-14,
    );
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
