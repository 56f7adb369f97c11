//! Attractors at places of Figure 7: motion is named only where it has been shown to have settled.

use core::f64::consts::TAU;

use grazing_input::Description;
use grazing_model::orbit::{Flight, FlightEnd, Orbit};
use grazing_model::rest::release;
use grazing_model::{AnyOscillator, ImpactOscillator, LinearOscillator, State};
use grazing_unfold::Scope;
use grazing_unfold::long_time::{Fate, Horizon, MotionKind, Patience};
use grazing_unfold::place::{Attractor, Place, Starts};
use grazing_unfold::progress::Silent;

use crate::specimens::{self, EPSILON, ZETA};

fn oscillator([amplitude, frequency]: [f64; 2]) -> AnyOscillator {
    AnyOscillator::new(LinearOscillator::new(ZETA, EPSILON, amplitude, frequency).unwrap())
}

/// Solutions of one loop, and the window of Figure 7.
fn scope() -> Scope {
    specimens::scope([0.0, 1.2], [0.3, 1.6], &[1])
}

/// The attractors of 40 states: kind, impacts and periods of each.
fn attractors(at: [f64; 2], horizon: Horizon) -> Vec<(MotionKind, u32, u32)> {
    let starts = Starts { states: 40, horizon, ..Starts::default() };
    let place = Place::compute(&oscillator(at), &scope(), &starts, &Silent).unwrap();
    let named = place.attractors.into_iter().map(|Attractor { fate, exponent, .. }| {
        assert_eq!(exponent.is_positive(), fate.kind == MotionKind::Chaotic);
        // A cycle has an exact exponent, and attracts.
        assert_eq!(exponent.mean < 0.0 && exponent.error == 0.0, fate.periods.is_some());
        let periods = fate.periods.unwrap_or(0);
        (fate.kind, libm::round(fate.impacts * f64::from(periods)) as u32, periods)
    });
    named.collect()
}

#[test]
fn motion_is_named_when_it_has_settled_and_each_attractor_once() {
    let usual = Starts::default().horizon;
    for (at, kind, impacts, periods) in [
        // Transients of over a thousand periods.
        ([0.265, 0.8541], MotionKind::NonImpacting, 0, 1),
        // Motion that approaches its cycle so slowly that it looks like a cycle of twice the
        // length.
        ([0.3, 0.8541], MotionKind::Periodic, 3, 6),
        ([0.25, 0.87], MotionKind::Periodic, 2, 6),
    ] {
        assert_eq!(attractors(at, usual), [(kind, impacts, periods)], "{at:?}");
        // By simulation alone, for a long time.
        let oscillator = oscillator(at);
        let period = oscillator.forcing_period();
        let mut orbit = Orbit::new(&oscillator, State::at_rest(-0.3, 1.0), 20_000.0 * period, usize::MAX);
        let late = orbit.by_ref().filter(|flight| flight.start > 19_900.0 * period);
        let velocities: Vec<f64> = late.map(|flight| flight.from.velocity).collect();
        let again =
            |count: usize| (velocities.iter().zip(&velocities[count..])).all(|(a, b)| (a - b).abs() < 1e-6);
        match impacts {
            0 => assert!(velocities.is_empty()),
            _ => assert_eq!((1..=20).find(|count| again(*count)), Some(impacts as usize), "{at:?}"),
        }
    }
}

#[test]
fn what_has_not_settled_is_not_named_but_chaos_is() {
    let short = Horizon { transient: 5, counted: 6, patience: Patience::Drifting, longest: 0 };
    let [(MotionKind::Unsettled, ..), ..] = attractors([0.265, 0.8541], short)[..] else {
        panic!("it takes longer than that to settle");
    };
    let found = attractors([0.5, 0.6], Starts::default().horizon);
    assert_eq!(found, [(MotionKind::Chaotic, 0, 0), (MotionKind::NonImpacting, 0, 1)]);
}

#[test]
fn fast_solutions_at_a_place_are_found_as_in_the_plane() {
    let at @ [amplitude, frequency] = [4.0, 0.6];
    let exact = grazing_trials::closed_form::orbits(ZETA, EPSILON, amplitude, frequency, 1);
    let exact: Vec<f64> =
        exact.iter().map(|orbit| orbit.velocity).filter(|velocity| *velocity > 0.0).collect();
    assert!(exact.iter().any(|velocity| (2.5..16.0).contains(velocity)), "{exact:?}");
    let horizon = Horizon { transient: 5, counted: 6, patience: Patience::Drifting, longest: 0 };
    let starts = Starts { states: 1, horizon, ..Starts::default() };
    let place = Place::compute(&oscillator(at), &scope(), &starts, &Silent).unwrap();
    for velocity in exact {
        let velocities = place.solutions.iter().filter_map(|found| found.impacts.first());
        let found = velocities.filter(|impact| (impact[0] - velocity).abs() < 1e-6);
        assert_eq!(found.count(), 1, "{velocity}");
    }
}

/// The oscillator with this force and restitution, and the parameters A and w, at a place.
fn forced(force: &str, restitution: f64, at: [f64; 2]) -> AnyOscillator {
    let text = format!(
        "name = \"forced\"\nparameters = {{}}\nprimary = {{ name = \"A\", range = [0, 9] }}\n\
         secondary = {{ name = \"w\", range = [0.1, 2] }}\nmotion = {{ force = \"{force}\", frequency = \"w\" }}\n\
         impact = {{ restitution = \"{restitution}\", duration = \"0\" }}\nanalysis = {{ loops = [1] }}"
    );
    Description::parse(&text, "forced").expect("it is right").oscillator(at)
}

#[test]
fn motion_that_rests_at_the_wall_is_one_attractor_with_all_states_and_forgets_where_it_was() {
    let starts = Starts { lattice: [8, 6], ..Starts::default() };
    let chatter = "-0.1*v - x - 1 + A*cos(w*t)";
    for at in [[5.0, 0.5], [2.0, 0.5], [1.2, 0.35]] {
        let oscillator = forced(chatter, 0.3, at);
        let place = Place::compute(&oscillator, &scope(), &starts, &Silent).unwrap();
        let [one] = &place.attractors[..] else { panic!("{at:?}: {:?}", place.attractors) };
        let Fate { kind, periods, impacts, rests, .. } = one.fate;
        assert_eq!(
            (kind, periods, impacts, rests),
            (MotionKind::Periodic, Some(1), f64::INFINITY, 1.0),
            "{at:?}"
        );
        assert_eq!((one.states, one.fate.loops()), (starts.states, None));
        assert_eq!((one.exponent.mean, one.exponent.error), (f64::NEG_INFINITY, 0.0));
        assert!(place.basins.iter().all(|(_, basin)| *basin == Some(0)));
        // From rest along the wall to the last impact that is followed, once round.
        let first = &one.flights[0];
        assert!(first[0][1..] == [0.0, 0.0] && first[1][1].abs() < 1e-14 && first[1][2].abs() < 1e-14);
        let phase = |time: f64| libm::fmod(time / place.period, 1.0);
        // The force lets go where A cos z = 1.
        let release = libm::acos(1.0 / at[0]) / TAU;
        assert!((phase(first[1][0]) - release).abs() < 1e-12, "{at:?}: {} {release}", phase(first[1][0]));
        assert!(first[1][0] - first[0][0] > 1e-3 * place.period);
        let last = one.flights.last().and_then(|flight| flight.last()).unwrap();
        let round = last[0] - first[0][0];
        assert!(round < place.period && round > place.period - 0.05, "{at:?}: {round}");
        // From the release on it is the motion that any simulation of it shows.
        let mut orbit = Orbit::new(&oscillator, State::at_rest(-1.7, 2.0), 8.0 * place.period, usize::MAX);
        let struck = |flight: Flight<_>| match flight.end {
            FlightEnd::Impact(impact) => flight.rest.map(|_| impact),
            FlightEnd::TimeIsUp(_) => None,
        };
        let impact = orbit.by_ref().filter_map(struck).last().unwrap();
        assert!((impact.velocity - one.strikes[0][1]).abs() < 1e-9, "{at:?}: {impact:?}");
    }
}

#[test]
fn motion_that_rests_on_the_way_reaches_the_attractor_of_all_other_states() {
    // Rest at the wall was once counted as an attractor here, with a share of 25 % and of 12 %.
    let starts = Starts { lattice: [8, 6], ..Starts::default() };
    for at in [[1.22557, 0.83052], [1.58831, 0.75761]] {
        let oscillator = forced("-0.06*v - x - 0.5*x^3 - 1 + A*cos(w*t)", 0.3, at);
        let place = Place::compute(&oscillator, &scope(), &starts, &Silent).unwrap();
        let [one] = &place.attractors[..] else { panic!("{at:?}: {:?}", place.attractors) };
        let Fate { kind, periods, impacts, rests, .. } = one.fate;
        assert_eq!((kind, periods, impacts, rests), (MotionKind::Periodic, Some(1), 2.0, 0.0), "{at:?}");
        assert_eq!(one.states, starts.states);
        assert!(place.basins.iter().all(|(_, basin)| *basin == Some(0)));
        // Some of the states do rest on their way.
        let resting = |x: f64| {
            let mut orbit = Orbit::new(&oscillator, State::at_rest(x, 0.0), 40.0 * place.period, usize::MAX);
            orbit.any(|flight| flight.rest.is_some())
        };
        assert!((1..40).any(|k| resting(-0.05 * f64::from(k))), "{at:?}");
    }
}

#[test]
fn plastic_impacts_rest_at_once_and_are_counted() {
    // Motion leaves the wall at once after the first impact, where the force pulls, and sticks after the
    // second, where it presses.
    let oscillator = forced("-0.1*v - x - 1 + A*cos(w*t)", 0.0, [5.0, 0.5]);
    let place = Place::compute(&oscillator, &scope(), &Starts::default(), &Silent).unwrap();
    let [one] = &place.attractors[..] else { panic!("{:?}", place.attractors) };
    let Fate { kind, periods, impacts, rests, .. } = one.fate;
    assert_eq!((kind, periods, impacts, rests), (MotionKind::Periodic, Some(1), 2.0, 1.0));
    let force = |phase: f64| 5.0 * libm::cos(phase) - 1.0;
    let forces: Vec<f64> = one.strikes[..2].iter().map(|[phase, _]| force(*phase)).collect();
    assert!(forces[0] < 0.0 && forces[1] > 0.0, "{forces:?}");
}

#[test]
fn rest_is_what_the_force_holds_at_the_wall_for_a_whole_period() {
    // Beside a phase at which it is evaluated the force turns for less than the distance to the next.
    let pulse = "-0.1*v - x + 1 - A*exp(20000*(cos(w*t - 0.0061) - 1))";
    for (force, amplitude, held) in [
        ("-0.1*v - x + 1 + A*cos(w*t)", 0.3, true),
        ("-0.1*v - x + 1 + A*cos(w*t)", 0.999_999, true),
        ("-0.1*v - x + 1 + A*cos(w*t)", 1.000_001, false),
        (pulse, 0.999, true),
        (pulse, 1.001, false),
    ] {
        let oscillator = forced(force, 0.5, [amplitude, 0.7]);
        assert_eq!(release(&oscillator, 0.0).is_none(), held, "{force}, {amplitude}");
    }
    for (amplitude, kind) in [(0.3, MotionKind::Resting), (1.2, MotionKind::Periodic)] {
        let oscillator = forced("-0.1*v - x + 1 + A*cos(w*t)", 0.5, [amplitude, 0.7]);
        let place = Place::compute(&oscillator, &scope(), &Starts::default(), &Silent).unwrap();
        let found: Vec<_> = place.attractors.iter().map(|one| (one.fate.kind, one.states)).collect();
        assert_eq!(found, [(kind, 24)], "{amplitude}");
        // It is drawn along the wall.
        let points = || place.attractors[0].flights.iter().flatten();
        assert!(points().any(|[_, x, v]| *x == 0.0 && *v == 0.0), "{amplitude}");
    }
}

#[test]
fn motion_that_stays_where_it_is_is_one_attractor() {
    let oscillator = forced("-0.5*v - x - 1 + A*cos(w*t)", 0.3, [0.0, 0.8]);
    let starts = Starts { lattice: [4, 3], ..Starts::default() };
    let place = Place::compute(&oscillator, &scope(), &starts, &Silent).unwrap();
    let found: Vec<_> = place.attractors.iter().map(|one| (one.fate.kind, one.states)).collect();
    assert_eq!(found, [(MotionKind::NonImpacting, 24)]);
    assert!(place.basins.iter().all(|(_, basin)| *basin == Some(0)));
}

#[test]
fn solutions_with_several_impacts_are_those_of_simulation_with_what_else_their_branches_have() {
    // Two impacts in three periods between two saddle-nodes, beside the frequency of Figure 2.
    let here = oscillator([0.305, 0.8541]);
    let place = Place::compute(&here, &scope(), &Starts::default(), &Silent).unwrap();
    let reached = place.attractors.iter().find(|one| one.fate.numbers() == Some((2, 3)));
    assert!(reached.is_some(), "{:?}", place.attractors.iter().map(|one| one.fate).collect::<Vec<_>>());
    let own = || place.solutions.iter().filter(|one| (one.impacts.len(), one.loops) == (2, 3));
    let [stable, unstable] = [true, false]
        .map(|stable| own().filter(|one| one.admissible && one.multipliers.stable() == stable).count());
    assert_eq!((stable, unstable), (1, 1), "the branch folds");
    for one in own().filter(|one| one.admissible) {
        assert_eq!(one.orbit.len(), 2);
        let [velocity, phase] = one.impacts[0];
        assert!(one.impacts.iter().all(|impact| impact[0] >= velocity));
        // The hybrid system comes back to the first impact, without Newton's method.
        let from = State { position: 0.0, velocity, phase };
        let mut orbit = Orbit::new(&here, from, 3.5 * here.forcing_period(), 10);
        let ends: Vec<State> = orbit
            .by_ref()
            .filter_map(|flight| match flight.end {
                FlightEnd::Impact(state) => Some(state),
                FlightEnd::TimeIsUp(_) => None,
            })
            .collect();
        assert!((ends[1].velocity - velocity).abs() < 1e-7, "{ends:?} {one:?}");
        assert!(libm::remainder(ends[1].phase - phase, TAU).abs() < 1e-7, "{ends:?} {one:?}");
        let second = one.impacts[1];
        assert!((ends[0].velocity - second[0]).abs() < 1e-7, "{ends:?} {one:?}");
    }
}
