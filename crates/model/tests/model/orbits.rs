//! Orbits with impacts: no event is stepped over, and every orbit ends for a named reason.

use grazing_model::motion::{BoundedMotion, Enclosure, Motion};
use grazing_model::orbit::{FlightEnd, Orbit, OrbitEnd};
use grazing_model::smooth::Integrated;
use grazing_model::{ImpactOscillator, LinearOscillator, State};
use proptest::prelude::*;

use crate::models::Lasting;

const OMEGA: f64 = 0.855;

fn oscillator(amplitude: f64) -> LinearOscillator {
    LinearOscillator::new(0.02, 0.9, amplitude, OMEGA).unwrap()
}

fn grazing_amplitude() -> f64 {
    libm::hypot(1.0 - OMEGA * OMEGA, 0.04 * OMEGA)
}

#[test]
fn impacts_at_low_velocity_are_not_stepped_over() {
    // The periodic solution raised above grazing by μ crosses the wall at a velocity of about
    // ω√(2μ/𝒜_graz) and is back before the wall a moment later: at μ = 1e-12 that is 2e-6 and 5e-6
    // time units.
    for mu in [1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12] {
        let oscillator = oscillator(grazing_amplitude() + mu);
        let motion = oscillator.motion(oscillator.non_impacting_solution(3.0));
        let crossing = motion.first_crossing(20.0).expect("the solution crosses the wall");
        let impact = motion.at(crossing.time);
        let expected = OMEGA * (2.0 * mu / grazing_amplitude()).sqrt();
        // Leading order in √μ; at 1e-12 rounding of x (1e-16) moves the crossing by 1e-16/v.
        assert!((impact.velocity / expected - 1.0).abs() < 0.1, "{mu}: {} {expected}", impact.velocity);
        assert!(impact.position.abs() < 1e-15, "{}", impact.position);
    }
}

#[test]
fn a_graze_from_below_is_no_impact() {
    let oscillator = oscillator(grazing_amplitude() - 1e-12);
    let motion = oscillator.motion(oscillator.non_impacting_solution(3.0));
    assert_eq!(motion.first_crossing(200.0), None);
}

#[test]
fn maxima_of_the_non_impacting_solution_are_one_a_period() {
    let oscillator = oscillator(0.2);
    let motion = oscillator.motion(oscillator.non_impacting_solution(1.0));
    let period = oscillator.forcing_period();
    let maxima = motion.local_maxima(12.0 * period);
    assert_eq!(maxima.len(), 12);
    for pair in maxima.windows(2) {
        // Event times are exact to rounding of the time, which is up to 90.
        assert!((pair[1].time - pair[0].time - period).abs() < 1e-12);
    }
    let height = 0.2 / grazing_amplitude() - 1.0;
    let highest = motion.highest_maximum(12.0 * period).unwrap();
    assert!((highest.position - height).abs() < 1e-14);
}

/// The first crossing in samples far finer than any motion here; the exact search must find it as
/// well.
fn sampled_crossing(motion: &impl Motion, horizon: f64) -> Option<f64> {
    (1..=200_000).map(|k| horizon * f64::from(k) / 200_000.0).find(|time| motion.at(*time).position > 0.0)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, failure_persistence: None, rng_seed: proptest::test_runner::RngSeed::Fixed(7), ..ProptestConfig::default() })]

    #[test]
    fn first_crossing_is_the_first(
        y in -1.5..-0.001_f64, z in 0.0..6.3_f64, amplitude in 0.1..1.4_f64, omega in 0.35..1.1_f64,
    ) {
        let oscillator = LinearOscillator::new(0.02, 0.9, amplitude, omega).unwrap();
        let motion = oscillator.motion(State::on_wall(y, z));
        let crossing = motion.first_crossing(30.0);
        let exact = crossing.map(|crossing| crossing.time);
        let sampled = sampled_crossing(&motion, 30.0);
        match (exact, sampled) {
            // The sample comes at most one spacing after the crossing.
            (Some(exact), Some(sampled)) => prop_assert!(exact <= sampled && sampled - exact < 30.0 / 200_000.0 + 1e-9,
                "{exact} {sampled}"),
            // A crossing shorter than the spacing of the samples.
            (Some(exact), None) => prop_assert!(motion.at(exact).velocity < 1e-3),
            (None, Some(sampled)) => prop_assert!(false, "missed a crossing at {sampled}"),
            (None, None) => {}
        }
        if let Some(crossing) = crossing {
            // Rounding of times up to 30 at velocities up to 2.
            let there = motion.at(crossing.time);
            prop_assert!(there.position.abs() < 1e-13);
            prop_assert!((there.velocity - crossing.velocity).abs() < 1e-12);
        }
    }

    #[test]
    fn highest_maximum_is_the_highest_of_all(
        y in -1.5..-0.001_f64, z in 0.0..6.3_f64, amplitude in 0.1..1.4_f64, omega in 0.35..1.1_f64,
    ) {
        let oscillator = LinearOscillator::new(0.02, 0.9, amplitude, omega).unwrap();
        let motion = oscillator.motion(State::on_wall(y, z));
        let all = motion.local_maxima(40.0);
        let highest = motion.highest_maximum(40.0);
        let expected = all.iter().map(|maximum| maximum.position).fold(f64::NEG_INFINITY, f64::max);
        prop_assert_eq!(highest.map_or(f64::NEG_INFINITY, |maximum| maximum.position), expected);
        for maximum in &all {
            let here = motion.at(maximum.time);
            // Rounding of times up to 40 at accelerations up to 3.
            prop_assert!(here.velocity.abs() < 3e-13 && here.acceleration <= 0.0);
        }
    }

    #[test]
    fn rest_is_found_in_both_directions_of_time(
        y in 0.01..1.0_f64, z in -0.8..0.8_f64, forwards in proptest::bool::ANY,
    ) {
        let oscillator = oscillator(0.3);
        let motion = oscillator.motion(State::on_wall(if forwards { y } else { -y }, z));
        let time = motion.first_rest(forwards, 10.0).unwrap();
        prop_assert_eq!(time > 0.0, forwards);
        prop_assert!(motion.at(time).velocity.abs() < 1e-14);
        prop_assert!(motion.at(time).position > 0.0);
    }
}

#[test]
fn bounds_outside_of_an_enclosure_are_infinite() {
    let oscillator = oscillator(0.3);
    let motion = oscillator.motion(State::at_rest(-0.4, 1.0));
    let enclosure = motion.enclose(-5.0);
    assert_eq!(enclosure.bounds_between(-2.0, -5.0), enclosure.bounds());
    assert_eq!(enclosure.bounds_between(-2.0, -5.1).snap, f64::INFINITY);
    assert_eq!(motion.enclose(5.0).bounds_between(0.0, -0.1).snap, f64::INFINITY);
}

#[test]
fn impacts_that_last_take_their_time() {
    let oscillator = Integrated::new(Lasting, [0.6, 0.8]);
    let horizon = 60.0 * oscillator.forcing_period();
    let flights: Vec<_> = Orbit::new(&oscillator, State::at_rest(-0.4, 1.0), horizon, 10_000).collect();
    assert!(flights.len() > 20);
    for pair in flights.windows(2) {
        let FlightEnd::Impact(impact) = pair[0].end else { panic!("an impact is between flights") };
        let contact = pair[1].start - pair[0].start - pair[0].duration;
        assert!((contact - Lasting::PSI * impact.velocity / 0.8).abs() < 1e-12 * horizon);
    }
    // Time and phase advance together.
    for flight in &flights {
        let turns = (1.0 + 0.8 * flight.start - flight.from.phase) / core::f64::consts::TAU;
        assert!((turns - libm::rint(turns)).abs() < 1e-11);
    }
}

#[test]
fn impacts_obey_the_reset_law_and_flights_join() {
    let oscillator = oscillator(0.3);
    let horizon = 300.0 * oscillator.forcing_period();
    let flights: Vec<_> = Orbit::new(&oscillator, State::at_rest(-0.4, 1.0), horizon, 10_000).collect();
    assert!(flights.len() > 50, "an orbit at this amplitude impacts every other period or so");
    for pair in flights.windows(2) {
        let FlightEnd::Impact(impact) = pair[0].end else {
            panic!("only the last flight ends without an impact")
        };
        assert_eq!(pair[1].from.velocity, -0.9 * impact.velocity);
        assert_eq!(pair[1].from.position, 0.0);
        assert!((pair[1].start - pair[0].start - pair[0].duration).abs() < 1e-12 * horizon);
        // Phases are reduced modulo 2π at impacts.
        let turns = (impact.phase - pair[1].from.phase) / core::f64::consts::TAU;
        assert!(
            (turns - libm::rint(turns)).abs() < 1e-14
                && (0.0..core::f64::consts::TAU).contains(&pair[1].from.phase)
        );
    }
}

#[test]
fn an_orbit_without_impacts_ends_on_time_in_the_non_impacting_solution() {
    let oscillator = oscillator(0.2);
    let horizon = 300.0 * oscillator.forcing_period();
    let OrbitEnd::TimeIsUp(state) = Orbit::new(&oscillator, State::at_rest(-0.7, 0.0), horizon, 10).finish()
    else {
        panic!("nothing else can happen here")
    };
    // The transient has decayed by e^{−0.02 · 2207}, to 1e-19.
    let periodic = oscillator.non_impacting_solution(state.phase);
    assert!((state.position - periodic.position).abs() < 1e-12);
    assert!((state.velocity - periodic.velocity).abs() < 1e-12);
}

#[test]
fn a_block_at_rest_on_the_wall_stays_if_pressed_and_elastic_impacts_do_not_accumulate() {
    let oscillator = LinearOscillator::new(0.02, 0.5, 3.0, 0.05).unwrap();
    let OrbitEnd::Resting { rest, held } =
        Orbit::new(&oscillator, State::on_wall(0.0, 0.1), 10.0, 10).finish()
    else {
        panic!("the force presses up to phase arccos 1/3, at time 22.6")
    };
    assert_eq!(
        (rest.start, rest.phase, rest.duration, rest.accumulated, held),
        (0.0, 0.1, 10.0, false, false)
    );
    // Without damping of impacts nothing accumulates, and the limit ends the orbit.
    let elastic = LinearOscillator::new(0.02, 1.0, 3.0, 0.05).unwrap();
    let end = Orbit::new(&elastic, State::on_wall(1e-3, 0.0), 1e3, 500).finish();
    assert!(matches!(end, OrbitEnd::TooManyImpacts { impacts: 500, .. }), "{end:?}");
}
