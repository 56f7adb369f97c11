//! Slices of the parameter plane: all branches of solutions at one value of η, with one impact in p
//! forcing periods or with none.
//!
//! A branch of MPSs begins on the grazing curve, where y = 0, on the edge of the window, or is
//! closed. Those from the grazing curve are followed from there. The others have neighbours in the
//! adjacent slices: (y, η) are coordinates of the surface of MPSs, so that an MPS is carried from
//! slice to slice at constant y. They are also found where a known bifurcation curve crosses the
//! slice. Without impacts branches pass the grazing curve, and solutions are carried at constant μ.

mod branch_starts;

use core::f64::consts::TAU;

use grazing_continuation::arclength::StepControl;
use grazing_continuation::curve::{Curve, CurvePoint, Event, Route, SolutionCurve, Window};
use grazing_continuation::locate::{Condition, locate, locate_within};
use grazing_continuation::mps::{EventTimes, LoopEquations, Unknowns, parameters, unknown};
use grazing_continuation::newton::Space;
use grazing_continuation::tolerances::RECURS;
use grazing_model::motion::Motion;
use grazing_model::phase::turned;
use grazing_model::smooth::Purpose;
use grazing_model::{ImpactOscillator, State};

use crate::copies::without_copies;
use crate::grazing::HighestPoint;
use crate::missed_bifurcations;
use crate::progress::Progress;
use crate::step_limits::{StepLimits, is_lost};
use crate::tolerances::BETWEEN_BIFURCATIONS;

/// The branches at one η, and the progress of the work on them.
#[derive(Clone, Debug)]
pub(crate) struct Slice {
    pub(crate) secondary: f64,
    pub(crate) branches: Vec<Curve>,
    /// The η of the neighbours below and above, and the number of their branches that have been
    /// carried here.
    taken: [(f64, usize); 2],
    /// The number of branches whose bifurcations have been examined.
    looked_at: usize,
    /// The numbers of curves and of columns that have been examined for branches.
    curves: usize,
    columns: usize,
}

impl Slice {
    pub(crate) fn new(secondary: f64, branches: Vec<Curve>) -> Self {
        let taken = [(f64::NAN, 0); 2];
        Self { secondary, branches, taken, looked_at: 0, curves: 0, columns: 0 }
    }

    /// The branches that have not been taken before.
    pub(crate) fn take_new(&mut self) -> &[Curve] {
        let from = core::mem::replace(&mut self.looked_at, self.branches.len());
        &self.branches[from..]
    }
}

/// Carries branches from slice to slice, in the order of η, until none has one that its neighbours
/// lack.
///
/// `carry` adds the branches of the first slice that the second lacks, and returns whether there
/// were any.
pub(crate) fn spread(
    slices: &mut [Slice],
    progress: &dyn Progress,
    carry: impl Fn(&Slice, &mut Slice) -> bool,
) {
    slices.sort_by(|a, b| a.secondary.total_cmp(&b.secondary));
    let upwards = (1..slices.len()).map(|k| [k - 1, k]);
    let both = upwards.clone().chain(upwards.rev().map(|[low, high]| [high, low]));
    let mut fresh = true;
    while core::mem::take(&mut fresh) && !progress.stopped() {
        for pair in both.clone() {
            if let Ok([from, to]) = slices.get_disjoint_mut(pair) {
                fresh |= carry(from, to);
            }
        }
    }
}

/// Steps along branches that need not be drawn: rough points are enough for the signs of events
/// between them, which are located separately (empirical: neighbouring folds and grazings of the
/// oscillators that were tried lie much farther apart, and the error of a point, some 10⁻⁷, is far
/// below the accuracy required).
const STEPS: StepControl =
    StepControl { first: 1e-3, longest: 0.1, shortest: 1e-6, turn: 0.07, tolerance: 1e-4 };
/// In a window narrower than this the error of a rough point would be visible: points there have
/// all their digits.
const ROUGHLY_SEEN: f64 = 1e-3;
/// Steps along branches without impacts, in (x, y, fractions of the ranges), that do not jump over
/// changes of the highest point (empirical).
pub(crate) const FREE_STEPS: StepControl = StepControl { turn: 0.2, ..precise(STEPS) };

/// The steps with points that have all their digits: only then it is known of a solution that it is its own mirror
/// image.
pub(crate) const fn precise(control: StepControl) -> StepControl {
    StepControl { tolerance: StepControl::DRAWING.tolerance, ..control }
}

/// The steps along branches of MPSs in a window.
pub(crate) fn steps(window: Window) -> StepControl {
    if window.widths()[0] < ROUGHLY_SEEN { precise(STEPS) } else { STEPS }
}
/// A branch is lost if it has as many points as the longest steps would make of this length, or
/// this many points.
const LONGEST_BRANCH: f64 = 500.0;
const MOST_POINTS: usize = 25_000;
/// Size of free motion above which steps become longer in proportion: fast forcing makes the unit
/// of length small compared with the wall's distance from rest.
const LARGE: f64 = 16.0;
/// An MPS this close to the chord between two points of a branch, as a fraction of its length, lies
/// on the branch: the branch deviates from the chord by an eighth of the angle by which it turns,
/// which is at most three times that of the step control.
const ON_BRANCH: f64 = 0.05;
const ON_FREE_BRANCH: f64 = 0.15;

/// Columns are at the same μ if they are this close, as a fraction of its range.
const ROUNDED: f64 = 1e-9;

/// A solution that Newton's method finds farther than this from the carried one is another one
/// (empirical; wherever the wall's distance from rest is of order one).
pub(crate) const CARRIED_OFF: f64 = 0.5;
/// Largest number of branches of a slice: a slice with more is not distinguished from one with
/// infinitely many, as of a pendulum that may have turned any number of times.
pub(crate) const MOST_BRANCHES: usize = 50;

/// The search for the branches of slices.
pub(crate) struct Slicer {
    pub(crate) equations: LoopEquations,
    pub(crate) window: Window,
    /// Steps along branches.
    pub(crate) control: StepControl,
    /// The equations of solutions of half the period, at whose period doublings branches begin.
    pub(crate) halved: Option<LoopEquations>,
}

impl Slicer {
    pub(crate) fn new(equations: LoopEquations, window: Window, control: StepControl) -> Self {
        Self { equations, window, control, halved: None }
    }

    /// The solution without impacts that has this highest point.
    pub(crate) fn with_highest(&self, highest: &HighestPoint) -> Option<Unknowns> {
        let [primary, secondary] = highest.parameters;
        let oscillator = self.equations.oscillator_at(&Unknowns::new(0.0, 0.0, primary, secondary));
        let phase = turned(highest.phase);
        let rest = (TAU - phase) / oscillator.forcing_frequency().value;
        let there = oscillator.motion(State::at_rest(highest.height, phase)).at(rest);
        let near = Unknowns::new(there.position, there.velocity, primary, secondary);
        locate(&self.equations, Condition::beside(&self.equations, &near), near, &mut EventTimes::default())
            .ok()
    }

    /// Whether a point in or near the window is a solution whose impacts have a velocity, or one without
    /// impacts, that does not recur after a part of its period.
    pub(crate) fn is_real(&self, point: &Unknowns) -> bool {
        if self.equations.has_impacts() {
            return point.lowest_velocity().1 > 0.0 && !self.equations.recurs_sooner(point);
        }
        self.halved.as_ref().is_none_or(|halved| {
            let half_way = halved.maps::<1>(point, &mut EventTimes::default());
            half_way.is_ok_and(|maps| maps.distance() > RECURS)
        })
    }

    /// Whether a solution lies on a branch.
    pub(crate) fn passes(&self, branch: &Curve, at: &Unknowns) -> bool {
        let gap = |from: &Unknowns, point: &CurvePoint| self.equations.gap(from, &point.solution.unknowns);
        let near = if self.equations.has_impacts() { ON_BRANCH } else { ON_FREE_BRANCH };
        let start = branch.points.first().is_some_and(|point| gap(at, point).norm() < STEPS.first);
        let on_chord = |pair: &[CurvePoint]| {
            near_chord(&gap(at, &pair[0]), &gap(&pair[0].solution.unknowns, &pair[1]), near)
        };
        start || branch.points.windows(2).any(on_chord)
    }

    /// Whether a solution lies on one of the branches of a slice.
    fn knows(&self, slice: &Slice, at: &Unknowns) -> bool {
        self.pass(&slice.branches, at)
    }

    /// Whether a solution lies on one of some branches, itself or half its time later.
    pub(crate) fn pass<'a>(
        &self,
        branches: impl IntoIterator<Item = &'a Curve, IntoIter: Clone>,
        at: &Unknowns,
    ) -> bool {
        let branches = branches.into_iter();
        let passes = |at: &Unknowns| branches.clone().any(|branch| self.passes(branch, at));
        passes(at) || self.half_its_time_later(at).is_some_and(|later| passes(&later))
    }

    /// Motion without impacts that recurs after several forcing periods, half of them later: another point of the
    /// plane of constant phase, through which the branch leads as well. Impacts are compared with all of a solution's.
    pub(crate) fn half_its_time_later(&self, at: &Unknowns) -> Option<Unknowns> {
        let halved = self.halved.as_ref().filter(|_| !self.equations.has_impacts())?;
        let oscillator = halved.oscillator_at(at);
        let there = oscillator.motion(halved.departure(at)).at(oscillator.forcing_period());
        let mut later = at.clone();
        (later[0], later[1]) = (there.position, there.velocity);
        Some(later)
    }

    /// The branches of a slice without those that are part of another one, beyond whose end they
    /// were started.
    pub(crate) fn distinct(&self, slice: Slice) -> Vec<Curve> {
        let mut distinct: Vec<Curve> = Vec::new();
        let part = |inner: &Curve, whole: &Curve| {
            let count = inner.points.len();
            let places = [0, count / 2, count.saturating_sub(1)].map(|place| inner.points.get(place));
            places.into_iter().flatten().all(|point| self.passes(whole, &point.solution.unknowns))
        };
        for branch in slice.branches {
            if !distinct.iter().any(|known| part(&branch, known)) {
                distinct.retain(|known| !part(known, &branch));
                distinct.push(branch);
            }
        }
        distinct
    }

    /// Whether a bifurcation on a branch lies on the chord of a curve that crosses the slice.
    fn has(&self, branch: &Curve, condition: Condition, [from, to]: &[Unknowns; 2]) -> bool {
        let chord = self.equations.gap(from, to);
        let of_kind = branch.events.iter().filter(|event| event.condition == condition);
        let mut starts = of_kind.map(|event| self.equations.gap(&event.solution.unknowns, from));
        starts.any(|start| near_chord(&start, &chord, ON_BRANCH))
    }

    /// Adds a bifurcation to a branch that has stepped over it, as over both of two that lie close
    /// together.
    fn insert(&self, branch: &mut Curve, condition: Condition, through: &Unknowns, times: EventTimes) {
        let distance = |of: &Unknowns| self.equations.gap(of, through).norm();
        let known = |event: &Event| {
            event.condition == condition && distance(&event.solution.unknowns) < BETWEEN_BIFURCATIONS
        };
        let aside = |pair: &[CurvePoint]| {
            let [from, to] = [0, 1].map(|k| &pair[k].solution.unknowns);
            distance(from) + distance(to) - self.equations.gap(from, to).norm()
        };
        let steps = branch.points.windows(2).map(aside).enumerate();
        let Some((before, _)) = steps.min_by(|a, b| a.1.total_cmp(&b.1)) else { return };
        if branch.events.iter().any(known) {
            return;
        }
        let index = before + 1;
        let start = &branch.points[before].solution.unknowns;
        let way = |of: &Unknowns| self.equations.gap(start, of).norm();
        let later = |event: &Event| {
            event.index > index || event.index == index && way(&event.solution.unknowns) > way(through)
        };
        let place = branch.events.iter().position(later).unwrap_or(branch.events.len());
        let solution = self.equations.solution(through);
        branch.events.insert(place, Event { condition, solution, index, times });
    }

    /// The solution that corresponds to `near` on the surface of solutions, if it lies in the
    /// window and nearby.
    fn at(&self, equations: &LoopEquations, near: Unknowns, times: &mut EventTimes) -> Option<Unknowns> {
        let beside = Condition::beside(equations, &near);
        let found = locate_within(CARRIED_OFF, equations, beside, near, times).ok()?;
        (!self.equations.has_impacts() || self.window.contains(parameters(&found))).then_some(found)
    }

    /// Follows the branch through a solution, to greater velocities or in both directions, unless
    /// it is known.
    pub(crate) fn add(&self, slice: &mut Slice, through: Unknowns, times: &EventTimes, both: bool) {
        if slice.branches.len() >= MOST_BRANCHES || !self.is_real(&through) || self.knows(slice, &through) {
            return;
        }
        // A branch does not leave its own η.
        let window = Window { secondary: [f64::NEG_INFINITY, f64::INFINITY], ..self.window };
        let (curve, route) = self.branch(Condition::Secondary(slice.secondary), window, &through);
        let followed = if !self.equations.has_impacts() {
            // In the order of μ.
            let pace = |points: &[CurvePoint], _: &Unknowns| {
                let goes_on = !is_lost(points) && self.is_real(&points[points.len() - 1].solution.unknowns);
                goes_on.then_some(f64::INFINITY)
            };
            let route = Route { pace: Some(&pace), ..route };
            let both_ways = || {
                let leftwards = -through.along(unknown::PRIMARY);
                curve.follow_both_ways(through.clone(), leftwards, times, &route)
            };
            Purpose::FreeBranches.during(both_ways)
        } else {
            let faster = through.along(unknown::VELOCITY);
            Purpose::Branches.during(|| match both {
                true => curve.follow_both_ways(through, faster, times, &route),
                false => curve.follow(through, faster, times.clone(), &route),
            })
        };
        slice.branches.extend(followed.map(|branch| self.whole(branch)));
        // Curves that were examined may cross the new branch.
        slice.curves = 0;
    }

    fn branch(
        &self,
        condition: Condition,
        window: Window,
        through: &Unknowns,
    ) -> (SolutionCurve, Route<'static>) {
        let curve = SolutionCurve { equations: self.equations.clone(), condition };
        let mut control = self.control;
        let step_limit = ((LONGEST_BRANCH / control.longest) as usize).min(MOST_POINTS);
        if !self.equations.has_impacts() {
            control.longest *= size(through);
        }
        (curve, Route { window, control, step_limit, stop_at_events: false, pace: None })
    }

    /// A branch with the pairs of bifurcations that it has stepped over.
    fn whole(&self, branch: Curve) -> Curve {
        let mut branch = without_copies(&self.equations, branch);
        for (condition, through, times) in missed_bifurcations::stepped_over(&self.equations, &branch) {
            self.insert(&mut branch, condition, &through, times);
        }
        branch
    }

    /// The branches at one μ to which slices of constant η lead, without those that are known.
    pub(crate) fn across(&self, slices: &[Slice], primary: f64, known: &[Curve]) -> Vec<Curve> {
        let mut branches: Vec<Curve> = Vec::new();
        let sources = slices.iter().flat_map(|slice| &slice.branches);
        let count = known.len();
        let apart = ROUNDED * self.window.widths()[0];
        let here = |at: f64| (at - primary).abs() <= apart;
        let is_here = |column: &&Curve| matches!(column.condition, Condition::Primary(at) if here(at));
        let known: Vec<&Curve> = known.iter().filter(is_here).collect();
        for ChordCrossing { place: near, mut times, .. } in
            sources.flat_map(|branch| crossings(branch, unknown::PRIMARY, primary))
        {
            let is_known = |at: &Unknowns| self.pass(known.iter().copied().chain(&branches), at);
            if is_known(&near) || count + branches.len() >= MOST_BRANCHES {
                continue;
            }
            let conditions = [Condition::Primary(primary), Condition::Secondary(near[unknown::SECONDARY])];
            let Ok(through) = locate(&self.equations, conditions, near, &mut times) else { continue };
            if self.is_real(&through) && !is_known(&through) {
                branches.extend(self.upwards(&through, &times));
            }
        }
        branches
    }

    /// The branch through a solution at constant μ.
    pub(crate) fn upwards(&self, through: &Unknowns, times: &EventTimes) -> Option<Curve> {
        let window = Window { primary: [f64::NEG_INFINITY, f64::INFINITY], ..self.window };
        let (curve, route) = self.branch(Condition::Primary(through[unknown::PRIMARY]), window, through);
        let upwards = through.along(unknown::SECONDARY);
        if self.equations.has_impacts() {
            let followed =
                Purpose::Columns.during(|| curve.follow_both_ways(through.clone(), upwards, times, &route));
            return Some(self.whole(followed.ok()?));
        }
        let pace = StepLimits::new(&self.equations, window, through);
        let pace = |points: &[CurvePoint], tangent: &Unknowns| pace.longest(points, tangent, size(through));
        let route = Route { pace: Some(&pace), ..route };
        let followed =
            Purpose::FreeBranches.during(|| curve.follow_both_ways(through.clone(), upwards, times, &route));
        Some(self.whole(followed.ok()?))
    }
}

/// The ratio of the size of motion from a state to the usual one, at least 1.
fn size(through: &Unknowns) -> f64 {
    (libm::hypot(through[0], through[1]) / LARGE).max(1.0)
}

/// A point at which a chord of a curve has a given value of one of the unknowns.
pub(crate) struct ChordCrossing {
    /// The curve's condition.
    condition: Condition,
    /// The ends of the chord.
    chord: [Unknowns; 2],
    /// The point of the chord.
    place: Unknowns,
    /// The event times nearby.
    times: EventTimes,
}

/// Points beside those at which a curve has a given value of one of the unknowns.
pub(crate) fn passing(curve: &Curve, unknown: usize, value: f64) -> impl Iterator<Item = Unknowns> {
    crossings(curve, unknown, value).map(|crossing| crossing.place)
}

/// The points at which the chords of a curve have a given value of one of the unknowns.
pub(crate) fn crossings(curve: &Curve, unknown: usize, value: f64) -> impl Iterator<Item = ChordCrossing> {
    curve.points.windows(2).filter_map(move |pair| {
        let chord = [0, 1].map(|k| pair[k].solution.unknowns.clone());
        let [a, b] = &chord;
        let [from, to] = [a, b].map(|point| point[unknown] - value);
        let crosses = from * to <= 0.0 && from != to;
        let place = a + (b - a) * (from / (from - to));
        crosses.then(|| ChordCrossing {
            condition: curve.condition,
            chord,
            place,
            times: pair[0].times.clone(),
        })
    })
}

/// Whether the distance of the origin from a chord that begins at `start` is less than a fraction
/// of its length.
pub(crate) fn near_chord<V: Space>(start: &V, chord: &V, share: f64) -> bool {
    let along = (-start.dot(chord) / chord.dot(chord)).clamp(0.0, 1.0);
    (start.clone() + chord.clone() * along).norm() < share * chord.norm()
}
