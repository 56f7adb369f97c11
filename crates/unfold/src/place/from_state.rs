//! Motion from a given state, as rows.

use grazing_model::orbit::OrbitEnd;
use grazing_model::phase::centred;
use grazing_model::{ImpactOscillator, State};
use grazing_results::Dimensioned;
use grazing_results::place::{MotionFromState, SimulatedImpact, SimulatedMotion};

use super::rows::wall;
use crate::described::Prepared;
use crate::long_time::Trajectory;

/// The greatest number of impacts per forcing period of motion from a given state.
const MOST_IMPACTS: f64 = 1000.0;

/// Motion of an oscillator at a place, from a position, velocity and time, over a number of forcing
/// periods.
///
/// # Errors
/// An explanation in words why there is no such motion.
pub fn simulated(
    of: &Prepared,
    at: [f64; 2],
    [x, y, time]: [f64; 3],
    periods: f64,
) -> Result<MotionFromState, String> {
    let (here, units) = (of.oscillator.with_parameters(of.without_dimensions(at)), of.axes.units);
    let frequency = here.forcing_frequency().value;
    if !(frequency > 0.0 && frequency.is_finite()) {
        let frequency = frequency / units.time;
        return Err(format!("the forcing frequency is {frequency} at this place; it must be positive"));
    }
    if !(x <= 0.0 && [x, y, time, periods].iter().all(|number| number.is_finite()) && periods > 0.0) {
        return Err(format!(
            "motion from x = {x}, v = {y} at t = {time} for {periods} forcing periods: all must be finite numbers, x (measured from the wall) at most 0, and the number of periods positive"
        ));
    }
    let (length, velocity, begin) = (units.length, units.velocity(), time / units.time);
    let from = State { position: x / length, velocity: y / velocity, phase: frequency * begin };
    let [beyond, _] = here.gap(from.phase);
    if from.position < -beyond.value {
        let other = -beyond.value * length;
        return Err(format!(
            "motion from x = {x} at t = {time}: the other wall is at x = {other} then, and the motion is between the walls"
        ));
    }
    let impacts = libm::ceil(MOST_IMPACTS * periods) as usize;
    let found = Trajectory::follow(&here, from, begin, (periods * here.forcing_period(), impacts));
    let point = |(flight, points): (u32, &Vec<[f64; 3]>)| {
        let point = move |&[time, x, y]: &[f64; 3]| SimulatedMotion { flight, time, x, y };
        points.iter().map(point).collect::<Vec<_>>()
    };
    let impact = |(&[time, phase, impact_velocity], stop): (&[f64; 3], &usize)| {
        let impact_phase = centred(phase);
        SimulatedImpact { time, wall: wall(*stop), impact_phase, impact_velocity }
    };
    let end = match found.end {
        OrbitEnd::TimeIsUp(end) if end.position.is_finite() => "the time is over".to_owned(),
        OrbitEnd::TimeIsUp(_) => "it cannot be followed".to_owned(),
        OrbitEnd::Resting { rest, held } => {
            let at = (begin + rest.start) * units.time;
            let then =
                if held { ", where the force holds it for whole periods" } else { "; the time is over" };
            format!("it comes to rest at the wall at t = {at}{then}")
        }
        OrbitEnd::TooManyImpacts { impacts, .. } => format!("there are more than {impacts} impacts"),
    };
    let motion = (1..).zip(&found.flights).flat_map(point).collect();
    let impacts = found.impacts.iter().zip(&found.stops).map(impact).collect();
    Ok(MotionFromState { motion, impacts, end }.with_dimensions(&units))
}
