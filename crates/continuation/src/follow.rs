//! Following a curve of MPSs point by point: events, changes of formulation, ends.

mod events;

use core::ops::ControlFlow;

use grazing_model::ImpactOscillator;
use grazing_model::maps::MapError;
use grazing_model::smooth::Purpose;

use crate::arclength::{Continuation, FEWEST_OF_A_LOOP, Stall, StepControl, back_at};
use crate::bifurcation::Bifurcation;
use crate::curve::{Curve, CurveEnd, CurvePoint, Event, Route, SolutionCurve};
use crate::locate::Condition;
use crate::mps::{EventTimes, Multipliers, PeriodicSolution, Unknowns, parameters, unknown};
use crate::tolerances::{
    self, AGAIN, FORGOTTEN, LOST_POINTS, MOST_OUT_OF_SIGHT, MOST_SHORT_STEPS, NO_VELOCITY, ON_TWO_CURVES,
    OUT_OF_SIGHT, SHORT_STEP, SOUNDED, VIOLENT,
};
use events::{CurveStation, CurveStep, EVENTS, Signs, changes, signs, vanishing};

impl<O: ImpactOscillator> SolutionCurve<O> {
    /// Follows the curve from `start`, in the direction closer to `direction`, until it ends.
    ///
    /// The formulation is that of the equations, usually
    /// [`FixedPhase`](crate::mps::Formulation::FixedPhase): where VIVID ends, the curve ends.
    ///
    /// # Errors
    /// The curve cannot be started: the equations are undefined or have no unique tangent at
    /// `start`.
    pub fn follow(
        self,
        start: Unknowns,
        direction: Unknowns,
        times: EventTimes,
        route: &Route<'_>,
    ) -> Result<Curve, Stall<MapError>> {
        let here = Continuation::new(&self, route.control, start, direction, times)?.here().clone();
        let mut follower = Follower {
            followed: &self,
            route,
            signs: self.starting_signs(&here),
            beyond: 0,
            curve: Curve {
                condition: self.condition,
                points: vec![self.starting_point(&here)],
                events: Vec::new(),
                end: CurveEnd::StepLimit,
                beginning: None,
            },
        };
        if let Some(stall) = follower.walk(here) {
            follower.curve.end = CurveEnd::Stalled(stall);
        }
        Ok(follower.curve)
    }

    /// Follows the curve through one of its points in both directions, first that of `direction`,
    /// then the other, and returns one list.
    ///
    /// # Errors
    /// As [`follow`](Self::follow).
    pub fn follow_both_ways(
        self,
        through: Unknowns,
        direction: Unknowns,
        times: &EventTimes,
        route: &Route<'_>,
    ) -> Result<Curve, Stall<MapError>> {
        let mut before = self.clone().follow(through.clone(), direction.clone(), times.clone(), route)?;
        if matches!(before.end, CurveEnd::Closed) {
            return Ok(before);
        }
        let after = self.clone().follow(through, -direction, times.clone(), route)?;
        let condition =
            self.bifurcation_between(before.points.get(1), &before.points[0], after.points.get(1));
        // The point is in both lists.
        let mut shared = before.points.len() - 1;
        before.points.reverse();
        // An event lies before the point of its index, and beyond it once the order is reversed.
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

    /// The bifurcation at which a point of a one-parameter branch itself lies, by which its
    /// neighbours on the branch differ.
    ///
    /// No sign changes beyond the point in either direction, so the bifurcation is not detected on
    /// the way.
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
        let vanishes = |event: &Bifurcation| {
            let [Some(before), Some(here), Some(after)] =
                [&before, &here, &after].map(|stability| vanishing(*event, stability))
            else {
                return false;
            };
            here.abs() <= ON_TWO_CURVES && before * after < 0.0
        };
        EVENTS.into_iter().find(vanishes).map(Bifurcation::condition)
    }

    /// Whether the curve is a one-parameter branch.
    fn is_branch(&self) -> bool {
        matches!(self.condition, Condition::Primary(_) | Condition::Secondary(_))
    }

    /// The first point; at y = 0 its multipliers are limits along the tangent.
    fn starting_point(&self, first: &CurveStation) -> CurvePoint {
        let solution = if self.is_at_grazing(&first.point) {
            self.equations.limiting_solution(&first.point, &first.tangent)
        } else {
            self.equations.solution(&first.point)
        };
        CurvePoint { solution, times: first.carried.clone() }
    }
}

/// A curve while it is being followed.
struct Follower<'a, O> {
    followed: &'a SolutionCurve<O>,
    route: &'a Route<'a>,
    curve: Curve,
    signs: Option<Signs>,
    /// The number of sounded points in a row at which motion goes far beyond the wall.
    beyond: usize,
}

/// What was known before a step.
struct Before {
    station: CurveStation,
    points: usize,
    events: usize,
    signs: Option<Signs>,
    beyond: usize,
}

impl<O: ImpactOscillator> Follower<'_, O> {
    /// Continues until the curve ends (`None`) or no further point is found.
    fn walk(&mut self, mut here: CurveStation) -> Option<Stall<MapError>> {
        let mut control = self.route.control;
        let SolutionCurve { equations, condition } = self.followed;
        // Events on a sketch are located separately, with all digits.
        let rough = control
            .sketches()
            .then(|| SolutionCurve { equations: equations.roughly(), condition: *condition });
        let mut walked = rough.as_ref().unwrap_or(self.followed);
        let start = |walked, control, here: &CurveStation| {
            Continuation::new(walked, control, here.point.clone(), here.tangent.clone(), here.carried.clone())
        };
        let mut walker = match start(walked, control, &here) {
            Ok(walker) => walker,
            Err(stall) => return Some(stall),
        };
        let mut last: Option<Before> = None;
        while self.curve.points.len() <= self.route.step_limit && !self.creeps() {
            here = walker.here().clone();
            if let Some(pace) = self.route.pace {
                let Some(longest) = pace(&self.curve.points, &here.tangent) else {
                    self.curve.end = CurveEnd::Abandoned;
                    return None;
                };
                walker.limit(longest);
            }
            let after = match (walker.advance(), last.take()) {
                (Ok(station), _) => station.clone(),
                // Among violent motion the last point of a sketch may be off, and nothing leads on from it.
                (Err(stall), Some(before)) if control.sketches() => {
                    let step = equations.gap(&before.station.point, &here.point).norm();
                    walked = self.followed;
                    control = StepControl {
                        first: (AGAIN * step).max(control.shortest),
                        tolerance: tolerances::STEP,
                        ..control
                    };
                    walker = match start(walked, control, &before.station) {
                        Ok(again) => again,
                        Err(_) => return Some(stall),
                    };
                    self.go_back(before);
                    continue;
                }
                (Err(stall), _) => return Some(stall),
            };
            let step = equations.gap(&here.point, &after.point).norm();
            let before = self.before(&here);
            if let ControlFlow::Break(end) = self.accept(&here, after) {
                // The step may have led to another branch, where motion is sensitive: shorter ones do not.
                let first = AGAIN * step;
                if matches!(end, CurveEnd::EventNotLocated { .. })
                    && first > control.first
                    && let Ok(again) = start(walked, StepControl { first, ..control }, &here)
                {
                    walker = again;
                    continue;
                }
                self.curve.end = end;
                return None;
            }
            last = Some(before);
            if self.is_lost() || self.is_out_of_sight() {
                self.curve.end = CurveEnd::Abandoned;
                return None;
            }
        }
        None
    }

    /// What is known before a step from a station.
    fn before(&self, station: &CurveStation) -> Before {
        let Self { curve: Curve { points, events, .. }, signs, beyond, .. } = self;
        let station = station.clone();
        Before { station, points: points.len(), events: events.len(), signs: *signs, beyond: *beyond }
    }

    /// Forgets the steps since.
    fn go_back(&mut self, Before { points, events, signs, beyond, .. }: Before) {
        self.curve.points.truncate(points);
        self.curve.events.truncate(events);
        (self.signs, self.beyond) = (signs, beyond);
    }

    /// Whether the curve has hardly advanced for long, as where motion is so sensitive that no longer steps
    /// succeed.
    fn creeps(&self) -> bool {
        let (equations, points) = (&self.followed.equations, &self.curve.points);
        let short = |pair: &[CurvePoint]| {
            let step = equations.gap(&pair[0].solution.unknowns, &pair[1].solution.unknowns);
            step.norm() < SHORT_STEP * self.route.control.longest
        };
        points.len() > MOST_SHORT_STEPS && points.windows(2).rev().take(MOST_SHORT_STEPS).all(short)
    }

    /// Whether motion on a sketch has gone far beyond the wall for long: from there it seldom comes back
    /// to what is admissible, and the faster solutions are the more of them there are.
    fn is_out_of_sight(&mut self) -> bool {
        let equations = &self.followed.equations;
        let count = self.curve.points.len();
        if !self.route.control.sketches() || !equations.has_impacts() || !count.is_multiple_of(SOUNDED) {
            return false;
        }
        let Some(CurvePoint { solution, .. }) = self.curve.points.last() else { return false };
        let with_maxima = || equations.sketch(&solution.unknowns, solution.multipliers, true).ceiling();
        let ceiling = solution.highest_interior_maximum.map_or_else(with_maxima, |top| top.position);
        self.beyond = if ceiling > OUT_OF_SIGHT { self.beyond + 1 } else { 0 };
        self.beyond > MOST_OUT_OF_SIGHT
    }

    /// Whether the curve has been among violent motion for long.
    fn is_lost(&self) -> bool {
        let points = &self.curve.points;
        let violent =
            |point: &CurvePoint| point.times.stability.is_some_and(|stability| stability.violence > VIOLENT);
        points.len() > LOST_POINTS && points.iter().rev().take(LOST_POINTS).all(violent)
    }

    /// Appends the next point, unless the curve ends before it.
    fn accept(&mut self, before: &CurveStation, after: CurveStation) -> ControlFlow<CurveEnd> {
        let equations = &self.followed.equations;
        let step = CurveStep { followed: self.followed, control: self.route.control, before, after: &after };
        let (impact, velocity) = after.point.lowest_velocity();
        let grazes = velocity <= NO_VELOCITY && velocity < before.point[unknown::velocity(impact)];
        if equations.has_impacts() && grazes {
            return ControlFlow::Break(self.end_at_grazing(&step, impact));
        }
        let (mut solution, mut now) = self.solution_and_signs(&after);
        if let Some(mut past) = self.signs {
            if past[Bifurcation::Grazing].is_none() && now[Bifurcation::Grazing].is_some() {
                past[Bifurcation::Grazing] = Some(equations.solution(&before.point).touches());
            }
            if self.matters(past, now, &solution) {
                let located = self.locate_events(&step, past, now, &solution);
                let lost = matches!(located, ControlFlow::Break(CurveEnd::EventNotLocated { .. }));
                match lost.then(|| self.without_events(&step)).flatten() {
                    Some(exact) => (solution, now) = exact,
                    None => located?,
                }
            }
        }
        // What has no sign here has that of the points before.
        let past = self.signs.and_then(|past| past[Bifurcation::Torus]);
        now[Bifurcation::Torus] = now[Bifurcation::Torus].or(past);
        self.signs = Some(now);
        if let Some(start) = self.back_at_the_start(&step) {
            self.curve.points.push(start);
            return ControlFlow::Break(CurveEnd::Closed);
        }
        if !self.route.window.contains(parameters(&after.point)) {
            self.end_on_the_edge(&step);
            return ControlFlow::Break(CurveEnd::LeftWindow);
        }
        self.curve.points.push(CurvePoint { solution, times: after.carried });
        ControlFlow::Continue(())
    }

    /// The MPS at a point and the signs there; on a sketch with the values left by the corrector,
    /// and admissibility only where this solution or the previous one is stable.
    fn solution_and_signs(&self, station: &CurveStation) -> (PeriodicSolution, Signs) {
        let SolutionCurve { equations, condition } = self.followed;
        match station.carried.stability.filter(|_| self.route.control.sketches()) {
            Some(stability) => {
                let before = self.curve.points.last().is_some_and(|point| point.solution.stable());
                let with_maxima = before || stability.multipliers.stable();
                let solution = equations.sketch(&station.point, stability.multipliers, with_maxima);
                let mut signs = signs(*condition, &stability, &solution);
                signs[Bifurcation::Grazing] = signs[Bifurcation::Grazing].filter(|_| with_maxima);
                (solution, signs)
            }
            None => {
                let (solution, stability) = equations.solution_and_stability(&station.point);
                (solution.clone(), signs(*condition, &stability, &solution))
            }
        }
    }

    /// The solution and the signs at the end of a step of a sketch with all digits, if then there is no event
    /// on the step.
    fn without_events(&self, step: &CurveStep<'_, O>) -> Option<(PeriodicSolution, Signs)> {
        let exact = |station: &CurveStation| {
            let (solution, stability) = self.followed.equations.solution_and_stability(&station.point);
            (solution.clone(), signs(self.followed.condition, &stability, &solution))
        };
        let sketches = self.route.control.sketches();
        let (past, now) = sketches.then(|| (exact(step.before), exact(step.after)))?;
        changes(past.1, now.1).next().is_none().then_some(now)
    }

    /// Whether an event before the next point is to be located: on a sketch a single event between
    /// two MPSs neither of which is stable and admissible is not.
    fn matters(&self, past: Signs, now: Signs, next: &PeriodicSolution) -> bool {
        let either =
            || next.attracts() || self.curve.points.last().is_some_and(|point| point.solution.attracts());
        match changes(past, now).count() {
            0 => false,
            1 => !self.route.control.sketches() || either(),
            _ => true,
        }
    }

    /// The first point, if the curve passes it between two of its points, with the phase increased
    /// by the whole turns made since.
    fn back_at_the_start(&self, step: &CurveStep<'_, O>) -> Option<CurvePoint> {
        let [first, second, ..] = self.curve.points.as_slice() else { return None };
        if self.curve.points.len() <= FEWEST_OF_A_LOOP {
            return None;
        }
        let start = first.solution.unknowns.clone();
        let onwards = &second.solution.unknowns - &start;
        let way = [&step.before.point, &step.after.point];
        let angle = self.followed.equations.angle();
        let back = back_at((start, onwards), way, self.route.control.turn, angle)?;
        let mut point = first.clone();
        point.solution.unknowns = back;
        Some(point)
    }

    /// Appends the events on a step that ends at this solution.
    fn locate_events(
        &mut self,
        step: &CurveStep<'_, O>,
        past: Signs,
        now: Signs,
        beyond: &PeriodicSolution,
    ) -> ControlFlow<CurveEnd> {
        let located = match Purpose::Events.during(|| step.events(past, now, beyond, self.curve.points.len()))
        {
            Ok(located) => located,
            Err(end) => return ControlFlow::Break(end),
        };
        // Events beyond the edge are not on the curve, which ends there, unless a branch comes back on the same step:
        // then it has turned round.
        let contains = |point: &Unknowns| self.route.window.contains(parameters(point));
        let turns = self.followed.is_branch() && contains(&step.after.point);
        let on_curve = |event: &Event| turns || contains(&event.solution.unknowns);
        for event in located.into_iter().filter(on_curve) {
            self.curve.events.push(event.clone());
            // Beyond it the product of real multipliers is 1, which is no bifurcation.
            let ends =
                self.followed.condition == Condition::TORUS && event.condition != Condition::InteriorGrazing;
            if self.route.stop_at_events || ends {
                let mut times = event.times.clone();
                if self.followed.condition == event.condition {
                    // The times of the event belong to the other curve, on which another maximum
                    // touches the wall.
                    core::mem::swap(&mut times.grazing_time, &mut times.second_grazing_time);
                }
                self.curve.points.push(CurvePoint { solution: event.solution.clone(), times });
                return ControlFlow::Break(CurveEnd::Event(Box::new(event)));
            }
        }
        ControlFlow::Continue(())
    }

    /// Ends the curve where the velocity of an impact vanishes.
    fn end_at_grazing(&mut self, step: &CurveStep<'_, O>, impact: usize) -> CurveEnd {
        let SolutionCurve { equations, condition } = self.followed;
        let before = step.before;
        let (mut point, times) = match step.grazing(impact) {
            Ok(found) => found,
            // At grazing but for rounding, and for long: there is no zero to be located.
            Err(_) if before.point[unknown::velocity(impact)] < FORGOTTEN => {
                (before.point.clone(), before.carried.clone())
            }
            Err(failure) => {
                return CurveEnd::EventNotLocated { condition: Condition::stopped(impact), failure };
            }
        };
        point[unknown::velocity(impact)] = 0.0;
        let tangent = step.after.tangent.clone();
        let mut solution = equations.limiting_solution(&point, &tangent);
        match Continuation::new(self.followed, self.route.control, point.clone(), tangent, times.clone()) {
            Ok(end) if *condition != Condition::InteriorGrazing => {
                solution = equations.limiting_solution(&point, &end.here().tangent);
                if solution.multipliers.trace.is_infinite()
                    && let ControlFlow::Break(lost) = self.locate_last_events(before, end.here(), &solution)
                {
                    return lost;
                }
            }
            // An end of interior grazing is a branch point, without a unique tangent along which to
            // take limits.
            _ => solution.multipliers = Multipliers { trace: f64::NAN, determinant: f64::NAN },
        }
        self.curve.points.push(CurvePoint { solution, times });
        CurveEnd::Grazing
    }

    /// Appends the SN and PD on the last step of a branch, which ends where the trace is infinite.
    fn locate_last_events(
        &mut self,
        before: &CurveStation,
        after: &CurveStation,
        end: &PeriodicSolution,
    ) -> ControlFlow<CurveEnd> {
        let Some(past) = self.signs else { return ControlFlow::Continue(()) };
        let (_, stability) = self.followed.equations.solution_and_stability(&after.point);
        let there = signs(self.followed.condition, &stability, end);
        let mut now = past;
        for event in [Bifurcation::SaddleNode, Bifurcation::PeriodDoubling] {
            now[event] = there[event];
        }
        if !self.matters(past, now, end) {
            return ControlFlow::Continue(());
        }
        let step = CurveStep { followed: self.followed, control: self.route.control, before, after };
        self.locate_events(&step, past, now, end)
    }

    /// Adds the point at which the curve crosses the edge of the window, or the point beyond if it
    /// cannot be located.
    fn end_on_the_edge(&mut self, step: &CurveStep<'_, O>) {
        let window = &self.route.window;
        let outside = step.after.point.clone();
        let mut times = step.after.carried.clone();
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
            let mut point = step.located_near(condition, step.on_chord(coordinate, edge), &mut times).ok()?;
            point[coordinate] = edge;
            window.contains(parameters(&point)).then_some(point)
        });
        let solution = self.followed.equations.solution(&crossing.unwrap_or(outside));
        self.curve.points.push(CurvePoint { solution, times });
    }
}
