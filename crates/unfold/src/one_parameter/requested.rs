//! One-parameter diagrams of an oscillator from a text file.

use core::f64::consts::TAU;

use grazing_input::Description;
use grazing_model::smooth::{SmoothOscillator, Stop};
use grazing_results::Dimensioned;
use grazing_results::branches::OneParameter;
use grazing_results::readings::{MotionReading, Ordinate, Reading};

use super::{Cut, Line, Sampling, Subject};
use crate::curves::DiagramCurve;
use crate::described::Prepared;
use crate::progress::Progress;
use crate::unfinished::Unfinished;

/// Sampling of long-term behaviour: at as many parameter values as a figure can resolve as columns of
/// dots, after a transient that is longer where damping is weak.
pub const SAMPLING: Sampling = Sampling {
    values: 240,
    between: None,
    orbits: 2,
    transient: 150,
    recorded: 24,
    lowest: None,
    seed: 1,
    readings: false,
    impacts: 1,
};

/// Fills in the quantities that depend on the mass, in the oscillator's own units.
fn weigh(found: &mut OneParameter, description: &Description) {
    let walls: Vec<Description> = description.from_each_wall().collect();
    let impact = |wall: u32, velocity: f64, phase: f64, parameters| {
        let seen = &walls[(wall.max(1) as usize - 1).min(walls.len() - 1)];
        // Without an impact there is no phase, and its value does not matter.
        seen.impulse_and_loss([velocity, if phase.is_nan() { 0.0 } else { phase }], parameters)
    };
    let period = |[mu, eta]: [f64; 2]| TAU / description.forcing_frequency(mu, eta);
    let mut strands: Vec<&mut [Reading]> = found.readings.chunk_by_mut(|a, b| a.branch == b.branch).collect();
    // The strands of the impacts of one solution follow each other.
    let mut rest = &mut strands[..];
    while let Some(count) = rest.first().map(|strand| strand[0].impacts.max(1) as usize) {
        let (own, others) = rest.split_at_mut(count.min(rest.len()));
        for point in 0..own[0].len() {
            let mut sum = [0.0; 2];
            for row in own.iter_mut().map(|strand| &mut strand[point]) {
                let [impulse, loss] =
                    impact(row.wall, row.impact_velocity, row.impact_phase, [row.primary, row.secondary]);
                row.impulse = impulse;
                sum = [sum[0] + impulse, sum[1] + loss];
            }
            for row in own.iter_mut().map(|strand| &mut strand[point]) {
                let time = f64::from(row.loops.max(1)) * period([row.primary, row.secondary]);
                (row.force, row.power) = (sum[0] / time, sum[1] / time);
            }
        }
        rest = others;
    }
    let same = |a: &MotionReading, b: &MotionReading| {
        (a.sweep, a.orbit, a.primary, a.secondary) == (b.sweep, b.orbit, b.primary, b.secondary)
    };
    for orbit in found.motion.chunk_by_mut(same) {
        let MotionReading { primary, secondary, impacts, rests, periods, .. } = orbit[0];
        let parameters = [primary, secondary];
        // Where impacts accumulate, those that have rows are of one cycle, and the others weigh nothing.
        let cycles = if impacts.is_finite() { impacts / orbit.len() as f64 } else { 1.0 / periods };
        let rate = cycles / period(parameters);
        let mut sum = [0.0; 2];
        for row in orbit.iter_mut() {
            let [impulse, loss] = impact(row.wall, row.impact_velocity, row.impact_phase, parameters);
            row.impulse = impulse;
            sum = [sum[0] + impulse, sum[1] + loss];
        }
        // At rest the wall bears a force that is no impulse.
        let force = if rests > 0.0 { f64::NAN } else { sum[0] * rate };
        orbit.iter_mut().for_each(|row| (row.force, row.power) = (force, sum[1] * rate));
    }
}

/// A diagram in the oscillator's own units with this ordinate and the quantities that depend on the mass;
/// without readings the ordinate is x.
pub fn in_own_units(found: OneParameter, ordinate: Ordinate, description: &Description) -> OneParameter {
    let ordinate = if found.readings.is_empty() { Ordinate::X } else { ordinate };
    let from_the_wall = !description.wall().is_usual();
    let mut found = OneParameter { ordinate, from_the_wall, ..found }.with_dimensions(&description.units());
    weigh(&mut found, description);
    found
}

/// The one-parameter diagrams that a file requests, in the oscillator's own units, and a list of missing
/// parts.
pub(crate) fn diagrams(
    description: &Description,
    curves: &[DiagramCurve],
    stop: &Stop,
    progress: &dyn Progress,
) -> (Vec<OneParameter>, Vec<Unfinished>) {
    let (mut diagrams, mut unfinished) = (Vec::new(), Vec::new());
    let units = description.units();
    let Prepared { oscillator, scope, .. } = Prepared::of(description, stop);
    for (diagram, setting) in (1..).zip(description.diagrams()) {
        let &grazing_input::OneParameterRequest {
            primary_is_fixed,
            at,
            range,
            seed,
            sweeps,
            ordinate,
            impacts,
            ..
        } = setting;
        let line = Line { diagram, primary_is_fixed, at, range }.without_dimensions(&units);
        let unit = if primary_is_fixed { units.secondary } else { units.primary };
        let subject = |across: &f64| Subject { across: across / unit, loops: None };
        let subjects: Vec<Subject> = setting.portraits.iter().map(subject).collect();
        let readings = sweeps || ordinate != Ordinate::X;
        let sampling = Sampling { seed, readings, impacts, ..SAMPLING };
        let cut = Cut::follow(&oscillator, &scope, curves, line, progress);
        let found = cut.map(|mut cut| {
            let mut found = cut.simulated(&sampling, &subjects, progress);
            if readings {
                found.readings = cut.readings();
            }
            if sweeps {
                let (rows, orbits) = cut.sweeps(&sampling, progress);
                found.motion.extend(rows);
                found.simulated = found.simulated.map(|known| known.plus(orbits));
            }
            in_own_units(if progress.stopped() { cut.diagram() } else { found }, ordinate, description)
        });
        let missing = match &found {
            None => Some(format!("one-parameter diagram {diagram}")),
            Some(found) if found.simulated.is_none() => {
                Some(format!("attractors and phase portraits of one-parameter diagram {diagram}"))
            }
            Some(_) => None,
        };
        unfinished.extend(missing.map(Unfinished::stage));
        diagrams.extend(found);
    }
    (diagrams, unfinished)
}
