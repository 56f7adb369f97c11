//! Orbits of the hybrid system eq:f with eq:resetLaw: motion and impacts.

use crate::motion::Motion;
use crate::oscillator::ImpactOscillator;
use crate::phase::turned;
use crate::state::{OnWall, State};
use crate::tolerances::CHATTER_VELOCITY;

/// A flight between two events of an orbit.
#[derive(Clone, Debug)]
pub struct Flight<M> {
    /// Time at which the flight begins, counted from the start of the orbit; impacts may take time
    /// as well.
    pub start: f64,
    /// State in which the flight begins, its phase reduced to [0, 2π).
    pub from: State,
    /// The motion, with time counted from the start of the flight.
    pub motion: M,
    /// Length of the flight.
    pub duration: f64,
    /// How the flight ends.
    pub end: FlightEnd,
}

/// How a flight ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FlightEnd {
    /// An impact: the state on the incoming set, just before the reset law acts.
    Impact(State),
    /// The orbit was followed for the whole requested time.
    TimeIsUp(State),
}

/// How an orbit ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum OrbitEnd {
    /// Followed for the whole time, ending in this state.
    TimeIsUp(State),
    /// The object is pressed against the wall (y = 0 and ẍ ≥ 0 at x = 0) and stays there until the
    /// force turns.
    Sticking {
        /// Time at which it sticks.
        time: f64,
        /// Phase at which it sticks.
        phase: f64,
    },
    /// Infinitely many impacts accumulate: impact velocities fell below the resolution while ẍ > 0
    /// at the wall, so that they go on falling geometrically to a sticking state.
    Chattering {
        /// Time of the last impact that was resolved.
        time: f64,
        /// Phase at the last impact that was resolved.
        phase: f64,
        /// Number of impacts up to that time.
        impacts: usize,
    },
    /// The number of impacts reached its limit.
    TooManyImpacts {
        /// Time of the last impact.
        time: f64,
        /// Number of impacts.
        impacts: usize,
    },
}

/// An orbit with impacts as an iterator over its flights.
///
/// After the iterator has ended, [`end`](Self::end) gives the reason. Phases are reduced modulo 2π
/// at every impact (eq:z).
#[derive(Clone, Debug)]
pub struct Orbit<'a, O> {
    oscillator: &'a O,
    state: State,
    time: f64,
    horizon: f64,
    impacts: usize,
    impact_limit: usize,
    end: Option<OrbitEnd>,
}

impl<'a, O: ImpactOscillator> Orbit<'a, O> {
    /// The orbit from a state with x ≤ 0, to be followed for the time `horizon` or until
    /// `impact_limit` impacts.
    ///
    /// A start on the incoming set (x = 0, y > 0) begins with its impact.
    pub fn new(oscillator: &'a O, from: State, horizon: f64, impact_limit: usize) -> Self {
        let mut orbit = Self {
            oscillator,
            state: wrapped(from),
            time: 0.0,
            horizon,
            impacts: 0,
            impact_limit,
            end: None,
        };
        if from.position >= 0.0 && from.velocity > 0.0 {
            orbit.reset();
        } else {
            orbit.check_contact();
        }
        orbit
    }

    /// Why the orbit ended; `None` while it goes on.
    pub fn end(&self) -> Option<OrbitEnd> {
        self.end
    }

    /// Number of impacts so far.
    pub fn impacts(&self) -> usize {
        self.impacts
    }

    /// Follows the orbit to its end.
    pub fn finish(mut self) -> OrbitEnd {
        for _ in self.by_ref() {}
        self.end.unwrap_or(OrbitEnd::TimeIsUp(self.state))
    }

    fn reset(&mut self) {
        self.impacts += 1;
        let impact_velocity = self.state.velocity;
        let recoil: State =
            self.oscillator.reset::<1>(OnWall::new(impact_velocity, self.state.phase)).image().into();
        self.time += (recoil.phase - self.state.phase) / self.oscillator.forcing_frequency().value;
        self.state = wrapped(recoil);
        let pressed = || self.oscillator.acceleration(State::on_wall(0.0, self.state.phase)) > 0.0;
        if impact_velocity < CHATTER_VELOCITY && pressed() {
            self.end = Some(OrbitEnd::Chattering {
                time: self.time,
                phase: self.state.phase,
                impacts: self.impacts,
            });
        } else if self.impacts >= self.impact_limit {
            self.end = Some(OrbitEnd::TooManyImpacts { time: self.time, impacts: self.impacts });
        }
        self.check_contact();
    }

    fn check_contact(&mut self) {
        let resting = self.state.position >= 0.0 && self.state.velocity == 0.0;
        if self.end.is_none() && resting && self.oscillator.acceleration(self.state) >= 0.0 {
            self.end = Some(OrbitEnd::Sticking { time: self.time, phase: self.state.phase });
        }
    }
}

impl<O: ImpactOscillator> Iterator for Orbit<'_, O> {
    type Item = Flight<O::Motion>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.end.is_some() {
            return None;
        }
        let (start, from) = (self.time, self.state);
        let left = self.horizon - start;
        if left < 0.0 {
            // The time was up during an impact.
            self.end = Some(OrbitEnd::TimeIsUp(from));
            return None;
        }
        let motion = self.oscillator.motion(from);
        let crossing = motion.first_crossing(left);
        let duration = crossing.map_or(left, |crossing| crossing.time);
        let phase = from.phase + self.oscillator.forcing_frequency().value * duration;
        self.time += duration;
        let end = if let Some(crossing) = crossing {
            let impact = State::on_wall(crossing.velocity, phase);
            self.state = impact;
            self.reset();
            FlightEnd::Impact(impact)
        } else {
            let last = motion.at(duration).state(phase);
            self.state = last;
            self.end = Some(OrbitEnd::TimeIsUp(last));
            FlightEnd::TimeIsUp(last)
        };
        Some(Flight { start, from, motion, duration, end })
    }
}

/// The state with its phase reduced to [0, 2π).
fn wrapped(state: State) -> State {
    let phase = turned(state.phase);
    State { phase, ..state }
}
