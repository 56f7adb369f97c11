//! Pseudo-arclength continuation of a curve of zeros of N − 1 equations in N unknowns.
//!
//! The bordered system that a corrector step solves, with t the tangent and s the step:
//!
//! ```text
//! ┌ DF(u) ┐      ┌ F(u)             ┐
//! │       │ Δu = │                  │
//! └ tᵀ    ┘      └ tᵀ(u − u₀) − s   ┘
//! ```
//!
//! The system stays regular at folds. The engine has no notion of what the curve means: the caller
//! handles events and diagnostics, and either advances the curve point by point or has it followed
//! from end to end ([`Traversal`]).

use core::f64::consts::TAU;
use core::fmt;

use crate::newton::{self, Linearisation, NewtonFailure, Space};
use crate::regula_falsi::zero_between;
use crate::tolerances::{self, CORRECTIONS, EVALUATIONS, FARTHEST_CORRECTION};

/// N − 1 smooth equations in N unknowns.
pub trait CurveEquations {
    /// The unknowns.
    type Point: Space;
    /// State that the equations carry from point to point along the curve, such as the times of
    /// events.
    type Carried: Clone;
    /// The reason why the equations can be undefined at a point.
    type Failure: Copy;

    /// The equations in the first N − 1 rows; the last row is zero and is filled by the engine.
    ///
    /// # Errors
    /// The equations are not defined at `point`.
    fn evaluate(
        &self,
        point: &Self::Point,
        carried: &mut Self::Carried,
    ) -> Result<Linearisation<Self::Point>, Self::Failure>;

    /// Whether the state carried from the last evaluation may change with one more correction, so
    /// that a rough point is not enough.
    fn is_unsettled(&self, _carried: &Self::Carried) -> bool {
        false
    }

    /// The unit of each unknown in lengths of steps and in turns.
    fn units(&self, point: &Self::Point) -> Self::Point {
        point.filled(1.0)
    }

    /// Called with every accepted point, to bring the carried state up to it.
    fn settle(&self, _point: &Self::Point, _carried: &mut Self::Carried) {}
}

/// Control of the step length. All lengths are in the Euclidean norm of the unknowns, each divided
/// by its unit.
#[derive(Clone, Copy, Debug)]
pub struct StepControl {
    /// Length of the first step.
    pub first: f64,
    /// Steps never get longer than this.
    pub longest: f64,
    /// A step that would have to be shorter than this ends the curve; it must exceed
    /// [`tolerances::STEP`], below which the corrector cannot judge a step.
    pub shortest: f64,
    /// The tangent turns by about this angle from point to point, in radians.
    pub turn: f64,
    /// The corrector's last step is no longer than this, nor than a thousandth of the step; its square is
    /// about the error of a point.
    pub tolerance: f64,
}

impl StepControl {
    /// Steps for curves that are drawn: two degrees of turn look smooth at any magnification used
    /// (empirical).
    pub const DRAWING: Self =
        Self { first: 1e-3, longest: 0.02, shortest: 1e-6, turn: 0.035, tolerance: tolerances::STEP };

    /// Whether points are rough, so that only the quantities that reveal events along a curve are
    /// computed at them.
    pub fn sketches(&self) -> bool {
        self.tolerance > tolerances::STEP
    }
}

/// A point on the curve.
#[derive(Clone, Debug)]
pub struct Station<V, M> {
    /// The unknowns.
    pub point: V,
    /// The tangent, pointing onwards, of length one with each unknown divided by its unit.
    pub tangent: V,
    /// The state that the equations carry at this point.
    pub carried: M,
}

/// A point on the curve of these equations.
pub type StationOf<C> = Station<<C as CurveEquations>::Point, <C as CurveEquations>::Carried>;

/// The error that no further point could be found.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("step length {step:.1e}: {failure}")]
pub struct Stall<E> {
    /// The length of the shortest step that was tried.
    pub step: f64,
    /// The reason why that step failed.
    pub failure: NewtonFailure<E>,
}

/// A continuation in progress.
#[derive(Clone, Debug)]
pub struct Continuation<'a, C: CurveEquations> {
    equations: &'a C,
    control: StepControl,
    /// The unit of each unknown: all lengths are taken after division by these.
    units: C::Point,
    here: Station<C::Point, C::Carried>,
    step: f64,
    /// The last point and its tangent, in these units, and the previous ones.
    counted: Tangent<C::Point>,
    past: Option<Tangent<C::Point>>,
}

/// A new station and the angle by which the curve turned on the way.
type Attempt<C> = (StationOf<C>, f64);

/// A step is repeated if the tangent or the chord turns by more than this multiple of the target angle
/// (empirical). If the chord does and the new tangent does not, the step led to another curve beside this one.
const OVERTURN: f64 = 3.0;
/// Bounds of the ratio of a new step, chosen by the turn, to the last one (empirical).
const GROWTH: [f64; 2] = [0.5, 1.6];
/// Factors by which a step shrinks if the tangent turns too far in it, and if no point is found
/// (empirical).
const TURNED: f64 = 0.5;
const NOT_FOUND: f64 = 0.25;
/// Largest ratio of the corrector's last step to the step: among violent motion, where steps are short, a point
/// is off by far more than the square of the corrector's last step (empirical).
const OF_STEP: f64 = 1e-3;
/// Steps up to this many times as long as the shortest are not repeated because of the turn
/// (empirical).
const SHORT: f64 = 4.0;

impl<'a, C: CurveEquations> Continuation<'a, C> {
    /// Starts at a point of the curve, in the direction closer to `direction`.
    ///
    /// # Errors
    /// The equations are undefined at the start, or the curve has no unique tangent there.
    pub fn new(
        equations: &'a C,
        control: StepControl,
        start: C::Point,
        direction: C::Point,
        mut carried: C::Carried,
    ) -> Result<Self, Stall<C::Failure>> {
        let stall = |failure| Stall { step: 0.0, failure };
        let units = equations.units(&start);
        let counted = start.component_div(&units);
        let linearisation = in_units(equations, &units, &counted, &mut carried)
            .map_err(|cause| stall(NewtonFailure::Undefined { iteration: 1, cause }))?;
        let residual = linearisation.residual.norm();
        let tangent = linearisation
            .bordered(0.0, &direction.component_div(&units))
            .null_direction()
            .ok_or(stall(NewtonFailure::Singular { iteration: 1, residual }))?;
        equations.settle(&start, &mut carried);
        let here = Station { point: start, tangent: tangent.component_mul(&units), carried };
        Ok(Self {
            equations,
            control,
            units,
            here,
            step: control.first,
            counted: (counted, tangent),
            past: None,
        })
    }

    /// The last point found.
    pub fn here(&self) -> &StationOf<C> {
        &self.here
    }

    /// Limits the length of the next step.
    pub fn limit(&mut self, longest: f64) {
        self.step = self.step.min(longest).max(self.control.shortest);
    }

    /// Finds the next point.
    ///
    /// # Errors
    /// Even the shortest step failed.
    pub fn advance(&mut self) -> Result<&StationOf<C>, Stall<C::Failure>> {
        loop {
            match self.attempt() {
                Ok((next, angle))
                    if angle <= OVERTURN * self.control.turn || self.step < SHORT * self.control.shortest =>
                {
                    // Avoids a division by zero where nothing turns.
                    let growth =
                        (self.control.turn / angle.max(f64::MIN_POSITIVE)).clamp(GROWTH[0], GROWTH[1]);
                    self.step = (self.step * growth).clamp(self.control.shortest, self.control.longest);
                    let Station { point, tangent, carried } = next;
                    self.here = Station {
                        point: point.component_mul(&self.units),
                        tangent: tangent.component_mul(&self.units),
                        carried,
                    };
                    self.past = Some(core::mem::replace(&mut self.counted, (point, tangent)));
                    return Ok(&self.here);
                }
                Ok(_) => self.step *= TURNED,
                Err(failure) => {
                    if self.step <= self.control.shortest {
                        return Err(Stall { step: self.step, failure });
                    }
                    self.step *= NOT_FOUND;
                }
            }
            self.step = self.step.max(self.control.shortest);
        }
    }

    /// The cubic through the last two points with their tangents, extrapolated to the plane of the
    /// corrector.
    fn predict(&self) -> C::Point {
        let (point, tangent) = self.counted.clone();
        let step = self.step;
        let Some((past, past_tangent)) = self.past.clone() else { return point + tangent * step };
        let gap = (point.clone() - past.clone()).norm();
        let a = (past - point.clone() + tangent.clone() * gap) / (gap * gap);
        let b = (tangent.clone() - past_tangent) / gap;
        let ratio = step / gap;
        let bend = (a.clone() * 3.0 - b.clone() + (a * 2.0 - b) * ratio) * (step * step);
        let along = step - tangent.dot(&bend);
        point + tangent * along + bend
    }

    /// One predictor and corrector: the new station, with its unknowns divided by their units, and
    /// the angle between the last tangent and the new one or the chord, whichever is larger.
    fn attempt(&self) -> Result<Attempt<C>, NewtonFailure<C::Failure>> {
        let (origin, along) = &self.counted;
        let mut carried = self.here.carried.clone();
        let corrected = |near: C::Point, tolerance: f64, carried: &mut C::Carried| {
            newton::solve_within(FARTHEST_CORRECTION * self.step, tolerance, near, CORRECTIONS, |point| {
                let system = in_units(self.equations, &self.units, point, carried)?;
                Ok(system.bordered(along.dot(&(point.clone() - origin.clone())) - self.step, along))
            })
        };
        let tolerance = self.control.tolerance.min(OF_STEP * self.step).max(tolerances::STEP);
        let mut solution = corrected(self.predict(), tolerance, &mut carried)?;
        if self.control.sketches() && self.equations.is_unsettled(&carried) {
            solution = corrected(solution.point, tolerances::STEP, &mut carried)?;
        }
        // The last corrector's matrix is bordered with the old tangent: its factors give the new
        // one as well.
        let tangent = solution
            .point
            .null_direction(&solution.factors)
            .ok_or(NewtonFailure::Singular { iteration: solution.iterations, residual: solution.residual })?;
        self.equations.settle(&solution.point.component_mul(&self.units), &mut carried);
        let turn = libm::acos(tangent.dot(along).clamp(-1.0, 1.0));
        let aside = (solution.point.clone() - origin.clone() - along.clone() * self.step).norm();
        // The points themselves are aside by as much.
        let swerve = if aside > self.control.tolerance { libm::atan(aside / self.step) } else { 0.0 };
        Ok((Station { point: solution.point, tangent, carried }, turn.max(swerve)))
    }
}

/// The equations at a point whose unknowns are divided by their units.
fn in_units<C: CurveEquations>(
    equations: &C,
    units: &C::Point,
    counted: &C::Point,
    carried: &mut C::Carried,
) -> Result<Linearisation<C::Point>, C::Failure> {
    let mut linearisation = equations.evaluate(&counted.component_mul(units), carried)?;
    units.scale_columns(&mut linearisation.jacobian);
    Ok(linearisation)
}

/// The point of a curve near `near`, in the plane through another point across a direction; `None`
/// where Newton's method fails.
pub fn across<C: CurveEquations<Carried: Default>>(
    equations: &C,
    near: C::Point,
    direction: &C::Point,
    through: &C::Point,
) -> Option<newton::Root<C::Point>> {
    let mut carried = C::Carried::default();
    let found = newton::solve(near, EVALUATIONS, |point| {
        let system = equations.evaluate(point, &mut carried)?;
        Ok::<_, C::Failure>(system.bordered(direction.dot(&(point.clone() - through.clone())), direction))
    });
    found.ok()
}

/// The value that `measure` returns at the point, between two points of a curve, where the number
/// returned with it vanishes; `None` if that number has the same sign at both, or the point is not
/// found.
pub(crate) fn zero_on<T, C: CurveEquations<Carried: Default>>(
    equations: &C,
    [a, b]: [C::Point; 2],
    measure: impl Fn(newton::Root<C::Point>) -> Option<(T, f64)>,
    enough: f64,
) -> Option<T> {
    let chord = b - a.clone();
    let direction = chord.clone() / chord.norm();
    let at = |share: f64| {
        let start = a.clone() + chord.clone() * share;
        measure(across(equations, start.clone(), &direction, &start)?)
    };
    let values = [at(0.0)?.1, at(1.0)?.1];
    if values[0] * values[1] >= 0.0 {
        return None;
    }
    zero_between(values, |share| at(share).ok_or(()), |_, value| value.abs() <= enough).ok()
}

/// The end of a curve that is followed through a window.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum WalkEnd<E> {
    /// The curve leaves the window.
    LeftWindow,
    /// The curve is closed: the last point is the first.
    Closed,
    /// No further point was found.
    Stalled(Stall<E>),
    /// The limit of points was reached.
    StepLimit,
    /// The computation was cancelled.
    Stopped,
}

impl<E: fmt::Display> WalkEnd<E> {
    /// The reason why the curve was not followed further; `None` where it ends as it should.
    pub fn lost(&self) -> Option<String> {
        match self {
            Self::LeftWindow | Self::Closed => None,
            Self::Stalled(stall) => Some(format!("no further point was found: {stall}")),
            Self::StepLimit => Some("after very many points there was no end".to_owned()),
            Self::Stopped => Some("the computation was stopped".to_owned()),
        }
    }
}

/// A point of a curve and the unit tangent there.
pub type Tangent<V> = (V, V);

/// The settings with which a curve is followed from end to end.
#[derive(Clone, Copy, Debug)]
pub struct Traversal<'a, C> {
    /// The curve's equations.
    pub equations: &'a C,
    /// Control of the step length.
    pub control: StepControl,
    /// A curve with this many points is abandoned.
    pub step_limit: usize,
    /// The index of the unknown that is an angle, if there is one: its values are equal up to whole
    /// turns.
    pub angle: Option<usize>,
}

/// Lower bound on the points of a closed curve: its tangent turns once round, by a few degrees from
/// point to point.
pub const FEWEST_OF_A_LOOP: usize = 10;

/// The points of a curve in order, and how it ends.
type Walked<V, E, T> = Result<(Vec<Tangent<V>>, T), Stall<E>>;

impl<C: CurveEquations<Carried: Default>> Traversal<'_, C> {
    /// The points on both sides of `start`, in the order of `direction`, and the ends before the
    /// first and after the last point.
    ///
    /// `leaves` receives the last point and the next with its tangent. Where the curve leaves the
    /// window between the two, it returns the point on the edge.
    ///
    /// # Errors
    /// The curve cannot be started.
    pub fn both_ways(
        &self,
        start: C::Point,
        direction: C::Point,
        leaves: impl Fn(&C::Point, &Tangent<C::Point>) -> Option<Tangent<C::Point>>,
    ) -> Walked<C::Point, C::Failure, [WalkEnd<C::Failure>; 2]> {
        let (mut after, last) = self.one_way(start.clone(), direction.clone(), &leaves)?;
        if matches!(last, WalkEnd::Closed) {
            return Ok((after, [last, last]));
        }
        let (mut points, first) = self.one_way(start, -direction, &leaves)?;
        // The start is in both lists; tangents point onwards.
        points.reverse();
        points.pop();
        points.iter_mut().for_each(|(_, tangent)| *tangent = -tangent.clone());
        points.append(&mut after);
        Ok((points, [first, last]))
    }

    fn one_way(
        &self,
        start: C::Point,
        direction: C::Point,
        leaves: impl Fn(&C::Point, &Tangent<C::Point>) -> Option<Tangent<C::Point>>,
    ) -> Walked<C::Point, C::Failure, WalkEnd<C::Failure>> {
        let carried = C::Carried::default();
        let mut walker = Continuation::new(self.equations, self.control, start.clone(), direction, carried)?;
        let first = (start, walker.here().tangent.clone());
        let mut points = vec![first.clone()];
        while points.len() < self.step_limit {
            let before = walker.here().point.clone();
            let next = match walker.advance() {
                Ok(station) => (station.point.clone(), station.tangent.clone()),
                Err(stall) => return Ok((points, WalkEnd::Stalled(stall))),
            };
            if let Some(edge) = leaves(&before, &next) {
                points.push(edge);
                return Ok((points, WalkEnd::LeftWindow));
            }
            if points.len() > FEWEST_OF_A_LOOP
                && let Some(back) = back_at(first.clone(), [&before, &next.0], self.control.turn, self.angle)
            {
                points.push((back, first.1));
                return Ok((points, WalkEnd::Closed));
            }
            points.push(next);
        }
        Ok((points, WalkEnd::StepLimit))
    }
}

/// The start of a curve, if the curve returns to it between two of its points, with the angle among
/// the unknowns increased by the whole turns made since. `onwards` is the direction in which the
/// curve left the start.
pub fn back_at<V: Space>(
    (start, onwards): Tangent<V>,
    [before, after]: [&V; 2],
    turn: f64,
    angle: Option<usize>,
) -> Option<V> {
    let gap = |point: &V| {
        let mut gap = point.clone() - start.clone();
        if let Some(angle) = angle {
            gap[angle] = libm::remainder(gap[angle], TAU);
        }
        gap
    };
    let [past, now] = [gap(before), gap(after)];
    let near = past.norm().max(now.norm()) <= (after.clone() - before.clone()).norm() * (1.0 + turn);
    (near && past.dot(&onwards) < 0.0 && now.dot(&onwards) >= 0.0).then(|| {
        let mut back = start.clone();
        if let Some(angle) = angle {
            back[angle] = after[angle] - now[angle];
        }
        back
    })
}
