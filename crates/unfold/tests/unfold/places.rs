//! Attractors at places of Figure 7: motion is named only where it has been shown to have settled.

use grazing_description::Description;
use grazing_model::orbit::Orbit;
use grazing_model::{AnyOscillator, ImpactOscillator, LinearOscillator, State};
use grazing_unfold::long_time::{Horizon, MotionKind, Patience, is_held_at_wall};
use grazing_unfold::place::{Attractor, Place, Starts};
use grazing_unfold::progress::Silent;

use crate::specimens::{EPSILON, ZETA};

fn oscillator([amplitude, frequency]: [f64; 2]) -> AnyOscillator {
    AnyOscillator::new(LinearOscillator::new(ZETA, EPSILON, amplitude, frequency).unwrap())
}

/// The attractors of 40 states: kind, impacts and periods of each.
fn attractors(at: [f64; 2], horizon: Horizon) -> Vec<(MotionKind, u32, u32)> {
    let starts = Starts { states: 40, horizon, ..Starts::default() };
    let place = Place::compute(&oscillator(at), &[1], &starts, &Silent).unwrap();
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
    let place = Place::compute(&oscillator(at), &[1], &starts, &Silent).unwrap();
    for velocity in exact {
        let found = place.solutions.iter().filter(|found| (found.impact[0] - velocity).abs() < 1e-6);
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
fn motion_whose_impacts_accumulate_is_counted_and_drawn_up_to_there_and_is_no_attractor() {
    let starts = Starts { lattice: [8, 6], ..Starts::default() };
    let eps3 = "-0.06*v - x - 0.5*x^3 - 1 + A*cos(w*t)";
    let chatter = "-0.1*v - x - 1 + A*cos(w*t)";
    for (force, at, attracts, most) in [
        (eps3, [1.22557, 0.83052], true, 12),
        (eps3, [1.58831, 0.75761], true, 12),
        (chatter, [5.0, 0.5], false, 24),
        (chatter, [1.2, 0.35], false, 24),
    ] {
        let oscillator = forced(force, 0.3, at);
        let place = Place::compute(&oscillator, &[1], &starts, &Silent).unwrap();
        let [rest @ .., last] = &place.attractors[..] else { panic!("{at:?}") };
        let kinds: Vec<_> = rest.iter().map(|one| (one.fate.kind, one.fate.periods)).collect();
        let expected = [(MotionKind::Periodic, Some(1))];
        assert_eq!(kinds, expected[..usize::from(attracts)], "{at:?}");
        assert_eq!(last.fate.kind, MotionKind::Accumulating, "{at:?}");
        assert!((1..=most).contains(&last.states), "{at:?}: {}", last.states);
        assert_eq!(place.attractors.iter().map(|one| one.states).sum::<u32>(), starts.states);
        // The velocities of the last impacts fall by the restitution, until the last is hardly resolved; the force
        // changes during the flights before, by a share that falls with the velocity.
        let velocities: Vec<f64> = last.strikes.iter().rev().map(|strike| strike[1]).collect();
        assert!(velocities[0] < 1e-6 && velocities.len() >= 8, "{at:?}: {velocities:?}");
        let mut ratios = velocities.windows(2).skip(1).take(3).map(|pair| pair[0] / pair[1]);
        assert!(ratios.all(|ratio| (ratio - 0.3).abs() < 0.01), "{at:?}: {velocities:?}");
        let times = last.flights.iter().flatten().map(|point| point[0]);
        let [first, end] = times.fold([f64::INFINITY, 0.0], |[a, b], time| [a.min(time), b.max(time)]);
        assert!(end - first > 0.0 && end - first < 9.0 * place.period, "{at:?}: {first} {end}");
        // All of the lattice is decided, and both are in it where both exist.
        let count = |index| place.basins.iter().filter(|(_, basin)| *basin == Some(index)).count();
        assert_eq!((0..place.attractors.len()).map(count).sum::<usize>(), 48, "{at:?}");
        assert!((0..place.attractors.len()).all(|index| count(index) > 0), "{at:?}");
    }
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
        assert_eq!(is_held_at_wall(&oscillator), held, "{force}, {amplitude}");
    }
    for (amplitude, kind) in [(0.3, MotionKind::Resting), (1.2, MotionKind::Accumulating)] {
        let oscillator = forced("-0.1*v - x + 1 + A*cos(w*t)", 0.5, [amplitude, 0.7]);
        let place = Place::compute(&oscillator, &[1], &Starts::default(), &Silent).unwrap();
        let found: Vec<_> = place.attractors.iter().map(|one| (one.fate.kind, one.states)).collect();
        assert_eq!(found, [(kind, 24)], "{amplitude}");
    }
}

#[test]
fn motion_that_stays_where_it_is_is_one_attractor() {
    let oscillator = forced("-0.5*v - x - 1 + A*cos(w*t)", 0.3, [0.0, 0.8]);
    let starts = Starts { lattice: [4, 3], ..Starts::default() };
    let place = Place::compute(&oscillator, &[1], &starts, &Silent).unwrap();
    let found: Vec<_> = place.attractors.iter().map(|one| (one.fate.kind, one.states)).collect();
    assert_eq!(found, [(MotionKind::NonImpacting, 24)]);
    assert!(place.basins.iter().all(|(_, basin)| *basin == Some(0)));
}
