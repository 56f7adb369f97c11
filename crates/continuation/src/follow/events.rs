//! Events along a curve: the functions that vanish at bifurcations, and their zeros on a step.

use core::ops::{Index, IndexMut};

use grazing_model::ImpactOscillator;

use crate::arclength::{Continuation, Station, StepControl};
use crate::bifurcation::Bifurcation;
use crate::curve::{CurveEnd, Event, SolutionCurve};
use crate::locate::{Condition, LocateFailure, locate_grazing_end, locate_within};
use crate::mps::{EventTimes, PeriodicSolution, StabilityFunctions, Unknowns, unknown};
use crate::tolerances::{
    CUTS, FARTHEST_EVENT, FARTHEST_ITERATE, NO_VELOCITY, ON_TWO_CURVES, STABILITY, TOUCHES_TOO,
};

pub(super) type CurveStation = Station<Unknowns, EventTimes>;

/// The events that can occur along a curve; `Grazing` is that of solutions with impacts and without.
pub(super) const EVENTS: [Bifurcation; 5] = [
    Bifurcation::SaddleNode,
    Bifurcation::PeriodDoubling,
    Bifurcation::Grazing,
    Bifurcation::Torus,
    Bifurcation::Pitchfork,
];

/// By kind, the signs of the functions that vanish at the [`EVENTS`], of which that of `Grazing` is whether a maximum is
/// beyond the wall; `None` where they were not computed, or are not known.
#[derive(Clone, Copy, Default)]
pub(super) struct Signs([Option<bool>; Bifurcation::ALL.len()]);

impl Index<Bifurcation> for Signs {
    type Output = Option<bool>;

    fn index(&self, event: Bifurcation) -> &Option<bool> {
        &self.0[event as usize]
    }
}

impl IndexMut<Bifurcation> for Signs {
    fn index_mut(&mut self, event: Bifurcation) -> &mut Option<bool> {
        &mut self.0[event as usize]
    }
}

/// Largest number of maxima that may reach the wall one after the other within a step.
const MAXIMA: usize = 16;
/// Distance along the tangent at which the maxima of loops that touch the wall at y = 0 have left
/// it by more than the error of the tangent, and by more than rounding.
const BESIDE_GRAZING: f64 = 1e-6;

/// The function that vanishes at a bifurcation detected by multipliers.
pub(super) fn vanishing(event: Bifurcation, stability: &StabilityFunctions) -> Option<f64> {
    match event {
        Bifurcation::SaddleNode => Some(stability.saddle_node),
        Bifurcation::PeriodDoubling => Some(stability.period_doubling),
        Bifurcation::Torus => Some(stability.torus),
        Bifurcation::Pitchfork => stability.pitchfork,
        Bifurcation::NonImpactingGrazing | Bifurcation::Grazing => None,
    }
}

/// The signs at a solution. On a curve of fixed multiplier the other multiplier is positive or
/// negative throughout: only grazing can occur there. On one of fixed product both can become 1 or
/// −1. Where the product of the multipliers is 1 but for rounding, as it is everywhere without damping, its
/// deviation has no sign.
pub(super) fn signs(along: Condition, stability: &StabilityFunctions, solution: &PeriodicSolution) -> Signs {
    let mut signs = Signs::default();
    for event in EVENTS {
        signs[event] = match event {
            Bifurcation::Grazing => Some(solution.touches()),
            _ if along.fixes_a_multiplier() || event.condition() == along => None,
            Bifurcation::Torus if (stability.multipliers.determinant - 1.0).abs() <= STABILITY => None,
            _ => vanishing(event, stability).map(|value| value > 0.0),
        };
    }
    signs
}

/// The [`EVENTS`] at which two sets of signs differ.
pub(super) fn changes(past: Signs, now: Signs) -> impl Iterator<Item = Bifurcation> {
    let differ = |a: Option<bool>, b: Option<bool>| a.is_some_and(|a| b.is_some_and(|b| a != b));
    EVENTS.into_iter().filter(move |event| differ(past[*event], now[*event]))
}

impl<O: ImpactOscillator> SolutionCurve<O> {
    /// Whether a point lies on the grazing curve, with y = 0.
    pub(super) fn is_at_grazing(&self, point: &Unknowns) -> bool {
        self.equations.has_impacts() && point.lowest_velocity().1 == 0.0
    }

    /// The signs at the start, unless it is itself a codimension-two point, where one of the
    /// functions vanishes.
    pub(super) fn starting_signs(&self, first: &CurveStation) -> Option<Signs> {
        let (mut solution, stability) = self.equations.solution_and_stability(&first.point);
        let at_grazing = self.is_at_grazing(&first.point);
        if at_grazing {
            // The maxima of all loops touch the wall there; in which direction they leave it is
            // decided a little farther on.
            solution = self.equations.solution(&(&first.point + &first.tangent * BESIDE_GRAZING));
        }
        let clear = match self.condition {
            // Where another maximum touches the wall its sign is arbitrary.
            along if along.fixes_a_multiplier() => at_grazing || solution.ceiling().abs() > TOUCHES_TOO,
            _ => {
                let others = EVENTS.iter().filter(|event| event.condition() != self.condition);
                let vanishing = others.filter_map(|event| vanishing(*event, &stability));
                vanishing.map(f64::abs).fold(f64::INFINITY, f64::min) > ON_TWO_CURVES
            }
        };
        clear.then(|| signs(self.condition, &stability, &solution))
    }
}

/// A step along a curve, from one point to the next.
pub(super) struct CurveStep<'a, O> {
    pub(super) followed: &'a SolutionCurve<O>,
    pub(super) control: StepControl,
    pub(super) before: &'a CurveStation,
    pub(super) after: &'a CurveStation,
}

impl<O: ImpactOscillator> CurveStep<'_, O> {
    /// All events on the step, in the order of the curve; `beyond` is the solution at its end,
    /// which is the curve's point of this index.
    pub(super) fn events(
        &self,
        past: Signs,
        now: Signs,
        beyond: &PeriodicSolution,
        index: usize,
    ) -> Result<Vec<Event>, CurveEnd> {
        let mut located = Vec::new();
        for event in changes(past, now) {
            let condition = event.condition();
            let found = match self.event(condition, beyond) {
                Ok(found) if self.is_trivial(condition, &found.0) => {
                    Ok(self.event_closer(event, past[event]).unwrap_or(found))
                }
                found => found.or_else(|failure| self.event_closer(event, past[event]).ok_or(failure)),
            };
            match found {
                // For real multipliers a product of 1 is no bifurcation.
                Ok((solution, _)) if condition == Condition::TORUS && !solution.multipliers.complex() => {}
                Ok((solution, times)) => located.push(Event { condition, solution, index, times }),
                // Where branches cross because of a symmetry, or the rest position touches the
                // wall, motion without impacts continues.
                Err(_) if !self.followed.equations.has_impacts() || condition == Condition::TORUS => {}
                Err(failure) => return Err(CurveEnd::EventNotLocated { condition, failure }),
            }
        }
        let way = |event: &Event| self.before.tangent.dot(&(&event.solution.unknowns - &self.before.point));
        located.sort_by(|a, b| way(a).total_cmp(&way(b)));
        Ok(located)
    }

    /// Locates an event on the step; `beyond` is the solution at its end.
    fn event(
        &self,
        condition: Condition,
        beyond: &PeriodicSolution,
    ) -> Result<(PeriodicSolution, EventTimes), LocateFailure> {
        let Self { before, after, .. } = *self;
        let equations = &self.followed.equations;
        let mut times = after.carried.clone();
        let mut near = (&before.point + &after.point) * 0.5;
        let mut sought = condition;
        if condition == Condition::InteriorGrazing {
            // The maximum that crosses the wall is the highest one at whichever end is
            // inadmissible.
            let solution = if beyond.touches() {
                near = after.point.clone();
                beyond.clone()
            } else {
                near = before.point.clone();
                times = before.carried.clone();
                equations.solution(&before.point)
            };
            if self.followed.condition == Condition::InteriorGrazing {
                // One maximum touches the wall all along the curve; this is another one.
                sought = Condition::SecondInteriorGrazing;
            }
            if let Some(maximum) = solution.highest_interior_maximum {
                *sought.maximum_time(&mut times) = maximum.time;
            }
        }
        let mut point = self.located_near(sought, near, &mut times)?;
        let mut solution = equations.solution(&point);
        // Where this maximum touches the wall another may be beyond it, which touched it earlier.
        for _ in 0..MAXIMA {
            let beyond = solution.highest_interior_maximum.filter(|maximum| maximum.position > TOUCHES_TOO);
            let Some(maximum) = beyond.filter(|_| condition == Condition::InteriorGrazing) else { break };
            *sought.maximum_time(&mut times) = maximum.time;
            point = self.located_near(sought, point, &mut times)?;
            solution = equations.solution(&point);
        }
        if sought == Condition::SecondInteriorGrazing {
            // The curve that can start from there is that of the second maximum.
            core::mem::swap(&mut times.grazing_time, &mut times.second_grazing_time);
        }
        Ok((solution, times))
    }

    /// Locates an event that Newton's method does not find from the middle of the step, by cutting
    /// the step about it repeatedly.
    fn event_closer(&self, event: Bifurcation, past: Option<bool>) -> Option<(PeriodicSolution, EventTimes)> {
        let equations = &self.followed.equations;
        let comes_later = |middle: &CurveStation| {
            let (solution, stability) = equations.solution_and_stability(&middle.point);
            signs(self.followed.condition, &stability, &solution)[event] == past
        };
        self.cut(comes_later, |part| {
            let beyond = equations.solution(&part.after.point);
            let found = part.event(event.condition(), &beyond).ok();
            found.filter(|(solution, _)| !self.is_trivial(event.condition(), solution))
        })
    }

    /// Whether an event holds trivially: at y = 0 the maxima of all loops touch the wall, and Newton's method
    /// may end there although another maximum touches it on the step.
    fn is_trivial(&self, event: Condition, solution: &PeriodicSolution) -> bool {
        event == Condition::InteriorGrazing
            && self.followed.equations.has_impacts()
            && solution.unknowns.lowest_velocity().1 <= NO_VELOCITY
    }

    /// Cuts the step repeatedly about a point that lies in it until that point is located.
    fn cut<T>(
        &self,
        comes_later: impl Fn(&CurveStation) -> bool,
        located: impl Fn(&CurveStep<'_, O>) -> Option<T>,
    ) -> Option<T> {
        let way = |a: &CurveStation, b: &CurveStation| self.followed.equations.gap(&a.point, &b.point).norm();
        let (mut before, mut after) = (self.before.clone(), self.after.clone());
        for _ in 0..CUTS {
            let half = 0.5 * way(&before, &after);
            if half < self.control.shortest {
                return None;
            }
            let tolerance = StepControl::DRAWING.tolerance;
            let control = StepControl { first: half, longest: half, tolerance, ..self.control };
            let (point, tangent, times) =
                (before.point.clone(), before.tangent.clone(), before.carried.clone());
            let mut walker = Continuation::new(self.followed, control, point, tangent, times).ok()?;
            let middle = walker.advance().ok()?.clone();
            // A point farther from an end than both ends are from each other lies on another branch.
            if way(&before, &middle).max(way(&middle, &after)) > way(&before, &after) {
                return None;
            }
            if comes_later(&middle) {
                before = middle;
                continue;
            }
            after = middle;
            if let Some(found) = located(&CurveStep { before: &before, after: &after, ..*self }) {
                return Some(found);
            }
        }
        None
    }

    /// The point on the step where the velocity of an impact vanishes.
    pub(super) fn grazing(&self, impact: usize) -> Result<(Unknowns, EventTimes), LocateFailure> {
        let located = |step: &CurveStep<'_, O>| {
            let near = step.on_chord(unknown::velocity(impact), 0.0);
            let mut times = step.after.carried.clone();
            let SolutionCurve { equations, condition } = step.followed;
            let located = match condition {
                Condition::InteriorGrazing if near.impacts() == 1 => {
                    locate_grazing_end(equations, near.clone(), &mut times)
                        .and_then(|point| step.holds(point, near))
                }
                _ => step.located_near(Condition::stopped(impact), near, &mut times),
            };
            located.map(|point| (point, times))
        };
        located(self).or_else(|failure| {
            let comes_later = |middle: &CurveStation| middle.point[unknown::velocity(impact)] > NO_VELOCITY;
            self.cut(comes_later, |part| located(part).ok()).ok_or(failure)
        })
    }

    /// The point of the curve with a further condition that lies on the step or close to it.
    pub(super) fn located_near(
        &self,
        condition: Condition,
        near: Unknowns,
        times: &mut EventTimes,
    ) -> Result<Unknowns, LocateFailure> {
        let SolutionCurve { equations, condition: along } = self.followed;
        let point = locate_within(
            FARTHEST_ITERATE * self.length(),
            equations,
            [*along, condition],
            near.clone(),
            times,
        )?;
        self.holds(point, near)
    }

    fn length(&self) -> f64 {
        (&self.after.point - &self.before.point).norm()
    }

    /// Returns a point that was sought on the step, from near it, unless it lies elsewhere.
    fn holds(&self, point: Unknowns, near: Unknowns) -> Result<Unknowns, LocateFailure> {
        let (distance, step) = ((&point - near).norm(), self.length());
        if distance > FARTHEST_EVENT * step {
            return Err(LocateFailure::Elsewhere { distance, step });
        }
        Ok(point)
    }

    /// The point on the chord where one coordinate takes a value.
    pub(super) fn on_chord(&self, coordinate: usize, value: f64) -> Unknowns {
        let [before, after] = [self.before, self.after].map(|end| end.point.clone());
        let (a, b) = (before[coordinate], after[coordinate]);
        let mut point = &before + (after - &before) * ((value - a) / (b - a));
        point[coordinate] = value;
        point
    }
}
