//! An orbit that is followed for a long time, and what it comes to.

use grazing_model::motion::Motion;
use grazing_model::orbit::{Flight, FlightEnd, Orbit, OrbitEnd};
use grazing_model::phase::turned;
use grazing_model::{AnyMotion, AnyOscillator, ImpactOscillator, State};
use nalgebra::Vector2;

use super::recurrence::Recurrence;
use crate::tolerances::BETWEEN_ORBITS;

/// What motion comes to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MotionKind {
    /// Motion that does not reach the wall.
    NonImpacting,
    /// Motion with impacts that comes again.
    Periodic,
    /// Motion with impacts that does not, as far as it was followed.
    Aperiodic,
    /// It comes to rest at the wall for a while, or for good.
    Resting,
    /// It cannot be followed.
    Escaping,
}

impl MotionKind {
    /// In a word.
    pub const fn name(self) -> &'static str {
        match self {
            Self::NonImpacting => "non-impacting",
            Self::Periodic => "periodic",
            Self::Aperiodic => "aperiodic",
            Self::Resting => "resting",
            Self::Escaping => "escaping",
        }
    }
}

/// What an orbit comes to, in numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fate {
    /// What it is.
    pub kind: MotionKind,
    /// The forcing periods after which it comes again, if it does.
    pub periods: Option<u32>,
    /// Impacts in a forcing period, on average.
    pub impacts: f64,
    /// How sure that is: whether its impacts have come again, or still drift.
    pub recurrence: Recurrence,
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

/// What orbits are followed on for where they have not settled in time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Patience {
    /// Those that drift.
    Drifting,
    /// All whose impacts do not come again.
    Aperiodic,
}

/// For how long an orbit is followed, in forcing periods.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Horizon {
    /// Those before motion counts; more where it has not settled by then.
    pub transient: u32,
    /// Those in which it counts.
    pub counted: u32,
    /// What is followed on.
    pub patience: Patience,
}

/// No motion is waited for longer than about so many forcing periods.
pub const LONGEST_TRANSIENT: u32 = 2_000;
/// No orbit has more than a few impacts a period; sticking and chattering end it by themselves.
const MOST_IMPACTS: usize = 1_000_000;
/// Forcing periods of motion without impacts after which it is looked for again.
pub(super) const MOST_PERIODS: u32 = 16;
/// Flights that are shown of an orbit that does not come again.
const SHOWN: usize = 40;

/// An orbit after its transient, times being counted from the end of that.
pub struct LongOrbit {
    /// What it comes to.
    pub fate: Fate,
    /// The flights that begin after the transient.
    pub flights: Vec<Flight<AnyMotion>>,
    /// The impacts (y, z) at which these end.
    pub impacts: Vec<Vector2<f64>>,
    /// The flight in which the transient ends, as long as none follows it.
    last: Option<Flight<AnyMotion>>,
    /// Its state when time is up, unless it came to rest at the wall or cannot be followed.
    end: Option<State>,
}

impl LongOrbit {
    /// The orbit from a state, with a longer transient where it has not settled, as far as that is
    /// waited for.
    pub fn follow(oscillator: &AnyOscillator, mut from: State, horizon: Horizon) -> Self {
        let Horizon { mut transient, counted, patience } = horizon;
        let mut passed = 0;
        loop {
            let orbit = Self::after_transient(oscillator, from, [transient, counted]);
            passed += transient + counted;
            let unsettled = !orbit.flights.is_empty()
                && match orbit.fate.recurrence {
                    Recurrence::Cycle(_) => false,
                    Recurrence::Drift => true,
                    Recurrence::None => patience == Patience::Aperiodic,
                };
            match orbit.end {
                Some(end) if unsettled && passed < LONGEST_TRANSIENT => (from, transient) = (end, passed),
                _ => return orbit,
            }
        }
    }

    fn after_transient(oscillator: &AnyOscillator, from: State, [transient, counted]: [u32; 2]) -> Self {
        let period = oscillator.forcing_period();
        let transient = f64::from(transient) * period;
        let horizon = transient + f64::from(counted) * period;
        let mut orbit = Orbit::new(oscillator, from, horizon, MOST_IMPACTS);
        let (mut last, mut flights) = (None, Vec::new());
        for flight in orbit.by_ref() {
            let flight = Flight { start: flight.start - transient, ..flight };
            if flight.start >= 0.0 { flights.push(flight) } else { last = Some(flight) }
        }
        let last = last.filter(|_| flights.is_empty());
        let impacts: Vec<Vector2<f64>> = flights.iter().filter_map(impact).collect();
        let recurrence = Recurrence::of(&impacts);
        let rate = impacts.len() as f64 / f64::from(counted);
        let fate = |kind, periods, impacts| Fate { kind, periods, impacts, recurrence };
        let (fate, end) = match orbit.end() {
            Some(OrbitEnd::TimeIsUp(end)) if !end.position.is_finite() => {
                (fate(MotionKind::Escaping, None, f64::NAN), None)
            }
            Some(OrbitEnd::TimeIsUp(end)) => {
                let fate = match recurrence {
                    Recurrence::Cycle(cycle) => {
                        let time = flights[cycle].start - flights[0].start;
                        let periods = libm::round(time / period).max(1.0);
                        fate(MotionKind::Periodic, Some(periods as u32), cycle as f64 / periods)
                    }
                    _ if impacts.is_empty() => {
                        let free = flights.last().or(last.as_ref());
                        let periods = free.and_then(|flight| free_periods(flight, period));
                        fate(MotionKind::NonImpacting, periods, 0.0)
                    }
                    _ => fate(MotionKind::Aperiodic, None, rate),
                };
                (fate, Some(end))
            }
            _ => (fate(MotionKind::Resting, None, rate), None),
        };
        Self { fate, flights, impacts, last, end }
    }

    /// The flight in which motion without impacts is when time is up.
    pub fn free(&self) -> Option<&Flight<AnyMotion>> {
        let free = self.flights.last().or(self.last.as_ref());
        free.filter(|_| self.fate.kind == MotionKind::NonImpacting)
    }

    /// The state at the end of the transient, where no impact follows.
    pub fn free_state(&self, oscillator: &AnyOscillator) -> Option<State> {
        let flight = self.last.as_ref().filter(|_| self.end.is_some())?;
        Some(state_at(oscillator, flight, -flight.start))
    }

    /// The state of motion without impacts when it has last passed phase zero.
    pub fn at_phase_zero(&self, oscillator: &AnyOscillator) -> Option<State> {
        let flight = self.free()?;
        let frequency = oscillator.forcing_frequency().value;
        // The last whole turn of the flight.
        let phase = flight.from.phase + frequency * flight.duration;
        let past = turned(phase) / frequency;
        Some(State { phase: 0.0, ..state_at(oscillator, flight, flight.duration - past) })
    }

    /// The flights of one cycle, or some of them where they do not come again.
    pub fn shown(&self) -> &[Flight<AnyMotion>] {
        let Fate { periods, impacts, .. } = self.fate;
        let cycle =
            periods.map_or(SHOWN, |periods| libm::round(impacts * f64::from(periods)).max(1.0) as usize);
        &self.flights[..cycle.min(self.flights.len())]
    }

    /// The state from which motion without impacts comes again, or some periods of it, and for how
    /// many it is followed.
    pub fn free_cycle(&self, oscillator: &AnyOscillator) -> Option<(State, f64)> {
        let flight = self.free()?;
        let periods = f64::from(self.fate.periods.unwrap_or(MOST_PERIODS));
        let period = oscillator.forcing_period();
        Some((state_at(oscillator, flight, flight.duration - periods * period), periods))
    }
}

/// The impact (y, z) at which a flight ends.
fn impact<M>(flight: &Flight<M>) -> Option<Vector2<f64>> {
    match flight.end {
        FlightEnd::Impact(impact) => Some(Vector2::new(impact.velocity, impact.phase)),
        FlightEnd::TimeIsUp(_) => None,
    }
}

/// The state at a time from the beginning of a flight.
pub(super) fn state_at(oscillator: &AnyOscillator, flight: &Flight<AnyMotion>, time: f64) -> State {
    let phase = flight.from.phase + oscillator.forcing_frequency().value * time;
    flight.motion.at(time).state(phase)
}

/// The forcing periods after which motion without impacts comes again, after the transient.
fn free_periods<M: Motion>(flight: &Flight<M>, period: f64) -> Option<u32> {
    let start = (-flight.start).max(0.0);
    let state = |time: f64| {
        let here = flight.motion.at(time);
        Vector2::new(here.position, here.velocity * period)
    };
    let first = state(start);
    (1..=MOST_PERIODS).find(|periods| {
        let time = start + f64::from(*periods) * period;
        time <= flight.duration && (state(time) - first).norm() < BETWEEN_ORBITS
    })
}
