//! One-parameter diagrams: what there is at one η as μ changes.
//!
//! Branches of non-impacting motion and of p-loop MPSs, bifurcations on them, the long-time behaviour of the hybrid system from random
//! states, and orbits at chosen μ. Everything is shown by x on the Poincaré section Π.

mod branches;
mod exchanged;
mod long_time;
mod portraits;

use grazing_continuation::arclength::StepControl;
use grazing_continuation::bifurcation::Bifurcation;
use grazing_continuation::locate::Condition;
use grazing_continuation::mps::{Formulation, LoopEquations};
use grazing_model::ImpactOscillator;
use rayon::prelude::*;

pub use branches::{Branch, BranchBifurcation, Strand, StrandPoint};
pub use exchanged::{Exchanged, exchanged};
pub(crate) use long_time::{LONGEST_TRANSIENT, impacts};
pub use long_time::{Plan, Settled, long_time_behaviour, random_start, settled};
pub(crate) use portraits::cycle;
pub use portraits::{ATTRACTOR_PERIODS, Portrait, drifts, sampled};

use crate::curves::DiagramCurve;
use crate::non_impacting::branch;
use crate::non_impacting::orbits::PeriodicOrbits;
use crate::progress::Progress;
use crate::slices::{Slice, Slicer, broken_at, distinct};
use crate::{Scope, search};

/// What is to be shown.
#[derive(Clone, Debug, PartialEq)]
pub struct Wanted {
    /// η.
    pub secondary: f64,
    /// The values of μ, inside those of the scope, through which branches are followed.
    pub range: [f64; 2],
    /// Values of μ in that range at which orbits are shown.
    pub portraits: Vec<f64>,
    /// How the long-time behaviour is sampled.
    pub plan: Plan,
}

/// What there is at one η.
#[derive(Clone, Debug)]
pub struct OneParameter {
    /// The non-impacting solution (p = 0) and p-loop MPSs, one strand a loop.
    pub strands: Vec<Strand>,
    /// Bifurcations of admissible solutions.
    pub bifurcations: Vec<BranchBifurcation>,
    /// (μ, x) at visits to Π of orbits that have settled; none if that was not finished.
    pub visits: Vec<[f64; 2]>,
    /// The number of orbits that left no visit, as they came to rest at the wall or could not be followed, and of all.
    pub resting: [u32; 2],
    /// Orbits at the chosen values of μ; none if they were not finished.
    pub portraits: Vec<Portrait>,
    /// Where a branch of MPSs could not be followed to its end: p, μ, and what happened.
    pub broken: Vec<(u32, f64, String)>,
    /// The long-time behaviour is missing, because an end was asked for.
    pub unfinished: bool,
}

/// The stages.
const BRANCHES: &str = "branches of a one-parameter diagram";
const LONG_TIME: &str = "long-time behaviour";

/// Motion without impacts is looked for that has its highest point here, the wall's distance from rest being of order one.
const HEIGHTS: [f64; 4] = [0.0, -0.25, -0.5, -0.75];
/// MPSs are looked for by solving for them at so many values of μ, from end to end.
const PLACES: u32 = 9;
/// Steps along branches without impacts are at most this part of the range that is shown.
const STEP: f64 = 0.02;
/// And no shorter than this part of the whole one.
const LEAST_STEP: f64 = 1e-3;
/// And it is left to relax from rest at these positions, as in another well.
const POSITIONS: [f64; 4] = [-1.5, -2.0, -3.0, -4.0];
/// Random states are looked for this far from the wall at least, which is of the order of one away from rest: those farther off swing faster.
const LEAST_DEPTH: f64 = 2.0;
/// Bifurcations that agree to this share of the range, and in their impacts, are one, on branches that overlap.
const SAME: f64 = 1e-8;

impl OneParameter {
    /// What there is of an oscillator at one η, the values of μ and the numbers of loops being those of the scope. Curves of the
    /// two-parameter diagram that are known lead to branches, but need not be there. `begun` gets the branches before the simulation, which takes
    /// longer.
    ///
    /// `None` if an end was asked for before the branches were known.
    pub fn compute<O: ImpactOscillator>(
        oscillator: &O,
        scope: &Scope,
        curves: &[DiagramCurve],
        wanted: &Wanted,
        progress: &dyn Progress,
        begun: &mut dyn FnMut(&Self),
    ) -> Option<Self> {
        let Wanted { secondary, range, .. } = *wanted;
        progress.begin(BRANCHES, scope.loops.len() as u64 + 1);
        let share = (range[1] - range[0]) / scope.window.widths()[0];
        let longest = (STEP * share).max(LEAST_STEP);
        let control = StepControl { longest, ..branch::STEPS };
        let orbits = PeriodicOrbits { oscillator, scope, control };
        let motion = orbits.motion(secondary, &POSITIONS, &HEIGHTS);
        progress.step(BRANCHES);
        let grazing: Vec<[f64; 2]> =
            motion.grazing.iter().map(|orbit| [orbit.phase(), orbit.primary()]).collect();
        let branches = mps_branches(oscillator, scope, curves, secondary, &grazing, progress);
        progress.end(BRANCHES);
        let mut strands: Vec<Strand> = motion.branches.iter().map(Strand::of_non_impacting).collect();
        let mut bifurcations: Vec<BranchBifurcation> =
            motion.branches.iter().flat_map(BranchBifurcation::of_non_impacting).collect();
        let found: Vec<_> = branches.par_iter().map(Branch::shown).collect();
        for (own_strands, own_bifurcations) in found {
            strands.extend(own_strands);
            bifurcations.extend(own_bifurcations);
        }
        let inside = |primary: f64| range[0] <= primary && primary <= range[1];
        let strands: Vec<Strand> = strands.iter().flat_map(|strand| strand.within(range)).collect();
        bifurcations.retain(|bifurcation| inside(bifurcation.primary));
        let bifurcations = bifurcations.into_iter().fold(Vec::new(), |mut distinct, one| {
            if !distinct.iter().any(|other| one.is(other, SAME * scope.window.widths()[0])) {
                distinct.push(one);
            }
            distinct
        });
        if progress.stopped() {
            return None;
        }
        let ends = branches.iter().flat_map(|branch| {
            let of_loops = |(primary, reason)| (branch.equations.loops(), primary, reason);
            broken_at(&branch.curve).map(of_loops)
        });
        let mut found = Self {
            strands,
            bifurcations,
            visits: Vec::new(),
            resting: [0, 0],
            portraits: Vec::new(),
            broken: ends.filter(|(_, primary, _)| inside(*primary)).collect(),
            unfinished: true,
        };
        begun(&found);
        let products = motion
            .branches
            .iter()
            .flat_map(|branch| &branch.orbits)
            .map(|orbit| orbit.multipliers.determinant);
        let plan = &wanted.plan.as_long_as_it_takes(products);
        let shown = found.strands.iter().flat_map(|strand| &strand.points).filter(|point| point.admissible);
        let lowest = shown.map(|point| point.x).fold(-LEAST_DEPTH, f64::min);
        let scene = portraits::Scene {
            orbits: &orbits,
            non_impacting: &motion.branches,
            branches: &branches,
            plan,
            lowest,
        };
        let (visits, resting) = long_time_behaviour(oscillator, secondary, range, (plan, lowest), progress);
        let portraits = scene.at_all(&wanted.portraits, secondary, progress);
        if !progress.stopped() {
            found = Self { visits, resting, portraits, unfinished: false, ..found };
        }
        Some(found)
    }
}

/// The branches of MPSs of all p at one η: those from grazing (z, μ), those that known curves cross, and those that are found by solving for
/// MPSs.
fn mps_branches<O: ImpactOscillator>(
    oscillator: &O,
    scope: &Scope,
    curves: &[DiagramCurve],
    secondary: f64,
    grazing: &[[f64; 2]],
    progress: &dyn Progress,
) -> Vec<Branch<O>> {
    let grazing = |_| grazing.to_vec();
    let slices = scope.loops.par_iter().map(|&loops| {
        let equations = LoopEquations::new(oscillator.clone(), loops, Formulation::FixedPhase);
        let slicer = Slicer::new(&equations, scope.window, StepControl::DRAWING, &grazing);
        let mut slice = slicer.beginning_at_grazing(secondary);
        let own: Vec<DiagramCurve> = curves.iter().filter(|curve| curve.loops == loops).cloned().collect();
        slicer.through_curves(&mut slice, &own);
        progress.step(BRANCHES);
        (equations, slice)
    });
    let begun: Vec<_> = slices.collect();
    let begun = begun.into_iter().flat_map(|(equations, slice)| {
        slice.branches.into_iter().map(move |curve| Branch { equations: equations.clone(), curve })
    });
    completed(oscillator, scope, secondary, begun.collect(), progress)
}

/// Branches of MPSs at one η and those besides that are found by solving for MPSs, by p; each once.
pub fn completed<O: ImpactOscillator>(
    oscillator: &O,
    scope: &Scope,
    secondary: f64,
    begun: Vec<Branch<O>>,
    progress: &dyn Progress,
) -> Vec<Branch<O>> {
    let fastest = search::fastest(begun.iter().map(|branch| &branch.curve));
    let found =
        search::on_slice(oscillator, &scope.loops, scope.window, (secondary, PLACES), fastest, progress);
    let of_loops = |loops: u32| {
        let equations = LoopEquations::new(oscillator.clone(), loops, Formulation::FixedPhase);
        let own = begun.iter().filter(|branch| branch.equations.loops() == loops);
        let mut slice = Slice::new(secondary, own.map(|branch| branch.curve.clone()).collect());
        let slicer = Slicer::new(&equations, scope.window, StepControl::DRAWING, &|_| Vec::new());
        let own = found.iter().filter(|(other, _)| *other == loops);
        slicer.through(&mut slice, own.map(|(_, solution)| *solution));
        let branches = distinct(slice.branches).into_iter();
        branches.map(|curve| Branch { equations: equations.clone(), curve }).collect::<Vec<_>>()
    };
    scope.loops.par_iter().map(|loops| of_loops(*loops)).collect::<Vec<_>>().concat()
}

/// The bifurcation that a condition is on a branch of non-impacting motion.
fn of_non_impacting(condition: Condition) -> Option<Bifurcation> {
    match condition {
        Condition::InteriorGrazing => Some(Bifurcation::NonImpactingGrazing),
        other => Bifurcation::of(other),
    }
}
