//! The derivative of the map from impact to impact.

use grazing_model::orbit::Flight;
use grazing_model::{AnyMotion, AnyOscillator, ImpactOscillator, OnWall, State, flow_variable};
use nalgebra::{Matrix2, Vector2};

use super::strike::Strike;

/// The derivative of the map (y, z) ↦ (y′, z′) from an impact to the end of the flight that follows
/// it, each as its stop sees it.
///
/// A displaced orbit hits the wall earlier by δx/ẋ: a displacement in x at the time of the impact
/// is compensated by the time. At another stop, x and y are −D − x and −Ḋ − y there, of which D and Ḋ
/// change with the phase by Ḋ/ω and D̈/ω; the sum of the accelerations in both views is −D̈.
pub(super) fn from_impact_to_impact(
    oscillator: &AnyOscillator,
    Strike { impact, stop }: Strike,
    flight: &Flight<AnyMotion>,
) -> Matrix2<f64> {
    let frequency = oscillator.forcing_frequency().value;
    let impact = OnWall::new(impact[0], impact[1]);
    let other = oscillator.other_stop();
    let seen_from = |stop: usize| other.as_ref().filter(|_| stop == 1).unwrap_or(oscillator);
    let reset = seen_from(stop).reset::<1>(impact).derivative();
    let jacobian = match stop {
        0 => oscillator.flow_along::<1>(&flight.motion, flight.from, flight.duration).jacobian,
        _ => {
            let from = State { position: 0.0, ..oscillator.across(flight.from) };
            seen_from(stop).flow::<1>(from, flight.duration).jacobian
        }
    };
    let column = |variable: usize| jacobian.column(variable).into_owned();
    let (mut by_velocity, mut by_phase) = (column(flow_variable::VELOCITY), column(flow_variable::PHASE));
    let mut by_time = column(flow_variable::DURATION);
    if flight.stop != stop {
        let phase = flight.from.phase + frequency * flight.duration;
        let hits = Strike::of(flight).map_or(f64::NAN, |strike| strike.impact[0]);
        let pushed = seen_from(flight.stop).acceleration(State::on_wall(hits, phase));
        let rates = [by_time[0] + hits, by_time[1] + pushed].map(|sum| -sum / frequency);
        by_phase = -by_phase - Vector2::from(rates);
        by_time = Vector2::new(hits, pushed);
        by_velocity = -by_velocity;
    }
    let on_wall = |by: Vector2<f64>, phase: f64| {
        let late = -by[0] / by_time[0];
        Vector2::new(by[1] + by_time[1] * late, phase + frequency * late)
    };
    Matrix2::from_columns(&[on_wall(by_velocity, 0.0), on_wall(by_phase, 1.0)]) * reset
}
