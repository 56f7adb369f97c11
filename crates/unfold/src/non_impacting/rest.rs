//! Where an oscillator rests in front of the wall.
//!
//! Near its rest position motion relaxes even where attraction at the wall exceeds the spring, as
//! that of adhesion does: from nearer to the wall than some point it falls onto the wall. How far
//! off the rest position is then, the unit of length does not say.

use core::f64::consts::TAU;

use grazing_continuation::regula_falsi::zero_between;
use grazing_model::{AnyOscillator, ImpactOscillator, State};

/// Instants of a forcing period at which the force is looked at.
const INSTANTS: u32 = 16;
/// Rest positions are looked for from the wall out to the last of so many distances, ...
const DISTANCES: u32 = 80;
/// ... of which the first is this one,
const FIRST: f64 = 1.0 / 256.0;
/// and each lies this many times as far off as the one before: from a 256th to some 3500, around a
/// unit of length that is the distance from rest or, where the force is steep at the wall, some
/// thousandth of it.
const RATIO: f64 = 1.19;
/// What lies farther off than this many times the nearest is left out: a pendulum has rest
/// positions without end, which differ in its turns alone.
const REACH: f64 = 4.0;
/// Motion relaxes from beside a rest position as well: where the mean force is this share of what
/// it is around.
const ENOUGH: f64 = 1e-3;

/// The stable rest positions in front of the wall, from there on: where the force at rest, on
/// average over a forcing period, is zero and drives back to there.
pub(super) fn positions(oscillator: &AnyOscillator) -> Vec<f64> {
    let mean = |position: f64| {
        let phases = (0..INSTANTS).map(|k| TAU * f64::from(k) / f64::from(INSTANTS));
        let forces = phases.map(|phase| oscillator.acceleration(State::at_rest(position, phase)));
        forces.sum::<f64>() / f64::from(INSTANTS)
    };
    let mut found = Vec::<f64>::new();
    let [mut near, mut at_near] = [0.0, mean(0.0)];
    let mut far = -FIRST;
    for _ in 0..DISTANCES {
        if found.first().is_some_and(|nearest| far < REACH * nearest) {
            break;
        }
        let at_far = mean(far);
        if at_near < 0.0 && at_far >= 0.0 {
            let at = |share: f64| {
                let position = near + share * (far - near);
                let force = mean(position);
                Ok::<_, core::convert::Infallible>((position, force))
            };
            let enough = |_: &f64, force: f64| force.abs() <= ENOUGH * (at_far - at_near);
            let Ok(position) = zero_between([at_near, at_far], at, enough);
            found.push(position);
        }
        [near, at_near] = [far, at_far];
        far *= RATIO;
    }
    found
}
