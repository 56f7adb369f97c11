//! An orbit that is followed for a long time, and its long-term behaviour.

use grazing_model::orbit::{Flight, FlightEnd, Orbit, OrbitEnd};
use grazing_model::phase::turned;
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
        /// Motion that comes to rest at the wall for a while, or for good.
        Resting = "resting",
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
    /// The flight in which the transient ends, as long as no flight follows it.
    last: Option<Flight<AnyMotion>>,
    /// The state at the end of the time, unless the orbit came to rest at the wall or cannot be
    /// followed.
    pub(super) end: Option<State>,
}

impl LongOrbit {
    /// The orbit from a state, with a longer transient where it has not settled, within the limits
    /// of the horizon.
    pub fn follow(oscillator: &AnyOscillator, mut from: State, horizon: Horizon) -> Self {
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
        let (mut last, mut flights) = (None, Vec::new());
        for flight in orbit.by_ref() {
            let flight = Flight { start: flight.start - transient, ..flight };
            if flight.start >= 0.0 { flights.push(flight) } else { last = Some(flight) }
        }
        let last = last.filter(|_| flights.is_empty());
        let impacts: Vec<Vector2<f64>> = flights.iter().filter_map(impact).collect();
        let (kind, end) = match orbit.end() {
            Some(OrbitEnd::TimeIsUp(end)) if end.position.is_finite() => (MotionKind::Unsettled, Some(end)),
            Some(OrbitEnd::TimeIsUp(_)) => (MotionKind::Escaping, None),
            _ => (MotionKind::Resting, None),
        };
        let rate = impacts.len() as f64 / f64::from(counted);
        let fate = Fate { kind, periods: None, impacts: rate, followed: 0 };
        Self { fate, cycle: None, flights, impacts, last, end }
    }

    /// The flight of motion that has no impact after the transient.
    pub(super) fn free_flight(&self) -> Option<&Flight<AnyMotion>> {
        let free = self.flights.last().or(self.last.as_ref());
        free.filter(|_| self.impacts.is_empty() && self.end.is_some())
    }

    /// The state at the end of the transient, where no impact follows.
    pub fn free_state(&self, oscillator: &AnyOscillator) -> Option<State> {
        let flight = self.free_flight()?;
        Some(state_at(oscillator, flight, (-flight.start).max(0.0)))
    }

    /// A state on the attractor, from which it can be followed elsewhere; `None` if the orbit has
    /// come to rest or cannot be followed.
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

/// The impact (y, z) at which a flight ends.
fn impact<M>(flight: &Flight<M>) -> Option<Vector2<f64>> {
    match flight.end {
        FlightEnd::Impact(impact) => Some(Vector2::new(impact.velocity, impact.phase)),
        FlightEnd::TimeIsUp(_) => None,
    }
}
