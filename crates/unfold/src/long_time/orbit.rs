//! An orbit that is followed for a long time, and its long-term behaviour.

use grazing_model::orbit::{Flight, FlightEnd, Orbit, OrbitEnd};
use grazing_model::phase::turned;
use grazing_model::rest::Rest;
use grazing_model::smooth::Purpose;
use grazing_model::{AnyMotion, AnyOscillator, ImpactOscillator, State};

use super::cycle::{Cycle, MOST_IMPACTS, MOST_PERIODS, cycle_lengths, is_same_phase, state_at};
use super::strike::Strike;

grazing_results::words! {
    /// The kind of long-term behaviour.
    #[derive(PartialOrd, Ord)]
    MotionKind {
        /// A periodic solution that does not reach the wall.
        NonImpacting = "non-impacting",
        /// A periodic solution with impacts, with rests at the wall or without.
        Periodic = "periodic",
        /// Motion that has not settled on a cycle within the time for which it was followed.
        Unsettled = "unsettled",
        /// Motion that has not settled, with a positive Lyapunov exponent that has converged.
        Chaotic = "chaotic",
        /// Motion that comes to rest at the wall, where the force holds it for a whole period, and so
        /// for good.
        Resting = "resting",
        /// Motion that runs away, or cannot be followed.
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
    /// Impacts in a forcing period, on average; ∞ where they accumulate.
    pub impacts: f64,
    /// Those of them at the second of two stops, in a forcing period on average; NaN with one stop.
    pub second: f64,
    /// Rests at the wall in a forcing period, on average, that the force ends.
    pub rests: f64,
    /// The number of forcing periods for which it was followed.
    pub followed: u32,
}

impl Fate {
    /// The numbers of impacts and of loops p of a periodic solution, (0, 0) for one without impacts; `None`
    /// with rests, and for motion without impacts that recurs after several periods.
    pub fn numbers(&self) -> Option<(usize, u32)> {
        match self.kind {
            _ if self.rests > 0.0 => None,
            MotionKind::NonImpacting if self.periods == Some(1) => Some((0, 0)),
            // A whole number of impacts, counted over a whole number of periods.
            MotionKind::Periodic => {
                self.periods.map(|periods| (libm::round(self.impacts * f64::from(periods)) as usize, periods))
            }
            _ => None,
        }
    }

    /// The number of loops p of a solution with one impact in p forcing periods; 0 without impacts.
    pub fn loops(&self) -> Option<u32> {
        self.numbers().filter(|(impacts, _)| *impacts < 2).map(|(_, loops)| loops)
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

/// The phases at which the force has released an orbit from rest at a stop: from the first that recurs
/// on the motion recurs.
#[derive(Default)]
pub(super) struct Releases {
    /// Stops and phases.
    seen: Vec<(usize, f64)>,
    /// Whether motion from one release to the next amplifies rounding, so that nothing is known to recur.
    irregular: bool,
}

impl Releases {
    /// Adds the release of a flight, if it has one; the cycle, if it recurs.
    fn recur(
        &mut self,
        oscillator: &AnyOscillator,
        flight: &Flight<AnyMotion>,
        longest: f64,
    ) -> Option<Cycle> {
        let rest = flight.rest.filter(|_| !self.irregular)?;
        let release = (rest.stop, flight.from.phase);
        if !self.seen.iter().any(|other| other.0 == release.0 && is_same_phase(other.1, release.1)) {
            self.seen.push(release);
            return None;
        }
        let cycle = Cycle::through_rest(oscillator, release, longest);
        self.irregular = cycle.is_none();
        cycle
    }
}

/// An orbit after its transient, with times counted from the end of the transient; on its cycle, if
/// it has settled.
pub struct LongOrbit {
    /// The long-term behaviour of the orbit.
    pub fate: Fate,
    /// The cycle on which the orbit has settled.
    pub cycle: Option<Cycle>,
    /// The flights that begin after the transient.
    pub flights: Vec<Flight<AnyMotion>>,
    /// The impacts at which these end.
    pub impacts: Vec<Strike>,
    /// The rest at a stop with which it ends.
    pub(crate) at_rest: Option<Rest>,
    /// The last flight that begins in the transient.
    before: Option<Flight<AnyMotion>>,
    /// The state at the end of the time, unless the orbit came to rest at the wall for good or cannot be
    /// followed.
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
        let (mut followed, mut releases) = (0, Releases::default());
        loop {
            let mut orbit =
                Self::after_transient(oscillator, from, [transient, counted], Some(&mut releases));
            followed += transient + counted;
            orbit.fate.followed = followed;
            let Some(end) = orbit.end else { return orbit };
            if let Some(cycle) = orbit.cycle.or_else(|| orbit.settled(oscillator)) {
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

    pub(super) fn on_cycle(oscillator: &AnyOscillator, cycle: Cycle, [counted, followed]: [u32; 2]) -> Self {
        let from = (cycle.stop, cycle.from);
        let orbit = Self::from_stop(oscillator, from, [0, counted.max(cycle.periods)], None);
        let impacts = if cycle.accumulates { f64::INFINITY } else { cycle.impacts as f64 };
        let fate = Fate {
            kind: if cycle.impacts == 0 { MotionKind::NonImpacting } else { MotionKind::Periodic },
            periods: Some(cycle.periods),
            impacts: impacts / f64::from(cycle.periods),
            second: at_second(oscillator, &orbit.impacts[..cycle.impacts.min(orbit.impacts.len())])
                / f64::from(cycle.periods),
            rests: cycle.rests as f64 / f64::from(cycle.periods),
            followed,
        };
        Self { fate, cycle: Some(cycle), ..orbit }
    }

    /// The orbit from a state, up to a release that recurs, if these are watched: then its cycle is known.
    pub(super) fn after_transient(
        oscillator: &AnyOscillator,
        from: State,
        times: [u32; 2],
        releases: Option<&mut Releases>,
    ) -> Self {
        Self::from_stop(oscillator, (0, from), times, releases)
    }

    /// The same from a state as a stop sees it.
    fn from_stop(
        oscillator: &AnyOscillator,
        from: (usize, State),
        [transient, counted]: [u32; 2],
        mut releases: Option<&mut Releases>,
    ) -> Self {
        let period = oscillator.forcing_period();
        let transient = f64::from(transient) * period;
        let horizon = transient + f64::from(counted) * period;
        let mut orbit = Orbit::from_stop(oscillator, from, horizon, MOST_IMPACTS);
        let (mut before, mut flights) = (None, Vec::new());
        let (mut cycle, mut end) = (None, None);
        for flight in orbit.by_ref() {
            let flight = Flight { start: flight.start - transient, ..flight };
            cycle = releases.as_mut().and_then(|releases| releases.recur(oscillator, &flight, horizon));
            if cycle.is_some() {
                end = Some(OrbitEnd::TimeIsUp(flight.from));
                break;
            }
            if flight.start >= 0.0 { flights.push(flight) } else { before = Some(flight) }
        }
        let impacts: Vec<Strike> = flights.iter().filter_map(Strike::of).collect();
        let at_rest = match orbit.end() {
            Some(OrbitEnd::Resting { rest, .. }) => Some(rest),
            _ => None,
        };
        let (kind, end) = match end.or(orbit.end()) {
            Some(OrbitEnd::TimeIsUp(end)) if end.position.is_finite() => (MotionKind::Unsettled, Some(end)),
            Some(OrbitEnd::Resting { held: true, .. }) => (MotionKind::Resting, None),
            Some(OrbitEnd::Resting { rest, .. }) => {
                let turned = oscillator.forcing_frequency().value * rest.duration;
                let end = State::on_wall(0.0, rest.phase + turned);
                let other = oscillator.other_stop().filter(|_| rest.stop == 1);
                (MotionKind::Unsettled, Some(other.map_or(end, |other| other.across(end))))
            }
            _ => (MotionKind::Escaping, None),
        };
        let rests = || flights.iter().filter_map(|flight| flight.rest);
        let count = if rests().any(|rest| rest.accumulated) { f64::INFINITY } else { impacts.len() as f64 };
        let [impacts_in_one, rests_in_one] =
            [count, rests().count() as f64].map(|count| count / f64::from(counted));
        let second = at_second(oscillator, &impacts) / f64::from(counted);
        let (impacts_per_period, rests) = (impacts_in_one, rests_in_one);
        let fate = Fate { kind, periods: None, impacts: impacts_per_period, second, rests, followed: 0 };
        Self { fate, cycle, flights, impacts, before, end, at_rest }
    }

    /// The flight of motion that has no impact after the transient.
    pub(super) fn free_flight(&self) -> Option<&Flight<AnyMotion>> {
        let free = self.flights.last().or(self.before.as_ref());
        let on = |flight: &&Flight<_>| matches!(flight.end, FlightEnd::TimeIsUp(_)) && self.end.is_some();
        free.filter(|flight| self.impacts.is_empty() && on(flight))
    }

    /// The state at the end of the transient, where no impact follows.
    pub fn free_state(&self, oscillator: &AnyOscillator) -> Option<State> {
        let flight = self.free_flight()?;
        Some(state_at(oscillator, flight, (-flight.start).max(0.0)))
    }

    /// A state on the attractor, from which it can be followed elsewhere; `None` if the orbit has
    /// come to rest for good or cannot be followed.
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
        let cycle = self.cycle.map_or(SHOWN, |cycle| cycle.impacts.max(1));
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

/// The number of impacts at the second of two stops; NaN if there is only one.
fn at_second(oscillator: &AnyOscillator, impacts: &[Strike]) -> f64 {
    let count = impacts.iter().filter(|strike| strike.stop == 1).count() as f64;
    if oscillator.other_stop().is_some() { count } else { f64::NAN }
}
