//! Impacts of orbits, and when two of them are the same.

use grazing_model::maps::virtual_map;
use grazing_model::orbit::{Flight, FlightEnd};
use grazing_model::{AnyOscillator, ImpactOscillator, OnWall, State};
use nalgebra::Vector2;

/// An impact of an orbit, as the stop that it hits sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Strike {
    /// Velocity and phase (y, z).
    pub impact: Vector2<f64>,
    /// The stop: 0 for that at x = 0, 1 for the other, if there are two.
    pub stop: usize,
}

impl Strike {
    /// The impact at which a flight ends.
    pub(crate) fn of<M>(flight: &Flight<M>) -> Option<Self> {
        match flight.end {
            FlightEnd::Impact(at) => {
                Some(Self { impact: Vector2::new(at.velocity, at.phase), stop: flight.stop })
            }
            FlightEnd::TimeIsUp(_) => None,
        }
    }

    /// The extremum x beyond its stop that motion would reach without it, as the first stop sees it, and its
    /// phase; of two stops, the other has a minimum.
    pub(crate) fn virtual_top(&self, oscillator: &AnyOscillator) -> Option<[f64; 2]> {
        let other = oscillator.other_stop().filter(|_| self.stop == 1);
        let impact = OnWall::new(self.impact[0], self.impact[1]);
        let top = virtual_map::<_, 1>(other.as_ref().unwrap_or(oscillator), impact, None).ok()?.jet.image();
        let x = other.map_or(top.position, |other| other.across(top.into()).position);
        Some([x, top.phase])
    }

    /// The state at the impact, as its stop sees it.
    pub(super) fn state(&self) -> State {
        State::on_wall(self.impact[0], self.impact[1])
    }
}
