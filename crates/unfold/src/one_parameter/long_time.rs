//! Long-time behaviour of the hybrid system from random states.

use core::f64::consts::TAU;

use grazing_model::maps::{next_visit, virtual_map};
use grazing_model::motion::{Motion, highest_maximum};
use grazing_model::orbit::{Flight, FlightEnd, Orbit, OrbitEnd};
use grazing_model::{AtRest, ImpactOscillator, OnWall, State};
use nalgebra::Vector2;
use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;
use rayon::prelude::*;

use super::LONG_TIME;
use super::portraits::drifts;
use crate::progress::Progress;

/// How long-time behaviour is sampled.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// Values of μ, evenly spaced, at least 2.
    pub values: u32,
    /// Orbits at each, from random states.
    pub orbits: u32,
    /// The forcing periods before an orbit counts; more where damping is weak.
    pub transient: u32,
    /// The forcing periods for which it counts then.
    pub recorded: u32,
    /// The seed of the random states.
    pub seed: u64,
}

/// Motion without impacts has settled when what it began with is this small a part of what it was: far less than a dot.
const SETTLED: f64 = 1e-5;
/// But no motion is waited for longer than about so many forcing periods.
pub(crate) const LONGEST_TRANSIENT: u32 = 2_000;

impl Plan {
    /// The same plan with a transient in which motion beside orbits without impacts settles, of whose multipliers these are the products δ.
    ///
    /// A period shrinks areas about an orbit by δ, and so lengths by √δ, if the multipliers are complex.
    pub(super) fn as_long_as_it_takes(&self, products: impl Iterator<Item = f64>) -> Self {
        let weakest = products.fold(0.0, f64::max);
        let periods = 2.0 * libm::log(SETTLED) / libm::log(weakest);
        let wanted = if weakest < 1.0 { libm::ceil(periods) as u32 } else { LONGEST_TRANSIENT };
        Self { transient: wanted.min(LONGEST_TRANSIENT).max(self.transient), ..self.clone() }
    }
}

/// A random point of Π: x uniform between a lowest one and the wall, the phase uniform.
pub fn random_start(lowest: f64, random: &mut Pcg64) -> State {
    State::at_rest(lowest * uniform(random), TAU * uniform(random))
}

/// Uniform in [0, 1), with 53 random bits.
fn uniform(random: &mut Pcg64) -> f64 {
    (random.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
}

/// No orbit has more than a few impacts a period; sticking and chattering end it by themselves.
const MOST_IMPACTS: usize = 1_000_000;

/// An orbit after its transient, times being counted from the end of that.
pub enum Settled<M> {
    /// With impacts: its flights.
    Impacts(Vec<Flight<M>>),
    /// Without: the state at the end of the transient.
    Free(State),
    /// It came to rest at the wall before, where it is followed no further, or cannot be followed at all.
    Ended,
}

/// Follows an orbit for `recorded` forcing periods after `transient` ones, or after more where its impacts are `unsettled` then, as far as that is
/// waited for.
pub fn settled<O: ImpactOscillator>(
    oscillator: &O,
    mut from: State,
    [mut transient, recorded]: [u32; 2],
    unsettled: impl Fn(&[Vector2<f64>]) -> bool,
) -> Settled<O::Motion> {
    let mut passed = 0;
    loop {
        let (found, end) = after_transient(oscillator, from, [transient, recorded]);
        passed += transient + recorded;
        match (&found, end) {
            (Settled::Impacts(flights), Some(end))
                if passed < LONGEST_TRANSIENT && unsettled(&impacts(flights)) =>
            {
                (from, transient) = (end, passed);
            }
            _ => return found,
        }
    }
}

/// The orbit for `recorded` forcing periods after `transient` ones, and its state then if it goes on.
fn after_transient<O: ImpactOscillator>(
    oscillator: &O,
    from: State,
    [transient, recorded]: [u32; 2],
) -> (Settled<O::Motion>, Option<State>) {
    let period = oscillator.forcing_period();
    let transient = f64::from(transient) * period;
    let horizon = transient + f64::from(recorded) * period;
    let mut orbit = Orbit::new(oscillator, from, horizon, MOST_IMPACTS);
    let (mut last, mut flights) = (None, Vec::new());
    for flight in orbit.by_ref() {
        let flight = Flight { start: flight.start - transient, ..flight };
        if flight.start >= 0.0 { flights.push(flight) } else { last = Some(flight) }
    }
    let end = match orbit.end() {
        Some(OrbitEnd::TimeIsUp(end)) if end.position.is_finite() => Some(end),
        _ => None,
    };
    let found = match (end, last) {
        _ if !flights.is_empty() => Settled::Impacts(flights),
        (Some(_), Some(Flight { start, from, motion, .. })) => {
            let here = motion.at(-start);
            let phase = from.phase - oscillator.forcing_frequency().value * start;
            Settled::Free(State { position: here.position, velocity: here.velocity, phase })
        }
        _ => Settled::Ended,
    };
    (found, end)
}

/// The impacts (y, z) at which flights end.
pub(crate) fn impacts<M>(flights: &[Flight<M>]) -> Vec<Vector2<f64>> {
    let impact = |flight: &Flight<M>| match flight.end {
        FlightEnd::Impact(impact) => Some(Vector2::new(impact.velocity, impact.phase)),
        FlightEnd::TimeIsUp(_) => None,
    };
    flights.iter().filter_map(impact).collect()
}

/// x on Π at the visits of an orbit from a random state after its transient; none if it has come to rest at the wall by then.
fn long_time_visits<O: ImpactOscillator>(
    oscillator: &O,
    plan: &Plan,
    lowest: f64,
    random: &mut Pcg64,
) -> Vec<f64> {
    let mut visits = Vec::new();
    let start = random_start(lowest, random);
    match settled(oscillator, start, [plan.transient, plan.recorded], drifts) {
        Settled::Impacts(flights) => {
            flights.iter().for_each(|flight| visits_of(oscillator, flight, &mut visits));
        }
        Settled::Free(state) => visits = highest_points(oscillator, state, plan.recorded),
        Settled::Ended => {}
    }
    visits
}

/// The highest point of every forcing period of motion that does not reach the wall.
fn highest_points<O: ImpactOscillator>(oscillator: &O, from: State, periods: u32) -> Vec<f64> {
    let period = oscillator.forcing_period();
    let motion = oscillator.motion(from);
    let Some(first) = highest_maximum(&motion, 1.25 * period) else { return Vec::new() };
    // Half-way from one to the next, so that none lies at the end of its period.
    let points = (0..periods.saturating_sub(1)).filter_map(|k| {
        let time = first.time + (f64::from(k) + 0.5) * period;
        let here = motion.at(time);
        let phase = from.phase + oscillator.forcing_frequency().value * time;
        let state = State { position: here.position, velocity: here.velocity, phase };
        highest_maximum(&oscillator.motion(state), period)
    });
    core::iter::once(first).chain(points).map(|maximum| maximum.position).collect()
}

/// (μ, x) at the visits of settled orbits over a range of μ; and how many of them left no visit, and how many there are.
pub fn long_time_behaviour<O: ImpactOscillator>(
    oscillator: &O,
    secondary: f64,
    [low, high]: [f64; 2],
    (plan, lowest): (&Plan, f64),
    progress: &dyn Progress,
) -> (Vec<[f64; 2]>, [u32; 2]) {
    progress.begin(LONG_TIME, u64::from(plan.values));
    let sample = |k: u32| {
        let primary = low + (high - low) * f64::from(k) / f64::from(plan.values - 1);
        let oscillator = oscillator.with_parameters([primary, secondary]);
        let mut random = Pcg64::new(u128::from(plan.seed), u128::from(k));
        let (mut visits, mut resting) = (Vec::new(), 0);
        for _ in 0..plan.orbits {
            if progress.stopped() {
                break;
            }
            let found = long_time_visits(&oscillator, plan, lowest, &mut random);
            resting += u32::from(found.is_empty());
            visits.extend(found.into_iter().map(|x| [primary, x]));
        }
        progress.step(LONG_TIME);
        (visits, resting)
    };
    let samples: Vec<_> = (0..plan.values).into_par_iter().map(sample).collect();
    progress.end(LONG_TIME);
    let resting = samples.iter().map(|(_, resting)| resting).sum();
    let visits = samples.into_iter().flat_map(|(visits, _)| visits);
    (visits.filter(|visit| visit[1].is_finite()).collect(), [resting, plan.values * plan.orbits])
}

/// The x-values at which a flight meets Π: the iterates of P_global from the virtual point of its recoil for as long as
/// they lie within the flight, and the virtual top beyond the wall with which it ends.
fn visits_of<O: ImpactOscillator>(oscillator: &O, flight: &Flight<O::Motion>, visits: &mut Vec<f64>) {
    let State { position, velocity, phase } = flight.from;
    let mut here = match velocity {
        0.0 => Some((0.0, AtRest::new(position, phase))),
        _ => {
            let origin = virtual_map::<_, 1>(oscillator, OnWall::new(velocity, phase), None);
            origin.ok().map(|origin| (origin.time, origin.jet.image()))
        }
    };
    while let Some((time, visit)) = here {
        let next = next_visit(oscillator, visit, None).ok();
        let next = next.map(|next| (time + next.time, next.jet.image()));
        here = next.filter(|(time, _)| *time < flight.duration);
        visits.extend(here.map(|(_, visit)| visit.position));
    }
    if let FlightEnd::Impact(impact) = flight.end
        && let Ok(top) = virtual_map::<_, 1>(oscillator, OnWall::new(impact.velocity, impact.phase), None)
    {
        visits.push(top.jet.value[0]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_transient_is_as_long_as_weak_damping_needs_and_no_longer() {
        let plan = Plan { values: 2, orbits: 1, transient: 150, recorded: 1, seed: 1 };
        let transient = |products: &[f64]| plan.as_long_as_it_takes(products.iter().copied()).transient;
        assert_eq!((transient(&[]), transient(&[f64::NAN]), transient(&[0.5])), (150, 150, 150));
        for product in [0.9, 0.97, 0.985] {
            let left = |periods: u32| libm::pow(product, 0.5 * f64::from(periods));
            let periods = transient(&[0.1, product]);
            assert!(left(periods) <= SETTLED && left(periods - 1) > SETTLED, "{product}: {periods}");
        }
        assert_eq!((transient(&[0.9999]), transient(&[1.2])), (LONGEST_TRANSIENT, LONGEST_TRANSIENT));
    }
}
