//! The solution on which motion of any oscillator with impacts settles, by simulation from event to
//! event.

use core::f64::consts::TAU;

use grazing_model::orbit::{FlightEnd, Orbit, OrbitEnd};
use grazing_model::phase::turned;
use grazing_model::{ImpactOscillator, State};

use crate::random::Random;

/// A p-loop solution on which motion has settled, or one without impacts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settled {
    /// The number of loops p; 0 without impacts.
    pub loops: u32,
    /// Velocity of the impact; without impacts, velocity at phase zero.
    pub velocity: f64,
    /// Phase of the impact; zero without impacts.
    pub phase: f64,
}

/// Forcing periods for which motion is followed before each test, and the number of such spells.
const SPELL: f64 = 50.0;
const SPELLS: usize = 7;
/// The difference below which impacts count as equal.
const SAME: f64 = 1e-6;
/// The number of consecutive impacts, equal to a thousandth of [`SAME`], after which motion counts as
/// settled.
const SURE: usize = 8;
/// The impact velocity below which motion is close to grazing, and settles slowly.
const SLOWEST: f64 = 1e-3;
/// The distance beyond which motion without impacts has been carried away, as a pendulum over the top.
const CARRIED_AWAY: f64 = 4.0;
/// The greatest number of impacts in a spell; motion that settles has fewer.
const MOST_IMPACTS: usize = 10_000;

/// The p-loop solution, or the one without impacts, on which motion from a random state settles.
pub fn settled(oscillator: &impl ImpactOscillator, random: &mut Random) -> Option<Settled> {
    let period = oscillator.forcing_period();
    let mut from = State {
        position: -random.uniform(0.0, 2.0),
        velocity: random.uniform(-1.5, 1.5),
        phase: random.uniform(0.0, TAU),
    };
    let mut impacts: Vec<[f64; 3]> = Vec::new();
    for _ in 0..SPELLS {
        impacts.clear();
        let mut orbit = Orbit::new(oscillator, from, SPELL * period, MOST_IMPACTS);
        for flight in orbit.by_ref() {
            if let FlightEnd::Impact(state) = flight.end {
                impacts.push([flight.start + flight.duration, state.velocity, state.phase]);
                let last = impacts.len().checked_sub(SURE).map(|first| &impacts[first..]);
                if let Some(found) = last.and_then(|last| repeated(last, period, 1e-3 * SAME)) {
                    return Some(found);
                }
            }
        }
        // Motion that rests at the wall for a while has no p-loop solution.
        let Some(OrbitEnd::TimeIsUp(state)) = orbit.end() else { return None };
        if impacts.is_empty()
            && let Some(found) = without_impacts(oscillator, state)
        {
            return Some(found);
        }
        from = state;
    }
    // At least three repetitions.
    (impacts.len() > 3).then(|| repeated(&impacts, period, SAME)).flatten()
}

/// The solution without impacts on which motion has settled, if the state recurs after a period.
fn without_impacts(oscillator: &impl ImpactOscillator, from: State) -> Option<Settled> {
    let to_phase_zero = (TAU - turned(from.phase)) / oscillator.forcing_frequency().value;
    let after = |state: State, time: f64| {
        let mut orbit = Orbit::new(oscillator, state, time, 1);
        match (orbit.next()?.end, orbit.impacts()) {
            (FlightEnd::TimeIsUp(state), 0) => Some(state),
            _ => None,
        }
    };
    let start = after(from, to_phase_zero)?;
    let end = after(start, oscillator.forcing_period())?;
    let gap = libm::hypot(end.position - start.position, end.velocity - start.velocity);
    (gap < SAME && start.position > -CARRIED_AWAY).then_some(Settled {
        loops: 0,
        velocity: start.velocity,
        phase: 0.0,
    })
}

/// The p-loop solution with these impacts, if they are all equal to within `difference`.
fn repeated(impacts: &[[f64; 3]], period: f64, difference: f64) -> Option<Settled> {
    let [first, second, ..] = impacts else { return None };
    // The duration of impacts is not included in that of flights.
    let loops = libm::round((second[0] - first[0]) / period);
    let same = impacts.iter().all(|[_, velocity, phase]| {
        (velocity - first[1]).abs() < difference
            && libm::remainder(phase - first[2], TAU).abs() < difference
            && *velocity > SLOWEST
    });
    (same && loops >= 1.0).then_some(Settled { loops: loops as u32, velocity: first[1], phase: first[2] })
}
