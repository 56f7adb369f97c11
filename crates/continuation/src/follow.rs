//! Following a curve of MPSs point by point: events, changes of formulation, ends.

use core::ops::ControlFlow;

use grazing_model::ImpactOscillator;
use grazing_model::maps::MapError;

use crate::arclength::{Continuation, FEWEST_OF_A_LOOP, Stall, Station, StepControl, back_at};
use crate::bifurcation::Bifurcation;
use crate::curve::{Curve, CurveEnd, CurvePoint, Event, MpsCurve, Pace, Route};
use crate::locate::{Condition, LocateFailure, locate_grazing_end, locate_within};
use crate::mps::{
    EventTimes, MaximalPeriodicSolution, Multipliers, Stability, Unknowns, parameters, unknown,
};
use crate::tolerances::{
    CUTS, FARTHEST_EVENT, FARTHEST_ITERATE, LOST_MULTIPLIERS, LOST_POINTS, NO_VELOCITY, ON_TWO_CURVES,
    TOUCHES_TOO,
};

type MpsStation = Station<4, EventTimes>;

/// So far along the tangent the maxima of loops that touch the wall at y = 0 have left it by more than the tangent is off, and by more than rounding.
const BESIDE_GRAZING: f64 = 1e-6;

impl<O: ImpactOscillator> MpsCurve<O> {
    /// Follows the curve from `start`, to the side of `direction`, until it ends.
    ///
    /// In the formulation of the equations, [`FixedPhase`](crate::mps::Formulation::FixedPhase) as a rule: where VIVID ends, the curve ends.
    ///
    /// # Errors
    /// The curve cannot be started: the equations are undefined or have no unique tangent at `start`.
    pub fn follow(
        self,
        start: Unknowns,
        direction: Unknowns,
        times: EventTimes,
        route: &Route,
    ) -> Result<Curve, Stall<MapError>> {
        self.follow_at_pace(start, direction, times, route, &|_, _| Some(f64::INFINITY))
    }

    fn follow_at_pace(
        self,
        start: Unknowns,
        direction: Unknowns,
        times: EventTimes,
        route: &Route,
        pace: &Pace<'_>,
    ) -> Result<Curve, Stall<MapError>> {
        let here = Continuation::new(&self, route.control, start, direction, times)?.here().clone();
        let mut follower = Follower {
            route,
            pace,
            signs: starting_signs(&self, &here),
            curve: Curve {
                condition: self.condition,
                points: vec![starting_point(&self, &here)],
                events: Vec::new(),
                end: CurveEnd::StepLimit,
                beginning: None,
            },
        };
        if let Some(stall) = follower.walk(&self, here) {
            follower.curve.end = CurveEnd::Stalled(stall);
        }
        Ok(follower.curve)
    }

    /// Follows the curve through a point of it to both sides: first to the side of `direction`, then to the other, in one list.
    ///
    /// # Errors
    /// As [`follow`](Self::follow).
    pub fn follow_both_ways(
        self,
        through: Unknowns,
        direction: Unknowns,
        times: &EventTimes,
        route: &Route,
    ) -> Result<Curve, Stall<MapError>> {
        self.follow_both_ways_at_pace(through, direction, times, route, &|_, _| Some(f64::INFINITY))
    }

    /// The same at a pace.
    ///
    /// # Errors
    /// As [`follow`](Self::follow).
    pub fn follow_both_ways_at_pace(
        self,
        through: Unknowns,
        direction: Unknowns,
        times: &EventTimes,
        route: &Route,
        pace: &Pace<'_>,
    ) -> Result<Curve, Stall<MapError>> {
        let mut before = self.clone().follow_at_pace(through, direction, times.clone(), route, pace)?;
        if matches!(before.end, CurveEnd::Closed) {
            return Ok(before);
        }
        let after = self.clone().follow_at_pace(through, -direction, times.clone(), route, pace)?;
        let condition =
            self.bifurcation_between(before.points.get(1), &before.points[0], after.points.get(1));
        // The point stands in both.
        let mut shared = before.points.len() - 1;
        before.points.reverse();
        // An event lies before the point of its index, and beyond it once the order is turned.
        before.events.reverse();
        before.events.iter_mut().for_each(|event| event.index = shared + 1 - event.index);
        if let Some(condition) = condition
            && let Some(CurvePoint { solution, times }) = before.points.pop()
        {
            before.events.push(Event { condition, solution, index: shared, times });
            shared -= 1;
        }
        before.points.extend(after.points.into_iter().skip(1));
        let later = after.events.into_iter().map(|event| Event { index: event.index + shared, ..event });
        before.events.extend(later);
        (before.beginning, before.end) = (Some(before.end), after.end);
        Ok(before)
    }

    /// The bifurcation that a point of a one-parameter branch is itself, by which its neighbours on the branch differ.
    ///
    /// To neither side a sign changes beyond it, so that it is not seen on the way.
    fn bifurcation_between(
        &self,
        before: Option<&CurvePoint>,
        at: &CurvePoint,
        after: Option<&CurvePoint>,
    ) -> Option<Condition> {
        if !self.is_branch() {
            return None;
        }
        let stability =
            |point: &CurvePoint| self.equations.solution_and_stability(&point.solution.unknowns).1;
        let here = stability(at);
        let [before, after] = [stability(before?), stability(after?)];
        let vanishes = |event: &Condition| {
            let [Some(before), Some(here), Some(after)] =
                [&before, &here, &after].map(|stability| vanishing(*event, stability))
            else {
                return false;
            };
            here.abs() <= ON_TWO_CURVES && before * after < 0.0
        };
        EVENTS.into_iter().find(vanishes)
    }

    /// A one-parameter branch.
    fn is_branch(&self) -> bool {
        matches!(self.condition, Condition::Primary(_) | Condition::Secondary(_))
    }
}

/// A curve in the making.
struct Follower<'a> {
    route: &'a Route,
    pace: &'a Pace<'a>,
    curve: Curve,
    signs: Option<Signs>,
}

/// What can happen to the solution along a curve.
const EVENTS: [Condition; 3] = [
    Bifurcation::SaddleNode.condition(),
    Bifurcation::PeriodDoubling.condition(),
    Bifurcation::Grazing.condition(),
];
/// The place of admissibility in [`Signs`].
const INADMISSIBLE: usize = 2;

/// Signs of the functions that vanish at the [`EVENTS`]; unknown where that was not looked at.
type Signs = [Option<bool>; EVENTS.len()];

/// What vanishes at a bifurcation that multipliers show.
fn vanishing(event: Condition, stability: &Stability) -> Option<f64> {
    match event {
        Condition::SADDLE_NODE => Some(stability.saddle_node),
        Condition::PERIOD_DOUBLING => Some(stability.period_doubling),
        _ => None,
    }
}

impl Follower<'_> {
    /// Goes on until the curve ends (`None`) or no further point is found.
    fn walk<O: ImpactOscillator>(
        &mut self,
        equations: &MpsCurve<O>,
        mut here: MpsStation,
    ) -> Option<Stall<MapError>> {
        let control = self.route.control;
        // What happens on a sketch is located by itself, with all digits.
        let rough = control
            .sketches()
            .then(|| MpsCurve { equations: equations.equations.roughly(), condition: equations.condition });
        let walked = rough.as_ref().unwrap_or(equations);
        let walker = Continuation::new(walked, control, here.point, here.tangent, here.carried.clone());
        let mut walker = match walker {
            Ok(walker) => walker,
            Err(stall) => return Some(stall),
        };
        while self.curve.points.len() <= self.route.step_limit && !self.is_lost() {
            here = walker.here().clone();
            let Some(longest) = (self.pace)(&self.curve.points, &here.tangent) else { break };
            walker.limit(longest);
            let after = match walker.advance() {
                Ok(station) => station.clone(),
                Err(stall) => return Some(stall),
            };
            if let ControlFlow::Break(end) = self.accept(equations, &here, after) {
                self.curve.end = end;
                return None;
            }
        }
        None
    }

    /// Whether a sketch has been among violent motion for long.
    fn is_lost(&self) -> bool {
        let points = &self.curve.points;
        let violent = |point: &CurvePoint| point.solution.multipliers.size() > LOST_MULTIPLIERS;
        self.route.control.sketches()
            && points.len() > LOST_POINTS
            && points.iter().rev().take(LOST_POINTS).all(violent)
    }

    /// Takes in the next point, unless the curve ends before it.
    fn accept<O: ImpactOscillator>(
        &mut self,
        equations: &MpsCurve<O>,
        before: &MpsStation,
        after: MpsStation,
    ) -> ControlFlow<CurveEnd> {
        let velocity = after.point[unknown::VELOCITY];
        let grazes = velocity <= NO_VELOCITY && velocity < before.point[unknown::VELOCITY];
        if equations.equations.has_impacts() && grazes {
            return ControlFlow::Break(self.end_at_grazing(equations, before, &after));
        }
        let (solution, now) = self.seen(equations, &after);
        if let Some(mut past) = self.signs {
            if past[INADMISSIBLE].is_none() && now[INADMISSIBLE].is_some() {
                past[INADMISSIBLE] = Some(equations.equations.solution(&before.point).touches());
            }
            if self.matters(past, now, &solution) {
                self.locate_events(equations, past, now, before, &after, &solution)?;
            }
        }
        self.signs = Some(now);
        if let Some(start) = self.back_at_the_start(before, &after, equations.equations.angle()) {
            self.curve.points.push(start);
            return ControlFlow::Break(CurveEnd::Closed);
        }
        if !self.route.window.contains(parameters(&after.point)) {
            self.end_on_the_edge(equations, before, after);
            return ControlFlow::Break(CurveEnd::LeftWindow);
        }
        self.curve.points.push(CurvePoint { solution, times: after.carried });
        ControlFlow::Continue(())
    }

    /// The MPS at a point and the signs there; if the curve is sketched, as the corrector has left them, and admissibility only where
    /// it or the one before is stable.
    fn seen<O: ImpactOscillator>(
        &self,
        equations: &MpsCurve<O>,
        station: &MpsStation,
    ) -> (MaximalPeriodicSolution, Signs) {
        match station.carried.stability.filter(|_| self.route.control.sketches()) {
            Some(stability) => {
                let before = self.curve.points.last().is_some_and(|point| point.solution.stable());
                let with_maxima = before || stability.multipliers.stable();
                let solution = equations.equations.sketch(&station.point, stability.multipliers, with_maxima);
                let mut signs = signs(equations.condition, &stability, &solution);
                signs[INADMISSIBLE] = signs[INADMISSIBLE].filter(|_| with_maxima);
                (solution, signs)
            }
            None => {
                let (solution, stability) = equations.equations.solution_and_stability(&station.point);
                (solution, signs(equations.condition, &stability, &solution))
            }
        }
    }

    /// Whether something happens before the next point that is to be located: on a sketch a single event between two MPSs neither of
    /// which is stable and admissible is not.
    fn matters(&self, past: Signs, now: Signs, next: &MaximalPeriodicSolution) -> bool {
        let good = |solution: &MaximalPeriodicSolution| solution.stable() && solution.admissible();
        let either = || good(next) || self.curve.points.last().is_some_and(|point| good(&point.solution));
        match changes(past, now).count() {
            0 => false,
            1 => !self.route.control.sketches() || either(),
            _ => true,
        }
    }

    /// The first point, if the curve passes it between two of its points; with the phase as far on as it is then.
    fn back_at_the_start(
        &self,
        before: &MpsStation,
        after: &MpsStation,
        angle: Option<usize>,
    ) -> Option<CurvePoint> {
        let [first, second, ..] = self.curve.points.as_slice() else { return None };
        if self.curve.points.len() <= FEWEST_OF_A_LOOP {
            return None;
        }
        let start = first.solution.unknowns;
        let onwards = second.solution.unknowns - start;
        let way = [&before.point, &after.point];
        let back = back_at((start, onwards), way, self.route.control.turn, angle)?;
        let mut point = first.clone();
        point.solution.unknowns = back;
        Some(point)
    }

    /// Locates all events between two points and lists them in the order of the curve.
    fn locate_events<O: ImpactOscillator>(
        &mut self,
        equations: &MpsCurve<O>,
        past: Signs,
        now: Signs,
        before: &MpsStation,
        after: &MpsStation,
        beyond: &MaximalPeriodicSolution,
    ) -> ControlFlow<CurveEnd> {
        let index = self.curve.points.len();
        let mut located = Vec::new();
        for event in changes(past, now) {
            let condition = EVENTS[event];
            let found = locate_event(equations, condition, before, after, beyond);
            match found.or_else(|failure| {
                self.located_closer(equations, event, past[event], [before, after]).ok_or(failure)
            }) {
                Ok((solution, times)) => located.push(Event { condition, solution, index, times }),
                // Where branches cross for the sake of a symmetry, or rest touches the wall, motion without impacts goes on.
                Err(_) if !equations.equations.has_impacts() => {}
                Err(failure) => {
                    return ControlFlow::Break(CurveEnd::EventNotLocated { condition, failure });
                }
            }
        }
        let way = |event: &Event| before.tangent.dot(&(event.solution.unknowns - before.point));
        located.sort_by(|a, b| way(a).total_cmp(&way(b)));
        // What lies beyond the edge is not on the curve, which ends there.
        let inside = |event: &Event| self.route.window.contains(event.solution.parameters());
        for event in located.into_iter().filter(inside) {
            self.curve.events.push(event.clone());
            if self.route.stop_at_events {
                self.curve.points.push(CurvePoint { solution: event.solution, times: event.times.clone() });
                return ControlFlow::Break(CurveEnd::Event(Box::new(event)));
            }
        }
        ControlFlow::Continue(())
    }

    /// Locates an event that Newton's method does not find from the middle of the step: the step is cut about it, over and over.
    fn located_closer<O: ImpactOscillator>(
        &self,
        equations: &MpsCurve<O>,
        event: usize,
        past: Option<bool>,
        [before, after]: [&MpsStation; 2],
    ) -> Option<(MaximalPeriodicSolution, EventTimes)> {
        let comes_later = |middle: &MpsStation| {
            let (solution, stability) = equations.equations.solution_and_stability(&middle.point);
            signs(equations.condition, &stability, &solution)[event] == past
        };
        let located = |before: &MpsStation, after: &MpsStation| {
            let beyond = equations.equations.solution(&after.point);
            locate_event(equations, EVENTS[event], before, after, &beyond).ok()
        };
        self.cut(equations, [before, after], comes_later, located)
    }

    /// Cuts a step about a place that lies in it until the place is located.
    fn cut<O: ImpactOscillator, T>(
        &self,
        equations: &MpsCurve<O>,
        [before, after]: [&MpsStation; 2],
        comes_later: impl Fn(&MpsStation) -> bool,
        located: impl Fn(&MpsStation, &MpsStation) -> Option<T>,
    ) -> Option<T> {
        let (mut before, mut after) = (before.clone(), after.clone());
        for _ in 0..CUTS {
            let half = 0.5 * equations.equations.gap(&before.point, &after.point).norm();
            if half < self.route.control.shortest {
                return None;
            }
            let tolerance = StepControl::DRAWING.tolerance;
            let control = StepControl { first: half, longest: half, tolerance, ..self.route.control };
            let (point, tangent, times) = (before.point, before.tangent, before.carried.clone());
            let mut walker = Continuation::new(equations, control, point, tangent, times).ok()?;
            let middle = walker.advance().ok()?.clone();
            if comes_later(&middle) {
                before = middle;
                continue;
            }
            after = middle;
            if let Some(found) = located(&before, &after) {
                return Some(found);
            }
        }
        None
    }

    /// Ends the curve where the impact velocity vanishes.
    fn end_at_grazing<O: ImpactOscillator>(
        &mut self,
        equations: &MpsCurve<O>,
        before: &MpsStation,
        after: &MpsStation,
    ) -> CurveEnd {
        let condition = Condition::ImpactVelocity(0.0);
        let at_zero = |before: &MpsStation, after: &MpsStation| {
            let near = on_chord(&before.point, &after.point, unknown::VELOCITY, 0.0);
            let mut times = after.carried.clone();
            let located = match equations.condition {
                Condition::InteriorGrazing => locate_grazing_end(&equations.equations, near, &mut times)
                    .and_then(|point| on_step(point, near, [before, after])),
                _ => located_near(equations, condition, near, [before, after], &mut times),
            };
            located.map(|point| (point, times))
        };
        let located = at_zero(before, after).or_else(|failure| {
            let comes_later = |middle: &MpsStation| middle.point[unknown::VELOCITY] > NO_VELOCITY;
            let closer = |before: &MpsStation, after: &MpsStation| at_zero(before, after).ok();
            self.cut(equations, [before, after], comes_later, closer).ok_or(failure)
        });
        let (mut point, times) = match located {
            Ok(found) => found,
            Err(failure) => return CurveEnd::EventNotLocated { condition, failure },
        };
        point[unknown::VELOCITY] = 0.0;
        let mut solution = equations.equations.limiting_solution(&point, &after.tangent);
        let control = self.route.control;
        match Continuation::new(equations, control, point, after.tangent, times.clone()) {
            Ok(end) if equations.condition != Condition::InteriorGrazing => {
                solution = equations.equations.limiting_solution(&point, &end.here().tangent);
            }
            // An end of interior grazing is a branch point, without a unique tangent along which to take limits.
            _ => solution.multipliers = Multipliers { trace: f64::NAN, determinant: f64::NAN },
        }
        self.curve.points.push(CurvePoint { solution, times });
        CurveEnd::Grazing
    }

    /// Adds the point at which the curve crosses the edge of the window, or the point beyond if it cannot be located.
    fn end_on_the_edge<O: ImpactOscillator>(
        &mut self,
        equations: &MpsCurve<O>,
        before: &MpsStation,
        after: MpsStation,
    ) {
        let window = &self.route.window;
        let outside = after.point;
        let mut times = after.carried.clone();
        let edges = [(unknown::PRIMARY, window.primary), (unknown::SECONDARY, window.secondary)];
        let crossing = edges.into_iter().find_map(|(coordinate, [low, high])| {
            let value = outside[coordinate];
            if low <= value && value <= high {
                return None;
            }
            let edge = if value < low { low } else { high };
            let condition = match coordinate {
                unknown::PRIMARY => Condition::Primary(edge),
                _ => Condition::Secondary(edge),
            };
            let near = on_chord(&before.point, &outside, coordinate, edge);
            let mut point = located_near(equations, condition, near, [before, &after], &mut times).ok()?;
            point[coordinate] = edge;
            window.contains(parameters(&point)).then_some(point)
        });
        let solution = equations.equations.solution(&crossing.unwrap_or(outside));
        self.curve.points.push(CurvePoint { solution, times });
    }
}

/// Whether a point of the curve is one of the grazing curve, with y = 0.
fn is_at_grazing<O: ImpactOscillator>(equations: &MpsCurve<O>, point: &Unknowns) -> bool {
    equations.equations.has_impacts() && point[unknown::VELOCITY] == 0.0
}

/// The first point; at y = 0 its multipliers are limits along the tangent.
fn starting_point<O: ImpactOscillator>(equations: &MpsCurve<O>, first: &MpsStation) -> CurvePoint {
    let solution = if is_at_grazing(equations, &first.point) {
        equations.equations.limiting_solution(&first.point, &first.tangent)
    } else {
        equations.equations.solution(&first.point)
    };
    CurvePoint { solution, times: first.carried.clone() }
}

/// The signs at the start, unless it is itself a codimension-two point, where one of the functions vanishes.
fn starting_signs<O: ImpactOscillator>(equations: &MpsCurve<O>, first: &MpsStation) -> Option<Signs> {
    let (mut solution, stability) = equations.equations.solution_and_stability(&first.point);
    let at_grazing = is_at_grazing(equations, &first.point);
    if at_grazing {
        // The maxima of all loops touch the wall there; where they go from there is to be seen a little farther on.
        solution = equations.equations.solution(&(first.point + first.tangent * BESIDE_GRAZING));
    }
    let clear = match equations.condition {
        // Where another maximum touches the wall its sign is a toss-up.
        Condition::Multiplier(_) => at_grazing || solution.ceiling().abs() > TOUCHES_TOO,
        _ => stability.saddle_node.abs().min(stability.period_doubling.abs()) > ON_TWO_CURVES,
    };
    clear.then(|| signs(equations.condition, &stability, &solution))
}

/// On a curve of fixed multiplier the other multiplier is positive or negative throughout: only grazing can happen there.
fn signs(along: Condition, stability: &Stability, solution: &MaximalPeriodicSolution) -> Signs {
    EVENTS.map(|event| match vanishing(event, stability) {
        Some(value) => (!matches!(along, Condition::Multiplier(_))).then_some(value > 0.0),
        None => Some(solution.touches()),
    })
}

/// The places in [`EVENTS`] of those between which signs differ.
fn changes(past: Signs, now: Signs) -> impl Iterator<Item = usize> {
    let differ = |a: Option<bool>, b: Option<bool>| a.is_some_and(|a| b.is_some_and(|b| a != b));
    (0..EVENTS.len()).filter(move |event| differ(past[*event], now[*event]))
}

/// Locates an event between two points of the curve; `beyond` is the MPS at the second.
fn locate_event<O: ImpactOscillator>(
    equations: &MpsCurve<O>,
    condition: Condition,
    before: &MpsStation,
    after: &MpsStation,
    beyond: &MaximalPeriodicSolution,
) -> Result<(MaximalPeriodicSolution, EventTimes), LocateFailure> {
    let mut times = after.carried.clone();
    let mut near = (before.point + after.point) * 0.5;
    let mut sought = condition;
    if condition == Condition::InteriorGrazing {
        // The maximum that crosses the wall is the highest one at whichever end is inadmissible.
        let solution = if beyond.touches() {
            near = after.point;
            *beyond
        } else {
            near = before.point;
            times = before.carried.clone();
            equations.equations.solution(&before.point)
        };
        if let Some(maximum) = solution.highest_interior_maximum {
            if equations.condition == Condition::InteriorGrazing {
                // One maximum touches the wall all along the curve; this is another one.
                sought = Condition::SecondInteriorGrazing;
                times.second_grazing_time = maximum.time;
            } else {
                times.grazing_time = maximum.time;
            }
        }
    }
    let point = located_near(equations, sought, near, [before, after], &mut times)?;
    if sought == Condition::SecondInteriorGrazing {
        // The curve that can start from there is that of the second maximum.
        core::mem::swap(&mut times.grazing_time, &mut times.second_grazing_time);
    }
    Ok((equations.equations.solution(&point), times))
}

/// The point of a curve with a further condition that lies on a step, or next to it.
fn located_near<O: ImpactOscillator>(
    equations: &MpsCurve<O>,
    condition: Condition,
    near: Unknowns,
    [before, after]: [&MpsStation; 2],
    times: &mut EventTimes,
) -> Result<Unknowns, LocateFailure> {
    let step = (after.point - before.point).norm();
    let conditions = [equations.condition, condition];
    let point = locate_within(FARTHEST_ITERATE * step, &equations.equations, conditions, near, times)?;
    on_step(point, near, [before, after])
}

/// A point that was looked for on a step, from near it, unless it lies elsewhere.
fn on_step(
    point: Unknowns,
    near: Unknowns,
    [before, after]: [&MpsStation; 2],
) -> Result<Unknowns, LocateFailure> {
    let (distance, step) = ((point - near).norm(), (after.point - before.point).norm());
    if distance > FARTHEST_EVENT * step {
        return Err(LocateFailure::Elsewhere { distance, step });
    }
    Ok(point)
}

/// The point on the chord where one coordinate takes a value.
fn on_chord(before: &Unknowns, after: &Unknowns, coordinate: usize, value: f64) -> Unknowns {
    let (a, b) = (before[coordinate], after[coordinate]);
    let mut point = before + (after - before) * ((value - a) / (b - a));
    point[coordinate] = value;
    point
}
