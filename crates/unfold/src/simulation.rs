//! The behaviour of the hybrid system, simulated from event to event.

use core::f64::consts::TAU;

use grazing_continuation::flights::flight_time;
use grazing_continuation::mps::{Unknowns, unknown};
use grazing_model::orbit::{FlightEnd, Orbit};
use grazing_model::{ImpactOscillator, OnWall, State};
use nalgebra::{Matrix2, Vector2};

use crate::tolerances::BETWEEN_RETURNS;

/// The outcome of an impact that may belong to an MPS.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReturnOutcome {
    /// The next impact comes after p forcing periods, and is the same one: an MPS of the hybrid
    /// system.
    Returns,
    /// The impact velocity is not positive: no orbit of the hybrid system begins like this.
    NoImpact,
    /// The wall is reached before p forcing periods are over: the solution is virtual.
    MeetsTheWall,
    /// There is no impact when it is due, or another one.
    GoesElsewhere,
    /// The other of two stops is hit first.
    HitsTheOtherStop,
}

/// An impact (y, z) that may belong to an MPS.
#[derive(Clone, Copy, Debug)]
pub struct Suspect<'a, O> {
    /// The oscillator.
    pub oscillator: &'a O,
    /// The number of loops p.
    pub loops: u32,
    /// Impact velocity y.
    pub velocity: f64,
    /// Impact phase z.
    pub phase: f64,
}

/// Displacements are this fraction of the scale on which the motion changes.
const PART: f64 = 3e-4;

/// Number of times that a perturbed orbit is followed through p forcing periods before its fate
/// counts as undecided.
pub const MOST_RETURNS: usize = 5_000;

impl<'a, O: ImpactOscillator> Suspect<'a, O> {
    /// The impact of a point (y, z, μ, η).
    pub fn of(oscillator: &'a O, loops: u32, point: &Unknowns) -> Self {
        Self { oscillator, loops, velocity: point[unknown::VELOCITY], phase: point[unknown::PHASE] }
    }

    /// Time from recoil to impact of an MPS: p forcing periods minus the duration of the impact.
    fn flight(&self) -> f64 {
        let reset = self.oscillator.reset::<1>(OnWall::new(self.velocity, self.phase)).value;
        flight_time(self.oscillator, self.loops, self.phase, reset[1])
    }

    /// Follows the orbit to its next impact.
    pub fn follow(&self) -> ReturnOutcome {
        if self.velocity.is_nan() || self.velocity <= 0.0 {
            return ReturnOutcome::NoImpact;
        }
        let due = self.flight();
        let from = State::on_wall(self.velocity, self.phase);
        let mut orbit = Orbit::new(self.oscillator, from, 1.5 * due, 2);
        // The smallest possible difference is of the size of the impact: its velocity, and the time
        // in which this vanishes.
        let stop = self.velocity / self.oscillator.acceleration(from).abs();
        match orbit.next().map(|flight| (flight.duration, flight.end, flight.stop)) {
            Some((_, FlightEnd::Impact(_), 1)) => ReturnOutcome::HitsTheOtherStop,
            Some((time, FlightEnd::Impact(impact), _)) => {
                if time < due - BETWEEN_RETURNS * stop {
                    ReturnOutcome::MeetsTheWall
                } else if time <= due + BETWEEN_RETURNS * stop
                    && (impact.velocity - self.velocity).abs() <= BETWEEN_RETURNS * self.velocity
                {
                    ReturnOutcome::Returns
                } else {
                    ReturnOutcome::GoesElsewhere
                }
            }
            _ => ReturnOutcome::GoesElsewhere,
        }
    }

    /// The displacement of the next impact from (y, z), if the orbit begins at (y, z) + `by` and
    /// the impact comes when it is due, up to a quarter of a forcing period.
    ///
    /// In (y, z) the map from impact to impact is smooth.
    fn displaced(&self, by: Vector2<f64>) -> Option<Vector2<f64>> {
        let (velocity, phase) = (self.velocity + by[0], self.phase + by[1]);
        let recoil = self.oscillator.reset::<1>(OnWall::new(velocity, phase)).value;
        let period = self.oscillator.forcing_period();
        let due = flight_time(self.oscillator, self.loops, phase, recoil[1]);
        let from = State::on_wall(velocity, phase);
        let flight = Orbit::new(self.oscillator, from, due + 0.25 * period, 2).next()?;
        let (FlightEnd::Impact(impact), 0) = (flight.end, flight.stop) else { return None };
        let late = flight.duration - due;
        (late > -0.25 * period)
            .then(|| Vector2::new(impact.velocity - self.velocity, by[1] + late * TAU / period))
    }

    /// Whether an orbit displaced by a small fraction of y² is farther away at the next impact, or
    /// has it at another time.
    ///
    /// y² is the scale on which orbits beside an MPS far from resonance miss the wall.
    pub fn repels_at_once(&self) -> bool {
        let size = PART * self.velocity * self.velocity;
        let grows = |by: Vector2<f64>| self.displaced(by * size).is_none_or(|next| next.norm() > size);
        grows(Vector2::x()) || grows(Vector2::y())
    }

    /// Trace and determinant of the derivative of the map from impact to impact, by central
    /// differences with a small fraction of y; `None` if an orbit does not return when it is due.
    ///
    /// y is the scale on which this map varies near a resonance.
    pub fn multipliers(&self) -> Option<[f64; 2]> {
        let size = PART * self.velocity;
        let column = |direction: Vector2<f64>| {
            let ahead = self.displaced(direction * size)?;
            Some((ahead - self.displaced(direction * -size)?) / (2.0 * size))
        };
        let derivative = Matrix2::from_columns(&[column(Vector2::x())?, column(Vector2::y())?]);
        Some([derivative.trace(), derivative.determinant()])
    }

    /// Whether an orbit that is displaced by a small fraction of y comes ten times nearer in the
    /// long run (yes), or gets as far as y/3 away or does not return when it is due (no). `None` if
    /// neither has happened after many returns.
    ///
    /// For MPSs near a resonance. Beside a fold a displacement can grow considerably before it
    /// shrinks.
    pub fn attracts(&self) -> Option<bool> {
        let size = PART * self.velocity;
        let mut displacement = Vector2::new(0.6, -0.8) * size;
        for _ in 0..MOST_RETURNS {
            match self.displaced(displacement) {
                Some(next) if next.norm() < 0.1 * size => return Some(true),
                Some(next) if next.norm() < self.velocity / 3.0 => displacement = next,
                _ => return Some(false),
            }
        }
        None
    }

    /// Whether motion that begins beside the impact goes elsewhere; `None` as for
    /// [`attracts`](Self::attracts).
    pub fn leaves(&self) -> Option<bool> {
        self.attracts().map(|attracts| !attracts)
    }
}
