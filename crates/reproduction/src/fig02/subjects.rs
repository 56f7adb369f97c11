//! What the phase portraits of Figure 2 show: solutions at the amplitudes that the file asks for,
//! or where they exist.

use grazing_unfold::one_parameter::{Branch, Subject};

use crate::StudyError;
use crate::parameters::{Figure2, MOST_PORTRAITS, Portrait};

/// The part of a stretch, at either end, in which no portrait is put by itself: close to a
/// bifurcation an orbit is hardly told from the one it is born with.
const EDGE: f64 = 0.05;

/// All subjects, and what is shown elsewhere than asked for, or not at all, in sentences.
pub(super) fn all(
    figure: &Figure2,
    grazing: f64,
    branches: &[Branch],
) -> Result<(Vec<Subject>, Vec<String>), StudyError> {
    let asked = &figure.portraits;
    if asked.is_empty() {
        return Ok((chosen(figure, grazing, branches), Vec::new()));
    }
    let (mut subjects, mut notes) = (Vec::new(), Vec::new());
    for portrait in asked {
        let Portrait { loops, amplitude: wish, must, key, .. } = portrait;
        match found(figure, grazing, branches, portrait) {
            Some(subject) => {
                let amplitude = subject.across;
                if !must && wish.is_some_and(|wish| wish != amplitude) {
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
    if subjects.is_empty() { Ok((chosen(figure, grazing, branches), notes)) } else { Ok((subjects, notes)) }
}

/// The non-impacting solution, and each p that is somewhere stable, from left to right.
fn chosen(figure: &Figure2, grazing: f64, branches: &[Branch]) -> Vec<Subject> {
    let mut subjects = vec![non_impacting(figure, grazing, None)];
    for &loops in figure.loops.iter().take(MOST_PORTRAITS - 1) {
        subjects.extend(nearest(branches, loops, None));
    }
    subjects.sort_by(|a, b| a.across.total_cmp(&b.across));
    subjects
}

/// What the file asks for, if it exists.
fn found(figure: &Figure2, grazing: f64, branches: &[Branch], portrait: &Portrait) -> Option<Subject> {
    let Portrait { loops, amplitude: wish, must, .. } = *portrait;
    if loops == 0 {
        return Some(non_impacting(figure, grazing, wish));
    }
    let there = wish.and_then(|amplitude| at(branches, loops, amplitude));
    if must { there } else { there.or_else(|| nearest(branches, loops, wish)) }
}

/// The non-impacting solution or the attractor, at the amplitude or the nearest one in the figure.
fn non_impacting(figure: &Figure2, grazing: f64, wish: Option<f64>) -> Subject {
    let window = figure.amplitude;
    let across = match wish {
        Some(wish) => wish.clamp(window[0], window[1]),
        None => 0.5 * (window[0] + grazing),
    };
    Subject { across, loops: Some(0) }
}

/// The stable admissible MPS at the amplitude that is nearest to the wish, or in the middle of the
/// widest stretch.
fn nearest(branches: &[Branch], loops: u32, wish: Option<f64>) -> Option<Subject> {
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
fn of(branches: &[Branch], loops: u32) -> impl Iterator<Item = &Branch> {
    branches.iter().filter(move |branch| branch.equations.loops() == loops)
}

fn missing(branches: &[Branch], portrait: &Portrait) -> StudyError {
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
fn at(branches: &[Branch], loops: u32, across: f64) -> Option<Subject> {
    let there = of(branches, loops).any(|branch| !branch.stable_at(across).is_empty());
    there.then_some(Subject { across, loops: Some(loops) })
}
