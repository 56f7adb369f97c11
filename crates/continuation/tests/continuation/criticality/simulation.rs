//! Orbits of the hybrid system beside period doublings.

use core::f64::consts::TAU;

use grazing_continuation::criticality::period_doubling;
use grazing_continuation::locate::{Condition, locate};
use grazing_continuation::mps::{EventTimes, unknown};
use grazing_continuation::resonance::ResonantGrazingPoint;
use grazing_model::orbit::{FlightEnd, Orbit};
use grazing_model::{ImpactOscillator, LinearOscillator, State};
use nalgebra::Vector2;

use super::specimens::{at_velocity, one_loop};
use crate::specimens::assert_within;

/// The next impact p periods after one of the hybrid system; `None` if the wall is met at another time.
fn next_impact<O: ImpactOscillator>(
    oscillator: &O,
    loops: u32,
    impact: Vector2<f64>,
) -> Option<Vector2<f64>> {
    let period = oscillator.forcing_period();
    let expected = f64::from(loops) * period;
    let start = State::on_wall(impact[0], impact[1]);
    let flight = Orbit::new(oscillator, start, expected + 0.5 * period, usize::MAX).next()?;
    let FlightEnd::Impact(next) = flight.end else { return None };
    let turns = libm::round((next.phase - impact[1]) / TAU);
    ((flight.duration - expected).abs() < 0.25 * period)
        .then(|| Vector2::new(next.velocity, next.phase - turns * TAU))
}

/// Half the distance between successive impacts after many, in units of what it is for the doubled orbit.
///
/// From shares of it; infinite where the loops are left. Parameters are those at which the doubled orbit has impacts X(±s) with
/// s a `part` of y.
fn simulated(
    resonance: &ResonantGrazingPoint<LinearOscillator>,
    y: f64,
    part: f64,
    impacts: usize,
    shares: [f64; 2],
) -> [f64; 2] {
    let flip = at_velocity(resonance, Condition::PERIOD_DOUBLING, y);
    let normal_form = period_doubling(resonance.equations(), &flip).unwrap();
    let s = part * y;
    let primary = flip[unknown::PRIMARY] - normal_form.coefficient * s * s / normal_form.multiplier_slopes[0];
    let conditions = [Condition::Primary(primary), Condition::Secondary(flip[unknown::SECONDARY])];
    let solution = locate(resonance.equations(), conditions, flip, &mut EventTimes::default()).unwrap();
    assert!(resonance.equations().solution(&solution).0.admissible());
    let oscillator = resonance.equations().oscillator_at(&solution);
    shares.map(|share| {
        let mut here = solution.fixed_rows::<2>(0) + normal_form.direction * (share * s);
        let mut apart = f64::NAN;
        for _ in 0..impacts {
            let Some(next) = next_impact(&oscillator, resonance.loops(), here) else { return f64::INFINITY };
            apart = 0.5 * (next - here).norm() / s;
            here = next;
        }
        apart
    })
}

#[test]
fn simulated_orbits_settle_on_the_orbit_that_a_supercritical_period_doubling_creates() {
    // From within and from without. Each impact takes 2c s² off, here 0.008; terms of higher order are (s/y)² = 0.0025.
    let ends = simulated(&one_loop(3), 0.05, 0.05, 2_000, [0.3, 1.6]);
    for end in ends {
        assert_within(end, 1.0, 0.01);
    }
}

#[test]
fn simulated_orbits_beside_a_subcritical_period_doubling_return_or_leave() {
    // The unstable doubled orbit lies between; c is small here, so that many impacts are needed.
    let [within, without] = simulated(&one_loop(4), 0.01, 0.3, 12_000, [0.8, 1.2]);
    assert!(within < 0.4, "{within}");
    assert!(without > 2.4, "{without}");
}
