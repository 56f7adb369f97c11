//! Phase portraits: periodic orbits, and the attractor where the non-impacting solution is none.

use grazing_model::orbit::Flight;
use grazing_model::{ImpactOscillator, LinearOscillator};
use grazing_results::branches::{PortraitKind, PortraitPoint};
use grazing_unfold::one_parameter::{ATTRACTOR_PERIODS, Branch, Settled, random_start, sampled, settled};
use rand_pcg::Pcg64;

use super::subjects::{self, Subject};
use super::{Setting, attractor};
use crate::StudyError;

/// The free flights of each orbit, sampled in time, an empty row after each flight; and what is shown
/// elsewhere than asked for, or not at all, in sentences.
pub(super) fn rows(
    setting: &Setting,
    branches: &[Branch<LinearOscillator>],
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
    let mut flight = |kind, samples: Vec<[f64; 3]>| {
        let row = |[time, x, y]: [f64; 3]| PortraitPoint {
            portrait: number,
            loops,
            primary: amplitude,
            kind,
            time,
            x,
            y,
        };
        rows.extend(samples.into_iter().chain([[f64::NAN; 3]]).map(row));
    };
    if let Some(recoil) = recoil {
        let motion = oscillator.motion(recoil);
        flight(PortraitKind::Periodic, sampled(&motion, 0.0, f64::from(loops) * period, period));
    } else if amplitude <= setting.grazing.amplitude() {
        let top = oscillator.non_impacting_solution(setting.grazing.phase());
        flight(PortraitKind::Periodic, sampled(&oscillator.motion(top), 0.0, period, period));
    } else {
        let plan = &setting.figure.attractor;
        let mut random = Pcg64::new(u128::from(plan.seed), u128::from(number) << 64);
        let start = random_start(attractor::lowest(setting), &mut random);
        let Settled::Impacts(flights) = settled(&oscillator, start, [plan.transient, ATTRACTOR_PERIODS])
        else {
            return Ok(false);
        };
        let transient = f64::from(plan.transient) * period;
        for Flight { start, motion, duration, .. } in &flights {
            flight(PortraitKind::Attractor, sampled(motion, start - transient, *duration, period));
        }
    }
    Ok(true)
}
