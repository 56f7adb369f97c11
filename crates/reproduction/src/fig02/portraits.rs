//! Phase portraits: periodic orbits, and the attractor where the non-impacting solution is none.

use grazing_model::orbit::Flight;
use grazing_model::smooth::Units;
use grazing_model::{ImpactOscillator, LinearOscillator};
use grazing_results::branches::PortraitPoint;
use grazing_unfold::one_parameter::{
    ATTRACTOR_PERIODS, Branch, Portrait, Settled, drifts, random_start, sampled, settled,
};
use rand_pcg::Pcg64;

use super::Setting;
use super::subjects::{self, Subject};
use crate::StudyError;
use crate::one_parameter::orbit;

/// The portraits, orbit by orbit; and what is shown elsewhere than asked for, or not at all, in sentences.
pub(super) fn rows(
    setting: &Setting,
    branches: &[Branch<LinearOscillator>],
) -> Result<(Vec<PortraitPoint>, Vec<String>), StudyError> {
    let mut rows = Vec::new();
    let (subjects, mut notes) = subjects::all(setting, branches)?;
    let mut number = 1;
    for subject in &subjects {
        if let Some(portrait) = portrait(setting, number, subject)? {
            rows.extend(orbit(number, &portrait, &Units::ONE));
            number += 1;
        } else {
            let said = "the orbit comes to rest at the wall, so that there is no portrait of it";
            notes.push(format!("amplitude {}: {said}", subject.amplitude));
        }
    }
    Ok((rows, notes))
}

/// The portrait of this number, unless its orbit ends before the transient does.
fn portrait(setting: &Setting, number: u32, subject: &Subject) -> Result<Option<Portrait>, StudyError> {
    let Subject { loops, amplitude, recoil } = *subject;
    let oscillator = setting.oscillator(amplitude)?;
    let period = oscillator.forcing_period();
    let attractor = recoil.is_none() && amplitude > setting.grazing.amplitude();
    let flights = if attractor {
        let plan = &setting.figure.attractor;
        let mut random = Pcg64::new(u128::from(plan.seed), u128::from(number) << 64);
        let start = random_start(setting.lowest(), &mut random);
        let periods = [plan.transient, ATTRACTOR_PERIODS];
        let Settled::Impacts(flights) = settled(&oscillator, start, periods, drifts) else {
            return Ok(None);
        };
        let shown = |flight: &Flight<_>| sampled(&flight.motion, flight.start, flight.duration, period);
        flights.iter().map(shown).collect()
    } else {
        let periods = f64::from(loops.max(1));
        let top = || oscillator.non_impacting_solution(setting.grazing.phase());
        let motion = oscillator.motion(recoil.unwrap_or_else(top));
        vec![sampled(&motion, 0.0, periods * period, period)]
    };
    Ok(Some(Portrait { loops, primary: amplitude, attractor, flights }))
}
