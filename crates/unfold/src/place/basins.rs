//! Basins of attraction: what the states of a lattice come to.

use grazing_model::{AnyOscillator, State};

use super::outcome::{KnownOutcomes, OrbitOutcome, each, is_irregular};
use crate::long_time::{Horizon, MotionKind, Patience};
use crate::progress::Progress;

/// The names of the stages.
const BASINS: &str = "basins of attraction";
const SLOW: &str = "basins of attraction: motion that has not settled";
const IRREGULAR: &str = "basins of attraction: irregular motion";

/// The first horizon for states of the lattice, in which most settle.
const FIRST: Horizon = Horizon { transient: 16, counted: 32, patience: Patience::Drifting, longest: 0 };
/// The number of forcing periods for which a state of the lattice may be followed on average: what
/// those that settle at first leave is there for the others.
const ON_AVERAGE: u32 = 96;
/// The number of states that have not settled by then of which it is seen, within the whole horizon,
/// whether their motion is irregular.
const WITNESSES: usize = 4;

/// The outcomes of the states of a lattice, as indices of known outcomes, to which those that are new
/// are added; `None` for states that have not settled. `None` if the computation was cancelled.
///
/// All are followed for a short time, and those that have not settled for as long as the whole lattice
/// may take. What has not settled then is irregular motion if that of some of these states is so for
/// the whole horizon, and undecided if any of them settles.
pub(super) fn basins(
    oscillator: &AnyOscillator,
    lattice: &[State],
    horizon: Horizon,
    known: &mut KnownOutcomes,
    progress: &dyn Progress,
) -> Option<Vec<(State, Option<usize>)>> {
    let outcome = |from: State, horizon| OrbitOutcome::of(oscillator, from, horizon);
    let first = each(BASINS, lattice, progress, |&from| outcome(from, FIRST))?;
    let mut indices: Vec<Option<usize>> = vec![None; lattice.len()];
    let mut rest: Vec<(usize, State)> = Vec::new();
    let mut take = |place: usize,
                    outcome: OrbitOutcome,
                    known: &mut KnownOutcomes,
                    rest: &mut Vec<(usize, State)>| match outcome.fate.kind {
        MotionKind::Unsettled => rest.push((place, outcome.late)),
        _ => indices[place] = Some(known.add(0, outcome)),
    };
    for (place, outcome) in first.into_iter().enumerate() {
        take(place, outcome, known, &mut rest);
    }
    let spent = FIRST.transient + FIRST.counted;
    let left = u64::from(ON_AVERAGE - spent) * lattice.len() as u64;
    let longest = left.checked_div(rest.len() as u64).unwrap_or(0).min(horizon.longest.into()) as u32;
    let on = Horizon { transient: spent, longest, patience: Patience::Unsettled, ..FIRST };
    let unsettled = core::mem::take(&mut rest);
    let later = each(SLOW, &unsettled, progress, |&(_, from)| OrbitOutcome::at_last(oscillator, from, on))?;
    for ((place, _), outcome) in unsettled.into_iter().zip(later) {
        take(place, outcome, known, &mut rest);
    }
    let witnesses: Vec<(usize, State)> =
        rest.iter().step_by(rest.len().div_ceil(WITNESSES).max(1)).copied().collect();
    let seen = each(IRREGULAR, &witnesses, progress, |&(_, from)| outcome(from, horizon))?;
    let irregular = seen.iter().all(|one| is_irregular(one.fate.kind));
    for ((place, _), outcome) in witnesses.into_iter().zip(seen) {
        // Irregular motion is not distinguished.
        let index = known.irregular().filter(|_| is_irregular(outcome.fate.kind));
        indices[place] = Some(index.unwrap_or_else(|| known.add(0, outcome)));
    }
    if irregular {
        rest.iter().for_each(|&(place, _)| indices[place] = indices[place].or(known.irregular()));
    }
    Some(lattice.iter().copied().zip(indices).collect())
}
