//! Orbits in the (x, y) plane: the stable solutions at some μ, and what simulation finds besides.

use core::f64::consts::TAU;
use core::ops::RangeInclusive;

use grazing_model::motion::Motion;
use grazing_model::{ImpactOscillator, State};
use nalgebra::Vector2;
use rand_pcg::Pcg64;
use rayon::prelude::*;

use super::branches::Branch;
use super::long_time::{Plan, Settled, impacts, random_start, settled};
use crate::non_impacting::branch;
use crate::non_impacting::orbits::{OrbitPoint, PRIMARY, PeriodicOrbits};
use crate::progress::Progress;

/// An orbit that is shown.
#[derive(Clone, Debug)]
pub struct Portrait {
    /// Loops p of an MPS; 0 is the non-impacting solution, or an attractor.
    pub loops: u32,
    /// μ.
    pub primary: f64,
    /// It was found by simulation and is neither an MPS nor the non-impacting solution.
    pub attractor: bool,
    /// Its free flights: (t, x, y) at times close enough for a curve to be drawn.
    pub flights: Vec<Vec<[f64; 3]>>,
}

/// Samples of an orbit per forcing period.
const SAMPLES: f64 = 200.0;
/// Forcing periods of an attractor.
pub const ATTRACTOR_PERIODS: u32 = 40;
/// Forcing periods of motion that does not reach the wall.
const FREE_PERIODS: f64 = 8.0;
/// Random states at each μ.
const STARTS: u32 = 8;
/// Impacts closer than this are one: orbits have settled to far less.
const SAME: f64 = 1e-3;
/// Motion whose impacts come again to within this may be about to settle.
const NEARLY: f64 = 0.1;
/// Attractors whose impacts lie this close to each other look the same.
const ALIKE: f64 = 0.03;
/// An orbit whose impacts do not come again after so many counts as not periodic.
const LONGEST_CYCLE: usize = 24;

/// Samples of a motion in a flight that begins at time `start`.
pub fn sampled(motion: &impl Motion, start: f64, duration: f64, period: f64) -> Vec<[f64; 3]> {
    let steps = libm::ceil(SAMPLES * duration / period);
    let at = |k: u32| {
        let time = duration * f64::from(k) / steps;
        let here = motion.at(time);
        [start + time, here.position, here.velocity]
    };
    (0..=steps as u32).map(at).collect()
}

/// Impacts (y, z) of an orbit that has settled.
type Impacts = Vec<Vector2<f64>>;

/// What orbits are looked for in.
pub(super) struct Scene<'a, O> {
    pub(super) orbits: &'a PeriodicOrbits<'a, O>,
    pub(super) non_impacting: &'a [branch::Branch],
    pub(super) branches: &'a [Branch<O>],
    pub(super) plan: &'a Plan,
    pub(super) lowest: f64,
}

impl<O: ImpactOscillator> Scene<'_, O> {
    /// The orbits at some values of μ, those of each together.
    pub(super) fn at_all(&self, places: &[f64], secondary: f64, progress: &dyn Progress) -> Vec<Portrait> {
        let numbered: Vec<(u128, f64)> = (0..).zip(places.iter().copied()).collect();
        let found = numbered.into_par_iter().map(|(place, primary)| {
            if progress.stopped() { Vec::new() } else { self.at(place, [primary, secondary]) }
        });
        found.collect::<Vec<_>>().concat()
    }

    fn at(&self, place: u128, [primary, secondary]: [f64; 2]) -> Vec<Portrait> {
        let oscillator = self.orbits.oscillator.with_parameters([primary, secondary]);
        let period = oscillator.forcing_period();
        let periodic = |loops, flights| Portrait { loops, primary, attractor: false, flights };
        let mut portraits = Vec::new();
        let free = self.non_impacting_at(primary);
        for orbit in &free {
            let from = State { position: orbit[0], velocity: orbit[1], phase: 0.0 };
            portraits.push(periodic(0, vec![sampled(&oscillator.motion(from), 0.0, period, period)]));
        }
        let mut known: Vec<Impacts> = Vec::new();
        for branch in self.branches {
            let loops = branch.equations.loops();
            for point in branch.stable_at(primary) {
                let impact = Vector2::new(point[0], point[1]);
                if known.iter().any(|other| contains(other, &impact)) {
                    continue;
                }
                known.push(vec![impact]);
                let recoil = branch.equations.recoil(&point);
                let lag = (recoil.phase - point[1]) / oscillator.forcing_frequency().value;
                let flight = f64::from(loops) * period - lag;
                portraits
                    .push(periodic(loops, vec![sampled(&oscillator.motion(recoil), 0.0, flight, period)]));
            }
        }
        let mut seen: Vec<Impacts> = Vec::new();
        let (mut aperiodic, mut free_known) = (false, !free.is_empty());
        // None of the numbers of the grid.
        let mut random = Pcg64::new(u128::from(self.plan.seed), (place + 1) << 64);
        for _ in 0..STARTS {
            let start = random_start(self.lowest, &mut random);
            let flights =
                match settled(&oscillator, start, [self.plan.transient, ATTRACTOR_PERIODS], |impacts| {
                    cycle(impacts).is_none()
                }) {
                    Settled::Impacts(flights) => flights,
                    Settled::Free(state) => {
                        // Motion of several times the forcing's period, or what no branch leads to.
                        if !core::mem::replace(&mut free_known, true) {
                            let duration = FREE_PERIODS * period;
                            let flights = vec![sampled(&oscillator.motion(state), 0.0, duration, period)];
                            portraits.push(Portrait { loops: 0, primary, attractor: true, flights });
                        }
                        continue;
                    }
                    Settled::Ended => continue,
                };
            let impacts: Impacts = impacts(&flights);
            let Some(first) = impacts.first() else { continue };
            if known.iter().any(|other| contains(other, first)) {
                continue;
            }
            let known_already = seen.iter().any(|other| near(other, &impacts) && near(&impacts, other));
            if known_already || cycle(&impacts).is_none() && core::mem::replace(&mut aperiodic, true) {
                continue;
            }
            seen.push(impacts);
            let began = flights[0].start;
            let flights = flights
                .iter()
                .map(|flight| sampled(&flight.motion, flight.start - began, flight.duration, period));
            portraits.push(Portrait { loops: 0, primary, attractor: true, flights: flights.collect() });
        }
        portraits
    }

    /// The stable non-impacting orbits off the wall.
    fn non_impacting_at(&self, primary: f64) -> Vec<OrbitPoint> {
        let [share, _] = self.orbits.scope.window.shares([primary, 0.0]);
        let pairs = self.non_impacting.iter().flat_map(|branch| branch.orbits.windows(2));
        let mut found: Vec<OrbitPoint> = Vec::new();
        for pair in pairs {
            let [a, b] = [pair[0].orbit, pair[1].orbit];
            let [from, to] = [a, b].map(|orbit| orbit[PRIMARY] - share);
            if from * to > 0.0 || from == to {
                continue;
            }
            let mut near = a + (b - a) * (from / (from - to));
            near[PRIMARY] = share;
            let good = self.orbits.at(&near).filter(|orbit| self.orbits.seen(orbit).good());
            found.extend(good.filter(|orbit| !found.iter().any(|other| (other - orbit).norm() < SAME)));
        }
        found
    }
}

/// Whether two impacts are no farther apart than this, in y counted in y where that is above one.
fn within(distance: f64, a: &Vector2<f64>, b: &Vector2<f64>) -> bool {
    (a[0] - b[0]).abs() <= distance * a[0].max(1.0) && libm::remainder(a[1] - b[1], TAU).abs() <= distance
}

fn contains(impacts: &Impacts, impact: &Vector2<f64>) -> bool {
    impacts.iter().any(|other| within(SAME, other, impact))
}

/// Whether every impact of an attractor lies beside one of another.
fn near(all: &Impacts, impacts: &Impacts) -> bool {
    impacts.iter().all(|impact| all.iter().any(|other| within(ALIKE, other, impact)))
}

/// The number of impacts after which the same ones come again, if they do, again and again.
pub(crate) fn cycle(impacts: &[Vector2<f64>]) -> Option<usize> {
    let again = |cycle: usize| impacts.iter().enumerate().all(|(k, a)| within(SAME, a, &impacts[k % cycle]));
    cycles(impacts).find(|cycle| again(*cycle))
}

/// Whether nearly the same impacts come again, but not the same: as where motion comes slowly to a cycle, or leaves one.
pub fn drifts(impacts: &[Vector2<f64>]) -> bool {
    let nearly = |cycle: usize| impacts.iter().zip(&impacts[cycle..]).all(|(a, b)| within(NEARLY, a, b));
    cycle(impacts).is_none() && cycles(impacts).any(nearly)
}

/// The numbers of impacts in which these may have come again.
fn cycles(impacts: &[Vector2<f64>]) -> RangeInclusive<usize> {
    1..=LONGEST_CYCLE.min(impacts.len() / 2)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Impacts whose velocities alternate and come nearer to their limits by a factor.
    fn settling(factor: f64, from: f64) -> Impacts {
        let impact =
            |k: i32| Vector2::new(1.0 + 0.2 * f64::from(k % 2) + from * libm::pow(factor, k.into()), 2.0);
        (0..40).map(impact).collect()
    }

    #[test]
    fn impacts_that_come_slowly_to_a_cycle_drift_until_they_have_come_to_it() {
        // Each is within the distance of the one two before, but not of the first.
        let slow = settling(0.99, 0.02);
        assert!(slow.windows(3).all(|three| within(SAME, &three[0], &three[2])));
        assert!(drifts(&slow) && cycle(&slow).is_none());
        let settled = settling(0.99, 1e-4);
        assert!(!drifts(&settled));
        assert_eq!(cycle(&settled), Some(2));
        // What wanders about neither drifts nor comes again.
        let wandering: Impacts =
            (0..40).map(|k| Vector2::new(1.0 + 0.5 * libm::sin(f64::from(k * k)), 2.0)).collect();
        assert!(!drifts(&wandering) && cycle(&wandering).is_none());
    }
}
