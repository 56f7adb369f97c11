//! The map of attractors: orbits followed event by event, closed forms, and neighbouring orbits.

use core::f64::consts::TAU;
use std::collections::BTreeSet;

use grazing_beyond::attractors::{BeyondAttractors, Map, STARTS, Stretch};
use grazing_model::orbit::{FlightEnd, Orbit, OrbitEnd};
use grazing_model::{AnyOscillator, ImpactOscillator, LinearOscillator, State};
use grazing_reproduction::forced;
use grazing_trials::closed_form;
use grazing_trials::random::Random;
use grazing_trials::simulation::settled;
use grazing_unfold::long_time::{Horizon, MotionKind, Patience};
use grazing_unfold::place::seen;

use super::{study, theory};

const COARSE: BeyondAttractors = BeyondAttractors { columns: 61, rows: 37 };

/// The paper's oscillator at a place (amplitude, frequency).
fn oscillator([amplitude, frequency]: [f64; 2]) -> LinearOscillator {
    forced(&theory(), amplitude, frequency).expect("it is one")
}

/// The stable, admissible p-loop MPS at a place, in closed form.
fn stable([amplitude, frequency]: [f64; 2], loops: u32) -> Option<closed_form::ClosedFormOrbit> {
    let (zeta, epsilon) = (theory().damping_ratio(), theory().coefficient_of_restitution());
    let all = closed_form::orbits(zeta, epsilon, amplitude, frequency, loops);
    all.into_iter().find(|orbit| orbit.stable() && orbit.admissible())
}

/// Random places of the coarse map, with the attractors there.
fn places(seed: u64, count: u32) -> Vec<([f64; 2], Vec<Stretch>)> {
    let map = Map::of(&COARSE, study()).expect("it is right");
    let mut random = Random::new(seed);
    let mut place = |_| {
        let [column, row] =
            [COARSE.columns, COARSE.rows].map(|count| random.uniform(0.0, f64::from(count)) as u32);
        let rows = map.rows(row as usize..row as usize + 1);
        let mut end = 0;
        let there = rows[0].groups().find(|group| {
            end += group[0].places;
            column < end
        });
        (map.place(column, row), there.expect("all places are there").to_vec())
    };
    (0..count).map(&mut place).collect()
}

/// The state after a time, with the number of impacts; none where motion sticks.
fn after(oscillator: &LinearOscillator, from: State, time: f64) -> Option<(State, u32)> {
    let mut orbit = Orbit::new(oscillator, from, time, usize::MAX);
    let impacts = orbit.by_ref().filter(|flight| matches!(flight.end, FlightEnd::Impact(_))).count();
    match orbit.end() {
        Some(OrbitEnd::TimeIsUp(state)) => Some((state, impacts as u32)),
        _ => None,
    }
}

/// The period in forcing periods of the long-term motion from a state, and its impacts in a period; an
/// error if it is still converging.
fn comes_again(oscillator: &LinearOscillator, from: State) -> Result<Option<(u32, u32)>, ()> {
    let period = oscillator.forcing_period();
    let Some((settled, _)) = after(oscillator, from, 1500.0 * period) else { return Ok(None) };
    let (mut here, mut impacts) = (settled, 0);
    for periods in 1..=24 {
        let Some((next, more)) = after(oscillator, here, period) else { return Ok(None) };
        (here, impacts) = (next, impacts + more);
        match libm::hypot(here.position - settled.position, here.velocity - settled.velocity) {
            gap if gap < 1e-7 => return Ok(Some((periods, impacts))),
            gap if gap < 1e-4 => return Err(()),
            _ => {}
        }
    }
    Ok(None)
}

#[test]
fn places_of_the_map_have_what_orbits_come_to_that_are_followed_event_by_event() {
    let (mut compared, mut coexisting) = (0, 0);
    for (place, there) in places(1, 160) {
        let oscillator = oscillator(place);
        let starts = STARTS.map(|(position, turns)| State::at_rest(position, TAU * turns));
        let direct: Result<Vec<_>, ()> =
            starts.iter().map(|start| comes_again(&oscillator, *start)).collect();
        let Ok(direct) = direct else { continue };
        for loops in there.iter().filter_map(Stretch::loops).filter(|loops| *loops > 0) {
            assert!(stable(place, loops).is_some(), "{place:?}: {there:?}");
        }
        let periodic = there.iter().filter(|one| one.periods > 0);
        let mapped: BTreeSet<_> = periodic
            .map(|one| (one.periods, (one.impacts * f64::from(one.periods)).round() as u32))
            .collect();
        let found: BTreeSet<_> = direct.iter().flatten().copied().collect();
        assert!(mapped.is_subset(&found), "{place:?}: {mapped:?} {direct:?}");
        // Motion that has not settled within the map's time may do so later.
        if there.iter().all(|one| one.periods > 0) {
            assert_eq!(mapped, found, "{place:?}");
            compared += 1;
            coexisting += u32::from(mapped.len() > 1);
        }
    }
    assert!(compared > 110 && coexisting > 5, "{compared} {coexisting}");
}

#[test]
fn where_one_attractor_is_seen_random_states_settle_on_it() {
    let (mut same, mut other) = (0, 0);
    let mut random = Random::new(7);
    for (place, there) in places(2, 200) {
        let [one] = &there[..] else { continue };
        let (Some(loops), Some(found)) = (one.loops(), settled(&oscillator(place), &mut random)) else {
            continue;
        };
        *(if found.loops == loops { &mut same } else { &mut other }) += 1;
    }
    // All four initial states of the map may miss a basin.
    assert!(same > 90 && other * 25 < same, "{same} {other}");
}

#[test]
fn regions_of_figure_7_explain_all_mps_of_the_map() {
    let map = Map::of(&COARSE, study()).expect("it is right");
    let shown = map.assembled(map.rows(0..map.count())).expect("it grazes");
    assert_eq!(shown.counts.iter().map(|count| count.loops).collect::<Vec<_>>(), [0, 1, 2, 3]);
    for count in &shown.counts {
        assert_eq!((count.unexplained, count.settled + count.unseen), (0, count.in_regions), "{count:?}");
        assert!(count.in_regions > 10 && 4 * count.settled > 3 * count.in_regions, "{count:?}");
    }
    let remarked: u32 = shown.remarks.iter().map(|remark| remark.places).sum();
    assert_eq!(remarked, shown.counts.iter().map(|count| count.unseen).sum());
}

#[test]
fn orbits_that_begin_beside_an_mps_that_the_map_does_not_see_come_to_it() {
    let map = Map::of(&COARSE, study()).expect("it is right");
    let shown = map.assembled(map.rows(0..map.count())).expect("it grazes");
    let mut tried = [0; 4];
    for remark in &shown.remarks {
        let place = [remark.first, remark.secondary];
        let oscillator = oscillator(place);
        let beside = match remark.loops {
            0 => oscillator.non_impacting_solution(0.0),
            loops => {
                let stable = stable(place, loops).unwrap_or_else(|| panic!("{remark:?}"));
                State::on_wall(stable.velocity * (1.0 + 1e-7), stable.phase)
            }
        };
        let horizon = Horizon { transient: 32, counted: 16, patience: Patience::Unsettled, longest: 400 };
        let [found] = seen(&AnyOscillator::new(oscillator), &[beside], horizon)[..] else {
            panic!("one state, one attractor")
        };
        assert_eq!(found.fate.loops(), Some(remark.loops), "{remark:?}");
        tried[remark.loops as usize] += 1;
    }
    assert!(tried[..3].iter().all(|count| *count > 5), "{tried:?}");
}

/// The largest exponent from a nearby orbit, rescaled in every period, and its standard error.
fn by_differences(oscillator: &LinearOscillator) -> [f64; 2] {
    const NEAR: f64 = 1e-8;
    const PART: u32 = 400;
    let period = oscillator.forcing_period();
    let (position, turns) = STARTS[1];
    let (mut here, _) =
        after(oscillator, State::at_rest(position, TAU * turns), 600.0 * period).expect("it goes on");
    let mut by = [0.6 * NEAR, 0.8 * NEAR];
    let rates = [(); 10].map(|()| {
        let mut growth = 0.0;
        for _ in 0..PART {
            let beside = State { position: here.position + by[0], velocity: here.velocity + by[1], ..here };
            let [next, other] =
                [here, beside].map(|from| after(oscillator, from, period).expect("it goes on").0);
            by = [other.position - next.position, other.velocity - next.velocity];
            let size = libm::hypot(by[0], by[1]);
            growth += libm::log(size / NEAR);
            by = by.map(|part| part * NEAR / size);
            here = next;
        }
        growth / (f64::from(PART) * period)
    });
    let mean = rates.iter().sum::<f64>() / 10.0;
    let squares: f64 = rates.iter().map(|rate| (rate - mean) * (rate - mean)).sum();
    [mean, (squares / 90.0).sqrt()]
}

#[test]
fn exponents_of_irregular_motion_are_those_of_orbits_beside_each_other() {
    let map = Map::of(&COARSE, study()).expect("it is right");
    let (mut seen, mut off) = (0, 0);
    for row in &map.rows(0..map.count()) {
        let alone = row.groups().filter(|group| group.len() == 1 && group[0].places == 1);
        for one in alone.map(|group| &group[0]).filter(|one| one.motion == "chaotic") {
            let [mean, error] = by_differences(&oscillator([one.first, one.secondary]));
            assert_eq!(one.least.to_bits(), one.greatest.to_bits());
            seen += 1;
            off += u32::from((one.least - mean).abs() > 4.0 * libm::hypot(error, one.error));
        }
    }
    assert!(seen > 15 && off * 10 <= seen, "{off} of {seen}");
}

#[test]
fn exponents_of_periodic_motion_are_known() {
    let horizon = Horizon { transient: 32, counted: 16, patience: Patience::Unsettled, longest: 400 };
    let state = [State::at_rest(-0.5, 0.0)];
    let at = |place| seen(&AnyOscillator::new(oscillator(place)), &state, horizon);
    let zeta = theory().damping_ratio();
    // Free motion decays like exp(-ζt).
    let [free] = at([0.1, 0.8])[..] else { panic!("it is alone") };
    assert_eq!((free.fate.kind, free.states, free.exponent.error), (MotionKind::NonImpacting, 1, 0.0));
    assert!((free.exponent.mean + zeta).abs() < 1e-9, "{free:?}");
    // Complex multipliers of an MPS have the product ε² exp(-2ζT).
    let place = [1.0, 0.9];
    let [struck] = at(place)[..] else { panic!("it is alone") };
    let period = oscillator(place).forcing_period();
    let known = libm::log(theory().coefficient_of_restitution()) / period - zeta;
    assert_eq!(struck.fate.loops(), Some(1));
    assert!((struck.exponent.mean - known).abs() < 1e-9, "{struck:?} {known}");
}
