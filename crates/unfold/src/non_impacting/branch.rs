//! Branches of periodic orbits without impacts at one value of η, and their bifurcations.

use grazing_continuation::arclength::{Continuation, StepControl};
use grazing_continuation::locate::Condition;
use grazing_continuation::mps::{MaximalPeriodicSolution, Multipliers};
use grazing_model::ImpactOscillator;
use grazing_theorems::from_map::GrazingOrbit;
use grazing_theorems::spectrum::in_trapesium;

use super::orbits::{OrbitPoint, PRIMARY, PeriodicOrbit, PeriodicOrbitCurve, PeriodicOrbits, SECONDARY};
use crate::edges::leaves;
use crate::slices::near_chord;

/// A branch through the range of μ.
#[derive(Clone, Debug)]
pub(crate) struct Branch {
    /// Its orbits in order, the bifurcations among them.
    pub(crate) orbits: Vec<PeriodicOrbit>,
    pub(crate) bifurcations: Vec<Crossing>,
    /// It was followed to the edges of the range to both sides.
    pub(crate) whole: bool,
}

/// A fold, a period doubling or grazing between two orbits of a branch.
#[derive(Clone, Debug)]
pub(crate) struct Crossing {
    /// [`Condition::SADDLE_NODE`], [`Condition::PERIOD_DOUBLING`] or [`Condition::InteriorGrazing`].
    pub(crate) condition: Condition,
    /// The orbit at a bifurcation that was located, or one nearby.
    pub(crate) near: PeriodicOrbit,
    /// The place of that orbit on the branch, if the bifurcation was located.
    pub(crate) place: Option<usize>,
}

/// Steps in (x, y, shares of the ranges) that do not jump over the highest point's changes (empirical).
pub(crate) const STEPS: StepControl =
    StepControl { first: 1e-3, longest: 0.1, shortest: 1e-6, turn: 0.2, ..StepControl::DRAWING };
/// A branch of this many points goes nowhere.
const STEP_LIMIT: usize = 4000;
/// A branch that has passed the wall is left where a multiplier exceeds this (empirical): beyond the wall it matters only for where it may come
/// back, and next to a force that pulls into a pole motion grows without bounds, which makes every orbit there a search by itself.
const VIOLENT: f64 = 1e4;
/// An orbit this close to the chord between two orbits of a branch, as a share of its length, lies on the branch: that leaves the chord
/// by an eighth of the angle by which it turns, which is three times that of the step control at most.
const ON_BRANCH: f64 = 0.15;

impl PeriodicOrbit {
    /// Stable, and nowhere above the wall.
    pub(crate) fn good(&self) -> bool {
        in_trapesium(self.multipliers.trace, self.multipliers.determinant) && self.off_the_wall()
    }

    pub(crate) fn off_the_wall(&self) -> bool {
        self.highest.position <= MaximalPeriodicSolution::TOUCH
    }

    /// Above the wall, and so unstable that no motion stays near it.
    fn is_lost(&self) -> bool {
        let Multipliers { trace, determinant } = self.multipliers;
        !self.off_the_wall() && trace.abs().max(determinant.abs()) > VIOLENT
    }

    /// The signs of what vanishes at folds, period doublings and grazing.
    fn signs(&self) -> [bool; 3] {
        let (trace, determinant) = (self.multipliers.trace, self.multipliers.determinant);
        [1.0 - trace + determinant > 0.0, 1.0 + trace + determinant > 0.0, self.off_the_wall()]
    }
}

impl Branch {
    /// Whether an orbit lies on the branch.
    pub(crate) fn passes(&self, orbit: &OrbitPoint) -> bool {
        let gap = |known: &PeriodicOrbit| known.orbit - orbit;
        let start = self.orbits.first().is_some_and(|first| gap(first).norm() < STEPS.first);
        start || self.orbits.windows(2).any(|pair| near_chord(&gap(&pair[0]), &gap(&pair[1]), ON_BRANCH))
    }
}

impl<O: ImpactOscillator> PeriodicOrbits<'_, O> {
    /// Adds the branch through an orbit, unless it is known.
    pub(crate) fn add_branch(&self, branches: &mut Vec<Branch>, through: &OrbitPoint) {
        if !branches.iter().any(|branch| branch.passes(through)) {
            branches.extend(self.branch(through));
        }
    }

    /// The branch through an orbit, at its η.
    pub(crate) fn branch(&self, through: &OrbitPoint) -> Option<Branch> {
        let up = OrbitPoint::new(0.0, 0.0, 1.0, 0.0);
        let (mut orbits, begins) = self.follow(through, -up)?;
        orbits.reverse();
        let (after, ends) = self.follow(through, up)?;
        orbits.extend(after.into_iter().skip(1));
        let mut branch = Branch { orbits: Vec::new(), bifurcations: Vec::new(), whole: begins && ends };
        let conditions = [Condition::SADDLE_NODE, Condition::PERIOD_DOUBLING, Condition::InteriorGrazing];
        for orbit in orbits {
            if let Some(before) = branch.orbits.last().copied() {
                let changed = before.signs().into_iter().zip(orbit.signs()).map(|(a, b)| a != b);
                for (condition, _) in conditions.into_iter().zip(changed).filter(|(_, changed)| *changed) {
                    branch.meet(self, condition, &before, &orbit);
                }
            }
            branch.orbits.push(orbit);
        }
        Some(branch)
    }

    /// Orbits from one to the side of a direction, and whether they reach the edge of the range.
    fn follow(&self, start: &OrbitPoint, direction: OrbitPoint) -> Option<(Vec<PeriodicOrbit>, bool)> {
        let curve = PeriodicOrbitCurve { orbits: self, condition: Condition::Secondary(start[SECONDARY]) };
        let mut walker = Continuation::new(&curve, self.control, *start, direction, ()).ok()?;
        let mut found = vec![self.seen(start)];
        for _ in 0..STEP_LIMIT {
            let before = walker.here().point;
            let Ok(station) = walker.advance() else { return Some((found, false)) };
            let after = station.point;
            if let Some((way, _, edge)) = leaves([PRIMARY], [&before, &after]) {
                let mut near = before + (after - before) * way;
                near[PRIMARY] = edge;
                found.extend(self.at(&near).map(|orbit| self.seen(&orbit)));
                return Some((found, true));
            }
            let seen = self.seen(&after);
            found.push(seen);
            if seen.is_lost() {
                return Some((found, false));
            }
        }
        Some((found, false))
    }

    /// The grazing orbit near a periodic orbit.
    pub(super) fn grazing(&self, near: &PeriodicOrbit) -> Option<GrazingOrbit<O>> {
        GrazingOrbit::find(&self.oscillator_at(&near.orbit), near.phase_of_highest).ok()
    }
}

impl Branch {
    /// Locates a bifurcation between the last orbit and the next, and puts it in its place.
    fn meet<O: ImpactOscillator>(
        &mut self,
        orbits: &PeriodicOrbits<'_, O>,
        condition: Condition,
        before: &PeriodicOrbit,
        after: &PeriodicOrbit,
    ) {
        let (near, located) = if condition == Condition::InteriorGrazing {
            let (a, b) = (before.highest.position, after.highest.position);
            let weight = a / (a - b);
            let mut between = before.orbit + (after.orbit - before.orbit) * weight;
            let mut near = *if weight < 0.5 { before } else { after };
            near.orbit[PRIMARY] = between[PRIMARY];
            let located = orbits.grazing(&near).and_then(|grazing| {
                between[PRIMARY] = orbits.scope.window.shares([grazing.primary(), 0.0])[0];
                let mut seen = orbits.seen(&orbits.at(&between)?);
                seen.highest.position = 0.0;
                Some(seen)
            });
            (near, located)
        } else {
            let middle = (before.orbit + after.orbit) * 0.5;
            let step = (after.orbit - before.orbit).norm();
            let found = orbits.with_multiplier(&middle, condition);
            let found = found.filter(|found| (found - middle).norm() < 2.0 * step);
            let located = found.map(|orbit| orbits.seen(&orbit));
            (located.unwrap_or(*before), located)
        };
        let place = located.map(|_| self.orbits.len());
        self.orbits.extend(located);
        self.bifurcations.push(Crossing { condition, near, place });
    }
}
