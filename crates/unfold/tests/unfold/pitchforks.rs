//! Pitchforks of symmetric motion without impacts, compared with motion that has settled.

use std::sync::LazyLock;

use grazing_continuation::bifurcation::Bifurcation;
use grazing_continuation::locate::{Condition, LocateFailure, locate};
use grazing_continuation::mps::{EventTimes, LoopEquations, Unknowns};
use grazing_continuation::newton::NewtonFailure;
use grazing_model::maps::MapError;
use grazing_model::motion::Motion;
use grazing_model::{AnyOscillator, ImpactOscillator, State};
use grazing_unfold::one_parameter::{Cut, Line};
use grazing_unfold::progress::Silent;
use grazing_unfold::{Diagram, Scope};

use crate::specimens::{described, scope};

/// An oscillator that is symmetric about a position, with a part of its plane.
struct Symmetric {
    oscillator: AnyOscillator,
    scope: Scope,
    centre: f64,
    diagram: Diagram,
}

/// A driven pendulum that hangs at x = −3, and a particle between two wells with the hill at −1.8.
static SPECIMENS: LazyLock<[Symmetric; 2]> = LazyLock::new(|| {
    let pendulum = ("-0.5*v - sin(x + 3) + mu*cos(eta*t)", [[0.8, 1.2], [0.6, 0.75]], -3.0);
    let wells =
        ("-0.028*v + 0.36*((x + 1.8) - (x + 1.8)^3) + mu*cos(eta*t)", [[0.3, 0.6], [0.6, 0.75]], -1.8);
    [pendulum, wells].map(|(force, ranges, centre)| {
        let model = described([force, "eta", "0"], 0.7, ranges);
        let oscillator = model.oscillator([ranges[0][0], ranges[1][0]]);
        let scope = scope(ranges[0], ranges[1], &[1]);
        let diagram = Diagram::located(&oscillator, &scope, &Silent).expect("it grazes");
        Symmetric { oscillator, scope, centre, diagram }
    })
});

/// The pitchforks as points of the plane.
fn pitchforks(diagram: &Diagram) -> Vec<[f64; 2]> {
    let curves = diagram.curves.iter().filter(|curve| curve.kind == Bifurcation::Pitchfork);
    curves.flat_map(|curve| curve.curve.parameters()).collect()
}

/// The distance of settled motion, with the wall ignored, from its own mirror image after half a
/// period.
fn asymmetry(oscillator: &AnyOscillator, at: [f64; 2], from: [f64; 2], centre: f64) -> f64 {
    let oscillator = oscillator.with_parameters(at);
    let period = oscillator.forcing_period();
    let after = |state: State, time: f64| {
        let there = oscillator.motion(state).at(time);
        let phase = core::f64::consts::TAU * time / period;
        State { position: there.position, velocity: there.velocity, phase: state.phase + phase }
    };
    let mut state = State { position: from[0], velocity: from[1], phase: 0.0 };
    for _ in 0..600 {
        state = State { phase: 0.0, ..after(state, period) };
    }
    let half = after(state, 0.5 * period);
    (state.position + half.position - 2.0 * centre).abs() + (state.velocity + half.velocity).abs()
}

#[test]
fn motion_is_symmetric_on_one_side_of_a_pitchfork_and_not_on_the_other() {
    let [Symmetric { oscillator, centre, diagram, .. }, _] = &*SPECIMENS;
    let centre = *centre;
    let places = pitchforks(diagram);
    assert!(places.len() > 20, "{}", places.len());
    for [primary, secondary] in places.into_iter().step_by(20) {
        let settled = |shift: f64| asymmetry(oscillator, [primary + shift, secondary], [centre, 0.0], centre);
        // This close to it asymmetry takes hundreds of periods to die out; beyond, it grows like
        // the root of the distance.
        assert!(settled(-2e-3) < 1e-4, "at {primary}, {secondary}: {}", settled(-2e-3));
        assert!(settled(2e-3) > 1e-2, "at {primary}, {secondary}: {}", settled(2e-3));
    }
}

#[test]
fn what_is_stable_beside_a_pitchfork_is_decided_on_both_sides() {
    for Symmetric { diagram, .. } in &*SPECIMENS {
        assert!(!pitchforks(diagram).is_empty());
        assert!(
            diagram.regions.iter().all(|region| region.doubt.is_none()),
            "{:?}",
            diagram.regions.iter().filter_map(|region| region.doubt.as_ref()).collect::<Vec<_>>()
        );
    }
}

#[test]
fn an_oscillator_without_symmetry_has_no_pitchfork_to_locate() {
    let [Symmetric { oscillator, scope, centre, .. }, _] = &*SPECIMENS;
    let equations = LoopEquations::without_impacts(oscillator.clone(), scope.window.widths());
    let conditions = [Condition::SymmetryBreaking, Condition::Secondary(0.7)];
    let near = Unknowns::new(*centre, 0.0, 1.0, 0.7);
    let found = locate(&equations, conditions, near, &mut EventTimes::default());
    let undefined = NewtonFailure::Undefined { iteration: 1, cause: MapError::NotSymmetric };
    assert_eq!(found, Err(LocateFailure::Newton(undefined)));
}

#[test]
fn a_one_parameter_diagram_shows_a_pitchfork_where_the_curve_crosses_it() {
    for Symmetric { oscillator, scope, diagram, .. } in &*SPECIMENS {
        let curve = pitchforks(diagram);
        let middle = curve[curve.len() / 2];
        let line = Line { diagram: 1, primary_is_fixed: false, at: middle[1], range: scope.window.primary };
        let cut = Cut::follow(oscillator, scope, &diagram.curves, line, &Silent).expect("nobody stops it");
        let found = cut.diagram().bifurcations;
        let mut found = found.iter().filter(|found| found.kind == Bifurcation::Pitchfork);
        // Both are located to some 10⁻¹⁰.
        assert!(found.any(|found| (found.primary - middle[0]).abs() < 1e-8), "{middle:?}");
    }
}
