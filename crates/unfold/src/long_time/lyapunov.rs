//! The largest Lyapunov exponent of an orbit.

use grazing_model::orbit::FlightEnd;
use grazing_model::{AnyOscillator, ImpactOscillator, OnWall, flow_variable};
use nalgebra::{Matrix2, Vector2};

use super::orbit::{LongOrbit, MOST_PERIODS, MotionKind, state_at};

impl LongOrbit {
    /// The mean rate at which a small displacement grows, by the derivatives of the maps from
    /// impact to impact, or of the flow; of the dimension of a reciprocal time, and not a number
    /// where motion rests or cannot be followed.
    ///
    /// A displaced orbit hits the wall earlier by δx/ẋ, so that an impact is a map (δy, δz) ↦ (δy,
    /// δz) on the wall.
    pub fn lyapunov(&self, oscillator: &AnyOscillator) -> f64 {
        if matches!(self.fate.kind, MotionKind::Resting | MotionKind::Escaping) {
            return f64::NAN;
        }
        let frequency = oscillator.forcing_frequency().value;
        let period = oscillator.forcing_period();
        let mut displacement = Vector2::new(0.6, 0.8);
        let (mut growth, mut time) = (0.0, 0.0);
        let mut stretch = |derivative: Matrix2<f64>, duration: f64| {
            displacement = derivative * displacement;
            let size = displacement.norm();
            displacement /= size;
            growth += libm::log(size);
            time += duration;
        };
        if let Some(flight) = self.free() {
            for left in (1..=MOST_PERIODS).rev() {
                let time = flight.duration - f64::from(left) * period;
                let from = state_at(oscillator, flight, time);
                let jacobian = oscillator.flow::<1>(from, period).jacobian;
                stretch(jacobian.fixed_columns::<2>(flow_variable::POSITION).into_owned(), period);
            }
            return growth / time;
        }
        for pair in self.flights.windows(2) {
            let (FlightEnd::Impact(impact), FlightEnd::Impact(_)) = (pair[0].end, pair[1].end) else {
                continue;
            };
            let reset = oscillator.reset::<1>(OnWall::new(impact.velocity, impact.phase)).derivative();
            let flight = &pair[1];
            let jacobian = oscillator.flow_along::<1>(&flight.motion, flight.from, flight.duration).jacobian;
            let column = |variable: usize| jacobian.column(variable).into_owned();
            let (by_velocity, by_phase) = (column(flow_variable::VELOCITY), column(flow_variable::PHASE));
            let by_time = column(flow_variable::DURATION);
            // What x is off by at the time of the impact is made up for by the time.
            let on_wall = |by: Vector2<f64>, phase: f64| {
                let late = -by[0] / by_time[0];
                Vector2::new(by[1] + by_time[1] * late, phase + frequency * late)
            };
            let flown = Matrix2::from_columns(&[on_wall(by_velocity, 0.0), on_wall(by_phase, 1.0)]);
            stretch(flown * reset, flight.duration);
        }
        growth / time
    }
}
