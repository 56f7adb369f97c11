//! Phase portraits: periodic orbits, and the attractor where the non-impacting solution is none.

use grazing_model::motion::Motion;
use grazing_model::orbit::Flight;
use grazing_model::{ImpactOscillator, LinearMotion};
use grazing_results::branches::{PortraitKind, PortraitPoint};
use rand_pcg::Pcg64;

use super::branches::Branch;
use super::subjects::{self, Subject};
use super::{Setting, attractor};
use crate::StudyError;

/// Samples of an orbit per forcing period.
const SAMPLES: f64 = 200.0;

/// Forcing periods of an attractor that is not periodic.
const ATTRACTOR_PERIODS: f64 = 40.0;

/// The free flights of each orbit, sampled in time, an empty row after each flight; and what is shown
/// elsewhere than asked for, or not at all, in sentences.
pub(super) fn rows(
    setting: &Setting,
    branches: &[Branch],
) -> Result<(Vec<PortraitPoint>, Vec<String>), StudyError> {
    let mut rows = Vec::new();
    let (subjects, mut notes) = subjects::all(setting, branches)?;
    let mut number = 0;
    for subject in &subjects {
        if draw(setting, number + 1, subject, &mut rows)? {
            number += 1;
        } else {
            let said = "the orbit comes to rest at the wall, so that there is no portrait of it";
            notes.push(format!("amplitude {}: {said}", subject.amplitude));
        }
    }
    Ok((rows, notes))
}

/// Draws a portrait, unless its orbit ends before the transient does.
fn draw(
    setting: &Setting,
    number: u32,
    subject: &Subject,
    rows: &mut Vec<PortraitPoint>,
) -> Result<bool, StudyError> {
    let Subject { loops, amplitude, recoil } = *subject;
    let oscillator = setting.oscillator(amplitude)?;
    let period = oscillator.forcing_period();
    let mut sample = |kind, start: f64, motion: &LinearMotion, duration: f64| {
        let at = |time, x, y| PortraitPoint { portrait: number, loops, primary: amplitude, kind, time, x, y };
        let steps = libm::ceil(SAMPLES * duration / period);
        for k in 0..=steps as u32 {
            let time = duration * f64::from(k) / steps;
            let here = motion.at(time);
            rows.push(at(start + time, here.position, here.velocity));
        }
        rows.push(at(f64::NAN, f64::NAN, f64::NAN));
    };
    if let Some(recoil) = recoil {
        sample(PortraitKind::Periodic, 0.0, &oscillator.motion(recoil), f64::from(loops) * period);
    } else if amplitude <= setting.grazing.amplitude() {
        let top = oscillator.non_impacting_solution(setting.grazing.phase());
        sample(PortraitKind::Periodic, 0.0, &oscillator.motion(top), period);
    } else {
        let plan = &setting.figure.attractor;
        let mut random = Pcg64::new(u128::from(plan.seed), u128::from(number) << 64);
        let transient = f64::from(plan.transient) * period;
        let horizon = transient + ATTRACTOR_PERIODS * period;
        let start = attractor::random_start(setting, &mut random);
        let flights = attractor::settled_flights(&oscillator, start, transient, horizon);
        for Flight { start, motion, duration, .. } in &flights {
            sample(PortraitKind::Attractor, start - transient, motion, *duration);
        }
        return Ok(!flights.is_empty());
    }
    Ok(true)
}
