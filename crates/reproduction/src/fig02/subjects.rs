//! What the phase portraits show: solutions at the amplitudes that the file asks for, or where they exist.

use grazing_model::{LinearOscillator, State};
use grazing_unfold::one_parameter::Branch;

use super::Setting;
use crate::StudyError;
use crate::parameters::{MOST_PORTRAITS, Portrait};

/// The part of a stretch, at either end, in which no portrait is put by itself: close to a bifurcation an orbit is hardly told
/// from the one it is born with.
const EDGE: f64 = 0.05;

/// An orbit that is shown.
pub(super) struct Subject {
    /// Its loops; 0 is the non-impacting solution, or the attractor above the grazing amplitude.
    pub(super) loops: u32,
    /// Its forcing amplitude.
    pub(super) amplitude: f64,
    /// The recoil of a maximal periodic solution.
    pub(super) recoil: Option<State>,
}

/// All subjects, and what is shown elsewhere than asked for, or not at all, in sentences.
pub(super) fn all(
    setting: &Setting,
    branches: &[Branch<LinearOscillator>],
) -> Result<(Vec<Subject>, Vec<String>), StudyError> {
    let asked = &setting.figure.portraits;
    if asked.is_empty() {
        return Ok((chosen(setting, branches), Vec::new()));
    }
    let (mut subjects, mut notes) = (Vec::new(), Vec::new());
    for portrait in asked {
        let Portrait { loops, amplitude: wish, must, key, .. } = portrait;
        match found(setting, branches, portrait) {
            Some(subject) => {
                if !must && wish.is_some_and(|wish| wish != subject.amplitude) {
                    let amplitude = subject.amplitude;
                    notes.push(format!(
                        "{key}: the portrait of p = {loops} is at {amplitude:.5}, where it exists"
                    ));
                }
                subjects.push(subject);
            }
            None if *must => return Err(missing(branches, portrait)),
            None => notes.push(format!(
                "{key}: no such portrait, as no {loops}-loop solution is stable and admissible at the amplitudes of Figure 2"
            )),
        }
    }
    // There is always a non-impacting solution.
    if subjects.is_empty() { Ok((chosen(setting, branches), notes)) } else { Ok((subjects, notes)) }
}

/// The non-impacting solution, and each p that is somewhere stable, from left to right.
fn chosen(setting: &Setting, branches: &[Branch<LinearOscillator>]) -> Vec<Subject> {
    let mut subjects = vec![non_impacting(setting, None)];
    for &loops in setting.figure.loops.iter().take(MOST_PORTRAITS - 1) {
        subjects.extend(nearest(branches, loops, None));
    }
    subjects.sort_by(|a, b| a.amplitude.total_cmp(&b.amplitude));
    subjects
}

/// What the file asks for, if it exists.
fn found(setting: &Setting, branches: &[Branch<LinearOscillator>], portrait: &Portrait) -> Option<Subject> {
    let Portrait { loops, amplitude: wish, must, .. } = *portrait;
    if loops == 0 {
        return Some(non_impacting(setting, wish));
    }
    let there = wish.and_then(|amplitude| at(branches, loops, amplitude));
    if must { there } else { there.or_else(|| nearest(branches, loops, wish)) }
}

/// The non-impacting solution or the attractor, at the amplitude or the nearest one in the figure.
fn non_impacting(setting: &Setting, wish: Option<f64>) -> Subject {
    let (window, grazing) = (setting.figure.amplitude, setting.grazing.amplitude());
    let amplitude = match wish {
        Some(wish) => wish.clamp(window[0], window[1]),
        None => 0.5 * (window[0] + grazing),
    };
    Subject { loops: 0, amplitude, recoil: None }
}

/// The stable admissible MPS at the amplitude that is nearest to the wish, or in the middle of the widest stretch.
fn nearest(branches: &[Branch<LinearOscillator>], loops: u32, wish: Option<f64>) -> Option<Subject> {
    let inner = |[low, high]: [f64; 2]| [low + EDGE * (high - low), high - EDGE * (high - low)];
    let mut places: Vec<(f64, f64)> = of(branches, loops)
        .flat_map(Branch::stable_stretches)
        .map(|stretch| {
            let [low, high] = inner(stretch);
            match wish {
                Some(wish) => ((wish - wish.clamp(low, high)).abs(), wish.clamp(low, high)),
                None => (low - high, 0.5 * (low + high)),
            }
        })
        .collect();
    places.sort_by(|a, b| a.0.total_cmp(&b.0));
    places.into_iter().find_map(|(_, amplitude)| at(branches, loops, amplitude))
}

/// The branches of p-loop MPSs.
fn of(branches: &[Branch<LinearOscillator>], loops: u32) -> impl Iterator<Item = &Branch<LinearOscillator>> {
    branches.iter().filter(move |branch| branch.equations.loops() == loops)
}

fn missing(branches: &[Branch<LinearOscillator>], portrait: &Portrait) -> StudyError {
    let ranges: Vec<String> = of(branches, portrait.loops)
        .flat_map(Branch::stable_stretches)
        .map(|[low, high]| format!("from {low:.5} to {high:.5}"))
        .collect();
    let remedy = if ranges.is_empty() {
        "none is at the amplitudes of Figure 2, so leave the portrait out or show other loops".to_owned()
    } else {
        format!("there is one {}", ranges.join(", "))
    };
    let Portrait { key, loops, .. } = portrait;
    StudyError::NoPortrait(format!(
        "{key}: no stable admissible {loops}-loop solution is there for a phase portrait; {remedy}"
    ))
}

/// The stable admissible MPS at the amplitude.
fn at(branches: &[Branch<LinearOscillator>], loops: u32, amplitude: f64) -> Option<Subject> {
    of(branches, loops).find_map(|branch| {
        let point = branch.stable_at(amplitude).into_iter().next()?;
        Some(Subject { loops, amplitude, recoil: Some(branch.equations.recoil(&point)) })
    })
}
