//! Slices of the parameter plane: all branches of solutions at one value of η, above all those of p-loop MPSs.
//!
//! A branch begins on the grazing curve, where y = 0, on the edge of the window, or is closed. Those from the grazing curve are
//! followed from there. The others have neighbours in the slices beside: (y, η) are coordinates of the surface of MPSs, so that
//! an MPS is carried from slice to slice with its y held. And they are met where a known bifurcation curve crosses the slice.

use core::f64::consts::TAU;

use grazing_continuation::arclength::StepControl;
use grazing_continuation::curve::{Curve, CurveEnd, CurvePoint, Event, MpsCurve, Route, Window};
use grazing_continuation::locate::{Condition, locate, locate_within};
use grazing_continuation::mps::{
    EventTimes, LoopEquations, MaximalPeriodicSolution, Unknowns, parameters, unknown,
};
use grazing_model::ImpactOscillator;
use nalgebra::SVector;

use crate::curves::DiagramCurve;
use crate::progress::Progress;

/// The branches at one η, and how far they have been worked on.
#[derive(Clone, Debug)]
pub(crate) struct Slice<B> {
    pub(crate) secondary: f64,
    pub(crate) branches: Vec<B>,
    /// They have been carried to both neighbours.
    carried: bool,
    /// The number of branches whose bifurcations have been looked at.
    looked_at: usize,
    /// The number of curves that have been looked at for branches.
    curves: usize,
}

impl<B> Slice<B> {
    pub(crate) fn new(secondary: f64, branches: Vec<B>) -> Self {
        Self { secondary, branches, carried: false, looked_at: 0, curves: 0 }
    }

    /// The branches that have not been taken before.
    pub(crate) fn take_new(&mut self) -> &[B] {
        let from = core::mem::replace(&mut self.looked_at, self.branches.len());
        &self.branches[from..]
    }
}

/// Carries branches from slice to slice, in the order of η, until none has one that its neighbours do not know.
///
/// `carry` adds what the first slice has and the second lacks, and says whether there was any.
pub(crate) fn spread<B>(
    slices: &mut [Slice<B>],
    progress: &dyn Progress,
    carry: impl Fn(&Slice<B>, &mut Slice<B>) -> bool,
) {
    slices.sort_by(|a, b| a.secondary.total_cmp(&b.secondary));
    while slices.iter().any(|slice| !slice.carried) && !progress.stopped() {
        let fresh: Vec<bool> =
            slices.iter_mut().map(|slice| !core::mem::replace(&mut slice.carried, true)).collect();
        let upwards = (1..slices.len()).map(|k| [k - 1, k]);
        let both = upwards.clone().chain(upwards.rev().map(|[low, high]| [high, low]));
        for pair in both.filter(|[from, to]| fresh[*from] || fresh[*to]) {
            if let Ok([from, to]) = slices.get_disjoint_mut(pair)
                && carry(from, to)
            {
                to.carried = false;
            }
        }
    }
}

/// A piece of a branch on which stability and admissibility do not change.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stretch {
    /// The primary parameter at its ends.
    pub(crate) primary: [f64; 2],
    /// The MPSs are stable and admissible.
    pub(crate) good: bool,
}

/// Where MPSs begin or cease to be stable or admissible.
#[derive(Clone, Debug)]
pub(crate) struct Border<'a> {
    pub(crate) primary: f64,
    /// The bifurcation; none was located where it is missing.
    pub(crate) event: Option<&'a Event>,
    /// How far the stable, admissible MPSs beside it extend in both parameters, unless grazing bounds them.
    pub(crate) reach: Option<[f64; 2]>,
}

/// Steps along branches that need not be drawn: rough points are enough for the signs of what happens between them, and that is
/// located by itself (empirical: neighbouring folds and grazings of the oscillators that were tried lie much farther apart, and the error of a
/// point, some 10⁻⁸, is far below what is read off it).
const STEPS: StepControl =
    StepControl { first: 1e-3, longest: 0.1, shortest: 1e-6, turn: 0.07, tolerance: 1e-4 };
/// In a window narrower than this the error of a rough point would be seen: there points have all their digits.
const NARROW: f64 = 1e-3;

/// The steps along branches in a window.
pub(crate) fn steps(window: Window) -> StepControl {
    match window.widths()[0] < NARROW {
        true => StepControl { tolerance: StepControl::DRAWING.tolerance, ..STEPS },
        false => STEPS,
    }
}
/// A branch with as many points as the longest steps would make of this length has lost its way.
const LONGEST_BRANCH: f64 = 500.0;
/// Branches from the grazing curve begin at this impact velocity, beside the singular point (empirical; what lies between is narrower
/// than y² in μ), and in a window that is not much wider than that at this share of the root of its width.
const BESIDE_GRAZING: f64 = 1e-4;
const BESIDE_SHARE: f64 = 0.01;
/// An MPS this close to the chord between two points of a branch, as a share of its length, lies on the branch: that leaves the chord
/// by an eighth of the angle by which it turns, which is three times that of the step control at most.
const ON_BRANCH: f64 = 0.05;
/// MPSs of a branch that are carried to a neighbouring slice.
const CARRIED: usize = 8;

/// A solution that Newton's method finds farther than this from where it was carried to is another one (empirical; wherever the wall's
/// distance from rest is of order one).
pub(crate) const CARRIED_OFF: f64 = 0.5;
/// No slice has more branches than this, or it is not told apart from one without end, as of a pendulum that may have turned any
/// number of times.
pub(crate) const MOST_BRANCHES: usize = 50;

/// What finds slices.
pub(crate) struct Slicer<'a, O> {
    pub(crate) equations: LoopEquations<O>,
    pub(crate) window: Window,
    /// Steps along branches.
    pub(crate) control: StepControl,
    /// The points (z, μ) of the grazing curve at some η.
    pub(crate) grazing: &'a (dyn Fn(f64) -> Vec<[f64; 2]> + Sync),
}

impl<O: ImpactOscillator> Slicer<'_, O> {
    pub(crate) fn new<'a>(
        equations: &LoopEquations<O>,
        window: Window,
        control: StepControl,
        grazing: &'a (dyn Fn(f64) -> Vec<[f64; 2]> + Sync),
    ) -> Slicer<'a, O> {
        Slicer { equations: equations.clone(), window, control, grazing }
    }

    /// The branches at some η that begin on the grazing curve.
    pub(crate) fn beginning_at_grazing(&self, secondary: f64) -> Slice<Curve> {
        let mut slice = Slice::new(secondary, Vec::new());
        let beside = BESIDE_GRAZING.min(BESIDE_SHARE * self.window.widths()[0].sqrt());
        for [phase, primary] in (self.grazing)(secondary) {
            let near = Unknowns::new(beside, phase, primary, secondary);
            if let Some(start) = self.at(near, &mut EventTimes::default()) {
                self.add(&mut slice, start, &EventTimes::default(), false);
            }
        }
        slice
    }

    /// Adds the branches of a slice that a neighbouring slice leads to, and says whether there are any.
    pub(crate) fn carry(&self, from: &Slice<Curve>, to: &mut Slice<Curve>) -> bool {
        let before = to.branches.len();
        for branch in &from.branches {
            let every = (branch.points.len() / CARRIED).max(1);
            for point in branch.points.iter().skip(every / 2).step_by(every) {
                let mut near = point.solution.unknowns;
                near[unknown::SECONDARY] = to.secondary;
                let mut times = point.times.clone();
                if let Some(start) = self.at(near, &mut times) {
                    self.add(to, start, &times, true);
                }
            }
        }
        to.branches.len() > before
    }

    /// Adds the branches of a slice to which curves that cross it lead, and says whether there are any.
    pub(crate) fn through_curves(&self, slice: &mut Slice<Curve>, curves: &[DiagramCurve]) -> bool {
        let before = slice.branches.len();
        let secondary = slice.secondary;
        let here = Condition::Secondary(secondary);
        let new = core::mem::replace(&mut slice.curves, curves.len());
        let known = curves[new..].iter().map(|curve| &curve.curve);
        for (condition, near, mut times) in
            known.flat_map(|curve| crossings(curve, unknown::SECONDARY, secondary))
        {
            if slice.branches.iter().any(|branch| passes(branch, &near)) {
                continue;
            }
            let found = locate_within(CARRIED_OFF, &self.equations, [condition, here], near, &mut times);
            if let Ok(through) = found
                && through[unknown::VELOCITY] > 0.0
                && self.window.contains(parameters(&through))
            {
                self.add(slice, through, &times, true);
            }
        }
        let fresh = slice.branches.len() > before;
        slice.carried &= !fresh;
        fresh
    }

    /// Adds the branches through MPSs on a slice that are not known; but none on which no MPS is both stable and admissible, if the one that it
    /// was found by is neither.
    pub(crate) fn through(&self, slice: &mut Slice<Curve>, solutions: impl Iterator<Item = Unknowns>) {
        let mut dismissed: Vec<Curve> = Vec::new();
        for solution in solutions {
            if dismissed.iter().any(|branch| passes(branch, &solution)) {
                continue;
            }
            let before = slice.branches.len();
            self.add(slice, solution, &EventTimes::default(), true);
            let Some(new) = slice.branches.get(before) else { continue };
            let start = self.equations.solution(&solution);
            if start.stable() || start.admissible() || new.points.iter().any(|point| good(&point.solution)) {
                slice.carried = false;
            } else {
                dismissed.extend(slice.branches.pop());
            }
        }
    }

    /// The MPS with the impact velocity and the η of `near`, if it lies in the window and nearby.
    fn at(&self, near: Unknowns, times: &mut EventTimes) -> Option<Unknowns> {
        let found = locate_within(CARRIED_OFF, &self.equations, beside(&near), near, times).ok()?;
        self.window.contains(parameters(&found)).then_some(found)
    }

    /// Follows the branch through an MPS, to greater velocities or to both sides, unless it is known.
    fn add(&self, slice: &mut Slice<Curve>, through: Unknowns, times: &EventTimes, both: bool) {
        if slice.branches.len() >= MOST_BRANCHES
            || slice.branches.iter().any(|branch| passes(branch, &through))
        {
            return;
        }
        // No branch leaves its own η.
        let window = Window { secondary: [f64::NEG_INFINITY, f64::INFINITY], ..self.window };
        let (curve, route) = self.branch(Condition::Secondary(slice.secondary), window);
        let upwards = Unknowns::new(1.0, 0.0, 0.0, 0.0);
        let followed = if both {
            curve.follow_both_ways(through, upwards, times, &route)
        } else {
            curve.follow(through, upwards, times.clone(), &route)
        };
        slice.branches.extend(followed);
    }

    fn branch(&self, condition: Condition, window: Window) -> (MpsCurve<O>, Route) {
        let curve = MpsCurve { equations: self.equations.clone(), condition };
        let step_limit = (LONGEST_BRANCH / self.control.longest) as usize;
        let route = Route { window, control: self.control, step_limit, stop_at_events: false };
        (curve, route)
    }

    /// The branches at one μ to which slices of constant η lead.
    pub(crate) fn across(&self, slices: &[Slice<Curve>], primary: f64) -> Vec<Curve> {
        let window = Window { primary: [f64::NEG_INFINITY, f64::INFINITY], ..self.window };
        let (curve, route) = self.branch(Condition::Primary(primary), window);
        let mut branches: Vec<Curve> = Vec::new();
        let known = slices.iter().flat_map(|slice| &slice.branches);
        for (_, near, mut times) in known.flat_map(|branch| crossings(branch, unknown::PRIMARY, primary)) {
            if branches.iter().any(|branch| passes(branch, &near)) {
                continue;
            }
            let conditions = [Condition::Primary(primary), Condition::Secondary(near[unknown::SECONDARY])];
            let Ok(through) = locate(&self.equations, conditions, near, &mut times) else { continue };
            if through[unknown::VELOCITY] > 0.0 && !branches.iter().any(|branch| passes(branch, &through)) {
                let upwards = Unknowns::new(0.0, 0.0, 0.0, 1.0);
                branches.extend(curve.clone().follow_both_ways(through, upwards, &times, &route));
            }
        }
        branches
    }
}

/// The branches without those that are part of another, which they were begun beyond the end of.
pub(crate) fn distinct(branches: Vec<Curve>) -> Vec<Curve> {
    let mut distinct: Vec<Curve> = Vec::new();
    let part = |inner: &Curve, whole: &Curve| {
        let count = inner.points.len();
        let places = [0, count / 2, count.saturating_sub(1)].map(|place| inner.points.get(place));
        places.into_iter().flatten().all(|point| passes(whole, &point.solution.unknowns))
    };
    for branch in branches {
        if !distinct.iter().any(|known| part(&branch, known)) {
            distinct.retain(|known| !part(known, &branch));
            distinct.push(branch);
        }
    }
    distinct
}

/// The conditions that hold the η and the impact velocity of a point.
fn beside(point: &Unknowns) -> [Condition; 2] {
    [Condition::Secondary(point[unknown::SECONDARY]), Condition::ImpactVelocity(point[unknown::VELOCITY])]
}

/// Where the chords of a curve take a value of one of the unknowns: the curve's condition, the point and the event times nearby.
pub(crate) fn crossings(
    curve: &Curve,
    unknown: usize,
    value: f64,
) -> impl Iterator<Item = (Condition, Unknowns, EventTimes)> {
    curve.points.windows(2).filter_map(move |pair| {
        let [a, b] = [0, 1].map(|k| pair[k].solution.unknowns);
        let [from, to] = [a, b].map(|point| point[unknown] - value);
        let crosses = from * to <= 0.0 && from != to;
        crosses.then(|| (curve.condition, a + (b - a) * (from / (from - to)), pair[0].times.clone()))
    })
}

/// Whether an MPS lies on a branch.
fn passes(branch: &Curve, at: &Unknowns) -> bool {
    let gap = |point: &CurvePoint| {
        let mut gap = point.solution.unknowns - at;
        gap[unknown::PHASE] = libm::remainder(gap[unknown::PHASE], TAU);
        gap
    };
    let start = branch.points.first().is_some_and(|point| gap(point).norm() < STEPS.first);
    let chord = |pair: &[CurvePoint]| pair[1].solution.unknowns - pair[0].solution.unknowns;
    start || branch.points.windows(2).any(|pair| near_chord(&gap(&pair[0]), &chord(pair), ON_BRANCH))
}

/// Whether the origin lies nearer to a chord that begins at `start` than a share of its length.
pub(crate) fn near_chord<const N: usize>(
    start: &SVector<f64, N>,
    chord: &SVector<f64, N>,
    share: f64,
) -> bool {
    let along = (-start.dot(chord) / chord.norm_squared()).clamp(0.0, 1.0);
    (start + chord * along).norm() < share * chord.norm()
}

/// A point of a branch: one of the curve's, or an event.
pub(crate) struct Vertex<'a> {
    pub(crate) solution: &'a MaximalPeriodicSolution,
    pub(crate) event: Option<&'a Event>,
}

/// The points of a branch with its events in their places.
pub(crate) fn vertices(branch: &Curve) -> Vec<Vertex<'_>> {
    fn happens(event: &Event) -> Vertex<'_> {
        Vertex { solution: &event.solution, event: Some(event) }
    }
    let mut vertices = Vec::with_capacity(branch.points.len() + branch.events.len());
    let mut events = branch.events.iter().peekable();
    for (index, point) in branch.points.iter().enumerate() {
        while let Some(event) = events.next_if(|event| event.index <= index) {
            vertices.push(happens(event));
        }
        vertices.push(Vertex { solution: &point.solution, event: None });
    }
    vertices.extend(events.map(happens));
    vertices
}

/// A stable MPS of the hybrid system.
fn good(solution: &MaximalPeriodicSolution) -> bool {
    solution.stable() && solution.admissible()
}

/// The stretches of a branch and what lies between them, if MPSs are stable and admissible on one of both.
pub(crate) fn stretches<'a, O: ImpactOscillator>(
    equations: &LoopEquations<O>,
    branch: &'a Curve,
) -> (Vec<Stretch>, Vec<Border<'a>>) {
    let vertices = vertices(branch);
    let status = |pair: &[Vertex<'_>]| {
        let [a, b] = [&pair[0], &pair[1]];
        match [a.event, b.event] {
            [None, _] => good(a.solution),
            [_, None] => good(b.solution),
            // Two events in a row: what lies between is looked at.
            _ => middle_of(equations, a.solution, b.solution).is_some_and(|solution| good(&solution)),
        }
    };
    let primary = |vertex: &Vertex<'_>| vertex.solution.parameters()[0];
    let stretches: Vec<Stretch> = vertices
        .windows(2)
        .map(|pair| Stretch { primary: [primary(&pair[0]), primary(&pair[1])], good: status(pair) })
        .collect();
    let mut borders: Vec<Border<'a>> = Vec::new();
    let mut end = 0;
    for run in stretches.chunk_by(|a, b| a.good == b.good) {
        let start = end;
        end += run.len();
        if run[0].good {
            let all = &vertices[start..=end];
            // Grazing may bound as little, and matters.
            let grazes = |vertex: &Vertex<'_>| {
                vertex.event.is_some_and(|it| it.condition == Condition::InteriorGrazing)
            };
            let places = || all.iter().map(|vertex| vertex.solution.parameters());
            let extent = |k: usize| {
                let [least, greatest] = [f64::min, f64::max].map(|of| places().map(|at| at[k]).reduce(of));
                greatest.zip(least).map_or(0.0, |(greatest, least)| greatest - least)
            };
            let reach = (!all.iter().any(grazes)).then(|| [0, 1].map(extent));
            let inner = [start, end].into_iter().filter(|k| 0 < *k && *k < stretches.len());
            borders.extend(inner.map(|k| Border {
                primary: primary(&vertices[k]),
                event: vertices[k].event,
                reach,
            }));
        }
    }
    (stretches, borders)
}

/// The MPS with the mean impact velocity of two neighbours on a branch.
fn middle_of<O: ImpactOscillator>(
    equations: &LoopEquations<O>,
    a: &MaximalPeriodicSolution,
    b: &MaximalPeriodicSolution,
) -> Option<MaximalPeriodicSolution> {
    let middle = (a.unknowns + b.unknowns) * 0.5;
    let found = locate(equations, beside(&middle), middle, &mut EventTimes::default()).ok()?;
    Some(equations.solution(&found))
}

/// A branch whose multipliers exceed this may end anywhere: it runs into motion that escapes, over a hill of a potential say, and in its neighbourhood
/// parameters matter so much that what stable stretches there may be are shorter than a diagram is drawn (empirical: none was seen by simulation).
const VIOLENT: f64 = 1e3;

/// The primary parameters at which a branch could not be followed to its end, with what happened.
pub(crate) fn broken_at(branch: &Curve) -> impl Iterator<Item = (f64, String)> {
    let ends =
        [(branch.points.first(), branch.beginning.as_ref()), (branch.points.last(), Some(&branch.end))];
    ends.into_iter().filter_map(|(point, end)| {
        let reason = match end? {
            CurveEnd::LeftWindow | CurveEnd::Grazing | CurveEnd::Closed | CurveEnd::Event(_) => return None,
            CurveEnd::EventNotLocated { failure, .. } => {
                format!("a bifurcation was seen and not located: {failure}")
            }
            CurveEnd::Stalled(stall) => format!("no further point was found: {stall}"),
            CurveEnd::StepLimit => format!("after {} points there was no end", branch.points.len()),
        };
        let last = &point?.solution;
        (last.multipliers.size() <= VIOLENT).then(|| (last.parameters()[0], reason))
    })
}

#[cfg(test)]
mod tests {
    use grazing_continuation::mps::Formulation;
    use grazing_model::LinearOscillator;

    use super::*;
    use crate::progress::Silent;
    use crate::{Diagram, Scope};

    #[test]
    fn a_solution_half_a_turn_from_a_branch_is_not_on_it() {
        let window = Window { primary: [0.0, 1.2], secondary: [0.6, 1.0] };
        let oscillator = LinearOscillator::new(0.05, 0.9, 0.5, 0.9).expect("it is in the domain");
        let grazing = grazing_theorems::LinearOscillator::new(0.05, 0.9).and_then(|it| it.grazing(0.8));
        let grazing = grazing.expect("it is in the domain");
        let place = [grazing.phase(), grazing.amplitude()];
        let equations = LoopEquations::new(oscillator, 1, Formulation::FixedPhase);
        let places = move |_| vec![place];
        let slice = Slicer::new(&equations, window, steps(window), &places).beginning_at_grazing(0.8);
        let branch = slice.branches.first().expect("it begins there");
        assert!(branch.points.len() > 5);
        for pair in branch.points.windows(2) {
            let [a, b] = [0, 1].map(|k| pair[k].solution.unknowns);
            let mut middle = (a + b) * 0.5;
            assert!(passes(branch, &middle));
            middle[unknown::PHASE] += core::f64::consts::PI;
            assert!(!passes(branch, &middle));
        }
    }

    #[test]
    fn a_slice_that_knows_no_branch_gets_those_through_the_curves_that_cross_it() {
        let window = Window { primary: [0.0, 1.2], secondary: [0.6, 1.0] };
        let oscillator = LinearOscillator::new(0.05, 0.9, 0.5, 0.9).expect("it is in the domain");
        let scope = Scope { window, loops: vec![2], start: None };
        let diagram = Diagram::compute(&oscillator, &scope, &Silent).expect("there is grazing");
        let curves: Vec<DiagramCurve> =
            diagram.curves.iter().filter(|curve| curve.loops == 2).cloned().collect();
        let slicer = Slicer::new(&diagram.equations(2), window, steps(window), &|_| Vec::new());
        let middle =
            |curve: &DiagramCurve| curve.curve.points[curve.curve.points.len() / 2].solution.unknowns;
        assert!(curves.len() > 2, "{}", curves.len());
        for crossing in curves.iter().map(middle) {
            let mut slice = Slice::new(crossing[unknown::SECONDARY], Vec::new());
            assert!(slicer.through_curves(&mut slice, &curves));
            assert!(slice.branches.iter().any(|branch| passes(branch, &crossing)), "{crossing}");
            // They are looked at once.
            assert!(!slicer.through_curves(&mut slice, &curves));
        }
    }
}
