//! Compares shaded regions of any oscillator with continuation and simulation, on a lattice of points.

use grazing_continuation::mps::{PeriodicSolution, Unknowns, unknown};
use grazing_input::Description;
use grazing_model::ImpactOscillator;
use grazing_model::smooth::Stop;
use grazing_unfold::described::Prepared;
use grazing_unfold::simulation::Suspect;
use grazing_unfold::{Diagram, Scope, UnfoldError};
use rayon::prelude::*;

use crate::continued::{along, good, near};
use crate::random::Random;
use crate::regions::{Shown, doubts, shown};
use crate::simulation::{Settled, settled};

/// A disagreement between regions, continuation and simulation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Disagreement {
    /// Motion settles on a p-loop solution, or on one without impacts, where nothing is shaded.
    #[error("motion settles where nothing is shaded")]
    SeenUnshaded,
    /// Continuation leads to a stable, admissible MPS where nothing is shaded.
    #[error("a stable solution where nothing is shaded")]
    FoundUnshaded,
    /// The point is shaded, but continuation leads to no stable, admissible MPS.
    #[error("shaded, and no stable solution was found")]
    NotFound,
    /// Simulation that begins near a stable, admissible MPS does not return to it.
    #[error("motion that begins beside a stable solution leaves it")]
    LeavesIt,
}

/// The results on a lattice of points.
#[derive(Clone, Debug, Default)]
pub struct LatticeComparison {
    /// The fraction of the points at which some p is shaded.
    pub shaded: f64,
    /// The fraction of the points at which some p is hatched.
    pub hatched: f64,
    /// The number of times motion settled on a p-loop solution where p is shaded.
    pub seen: usize,
    /// The number of stable, admissible MPSs, over all points and p, to which simulation returns.
    pub confirmed: usize,
    /// The disagreements, each with p and the point.
    pub wrong: Vec<(u32, [f64; 2], Disagreement)>,
    /// The reasons why regions are hatched.
    pub doubts: Vec<String>,
}

impl LatticeComparison {
    /// The number of disagreements of a kind.
    pub fn count(&self, kind: Disagreement) -> usize {
        self.wrong.iter().filter(|(.., found)| *found == kind).count()
    }
}

/// The number of integration steps after which an analysis is stopped; it takes minutes instead of
/// seconds.
const MOST_STEPS: u64 = 200_000_000;

/// The diagram of an oscillator in its own units; regions that take too long are undecided.
///
/// # Errors
/// There is nothing to unfold.
pub fn unfolded(description: &Description) -> Result<Diagram, UnfoldError> {
    let stop = Stop::after(MOST_STEPS);
    let Prepared { oscillator, scope, .. } = Prepared::of(description, &stop);
    let diagram = Diagram::compute(&oscillator, &scope, &stop);
    stop.withdraw();
    diagram
}

/// Compares a diagram with continuation and simulation on a lattice, with `states` random states at each
/// point.
pub fn compare(diagram: &Diagram, lattice: usize, states: u32) -> LatticeComparison {
    let Scope { window, loops, .. } = &diagram.scope;
    let at = |[low, high]: [f64; 2], k: usize| low + (high - low) * (k as f64 + 0.5) / lattice as f64;
    let points: Vec<[f64; 2]> = (0..lattice * lattice)
        .map(|k| [at(window.primary, k % lattice), at(window.secondary, k / lattice)])
        .collect();
    let seen: Vec<Vec<Settled>> = points
        .par_iter()
        .enumerate()
        .map(|(number, point)| {
            let mut random = Random::new(number as u64);
            let here = diagram.oscillator.with_parameters(*point);
            (0..states).filter_map(|_| settled(&here, &mut random)).collect()
        })
        .collect();
    let mut outcome = LatticeComparison { doubts: doubts(diagram), ..LatticeComparison::default() };
    let (mut shaded, mut hatched) = (vec![false; points.len()], vec![false; points.len()]);
    for (&point, here) in points.iter().zip(&seen) {
        let stays_off = here.iter().any(|settled| settled.loops == 0);
        if stays_off && shown(diagram, 0, point) == Shown::White {
            outcome.wrong.push((0, point, Disagreement::SeenUnshaded));
        }
    }
    for &loops in loops {
        let all: Vec<Shown> = points.par_iter().map(|point| shown(diagram, loops, *point)).collect();
        let found = solutions(diagram, loops, &points, &seen, lattice);
        let judged: Vec<(usize, Vec<Disagreement>)> = (0..points.len())
            .into_par_iter()
            .map(|k| judge(diagram, all[k], &found[k], seen[k].iter().any(|seen| seen.loops == loops)))
            .collect();
        for (k, (confirmed, wrong)) in judged.into_iter().enumerate() {
            shaded[k] |= all[k] == Shown::Shaded;
            hatched[k] |= all[k] == Shown::Hatched;
            outcome.confirmed += confirmed;
            let motions = seen[k].iter().filter(|seen| seen.loops == loops).count();
            outcome.seen += if all[k] == Shown::Shaded { motions } else { 0 };
            outcome.wrong.extend(wrong.into_iter().map(|kind| (loops, points[k], kind)));
        }
    }
    let share = |of: &[bool]| of.iter().filter(|is| **is).count() as f64 / points.len() as f64;
    (outcome.shaded, outcome.hatched) = (share(&shaded), share(&hatched));
    outcome
}

/// The stable, admissible MPSs at the points of a lattice: on branches from grazing and from curves, or
/// else near those of neighbouring points or near motion that has settled.
fn solutions(
    diagram: &Diagram,
    loops: u32,
    points: &[[f64; 2]],
    seen: &[Vec<Settled>],
    lattice: usize,
) -> Vec<Vec<PeriodicSolution>> {
    let rows = points.par_chunks(lattice).flat_map_iter(|row| {
        let primaries: Vec<f64> = row.iter().map(|point| point[0]).collect();
        along(diagram, loops, row[0][1], &primaries)
    });
    let mut found: Vec<Vec<PeriodicSolution>> = rows.collect();
    found.iter_mut().for_each(|here| here.retain(good));
    let equations = diagram.equations(loops);
    for (k, settled) in seen.iter().enumerate() {
        if let (true, Some(at)) = (found[k].is_empty(), settled.iter().find(|at| at.loops == loops)) {
            let known = Unknowns::new(at.velocity, at.phase, points[k][0], points[k][1]);
            found[k].extend(near(&equations, &known, points[k]).filter(good));
        }
    }
    // Forwards and backwards, so that a solution spreads as far as possible.
    for _ in 0..2 {
        for k in (0..points.len()).chain((0..points.len()).rev()) {
            let column = k % lattice;
            let beside = [
                (column > 0).then(|| k - 1),
                (column + 1 < lattice).then_some(k + 1),
                k.checked_sub(lattice),
                Some(k + lattice).filter(|above| *above < points.len()),
            ];
            if found[k].is_empty() && shown(diagram, loops, points[k]) == Shown::Shaded {
                let known = beside.into_iter().flatten().flat_map(|other| &found[other]);
                let new = known.filter_map(|known| near(&equations, &known.unknowns, points[k])).find(good);
                found[k].extend(new);
            }
        }
    }
    found
}

/// The number of these stable, admissible MPSs at a point to which simulation returns, and the
/// disagreements.
fn judge(
    diagram: &Diagram,
    shown: Shown,
    found: &[PeriodicSolution],
    seen: bool,
) -> (usize, Vec<Disagreement>) {
    let mut wrong = Vec::new();
    if shown == Shown::Border || shown == Shown::Hatched {
        return (0, wrong);
    }
    if shown == Shown::White && seen {
        wrong.push(Disagreement::SeenUnshaded);
    }
    match (shown, found.is_empty()) {
        (Shown::Shaded, true) => wrong.push(Disagreement::NotFound),
        (Shown::White, false) => wrong.push(Disagreement::FoundUnshaded),
        _ => {}
    }
    let attracts = |solution: &PeriodicSolution| {
        let equations = diagram.equations(solution.loops);
        let suspect = Suspect {
            oscillator: &equations.oscillator_at(&solution.unknowns),
            loops: solution.loops,
            velocity: solution.impact_velocity(),
            phase: solution.unknowns[unknown::PHASE],
        };
        suspect.attracts() == Some(true)
    };
    let confirmed = found.iter().filter(|solution| attracts(solution)).count();
    if confirmed < found.len() {
        wrong.push(Disagreement::LeavesIt);
    }
    (confirmed, wrong)
}
