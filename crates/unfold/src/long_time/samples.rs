//! Orbits as sampled curves.

use core::f64::consts::TAU;

use grazing_continuation::mps::{LoopEquations, Unknowns};
use grazing_model::State;
use grazing_model::motion::Motion;
use grazing_model::orbit::{Flight, FlightEnd, Orbit, OrbitEnd};
use grazing_model::rest::Rest;
use grazing_model::{AnyMotion, AnyOscillator, ImpactOscillator};

/// Number of samples of an orbit per forcing period.
const SAMPLES: f64 = 200.0;

/// Samples (t, x, y) of a motion in a flight that begins at time `start`, close enough for a curve
/// to be drawn.
pub fn sampled(motion: &impl Motion, start: f64, duration: f64, period: f64) -> Vec<[f64; 3]> {
    let steps = libm::ceil(SAMPLES * duration / period);
    let at = |k: u32| {
        let time = duration * f64::from(k) / steps;
        let here = motion.at(time);
        [start + time, here.position, here.velocity]
    };
    (0..=steps as u32).map(at).collect()
}

/// Samples (t, x, y) of a flight that begins at time `start`, and before them those of the rest at the
/// wall from which it is released.
pub(crate) fn sampled_flight(
    oscillator: &AnyOscillator,
    flight: &Flight<AnyMotion>,
    start: f64,
    period: f64,
) -> Vec<[f64; 3]> {
    let before = |rest: &Rest| {
        let begin = start - (flight.start - rest.start);
        sampled_rest(oscillator, rest, |time| begin + time)
    };
    let mut samples = flight.rest.as_ref().map_or(Vec::new(), before);
    // The flight begins where the rest ends.
    samples.pop();
    samples.extend(sampled(&flight.motion, start, flight.duration, period));
    samples
}

/// Samples (t, x, y) of a rest at a stop, with t as a function of the time from its beginning: its ends,
/// or as many as for a flight at the other stop, which may move.
pub(crate) fn sampled_rest(
    oscillator: &AnyOscillator,
    rest: &Rest,
    when: impl Fn(f64) -> f64,
) -> Vec<[f64; 3]> {
    let frequency = oscillator.forcing_frequency().value;
    let at = |time: f64| {
        let [gap, rate] = oscillator.gap(rest.phase + frequency * time);
        match rest.stop {
            0 => [when(time), 0.0, 0.0],
            _ => [when(time), -gap.value, -rate.value],
        }
    };
    let steps = match rest.stop {
        0 => 1,
        _ => libm::ceil(SAMPLES * rest.duration * frequency / TAU).max(1.0) as u32,
    };
    (0..=steps).map(|k| at(rest.duration * f64::from(k) / f64::from(steps))).collect()
}

/// An orbit from a state on, in a form for display.
#[derive(Clone, Debug)]
pub struct Trajectory {
    /// The flights, (t, x, y) along each, with the rest at the wall before it; the phase is zero at
    /// t = 0. A rest in which the orbit ends comes last.
    pub flights: Vec<Vec<[f64; 3]>>,
    /// Time, phase and velocity of the impacts.
    pub impacts: Vec<[f64; 3]>,
    /// Their stops: 0 for that at x = 0, 1 for the other, if there are two.
    pub stops: Vec<usize>,
    /// The end of the orbit.
    pub end: OrbitEnd,
}

impl Trajectory {
    /// The orbit from a state at time `begin`, which corresponds to its phase, for a time or up to
    /// a number of impacts.
    pub fn follow(
        oscillator: &AnyOscillator,
        from: State,
        begin: f64,
        (time, impacts): (f64, usize),
    ) -> Self {
        let period = oscillator.forcing_period();
        let mut orbit = Orbit::new(oscillator, from, time, impacts);
        let (flights, impacts, stops) = (Vec::new(), Vec::new(), Vec::new());
        let mut all = Self { flights, impacts, stops, end: OrbitEnd::TimeIsUp(from) };
        for flight in orbit.by_ref() {
            let start = begin + flight.start;
            all.flights.push(sampled_flight(oscillator, &flight, start, period));
            if let FlightEnd::Impact(impact) = flight.end {
                all.impacts.push([start + flight.duration, impact.phase, impact.velocity]);
                all.stops.push(flight.stop);
            }
        }
        if let Some(OrbitEnd::Resting { rest, .. }) = orbit.end() {
            all.flights.push(sampled_rest(oscillator, &rest, |time| begin + (rest.start + time)));
        }
        Self { end: orbit.end().unwrap_or(all.end), ..all }
    }
}

/// The flights of a periodic solution, the first of which begins at time `start`, as the first stop sees them.
pub fn sampled_solution(equations: &LoopEquations, point: &Unknowns, start: f64) -> Vec<Vec<[f64; 3]>> {
    let oscillator = equations.oscillator_at(point);
    let (period, flights) = (oscillator.forcing_period(), equations.flown(point));
    flights.iter().map(|flight| sampled_flight(&oscillator, flight, start + flight.start, period)).collect()
}

/// The first time from zero on at which the forcing has this phase.
pub fn time_of_phase(phase: f64, period: f64) -> f64 {
    let turns = phase / TAU;
    (turns - libm::floor(turns)) * period
}
