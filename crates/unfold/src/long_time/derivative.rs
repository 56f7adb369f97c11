//! The derivative of the map from impact to impact.

use grazing_model::orbit::Flight;
use grazing_model::{AnyMotion, AnyOscillator, ImpactOscillator, OnWall, State, flow_variable};
use nalgebra::{Matrix2, Vector2};

/// The derivative of the map (y, z) ↦ (y′, z′) from an impact to the end of the flight that follows
/// it.
///
/// A displaced orbit hits the wall earlier by δx/ẋ: a displacement in x at the time of the impact
/// is compensated by the time.
pub(super) fn from_impact_to_impact(
    oscillator: &AnyOscillator,
    impact: State,
    flight: &Flight<AnyMotion>,
) -> Matrix2<f64> {
    let frequency = oscillator.forcing_frequency().value;
    let reset = oscillator.reset::<1>(OnWall::new(impact.velocity, impact.phase)).derivative();
    let jacobian = oscillator.flow_along::<1>(&flight.motion, flight.from, flight.duration).jacobian;
    let column = |variable: usize| jacobian.column(variable).into_owned();
    let (by_velocity, by_phase) = (column(flow_variable::VELOCITY), column(flow_variable::PHASE));
    let by_time = column(flow_variable::DURATION);
    let on_wall = |by: Vector2<f64>, phase: f64| {
        let late = -by[0] / by_time[0];
        Vector2::new(by[1] + by_time[1] * late, phase + frequency * late)
    };
    Matrix2::from_columns(&[on_wall(by_velocity, 0.0), on_wall(by_phase, 1.0)]) * reset
}
