//! Resonances on the grazing curve of the linear oscillator, all of which are known.

use grazing_continuation::arclength::StepControl;
use grazing_model::ImpactOscillator;
use grazing_theorems::LinearOscillator;
use grazing_unfold::Diagram;
use grazing_unfold::diagram::route;
use grazing_unfold::progress::Silent;
use grazing_unfold::verdict::{Verdict, coefficients};

use crate::specimens::{
    DAMPED, EPSILON, ZETA, assert_closed_form, assert_within, closed_form, described, example, linear,
    resonances, scope, written,
};

/// Forcing frequency and n of all resonances of a p in a range, and whether a theorem holds there:
/// eq:resonance1, eq:resonancep.
fn expected(loops: u32, [lowest, highest]: [f64; 2]) -> Vec<(f64, u32, bool)> {
    let theory = LinearOscillator::new(ZETA, EPSILON).unwrap();
    let mut list: Vec<_> = theory
        .resonances(&[loops], lowest, highest)
        .unwrap()
        .iter()
        .map(|resonance| (resonance.forcing_frequency(), resonance.index(), true))
        .collect();
    if loops > 1 {
        let virtual_ones =
            (1..=10).map(|n| (theory.virtual_resonance_frequency(loops, n).unwrap(), n, false));
        list.extend(virtual_ones.filter(|(frequency, ..)| (lowest..=highest).contains(frequency)));
    }
    list.sort_by(|a, b| a.0.total_cmp(&b.0));
    list
}

fn assert_all_found(secondary: [f64; 2], loops: &[u32]) {
    let scope = scope([0.0, 20.0], secondary, loops);
    let found = resonances(&closed_form(), &scope);
    let mut listed = found.iter();
    for &loops in &scope.loops {
        for (frequency, n, holds) in expected(loops, secondary) {
            let next = listed.next().unwrap_or_else(|| panic!("p = {loops}, n = {n} is missing"));
            assert_eq!((next.loops, next.n, next.theorem.is_ok()), (loops, n, holds), "near {frequency}");
            // The accuracy of Newton's method on smooth equations.
            assert_within(next.located.orbit().oscillator().parameters()[1], frequency, 1e-10);
        }
    }
    assert!(listed.next().is_none());
}

#[test]
fn all_resonances_in_a_wide_window_are_found_once_with_their_n() {
    assert_all_found([0.2, 3.0], &[1, 2, 3, 4, 5, 6]);
}

#[test]
fn all_resonances_at_low_frequencies_are_found_once_with_their_n() {
    // Steps as long as for the wide window would be longer here than the distance between
    // resonances.
    assert_all_found([0.12, 0.4], &[6, 1]);
}

#[test]
fn all_resonances_at_high_frequencies_are_found_once_with_their_n() {
    assert_all_found([1.0, 4.2], &[2, 1, 5]);
}

/// Checks the resonances of the integrated oscillator of `examples/paper.toml` against all
/// properties known in closed form.
fn assert_integrated(secondary: [f64; 2], loops: &[u32]) {
    let (oscillator, mut scope) = example("paper.toml");
    (scope.window.secondary, scope.loops) = (secondary, loops.to_vec());
    assert_closed_form(&resonances(&oscillator, &scope), secondary, loops, |computed| computed);
}

#[test]
fn resonances_under_slow_forcing_have_the_coefficients_of_the_closed_form() {
    // The whole window of the example; n from 17 to 18, 38 to 39 and 58 to 60 for p = 1; from 13 to
    // 15 and 59 to 60 for p = 2 and 3.
    assert_integrated([0.3, 1.1], &[1, 2, 3]);
    assert_integrated([0.11, 0.12], &[1]);
    assert_integrated([0.05, 0.054], &[1]);
    assert_integrated([0.0333, 0.0345], &[1]);
    assert_integrated([0.065, 0.075], &[2, 3]);
    assert_integrated([0.0165, 0.0169], &[2, 3]);
}

#[test]
fn resonances_in_the_stiffness_lie_where_the_free_frequency_is_in_step() {
    let scope = scope([0.0, 1.5], [0.8, 2.0], &[1, 2]);
    let oscillator = written("-2*zeta*v - eta*x - 1 + mu*cos(0.8*t)", "0.8", &scope);
    let found = resonances(&oscillator, &scope);
    // ω₁ = 0.8 n/2 for p = 1 and 0.8 (n ± 1/4) for p = 2, where ω₁² = η − ζ²: eq:resonance1,
    // eq:resonancep.
    let wanted = [(1, 3, 1.5, true), (2, 1, 1.25, true), (2, 2, 1.75, false)];
    assert_eq!(found.len(), wanted.len());
    for (resonance, (loops, n, ratio, holds)) in found.iter().zip(wanted) {
        assert_eq!((resonance.loops, resonance.n, resonance.theorem.is_ok()), (loops, n, holds));
        let stiffness = 0.64 * ratio * ratio + DAMPED * DAMPED;
        // The accuracy of integration and Newton's method.
        assert_within(resonance.located.orbit().oscillator().parameters()[1], stiffness, 1e-10);
        let Ok(point) = &resonance.theorem else { continue };
        for coefficient in coefficients(point).into_array() {
            assert_eq!(coefficient.verdict(), Verdict::Agree, "{coefficient:?}");
            let measured = coefficient.fit.as_ref().unwrap().coefficient.value;
            assert_within(measured / coefficient.theorem.value, 1.0, 1e-5);
        }
    }
}

#[test]
fn where_motion_is_forgotten_within_a_period_nothing_is_resonant() {
    let oscillator = linear(0.15, EPSILON, [0.5, 0.05]);
    let diagram = Diagram::located(&oscillator, &scope([0.0, 2.0], [0.02, 0.12], &[1]), &Silent).unwrap();
    assert!(diagram.unlocated.is_empty(), "{:?}", diagram.unlocated);
    // Multipliers are exp(−0.3 π/η) in size, 3·10⁻⁶ at this η; the other resonances are located as
    // usual.
    let forgotten = 0.3 * core::f64::consts::PI / -libm::log(3e-6);
    let [curve] = diagram.grazing.as_slice() else { panic!("one") };
    for state in &curve.states {
        assert_eq!(state.is_forgotten(), state.parameters()[1] < forgotten);
    }
    let known: Vec<f64> = LinearOscillator::new(0.15, EPSILON)
        .unwrap()
        .resonances(&[1], 1.01 * forgotten, 0.12)
        .unwrap()
        .iter()
        .map(|resonance| resonance.forcing_frequency())
        .collect();
    assert!(known.len() > 5);
    let located: Vec<f64> =
        diagram.resonances.iter().map(|found| found.located.orbit().oscillator().parameters()[1]).collect();
    assert!(
        located.len() <= known.len() + 1 && located.iter().all(|frequency| *frequency > 0.99 * forgotten)
    );
    for frequency in known {
        assert!(located.iter().any(|eta| (eta - frequency).abs() < 1e-6), "{frequency}");
    }
}

#[test]
fn resonances_are_found_where_motion_is_almost_forgotten_within_p_periods() {
    let oscillator = linear(0.2, 0.9, [0.5, 0.5]);
    let found = resonances(&oscillator, &scope([0.0, 1.3], [0.2, 1.0], &[4, 5]));
    let theory = LinearOscillator::new(0.2, 0.9).unwrap();
    let expected = theory.resonances(&[4, 5], 0.2, 1.0).unwrap();
    assert_eq!(expected.len(), 8);
    for wanted in expected {
        let here = found
            .iter()
            .find(|one| (one.loops, one.n) == (wanted.loops(), wanted.index()) && one.theorem.is_ok());
        let here = here.unwrap_or_else(|| panic!("p = {}, n = {}", wanted.loops(), wanted.index()));
        let [_, frequency] = here.located.orbit().oscillator().parameters();
        assert_within(frequency, wanted.forcing_frequency(), 1e-9);
    }
}

#[test]
fn the_highest_maximum_at_a_resonance_is_at_the_wall_where_motion_has_lower_ones_as_well() {
    // Two maxima in a period, one of which grazes.
    let ranges = [[0.1, 3.0], [0.3, 0.45]];
    let model =
        described(["-0.04*v - x - 1 + mu*(cos(eta*t) + 2*cos(3*eta*t + 1))", "eta", "0"], EPSILON, ranges);
    let scope = scope(ranges[0], ranges[1], &[2, 3]);
    let diagram = Diagram::located(&model.oscillator([0.5, 0.4]), &scope, &Silent).expect("it grazes");
    let mut seen = 0;
    for (resonance, located) in diagram.unfolding() {
        let unfolded = located.unfold(&route(scope.window, StepControl::DRAWING)).expect("its curves begin");
        for curve in unfolded.curves() {
            let first = &curve.points[0].solution;
            // Event times are exact to rounding.
            assert!(first.ceiling().abs() < 1e-8, "p = {}: {}", resonance.loops, first.ceiling());
            seen += 1;
        }
    }
    assert!(seen >= 2, "{seen}");
}
