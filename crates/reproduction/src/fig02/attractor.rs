//! Long-time behaviour of forward orbits from random initial points.

use core::f64::consts::TAU;

use grazing_continuation::bifurcation::Bifurcation;
use grazing_model::maps::{global_map, virtual_map};
use grazing_model::orbit::{Flight, FlightEnd, Orbit};
use grazing_model::{AtRest, ImpactOscillator, LinearMotion, LinearOscillator, OnWall, State};
use grazing_results::branches::{AttractorPoint, BranchBifurcation};
use grazing_unfold::progress::Progress;
use nalgebra::Vector2;
use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;
use rayon::prelude::*;

use super::Setting;
use crate::StudyError;

/// x on Π along orbits after a transient, at amplitudes between GZ and PD.
///
/// Empty if the branches have no GZ or no PD in the window.
pub(super) fn rows(
    setting: &Setting,
    bifurcations: &[BranchBifurcation],
    progress: &dyn Progress,
) -> Result<Vec<AttractorPoint>, StudyError> {
    let first = |kind| bifurcations.iter().find(|b| b.kind == kind).map(|b| b.primary);
    let (Some(gz), Some(pd)) = (first(Bifurcation::Grazing), first(Bifurcation::PeriodDoubling)) else {
        return Ok(Vec::new());
    };
    let plan = &setting.figure.attractor;
    let what = "long-time behaviour";
    progress.begin(what, u64::from(plan.amplitudes));
    let sample = |k: u32| {
        let primary = gz + (pd - gz) * f64::from(k) / f64::from(plan.amplitudes - 1);
        let oscillator = setting.oscillator(primary)?;
        let mut random = Pcg64::new(u128::from(plan.seed), u128::from(k));
        let mut visits = Vec::new();
        for _ in 0..plan.orbits {
            visits.extend(long_time_visits(&oscillator, setting, &mut random));
        }
        progress.step(what);
        Ok(visits.into_iter().map(|x| AttractorPoint { primary, x }).collect())
    };
    let samples: Vec<Vec<_>> =
        (0..plan.amplitudes).into_par_iter().map(sample).collect::<Result<_, StudyError>>()?;
    progress.end(what);
    Ok(samples.into_iter().flatten().collect())
}

/// A random point of Π: x uniform between the lower edge of the figure and the wall, the phase uniform.
pub(super) fn random_start(setting: &Setting, random: &mut Pcg64) -> State {
    let lowest = setting.figure.x[0].min(0.0);
    State::at_rest(lowest * uniform(random), TAU * uniform(random))
}

/// Uniform in [0, 1), with 53 random bits.
fn uniform(random: &mut Pcg64) -> f64 {
    (random.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
}

/// x on Π at the visits of one orbit after its transient.
fn long_time_visits(oscillator: &LinearOscillator, setting: &Setting, random: &mut Pcg64) -> Vec<f64> {
    let plan = &setting.figure.attractor;
    let period = oscillator.forcing_period();
    let transient = f64::from(plan.transient) * period;
    let horizon = transient + f64::from(plan.recorded) * period;
    let mut visits = Vec::new();
    for flight in settled_flights(oscillator, random_start(setting, random), transient, horizon) {
        visits_of(oscillator, &flight, &mut visits);
    }
    visits
}

/// The free flights of an orbit from the first that begins after the transient.
pub(super) fn settled_flights(
    oscillator: &LinearOscillator,
    from: State,
    transient: f64,
    horizon: f64,
) -> Vec<Flight<LinearMotion>> {
    // No orbit here has more than a few impacts a period; sticking and chattering end it by themselves.
    let impact_limit = 1_000_000;
    Orbit::new(oscillator, from, horizon, impact_limit).filter(|flight| flight.start >= transient).collect()
}

/// The x-values at which a flight meets Π: the iterates of P_global from the virtual point of its recoil for as long as
/// they lie within the flight, and the virtual top beyond the wall with which it ends.
fn visits_of(oscillator: &LinearOscillator, flight: &Flight<LinearMotion>, visits: &mut Vec<f64>) {
    let mut time = 0.0;
    let mut here = Vector2::new(flight.from.position, flight.from.phase);
    if flight.from.velocity != 0.0 {
        let Ok(origin) =
            virtual_map::<_, 1>(oscillator, OnWall::new(flight.from.velocity, flight.from.phase), None)
        else {
            return;
        };
        (time, here) = (origin.time, origin.jet.value);
    }
    let half_period = 0.5 * oscillator.forcing_period();
    while let Ok(next) = global_map::<_, 1>(oscillator, AtRest::new(here[0], here[1]), None) {
        time += next.time;
        // A return time far from the forcing period belongs to a maximum that is not on Π.
        if time >= flight.duration || next.time < half_period {
            break;
        }
        here = next.jet.value;
        visits.push(here[0]);
    }
    if let FlightEnd::Impact(impact) = flight.end
        && let Ok(top) = virtual_map::<_, 1>(oscillator, OnWall::new(impact.velocity, impact.phase), None)
    {
        visits.push(top.jet.value[0]);
    }
}
