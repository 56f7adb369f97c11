//! Branches and bifurcation curves of MPSs: V = 0 and one condition, followed by pseudo-arclength.

use grazing_model::ImpactOscillator;
use grazing_model::maps::MapError;
use nalgebra::Vector4;

use crate::arclength::{Continuation, CurveEquations, Stall, StepControl};
use crate::locate::{Condition, conditioned, locate, locate_grazing_end};
use crate::mps::{Formulation, LoopEquations, LoopPair, MaximalPeriodicSolution, Memory, Unknowns, unknown};
use crate::newton::{Linearisation, NewtonFailure};

/// The equations of a curve of MPSs.
///
/// With [`Condition::Secondary`] it is a one-parameter branch, with [`Condition::Multiplier`] a curve of saddle-node or
/// period-doubling bifurcations, with [`Condition::InteriorGrazing`] a curve of grazing bifurcations of the MPS.
#[derive(Clone, Debug)]
pub struct MpsCurve<O> {
    /// The equations of the MPS.
    pub equations: LoopEquations<O>,
    /// The condition that holds along the curve.
    pub condition: Condition,
}

impl<O: ImpactOscillator> CurveEquations<4> for MpsCurve<O> {
    type Memory = Memory;
    type Failure = MapError;

    fn evaluate(&self, point: &Unknowns, memory: &mut Memory) -> Result<Linearisation<4>, MapError> {
        conditioned(&self.equations, self.condition, false, point, memory).map(|(system, _)| system)
    }

    fn settle(&self, point: &Unknowns, memory: &mut Memory) {
        self.equations.settle(point, memory);
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
    /// The point lies inside or on the edge.
    pub fn contains(&self, point: &Unknowns) -> bool {
        let within = |[low, high]: [f64; 2], value: f64| low <= value && value <= high;
        within(self.primary, point[unknown::PRIMARY]) && within(self.secondary, point[unknown::SECONDARY])
    }
}

/// Where and how a curve is to be followed.
#[derive(Clone, Copy, Debug)]
pub struct Route {
    /// The curve ends at the first point outside.
    pub window: Window,
    /// Control of the step length.
    pub control: StepControl,
    /// The curve ends after this many steps.
    pub step_limit: usize,
    /// The curve ends at the first event; otherwise events are listed and passed.
    pub stop_at_events: bool,
}

/// Something happens to the MPS at a point of the curve besides the curve's own condition.
#[derive(Clone, Debug)]
pub struct Event {
    /// The further condition that holds there.
    pub condition: Condition,
    /// The MPS there, located by Newton's method on both conditions.
    pub solution: MaximalPeriodicSolution,
    /// Index of the first point of the curve beyond the event.
    pub index: usize,
    /// What the equations remember there: another curve can start from it.
    pub memory: Memory,
}

/// How a curve ends.
#[derive(Clone, Debug)]
pub enum CurveEnd {
    /// It left the window.
    LeftWindow,
    /// The impact velocity reached zero; the last point of the curve lies there.
    Grazing,
    /// An event, which is the last point of the curve.
    Event(Event),
    /// An event was seen between the last two points, and could not be located.
    EventNotLocated {
        /// The further condition that holds there.
        condition: Condition,
        /// What happened in the attempt.
        failure: NewtonFailure<MapError>,
    },
    /// No further point was found, in either formulation.
    Stalled(Stall<MapError>),
    /// The step limit was reached.
    StepLimit,
}

/// A point of a curve.
#[derive(Clone, Debug)]
pub struct CurvePoint {
    /// The MPS.
    pub solution: MaximalPeriodicSolution,
    /// What the equations remember there.
    pub memory: Memory,
}

/// A curve of MPSs that has been followed to its end.
#[derive(Clone, Debug)]
pub struct Curve {
    /// The condition that holds along it.
    pub condition: Condition,
    /// Its points in order, the start included.
    pub points: Vec<CurvePoint>,
    /// The events it passed, in order.
    pub events: Vec<Event>,
    /// Why it ends.
    pub end: CurveEnd,
    /// Index of the first point that was computed without virtual points, if VIVID ended on the way.
    pub vivid_ended: Option<usize>,
}

/// Signs of the functions that vanish at events.
#[derive(Clone, Copy, PartialEq)]
struct Signs {
    saddle_node: bool,
    period_doubling: bool,
    inadmissible: bool,
}

impl<O: ImpactOscillator> MpsCurve<O> {
    /// Follows the curve from `start`, to the side of `direction`, until it ends.
    ///
    /// Starts in the formulation of the equations; where VIVID ends it goes on with [`Formulation::FixedPhase`].
    ///
    /// # Errors
    /// The curve cannot be started: the equations are undefined or have no unique tangent at `start`.
    pub fn follow(
        mut self,
        start: Unknowns,
        direction: Unknowns,
        memory: Memory,
        route: &Route,
    ) -> Result<Curve, Stall<MapError>> {
        let mut curve =
            Curve { condition: self.condition, points: Vec::new(), events: Vec::new(), end: CurveEnd::StepLimit, vivid_ended: None };
        let mut here = crate::arclength::Station { point: start, tangent: direction, memory };
        let mut signs: Option<Signs> = None;
        let mut steps = 0;
        'formulation: loop {
            let walker = Continuation::new(&self, route.control, here.point, here.tangent, here.memory.clone());
            let mut walker = match walker {
                Ok(walker) => walker,
                Err(stall) if curve.points.is_empty() => return Err(stall),
                Err(stall) => {
                    curve.end = CurveEnd::Stalled(stall);
                    return Ok(curve);
                }
            };
            if curve.points.is_empty() {
                let station = walker.here();
                let solution = self.grazing_solution(&station.point, &station.tangent);
                curve.points.push(CurvePoint { solution, memory: station.memory.clone() });
            }
            while steps < route.step_limit {
                steps += 1;
                let before = walker.here().clone();
                let after = match walker.advance() {
                    Ok(station) => station.clone(),
                    Err(_) if self.equations.formulation() == Formulation::Vivid => {
                        self.equations = self.equations.with_formulation(Formulation::FixedPhase);
                        curve.vivid_ended = Some(curve.points.len());
                        here = before;
                        continue 'formulation;
                    }
                    Err(stall) => {
                        curve.end = CurveEnd::Stalled(stall);
                        return Ok(curve);
                    }
                };
                let mut memory = after.memory.clone();
                let (solution, pair) = self.equations.solution(&after.point);
                if after.point[unknown::VELOCITY] <= VANISHING_VELOCITY && solution.impact_velocity() < before.point[unknown::VELOCITY] {
                    let crossing = between(&before.point, &after.point, unknown::VELOCITY, 0.0);
                    curve.end = self.end_at_grazing(crossing, &after.tangent, &mut memory, &mut curve.points);
                    return Ok(curve);
                }
                let now = self.signs(&pair, &solution);
                if let Some(past) = signs.filter(|past| *past != now) {
                    for condition in self.changes(past, now) {
                        let index = curve.points.len();
                        match self.event(condition, &before.point, &after.point, &solution, &mut memory) {
                            Ok(at) => curve.events.push(Event { condition, solution: at, index, memory: memory.clone() }),
                            Err(failure) => {
                                curve.end = CurveEnd::EventNotLocated { condition, failure };
                                return Ok(curve);
                            }
                        }
                    }
                    if let (true, Some(event)) = (route.stop_at_events, curve.events.last()) {
                        curve.points.push(CurvePoint { solution: event.solution, memory: event.memory.clone() });
                        curve.end = CurveEnd::Event(event.clone());
                        return Ok(curve);
                    }
                }
                signs = Some(now);
                if !route.window.contains(&after.point) {
                    let point = self.on_the_edge(&route.window, &before.point, &after.point, &mut memory);
                    let (solution, _) = self.equations.solution(&point);
                    curve.points.push(CurvePoint { solution, memory });
                    curve.end = CurveEnd::LeftWindow;
                    return Ok(curve);
                }
                curve.points.push(CurvePoint { solution, memory });
            }
            return Ok(curve);
        }
    }

    /// A point of the curve, its multipliers taken as limits along the tangent if y = 0.
    fn grazing_solution(&self, point: &Unknowns, tangent: &Unknowns) -> MaximalPeriodicSolution {
        if point[unknown::VELOCITY] == 0.0 {
            self.equations.limiting_solution(point, tangent)
        } else {
            self.equations.solution(point).0
        }
    }

    fn end_at_grazing(
        &self,
        crossing: Unknowns,
        tangent: &Unknowns,
        memory: &mut Memory,
        points: &mut Vec<CurvePoint>,
    ) -> CurveEnd {
        let condition = Condition::ImpactVelocity(0.0);
        let located = match self.condition {
            Condition::InteriorGrazing => locate_grazing_end(&self.equations, crossing, memory),
            _ => locate(&self.equations, [self.condition, condition], crossing, memory),
        };
        match located {
            Ok(mut point) => {
                point[unknown::VELOCITY] = 0.0;
                points.push(CurvePoint { solution: self.grazing_solution(&point, tangent), memory: memory.clone() });
                CurveEnd::Grazing
            }
            Err(failure) => CurveEnd::EventNotLocated { condition, failure },
        }
    }

    /// The point at which the curve crosses the edge of the window, or the point beyond if it cannot be located.
    fn on_the_edge(&self, window: &Window, inside: &Unknowns, outside: &Unknowns, memory: &mut Memory) -> Unknowns {
        let edges = [
            (unknown::PRIMARY, window.primary),
            (unknown::SECONDARY, window.secondary),
        ];
        for (coordinate, [low, high]) in edges {
            let edge = if outside[coordinate] < low { low } else { high };
            if low <= outside[coordinate] && outside[coordinate] <= high {
                continue;
            }
            let condition = match coordinate {
                unknown::PRIMARY => Condition::Primary(edge),
                _ => Condition::Secondary(edge),
            };
            let start = between(inside, outside, coordinate, edge);
            let located = locate(&self.equations, [self.condition, condition], start, &mut memory.clone());
            if let Ok(mut point) = located {
                point[coordinate] = edge;
                if window.contains(&point) {
                    return point;
                }
            }
        }
        *outside
    }

    fn signs(&self, pair: &LoopPair, solution: &MaximalPeriodicSolution) -> Signs {
        let watches = !matches!(self.condition, Condition::Multiplier(_));
        Signs {
            saddle_node: watches && pair.characteristic(1.0).0 > 0.0,
            period_doubling: watches && pair.characteristic(-1.0).0 > 0.0,
            inadmissible: solution.ceiling() > MaximalPeriodicSolution::TOUCH,
        }
    }

    fn changes(&self, past: Signs, now: Signs) -> impl Iterator<Item = Condition> + use<O> {
        let list = [
            (past.saddle_node != now.saddle_node, Condition::SADDLE_NODE),
            (past.period_doubling != now.period_doubling, Condition::PERIOD_DOUBLING),
            (past.inadmissible != now.inadmissible, Condition::InteriorGrazing),
        ];
        list.into_iter().filter_map(|(changed, condition)| changed.then_some(condition))
    }

    /// Locates an event between two points of the curve.
    fn event(
        &self,
        condition: Condition,
        before: &Unknowns,
        after: &Unknowns,
        beyond: &MaximalPeriodicSolution,
        memory: &mut Memory,
    ) -> Result<MaximalPeriodicSolution, NewtonFailure<MapError>> {
        let mut start = (before + after) * 0.5;
        if condition == Condition::InteriorGrazing {
            // The maximum that crosses the wall is the highest one at whichever end is inadmissible.
            let solution = if beyond.ceiling() > 0.0 {
                start = *after;
                *beyond
            } else {
                start = *before;
                self.equations.solution(before).0
            };
            if let Some(maximum) = solution.highest_interior_maximum {
                memory.grazing_time = maximum.time;
            }
        }
        let point = locate(&self.equations, [self.condition, condition], start, memory)?;
        Ok(self.equations.solution(&point).0)
    }
}

/// Impact velocities at or below this count as zero (empirical: y = 0 is approached transversally).
const VANISHING_VELOCITY: f64 = 1e-9;

/// The point on the chord where one coordinate takes a value.
fn between(before: &Unknowns, after: &Unknowns, coordinate: usize, value: f64) -> Unknowns {
    let (a, b) = (before[coordinate], after[coordinate]);
    let mut point: Vector4<f64> = before + (after - before) * ((value - a) / (b - a));
    point[coordinate] = value;
    point
}
