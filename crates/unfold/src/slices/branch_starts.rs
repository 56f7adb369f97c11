//! The sources of the branches of a slice: their beginnings, adjacent slices, curves and columns
//! that cross it, and solutions.

use grazing_continuation::bifurcation::Bifurcation;
use grazing_continuation::curve::{Curve, CurvePoint};
use grazing_continuation::locate::{Condition, locate_within};
use grazing_continuation::mps::{EventTimes, LoopEquations, Unknowns, parameters, unknown};
use grazing_model::smooth::Purpose;

use super::{CARRIED_OFF, ChordCrossing, MOST_BRANCHES, Slice, Slicer, crossings};
use crate::curves::DiagramCurve;
use crate::grazing::{HighestPoint, multipliers};

/// Impact velocity at which branches from the grazing curve begin, beside the singular point
/// (empirical; the part in between is narrower than y² in μ), and its fraction of the root of the
/// width of a window that is not much wider than that.
const BESIDE_GRAZING: f64 = 1e-4;
const BESIDE_SHARE: f64 = 0.01;
/// Factors of this velocity that are tried: a branch begins unstable, as its trace is infinite at y
/// = 0, and where motion is strongly damped this ends closer to the singular point.
const CLOSER: [f64; 4] = [1.0, 1e-2, 1e-4, 1e-6];
/// Distances in (x, y) from a period doubling at which branches of twice the period begin; the
/// square is the distance in μ. Those of twice the half of a period are farther from the branch of
/// symmetric motion than the tolerance for lying on it.
const BESIDE_DOUBLING: [f64; 3] = [1e-3, 1e-2, 5e-2];
/// Number of solutions of a branch that are carried to a neighbouring slice.
const CARRIED: usize = 8;

impl Slicer {
    /// The branches at some η that begin on the grazing curve, or pass it, at its points (z, μ).
    pub(crate) fn beginning_at_grazing(
        &self,
        secondary: f64,
        grazing: impl IntoIterator<Item = [f64; 2]>,
    ) -> Slice {
        let mut slice = Slice::new(secondary, Vec::new());
        let beside = BESIDE_GRAZING.min(BESIDE_SHARE * self.window.widths()[0].sqrt());
        for [phase, primary] in grazing {
            let both = !self.equations.has_impacts();
            let start = if both {
                self.with_highest(&HighestPoint { height: 0.0, phase, parameters: [primary, secondary] })
            } else {
                let at = |share: &f64| {
                    let near = Unknowns::new(share * beside, phase, primary, secondary);
                    self.at(&self.equations, near, &mut EventTimes::default())
                };
                let unstable = |at: &Unknowns| !self.equations.solution(at).stable();
                let oscillator = self.equations.oscillator_at(&Unknowns::new(0.0, phase, primary, secondary));
                // Where motion is forgotten within a period the trace is finite but for rounding.
                let closer = if multipliers(&oscillator, phase).forget(self.equations.loops().min(2)) {
                    &CLOSER[..1]
                } else {
                    &CLOSER[..]
                };
                let mut starts = closer.iter().filter_map(at);
                let first = starts.next();
                first.clone().filter(unstable).or_else(|| starts.find(unstable)).or(first)
            };
            if let Some(start) = start {
                self.add(&mut slice, start, &EventTimes::default(), both);
            }
        }
        slice
    }

    /// Adds the branches of solutions of twice the period that begin where curves of period
    /// doublings cross the slice.
    pub(crate) fn beginning_at_doublings(&self, slice: &mut Slice, curves: &[DiagramCurve]) {
        let Some(halved) = &self.halved else { return };
        let doublings = curves.iter().filter(|curve| curve.kind == Bifurcation::PeriodDoubling);
        let crossings =
            doublings.flat_map(|curve| crossings(&curve.curve, unknown::SECONDARY, slice.secondary));
        let here = Condition::Secondary(slice.secondary);
        for ChordCrossing { condition, place, mut times, .. } in crossings.collect::<Vec<_>>() {
            if let Ok(at) = locate_within(CARRIED_OFF, halved, [condition, here], place, &mut times) {
                self.beginning_beside(slice, halved, at);
            }
        }
    }

    /// Adds the branch of solutions of twice the period that begins at one with the multiplier −1.
    pub(crate) fn beginning_beside(&self, slice: &mut Slice, halved: &LoopEquations, at: Unknowns) {
        let maps = halved.maps::<1>(&at, &mut EventTimes::default());
        let Some(direction) = maps.ok().and_then(|maps| maps.direction(-1.0)) else { return };
        let direction = halved.with_others(&at, Unknowns::new(direction[0], direction[1], 0.0, 0.0));
        self.beginning_aside(slice, &direction, |aside| match halved.has_impacts() {
            true => (&at + aside).followed_by(&(&at - aside), halved.loops()),
            false => &at + aside,
        });
    }

    /// Adds the branch of solutions that are not symmetric and begins at a pitchfork.
    fn beginning_at_pitchfork(&self, slice: &mut Slice, at: &Unknowns) {
        if let Some(direction) = self.equations.leaving_symmetry(at) {
            self.beginning_aside(slice, &direction, |aside| at + aside);
        }
    }

    /// Adds the branch that leaves another one in a direction, from the nearest place at which it is found.
    fn beginning_aside(
        &self,
        slice: &mut Slice,
        direction: &Unknowns,
        aside: impl Fn(&Unknowns) -> Unknowns,
    ) {
        let before = slice.branches.len();
        for distance in BESIDE_DOUBLING {
            if slice.branches.len() > before {
                break;
            }
            let near = aside(&(direction * distance));
            let held = Condition::ImpactVelocity(near[unknown::VELOCITY]);
            let conditions = [held, Condition::Secondary(slice.secondary)];
            let times = &mut EventTimes::default();
            if let Ok(start) = locate_within(CARRIED_OFF, &self.equations, conditions, near, times) {
                self.add(slice, start, &EventTimes::default(), true);
            }
        }
    }

    /// Adds the branches of a slice to which a neighbouring slice leads, and returns whether there
    /// are any; a branch is carried to a neighbour once.
    pub(crate) fn carry(&self, from: &Slice, to: &mut Slice) -> bool {
        let before = to.branches.len();
        if before >= MOST_BRANCHES {
            return false;
        }
        let taken = &mut to.taken[usize::from(from.secondary > to.secondary)];
        let (neighbour, count) = core::mem::replace(taken, (from.secondary, from.branches.len()));
        let known = if neighbour == from.secondary { count } else { 0 };
        // Most solutions lead to known branches, for which few digits are enough.
        let rough = self.control.sketches().then(|| self.equations.roughly());
        for branch in &from.branches[known..] {
            // Others would lead to pieces of a branch that is abandoned here, too.
            let points = branch.before_abandoned();
            let every = (points.len() / CARRIED).max(1);
            for point in points.iter().skip(every / 2).step_by(every) {
                let mut near = point.solution.unknowns.clone();
                near[unknown::SECONDARY] = to.secondary;
                let new = |equations: &LoopEquations| {
                    let mut times = point.times.clone();
                    let found = Purpose::Carrying.during(|| self.at(equations, near, &mut times));
                    found.filter(|start| !self.knows(to, start)).map(|start| (start, times))
                };
                let seen = rough.as_ref().is_none_or(|rough| new.clone()(rough).is_some());
                if let Some((start, times)) = seen.then(|| new(&self.equations)).flatten() {
                    self.add(to, start, &times, true);
                }
            }
        }
        to.branches.len() > before
    }

    /// Adds the branches of a slice to which curves that cross it lead, and returns whether there
    /// are any; a curve's bifurcation is added to the branch on which it lies.
    pub(crate) fn through_curves(&self, slice: &mut Slice, curves: &[DiagramCurve]) -> bool {
        let before = slice.branches.len();
        let secondary = slice.secondary;
        let here = Condition::Secondary(secondary);
        let new = core::mem::replace(&mut slice.curves, curves.len());
        let known = curves[new..].iter().map(|curve| &curve.curve);
        for ChordCrossing { condition, chord, place: near, mut times } in
            known.flat_map(|curve| crossings(curve, unknown::SECONDARY, secondary))
        {
            // The curve's point may lie on a branch that has stepped over it; at a pitchfork, on
            // two.
            let passing = |slice: &Slice, at: &Unknowns| -> Vec<usize> {
                let all = slice.branches.iter().enumerate();
                let passing = all.filter(|(_, branch)| self.passes(branch, at)).map(|(index, _)| index);
                passing.take(if condition == Condition::SymmetryBreaking { usize::MAX } else { 1 }).collect()
            };
            let known = passing(slice, &near);
            let has = |index: &usize| self.has(&slice.branches[*index], condition, &chord);
            // A branch that has the pitchfork need not have led to the other one, which begins there.
            let least = if condition == Condition::SymmetryBreaking { 2 } else { 1 };
            if known.len() >= least && known.iter().all(has) {
                continue;
            }
            let locate =
                || locate_within(CARRIED_OFF, &self.equations, [condition, here], near.clone(), &mut times);
            let found = Purpose::Carrying.during(locate);
            if let Ok(through) = found
                && self.is_real(&through)
                && self.window.contains(parameters(&through))
            {
                if known.is_empty() {
                    self.add(slice, through.clone(), &times, true);
                }
                if condition == Condition::SymmetryBreaking {
                    self.beginning_at_pitchfork(slice, &through);
                }
                // Newton's method may have gone to a bifurcation on another branch.
                for index in passing(slice, &through) {
                    self.insert(&mut slice.branches[index], condition, &through, times.clone());
                }
            }
        }
        slice.branches.len() > before
    }

    /// Adds the branches of a slice to which stable, admissible solutions on columns that cross it
    /// lead, and returns whether there are any.
    pub(crate) fn through_columns(&self, slice: &mut Slice, columns: &[Curve]) -> bool {
        let before = slice.branches.len();
        let new = core::mem::replace(&mut slice.columns, columns.len());
        let secondary = slice.secondary;
        for ChordCrossing { condition, chord, place: near, mut times } in
            columns[new..].iter().flat_map(|column| crossings(column, unknown::SECONDARY, secondary))
        {
            if self.knows(slice, &near) {
                continue;
            }
            let conditions = [condition, Condition::Secondary(secondary)];
            let reach = (&chord[1] - &chord[0]).norm();
            let locate = || locate_within(reach, &self.equations, conditions, near, &mut times);
            let found = Purpose::Carrying.during(locate);
            if let Ok(through) = found
                && self.is_real(&through)
                && self.equations.solution(&through).attracts()
            {
                self.add(slice, through, &times, true);
            }
        }
        slice.branches.len() > before
    }

    /// Adds the unknown branches through MPSs on a slice; a branch without a stable MPS is left out
    /// if the MPS from which it was found is not admissible.
    pub(crate) fn through(&self, slice: &mut Slice, solutions: impl Iterator<Item = Unknowns>) {
        let mut dismissed: Vec<Curve> = Vec::new();
        for solution in solutions {
            if dismissed.iter().any(|branch| self.passes(branch, &solution)) {
                continue;
            }
            let before = slice.branches.len();
            self.add(slice, solution.clone(), &EventTimes::default(), true);
            let Some(new) = slice.branches.get(before) else { continue };
            let start = self.equations.solution(&solution);
            let stable = |point: &CurvePoint| point.solution.stable();
            if !start.stable() && !start.admissible() && !new.points.iter().any(stable) {
                dismissed.extend(slice.branches.pop());
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use grazing_continuation::curve::{CurveEnd, Event, Window};
    use grazing_continuation::mps::Formulation;
    use grazing_model::smooth::{Stop, Units};

    use super::super::steps;
    use super::*;
    use crate::progress::Silent;
    use crate::tolerances::BETWEEN_BIFURCATIONS;
    use crate::{Diagram, Scope};

    #[test]
    fn a_branch_is_carried_to_a_neighbour_once() {
        let window = Window { primary: [0.0, 1.2], secondary: [0.6, 1.0] };
        let stop = Stop::default();
        let description = crate::specimens::unforced("-0.1*v - x - 1");
        let oscillator = description.counted([0.5, 0.8], &Units::ONE, &stop);
        let grazing = grazing_theorems::LinearOscillator::new(0.05, 1.0).and_then(|it| it.grazing(0.8));
        let grazing = grazing.expect("it is in the domain");
        let equations = LoopEquations::new(oscillator, 1, Formulation::FixedPhase);
        let slicer = Slicer::new(equations, window, steps(window));
        let from = slicer.beginning_at_grazing(0.8, [[grazing.phase(), grazing.amplitude()]]);
        let mut to = Slice::new(0.82, Vec::new());
        assert!(slicer.carry(&from, &mut to));
        let taken = stop.steps();
        // Steps are counted in lots.
        assert!(!(0..20).any(|_| slicer.carry(&from, &mut to)));
        assert_eq!(stop.steps(), taken);
        // Slices that are inserted between are other neighbours.
        for k in 1..20 {
            let between = Slice { secondary: 0.8 + 1e-3 * f64::from(k), ..from.clone() };
            slicer.carry(&between, &mut to);
        }
        assert!(stop.steps() > taken);
    }

    #[test]
    fn what_is_far_beyond_the_wall_is_abandoned_and_not_carried_piece_by_piece() {
        let window = Window { primary: [0.0, 30.0], secondary: [2.3, 6.5] };
        let description = crate::specimens::unforced("-0.05*v - x - 0.1*x^3 - 1");
        let oscillator = description.counted([20.0, 3.0], &Units::ONE, &Stop::default());
        let equations = LoopEquations::new(oscillator.clone(), 4, Formulation::FixedPhase);
        let slicer = Slicer::new(equations, window, steps(window));
        let fast = crate::search::at(&oscillator, &[4], 5.0, &Silent);
        let high = fast.iter().filter(|(_, at)| slicer.equations.solution(at).ceiling() > 5.0);
        let high: Vec<_> = high.map(|(_, at)| at.clone()).collect();
        assert!(!high.is_empty(), "{fast:?}");
        for through in high {
            let column = slicer.upwards(&through, &EventTimes::default()).expect("it is a curve");
            let points = column.points.len();
            assert!(points < 150 && matches!(column.end, CurveEnd::Abandoned), "{points} {:?}", column.end);
            assert!(column.before_abandoned().len() < points);
            let mut slices = [3.0, 3.02].map(|secondary| Slice::new(secondary, Vec::new()));
            slicer.add(&mut slices[0], through, &EventTimes::default(), true);
            let [from, to] = &mut slices;
            for _ in 0..5 {
                slicer.carry(from, to);
                slicer.carry(to, from);
            }
            assert!(from.branches.len() <= 2 && to.branches.len() <= 2, "{}", from.branches.len());
        }
    }

    #[test]
    fn a_slice_that_knows_no_branch_gets_those_through_the_curves_that_cross_it() {
        let window = Window { primary: [0.0, 1.2], secondary: [0.6, 1.0] };
        let oscillator = crate::specimens::linear(0.05, [0.5, 0.9]);
        let scope = Scope { window, loops: vec![2], start: None };
        let diagram = Diagram::compute(&oscillator, &scope, &Silent).expect("there is grazing");
        let curves: Vec<DiagramCurve> =
            diagram.curves.iter().filter(|curve| curve.loops == 2).cloned().collect();
        let slicer = Slicer::new(diagram.equations(2), window, steps(window));
        let middle =
            |curve: &DiagramCurve| curve.curve.points[curve.curve.points.len() / 2].solution.unknowns.clone();
        assert!(curves.len() > 2, "{}", curves.len());
        for crossing in curves.iter().map(middle) {
            let mut slice = Slice::new(crossing[unknown::SECONDARY], Vec::new());
            assert!(slicer.through_curves(&mut slice, &curves));
            assert!(slice.branches.iter().any(|branch| slicer.passes(branch, &crossing)), "{crossing:?}");
            // Curves are examined once.
            assert!(!slicer.through_curves(&mut slice, &curves));
        }
    }

    #[test]
    fn a_branch_that_has_stepped_over_the_bifurcations_of_known_curves_gets_them() {
        let window = Window { primary: [0.0, 1.2], secondary: [0.6, 1.0] };
        let oscillator = crate::specimens::linear(0.05, [0.5, 0.9]);
        let scope = Scope { window, loops: vec![1], start: None };
        let diagram = Diagram::compute(&oscillator, &scope, &Silent).expect("there is grazing");
        let curves: Vec<DiagramCurve> =
            diagram.curves.iter().filter(|curve| curve.loops == 1).cloned().collect();
        let slicer = Slicer::new(diagram.equations(1), window, steps(window));
        let mut looked_at = 0;
        for secondary in [0.66, 0.74, 0.82, 0.9] {
            let places = diagram.grazing.iter().flat_map(|curve| curve.all_at(secondary));
            let places = places.map(|place| [place.phase, place.parameters[0]]);
            let mut slice = slicer.beginning_at_grazing(secondary, places);
            slicer.through_curves(&mut slice, &curves);
            let places = |slice: &Slice| -> Vec<(Condition, usize, Unknowns)> {
                let events = slice.branches.iter().flat_map(|branch| &branch.events);
                events.map(|event| (event.condition, event.index, event.solution.unknowns.clone())).collect()
            };
            let known = places(&slice);
            let lies_on_a_curve = |event: &Event| {
                let crossings =
                    curves.iter().flat_map(|curve| crossings(&curve.curve, unknown::SECONDARY, secondary));
                crossings.filter(|crossing| crossing.condition == event.condition).any(|crossing| {
                    slicer.equations.gap(&crossing.place, &event.solution.unknowns).norm() < 1e-3
                })
            };
            for branch in &mut slice.branches {
                branch.events.retain(|event| !lies_on_a_curve(event));
            }
            let left = places(&slice).len();
            slice.curves = 0;
            slicer.through_curves(&mut slice, &curves);
            let found = places(&slice);
            assert_eq!(found.len(), known.len());
            for ((condition, index, at), (other, place, known)) in found.iter().zip(&known) {
                // Both were located to some 10⁻¹⁰.
                assert!((condition, index) == (other, place) && (at - known).norm() < BETWEEN_BIFURCATIONS);
            }
            looked_at += known.len() - left;
        }
        assert!(looked_at >= 4, "{looked_at}");
    }

    #[test]
    fn a_solution_half_a_turn_from_a_branch_is_not_on_it() {
        let window = Window { primary: [0.0, 1.2], secondary: [0.6, 1.0] };
        let oscillator = crate::specimens::linear(0.05, [0.5, 0.9]);
        let grazing = grazing_theorems::LinearOscillator::new(0.05, 0.9).and_then(|it| it.grazing(0.8));
        let grazing = grazing.expect("it is in the domain");
        let place = [grazing.phase(), grazing.amplitude()];
        let equations = LoopEquations::new(oscillator, 1, Formulation::FixedPhase);
        let slicer = Slicer::new(equations, window, steps(window));
        let slice = slicer.beginning_at_grazing(0.8, [place]);
        let branch = slice.branches.first().expect("it begins there");
        assert!(branch.points.len() > 5);
        for pair in branch.points.windows(2) {
            let [a, b] = [0, 1].map(|k| pair[k].solution.unknowns.clone());
            let mut middle = (a + b) * 0.5;
            assert!(slicer.passes(branch, &middle));
            middle[unknown::PHASE] += core::f64::consts::PI;
            assert!(!slicer.passes(branch, &middle));
        }
    }
}
