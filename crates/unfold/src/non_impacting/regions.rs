//! Non-impacting motion in the whole window: its grazing curves, its folds and period doublings, and where it is stable.

use grazing_continuation::curve::CurveEnd;
use grazing_continuation::locate::Condition;
use grazing_model::ImpactOscillator;
use grazing_theorems::from_map::GrazingOrbit;
use nalgebra::{Vector2, Vector3};
use rayon::prelude::*;

use super::branch::{Branch, Crossing, STEPS};
use super::orbits::{OrbitPoint, PRIMARY, PeriodicOrbits, SECONDARY};
use super::{Height, PeriodicMotion, periodic_motion};
use crate::curves::DiagramCurve;
use crate::faces::Point;
use crate::grazing::{GrazingCurve, HighestPoint};
use crate::progress::Progress;
use crate::regions::{self, Doubt, Region, Sight, Surveyor, decided};
use crate::slices::{CARRIED_OFF, MOST_BRANCHES, Slice, near_chord, spread};
use crate::stop::Unfinished;
use crate::{Scope, UnfoldError, search};

/// What there is of motion without impacts.
#[derive(Clone, Debug)]
pub(crate) struct NonImpacting<O> {
    pub(crate) grazing: Vec<GrazingCurve<O>>,
    pub(crate) curves: Vec<DiagramCurve>,
    pub(crate) regions: Vec<Region>,
    /// What was not finished when an end was asked for.
    pub(crate) unfinished: Vec<Unfinished>,
}

/// Every so many of the slices motion is left to relax from rest, which finds branches to which grazing does not lead.
const RELAXED_EVERY: usize = 2;
/// The shares of the range of μ at which branches are followed through the range of η, which finds what lies between slices: resonances of motion
/// without impacts that are narrower than the way from one slice to the next, and folds to which no slice comes near.
const COLUMNS: [f64; 3] = [0.0, 0.5, 1.0];
/// Orbits of a branch that are carried to a neighbouring slice.
const CARRIED: usize = 8;
/// A fold or period doubling this close to the chord between two points of a curve, as a share of its length, lies on the curve, which
/// leaves the chord by an eighth of the angle by which it turns: six degrees at most.
const ON_CURVE: f64 = 0.03;

/// An orbit on the edge lies inside, give or take rounding.
const INSIDE: f64 = 1e-9;

/// Curves are drawn to this share of the ranges.
const DRAWN: f64 = 1e-4;

/// What is told of the search.
const STAGE: &str = "motion without impacts";

struct NonImpactingSurvey<'a, O> {
    orbits: PeriodicOrbits<'a, O>,
    grazing: Vec<GrazingCurve<O>>,
    curves: Vec<DiagramCurve>,
    slices: Vec<Slice<Branch>>,
    /// Branches through the range of η.
    columns: Vec<Branch>,
}

/// Looks for grazing of the non-impacting solutions and for their regions.
///
/// # Errors
/// There is no grazing in the ranges, with what was seen instead.
pub(crate) fn find<O: ImpactOscillator>(
    oscillator: &O,
    scope: &Scope,
    progress: &dyn Progress,
) -> Result<NonImpacting<O>, UnfoldError> {
    let levels = regions::levels(scope.window).into_iter().enumerate();
    let (relaxed, between): (Vec<_>, Vec<_>) = levels.partition(|(k, _)| k % RELAXED_EVERY == 0);
    let [relaxed, between] =
        [relaxed, between].map(|part| part.into_iter().map(|(_, secondary)| secondary).collect::<Vec<_>>());
    progress.begin(STAGE, relaxed.len() as u64);
    let found = on_slices(oscillator, scope, &relaxed, &between, progress);
    progress.end(STAGE);
    found
}

/// The same from slices on which motion is left to relax from rest, and others between them.
fn on_slices<O: ImpactOscillator>(
    oscillator: &O,
    scope: &Scope,
    relaxed: &[f64],
    between: &[f64],
    progress: &dyn Progress,
) -> Result<NonImpacting<O>, UnfoldError> {
    let motions: Vec<PeriodicMotion<O>> = relaxed
        .par_iter()
        .map(|secondary| {
            let motion = periodic_motion(oscillator, scope, *secondary);
            progress.step(STAGE);
            motion
        })
        .collect();
    let nothing = || match progress.stopped() {
        true => UnfoldError::Stopped { stage: STAGE },
        false => explanation(&motions),
    };
    let slices = relaxed.iter().zip(&motions);
    let slices = slices.map(|(secondary, motion)| Slice::new(*secondary, motion.branches.clone()));
    let mut survey = NonImpactingSurvey {
        orbits: PeriodicOrbits { oscillator, scope, control: STEPS },
        grazing: Vec::new(),
        curves: Vec::new(),
        slices: slices.collect(),
        columns: Vec::new(),
    };
    // From the middle outwards: a curve is told once, from where it is met first.
    let mut order: Vec<usize> = (0..motions.len()).collect();
    order.sort_by_key(|k| k.abs_diff(motions.len() / 2));
    for orbit in order.into_iter().flat_map(|k| &motions[k].grazing) {
        survey.add_grazing(orbit);
    }
    survey.follow_columns(progress);
    survey.look_for_grazing(progress);
    if survey.grazing.is_empty() {
        return Err(nothing());
    }
    let regions = decided(scope.window, &mut survey, 0, between, progress);
    let NonImpactingSurvey { grazing, curves, .. } = survey;
    let (regions, unfinished) = match progress.stopped() {
        true => (vec![Region::not_finished(scope.window, 0)], vec![Unfinished::stage(STAGE)]),
        false => (regions, Vec::new()),
    };
    Ok(NonImpacting { grazing, curves, regions, unfinished })
}

impl<O: ImpactOscillator> NonImpactingSurvey<'_, O> {
    /// Adds the grazing curve through an orbit unless it is known, and says whether it did.
    fn add_grazing(&mut self, orbit: &GrazingOrbit<O>) -> bool {
        let scope = self.orbits.scope;
        let shares = scope.window.shares(orbit.oscillator().parameters());
        if shares.iter().all(|share| (-INSIDE..=1.0 + INSIDE).contains(share))
            && !self.grazing.iter().any(|curve| curve.passes(orbit, scope))
            && let Ok(curve) = GrazingCurve::through(orbit, scope)
            && !curve.states.is_empty()
        {
            self.grazing.push(curve);
            return true;
        }
        false
    }

    /// Adds grazing to which nothing that is known leads, and the branches through the range of η on which it lies.
    fn look_for_grazing(&mut self, progress: &dyn Progress) {
        let PeriodicOrbits { oscillator, scope, .. } = self.orbits;
        for highest in search::grazing(oscillator, scope, progress) {
            if let Some(orbit) = highest.grazing(oscillator)
                && self.add_grazing(&orbit)
                && let Some(start) = self.orbits.through(&highest)
            {
                self.follow_column(&start);
            }
        }
    }

    /// The branches at some η that graze there.
    fn beginning_at_grazing(&self, secondary: f64) -> Slice<Branch> {
        let mut branches: Vec<Branch> = Vec::new();
        for place in self.grazing.iter().flat_map(|curve| curve.all_at(secondary)) {
            let highest = HighestPoint { height: 0.0, phase: place.phase, parameters: place.parameters };
            if let Some(start) = self.orbits.through(&highest) {
                self.orbits.add_branch(&mut branches, &start);
            }
        }
        Slice::new(secondary, branches)
    }

    fn carry(&self, from: &Slice<Branch>, to: &mut Slice<Branch>) -> bool {
        let before = to.branches.len();
        let share = self.orbits.scope.window.shares([0.0, to.secondary])[1];
        for branch in &from.branches {
            let every = (branch.orbits.len() / CARRIED).max(1);
            for known in branch.orbits.iter().skip(every / 2).step_by(every) {
                let mut near = known.orbit;
                near[SECONDARY] = share;
                if to.branches.len() < MOST_BRANCHES
                    && let Some(start) = self.orbits.within(CARRIED_OFF, &near)
                {
                    self.orbits.add_branch(&mut to.branches, &start);
                }
            }
        }
        to.branches.len() > before
    }

    /// Follows the branches of slices through the range of η, where they meet a column, and starts curves at what happens on them.
    fn follow_columns(&mut self, progress: &dyn Progress) {
        for share in COLUMNS {
            let branches = self.slices.iter().flat_map(|slice| &slice.branches);
            let starts: Vec<OrbitPoint> = branches.flat_map(|branch| branch.meets(share)).collect();
            for near in starts {
                let known = |start: &OrbitPoint| self.columns.iter().any(|column| column.passes(start));
                if progress.stopped() || self.columns.len() >= MOST_BRANCHES || known(&near) {
                    continue;
                }
                if let Some(start) = self.orbits.at(&near).filter(|start| !known(start)) {
                    self.follow_column(&start);
                }
            }
        }
    }

    fn follow_column(&mut self, start: &OrbitPoint) {
        if let Some(column) = self.orbits.branch(start, PRIMARY) {
            self.explain(&column.borders());
            self.columns.push(column);
        }
    }

    /// Starts curves at bifurcations that lie on none.
    fn explain(&mut self, found: &[(Crossing, usize)]) {
        for (bifurcation, held) in found {
            if bifurcation.condition == Condition::InteriorGrazing {
                if let Some(orbit) = self.orbits.grazing(&bifurcation.near, *held) {
                    self.add_grazing(&orbit);
                }
            } else if !self.known(bifurcation)
                && let Some(curve) = self.orbits.curve(bifurcation)
                && !stalls(&curve)
            {
                self.curves.push(curve);
            }
        }
    }

    /// Whether one curve lies on another in the plane, as do those of motion in both wells of a symmetric force: between them there
    /// would be nothing but slivers.
    fn covers(&self, known: &DiagramCurve, other: &DiagramCurve) -> bool {
        let places = |curve: &DiagramCurve| -> Vec<Vector2<f64>> {
            curve
                .curve
                .parameters()
                .iter()
                .map(|at| Vector2::from(self.orbits.scope.window.shares(*at)))
                .collect()
        };
        let [line, points] = [known, other].map(places);
        let near = |point: &Vector2<f64>| {
            line.windows(2).any(|pair| {
                let chord = pair[1] - pair[0];
                near_chord(&(pair[0] - point), &chord, DRAWN / chord.norm())
            })
        };
        known.kind == other.kind && points.iter().all(near)
    }

    /// Whether a fold or period doubling lies on a known curve.
    fn known(&self, bifurcation: &Crossing) -> bool {
        let scope = self.orbits.scope;
        let place = |parameters: [f64; 2], height: f64| {
            let [primary, secondary] = scope.window.shares(parameters);
            Vector3::new(primary, secondary, height)
        };
        let here = place(bifurcation.near.height.parameters, bifurcation.near.highest.position);
        self.curves.iter().filter(|curve| curve.curve.condition == bifurcation.condition).any(|curve| {
            curve.curve.points.windows(2).any(|pair| {
                let [a, b] = [0, 1].map(|k| place(pair[k].solution.parameters(), pair[k].solution.ceiling()));
                near_chord(&(a - here), &(b - a), ON_CURVE)
            })
        })
    }
}

/// A curve that goes on to nowhere begins at no fold: two branches meet there, as for the sake of a symmetry.
fn stalls(curve: &DiagramCurve) -> bool {
    [curve.curve.beginning.as_ref(), Some(&curve.curve.end)]
        .into_iter()
        .flatten()
        .any(|end| matches!(end, CurveEnd::Stalled(_)))
}

impl Branch {
    /// Orbits near those at a share of the range of μ.
    fn meets(&self, share: f64) -> impl Iterator<Item = OrbitPoint> {
        self.orbits.windows(2).filter_map(move |pair| {
            let [a, b] = [&pair[0].orbit, &pair[1].orbit];
            let [from, to] = [a, b].map(|orbit| orbit[PRIMARY] - share);
            (from * to <= 0.0 && from != to).then(|| {
                let mut near = a + (b - a) * (from / (from - to));
                near[PRIMARY] = share;
                near
            })
        })
    }

    /// The bifurcations that bound good motion, and what is held there.
    fn borders(&self) -> Vec<(Crossing, usize)> {
        let borders = self.bifurcations.iter().filter(|bifurcation| self.bounds(bifurcation));
        borders.map(|bifurcation| (bifurcation.clone(), self.held)).collect()
    }

    /// Whether motion is good to one side of a bifurcation and not to the other.
    fn bounds(&self, bifurcation: &Crossing) -> bool {
        let Some(place) = bifurcation.place else { return false };
        let at_event = |k: &usize| self.bifurcations.iter().any(|other| other.place == Some(*k));
        let good = |k: usize| self.orbits[k].good();
        let before = (0..place).rev().find(|k| !at_event(k)).map(good);
        let after = (place + 1..self.orbits.len()).find(|k| !at_event(k)).map(good);
        before.is_none() || after.is_none() || before != after
    }
}

impl<O: ImpactOscillator> Surveyor for NonImpactingSurvey<'_, O> {
    fn look_at(&mut self, levels: &[f64], progress: &dyn Progress) {
        let found: Vec<_> = levels.par_iter().map(|level| self.beginning_at_grazing(*level)).collect();
        self.slices.extend(found);
        let mut slices = core::mem::take(&mut self.slices);
        spread(&mut slices, progress, |from, to| self.carry(from, to));
        self.slices = slices;
        let new = self.slices.iter_mut().flat_map(Slice::take_new);
        let found: Vec<_> = new.flat_map(Branch::borders).collect();
        self.explain(&found);
        self.follow_columns(progress);
    }

    fn lines(&self) -> Vec<Vec<Point>> {
        let grazing = self.grazing.iter().map(|curve| curve.parameters().collect());
        let distinct = self
            .curves
            .iter()
            .enumerate()
            .filter(|(k, curve)| !self.curves[..*k].iter().any(|earlier| self.covers(earlier, curve)));
        grazing.chain(distinct.map(|(_, curve)| curve.curve.parameters())).collect()
    }

    fn curves(&self) -> &[DiagramCurve] {
        &self.curves
    }

    fn sights(&self) -> Vec<Sight> {
        let sight = |slice: &Slice<Branch>| {
            let mut sight = Sight::of(slice);
            for branch in &slice.branches {
                let is_event = |k: usize| branch.bifurcations.iter().any(|b| b.place == Some(k));
                let primary = |k: usize| branch.orbits[k].height.parameters[0];
                for k in 1..branch.orbits.len() {
                    let good = match [is_event(k - 1), is_event(k)] {
                        [false, false] if branch.orbits[k - 1].good() != branch.orbits[k].good() => {
                            sight.doubt(primary(k), Doubt::UnnamedChange);
                            false
                        }
                        [false, _] => branch.orbits[k - 1].good(),
                        [_, false] => branch.orbits[k].good(),
                        _ => false,
                    };
                    if good {
                        sight.see([primary(k - 1), primary(k)]);
                    }
                }
                if !branch.whole {
                    for orbit in [branch.orbits.first(), branch.orbits.last()].into_iter().flatten() {
                        let at = orbit.height.parameters[0];
                        let [left, right] = self.orbits.scope.window.primary;
                        if left < at && at < right && orbit.highest.position <= 0.0 {
                            sight.doubt(
                                at,
                                Doubt::Broken("motion without impacts ceases to exist".to_owned()),
                            );
                        }
                    }
                }
            }
            sight
        };
        self.slices.iter().map(sight).collect()
    }
}

/// Heights that differ by a smaller share are one: which of them is named is not left to rounding.
const SAME_HEIGHT: f64 = 1e-9;

/// Why no survey has seen grazing.
fn explanation<O>(motions: &[PeriodicMotion<O>]) -> UnfoldError {
    if let Some(at) = motions.iter().flat_map(|motion| &motion.pushed).next() {
        return UnfoldError::Pushed { at: *at };
    }
    let branches = motions.iter().flat_map(|motion| &motion.branches);
    let whole = branches.clone().all(|branch| branch.whole);
    let orbits = branches.flat_map(|branch| &branch.orbits);
    let heights = orbits.map(|orbit| orbit.height);
    let above = |a: Height, b: Height| a.position - b.position > SAME_HEIGHT * b.position.abs();
    let lowest = heights.clone().reduce(|a, b| if above(a, b) { b } else { a });
    let highest = heights.reduce(|a, b| if above(b, a) { b } else { a });
    match (lowest.zip(highest), motions.iter().find_map(|motion| motion.ran_away)) {
        (Some((lowest, highest)), _) => UnfoldError::NoGrazing { lowest, highest, whole },
        (None, Some(escape)) => UnfoldError::RunsAway { escape },
        (None, None) => UnfoldError::NoOrbit,
    }
}
