//! What orbits come to: outcomes, those that differ, and the loop over many starts.

use grazing_model::motion::Motion;
use grazing_model::{AnyOscillator, ImpactOscillator, State};

use crate::long_time::{Fate, Horizon, LongOrbit, MotionKind, Patience, Strike};
use crate::parallel;
use crate::progress::Progress;
use crate::settled::{Recurring, near};
use crate::tolerances::BETWEEN_ORBITS;

/// The orbit from a state; its exponent is judged if the horizon allows.
pub(super) fn long_orbit(oscillator: &AnyOscillator, start: State, horizon: Horizon) -> LongOrbit {
    let orbit = LongOrbit::follow(oscillator, start, horizon);
    if horizon.patience == Patience::Unsettled { orbit.judged(oscillator) } else { orbit }
}

/// The properties of an orbit from a state that are compared with those of others.
pub(super) struct OrbitOutcome {
    pub(super) start: State,
    /// A later state of the same motion, if it can be followed.
    pub(super) late: State,
    pub(super) fate: Fate,
    pub(super) impacts: Vec<Strike>,
    /// The stop at which the orbit rests for good.
    resting: Option<usize>,
    /// The cycle with impacts on which the orbit has settled.
    pub(super) near: Option<Recurring>,
    /// The state at phase zero of motion without impacts, and its highest point on a cycle.
    pub(super) at_phase_zero: Option<State>,
    pub(super) highest: f64,
}

impl OrbitOutcome {
    pub(super) fn of(oscillator: &AnyOscillator, start: State, horizon: Horizon) -> Self {
        Self::at_end(oscillator, start, &long_orbit(oscillator, start, horizon))
    }

    /// The outcome of motion that may not have settled, which need not be judged.
    pub(super) fn at_last(oscillator: &AnyOscillator, start: State, horizon: Horizon) -> Self {
        Self::at_end(oscillator, start, &LongOrbit::follow(oscillator, start, horizon))
    }

    pub(super) fn at_end(oscillator: &AnyOscillator, start: State, orbit: &LongOrbit) -> Self {
        let at_phase_zero = orbit.at_phase_zero(oscillator);
        // A motion without maxima stays where it is.
        let highest = orbit.cycle.map_or(f64::NAN, |cycle| {
            let motion = oscillator.motion(cycle.from);
            let top = motion.highest_maximum(f64::from(cycle.periods) * oscillator.forcing_period());
            top.map_or(cycle.from.position, |top| top.position)
        });
        let late = orbit.end.unwrap_or(start);
        let (near, impacts) = (near(oscillator, orbit), orbit.impacts.clone());
        let resting = orbit.at_rest.map(|rest| rest.stop);
        Self { start, late, fate: orbit.fate, impacts, resting, near, at_phase_zero, highest }
    }

    /// Whether the outcome looks like another one.
    pub(super) fn is_like(&self, other: &Self) -> bool {
        let cycle = |fate: &Fate| fate.periods.map(|periods| (periods, fate.rests));
        let (a, b) = (&self.fate, &other.fate);
        if (a.kind, cycle(a)) != (b.kind, cycle(b)) {
            return false;
        }
        match a.kind {
            MotionKind::Periodic => {
                // The last impact is the one that is nearest to the cycle.
                other.impacts.last().is_some_and(|last| {
                    self.impacts.iter().any(|impact| impact.is_like(BETWEEN_ORBITS, last))
                })
            }
            MotionKind::Resting => self.resting == other.resting,
            MotionKind::NonImpacting => (self.highest - other.highest).abs() < BETWEEN_ORBITS,
            _ => true,
        }
    }
}

/// The outcomes that differ, and the number of random states that lead to each.
pub(super) struct KnownOutcomes {
    pub(super) different: Vec<(u32, OrbitOutcome)>,
}

impl KnownOutcomes {
    /// The index of an outcome that is known.
    pub(super) fn index(&self, outcome: &OrbitOutcome) -> Option<usize> {
        self.different.iter().position(|(_, known)| known.is_like(outcome))
    }

    /// Adds an outcome of some random states, and returns its index.
    pub(super) fn add(&mut self, states: u32, outcome: OrbitOutcome) -> usize {
        match self.index(&outcome) {
            Some(index) => {
                self.different[index].0 += states;
                index
            }
            None => {
                self.different.push((states, outcome));
                self.different.len() - 1
            }
        }
    }

    /// The index of irregular motion.
    pub(super) fn irregular(&self) -> Option<usize> {
        self.different.iter().position(|(_, known)| is_irregular(known.fate.kind))
    }
}

pub(super) const fn is_irregular(kind: MotionKind) -> bool {
    matches!(kind, MotionKind::Chaotic | MotionKind::Unsettled)
}

/// Applies a function to each of some items in parallel, as steps of a stage; `None` if the
/// computation was cancelled.
pub(super) fn each<T: Sync, R: Send>(
    stage: &str,
    items: &[T],
    progress: &dyn Progress,
    of: impl Fn(&T) -> R + Sync,
) -> Option<Vec<R>> {
    let one = |item: &T| {
        let done = (!progress.stopped()).then(|| of(item));
        progress.step(stage);
        done
    };
    if items.is_empty() {
        return Some(Vec::new());
    }
    let all = || parallel::map(items, one).into_iter().collect::<Option<Vec<R>>>();
    progress.during(stage, items.len() as u64, all).filter(|_| !progress.stopped())
}
