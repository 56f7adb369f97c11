//! Resonances from one member of a family to another, compared with the closed form of the linear
//! oscillator.

use std::f64::consts::PI;

use grazing_continuation::curve::Window;
use grazing_input::Description;
use grazing_model::motion::Motion;
use grazing_model::{AnyOscillator, ImpactOscillator, State};
use grazing_theorems::from_map::GrazingOrbit;
use grazing_theorems::hypothesis::Quantity;
use grazing_theorems::linear_oscillator::LinearOscillator;
use grazing_unfold::family::{Arc, ArcEnd, arcs};
use grazing_unfold::progress::Silent;
use grazing_unfold::{Diagram, Scope};

/// The paper's oscillator with a frequency that is an expression in eta and c; the bounds of eta
/// are given.
fn linear(frequency: &str, [low, high]: [f64; 2]) -> Description {
    let text = format!(
        "name = \"Test\"\n[parameters]\nzeta = 0.02\nepsilon = 0.9\nc = 0.76\n[primary]\nname = \"A\"\nrange = [0, 1.5]\n\
         [secondary]\nname = \"eta\"\nrange = [{low}, {high}]\n[motion]\nforce = \"-2*zeta*v - x - 1 + A*cos(({frequency})*t)\"\n\
         frequency = \"{frequency}\"\n[impact]\nrestitution = \"epsilon\"\nduration = \"0\"\n[analysis]\nloops = [1, 2, 3]\n"
    );
    Description::parse(&text, "test.toml").unwrap_or_else(|error| panic!("{error}"))
}

/// An oscillator with a given force and restitution, in a window about the resonance p = 1, n = 3.
fn written(force: &str, restitution: &str) -> Description {
    let text = format!(
        "name = \"Test\"\n[parameters]\nc = 0\n[primary]\nname = \"A\"\nrange = [-0.3, 1.5]\n\
         [secondary]\nname = \"eta\"\nrange = [0.55, 0.8]\n[motion]\nforce = \"{force}\"\nfrequency = \"eta\"\n\
         [impact]\nrestitution = \"{restitution}\"\nduration = \"0\"\n[analysis]\nloops = [1]\n"
    );
    Description::parse(&text, "test.toml").unwrap_or_else(|error| panic!("{error}"))
}

type Found = Vec<Arc>;

/// The resonances of an oscillator with one value of a constant, and their arcs to another value.
fn followed(description: &Description, name: &str, [from, to]: [f64; 2]) -> (Diagram, Found) {
    let at = |way: f64| {
        let there = description.with_constant(name, from + (to - from) * way).ok()?;
        Some(there.oscillator([0.0, description.secondary().range()[0]]))
    };
    let window =
        Window { primary: description.primary().range(), secondary: description.secondary().range() };
    let scope = Scope { window, loops: description.loops().to_vec(), start: None };
    let first = at(0.0).expect("an oscillator");
    let diagram = Diagram::located(&first, &scope, &Silent).unwrap_or_else(|error| panic!("{error}"));
    let arcs = arcs(&diagram, &at);
    (diagram, arcs)
}

#[test]
fn resonances_and_coefficients_along_the_way_are_those_of_the_closed_form() {
    let description = linear("eta", [0.42, 1.1]);
    let zeta = |way: f64| 0.02 + 0.03 * way;
    let (diagram, arcs) = followed(&description, "zeta", [0.02, 0.05]);
    assert!(diagram.resonances.len() >= 6 && arcs.len() == diagram.resonances.len());
    for arc in &arcs {
        assert_eq!(arc.end, ArcEnd::Across);
        let resonance = &diagram.resonances[arc.resonance];
        let mut checked = 0;
        for at in &arc.points {
            let [primary, secondary] = at.orbit.oscillator().parameters();
            let exact = LinearOscillator::new(zeta(at.way), 0.9).unwrap();
            // Resonances with a negative a12 alpha for p >= 2 have no closed form in the paper.
            let Ok(exact) = exact.resonance(resonance.loops, resonance.n) else { continue };
            if (exact.forcing_frequency() - secondary).abs() > 0.01 {
                continue;
            }
            checked += 1;
            assert!((exact.forcing_frequency() - secondary).abs() < 1e-10);
            assert!((exact.grazing().amplitude() - primary).abs() < 1e-10);
            let computed = [at.point.saddle_node_coefficient(), at.point.period_doubling_coefficient()];
            let stated = [exact.saddle_node_coefficient(), exact.period_doubling_coefficient()];
            for (computed, stated) in computed.into_iter().zip(stated) {
                assert!((computed / stated - 1.0).abs() < 1e-8, "{computed} {stated}");
            }
        }
        assert!(checked == 0 || checked == arc.points.len());
    }
}

#[test]
fn a_coefficient_is_infinite_where_restitution_makes_up_for_damping() {
    let description = linear("eta", [0.6, 1.1]);
    let (diagram, arcs) = followed(&description, "epsilon", [1.05, 1.45]);
    let mut found = Vec::new();
    for arc in &arcs {
        let resonance = &diagram.resonances[arc.resonance];
        for at in arc.points.iter().filter(|at| at.zero.is_some()) {
            let [_, secondary] = at.orbit.oscillator().parameters();
            let epsilon = 1.05 + 0.4 * at.way;
            let damping = libm::exp(-2.0 * PI * f64::from(resonance.loops) * 0.02 / secondary);
            assert!((epsilon * damping - 1.0).abs() < 1e-9, "{epsilon} {damping}");
            found.push((resonance.loops, resonance.n, at.zero));
        }
    }
    // s_p^+ = -(1 - epsilon E_p)^2, but for p = 1 and even n s_1^- = (1 - epsilon E_1)^2.
    let [plus, minus] = [Quantity::SaddleNodeStability, Quantity::PeriodDoublingStability];
    assert_eq!(found, [(1, 3, Some(plus)), (1, 2, Some(minus)), (2, 1, Some(plus))]);
}

#[test]
fn two_resonances_that_meet_are_one_curve_and_the_place_is_that_of_the_closed_form() {
    // omega = c + (eta - 1/2)^2 / 2 takes every value twice that is greater than c.
    let description = linear("c + 0.5*(eta - 0.5)^2", [0.1, 0.9]);
    let (diagram, arcs) = followed(&description, "c", [0.76, 0.84]);
    let (loops, n) = (2, 1);
    let own: Vec<_> = arcs.iter().filter(|arc| diagram.resonances[arc.resonance].loops == loops).collect();
    assert_eq!(diagram.resonances.iter().filter(|resonance| resonance.loops == loops).count(), 2);
    // The way back is not listed separately.
    let [arc] = own[..] else { panic!("{} arcs", own.len()) };
    let ArcEnd::Back(Some(other)) = arc.end else { panic!("{:?}", arc.end) };
    assert!(other > arc.resonance && diagram.resonances[other].loops == loops);
    let meeting: Vec<_> =
        arc.points.iter().filter(|at| at.zero == Some(Quantity::DetuningDerivative)).collect();
    let [meeting] = meeting[..] else { panic!("{} meetings", meeting.len()) };
    let exact = LinearOscillator::new(0.02, 0.9).unwrap().resonance(loops, n).unwrap().forcing_frequency();
    assert!((0.76 + 0.08 * meeting.way - exact).abs() < 1e-10);
    assert!((meeting.orbit.oscillator().parameters()[1] - 0.5).abs() < 1e-8);
}

#[test]
fn a_resonance_ends_where_another_maximum_of_its_orbit_touches_the_wall() {
    // When the second harmonic dominates, the lower of two maxima reaches the wall where A = 0.
    let description = written("-0.04*v - x - 1 + A*cos(eta*t) + c*cos(2*eta*t + 0.3)", "0.9");
    let (_, arcs) = followed(&description, "c", [0.0, 1.5]);
    let [arc] = &arcs[..] else { panic!("{} arcs", arcs.len()) };
    assert_eq!(arc.end, ArcEnd::Inadmissible);
    let second = |orbit: &GrazingOrbit<AnyOscillator>| {
        // From the maximum at the wall once round, excluding it.
        let motion = orbit.oscillator().motion(State::on_wall(0.0, orbit.phase()));
        let period = orbit.oscillator().forcing_period();
        let inner = motion.local_maxima(period).into_iter();
        let inner = inner.filter(|maximum| (0.01 * period..0.99 * period).contains(&maximum.time));
        inner.map(|maximum| maximum.position).fold(f64::NEG_INFINITY, f64::max)
    };
    let (last, before) = arc.points.split_last().expect("there are points");
    // Located to 1e-11 of the change on a step; no earlier orbit passes through the wall.
    assert!(second(&last.orbit).abs() < 1e-9, "{}", second(&last.orbit));
    assert!(!before.is_empty() && before.iter().all(|at| second(&at.orbit) < 1e-9));
    assert!(0.0 < last.way && last.way < 1.0, "{}", last.way);
}

#[test]
fn an_extremum_is_a_double_zero_only_if_it_is_zero() {
    // c from 0 to 1: the restitution is least in the middle, and is zero there or is not.
    for (least, zeros) in [("0", 1), ("0.001", 0)] {
        let restitution = format!("{least} + 3*(c - 0.5)^2");
        let description = written("-0.04*v - x - 1 + A*cos(eta*t)", &restitution);
        let (_, arcs) = followed(&description, "c", [0.0, 1.0]);
        let [arc] = &arcs[..] else { panic!("{} arcs", arcs.len()) };
        assert_eq!(arc.end, ArcEnd::Across);
        let found: Vec<_> = arc.points.iter().filter(|at| at.zero == Some(Quantity::Restitution)).collect();
        assert_eq!(found.len(), zeros, "{least}");
        for at in found {
            // The square root of the accuracy of a double zero.
            assert!((at.way - 0.5).abs() < 1e-4 && at.point.grazing.phi < 1e-7, "{}", at.way);
        }
    }
}

#[test]
fn a_resonance_leaves_the_window_at_either_edge_before_the_other_member() {
    let resonance = LinearOscillator::new(0.02, 0.9).unwrap().resonance(1, 3).unwrap();
    let at = resonance.forcing_frequency();
    for (frequency, edge) in [("eta + 0.76 - c", 0.8), ("eta - 0.76 + c", 0.6)] {
        let description = linear(frequency, [0.6, 0.8]);
        let (diagram, arcs) = followed(&description, "c", [0.76, 1.06]);
        let is_it = |arc: &&Arc| {
            let found = &diagram.resonances[arc.resonance];
            (found.loops, found.n) == (1, 3)
        };
        let arc = arcs.iter().find(is_it).expect("it is in the window");
        assert_eq!(arc.end, ArcEnd::LeftWindow, "{frequency}");
        let last = arc.points.last().expect("it has points");
        assert!((last.orbit.oscillator().parameters()[1] - edge).abs() < 1e-9);
        // The frequency there is unchanged, and c has moved by the distance to the edge.
        assert!((0.3 * last.way - (edge - at).abs()).abs() < 1e-9, "{frequency}: {}", last.way);
    }
}
