//! An orbit that is followed for a long time, and what is read off it.

use core::f64::consts::TAU;

use grazing_model::motion::Motion;
use grazing_model::orbit::{Flight, FlightEnd, Orbit, OrbitEnd};
use grazing_model::{ImpactOscillator, OnWall, State, flow_variable};
use nalgebra::{Matrix2, Vector2};

use super::{Attractor, Fate, MotionKind, SAME, is_same};
use crate::one_parameter::{LONGEST_TRANSIENT, cycle, drifts, impacts, sampled};

/// No orbit has more impacts than this; sticking and chattering end it by themselves.
const MOST_IMPACTS: usize = 100_000;
/// Flights that are shown of an attractor that does not come again.
const SHOWN: usize = 40;
/// Forcing periods of motion without impacts after which it is looked for again.
const MOST_PERIODS: u32 = 16;

/// What is kept of an orbit from a state, to be compared with others.
pub(super) struct Seen {
    pub(super) start: State,
    pub(super) fate: Fate,
    pub(super) impacts: Vec<Vector2<f64>>,
    /// Position and velocity at phase zero, and the highest point, of motion without impacts.
    pub(super) at_phase_zero: Option<[f64; 2]>,
    pub(super) highest: f64,
}

impl Seen {
    /// Whether it looks like another one.
    pub(super) fn is_like(&self, other: &Self) -> bool {
        let (a, b) = (&self.fate, &other.fate);
        if (a.kind, a.periods) != (b.kind, b.periods) {
            return false;
        }
        match a.kind {
            MotionKind::Periodic => {
                let first = &other.impacts[0];
                self.impacts.iter().any(|impact| is_same(impact, first))
            }
            MotionKind::NonImpacting => (self.highest - other.highest).abs() < SAME,
            _ => true,
        }
    }
}

/// An orbit after its transient.
pub(super) struct LongOrbit<O: ImpactOscillator> {
    pub(super) fate: Fate,
    /// Flights that count; one without an impact if there are none with one.
    flights: Vec<Flight<O::Motion>>,
    impacts: Vec<Vector2<f64>>,
    period: f64,
}

impl<O: ImpactOscillator> LongOrbit<O> {
    /// The orbit from a state in those of two numbers of forcing periods that count, which come later where it has not settled by then.
    pub(super) fn new(oscillator: &O, from: State, [transient, counted]: [u32; 2]) -> Self {
        let period = oscillator.forcing_period();
        let begin = f64::from(transient) * period;
        let horizon = begin + f64::from(counted) * period;
        let mut orbit = Orbit::new(oscillator, from, horizon, MOST_IMPACTS);
        let (mut last, mut flights) = (None, Vec::new());
        for flight in orbit.by_ref() {
            if flight.start >= begin { flights.push(flight) } else { last = Some(flight) }
        }
        let impacts = impacts(&flights);
        if let Some(OrbitEnd::TimeIsUp(end)) = orbit.end()
            && transient < LONGEST_TRANSIENT
            && drifts(&impacts)
        {
            return Self::new(oscillator, end, [2 * transient + counted, counted]);
        }
        let rate = impacts.len() as f64 / f64::from(counted);
        let fate = match orbit.end() {
            Some(OrbitEnd::TimeIsUp(end)) if !end.position.is_finite() => {
                Fate { kind: MotionKind::Escaping, periods: None, impacts: f64::NAN }
            }
            Some(OrbitEnd::TimeIsUp(_)) if impacts.is_empty() => {
                flights.extend(last);
                let periods = flights.last().and_then(|flight| comes_again(flight, begin, period));
                Fate { kind: MotionKind::NonImpacting, periods, impacts: 0.0 }
            }
            Some(OrbitEnd::TimeIsUp(_)) => match cycle(&impacts) {
                Some(cycle) => {
                    let time = flights[cycle].start - flights[0].start;
                    let periods = libm::round(time / period).max(1.0);
                    let kind = MotionKind::Periodic;
                    Fate { kind, periods: Some(periods as u32), impacts: cycle as f64 / periods }
                }
                None => Fate { kind: MotionKind::Aperiodic, periods: None, impacts: rate },
            },
            _ => Fate { kind: MotionKind::Resting, periods: None, impacts: rate },
        };
        Self { fate, flights, impacts, period }
    }

    /// Position and velocity at phase zero of motion without impacts.
    fn at_phase_zero(&self, oscillator: &O) -> Option<[f64; 2]> {
        let flight = self.flights.last().filter(|_| self.fate.kind == MotionKind::NonImpacting)?;
        let frequency = oscillator.forcing_frequency().value;
        // The last whole turn of the flight.
        let phase = flight.from.phase + frequency * flight.duration;
        let past = (phase - TAU * libm::floor(phase / TAU)) / frequency;
        let here = flight.motion.at(flight.duration - past);
        Some([here.position, here.velocity])
    }

    pub(super) fn seen(self, oscillator: &O, start: State) -> Seen {
        let at_phase_zero = self.at_phase_zero(oscillator);
        let free = self.flights.last().filter(|_| self.fate.kind == MotionKind::NonImpacting);
        let highest = free.map_or(f64::NAN, |flight| highest(flight, self.period));
        Seen { start, fate: self.fate, impacts: self.impacts, at_phase_zero, highest }
    }

    pub(super) fn attractor(&self, oscillator: &O, start: State) -> Attractor {
        let period = self.period;
        let first = self.flights.first();
        let began = first.map_or(0.0, |first| first.start - begins(first.from.phase, period));
        let cycle = self
            .fate
            .periods
            .map_or(SHOWN, |periods| libm::round(self.fate.impacts * f64::from(periods)).max(1.0) as usize);
        let shown = self.flights.iter().take(cycle);
        let flights = match self.fate.kind {
            MotionKind::NonImpacting => {
                let flight = self.flights.last();
                let periods = f64::from(self.fate.periods.unwrap_or(MOST_PERIODS));
                let shown = |flight: &Flight<O::Motion>| {
                    let time = flight.duration - periods * period;
                    let from = flight.motion.at(time);
                    let phase = flight.from.phase + oscillator.forcing_frequency().value * time;
                    let from = State { position: from.position, velocity: from.velocity, phase };
                    vec![sampled(&oscillator.motion(from), begins(phase, period), periods * period, period)]
                };
                flight.map(shown).unwrap_or_default()
            }
            _ => shown
                .map(|flight| sampled(&flight.motion, flight.start - began, flight.duration, period))
                .collect(),
        };
        let strikes = self
            .impacts
            .iter()
            .map(|impact| [impact[1] - TAU * libm::floor(impact[1] / TAU), impact[0]])
            .collect();
        let free = self.at_phase_zero(oscillator);
        let free = free.map(|[position, velocity]| State { position, velocity, phase: 0.0 });
        let state = free.or(self.flights.last().map(|flight| flight.from)).unwrap_or(start);
        Attractor { states: 1, fate: self.fate, lyapunov: self.lyapunov(oscillator), flights, strikes, state }
    }

    /// The mean rate at which a small displacement grows, by the derivatives of the maps from impact to impact, or of the flow.
    ///
    /// A displaced orbit hits the wall earlier by δx/ẋ, so that an impact is a map (δy, δz) ↦ (δy, δz) on the wall.
    fn lyapunov(&self, oscillator: &O) -> f64 {
        if matches!(self.fate.kind, MotionKind::Resting | MotionKind::Escaping) {
            return f64::NAN;
        }
        let frequency = oscillator.forcing_frequency().value;
        let mut displacement = Vector2::new(0.6, 0.8);
        let (mut growth, mut time) = (0.0, 0.0);
        let mut stretch = |derivative: Matrix2<f64>, duration: f64| {
            displacement = derivative * displacement;
            let size = displacement.norm();
            displacement /= size;
            growth += libm::log(size);
            time += duration;
        };
        if self.fate.kind == MotionKind::NonImpacting {
            let Some(flight) = self.flights.last() else { return f64::NAN };
            for left in (1..=MOST_PERIODS).rev() {
                let time = flight.duration - f64::from(left) * self.period;
                let here = flight.motion.at(time);
                let phase = flight.from.phase + frequency * time;
                let from = State { position: here.position, velocity: here.velocity, phase };
                let jacobian = oscillator.flow::<1>(from, self.period).jacobian;
                stretch(jacobian.fixed_columns::<2>(flow_variable::POSITION).into_owned(), self.period);
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

/// The first time from zero on at which the phase is this one.
pub(super) fn begins(phase: f64, period: f64) -> f64 {
    let turns = phase / TAU;
    (turns - libm::floor(turns)) * period
}

/// The forcing periods after which motion without impacts comes again, from a time on.
fn comes_again<M: Motion>(flight: &Flight<M>, from: f64, period: f64) -> Option<u32> {
    let start = (from - flight.start).max(0.0);
    let state = |time: f64| {
        let here = flight.motion.at(time);
        Vector2::new(here.position, here.velocity * period)
    };
    let first = state(start);
    (1..=MOST_PERIODS).find(|periods| {
        let time = start + f64::from(*periods) * period;
        time <= flight.duration && (state(time) - first).norm() < SAME
    })
}

/// The highest point of the last forcing period of a flight, as it is sampled.
fn highest<M: Motion>(flight: &Flight<M>, period: f64) -> f64 {
    let points = sampled(&flight.motion, 0.0, flight.duration, period);
    let last = points.len().saturating_sub(200);
    points[last..].iter().map(|point| point[1]).fold(f64::NEG_INFINITY, f64::max)
}
