//! Long-time behaviour of forward orbits from random initial points.

use core::f64::consts::TAU;

use grazing_model::maps::virtual_map;
use grazing_model::motion::local_maxima;
use grazing_model::orbit::{Flight, FlightEnd, Orbit};
use grazing_model::{ImpactOscillator, LinearMotion, LinearOscillator, State};
use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;
use rayon::prelude::*;

use super::Setting;
use super::branches::Bifurcation;
use crate::StudyError;
use crate::progress::Progress;
use crate::table::{Table, columns, row};

/// `fig02_attractor.csv`: x on Π along orbits after a transient, at amplitudes between GZ and PD.
///
/// Empty if the branches have no GZ or no PD in the window.
pub(super) fn table(
    setting: &Setting,
    bifurcations: &[Bifurcation],
    progress: &dyn Progress,
) -> Result<Table, StudyError> {
    let mut columns = columns! { "amplitude": 0.0, "x": 0.0 };
    let first = |kind| bifurcations.iter().find(|b| b.kind == kind).map(|b| b.amplitude);
    if let (Some(gz), Some(pd)) = (first("GZ"), first("PD")) {
        let plan = setting.parameters.fig02().attractor();
        let what = "long-time behaviour";
        progress.begin(what, u64::from(plan.amplitudes()));
        let amplitude = |k: u32| gz + (pd - gz) * f64::from(k) / f64::from(plan.amplitudes() - 1);
        let samples: Vec<(f64, Vec<f64>)> = (0..plan.amplitudes())
            .into_par_iter()
            .map(|k| {
                let oscillator = setting.oscillator(amplitude(k))?;
                let mut random = Pcg64::new(u128::from(plan.seed()), u128::from(k));
                let mut visits = Vec::new();
                for _ in 0..plan.orbits() {
                    visits.extend(long_time_visits(&oscillator, setting, &mut random));
                }
                progress.step(what);
                Ok((amplitude(k), visits))
            })
            .collect::<Result<_, StudyError>>()?;
        progress.end(what);
        for (amplitude, visits) in samples {
            for x in visits {
                columns.push(row![amplitude, x]);
            }
        }
    }
    Ok(columns.finish("fig02_attractor")?)
}

/// A random point of Π: x uniform between the lower edge of the figure and the wall, the phase uniform.
pub(super) fn random_start(setting: &Setting, random: &mut Pcg64) -> State {
    let lowest = setting.parameters.fig02().x().lower().min(0.0);
    State::at_rest(lowest * uniform(random), TAU * uniform(random))
}

/// Uniform in [0, 1), with 53 random bits.
fn uniform(random: &mut Pcg64) -> f64 {
    (random.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
}

/// x on Π at the visits of one orbit after its transient.
fn long_time_visits(oscillator: &LinearOscillator, setting: &Setting, random: &mut Pcg64) -> Vec<f64> {
    let plan = setting.parameters.fig02().attractor();
    let period = oscillator.forcing_period();
    let transient = f64::from(plan.transient()) * period;
    let horizon = transient + f64::from(plan.recorded()) * period;
    let mut visits = Vec::new();
    for flight in settled_flights(oscillator, random_start(setting, random), transient, horizon) {
        visits_of(oscillator, setting.grazing.phase(), &flight, &mut visits);
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

/// The x-values at which a flight meets Π: its maxima, the one cut off by the wall continued to its virtual top.
///
/// Π is the part of y = 0 within a quarter turn of the grazing phase.
fn visits_of(
    oscillator: &LinearOscillator,
    grazing_phase: f64,
    flight: &Flight<LinearMotion>,
    visits: &mut Vec<f64>,
) {
    let frequency = oscillator.forcing_frequency().value;
    let on_section = |phase: f64| libm::cos(phase - grazing_phase) > 0.0;
    for maximum in local_maxima(&flight.motion, flight.duration) {
        if on_section(flight.from.phase + frequency * maximum.time) {
            visits.push(maximum.position);
        }
    }
    if let FlightEnd::Impact(impact) = flight.end {
        let top = virtual_map::<_, 1>(oscillator, impact.velocity, impact.phase, None);
        if let Ok(top) = top
            && on_section(top.jet.value[1])
        {
            visits.push(top.jet.value[0]);
        }
    }
}
