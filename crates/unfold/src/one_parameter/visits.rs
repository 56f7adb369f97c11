//! Long-term behaviour of the hybrid system from random states, as x on Π.

use grazing_model::motion::Motion;
use grazing_model::{AnyOscillator, ImpactOscillator, State};
use grazing_results::branches::Orbits;
use grazing_results::readings::{MotionReading, Sweep};
use rand_pcg::Pcg64;

use super::Sampling;
use super::flights::visits_of;
use super::readings::{counted, readings_of};
use crate::long_time::{Horizon, LONGEST_TRANSIENT, LongOrbit, random_start};
use crate::parallel;
use crate::progress::Progress;
use crate::settled::{Recurring, equations, near, solution};

/// Motion without impacts has settled when its transient is this small a fraction of its initial
/// size: far less than a dot.
const SETTLED: f64 = 1e-5;

/// The stage.
const LONG_TIME: &str = "long-term behaviour";

impl Sampling {
    /// The time for which an orbit is followed.
    pub(super) const fn horizon(&self) -> Horizon {
        Horizon::drifting(self.transient, self.recorded)
    }

    /// The sampling with a transient in which motion beside orbits without impacts settles;
    /// `products` are the products δ of their multipliers.
    ///
    /// A period shrinks areas about an orbit by δ, and so lengths by √δ, if the multipliers are
    /// complex.
    pub(super) fn as_long_as_it_takes(&self, products: impl Iterator<Item = f64>) -> Self {
        let weakest = products.fold(0.0, f64::max);
        let periods = 2.0 * libm::log(SETTLED) / libm::log(weakest);
        let enough = if weakest < 1.0 { libm::ceil(periods) as u32 } else { LONGEST_TRANSIENT };
        Self { transient: enough.min(LONGEST_TRANSIENT).max(self.transient), ..self.clone() }
    }
}

/// The values of x on Π at the visits of an orbit after its transient; a rest at the wall is one, at
/// x = 0.
fn long_time_visits(oscillator: &AnyOscillator, orbit: &LongOrbit, counted: u32) -> Vec<f64> {
    if let Some(state) = orbit.free_state(oscillator) {
        return highest_points(oscillator, state, counted);
    }
    let visits = orbit.flights.iter().flat_map(|flight| visits_of(oscillator, flight));
    visits.map(|[x, _]| x).collect()
}

/// The long-term behaviour from random states.
#[derive(Default)]
pub(super) struct Sampled {
    /// The points (μ, x) of the visits.
    pub(super) visits: Vec<[f64; 2]>,
    /// Further readings, if they are requested.
    pub(super) readings: Vec<MotionReading>,
    /// The numbers of orbits.
    pub(super) orbits: Orbits,
    /// Solutions on which orbits have settled, with several impacts but no more than are wanted.
    pub(super) settled: Vec<Recurring>,
}

/// The highest point of every forcing period of motion that does not reach the wall.
fn highest_points(oscillator: &AnyOscillator, from: State, periods: u32) -> Vec<f64> {
    let period = oscillator.forcing_period();
    let motion = oscillator.motion(from);
    let Some(first) = motion.highest_maximum(1.25 * period) else { return Vec::new() };
    // Half-way from one to the next, so that none lies at the end of its period.
    let points = (0..periods.saturating_sub(1)).filter_map(|k| {
        let time = first.time + (f64::from(k) + 0.5) * period;
        let state = motion.at(time).state(from.phase + oscillator.forcing_frequency().value * time);
        oscillator.motion(state).highest_maximum(period)
    });
    core::iter::once(first).chain(points).map(|maximum| maximum.position).collect()
}

/// The solution with several impacts, `most` of them at most, on which an orbit has settled.
fn settled(oscillator: &AnyOscillator, orbit: &LongOrbit, most: u32) -> Option<Recurring> {
    let impacts = orbit.cycle?.impacts;
    let (kind, near) = (2..=most as usize).contains(&impacts).then(|| near(oscillator, orbit))??;
    let equations = equations(oscillator, &kind);
    solution(&equations, &near, oscillator.parameters()).map(|at| (kind, at))
}

/// The long-term behaviour of orbits over a range of μ.
pub(super) fn long_time_behaviour(
    oscillator: &AnyOscillator,
    secondary: f64,
    [low, high]: [f64; 2],
    (sampling, lowest): (&Sampling, f64),
    progress: &dyn Progress,
) -> Sampled {
    let sample = |k: u32| {
        let primary = low + (high - low) * f64::from(k) / f64::from(sampling.values - 1);
        let oscillator = oscillator.with_parameters([primary, secondary]);
        let mut random = Pcg64::new(u128::from(sampling.seed), u128::from(k));
        let mut sampled = Sampled::default();
        for number in 0..sampling.orbits {
            if progress.stopped() {
                break;
            }
            let orbit = LongOrbit::follow(
                &oscillator,
                random_start(&oscillator, lowest, &mut random),
                sampling.horizon(),
            );
            let found = long_time_visits(&oscillator, &orbit, sampling.recorded);
            sampled.orbits = sampled.orbits.plus(counted(&orbit));
            sampled.settled.extend(settled(&oscillator, &orbit, sampling.impacts));
            sampled.visits.extend(found.into_iter().filter(|x| x.is_finite()).map(|x| [primary, x]));
            if sampling.readings {
                sampled.readings.extend(readings_of(&oscillator, &orbit, (Sweep::Random, number)));
            }
        }
        progress.step(LONG_TIME);
        sampled
    };
    let samples: Vec<_> =
        progress.during(LONG_TIME, sampling.values.into(), || parallel::map(0..sampling.values, sample));
    let mut all = Sampled::default();
    for Sampled { visits, readings, orbits, settled } in samples {
        all.settled.extend(settled);
        all.visits.extend(visits);
        all.readings.extend(readings);
        all.orbits = all.orbits.plus(orbits);
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_transient_is_as_long_as_weak_damping_needs_and_no_longer() {
        let (between, lowest) = (None, None);
        let sampling = Sampling {
            values: 2,
            between,
            orbits: 1,
            transient: 150,
            recorded: 1,
            lowest,
            seed: 1,
            readings: false,
            impacts: 1,
        };
        let transient = |products: &[f64]| sampling.as_long_as_it_takes(products.iter().copied()).transient;
        assert_eq!((transient(&[]), transient(&[f64::NAN]), transient(&[0.5])), (150, 150, 150));
        for product in [0.9, 0.97, 0.985] {
            let left = |periods: u32| libm::pow(product, 0.5 * f64::from(periods));
            let periods = transient(&[0.1, product]);
            assert!(left(periods) <= SETTLED && left(periods - 1) > SETTLED, "{product}: {periods}");
        }
        assert_eq!((transient(&[0.9999]), transient(&[1.2])), (LONGEST_TRANSIENT, LONGEST_TRANSIENT));
    }
}
