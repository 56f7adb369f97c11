//! Torus bifurcations, compared with those of an oscillator for which they are known in closed
//! form, and of a self-excited one.

use core::f64::consts::TAU;

use grazing_continuation::bifurcation::Bifurcation;
use grazing_model::AnyOscillator;
use grazing_unfold::one_parameter::{Cut, Line};
use grazing_unfold::progress::Silent;
use grazing_unfold::regions::Region;
use grazing_unfold::{Diagram, Scope};

use crate::specimens::{described, scope};

const FREQUENCY: f64 = 0.7;
const RESTITUTION: f64 = 0.9;

/// A linear oscillator with its damping η across, forced with the amplitude μ.
fn damped() -> (AnyOscillator, Scope) {
    let ranges = [[0.02, 0.9], [-0.1, 0.2]];
    let force = format!("-eta*v - x - 1 + mu*cos({FREQUENCY}*t)");
    let model = described([&force, &FREQUENCY.to_string(), "0"], RESTITUTION, ranges);
    (model.oscillator([0.5, 0.1]), scope(ranges[0], ranges[1], &[1]))
}

/// The damping at which areas are preserved in p forcing periods, with n = 0 or 1 impacts: det =
/// ε²ⁿ e^(−ηpT).
fn neutral(loops: u32) -> f64 {
    let impacts = if loops == 0 { 0.0 } else { 1.0 };
    2.0 * impacts * libm::log(RESTITUTION) / (f64::from(loops.max(1)) * TAU / FREQUENCY)
}

/// Whether a stable region contains a place for p, and no undecided one does.
fn stable(diagram: &Diagram, loops: u32, at: [f64; 2]) -> bool {
    let here = |region: &&Region| region.loops == loops && region.contains(at);
    let found = diagram.regions.iter().find(here);
    assert!(found.is_none_or(|region| region.doubt.is_none()), "p = {loops} at {at:?}: {found:?}");
    found.is_some()
}

#[test]
fn solutions_lose_stability_at_a_torus_bifurcation_where_areas_are_no_longer_contracted() {
    let (oscillator, scope) = damped();
    let diagram = Diagram::compute(&oscillator, &scope, &Silent).expect("it grazes");
    for loops in [0, 1] {
        let of_p = |kind: Bifurcation| {
            diagram.curves.iter().filter(move |curve| curve.loops == loops && curve.kind == kind)
        };
        let places: Vec<[f64; 2]> =
            of_p(Bifurcation::Torus).flat_map(|curve| curve.curve.parameters()).collect();
        assert!(places.len() > 5, "p = {loops}: {} points", places.len());
        // Points of a curve are located to some 10⁻¹⁰.
        for [_, damping] in places {
            assert!((damping - neutral(loops)).abs() < 1e-9, "p = {loops}: {damping}");
        }
    }
    // Forced with 0.3 motion does not reach the wall.
    assert!(stable(&diagram, 0, [0.3, 1e-5]) && !stable(&diagram, 0, [0.3, -1e-5]));
    // Forced with 0.62 it hits the wall.
    let neutral = neutral(1);
    assert!(stable(&diagram, 1, [0.62, neutral + 0.008]) && !stable(&diagram, 1, [0.62, neutral - 0.008]));
}

#[test]
fn a_one_parameter_diagram_shows_torus_bifurcations() {
    let (oscillator, scope) = damped();
    let line = Line { diagram: 1, primary_is_fixed: true, at: 0.3, range: scope.window.secondary };
    let diagram = Cut::follow(&oscillator, &scope, &[], line, &Silent).expect("nobody stops it").diagram();
    let of_kind = |found: &&grazing_results::branches::BranchBifurcation| found.kind == Bifurcation::Torus;
    let found: Vec<_> = diagram.bifurcations.iter().filter(of_kind).collect();
    let motion = found.iter().filter(|found| found.loops == 0).map(|found| found.secondary);
    // Located to some 10⁻¹⁰.
    assert!(motion.clone().count() == 1 && motion.clone().all(|damping| damping.abs() < 1e-9), "{found:?}");
}

/// Van der Pol's oscillator, which oscillates without forcing: it does not follow weak forcing.
#[test]
fn nothing_of_self_excited_motion_without_impacts_is_undecided() {
    let ranges = [[0.02, 1.5], [0.5, 1.6]];
    let force = "0.1*(1 - 4*(x + 1)^2)*v - (x + 1) + mu*cos(eta*t)";
    let model = described([force, "eta", "0"], 0.8, ranges);
    let scope = scope(ranges[0], ranges[1], &[1]);
    let diagram = Diagram::located(&model.oscillator([0.5, 1.0]), &scope, &Silent).expect("it grazes");
    assert!(diagram.curves.iter().any(|curve| curve.kind == Bifurcation::Torus));
    assert!(diagram.regions.iter().all(|region| region.doubt.is_none()));
    // Far from the resonance motion follows the force where its amplitude exceeds about 0.7 of its
    // amplitude without forcing: x = μ/(1 − ω²), and the mean damping changes its sign at 1/√2.
    let amplitude = |omega: f64, share: f64| share * libm::sqrt(0.5) * (omega * omega - 1.0);
    assert!(
        stable(&diagram, 0, [amplitude(1.5, 1.1), 1.5]) && !stable(&diagram, 0, [amplitude(1.5, 0.9), 1.5])
    );
}
