//! Examples that are the linear oscillator in other coordinates, compared with its closed form.

use core::f64::consts::TAU;

use grazing_model::ImpactOscillator;
use grazing_theorems::LinearOscillator;
use grazing_unfold::resonances::FoundResonance;

use crate::specimens::{
    EPSILON, ZETA, assert_closed_form, assert_within, constant, counted, grazing_curve, resonances,
};

/// Checks that resonances and coefficients of an example, in units of the paper, are those of the
/// closed form: `scaled` receives ω*, the grazing value of μ, c_SN and c_PD, in the units of the
/// file, and returns those of the amplitude of the force over frequency.
fn assert_linear(name: &str, unit_of_frequency: f64, scaled: impl Fn([f64; 4]) -> [f64; 4]) {
    let (oscillator, scope, units) = counted(name);
    let unit = units.primary / (units.secondary * units.secondary);
    let [lowest, highest] = scope.window.secondary.map(|eta| eta * units.secondary / unit_of_frequency);
    assert_closed_form(
        &resonances(&oscillator, &scope),
        [lowest, highest],
        &scope.loops,
        |[omega, amplitude, c_sn, c_pd]| {
            let [amplitude, omega] = units.parameters([amplitude, omega]);
            scaled([omega, amplitude, c_sn * unit, c_pd * unit])
        },
    );
}

#[test]
fn the_rig_in_si_units_is_the_oscillator_of_the_paper() {
    let [m, k, gap] = ["m", "k", "gap"].map(|name| constant("rig-si.toml", name));
    let (frequency, force) = ((k / m).sqrt(), k * gap);
    let coefficient = force / (frequency * frequency);
    assert_linear("rig-si.toml", frequency, |[omega, amplitude, c_sn, c_pd]| {
        [omega / frequency, amplitude / force, c_sn / coefficient, c_pd / coefficient]
    });
}

/// The conversion 𝒜 = B ω²: a curve B = B_graz(ω) + c (ω − ω*)² + ... is 𝒜 = 𝒜_graz(ω) + c ω*² (ω −
/// ω*)² + ..., since ω² changes at higher orders only.
#[test]
fn the_oscillator_in_a_moving_frame_has_the_resonances_of_the_paper() {
    assert_linear("base-excitation.toml", 1.0, |[omega, amplitude, c_sn, c_pd]| {
        let inertia = omega * omega;
        [omega, amplitude * inertia, c_sn * inertia, c_pd * inertia]
    });
}

/// Seen from the table the mass is driven by the force a (1 − ω²) cos ωt − 2 ζ a ω sin ωt, in units
/// of gap and natural frequency: 𝒜 = a 𝒜_graz(ω), so that 𝒜 = 𝒜_graz(ω) + c (ω − ω*)² + ... is a =
/// 1 + c/𝒜_graz(ω*) (ω − ω*)² + ...
#[test]
fn the_mass_over_the_shaking_table_grazes_at_its_height_and_has_the_resonances_of_the_paper() {
    let (oscillator, scope, units) = counted("shaking-table.toml");
    let [f0, gap] = ["f0", "gap"].map(|name| constant("shaking-table.toml", name));
    let curve = grazing_curve(&oscillator, &scope);
    for [mu, _] in curve.parameters() {
        // The parameter never moves: the difference is rounding.
        assert_within(mu * units.primary, gap, 1e-12 * gap);
    }
    let force = |f: f64| {
        let omega = f / f0;
        libm::hypot(1.0 - omega * omega, 2.0 * ZETA * omega)
    };
    assert_linear("shaking-table.toml", f0, |[f, a, c_sn, c_pd]| {
        let coefficient = force(f) * f0 * f0 / gap;
        [f / f0, force(f) * a / gap, c_sn * coefficient, c_pd * coefficient]
    });
}

/// The response to each harmonic is known, and the highest point of their sum is located on a fine
/// grid.
#[test]
fn two_harmonics_graze_where_the_sum_of_their_responses_does_and_resonate_where_one_does() {
    let (oscillator, scope, units) = counted("two-harmonics.toml");
    let [share, phase] = ["share", "phase"].map(|name| constant("two-harmonics.toml", name));
    // The displacement from rest at this phase, for the amplitude one.
    let response = |omega: f64, z: f64| {
        [(omega, 1.0, z), (2.0 * omega, share, 2.0 * z + phase)]
            .map(|(omega, force, z)| {
                let [stiff, damped] = [1.0 - omega * omega, 2.0 * ZETA * omega];
                force * (stiff * libm::cos(z) + damped * libm::sin(z)) / (stiff * stiff + damped * damped)
            })
            .into_iter()
            .sum::<f64>()
    };
    for state in grazing_curve(&oscillator, &scope).states.iter().step_by(10) {
        let [amplitude, omega] = units.parameters(state.orbit.oscillator().parameters());
        let highest = (0..20_000)
            .map(|k| response(omega, TAU * f64::from(k) / 20_000.0))
            .fold(f64::NEG_INFINITY, f64::max);
        // The grid misses a maximum by its curvature, which is below 40 in these units, times
        // 1.3e-8.
        assert_within(amplitude * highest, 1.0, 1e-6);
        assert_within(amplitude * response(omega, state.orbit.phase()), 1.0, 1e-9);
    }
    // Multipliers do not depend on the force.
    let [lowest, highest] = scope.window.secondary.map(|omega| omega * units.secondary);
    let theory = LinearOscillator::new(ZETA, EPSILON).unwrap();
    let found = resonances(&oscillator, &scope);
    let known = theory.resonances(&scope.loops, lowest, highest).unwrap();
    assert_eq!(found.iter().filter(|resonance| resonance.theorem.is_ok()).count(), known.len());
    for known in known {
        let (p, n) = (known.loops(), known.index());
        let same = |found: &&FoundResonance| (found.loops, found.n) == (p, n) && found.theorem.is_ok();
        let resonance = found.iter().find(same).unwrap_or_else(|| panic!("p = {p}, n = {n} is missing"));
        let [_, omega] = units.parameters(resonance.located.orbit().oscillator().parameters());
        assert_within(omega, known.forcing_frequency(), 1e-9);
    }
}
