//! Orbits as curves.

use core::f64::consts::TAU;

use grazing_continuation::mps::{LoopEquations, Unknowns};
use grazing_model::ImpactOscillator;
use grazing_model::motion::Motion;

/// Samples of an orbit per forcing period.
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

/// The flight of an MPS, from its recoil at time `start` to its impact.
pub fn sampled_solution(equations: &LoopEquations, point: &Unknowns, start: f64) -> Vec<[f64; 3]> {
    let oscillator = equations.oscillator_at(point);
    let motion = oscillator.motion(equations.departure(point));
    sampled(&motion, start, equations.flight(point), oscillator.forcing_period())
}

/// The first time from zero on at which the phase is this one.
pub fn time_of_phase(phase: f64, period: f64) -> f64 {
    let turns = phase / TAU;
    (turns - libm::floor(turns)) * period
}
