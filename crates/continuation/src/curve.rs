//! Branches and bifurcation curves of periodic solutions: V = 0 and one condition, followed by
//! pseudo-arclength.

use grazing_model::maps::MapError;
use grazing_model::{AnyOscillator, ImpactOscillator};

use crate::arclength::{CurveEquations, Stall, StepControl};
use crate::locate::{Condition, LocateFailure, conditioned};
use crate::mps::{EventTimes, LoopEquations, PeriodicSolution, Unknowns};
use crate::newton::Linearisation;
use crate::tolerances::ABANDONED_POINTS;

/// The equations of a curve of periodic solutions.
///
/// With [`Condition::Secondary`] it is a one-parameter branch, with [`Condition::Multiplier`] a
/// curve of saddle-node or period-doubling bifurcations, with [`Condition::TORUS`] one of
/// torus bifurcations, with [`Condition::InteriorGrazing`] one of grazing bifurcations of the
/// solution.
#[derive(Clone, Debug)]
pub struct SolutionCurve<O = AnyOscillator> {
    /// The equations of the solution.
    pub equations: LoopEquations<O>,
    /// The condition that holds along the curve.
    pub condition: Condition,
}

impl<O: ImpactOscillator> CurveEquations for SolutionCurve<O> {
    type Point = Unknowns;
    type Carried = EventTimes;
    type Failure = MapError;

    fn evaluate(
        &self,
        point: &Unknowns,
        times: &mut EventTimes,
    ) -> Result<Linearisation<Unknowns>, MapError> {
        let (system, maps) = conditioned(&self.equations, self.condition, false, point, times)?;
        let stability = maps.stability();
        times.unsettled = times.stability.is_some_and(|before| stability.is_unsettled_since(&before));
        times.stability = Some(stability);
        Ok(system)
    }

    fn is_unsettled(&self, times: &EventTimes) -> bool {
        times.unsettled
    }

    fn units(&self, point: &Unknowns) -> Unknowns {
        self.equations.units(point)
    }

    fn settle(&self, point: &Unknowns, times: &mut EventTimes) {
        self.equations.settle(point, times);
    }
}

/// A rectangle in the plane of the two parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Window {
    /// Least and greatest primary parameter.
    pub primary: [f64; 2],
    /// Least and greatest secondary parameter.
    pub secondary: [f64; 2],
}

impl Window {
    /// Whether a point (μ, η) lies inside or on the edge.
    pub fn contains(&self, [primary, secondary]: [f64; 2]) -> bool {
        let within = |[low, high]: [f64; 2], value: f64| low <= value && value <= high;
        within(self.primary, primary) && within(self.secondary, secondary)
    }

    /// The widths of the ranges of μ and η.
    pub fn widths(&self) -> [f64; 2] {
        [self.primary, self.secondary].map(|[low, high]| high - low)
    }

    /// The parameters (μ, η) at fractions of their ranges: 0 at the lower end, 1 at the upper one.
    pub fn parameters(&self, shares: [f64; 2]) -> [f64; 2] {
        let at = |[low, high]: [f64; 2], share: f64| low + (high - low) * share;
        [at(self.primary, shares[0]), at(self.secondary, shares[1])]
    }

    /// The fractions of their ranges at which parameters (μ, η) lie.
    pub fn shares(&self, [primary, secondary]: [f64; 2]) -> [f64; 2] {
        let share = |[low, high]: [f64; 2], value: f64| (value - low) / (high - low);
        [share(self.primary, primary), share(self.secondary, secondary)]
    }
}

/// The window, step control and limits with which a curve is followed.
#[derive(Clone, Copy)]
pub struct Route<'a> {
    /// The curve ends at the first point outside.
    pub window: Window,
    /// Control of the step length.
    pub control: StepControl,
    /// The curve ends after this many steps.
    pub step_limit: usize,
    /// The curve ends at the first event; otherwise events are listed and passed. At y = 0 it ends
    /// in any case.
    pub stop_at_events: bool,
    /// An additional limit on the length of steps, which can also end the curve; if `None`, the
    /// control alone limits steps.
    pub pace: Option<&'a Pace<'a>>,
}

/// The longest next step, in lengths of the step control, for the points of a curve so far and the
/// tangent at the last; `None` ends the curve.
pub type Pace<'a> = dyn Fn(&[CurvePoint], &Unknowns) -> Option<f64> + Sync + 'a;

/// An event: a further condition holds at a point of the curve besides the curve's own.
#[derive(Clone, Debug)]
pub struct Event {
    /// The further condition that holds at the event.
    pub condition: Condition,
    /// The solution at the event, located by Newton's method on both conditions.
    pub solution: PeriodicSolution,
    /// Index of the first point of the curve beyond the event.
    pub index: usize,
    /// The event times at the event: another curve can start from them.
    pub times: EventTimes,
}

/// The end of a curve.
#[derive(Clone, Debug)]
pub enum CurveEnd {
    /// The curve left the window.
    LeftWindow,
    /// The impact velocity reached zero; the last point of the curve lies there.
    Grazing,
    /// The curve returned to its first point, which is also its last.
    Closed,
    /// The last point is a solution that recurs after half the time: from there the curve comes back, its
    /// impacts numbered differently.
    Halved,
    /// An event, which is the last point of the curve.
    Event(Box<Event>),
    /// An event was seen between the last two points, and could not be located.
    EventNotLocated {
        /// The further condition that holds at the event.
        condition: Condition,
        /// The reason why the attempt failed.
        failure: LocateFailure,
    },
    /// No further point was found, in either formulation.
    Stalled(Stall<MapError>),
    /// The step limit was reached, or the curve has hardly advanced for long.
    StepLimit,
    /// What follows does not matter, by the pace or because motion has long been violent or, on a
    /// sketch, far beyond the wall.
    Abandoned,
}

/// A point of a curve.
#[derive(Clone, Debug)]
pub struct CurvePoint {
    /// The solution.
    pub solution: PeriodicSolution,
    /// The event times at the point.
    pub times: EventTimes,
}

/// A curve of periodic solutions that has been followed to its end.
#[derive(Clone, Debug)]
pub struct Curve {
    /// The condition that holds along the curve.
    pub condition: Condition,
    /// The points in order, the start included.
    pub points: Vec<CurvePoint>,
    /// The events on the curve, in order.
    pub events: Vec<Event>,
    /// The reason why the curve ends.
    pub end: CurveEnd,
    /// The reason why the curve begins where it does, if its beginning was found rather than given:
    /// [`SolutionCurve::follow_both_ways`].
    pub beginning: Option<CurveEnd>,
}

impl Curve {
    /// The curve in the plane of the two parameters (μ, η).
    pub fn parameters(&self) -> Vec<[f64; 2]> {
        self.points.iter().map(|point| point.solution.parameters()).collect()
    }

    /// The points without those for which the curve was abandoned at either end.
    pub fn before_abandoned(&self) -> &[CurvePoint] {
        let points = &self.points;
        let left_out = |end: Option<&CurveEnd>| match end {
            Some(CurveEnd::Abandoned) => ABANDONED_POINTS.min(points.len() / 2),
            _ => 0,
        };
        &points[left_out(self.beginning.as_ref())..points.len() - left_out(Some(&self.end))]
    }

    /// The reasons why the curve was not followed beyond its first and its last point; `None` where
    /// it ends as it should: at the edge of the window, at a point of codimension two, or where the
    /// curve was started.
    pub fn lost(&self) -> [Option<String>; 2] {
        [self.beginning.as_ref(), Some(&self.end)].map(|end| end.and_then(|end| self.why_lost(end)))
    }

    fn why_lost(&self, end: &CurveEnd) -> Option<String> {
        match end {
            CurveEnd::LeftWindow
            | CurveEnd::Grazing
            | CurveEnd::Closed
            | CurveEnd::Halved
            | CurveEnd::Event(_)
            | CurveEnd::Abandoned => None,
            CurveEnd::EventNotLocated { condition, failure } => {
                let what = match (condition, self.condition) {
                    (Condition::InteriorGrazing, _) => "a maximum between impacts that touches the wall",
                    (_, Condition::Primary(_) | Condition::Secondary(_)) => "a bifurcation",
                    _ => "a point where both bifurcations meet",
                };
                Some(format!("{what} was seen and not located: {failure}"))
            }
            CurveEnd::Stalled(stall) => Some(format!("no further point was found: {stall}")),
            CurveEnd::StepLimit => Some(format!("after {} points there was no end", self.points.len())),
        }
    }
}
