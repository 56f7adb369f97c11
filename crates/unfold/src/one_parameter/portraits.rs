//! Orbits in the (x, y) plane: the stable solutions at some μ, and further ones found by
//! simulation.

use grazing_continuation::mps::Unknowns;
use grazing_model::{AnyOscillator, ImpactOscillator};
use grazing_results::branches::{PortraitKind, PortraitPoint};
use nalgebra::Vector2;
use rand_pcg::Pcg64;

use super::branches::Branch;
use crate::long_time::{
    Horizon, LongOrbit, MotionKind, Patience, Strike, random_start, sampled, sampled_flight, sampled_solution,
};
use crate::parallel;
use crate::progress::Progress;
use crate::tolerances::{BETWEEN_ORBITS, BETWEEN_WANDERING_ORBITS};

/// A phase portrait that is requested.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Subject {
    /// The value of the parameter across.
    pub across: f64,
    /// The single orbit that is shown: a stable solution of p loops, or for 0 one without impacts
    /// or, if there is none, an attractor found by simulation. `None` shows all orbits.
    pub loops: Option<u32>,
}

/// Number of forcing periods of an attractor.
const ATTRACTOR_PERIODS: u32 = 40;
/// Number of forcing periods of motion that does not reach the wall.
const FREE_PERIODS: f64 = 8.0;
/// Number of random states at each μ.
const STARTS: u32 = 8;
/// Impacts of an orbit that has settled.
type Impacts = Vec<Strike>;

/// The oscillator, branches and settings of the search for orbits.
pub(super) struct Scene<'a> {
    pub(super) oscillator: &'a AnyOscillator,
    pub(super) branches: &'a [Branch],
    pub(super) secondary: f64,
    pub(super) transient: u32,
    /// The lowest initial state.
    pub(super) lowest: f64,
    pub(super) seed: u64,
}

/// A portrait in order of time, with an empty row after each flight; it has no number yet.
pub(super) type Portrait = Vec<PortraitPoint>;

fn portrait(
    kind: PortraitKind,
    loops: u32,
    [primary, secondary]: [f64; 2],
    flights: Vec<Vec<[f64; 3]>>,
) -> Portrait {
    let row = |[time, x, y]: [f64; 3]| PortraitPoint {
        diagram: 0,
        portrait: 0,
        loops,
        secondary,
        primary,
        kind,
        time,
        x,
        y,
    };
    flights.into_iter().flat_map(|flight| flight.into_iter().chain([[f64::NAN; 3]])).map(row).collect()
}

impl Scene<'_> {
    /// The portraits of all subjects, grouped by subject.
    pub(super) fn of_all(&self, subjects: &[Subject], progress: &dyn Progress) -> Vec<Portrait> {
        let portraits =
            |(place, subject)| if progress.stopped() { Vec::new() } else { self.of(place, subject) };
        parallel::map((0..).zip(subjects), portraits).concat()
    }

    /// The portraits of a subject with a given index; empty if the orbit does not exist or rests
    /// at the wall for good.
    fn of(&self, place: u128, subject: &Subject) -> Vec<Portrait> {
        let (all, patience) = match subject.loops {
            None => (true, Patience::Unsettled),
            // Any part of an irregular orbit is sufficient.
            Some(_) => (false, Patience::Drifting),
        };
        let mut portraits = self.at(place, subject.across, patience);
        if all {
            return portraits;
        }
        let chosen = portraits.iter().position(|portrait| Some(portrait[0].loops) == subject.loops);
        // If simulation finds nothing but MPSs, one of these is shown for p = 0.
        let chosen = chosen.or((subject.loops == Some(0) && !portraits.is_empty()).then_some(0));
        chosen.map(|chosen| portraits.swap_remove(chosen)).into_iter().collect()
    }

    fn at(&self, place: u128, primary: f64, patience: Patience) -> Vec<Portrait> {
        let parameters = [primary, self.secondary];
        let oscillator = self.oscillator.with_parameters(parameters);
        let period = oscillator.forcing_period();
        let solution = |loops, flights| portrait(PortraitKind::Periodic, loops, parameters, flights);
        let mut portraits = Vec::new();
        let (mut known, mut free): (Impacts, Vec<Unknowns>) = (Vec::new(), Vec::new());
        for branch in self.branches {
            for point in branch.stable_at(primary) {
                if branch.equations.has_impacts() {
                    let impact =
                        Strike { impact: Vector2::new(point[0], point[1]), stop: branch.equations.stop(0) };
                    if contains(&known, &impact) {
                        continue;
                    }
                    known.push(impact);
                } else {
                    if free.iter().any(|other| (other - &point).norm() < BETWEEN_ORBITS) {
                        continue;
                    }
                    free.push(point.clone());
                }
                let flights = sampled_solution(&branch.equations, &point, 0.0);
                portraits.push(solution(branch.equations.loops(), flights));
            }
        }
        let attractor = |flights| portrait(PortraitKind::Attractor, 0, parameters, flights);
        let mut seen: Vec<Impacts> = Vec::new();
        let (mut aperiodic, mut free_known) = (false, !free.is_empty());
        // A stream of random numbers that the grid does not use.
        let mut random = Pcg64::new(u128::from(self.seed), (place + 1) << 64);
        let horizon = Horizon { patience, ..Horizon::drifting(self.transient, ATTRACTOR_PERIODS) };
        for _ in 0..STARTS {
            let start = random_start(&oscillator, self.lowest, &mut random);
            let orbit = LongOrbit::follow(&oscillator, start, horizon);
            if let Some(state) = orbit.free_state(&oscillator) {
                // Motion with several times the forcing period, or motion to which no branch leads.
                if !core::mem::replace(&mut free_known, true) {
                    let duration = FREE_PERIODS * period;
                    portraits.push(attractor(vec![sampled(
                        &oscillator.motion(state),
                        0.0,
                        duration,
                        period,
                    )]));
                }
                continue;
            }
            let LongOrbit { fate, flights, impacts, .. } = orbit;
            let Some(first) = impacts.first() else { continue };
            if contains(&known, first) {
                continue;
            }
            let known_already = seen.iter().any(|other| near(other, &impacts) && near(&impacts, other));
            let periodic = fate.kind == MotionKind::Periodic;
            if known_already || !periodic && core::mem::replace(&mut aperiodic, true) {
                continue;
            }
            seen.push(impacts);
            let began = flights[0].rest.map_or(flights[0].start, |rest| rest.start);
            let flights = flights
                .iter()
                .map(|flight| sampled_flight(&oscillator, flight, flight.start - began, period));
            portraits.push(attractor(flights.collect()));
        }
        portraits
    }
}

fn contains(impacts: &Impacts, impact: &Strike) -> bool {
    impacts.iter().any(|other| other.is_like(BETWEEN_ORBITS, impact))
}

/// Whether every impact of an attractor lies near one of another attractor.
fn near(all: &Impacts, impacts: &Impacts) -> bool {
    impacts.iter().all(|impact| all.iter().any(|other| other.is_like(BETWEEN_WANDERING_ORBITS, impact)))
}
