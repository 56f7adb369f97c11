//! Cascades of the limit map, compared with its own orbits and those of the system.

use grazing_continuation::cascade::{Cascade, CascadeEnd};
use grazing_continuation::doubled::DoubledEquations;
use grazing_continuation::mps::unknown;
use grazing_continuation::resonance::LocatedResonance;
use grazing_model::orbit::{FlightEnd, Orbit};
use grazing_model::{ImpactOscillator, State};
use grazing_theorems::limit_map::LimitImpact;
use grazing_theorems::{LimitMap, Side};

use crate::specimens::{DUFFING, EPSILON, ZETA, assert_vanishes, duffing, located};

/// The parameters half-way between the first four onsets, with the number of impacts there.
fn between(onsets: &[f64]) -> impl Iterator<Item = (f64, usize)> {
    onsets.windows(2).zip([2, 4, 8]).map(|(pair, impacts)| (0.5 * (pair[0] + pair[1]), impacts))
}

/// The orbit with two impacts at a parameter, as a start for orbits that others begin from.
fn start(map: &LimitMap, parameter: f64) -> (f64, LimitImpact) {
    let gap = (4.0 * (parameter - map.period_doubling()[1]) / map.bend_of_doubled()).sqrt();
    let [mut first, _] = map.doubled_impacts(gap);
    first.phase *= 1.0001;
    (gap, first)
}

/// The number of impacts after which the last of these velocities recur, to a part in ten thousand.
fn period(velocities: &[f64]) -> Option<usize> {
    let last = &velocities[velocities.len() - 64..];
    (1..=32).find(|&count| (0..64 - count).all(|i| (last[i + count] / last[i] - 1.0).abs() < 1e-4))
}

#[test]
fn orbits_of_the_map_double_where_a_cascade_says_so() {
    let mut seen = 0;
    for (loops, sigma, epsilon) in
        [(1, -0.83, 0.9), (1, -0.4, 0.9), (1, -0.6, 0.2), (2, -0.73, 0.9), (3, -0.57, 0.9), (2, -0.8, 0.6)]
    {
        let map = LimitMap::of_linear_oscillator(loops, sigma, epsilon).unwrap();
        let Cascade { onsets, stop } = Cascade::of(&map, 4);
        assert_eq!((onsets.len(), stop), (4, CascadeEnd::Enough), "{sigma} {epsilon}");
        for (parameter, impacts) in between(&onsets) {
            let (_, mut here) = start(&map, parameter);
            let next = |_| {
                here = map.step(Side::Positive, parameter, here).expect("it stays");
                here.velocity
            };
            let velocities: Vec<f64> = (0..20_000).map(next).collect();
            assert_eq!(period(&velocities), Some(impacts), "{sigma} {epsilon} {parameter}");
            seen += 1;
        }
    }
    assert_eq!(seen, 18);
}

#[test]
fn a_cascade_says_why_it_stops() {
    for (loops, sigma, begun, why) in [
        (1, 0.8, 0, CascadeEnd::Subcritical),
        (1, -0.15, 0, CascadeEnd::Subcritical),
        (1, -0.22, 1, CascadeEnd::Subcritical),
        (2, -0.22, 1, CascadeEnd::Grazing),
        (2, -0.44, 2, CascadeEnd::Grazing),
        (2, -0.475, 3, CascadeEnd::Grazing),
    ] {
        let map = LimitMap::of_linear_oscillator(loops, sigma, 0.9).unwrap();
        let Cascade { onsets, stop } = Cascade::of(&map, 4);
        assert_eq!((onsets.len(), stop), (begun, why), "{loops} {sigma}");
        let Some(&last) = onsets.get(1) else { continue };
        // Orbits continue to the parameter at which the last ones leave the map, and leave it
        // there.
        let leaves = |parameter: f64| {
            let (_, mut here) = start(&map, parameter);
            (0..20_000).any(|_| match map.step(Side::Positive, parameter, here) {
                Ok(next) => {
                    here = next;
                    false
                }
                Err(_) => true,
            })
        };
        assert!(!leaves(1.0001 * last) && leaves(0.9 * last), "{sigma}");
    }
}

/// The simulated velocities of impacts that follow each other p periods apart.
fn simulated<O: ImpactOscillator>(
    resonance: &LocatedResonance<O>,
    size: f64,
    parameter: f64,
    impacts: usize,
) -> Vec<f64> {
    let point = resonance.resonant_point();
    let (map, scale) = (point.limit_map(), point.limit_scale());
    let eta = size / (scale.velocity * map.period_doubling()[0]);
    let from = resonance.near(eta, parameter, start(&map, parameter).1).unwrap();
    let oscillator = resonance.equations().oscillator_at(&from);
    let horizon = f64::from(resonance.loops()) * oscillator.forcing_period();
    let from = State::on_wall(from[unknown::VELOCITY], from[unknown::PHASE]);
    let flights = Orbit::new(&oscillator, from, 2.0 * impacts as f64 * horizon, usize::MAX);
    let mut velocities = Vec::new();
    for flight in flights.take(impacts) {
        let (FlightEnd::Impact(state) | FlightEnd::TimeIsUp(state)) = flight.end;
        assert!((flight.duration / horizon - 1.0).abs() < 0.1);
        velocities.push(state.velocity);
    }
    velocities
}

/// μ/η² at which computed orbits with two impacts double their period, in units of the map.
fn second_doubling<O: ImpactOscillator>(resonance: &LocatedResonance<O>, size: f64) -> Option<f64> {
    let point = resonance.resonant_point();
    let (map, scale) = (point.limit_map(), point.limit_scale());
    let eta = size / (scale.velocity * map.period_doubling()[0]);
    let found = DoubledEquations::new(resonance.equations()).flip(resonance, eta)?;
    let place = resonance.near(eta, 0.0, map.fixed_point(0.0).0).unwrap();
    Some((found[unknown::PRIMARY] - place[unknown::PRIMARY]) / (scale.parameter * eta * eta))
}

fn assert_the_system_does_as_the_map<O: ImpactOscillator>(resonance: &LocatedResonance<O>, size: f64) {
    let map = resonance.resonant_point().limit_map();
    let Cascade { onsets, .. } = Cascade::of(&map, 4);
    for (parameter, impacts) in between(&onsets) {
        let velocities = simulated(resonance, size, parameter, 1500);
        assert_eq!(period(&velocities), Some(impacts), "p = {}, {parameter}", resonance.loops());
    }
    // Digits are lost in proportion to 1/y².
    assert_vanishes(3.0, 1e-13, |size| Some(size * size * (second_doubling(resonance, size)? - onsets[1])));
}

#[test]
fn near_resonances_the_system_doubles_as_the_map() {
    let theory = grazing_theorems::LinearOscillator::new(ZETA, EPSILON).unwrap();
    for (loops, n) in [(1, 3), (2, 1), (3, 1)] {
        assert_the_system_does_as_the_map(&located(&theory.resonance(loops, n).unwrap()), 1e-4);
    }
    let (loops, near) = DUFFING[1];
    assert_the_system_does_as_the_map(&duffing(loops, near), 1e-4);
}

/// Checks that from each simulated impact the map's visits lead to the next one, after the same
/// number of periods.
fn assert_motion_that_misses_is_the_map_s<O: ImpactOscillator>(resonance: &LocatedResonance<O>) {
    let point = resonance.resonant_point();
    let (map, scale) = (point.limit_map(), point.limit_scale());
    let [velocity, doubling] = map.period_doubling();
    let (side, parameter) = (Side::of(velocity), 0.5 * doubling);
    let eta = 1e-5 / (scale.velocity * velocity);
    let (fixed, _) = map.fixed_point(velocity);
    let from = resonance.near(eta, parameter, fixed).unwrap();
    let oscillator = resonance.equations().oscillator_at(&from);
    let grazing_phase = from[unknown::PHASE] - scale.impact(eta, fixed)[1];
    let mut state = State::on_wall(from[unknown::VELOCITY], from[unknown::PHASE]);
    let period = oscillator.forcing_period();
    let mut missed = 0;
    for flight in Orbit::new(&oscillator, state, 4e3 * period, usize::MAX).take(200) {
        let FlightEnd::Impact(next) = flight.end else { break };
        let phase = libm::remainder(state.phase - grazing_phase, core::f64::consts::TAU);
        let from = scale.limit(eta, [state.velocity, phase]);
        let mut visit = [from.velocity * from.velocity, from.phase + from.velocity];
        let periods = libm::round(flight.duration / period) as u32;
        for number in 1..=periods {
            visit = map.next_visit(side, parameter, point.grazing.map.a.m11, visit);
            assert_eq!(visit[0] > 0.0, number == periods, "{visit:?}");
        }
        let simulated = next.velocity / (scale.velocity * eta);
        assert!((visit[0] - simulated * simulated).abs() < 1e-3 * (1.0 + visit[0]), "{visit:?} {simulated}");
        missed += u32::from(periods > 1);
        state = next;
    }
    assert!(missed > 20, "{missed}");
}

#[test]
fn motion_that_misses_the_wall_comes_back_as_in_the_map() {
    let theory = grazing_theorems::LinearOscillator::new(ZETA, EPSILON).unwrap();
    for n in [3, 4, 5] {
        assert_motion_that_misses_is_the_map_s(&located(&theory.resonance(1, n).unwrap()));
    }
    let (loops, near) = DUFFING[0];
    assert_motion_that_misses_is_the_map_s(&duffing(loops, near));
}

/// The largest number of impacts, a power of two, after which followed motion recurs before it
/// departs.
fn followed(map: &LimitMap) -> usize {
    let [velocity, doubling] = map.period_doubling();
    let (mut here, _) = map.fixed_point(velocity);
    here.velocity *= 1.001;
    let mut most = 1;
    for step in 1..4000 {
        let parameter = doubling * (1.0 - 2.5e-4 * f64::from(step));
        let mut velocities = Vec::new();
        for _ in 0..1500 {
            match map.step(Side::Positive, parameter, here) {
                Ok(next) => here = next,
                Err(_) => return most,
            }
            velocities.push(here.velocity);
        }
        most = most.max(period(&velocities).filter(|count| count.is_power_of_two()).unwrap_or(1));
    }
    panic!("it never departs");
}

#[test]
fn followed_motion_doubles_as_often_as_the_atlas_says() {
    let mut seen = [0; 5];
    for (loops, epsilon, place) in [1, 2].into_iter().flat_map(|loops| {
        [0.4, 0.6, 0.9].into_iter().flat_map(move |epsilon| (4..19).map(move |place| (loops, epsilon, place)))
    }) {
        let sigma = -0.05 * f64::from(place);
        let begun = [-0.015, 0.0, 0.015].map(|aside| {
            let map = LimitMap::of_linear_oscillator(loops, sigma + aside, epsilon).unwrap();
            Cascade::of(&map, 4).onsets.len()
        });
        // More and more orbits begin towards −1.
        assert!(begun[0] >= begun[1] && begun[1] >= begun[2], "{sigma} {epsilon}: {begun:?}");
        if begun[0] != begun[2] || begun[1] == 0 {
            continue;
        }
        let map = LimitMap::of_linear_oscillator(loops, sigma, epsilon).unwrap();
        let most = followed(&map);
        // After a subcritical doubling motion may jump to other orbits that persist; 16 impacts may
        // exist for less than a step.
        let as_said = match (loops, begun[1]) {
            (1, 1) => most >= 2,
            (_, 4) => most >= 8,
            (_, begun) => most == 1 << begun,
        };
        assert!(as_said, "{loops} {sigma} {epsilon}: {most}");
        seen[begun[1]] += 1;
    }
    assert!(seen[1] >= 10 && seen[2] >= 5 && seen[4] >= 30, "{seen:?}");
}

#[test]
fn motion_of_one_loop_stays_near_the_resonance() {
    let theory = grazing_theorems::LinearOscillator::new(ZETA, EPSILON).unwrap();
    for (n, part) in [(2, 0.9), (3, 0.5), (3, -0.03), (4, 0.9), (5, 0.5), (5, -0.03)] {
        let resonance = located(&theory.resonance(1, n).unwrap());
        let point = resonance.resonant_point();
        let (map, scale) = (point.limit_map(), point.limit_scale());
        let [velocity, doubling] = map.period_doubling();
        let (mut fixed, _) = map.fixed_point(velocity);
        fixed.velocity *= 1.01;
        // Impacts in a period, in the limit map and in the system.
        let mut visit = [fixed.velocity * fixed.velocity, fixed.phase + fixed.velocity];
        let next = |_| {
            visit = map.next_visit(Side::Positive, part * doubling, point.grazing.map.a.m11, visit);
            visit[0] > 0.0
        };
        let hits: Vec<bool> = (0..20_000).map(next).collect();
        let eta = 1e-5 / (scale.velocity * velocity);
        let from = resonance.near(eta, part * doubling, fixed).unwrap();
        let oscillator = resonance.equations().oscillator_at(&from);
        let from = State::on_wall(from[unknown::VELOCITY], from[unknown::PHASE]);
        let times = Orbit::new(&oscillator, from, 1e4 * oscillator.forcing_period(), usize::MAX).skip(2000);
        let times: Vec<f64> = times.map(|flight| flight.duration / oscillator.forcing_period()).collect();
        let share = hits[4000..].iter().filter(|hit| **hit).count() as f64 / 16_000.0;
        let simulated = times.len() as f64 / times.iter().sum::<f64>();
        assert!(share > 0.2 && (simulated / share - 1.0).abs() < 0.1, "{n} {part}: {share} {simulated}");
        // Two impacts in three periods, one in two.
        let recurs = |periods: usize| hits[4000..].windows(periods + 1).all(|pair| pair[0] == pair[periods]);
        assert_eq!([recurs(2), recurs(3)], [n == 4, n == 2], "{n}");
    }
}
