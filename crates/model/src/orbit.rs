//! Orbits of the hybrid system eq:f with eq:resetLaw: motion and impacts.

use crate::motion::{Crossing, Motion};
use crate::oscillator::ImpactOscillator;
use crate::phase::turned;
use crate::rest::{Rest, accumulation, release};
use crate::state::{OnWall, State};
use crate::tolerances::{CLEAR_OF_WALL, NOT_CLEAR_YET, SLOW_RECOIL};

/// A flight between two events of an orbit, and the rest at the wall from which it was released.
#[derive(Clone, Debug)]
pub struct Flight<M> {
    /// Time at which the flight begins, counted from the start of the orbit; impacts may take time
    /// as well.
    pub start: f64,
    /// State in which the flight begins, its phase reduced to [0, 2π); with two stops seen from the
    /// first, as the motion is.
    pub from: State,
    /// The motion, with time counted from the start of the flight.
    pub motion: M,
    /// Length of the flight.
    pub duration: f64,
    /// How the flight ends.
    pub end: FlightEnd,
    /// The stop that is hit at its end, if there are two: 0 for that at x = 0, 1 for the other.
    pub stop: usize,
    /// The rest at the wall that ends where the flight begins.
    pub rest: Option<Rest>,
}

/// How a flight ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FlightEnd {
    /// An impact: the state on the incoming set, just before the reset law acts, as its stop sees it.
    Impact(State),
    /// The orbit was followed for the whole requested time.
    TimeIsUp(State),
}

/// How an orbit ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum OrbitEnd {
    /// Followed for the whole time, ending in this state.
    TimeIsUp(State),
    /// At rest at the wall at the end of the time.
    Resting {
        /// The rest up to then.
        rest: Rest,
        /// Whether the force holds it there for a whole period, and so for good.
        held: bool,
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
/// Where the force presses, impacts accumulate: their velocities fall in a geometric sequence, and
/// infinitely many take a finite time. Those that are too slow to be told apart are left out; their
/// total duration is summed up, with an error of about 10⁻¹¹ for motion of order one. Then the
/// motion rests at the wall until the force turns, and the next flight begins from there. So does
/// motion that begins at rest at the wall, and recoil without velocity.
///
/// An oscillator with two stops is seen from each in turn: of the crossings of x = 0 in both views, that
/// which comes first is the impact.
///
/// After the iterator has ended, [`end`](Self::end) gives the reason. Phases are reduced modulo 2π
/// at every impact (eq:z).
#[derive(Clone, Debug)]
pub struct Orbit<'a, O> {
    oscillator: &'a O,
    /// The oscillator seen from its other stop.
    other: Option<O>,
    /// The stop from which the state is seen: that of the last impact.
    stop: usize,
    state: State,
    time: f64,
    horizon: f64,
    impacts: usize,
    impact_limit: usize,
    /// The rest that ends where the next flight begins.
    rest: Option<Rest>,
    end: Option<OrbitEnd>,
}

impl<'a, O: ImpactOscillator> Orbit<'a, O> {
    /// The orbit from a state with x ≤ 0, to be followed for the time `horizon` or until
    /// `impact_limit` impacts.
    ///
    /// A start on the incoming set (x = 0, y > 0) begins with its impact.
    pub fn new(oscillator: &'a O, from: State, horizon: f64, impact_limit: usize) -> Self {
        Self::from_stop(oscillator, (0, from), horizon, impact_limit)
    }

    /// The orbit from a state as a stop sees it, which is at one of the stops or between them.
    pub fn from_stop(
        oscillator: &'a O,
        (mut stop, mut from): (usize, State),
        horizon: f64,
        impact_limit: usize,
    ) -> Self {
        let other = oscillator.other_stop();
        if other.is_some() && from.position < 0.0 {
            let seen = if stop == 0 { oscillator } else { other.as_ref().unwrap_or(oscillator) }.across(from);
            (stop, from) = if seen.position >= 0.0 { (1 - stop, seen) } else { (stop, from) };
        }
        let mut orbit = Self {
            oscillator,
            other,
            stop,
            state: wrapped(from),
            time: 0.0,
            horizon,
            impacts: 0,
            impact_limit,
            rest: None,
            end: None,
        };
        if from.position >= 0.0 && from.velocity > 0.0 {
            orbit.reset();
        } else {
            orbit.come_to_rest(false);
        }
        orbit
    }

    /// The oscillator seen from a stop.
    fn seen_from(&self, stop: usize) -> &O {
        if stop == 0 { self.oscillator } else { self.other.as_ref().unwrap_or(self.oscillator) }
    }

    /// The state as the first stop sees it.
    fn seen_from_first(&self, state: State) -> State {
        if self.stop == 0 { state } else { self.seen_from(self.stop).across(state) }
    }

    /// Why the orbit ended; `None` while it goes on.
    pub fn end(&self) -> Option<OrbitEnd> {
        self.end
    }

    /// Number of impacts so far, without those that are left out where impacts accumulate.
    pub fn impacts(&self) -> usize {
        self.impacts
    }

    /// Follows the orbit to its end.
    pub fn finish(mut self) -> OrbitEnd {
        for _ in self.by_ref() {}
        self.end.unwrap_or(OrbitEnd::TimeIsUp(self.seen_from_first(self.state)))
    }

    fn reset(&mut self) {
        self.impacts += 1;
        let impact = OnWall::new(self.state.velocity, self.state.phase);
        let recoil: State = self.seen_from(self.stop).reset::<1>(impact).image().into();
        self.time += (recoil.phase - self.state.phase) / self.oscillator.forcing_frequency().value;
        self.state = wrapped(recoil);
        if self.impacts >= self.impact_limit {
            self.end = Some(OrbitEnd::TooManyImpacts { time: self.time, impacts: self.impacts });
            return;
        }
        let slow = -SLOW_RECOIL < self.state.velocity && self.state.velocity < 0.0;
        let accumulated = slow.then(|| accumulation(self.seen_from(self.stop), self.state)).flatten();
        if let Some(accumulated) = &accumulated {
            self.time += accumulated.duration;
            self.state = wrapped(accumulated.state);
        }
        self.come_to_rest(accumulated.is_some());
    }

    /// Waits at the wall while the force presses, if the motion is at rest there.
    fn come_to_rest(&mut self, accumulated: bool) {
        let State { position, velocity, phase } = self.state;
        let rests = position >= 0.0 && velocity == 0.0 && self.time < self.horizon;
        let oscillator = self.seen_from(self.stop);
        if !rests || oscillator.acceleration(self.state) < 0.0 {
            return;
        }
        let released = release(oscillator, phase);
        let frequency = self.oscillator.forcing_frequency().value;
        let duration = released.map_or(f64::INFINITY, |released| (released - phase) / frequency);
        let left = self.horizon - self.time;
        let (start, stop) = (self.time, self.stop);
        let rest = Rest { start, phase, duration: duration.min(left), accumulated, stop };
        match released {
            Some(released) if duration < left => {
                self.time += duration;
                self.state = wrapped(State::on_wall(0.0, released));
                self.rest = Some(rest);
            }
            _ => self.end = Some(OrbitEnd::Resting { rest, held: released.is_none() }),
        }
    }

    /// The first crossing of a motion that leaves the wall from rest: from where it is clear of the wall,
    /// since x is nothing but rounding before.
    fn return_to_wall(&self, motion: &O::Motion, horizon: f64) -> Option<Crossing> {
        let mut clear = NOT_CLEAR_YET;
        while clear < horizon {
            let there = motion.at(clear);
            if there.position < -CLEAR_OF_WALL {
                let phase = self.state.phase + self.oscillator.forcing_frequency().value * clear;
                let crossing =
                    self.seen_from(self.stop).motion(there.state(phase)).first_crossing(horizon - clear)?;
                return Some(Crossing { time: clear + crossing.time, ..crossing });
            }
            if there.position > CLEAR_OF_WALL {
                return motion.first_crossing(horizon);
            }
            clear *= 2.0;
        }
        None
    }
}

impl<O: ImpactOscillator> Iterator for Orbit<'_, O> {
    type Item = Flight<O::Motion>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.end.is_some() {
            return None;
        }
        let (start, state, rest) = (self.time, self.state, self.rest.take());
        let from = self.seen_from_first(state);
        let left = self.horizon - start;
        if left < 0.0 {
            // The time was up during an impact.
            self.end = Some(OrbitEnd::TimeIsUp(from));
            return None;
        }
        let here = self.seen_from(self.stop);
        let mut motion = here.motion(state);
        let leaves = state.position >= 0.0 && state.velocity == 0.0;
        let mut crossing =
            if leaves { self.return_to_wall(&motion, left) } else { motion.first_crossing(left) };
        let mut stop = self.stop;
        if self.other.is_some() {
            let across = self.seen_from(1 - stop).motion(here.across(state));
            let until = crossing.map_or(left, |crossing| crossing.time);
            let met = across.first_crossing(until);
            motion = if stop == 0 { motion } else { across };
            (stop, crossing) = met.map_or((stop, crossing), |met| (1 - stop, Some(met)));
        }
        let duration = crossing.map_or(left, |crossing| crossing.time);
        let phase = from.phase + self.oscillator.forcing_frequency().value * duration;
        self.time += duration;
        let end = if let Some(crossing) = crossing {
            let impact = State::on_wall(crossing.velocity, phase);
            (self.state, self.stop) = (impact, stop);
            self.reset();
            FlightEnd::Impact(impact)
        } else {
            let last = motion.at(duration).state(phase);
            (self.state, self.stop) = (last, 0);
            self.end = Some(OrbitEnd::TimeIsUp(last));
            FlightEnd::TimeIsUp(last)
        };
        Some(Flight { start, from, motion, duration, end, stop, rest })
    }
}

/// The state with its phase reduced to [0, 2π).
fn wrapped(state: State) -> State {
    let phase = turned(state.phase);
    State { phase, ..state }
}
