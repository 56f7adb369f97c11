//! An orbit that is followed for a long time, and its long-term behaviour.

use core::f64::consts::TAU;
use std::collections::VecDeque;

use grazing_model::orbit::{Flight, FlightEnd, Orbit, OrbitEnd};
use grazing_model::phase::turned;
use grazing_model::smooth::Purpose;
use grazing_model::{AnyMotion, AnyOscillator, ImpactOscillator, State};
use nalgebra::Vector2;

use super::cycle::{Cycle, MOST_IMPACTS, MOST_PERIODS, cycle_lengths, state_at};

grazing_results::words! {
    /// The kind of long-term behaviour.
    #[derive(PartialOrd, Ord)]
    MotionKind {
        /// A periodic solution that does not reach the wall.
        NonImpacting = "non-impacting",
        /// A periodic solution with impacts.
        Periodic = "periodic",
        /// Motion that has not settled on a cycle within the time for which it was followed.
        Unsettled = "unsettled",
        /// Motion that has not settled, with a positive Lyapunov exponent that has converged.
        Chaotic = "chaotic",
        /// Motion that comes to rest at the wall, where the force holds it for a whole period, and so
        /// for good.
        Resting = "resting",
        /// Motion that comes to the wall, mostly by impacts that accumulate, where the force holds it
        /// for a part of the period; it is not followed further.
        Accumulating = "accumulating",
        /// Motion that cannot be followed.
        Escaping = "escaping",
    }
}

/// The long-term behaviour of an orbit in numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fate {
    /// The kind of behaviour.
    pub kind: MotionKind,
    /// The number of forcing periods after which the motion recurs, if it does.
    pub periods: Option<u32>,
    /// Impacts in a forcing period, on average.
    pub impacts: f64,
    /// The number of forcing periods for which it was followed.
    pub followed: u32,
}

impl Fate {
    /// The number of loops p of a solution with one impact in p forcing periods; 0 without impacts.
    pub fn loops(&self) -> Option<u32> {
        match self.kind {
            MotionKind::NonImpacting if self.periods == Some(1) => Some(0),
            // A whole number of impacts, counted over a whole number of periods.
            MotionKind::Periodic => {
                self.periods.filter(|periods| (self.impacts * f64::from(*periods) - 1.0).abs() < 0.5)
            }
            _ => None,
        }
    }
}

/// The orbits that are followed further where they have not settled in time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Patience {
    /// Orbits that nearly recur.
    Drifting,
    /// All orbits that have not settled.
    Unsettled,
}

/// The time for which an orbit is followed, in forcing periods.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Horizon {
    /// The number of periods before motion counts; more where it has not settled by then.
    pub transient: u32,
    /// The number of periods in which motion counts.
    pub counted: u32,
    /// The orbits that are followed further.
    pub patience: Patience,
    /// The approximate total number of periods after which no motion is followed further.
    pub longest: u32,
}

impl Horizon {
    /// A horizon at which drifting motion is followed further, up to the usual length.
    pub const fn drifting(transient: u32, counted: u32) -> Self {
        Self { transient, counted, patience: Patience::Drifting, longest: LONGEST_TRANSIENT }
    }
}

/// The default limit on the time for which motion is followed, in forcing periods.
pub const LONGEST_TRANSIENT: u32 = 2_000;
/// Number of flights that are shown of an orbit that does not recur.
const SHOWN: usize = 40;
/// Number of forcing periods that are shown of motion that is not followed further.
const SHOWN_PERIODS: f64 = 4.0;

/// An orbit after its transient, with times counted from the end of the transient; on its cycle, if
/// it has settled.
pub struct LongOrbit {
    /// The long-term behaviour of the orbit.
    pub fate: Fate,
    /// The cycle on which the orbit has settled.
    pub cycle: Option<Cycle>,
    /// The flights that begin after the transient.
    pub flights: Vec<Flight<AnyMotion>>,
    /// The impacts (y, z) at which these end.
    pub impacts: Vec<Vector2<f64>>,
    /// The last flights that begin in the transient.
    before: VecDeque<Flight<AnyMotion>>,
    /// The state at the end of the time, unless the orbit came to rest at the wall, is not followed
    /// further or cannot be followed.
    pub(crate) end: Option<State>,
}

impl LongOrbit {
    /// The orbit from a state, with a longer transient where it has not settled, within the limits
    /// of the horizon.
    pub fn follow(oscillator: &AnyOscillator, from: State, horizon: Horizon) -> Self {
        Purpose::Simulation.during(|| Self::followed(oscillator, from, horizon))
    }

    fn followed(oscillator: &AnyOscillator, mut from: State, horizon: Horizon) -> Self {
        let Horizon { mut transient, counted, patience, longest } = horizon;
        let mut followed = 0;
        loop {
            let mut orbit = Self::after_transient(oscillator, from, [transient, counted]);
            followed += transient + counted;
            orbit.fate.followed = followed;
            let Some(end) = orbit.end else { return orbit };
            if let Some(cycle) = orbit.settled(oscillator) {
                return Self::on_cycle(oscillator, cycle, [counted, followed]);
            }
            let drifts = || orbit.impacts.is_empty() || cycle_lengths(&orbit.impacts).next().is_some();
            if followed >= longest || patience == Patience::Drifting && !drifts() {
                return orbit;
            }
            (from, transient) = (end, followed);
        }
    }

    fn settled(&self, oscillator: &AnyOscillator) -> Option<Cycle> {
        match self.free_flight() {
            Some(flight) => Cycle::without_impacts(oscillator, flight),
            None => Cycle::with_impacts(oscillator, &self.flights, &self.impacts),
        }
    }

    fn on_cycle(oscillator: &AnyOscillator, cycle: Cycle, [counted, followed]: [u32; 2]) -> Self {
        let orbit = Self::after_transient(oscillator, cycle.from, [0, counted]);
        let fate = Fate {
            kind: if cycle.impacts == 0 { MotionKind::NonImpacting } else { MotionKind::Periodic },
            periods: Some(cycle.periods),
            impacts: cycle.impacts as f64 / f64::from(cycle.periods),
            followed,
        };
        Self { fate, cycle: Some(cycle), ..orbit }
    }

    pub(super) fn after_transient(
        oscillator: &AnyOscillator,
        from: State,
        [transient, counted]: [u32; 2],
    ) -> Self {
        let period = oscillator.forcing_period();
        let transient = f64::from(transient) * period;
        let horizon = transient + f64::from(counted) * period;
        let mut orbit = Orbit::new(oscillator, from, horizon, MOST_IMPACTS);
        let (mut before, mut flights) = (VecDeque::new(), Vec::new());
        let shown = SHOWN_PERIODS * period;
        for flight in orbit.by_ref() {
            let flight = Flight { start: flight.start - transient, ..flight };
            if flight.start >= 0.0 {
                flights.push(flight);
                continue;
            }
            let old = |known: &&Flight<_>| known.start + known.duration < flight.start - shown;
            while before.front().filter(old).is_some() {
                before.pop_front();
            }
            before.push_back(flight);
        }
        let impacts: Vec<Vector2<f64>> = flights.iter().filter_map(impact).collect();
        let (kind, end) = match orbit.end() {
            Some(OrbitEnd::TimeIsUp(end)) if end.position.is_finite() => (MotionKind::Unsettled, Some(end)),
            Some(OrbitEnd::TimeIsUp(_)) => (MotionKind::Escaping, None),
            _ if is_held_at_wall(oscillator) => (MotionKind::Resting, None),
            _ => (MotionKind::Accumulating, None),
        };
        let rate = impacts.len() as f64 / f64::from(counted);
        let fate = Fate { kind, periods: None, impacts: rate, followed: 0 };
        Self { fate, cycle: None, flights, impacts, before, end }
    }

    /// The flight of motion that has no impact after the transient.
    pub(super) fn free_flight(&self) -> Option<&Flight<AnyMotion>> {
        let free = self.flights.last().or(self.before.back());
        free.filter(|_| self.impacts.is_empty() && self.end.is_some())
    }

    /// The last flights, transient or not, of some periods: what is seen of motion that is not followed
    /// further.
    pub(crate) fn before_the_end(&self, oscillator: &AnyOscillator) -> Vec<&Flight<AnyMotion>> {
        let all = || self.before.iter().chain(&self.flights);
        let end = |flight: &Flight<_>| flight.start + flight.duration;
        let from = all().last().map_or(0.0, end) - SHOWN_PERIODS * oscillator.forcing_period();
        all().filter(|flight| end(flight) >= from).collect()
    }

    /// The state at the end of the transient, where no impact follows.
    pub fn free_state(&self, oscillator: &AnyOscillator) -> Option<State> {
        let flight = self.free_flight()?;
        Some(state_at(oscillator, flight, (-flight.start).max(0.0)))
    }

    /// A state on the attractor, from which it can be followed elsewhere; `None` if the orbit has
    /// come to rest, is not followed further or cannot be followed.
    pub fn state(&self, oscillator: &AnyOscillator) -> Option<State> {
        self.end?;
        self.at_phase_zero(oscillator).or(self.flights.last().map(|flight| flight.from))
    }

    /// The state of motion without impacts at its last passage of phase zero.
    pub fn at_phase_zero(&self, oscillator: &AnyOscillator) -> Option<State> {
        let flight = self.free_flight()?;
        let frequency = oscillator.forcing_frequency().value;
        // The last whole turn of the flight.
        let phase = flight.from.phase + frequency * flight.duration;
        let past = turned(phase) / frequency;
        Some(State { phase: 0.0, ..state_at(oscillator, flight, flight.duration - past) })
    }

    /// The flights of one cycle, or some flights of an orbit that does not recur.
    pub fn shown(&self) -> &[Flight<AnyMotion>] {
        let Fate { periods, impacts, .. } = self.fate;
        let cycle =
            periods.map_or(SHOWN, |periods| libm::round(impacts * f64::from(periods)).max(1.0) as usize);
        &self.flights[..cycle.min(self.flights.len())]
    }

    /// The state from which motion without impacts recurs, or covers some periods if it does not,
    /// and the number of periods.
    pub fn free_cycle(&self, oscillator: &AnyOscillator) -> Option<(State, f64)> {
        let flight = self.free_flight()?;
        let periods = f64::from(self.fate.periods.unwrap_or(MOST_PERIODS));
        let period = oscillator.forcing_period();
        Some((state_at(oscillator, flight, (flight.duration - periods * period).max(0.0)), periods))
    }
}

/// Number of phases between which the least force at the wall is bracketed, and of steps by which it
/// is then narrowed down.
const PHASES: u32 = 512;
const NARROWINGS: u32 = 40;

/// Whether the force presses against the wall what rests there, at every phase: such motion stays at
/// rest.
pub fn is_held_at_wall(oscillator: &AnyOscillator) -> bool {
    let force = |phase: f64| oscillator.acceleration(State::on_wall(0.0, phase));
    let phase = |k: u32| TAU * f64::from(k) / f64::from(PHASES);
    let forces: Vec<f64> = (0..PHASES).map(|k| force(phase(k))).collect();
    (0..PHASES).all(|k| {
        let here = forces[k as usize];
        let beside = [PHASES - 1, 1].map(|step| forces[((k + step) % PHASES) as usize]);
        if here <= 0.0 || here.is_nan() || beside.iter().any(|other| *other < here) {
            return here > 0.0;
        }
        // A minimum lies between the phases beside this one.
        let (mut low, mut high) = (phase(k) - phase(1), phase(k) + phase(1));
        for _ in 0..NARROWINGS {
            let [first, second] = [(2.0 * low + high) / 3.0, (low + 2.0 * high) / 3.0];
            if force(first) < force(second) { high = second } else { low = first }
        }
        force(0.5 * (low + high)) > 0.0
    })
}

/// The impact (y, z) at which a flight ends.
pub(crate) fn impact<M>(flight: &Flight<M>) -> Option<Vector2<f64>> {
    match flight.end {
        FlightEnd::Impact(impact) => Some(Vector2::new(impact.velocity, impact.phase)),
        FlightEnd::TimeIsUp(_) => None,
    }
}
