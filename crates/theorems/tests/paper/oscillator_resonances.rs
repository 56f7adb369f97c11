//! The resonances of the oscillator: where they are, and propositions 3.2 and 3.3 against the general
//! formulas.

use proptest::prelude::*;

use grazing_theorems::generic_theorem::Side;
use grazing_theorems::hypothesis::Quantity;
use grazing_theorems::{
    GenericGrazing, LinearOscillator, Resonance, ResonantGrazing, TheoryError, Unfolding,
};

use super::{assert_close, assert_within, deterministic};

/// Rounding errors of the general formulas at a resonance, relative to the closed forms. The angle
/// `2 pi omega_1 / omega` (up to 40) and the cancellation in `s_1^-` (down to 0.003) set the largest, some
/// 1e-12.
const AGREEMENT: f64 = 1e-10;

fn resonances() -> impl Strategy<Value = Resonance> {
    // Stronger damping at these p and n makes E_p^2 underflow.
    (0.01..0.6_f64, 0.05..=1.0_f64, 1_u32..=6, 0_u32..=6).prop_map(|(zeta, epsilon, p, n)| {
        let oscillator = LinearOscillator::new(zeta, epsilon).expect("valid");
        oscillator.resonance(p, if p == 1 { n.max(1) } else { n }).expect("valid")
    })
}

proptest! {
    #![proptest_config(deterministic(1024))]

    #[test]
    fn propositions_3_2_and_3_3_agree_with_the_general_formulas(resonance in resonances()) {
        let point = resonance.resonant_point();
        let (closed, general) = (resonance.stability_coefficients(), point.stability_coefficients());
        assert_close(general.plus, closed.plus, AGREEMENT);
        assert_close(general.minus, closed.minus, AGREEMENT);
        assert_close(point.saddle_node_coefficient(), resonance.saddle_node_coefficient(), AGREEMENT);
        assert_close(point.period_doubling_coefficient(), resonance.period_doubling_coefficient(), AGREEMENT);
    }

    #[test]
    fn quantities_at_the_resonance_agree_with_their_general_forms(resonance in resonances()) {
        let grazing = resonance.grazing();
        let decay = grazing.decay(1);
        assert_close(
            grazing.second_phase_derivative(resonance.loops()),
            resonance.second_phase_derivative(),
            AGREEMENT,
        );
        // In proportion to E_1; the angle is rounded to 1e-14.
        assert_within(grazing.linearised_map().a.m12, resonance.off_diagonal(), 1e-13 * decay);
        match resonance.unfolding() {
            Unfolding::OneLoop { off_diagonal_derivative } => {
                assert_close(grazing.off_diagonal_derivative(), off_diagonal_derivative, AGREEMENT);
            }
            Unfolding::MultiLoop { loops, detuning_derivative } => {
                assert_close(grazing.detuning_derivative(loops), detuning_derivative, AGREEMENT);
                assert_within(grazing.detuning(loops), 0.0, 1e-13 * decay);
            }
        }
    }

    #[test]
    fn saddle_node_and_period_doubling_leave_on_different_sides(resonance in resonances()) {
        let point = resonance.resonant_point();
        let theorem = ResonantGrazing::check(&point, 1e-12).expect("the hypotheses hold");
        prop_assert!(theorem.saddle_node().coefficient < 0.0);
        prop_assert!(theorem.period_doubling().coefficient > 0.0);
        let even = resonance.loops() == 1 && resonance.index() % 2 == 0;
        let expected = if even { (Side::Positive, Side::Negative) } else { (Side::Negative, Side::Positive) };
        prop_assert_eq!((theorem.saddle_node().eta_side, theorem.period_doubling().eta_side), expected);
    }

    #[test]
    fn minus_sign_in_the_resonance_condition_gives_virtual_solutions(
        zeta in 0.01..0.6_f64,
        p in 2_u32..7,
        n in 1_u32..7,
    ) {
        let oscillator = LinearOscillator::new(zeta, 0.85).expect("valid");
        let omega = oscillator.virtual_resonance_frequency(p, n).expect("valid");
        let grazing = oscillator.grazing(omega).expect("valid");
        assert_within(grazing.detuning(p), 0.0, 1e-13 * grazing.decay(1));
        // Next to it, the only hypothesis that fails is a12 alpha > 0.
        let beside = oscillator.grazing(1.001 * omega).expect("valid").grazing_point();
        let violated = GenericGrazing::check(&beside, p).expect_err("a12 is negative");
        let names: Vec<Quantity> = violated.violated().map(|hypothesis| hypothesis.quantity).collect();
        prop_assert_eq!(names, [Quantity::OffDiagonalTimesSquareRootFactor]);
    }

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
    // 1 - E_p cancels in the general formulas; the closed forms are compared with their own limit for small
    // zeta: E_p = 1 - x, x = 2 pi p zeta / omega, so that c_SN tends to -(2 pi^2 p^2 A_graz / omega^2) / x^2
    // for epsilon = 1.
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
