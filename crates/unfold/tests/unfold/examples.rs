//! The examples: the theorems at every resonance, the coefficients measured there, and the results
//! of simulation.

use std::fmt::Write;

use grazing_model::ImpactOscillator;
use grazing_model::smooth::Units;
use grazing_results::Dimensioned;
use grazing_theorems::hypothesis::Quantity;
use grazing_unfold::Diagram;
use grazing_unfold::progress::Silent;
use grazing_unfold::resonances::FoundResonance;
use grazing_unfold::verdict::{Verdict, coefficients};
use grazing_unfold::verification::{Simulated, simulate};
use insta::{Settings, assert_snapshot};
use rayon::prelude::*;

use crate::specimens::{self, counted, example, file};

/// All resonances of an example, and the units in which they are measured.
fn resonances(name: &str) -> (Vec<FoundResonance>, Units) {
    let (oscillator, scope, units) = counted(name);
    let found = specimens::resonances(&oscillator, &scope);
    for resonance in &found {
        // Where a theorem fails the reason is that of Proposition 3.3: solutions on the other side
        // of ω₁/ω = n are virtual.
        if let Err(violated) = &resonance.theorem {
            let quantities: Vec<_> = violated.violated().map(|hypothesis| hypothesis.quantity).collect();
            assert_eq!(quantities, [Quantity::OffDiagonalTimesSquareRootFactor], "{name}: {violated}");
        }
    }
    (found, units)
}

/// Checks that theorem and fit agree within their errors and to five digits, and that simulation
/// agrees with the prediction on both sides of both curves.
fn assert_theory_holds(name: &str, resonances: &[FoundResonance]) {
    let failures: Vec<String> = resonances
        .par_iter()
        .filter_map(|resonance| Some((resonance, resonance.theorem.as_ref().ok()?)))
        .flat_map_iter(|(resonance, point)| {
            let place = format!("{name}, p = {}, n = {}", resonance.loops, resonance.n);
            let both = coefficients(point);
            both.named().into_iter().flat_map(move |(kind, coefficient)| {
                let place = format!("{place}, {}", kind.name());
                let theorem = coefficient.theorem.value;
                // Five digits.
                let close = coefficient
                    .fit
                    .is_ok_and(|fit| ((fit.coefficient.value - theorem) / theorem).abs() < 1e-5);
                let agrees = close && coefficient.verdict() == Verdict::Agree;
                let measured = (!agrees).then(|| format!("{place}: {coefficient:?}"));
                let sides = simulate(point, kind, &both);
                let lands = matches!(sides, Simulated::AsPredicted(_));
                let simulated = (!lands).then(|| format!("{place}: {sides:?}"));
                measured.into_iter().chain(simulated)
            })
        })
        .collect();
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

/// Compares an example with its snapshot, which is named after it, prefixed by `example_`.
fn assert_unfolds(snapshot: &str) {
    let name = snapshot.trim_start_matches("example_");
    let (found, units) = resonances(&format!("{name}.toml"));
    let unit = units.primary / (units.secondary * units.secondary);
    let mut text = String::new();
    for resonance in &found {
        let [mu, eta] = units.parameters(resonance.located.orbit().oscillator().parameters());
        write!(text, "p = {}, n = {}: eta {eta:.7e}, mu {mu:.7e}", resonance.loops, resonance.n).unwrap();
        match &resonance.theorem {
            Ok(point) => {
                let [sn, pd] = point.leading().map(|curve| curve.coefficient * unit).into_array();
                writeln!(text, ", c_SN {sn:.7e}, c_PD {pd:.7e}").unwrap();
            }
            Err(violated) => {
                for hypothesis in violated.violated().map(|hypothesis| hypothesis.with_dimensions(&units)) {
                    write!(text, ", {} violated by {:.7e}", hypothesis.statement(), hypothesis.value)
                        .unwrap();
                }
                writeln!(text).unwrap();
            }
        }
    }
    assert_as_in(snapshot, &text);
    assert_theory_holds(name, &found);
}

/// Compares a text with a snapshot.
fn assert_as_in(snapshot: &str, text: &str) {
    let mut settings = Settings::clone_current();
    settings.set_snapshot_path(file("expected"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| assert_snapshot!(snapshot, text));
}

#[test]
fn theory_holds_at_the_resonances_of_the_papers_oscillator() {
    assert_unfolds("example_paper");
}

#[test]
fn theory_holds_at_the_resonances_of_the_duffing_oscillator() {
    assert_unfolds("example_duffing");
}

#[test]
fn theory_holds_at_the_resonances_with_an_impact_that_varies_and_lasts() {
    assert_unfolds("example_varying-impact");
}

#[test]
fn theory_holds_at_the_resonances_with_quadratic_damping() {
    assert_unfolds("example_quadratic-damping");
}

#[test]
fn second_derivatives_keep_their_digits_where_drag_bends_within_a_tenth_of_the_velocity() {
    let (oscillator, mut scope) = example("quadratic-damping.toml");
    (scope.window.secondary, scope.loops) = ([0.95, 1.05], vec![1]);
    let found = specimens::resonances(&oscillator, &scope);
    let [Ok(point)] = [&found[0].theorem] else { panic!("the theorem holds at n = 2") };
    let (known, theorem) = (point.resonant_point(), point.theorem());
    let [amplitude, frequency] = point.orbit().oscillator().parameters();
    // By power series of 36 terms in 40 digits, whose derivatives are differences over 10⁻⁹ and
    // 10⁻⁶ of fourth order.
    for (computed, exact, bound) in [
        (frequency, 0.999_436_721_828_780_7, 1e-12),
        (amplitude, 0.045_626_017_855_751_53, 1e-12),
        (known.second_phase_derivative, -0.111_258_411_176_442_38, 1e-9),
        (known.unfolding.derivative, -5.239_699_489_759_759, 1e-9),
        (theorem.saddle_node().coefficient, -43.087_811_891_694_38, 1e-9),
        // s_1⁻ = 0.07 loses a digit, twice.
        (theorem.period_doubling().coefficient, 83_141.691_238_812_34, 1e-8),
    ] {
        assert!((computed / exact - 1.0).abs() < bound, "{computed:e} instead of {exact:e}");
    }
}

#[test]
fn theory_holds_at_the_resonances_where_the_clearance_is_the_parameter() {
    assert_unfolds("example_clearance");
}

#[test]
fn theory_holds_at_the_resonances_over_a_shaking_table() {
    assert_unfolds("example_shaking-table");
}

#[test]
fn theory_holds_at_the_resonances_in_a_frame_that_moves() {
    assert_unfolds("example_base-excitation");
}

#[test]
fn theory_holds_at_the_resonances_of_the_pendulum() {
    assert_unfolds("example_pendulum");
}

#[test]
fn theory_holds_at_the_resonances_of_the_rig_in_si_units() {
    assert_unfolds("example_rig-si");
}

#[test]
fn theory_holds_at_the_resonances_of_the_harvester() {
    assert_unfolds("example_harvester");
}

#[test]
fn theory_holds_at_the_resonances_of_the_tip_of_the_microscope() {
    assert_unfolds("example_afm");
}

#[test]
fn theory_holds_at_the_resonances_of_the_drill() {
    assert_unfolds("example_drill");
}

#[test]
fn theory_holds_at_the_resonances_where_the_stiffness_varies() {
    assert_unfolds("example_parametric");
}

#[test]
fn theory_holds_at_the_resonances_with_two_harmonics() {
    assert_unfolds("example_two-harmonics");
}

#[test]
fn theory_holds_at_the_resonances_of_the_leaf_spring() {
    assert_unfolds("example_leaf-spring");
}

#[test]
fn theory_holds_at_the_resonances_of_the_door() {
    assert_unfolds("example_door");
}

#[test]
fn theory_holds_at_the_resonances_of_the_relay() {
    assert_unfolds("example_relay");
}

#[test]
fn theory_holds_at_the_resonances_between_two_stops() {
    assert_unfolds("example_two-stops");
}

#[test]
fn theory_holds_at_the_resonances_of_the_clapper() {
    assert_unfolds("example_bell");
}

#[test]
fn an_impact_damper_on_a_soft_spring_has_no_resonances() {
    assert_unfolds("example_impact-damper");
}

#[test]
fn where_nothing_holds_the_mass_near_the_wall_there_is_no_grazing_and_no_resonance() {
    for snapshot in ["example_bouncing-ball", "example_gear-backlash"] {
        let (oscillator, scope, _) = counted(&format!("{}.toml", snapshot.trim_start_matches("example_")));
        let found = Diagram::located(&oscillator, &scope, &Silent).expect("it is no error");
        assert!(found.grazing.is_empty() && found.resonances.is_empty());
        assert_as_in(snapshot, "");
    }
}

#[test]
fn every_example_has_its_test() {
    let mut names: Vec<String> = std::fs::read_dir(file("examples"))
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "toml"))
        .map(|path| path.file_stem().unwrap().to_string_lossy().into_owned())
        .collect();
    names.sort();
    let tested = [
        "afm",
        "base-excitation",
        "bell",
        "bouncing-ball",
        "clearance",
        "door",
        "drill",
        "duffing",
        "gear-backlash",
        "harvester",
        "impact-damper",
        "leaf-spring",
        "paper",
        "parametric",
        "pendulum",
        "quadratic-damping",
        "relay",
        "rig-si",
        "shaking-table",
        "two-harmonics",
        "two-stops",
        "varying-impact",
    ];
    assert_eq!(names, tested);
}
