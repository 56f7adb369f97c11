//! The general formulas evaluated with the numerical P_global, compared with the closed forms of
//! section 3.

use grazing_model::ImpactOscillator;
use grazing_theorems::Resonance;
use grazing_theorems::from_map::GrazingOrbit;

use crate::specimens::{assert_close, assert_within, oscillator_at, resonances};

/// Values of (ζ, ε): those of the figures, light and heavy damping, and the elastic and a soft
/// wall.
const OSCILLATORS: [[f64; 2]; 5] = [[0.02, 0.9], [0.005, 0.95], [0.1, 0.9], [0.05, 1.0], [0.03, 0.5]];

/// Runs a check at every resonance with p = 1, …, 4 and 0.3 < ω < 2, with the grazing orbit found
/// by Newton's method from a slightly displaced start.
fn compare(check: impl Fn(&Resonance, &GrazingOrbit<grazing_model::LinearOscillator>)) {
    for [zeta, epsilon] in OSCILLATORS {
        let list = resonances(zeta, epsilon, &[1, 2, 3, 4], [0.3, 2.0]);
        assert!(list.len() > 10);
        for resonance in list {
            let oscillator = oscillator_at(&resonance);
            let [amplitude, omega] = oscillator.parameters();
            let off = oscillator.with_parameters([amplitude + 0.001, omega]);
            let orbit = GrazingOrbit::find(&off, resonance.grazing().phase() - 0.001).unwrap();
            check(&resonance, &orbit);
        }
    }
}

/// Tolerance for rounding: each value is a sum of at most some hundred rounded products of the
/// flow's derivatives, which for p = 4 and ω = 0.3 are taken at phases and times up to a hundred:
/// 10² · 10² · 10⁻¹⁶.
const ROUNDING: f64 = 1e-12;

#[test]
fn grazing_orbit_and_its_slopes() {
    compare(|resonance, orbit| {
        let grazing = resonance.grazing();
        assert_close(orbit.primary(), grazing.amplitude(), ROUNDING);
        assert_within(orbit.phase(), grazing.phase(), ROUNDING);
        assert_within(orbit.primary_slope(), grazing.amplitude_derivative(), 10.0 * ROUNDING);
        // dz/dω is a hundred where the amplitude is small, near ω = 1; and for p = 1, even n and
        // light damping the matrix that is solved with has a determinant of 10⁻².
        let scale = 1.0 + grazing.phase_derivative();
        assert_within(orbit.phase_slope(), grazing.phase_derivative(), 100.0 * ROUNDING * scale);
    });
}

#[test]
fn an_oscillator_with_and_without_its_forcing_is_the_same() {
    compare(|resonance, orbit| {
        let grazing = resonance.grazing();
        let (free, forced) = (grazing.oscillator(), orbit.oscillator());
        assert_eq!(free.damping_ratio(), forced.damping_ratio());
        assert_eq!(free.coefficient_of_restitution(), forced.restitution());
        assert_eq!(grazing.model().parameters(), [grazing.amplitude(), grazing.forcing_frequency()]);
    });
}

#[test]
fn linearised_map_trace_and_determinant() {
    compare(|resonance, orbit| {
        let (numerical, closed) = (orbit.grazing_point(), resonance.grazing().grazing_point());
        assert_within((numerical.map.a - closed.map.a).norm(), 0.0, ROUNDING * closed.map.a.norm());
        assert_within((numerical.map.b - closed.map.b).norm(), 0.0, ROUNDING * closed.map.b.norm());
        assert_close(numerical.map.determinant(), resonance.grazing().determinant(), ROUNDING);
        // The trace may be zero (p = 2); its terms are of order one.
        assert_within(numerical.map.trace(), resonance.grazing().trace(), ROUNDING);
        assert_close(numerical.gamma, closed.gamma, ROUNDING);
        assert_close(numerical.alpha(), closed.alpha(), ROUNDING);
    });
}

#[test]
fn second_derivative_of_the_iterated_map() {
    compare(|resonance, orbit| {
        let numerical = orbit.second_phase_derivative(resonance.loops()).unwrap();
        // For p = 1 and even n it is the small difference −E (1 − E) of terms below one.
        assert_within(numerical, resonance.second_phase_derivative(), ROUNDING);
    });
}

#[test]
fn derivative_that_unfolds_the_resonance() {
    compare(|resonance, orbit| {
        let numerical = orbit.resonant_point(resonance.loops()).unwrap();
        // The derivative contains dz_graz/dω: same bound.
        assert_close(numerical.unfolding.derivative, resonance.unfolding().derivative, 100.0 * ROUNDING);
    });
}

#[test]
fn stability_coefficients_and_quadratic_coefficients() {
    compare(|resonance, orbit| {
        let numerical = orbit.resonant_point(resonance.loops()).unwrap();
        let stability = numerical.stability_coefficients();
        let closed = resonance.stability_coefficients();
        // s^± are sums of terms of order one that may nearly cancel; c are proportional to 1/s⁺ and
        // to (s⁺/s⁻)².
        assert_within(stability.plus, closed.plus, 10.0 * ROUNDING);
        assert_within(stability.minus, closed.minus, 10.0 * ROUNDING);
        let loss = 1.0 / closed.plus.abs().min(closed.minus.abs());
        let bound = 100.0 * ROUNDING * loss.max(1.0);
        assert!(bound < 1e-7, "the comparison must mean something");
        assert_close(numerical.saddle_node_coefficient(), resonance.saddle_node_coefficient(), bound);
        assert_close(numerical.period_doubling_coefficient(), resonance.period_doubling_coefficient(), bound);
    });
}

#[test]
fn all_coefficients_agree_to_nine_digits_on_the_oscillator_of_the_figures() {
    let agree = |a: f64, b: f64| assert_close(a, b, 1e-9);
    for resonance in resonances(0.02, 0.9, &[1, 2, 3, 4], [0.3, 2.0]) {
        let oscillator = oscillator_at(&resonance);
        let orbit = GrazingOrbit::find(&oscillator, resonance.grazing().phase()).unwrap();
        let numerical = orbit.resonant_point(resonance.loops()).unwrap();
        let (stability, closed) = (numerical.stability_coefficients(), resonance.stability_coefficients());
        agree(numerical.second_phase_derivative, resonance.second_phase_derivative());
        agree(numerical.unfolding.derivative, resonance.unfolding().derivative);
        agree(stability.plus, closed.plus);
        agree(stability.minus, closed.minus);
        agree(numerical.saddle_node_coefficient(), resonance.saddle_node_coefficient());
        agree(numerical.period_doubling_coefficient(), resonance.period_doubling_coefficient());
    }
}
