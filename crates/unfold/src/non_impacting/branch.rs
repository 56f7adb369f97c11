//! Branches of periodic orbits without impacts at one value of η, or of μ, and their bifurcations.

use grazing_continuation::arclength::{Continuation, FEWEST_OF_A_LOOP, StepControl, back_at};
use grazing_continuation::locate::Condition;
use grazing_continuation::mps::{MaximalPeriodicSolution, Multipliers, unknown};
use grazing_model::{ImpactOscillator, State};
use grazing_theorems::from_map::GrazingOrbit;

use super::orbits::{OrbitPoint, PRIMARY, PeriodicOrbit, PeriodicOrbitCurve, PeriodicOrbits, SECONDARY};
use crate::edges::leaves;
use crate::grazing::HighestPoint;
use crate::slices::near_chord;
use crate::winding::angle_in_a_period;

/// A branch through the range of one parameter.
#[derive(Clone, Debug)]
pub(crate) struct Branch {
    /// The place of the other parameter in an orbit, which is held.
    pub(crate) held: usize,
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
/// From orbits larger than this steps are as much longer: fast forcing makes the unit of length small beside the wall's distance from rest.
const LARGE: f64 = 16.0;
/// A branch with as many points as the longest steps would make of this length goes nowhere, and so does one of so many points.
const LONGEST_BRANCH: f64 = 400.0;
const STEP_LIMIT: usize = 25_000;
/// A branch that has passed the wall is left where a multiplier exceeds this (empirical): beyond the wall it matters only for where it may come
/// back, and next to a force that pulls into a pole motion grows without bounds, which makes every orbit there a search by itself.
const VIOLENT: f64 = 1e4;
/// An orbit this close to the chord between two orbits of a branch, as a share of its length, lies on the branch: that leaves the chord
/// by an eighth of the angle by which it turns, which is three times that of the step control at most.
const ON_BRANCH: f64 = 0.15;

impl PeriodicOrbit {
    /// Stable, and nowhere above the wall.
    pub(crate) fn good(&self) -> bool {
        self.multipliers.stable() && self.off_the_wall()
    }

    pub(crate) fn off_the_wall(&self) -> bool {
        self.highest.position <= MaximalPeriodicSolution::TOUCH
    }

    /// Above the wall, and so unstable that no motion stays near it.
    fn is_lost(&self) -> bool {
        !self.off_the_wall() && self.multipliers.size() > VIOLENT
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
        let chord = |pair: &[PeriodicOrbit]| pair[1].orbit - pair[0].orbit;
        start || self.orbits.windows(2).any(|pair| near_chord(&gap(&pair[0]), &chord(pair), ON_BRANCH))
    }
}

impl<O: ImpactOscillator> PeriodicOrbits<'_, O> {
    /// Adds the branch through an orbit, unless it is known.
    pub(crate) fn add_branch(&self, branches: &mut Vec<Branch>, through: &OrbitPoint) {
        if !branches.iter().any(|branch| branch.passes(through)) {
            branches.extend(self.branch(through, SECONDARY));
        }
    }

    /// The branch through an orbit, one of its parameters held.
    pub(crate) fn branch(&self, through: &OrbitPoint, held: usize) -> Option<Branch> {
        let up = OrbitPoint::ith(other(held), 1.0);
        let (mut orbits, mut whole) = self.follow(through, -up, held)?;
        let closed =
            orbits.len() > FEWEST_OF_A_LOOP && orbits.last().map(|last| last.orbit) == Some(*through);
        if !closed {
            orbits.reverse();
            let (after, ends) = self.follow(through, up, held)?;
            orbits.extend(after.into_iter().skip(1));
            whole &= ends;
        }
        let mut branch = Branch { held, orbits: Vec::new(), bifurcations: Vec::new(), whole };
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

    /// Orbits from one to the side of a direction, and whether they reach the edge of the range, or the first one again.
    fn follow(
        &self,
        start: &OrbitPoint,
        direction: OrbitPoint,
        held: usize,
    ) -> Option<(Vec<PeriodicOrbit>, bool)> {
        let (share, running) = (start[held], other(held));
        let condition =
            if held == SECONDARY { Condition::Secondary(share) } else { Condition::Primary(share) };
        let curve = PeriodicOrbitCurve { orbits: self, condition };
        let size = (start.fixed_rows::<2>(0).norm() / LARGE).max(1.0);
        let control = StepControl { longest: self.control.longest * size, ..self.control };
        let mut walker = Continuation::new(&curve, control, *start, direction, ()).ok()?;
        let mut found = vec![self.seen(start)];
        let mut pace = (held == PRIMARY).then(|| Pace::new(self, start));
        let step_limit = ((LONGEST_BRANCH / self.control.longest) as usize).min(STEP_LIMIT);
        for _ in 0..step_limit {
            if let Some(pace) = &mut pace {
                walker.limit(pace.next(self, found.last()?) / walker.here().tangent[running].abs());
            }
            let before = walker.here().point;
            let Ok(station) = walker.advance() else { return Some((found, false)) };
            let after = station.point;
            if let Some((way, _, edge)) = leaves([running], [&before, &after]) {
                let mut near = before + (after - before) * way;
                near[running] = edge;
                found.extend(self.at(&near).map(|orbit| self.seen(&orbit)));
                return Some((found, true));
            }
            if found.len() > FEWEST_OF_A_LOOP
                && let [first, second, ..] = found[..]
                && back_at((*start, second.orbit - start), [&before, &after], control.turn, None).is_some()
            {
                found.push(first);
                return Some((found, true));
            }
            let seen = self.seen(&after);
            found.push(seen);
            if seen.is_lost() || (held == PRIMARY && seen.highest.position > HIGH * size) {
                return Some((found, false));
            }
        }
        Some((found, false))
    }

    /// The grazing orbit near a periodic orbit, one of its parameters held.
    pub(super) fn grazing(&self, near: &PeriodicOrbit, held: usize) -> Option<GrazingOrbit<O>> {
        let (oscillator, phase) = (self.oscillator_at(&near.orbit), near.phase_of_highest);
        match held {
            PRIMARY => {
                let near = HighestPoint { height: 0.0, phase, parameters: oscillator.parameters() };
                near.located(&oscillator, self.scope, unknown::PRIMARY)?.grazing(&oscillator)
            }
            _ => GrazingOrbit::find(&oscillator, phase).ok(),
        }
    }
}

/// The place of the other parameter.
fn other(parameter: usize) -> usize {
    PRIMARY + SECONDARY - parameter
}

/// How far a branch may go in the share of η without passing over a resonance of motion without impacts, which is as narrow as the damping is small.
///
/// The multipliers λ of small motion about an orbit turn as η changes, and at a resonance pass 1 or −1 at a distance that the damping leaves. So a step may turn them by
/// a share of their distance from there.
struct Pace {
    /// The angle by which small motion turns in a unit of time, at the start.
    rate: f64,
    /// The last share of η, the angle of λ there, between 0 and π, and how fast that changed.
    last: Option<[f64; 3]>,
}

/// That share,
const PART: f64 = 0.3;
/// and the step in the share of η that need not be shorter: without damping a resonance has no width.
const LEAST_WAY: f64 = 1e-4;
/// So far beyond the wall, whose distance from rest is of order one, a branch through the range of η is left: what is behind a resonance is
/// reached from there.
const HIGH: f64 = 10.0;

impl Pace {
    fn new<O: ImpactOscillator>(orbits: &PeriodicOrbits<'_, O>, start: &OrbitPoint) -> Self {
        let oscillator = orbits.oscillator_at(start);
        let from = State { position: start[0], velocity: start[1], phase: 0.0 };
        Self { rate: angle_in_a_period(&oscillator, from) / oscillator.forcing_period(), last: None }
    }

    /// The longest step in the share of η from an orbit.
    fn next<O: ImpactOscillator>(&mut self, orbits: &PeriodicOrbits<'_, O>, at: &PeriodicOrbit) -> f64 {
        let Multipliers { trace, determinant } = at.multipliers;
        // |1 − λ| and |1 + λ| of one of two that are complex.
        let distances = [1.0 - trace + determinant, 1.0 + trace + determinant].map(|c| c.abs().sqrt());
        let angle = libm::acos((0.5 * trace / determinant.sqrt()).clamp(-1.0, 1.0));
        let share = at.orbit[SECONDARY];
        let oscillator = orbits.oscillator_at(&at.orbit);
        let frequency = oscillator.forcing_frequency();
        let change = frequency.gradient[1].abs() * orbits.scope.window.widths()[1] / frequency.value;
        let expected = self.rate.abs() * oscillator.forcing_period() * change;
        let [measured, past] = self.last.map_or([0.0; 2], |[before, other, past]| {
            let turned = (angle - other).abs() / (share - before).abs();
            [if turned.is_finite() { turned } else { 0.0 }, past]
        });
        self.last = Some([share, angle, measured]);
        let step = PART * distances[0].min(distances[1]) / expected.max(measured).max(past);
        // Infinite where nothing turns.
        if step.is_nan() { f64::INFINITY } else { step.max(LEAST_WAY) }
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
        let running = other(self.held);
        let (near, located) = if condition == Condition::InteriorGrazing {
            let (a, b) = (before.highest.position, after.highest.position);
            let weight = a / (a - b);
            let mut between = before.orbit + (after.orbit - before.orbit) * weight;
            let mut near = *if weight < 0.5 { before } else { after };
            near.orbit[running] = between[running];
            let located = orbits.grazing(&near, self.held).and_then(|grazing| {
                let shares = orbits.scope.window.shares(grazing.oscillator().parameters());
                between[running] = shares[running - PRIMARY];
                let mut seen = orbits.seen(&orbits.at(&between)?);
                seen.highest.position = 0.0;
                Some(seen)
            });
            (near, located)
        } else {
            let middle = (before.orbit + after.orbit) * 0.5;
            let step = (after.orbit - before.orbit).norm();
            let found = orbits.with_multiplier(&middle, condition, self.held);
            let found = found.filter(|found| (found - middle).norm() < 2.0 * step);
            let located = found.map(|orbit| orbits.seen(&orbit));
            (located.unwrap_or(*before), located)
        };
        let place = located.map(|_| self.orbits.len());
        self.orbits.extend(located);
        self.bifurcations.push(Crossing { condition, near, place });
    }
}
