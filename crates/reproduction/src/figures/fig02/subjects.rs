//! The subjects of the phase portraits in Figure 2: solutions at the requested amplitudes, or where they
//! exist.

use grazing_unfold::one_parameter::{Branch, Subject};

use super::section::{Figure2, MOST_PORTRAITS, Portrait, Wish};
use crate::StudyError;

/// The part of an interval, at either end, in which no portrait is placed by default: close to a
/// bifurcation an orbit is hardly distinguishable from the one born with it.
const EDGE: f64 = 0.05;

/// All subjects, and sentences about portraits that are elsewhere than requested or missing.
pub(super) fn all(
    figure: &Figure2,
    grazing: f64,
    branches: &[Branch],
) -> Result<(Vec<Subject>, Vec<String>), StudyError> {
    let (mut subjects, mut notes) = (Vec::new(), Vec::new());
    for portrait in &figure.portraits {
        let Portrait { loops, wish, key } = portrait;
        match found(figure, grazing, branches, *loops, *wish) {
            Some(subject) => {
                let amplitude = subject.across;
                if wish.is_some_and(|wish| !wish.must && wish.value != amplitude) {
                    notes.push(format!(
                        "{key}: the portrait of p = {loops} is at {amplitude:.5}, where it exists"
                    ));
                }
                subjects.push(subject);
            }
            None if wish.is_some_and(|wish| wish.must) => return Err(missing(branches, portrait)),
            None => notes.push(format!(
                "{key}: no such portrait, as no {loops}-loop solution is stable and admissible at the amplitudes of Figure 2"
            )),
        }
    }
    if subjects.is_empty() {
        subjects = chosen(figure, grazing, branches);
    }
    Ok((subjects, notes))
}

/// The default subjects: the non-impacting solution, which always exists, and each p with a stable
/// solution somewhere, from left to right.
fn chosen(figure: &Figure2, grazing: f64, branches: &[Branch]) -> Vec<Subject> {
    let loops = std::iter::once(0).chain(figure.loops.iter().copied().take(MOST_PORTRAITS - 1));
    let mut subjects: Vec<_> =
        loops.filter_map(|loops| found(figure, grazing, branches, loops, None)).collect();
    subjects.sort_by(|a, b| a.across.total_cmp(&b.across));
    subjects
}

/// The subject that the file requests, if it exists.
fn found(
    figure: &Figure2,
    grazing: f64,
    branches: &[Branch],
    loops: u32,
    wish: Option<Wish<f64>>,
) -> Option<Subject> {
    let amplitude = wish.map(|wish| wish.value);
    if loops == 0 {
        // The non-impacting solution or the attractor, at that amplitude or the nearest one.
        let [left, right] = figure.across.value;
        let across = amplitude.map_or(0.5 * (left + grazing), |amplitude| amplitude.clamp(left, right));
        return Some(Subject { across, loops: Some(0) });
    }
    let there = amplitude.and_then(|amplitude| at(branches, loops, amplitude));
    match wish {
        Some(Wish { must: true, .. }) => there,
        _ => there.or_else(|| nearest(branches, loops, amplitude)),
    }
}

/// The stable admissible MPS at the amplitude nearest to the requested one, or in the middle of the
/// widest interval.
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
