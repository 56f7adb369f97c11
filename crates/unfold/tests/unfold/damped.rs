//! Oscillators that forget neighbouring motion within a period, or hardly lose energy, and forces that change
//! with a parameter nowhere but where motion goes.

use grazing_continuation::bifurcation::Bifurcation;
use grazing_input::Description;
use grazing_model::AnyOscillator;
use grazing_model::smooth::Stop;
use grazing_theorems::from_map::GrazingOrbit;
use grazing_unfold::grazing::{GrazingCurve, GrazingEnd};
use grazing_unfold::progress::Silent;
use grazing_unfold::{Diagram, Scope};

use crate::specimens::{described, linear, scope, written};

/// The diagram, in which nothing is undecided or missing.
#[track_caller]
fn decided(oscillator: &AnyOscillator, scope: &Scope) -> Diagram {
    let diagram = Diagram::compute(oscillator, scope, &Silent).unwrap_or_else(|error| panic!("{error}"));
    let doubts: Vec<_> = diagram.regions.iter().filter_map(|region| region.doubt.as_ref()).collect();
    assert!(doubts.is_empty(), "{doubts:?}");
    assert!(diagram.unlocated.is_empty() && diagram.not_unfolded.is_empty(), "{:?}", diagram.not_unfolded);
    diagram
}

/// Whether a stable solution of so many loops is shown at a place.
fn shaded(diagram: &Diagram, loops: u32, place: [f64; 2]) -> bool {
    diagram.regions.iter().any(|region| region.loops == loops && region.contains(place))
}

#[test]
fn what_is_forgotten_within_a_period_drives_no_step_and_solutions_are_stable_from_grazing_on() {
    // Multipliers between 10⁻¹³ and 10⁻³⁸.
    let diagram = decided(&linear(0.7, 0.5, [0.5, 0.1]), &scope([0.0, 2.0], [0.05, 0.15], &[1]));
    let [curve] = diagram.grazing.as_slice() else { panic!("one") };
    assert_eq!(curve.ends, [GrazingEnd::LeftWindow; 2]);
    assert!(curve.states.len() < 300, "{}", curve.states.len());
    assert!(curve.states.iter().all(|state| state.is_forgotten()));
    assert!(diagram.resonances.is_empty());
    assert!(diagram.curves.iter().all(|curve| curve.kind == Bifurcation::Grazing));
    for [_, eta] in curve.parameters().step_by(10) {
        let graz = curve.at(eta).expect("it is on the curve").parameters[0];
        assert_eq!([-1e-3, 1e-3].map(|aside| shaded(&diagram, 1, [graz + aside, eta])), [false, true]);
        assert_eq!([-1e-3, 1e-3].map(|aside| shaded(&diagram, 0, [graz + aside, eta])), [true, false]);
    }
}

#[test]
fn where_memory_fades_along_the_curve_bifurcations_end_on_it() {
    // Overdamped: nothing is resonant, and solutions begin unstable where a period leaves something.
    let scope = scope([0.0, 3.0], [0.12, 0.5], &[1, 2]);
    let diagram = decided(&written("-3*v - x - 1 + mu*cos(eta*t)", "eta", &scope), &scope);
    let [curve] = diagram.grazing.as_slice() else { panic!("one") };
    let forgotten = curve.states.iter().filter(|state| state.is_forgotten()).count();
    assert!(forgotten > 5 && forgotten < curve.states.len() - 5, "{forgotten}");
    assert!(diagram.resonances.is_empty());
    for [_, eta] in curve.parameters().step_by(10) {
        let graz = curve.at(eta).expect("it is on the curve").parameters[0];
        assert_eq!([-2e-3, 2e-3].map(|aside| shaded(&diagram, 1, [graz + aside, eta])), [false, true]);
    }
}

#[test]
fn a_curve_that_is_cut_off_does_not_leave_the_ranges() {
    let ranges = [[0.0, 2.0], [0.5, 1.5]];
    let description = described(["-0.4*v - x - 1 + mu*cos(eta*t)", "eta", "0"], 0.8, ranges);
    let scope = scope(ranges[0], ranges[1], &[1]);
    let through = |stop: &Stop| {
        let oscillator = description.counted([0.4, 1.0], &description.units(), stop);
        let orbit = GrazingOrbit::find(&oscillator, 1.5).expect("it grazes");
        GrazingCurve::through(&orbit, &scope, 1).map(|curve| (curve.states.len(), curve.ends))
    };
    let all = Stop::default();
    let (points, ends) = through(&all).expect("it is a curve");
    assert_eq!(ends, [GrazingEnd::LeftWindow; 2]);
    for share in [0.6, 0.9] {
        let cut = through(&Stop::after((share * all.steps() as f64) as u64));
        let Ok((fewer, ends)) = cut else { continue };
        assert!(fewer < points, "{fewer} of {points}");
        assert!(ends.contains(&GrazingEnd::Stopped), "{ends:?}");
    }
}

#[test]
fn without_damping_a_grazing_orbit_is_neutral() {
    let scope = scope([0.0, 1.0], [1.3, 1.4], &[]);
    let diagram = Diagram::compute(
        &written("-(x + 1) - 0.1*(x + 1)^3 + mu*cos(eta*t)", "eta", &scope),
        &scope,
        &Silent,
    );
    let diagram = diagram.expect("it grazes");
    let states = || diagram.grazing.iter().flat_map(|curve| &curve.states);
    assert!(states().count() > 10);
    assert!(states().all(|state| state.multipliers.neutral() && !state.multipliers.stable()));
}

#[test]
fn a_parameter_that_multiplies_x_has_a_unit_of_the_order_of_its_range() {
    let text = include_str!("../../../../examples/parametric.toml");
    let description = Description::parse(text, "parametric").expect("it is right");
    let mathieu = described(
        ["-0.1*v - (1 + mu*cos(2*eta*t))*x + 0.25*cos(eta*t)", "eta", "0.5"],
        0.8,
        [[0.0, 1.2], [0.6, 0.95]],
    );
    for units in [description.units(), mathieu.units()] {
        assert!(units.primary <= 16.0, "{units:?}");
    }
}
