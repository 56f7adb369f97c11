//! Phase portraits: periodic orbits, and the attractor where the non-impacting solution is none.

use grazing_continuation::locate::{Condition, locate};
use grazing_model::motion::Motion;
use grazing_model::orbit::Flight;
use grazing_model::{ImpactOscillator, LinearMotion, State};
use rand_pcg::Pcg64;

use super::branches::Branch;
use super::{Setting, attractor};
use crate::StudyError;
use crate::parameters::Portrait;
use crate::table::{Columns, Table, columns, row};

/// Samples of an orbit per forcing period.
const SAMPLES: f64 = 200.0;

/// Forcing periods of an attractor that is not periodic.
const ATTRACTOR_PERIODS: f64 = 40.0;

/// `fig02_portraits.csv`: the free flights of each orbit, sampled in time, an empty row after each flight.
pub(super) fn table(setting: &Setting, branches: &[Branch]) -> Result<Table, StudyError> {
    let mut columns = columns! {
        "portrait": 0, "p": 0, "amplitude": 0.0, "kind": "", "time": 0.0, "x": 0.0, "y": 0.0,
    };
    for (number, portrait) in (1..).zip(setting.parameters.fig02().portraits()) {
        draw(setting, branches, number, portrait, &mut columns)?;
    }
    Ok(columns.finish("fig02_portraits")?)
}

fn draw(
    setting: &Setting,
    branches: &[Branch],
    number: u32,
    portrait: &Portrait,
    columns: &mut Columns,
) -> Result<(), StudyError> {
    let (loops, amplitude) = (portrait.loops(), portrait.amplitude());
    let oscillator = setting.oscillator(amplitude)?;
    let period = oscillator.forcing_period();
    let mut sample = |kind: &'static str, start: f64, motion: &LinearMotion, duration: f64| {
        let steps = libm::ceil(SAMPLES * duration / period);
        for k in 0..=steps as u32 {
            let time = duration * f64::from(k) / steps;
            let here = motion.at(time);
            columns.push(row![number, loops, amplitude, kind, start + time, here.position, here.velocity]);
        }
        columns.push(row![number, loops, amplitude, kind, f64::NAN, f64::NAN, f64::NAN]);
    };
    if loops > 0 {
        let recoil = stable_recoil(branches, portrait)?;
        sample("periodic", 0.0, &oscillator.motion(recoil), f64::from(loops) * period);
    } else if amplitude <= setting.grazing.amplitude() {
        let top = oscillator.non_impacting_solution(setting.grazing.phase());
        sample("periodic", 0.0, &oscillator.motion(top), period);
    } else {
        let plan = setting.parameters.fig02().attractor();
        let mut random = Pcg64::new(u128::from(plan.seed()), u128::from(number) << 64);
        let transient = f64::from(plan.transient()) * period;
        let horizon = transient + ATTRACTOR_PERIODS * period;
        let start = attractor::random_start(setting, &mut random);
        for Flight { start, motion, duration, .. } in
            attractor::settled_flights(&oscillator, start, transient, horizon)
        {
            sample("attractor", start - transient, &motion, duration);
        }
    }
    Ok(())
}

/// The recoil state of the stable admissible MPS at the portrait's amplitude.
fn stable_recoil(branches: &[Branch], portrait: &Portrait) -> Result<State, StudyError> {
    let (loops, amplitude) = (portrait.loops(), portrait.amplitude());
    let missing = StudyError::NoPortrait { loops, amplitude };
    for branch in branches.iter().filter(|branch| branch.equations.loops() == loops) {
        for pair in branch.curve.points.windows(2) {
            let [before, after] = [&pair[0].solution, &pair[1].solution];
            let [from, frequency] = before.parameters();
            let brackets = (from - amplitude) * (after.parameters()[0] - amplitude) <= 0.0;
            if !(brackets && (before.stable() || after.stable())) {
                continue;
            }
            let conditions = [Condition::Secondary(frequency), Condition::Primary(amplitude)];
            let mut memory = pair[0].memory.clone();
            let Ok(point) = locate(&branch.equations, conditions, before.unknowns, &mut memory) else {
                continue;
            };
            let (solution, _) = branch.equations.solution(&point);
            if solution.stable() && solution.admissible() {
                return Ok(branch.equations.recoil(&point));
            }
        }
    }
    Err(missing)
}
