//! One-parameter diagrams: the solutions on a line of the parameter plane, along which one
//! parameter varies and the other is held.
//!
//! They contain branches of non-impacting motion and of p-loop MPSs, bifurcations on them, the
//! long-term behaviour of the hybrid system from random states, and orbits at chosen places.
//! Solutions are shown by x on the Poincaré section Π. The oscillator is oriented ([`oriented`]) so
//! that the parameter across is the first one, called μ below; rows contain both parameters in
//! their own roles.

mod branches;
mod flights;
mod oriented;
mod portraits;
mod readings;
pub mod requested;
mod visits;

use grazing_continuation::arclength::StepControl;
use grazing_continuation::bifurcation::Bifurcation;
use grazing_continuation::curve::Curve;
use grazing_continuation::mps::{Formulation, LoopEquations};
use grazing_model::{AnyOscillator, ImpactOscillator};
use grazing_results::branches::{AttractorPoint, BranchBifurcation, DiagramRow, OneParameter};
use grazing_results::readings::Ordinate;
use grazing_results::{Dimension, Dimensioned, Frame, columns};

pub use branches::Branch;
pub use oriented::oriented;
pub use portraits::Subject;

use crate::curves::DiagramCurve;
use crate::parallel;
use crate::progress::Progress;
use crate::segments::broken_at;
use crate::settled::{Recurring, Through};
use crate::slices::{FREE_STEPS, Slice, Slicer};
use crate::tolerances::BETWEEN_EVENTS_ON_A_CUT;
use crate::{Scope, non_impacting, search};
use branches::{Strand, same_bifurcation, within};
use portraits::Scene;
use visits::{Sampled, long_time_behaviour};

/// A line of the parameter plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// The number of the diagram of this line.
    pub diagram: u32,
    /// Whether the primary parameter is held, and the secondary one is across.
    pub primary_is_fixed: bool,
    /// The value of the parameter that is held.
    pub at: f64,
    /// The values of the other parameter that are shown, inside the range of the scope, through
    /// which branches are followed.
    pub range: [f64; 2],
}

impl Dimensioned for Line {
    fn each_number(&mut self, visit: &mut dyn FnMut(Dimension, &mut f64)) {
        let [mut across, mut held] = [columns::PRIMARY.dimension, columns::SECONDARY.dimension];
        if self.primary_is_fixed {
            (across, held) = (held, across);
        }
        visit(held, &mut self.at);
        self.range.iter_mut().for_each(|end| visit(across, end));
    }
}

/// Settings for the sampling of long-term behaviour.
#[derive(Clone, Debug, PartialEq)]
pub struct Sampling {
    /// Number of values of the parameter across, evenly spaced, at least 2.
    pub values: u32,
    /// The kinds of bifurcations between the first of which the values lie, or there are none;
    /// `None` for the whole range.
    pub between: Option<[Bifurcation; 2]>,
    /// Number of orbits at each value, from random states.
    pub orbits: u32,
    /// Number of forcing periods before an orbit counts; more where damping is weak.
    pub transient: u32,
    /// Number of forcing periods for which it then counts.
    pub recorded: u32,
    /// The least x of initial states; `None` for the least x that is shown.
    pub lowest: Option<f64>,
    /// The seed of the random states.
    pub seed: u64,
    /// Whether quantities other than x are read as well.
    pub readings: bool,
    /// The most impacts of solutions with several impacts whose branches are followed, from where orbits
    /// settle on them and from period doublings; 1 for none.
    pub impacts: u32,
}

/// The branches on a line.
pub struct Cut {
    /// The oscillator, oriented so that the parameter across is its primary one.
    oscillator: AnyOscillator,
    scope: Scope,
    line: Line,
    /// The branches, those of motion without impacts first.
    branches: Vec<Branch>,
}

/// The names of the stages.
const BRANCHES: &str = "branches of a one-parameter diagram";
const SEVERAL: &str = "branches of solutions with several impacts";

/// Heights of the highest point at which motion without impacts is looked for, the wall's distance
/// from rest being of order one.
const HEIGHTS: [f64; 4] = [0.0, -0.25, -0.5, -0.75];
/// Number of values of μ, from end to end, at which MPSs are looked for by solving for them.
const PLACES: u32 = 9;
/// Longest step along branches without impacts, as a fraction of the range that is shown.
const STEP: f64 = 0.02;
/// Lower bound of this longest step, as a fraction of the whole range.
const LEAST_STEP: f64 = 1e-3;
/// Further positions at rest from which motion is left to relax, as in another well.
const POSITIONS: [f64; 4] = [-1.5, -2.0, -3.0, -4.0];
/// Least depth of random states below the wall, which is at a distance of the order of one from
/// rest: those farther off oscillate faster.
const LEAST_DEPTH: f64 = 2.0;

impl Cut {
    /// The branches of an oscillator on a line, with the ranges and the numbers of loops of the
    /// scope; the range of the held parameter does not matter. Known curves of the two-parameter
    /// diagram lead to branches, but are not required.
    ///
    /// `None` if the computation was cancelled before they were known.
    pub fn follow(
        oscillator: &AnyOscillator,
        scope: &Scope,
        curves: &[DiagramCurve],
        line: Line,
        progress: &dyn Progress,
    ) -> Option<Self> {
        let exchanged = line.primary_is_fixed;
        let oscillator = oriented(oscillator, exchanged);
        let (scope, curves) = match exchanged {
            true => (scope.exchanged(), oriented::exchanged(curves)),
            false => (scope.clone(), curves.to_vec()),
        };
        let views = if oscillator.other_stop().is_some() { 2 } else { 1 };
        progress.begin(BRANCHES, views * scope.loops.len() as u64 + 1);
        let share = (line.range[1] - line.range[0]) / scope.window.widths()[0];
        let control = StepControl { longest: (STEP * share).max(LEAST_STEP), ..FREE_STEPS };
        let equations = non_impacting::equations(&oscillator, scope.window);
        let slicer = Slicer::new(equations, scope.window, control);
        let motion = non_impacting::motion(&oscillator, &scope, &slicer, line.at, &POSITIONS, &HEIGHTS);
        progress.step(BRANCHES);
        let grazing: Vec<[f64; 2]> =
            motion.grazing.iter().map(|orbit| [orbit.phase(), orbit.primary()]).collect();
        let mut free = Slice::new(line.at, motion.branches);
        let of_free: Vec<DiagramCurve> = curves.iter().filter(|curve| curve.loops == 0).cloned().collect();
        slicer.through_curves(&mut free, &of_free);
        let mut branches: Vec<_> = slicer
            .distinct(free)
            .into_iter()
            .map(|curve| Branch { equations: slicer.equations.clone(), curve })
            .collect();
        branches.extend(mps_branches(&oscillator, &scope, &curves, line.at, &grazing, progress));
        if let Some(other) = oscillator.other_stop() {
            // The start of the search is seen from the first stop.
            let scope = Scope { start: None, ..scope.clone() };
            let equations = non_impacting::equations(&other, scope.window);
            let slicer = Slicer::new(equations, scope.window, control);
            let motion = non_impacting::motion(&other, &scope, &slicer, line.at, &POSITIONS, &HEIGHTS);
            let grazing: Vec<[f64; 2]> =
                motion.grazing.iter().map(|orbit| [orbit.phase(), orbit.primary()]).collect();
            let seen = mps_branches(&other, &scope, &[], line.at, &grazing, progress).into_iter();
            branches.extend(seen.map(|Branch { equations, curve }| {
                let loops = equations.loops();
                let equations = LoopEquations::new(oscillator.clone(), loops, equations.formulation());
                Branch { equations: equations.at_stops([1]), curve }
            }));
        }
        progress.end(BRANCHES);
        let found = Self { oscillator, scope, line, branches };
        (!progress.stopped()).then_some(found)
    }

    /// The branches, those of motion without impacts first; μ is the parameter across.
    pub fn branches(&self) -> &[Branch] {
        &self.branches
    }

    /// The diagram with only its branches and bifurcations.
    pub fn diagram(&self) -> OneParameter {
        self.placed(self.oriented())
    }

    /// A diagram with rows in the roles of the line: both parameters in their own roles, and a
    /// frame of the height that it needs.
    fn placed(&self, mut diagram: OneParameter) -> OneParameter {
        let Line { diagram: number, primary_is_fixed, .. } = self.line;
        diagram.each_row(&mut |row| row.place(number, primary_is_fixed));
        diagram.fitted()
    }

    /// The diagram with the parameter across as the primary one.
    fn oriented(&self) -> OneParameter {
        let Line { diagram, primary_is_fixed, at, range } = self.line;
        let (mut strands, mut bifurcations) = (Vec::<Strand>::new(), Vec::<BranchBifurcation>::new());
        let found: Vec<_> = parallel::map(&self.branches, Branch::shown);
        for (own_strands, own_bifurcations) in found {
            strands.extend(own_strands);
            bifurcations.extend(own_bifurcations);
        }
        let strands = strands.iter().flat_map(|strand| within(strand, |point| point.primary, range));
        let mut branches = Vec::new();
        for (number, mut strand) in (1..).zip(strands) {
            strand.iter_mut().for_each(|point| point.branch = number);
            branches.extend(strand);
        }
        let inside = |primary: f64| range[0] <= primary && primary <= range[1];
        bifurcations.retain(|bifurcation| inside(bifurcation.primary));
        let same = BETWEEN_EVENTS_ON_A_CUT * self.scope.window.widths()[0];
        let bifurcations = bifurcations.into_iter().fold(Vec::new(), |mut distinct, one| {
            if !distinct.iter().any(|other| same_bifurcation(&one, other, same)) {
                distinct.push(one);
            }
            distinct
        });
        let of_mps = self.branches.iter().filter(|branch| branch.equations.has_impacts());
        let ends = of_mps.flat_map(|branch| {
            let of_branch =
                |(primary, reason)| ([branch.impacts(), branch.equations.loops()], primary, reason);
            broken_at(&branch.curve).map(of_branch)
        });
        OneParameter {
            diagram,
            primary_is_fixed,
            at,
            frame: Frame { x: range, y: [0.0, 0.0] },
            magnified: None,
            from_the_wall: false,
            branches,
            bifurcations,
            attractor: Vec::new(),
            portraits: Vec::new(),
            ordinate: Ordinate::X,
            readings: Vec::new(),
            motion: Vec::new(),
            simulated: None,
            broken: ends.filter(|(_, primary, _)| inside(*primary)).collect(),
            notes: Vec::new(),
        }
    }

    /// Rows in the roles of the line.
    fn in_place<R: DiagramRow>(&self, mut rows: Vec<R>) -> Vec<R> {
        let Line { diagram, primary_is_fixed, .. } = self.line;
        rows.iter_mut().for_each(|row| row.place(diagram, primary_is_fixed));
        rows
    }

    /// The sampling with a transient that is long enough for motion without impacts to settle.
    fn long_enough(&self, sampling: &Sampling) -> Sampling {
        let free = self.branches.iter().filter(|branch| !branch.equations.has_impacts());
        let points = free.flat_map(|branch| &branch.curve.points);
        sampling.as_long_as_it_takes(points.map(|point| point.solution.multipliers.determinant))
    }

    /// The diagram with long-term behaviour and phase portraits, or without them if the computation
    /// was cancelled; branches of solutions with several impacts are added, if any are wanted.
    pub fn simulated(
        &mut self,
        sampling: &Sampling,
        subjects: &[Subject],
        progress: &dyn Progress,
    ) -> OneParameter {
        let mut found = self.oriented();
        let at = self.line.at;
        let sampling = &self.long_enough(sampling);
        let shown = found.branches.iter().filter(|point| point.admissible);
        let lowest = shown.map(|point| point.x).fold(-LEAST_DEPTH, f64::min);
        let lowest = sampling.lowest.unwrap_or(lowest);
        let first = |kind: Bifurcation| {
            let first = found.bifurcations.iter().find(|bifurcation| bifurcation.kind == kind);
            first.map(|bifurcation| bifurcation.primary)
        };
        let range = match sampling.between {
            Some([from, to]) => first(from).zip(first(to)).map(<[f64; 2]>::from),
            None => Some(self.line.range),
        };
        let sampled =
            range.map(|range| long_time_behaviour(&self.oscillator, at, range, (sampling, lowest), progress));
        let Sampled { visits, readings, orbits, settled } = sampled.unwrap_or_default();
        let scene = Scene {
            oscillator: &self.oscillator,
            branches: &self.branches,
            secondary: at,
            transient: sampling.transient,
            lowest,
            seed: sampling.seed,
        };
        let portraits = scene.of_all(subjects, progress);
        if sampling.impacts > 1 && !progress.stopped() {
            self.continue_several(&settled, sampling.impacts, progress);
            found = self.oriented();
        }
        if !progress.stopped() {
            let visit = |[primary, x]: [f64; 2]| AttractorPoint { diagram: 0, secondary: at, primary, x };
            found.attractor = visits.into_iter().map(visit).collect();
            for (number, mut portrait) in (1..).zip(portraits) {
                portrait.iter_mut().for_each(|point| point.portrait = number);
                found.portraits.extend(portrait);
            }
            found.motion = readings;
            found.simulated = Some(orbits);
        }
        self.placed(found)
    }

    /// Adds the branches of solutions with several impacts through some of them, and those that begin at
    /// period doublings.
    fn continue_several(&mut self, settled: &[Recurring], most: u32, progress: &dyn Progress) {
        let through = Through {
            oscillator: &self.oscillator,
            window: self.scope.window,
            secondary: self.line.at,
            most: most as usize,
        };
        let known: Vec<(LoopEquations, Curve)> = self
            .branches
            .iter()
            .map(|Branch { equations, curve }| (equations.clone(), curve.clone()))
            .collect();
        let found = progress.during(SEVERAL, 1, || through.branches(settled, &known));
        self.branches.extend(found.into_iter().map(|(equations, curve)| Branch { equations, curve }));
    }
}

/// The branches of MPSs of all p at one η: those from grazing (z, μ), those that known curves
/// cross, and those found by solving for MPSs.
fn mps_branches(
    oscillator: &AnyOscillator,
    scope: &Scope,
    curves: &[DiagramCurve],
    secondary: f64,
    grazing: &[[f64; 2]],
    progress: &dyn Progress,
) -> Vec<Branch> {
    let slicer =
        |equations: &LoopEquations| Slicer::new(equations.clone(), scope.window, StepControl::DRAWING);
    let begun = |&loops: &u32| {
        let equations = LoopEquations::new(oscillator.clone(), loops, Formulation::FixedPhase);
        let slicer = slicer(&equations);
        let mut slice = slicer.beginning_at_grazing(secondary, grazing.iter().copied());
        let own: Vec<DiagramCurve> = curves.iter().filter(|curve| curve.loops == loops).cloned().collect();
        slicer.through_curves(&mut slice, &own);
        progress.step(BRANCHES);
        (equations, slice)
    };
    let begun: Vec<_> = parallel::map(&scope.loops, begun);
    let found = search::on_slice(oscillator, &scope.loops, scope.window, (secondary, PLACES), progress);
    let completed = |(equations, slice): (LoopEquations, Slice)| {
        let mut slice = Slice::new(secondary, slice.branches);
        let own = found.iter().filter(|(loops, _)| *loops == equations.loops());
        let slicer = slicer(&equations);
        slicer.through(&mut slice, own.map(|(_, solution)| solution.clone()));
        let branches = slicer.distinct(slice).into_iter();
        branches.map(|curve| Branch { equations: equations.clone(), curve }).collect::<Vec<_>>()
    };
    parallel::map(begun, completed).concat()
}
