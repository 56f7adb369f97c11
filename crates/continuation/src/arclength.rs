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
//! It stays regular at folds. The engine knows nothing of what the curve means: events and
//! diagnostics are the caller's, who advances it point by point, or has it followed from end to end
//! ([`Walk`]).

use core::f64::consts::TAU;
use core::fmt;

use nalgebra::{Const, DimMin, LU, SVector};

use crate::newton::{self, Linearisation, NewtonFailure};
use crate::regula_falsi::zero_between;
use crate::tolerances::{self, CORRECTIONS, EVALUATIONS, FARTHEST_CORRECTION};

/// N − 1 smooth equations in N unknowns.
pub trait CurveEquations<const N: usize> {
    /// What the equations carry from point to point along the curve, such as the times of events.
    type Carried: Clone;
    /// Why the equations can be undefined at a point.
    type Failure: Copy;

    /// The equations in the first N − 1 rows; the last row is zero and is filled by the engine.
    ///
    /// # Errors
    /// The equations are not defined at `point`.
    fn evaluate(
        &self,
        point: &SVector<f64, N>,
        carried: &mut Self::Carried,
    ) -> Result<Linearisation<N>, Self::Failure>;

    /// Whether what is carried from the last evaluation may be something else a correction further,
    /// so that a rough point is not enough.
    fn is_unsettled(&self, _carried: &Self::Carried) -> bool {
        false
    }

    /// The unit in which each unknown is counted in lengths of steps and in turns.
    fn units(&self) -> SVector<f64, N> {
        SVector::repeat(1.0)
    }

    /// Called with every accepted point, to bring what is carried up to it.
    fn settle(&self, _point: &SVector<f64, N>, _carried: &mut Self::Carried) {}
}

/// Control of the step length. All lengths are in the Euclidean norm of the unknowns, each counted
/// in its unit.
#[derive(Clone, Copy, Debug)]
pub struct StepControl {
    /// Length of the first step.
    pub first: f64,
    /// Steps never get longer than this.
    pub longest: f64,
    /// A step that would have to be shorter than this ends the curve; longer than
    /// [`tolerances::STEP`], below which the corrector cannot judge a step.
    pub shortest: f64,
    /// The tangent turns by about this angle from point to point, in radians.
    pub turn: f64,
    /// The corrector's last step is no longer than this; its square is about the error of a point.
    pub tolerance: f64,
}

impl StepControl {
    /// Steps for curves that are drawn: two degrees of turn look smooth at any magnification used
    /// (empirical).
    pub const DRAWING: Self =
        Self { first: 1e-3, longest: 0.02, shortest: 1e-6, turn: 0.035, tolerance: tolerances::STEP };

    /// Whether points are so rough that no more is to be computed of them than serves to find what
    /// happens along a curve.
    pub fn sketches(&self) -> bool {
        self.tolerance > tolerances::STEP
    }
}

/// A point on the curve.
#[derive(Clone, Debug)]
pub struct Station<const N: usize, M> {
    /// The unknowns.
    pub point: SVector<f64, N>,
    /// The tangent, pointing onwards, of length one where each unknown is counted in its unit.
    pub tangent: SVector<f64, N>,
    /// What the equations carry there.
    pub carried: M,
}

/// No further point could be found.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("step length {step:.1e}: {failure}")]
pub struct Stall<E> {
    /// The shortest step that was tried.
    pub step: f64,
    /// What happened in it.
    pub failure: NewtonFailure<E>,
}

/// A curve in the course of being followed.
#[derive(Clone, Debug)]
pub struct Continuation<'a, const N: usize, C: CurveEquations<N>> {
    equations: &'a C,
    control: StepControl,
    /// What each unknown is counted in: all lengths are taken after division by these.
    units: SVector<f64, N>,
    here: Station<N, C::Carried>,
    step: f64,
    /// The last point and its tangent, and those before.
    counted: Tangent<N>,
    past: Option<Tangent<N>>,
}

/// A new station and the angle by which the tangent turned on the way.
type Attempt<const N: usize, M> = (Station<N, M>, f64);

/// A step is taken again if the tangent turns by more than so many times the angle that is aimed at
/// (empirical).
const OVERTURN: f64 = 3.0;
/// A new step is as long as the turn suggests, within these factors of the last (empirical).
const GROWTH: [f64; 2] = [0.5, 1.6];
/// What is left of a step if the tangent turns too far in it, and if no point is found (empirical).
const TURNED: f64 = 0.5;
const NOT_FOUND: f64 = 0.25;
/// Steps this few times as long as the shortest are not taken again for the sake of the turn
/// (empirical).
const SHORT: f64 = 4.0;

impl<'a, const N: usize, C: CurveEquations<N>> Continuation<'a, N, C>
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    /// Starts at a point of the curve, heading to the side of `direction`.
    ///
    /// # Errors
    /// The equations are undefined at the start, or the curve has no unique tangent there.
    pub fn new(
        equations: &'a C,
        control: StepControl,
        start: SVector<f64, N>,
        direction: SVector<f64, N>,
        mut carried: C::Carried,
    ) -> Result<Self, Stall<C::Failure>> {
        let stall = |failure| Stall { step: 0.0, failure };
        let units = equations.units();
        let counted = start.component_div(&units);
        let linearisation = in_units(equations, &units, &counted, &mut carried)
            .map_err(|cause| stall(NewtonFailure::Undefined { iteration: 1, cause }))?;
        let residual = linearisation.residual.norm();
        let bordered = linearisation.bordered(0.0, &direction.component_div(&units)).jacobian;
        let tangent =
            tangent(&bordered.lu()).ok_or(stall(NewtonFailure::Singular { iteration: 1, residual }))?;
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
    pub fn here(&self) -> &Station<N, C::Carried> {
        &self.here
    }

    /// Lets the next step be no longer than this.
    pub fn limit(&mut self, longest: f64) {
        self.step = self.step.min(longest).max(self.control.shortest);
    }

    /// Finds the next point.
    ///
    /// # Errors
    /// Even the shortest step failed.
    pub fn advance(&mut self) -> Result<&Station<N, C::Carried>, Stall<C::Failure>> {
        loop {
            match self.attempt() {
                Ok((next, angle))
                    if angle <= OVERTURN * self.control.turn || self.step < SHORT * self.control.shortest =>
                {
                    // Where nothing turns, without a division by zero.
                    let growth =
                        (self.control.turn / angle.max(f64::MIN_POSITIVE)).clamp(GROWTH[0], GROWTH[1]);
                    self.step = (self.step * growth).clamp(self.control.shortest, self.control.longest);
                    let Station { point, tangent, carried } = next;
                    self.past = Some(core::mem::replace(&mut self.counted, (point, tangent)));
                    self.here = Station {
                        point: point.component_mul(&self.units),
                        tangent: tangent.component_mul(&self.units),
                        carried,
                    };
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

    /// The cubic through the last two points with their tangents, extrapolated to the plane that
    /// the corrector works in.
    fn predict(&self) -> SVector<f64, N> {
        let (point, tangent) = &self.counted;
        let step = self.step;
        let Some((past, past_tangent)) = &self.past else { return point + tangent * step };
        let gap = (point - past).norm();
        let a = (past - point + tangent * gap) / (gap * gap);
        let b = (tangent - past_tangent) / gap;
        let ratio = step / gap;
        let bend = (a * 3.0 - b + (a * 2.0 - b) * ratio) * (step * step);
        point + tangent * (step - tangent.dot(&bend)) + bend
    }

    /// One predictor and corrector; the new station, counted in units, and the angle between the
    /// two tangents.
    fn attempt(&self) -> Result<Attempt<N, C::Carried>, NewtonFailure<C::Failure>> {
        let (origin, along) = &self.counted;
        let mut carried = self.here.carried.clone();
        let corrected = |near: SVector<f64, N>, tolerance: f64, carried: &mut C::Carried| {
            newton::solve_within(FARTHEST_CORRECTION * self.step, tolerance, near, CORRECTIONS, |point| {
                let system = in_units(self.equations, &self.units, point, carried)?;
                Ok(system.bordered(along.dot(&(point - origin)) - self.step, along))
            })
        };
        let mut solution = corrected(self.predict(), self.control.tolerance, &mut carried)?;
        if self.control.sketches() && self.equations.is_unsettled(&carried) {
            solution = corrected(solution.point, tolerances::STEP, &mut carried)?;
        }
        // The last corrector's matrix is bordered with the old tangent: its factors give the new
        // one as well.
        let tangent = tangent(&solution.factors)
            .ok_or(NewtonFailure::Singular { iteration: solution.iterations, residual: solution.residual })?;
        self.equations.settle(&solution.point.component_mul(&self.units), &mut carried);
        let angle = libm::acos(tangent.dot(along).clamp(-1.0, 1.0));
        Ok((Station { point: solution.point, tangent, carried }, angle))
    }
}

/// The equations at a point whose unknowns are counted in units.
fn in_units<const N: usize, C: CurveEquations<N>>(
    equations: &C,
    units: &SVector<f64, N>,
    counted: &SVector<f64, N>,
    carried: &mut C::Carried,
) -> Result<Linearisation<N>, C::Failure> {
    let mut linearisation = equations.evaluate(&counted.component_mul(units), carried)?;
    for (mut column, unit) in linearisation.jacobian.column_iter_mut().zip(units.iter()) {
        column.scale_mut(*unit);
    }
    Ok(linearisation)
}

/// The point of a curve near another in the plane across a direction that goes through a third;
/// none where Newton's method fails.
pub fn across<const N: usize, C: CurveEquations<N, Carried: Default>>(
    equations: &C,
    near: SVector<f64, N>,
    direction: &SVector<f64, N>,
    through: &SVector<f64, N>,
) -> Option<newton::Solution<N>>
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    let mut carried = C::Carried::default();
    let found = newton::solve(near, EVALUATIONS, |point| {
        let system = equations.evaluate(point, &mut carried)?;
        Ok::<_, C::Failure>(system.bordered(direction.dot(&(point - through)), direction))
    });
    found.ok()
}

/// What is found on a curve between two of its points where a number that `measure` finds along with it
/// vanishes; none if it has one sign at both, or is not found.
pub(crate) fn zero_on<const N: usize, T, C: CurveEquations<N, Carried: Default>>(
    equations: &C,
    [a, b]: [SVector<f64, N>; 2],
    measure: impl Fn(newton::Solution<N>) -> Option<(T, f64)>,
    enough: f64,
) -> Option<T>
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    let at = |share: f64| {
        let start = a + (b - a) * share;
        measure(across(equations, start, &(b - a).normalize(), &start)?)
    };
    let values = [at(0.0)?.1, at(1.0)?.1];
    if values[0] * values[1] >= 0.0 {
        return None;
    }
    zero_between(values, |share| at(share).ok_or(()), |_, value| value.abs() <= enough).ok()
}

/// How a curve ends that is followed through a window.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum WalkEnd<E> {
    /// It leaves the window.
    LeftWindow,
    /// It is closed: the last point is the first.
    Closed,
    /// No further point was found.
    Stalled(Stall<E>),
    /// The limit of points was reached.
    StepLimit,
}

impl<E: fmt::Display> WalkEnd<E> {
    /// Why the curve was followed no further; nothing where that is as it should be.
    pub fn lost(&self) -> Option<String> {
        match self {
            Self::LeftWindow | Self::Closed => None,
            Self::Stalled(stall) => Some(format!("no further point was found: {stall}")),
            Self::StepLimit => Some("after very many points there was no end".to_owned()),
        }
    }
}

/// A point of a curve and the unit tangent there.
pub type Tangent<const N: usize> = (SVector<f64, N>, SVector<f64, N>);

/// What a curve is followed with from end to end.
#[derive(Clone, Copy, Debug)]
pub struct Walk<'a, const N: usize, C> {
    /// The curve's equations.
    pub equations: &'a C,
    /// Control of the step length.
    pub control: StepControl,
    /// A curve of this many points goes nowhere.
    pub step_limit: usize,
    /// The unknown that is an angle, if there is one: the same up to whole turns.
    pub angle: Option<usize>,
}

/// A closed curve has more points than this: its tangent turns once round, by a few degrees from
/// point to point.
pub const FEWEST_OF_A_LOOP: usize = 10;

/// The points of a curve in order, and how it ends.
type Walked<const N: usize, E, T> = Result<(Vec<Tangent<N>>, T), Stall<E>>;

impl<const N: usize, C: CurveEquations<N, Carried: Default>> Walk<'_, N, C>
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    /// The points from `start` to both sides, in the order of `direction`, and how they end before
    /// the first and after the last.
    ///
    /// `leaves` gets the last point and the next with its tangent. Where the curve leaves the
    /// window between the two it gives the point on the edge.
    ///
    /// # Errors
    /// The curve cannot be started.
    pub fn both_ways(
        &self,
        start: SVector<f64, N>,
        direction: SVector<f64, N>,
        leaves: impl Fn(&SVector<f64, N>, &Tangent<N>) -> Option<Tangent<N>>,
    ) -> Walked<N, C::Failure, [WalkEnd<C::Failure>; 2]> {
        let (mut after, last) = self.one_way(start, direction, &leaves)?;
        if matches!(last, WalkEnd::Closed) {
            return Ok((after, [last, last]));
        }
        let (mut points, first) = self.one_way(start, -direction, &leaves)?;
        // The start stands in both; tangents point onwards.
        points.reverse();
        points.pop();
        points.iter_mut().for_each(|(_, tangent)| *tangent = -*tangent);
        points.append(&mut after);
        Ok((points, [first, last]))
    }

    fn one_way(
        &self,
        start: SVector<f64, N>,
        direction: SVector<f64, N>,
        leaves: impl Fn(&SVector<f64, N>, &Tangent<N>) -> Option<Tangent<N>>,
    ) -> Walked<N, C::Failure, WalkEnd<C::Failure>> {
        let carried = C::Carried::default();
        let mut walker = Continuation::new(self.equations, self.control, start, direction, carried)?;
        let first = (start, walker.here().tangent);
        let mut points = vec![first];
        while points.len() < self.step_limit {
            let before = walker.here().point;
            let next = match walker.advance() {
                Ok(station) => (station.point, station.tangent),
                Err(stall) => return Ok((points, WalkEnd::Stalled(stall))),
            };
            if let Some(edge) = leaves(&before, &next) {
                points.push(edge);
                return Ok((points, WalkEnd::LeftWindow));
            }
            if points.len() > FEWEST_OF_A_LOOP
                && let Some(back) = back_at(first, [&before, &next.0], self.control.turn, self.angle)
            {
                points.push((back, first.1));
                return Ok((points, WalkEnd::Closed));
            }
            points.push(next);
        }
        Ok((points, WalkEnd::StepLimit))
    }
}

/// The start of a curve, if the curve comes back to it between two of its points; with the unknown
/// that is an angle as far on as it is then. `onwards` is where the curve went from the start.
pub fn back_at<const N: usize>(
    (start, onwards): Tangent<N>,
    [before, after]: [&SVector<f64, N>; 2],
    turn: f64,
    angle: Option<usize>,
) -> Option<SVector<f64, N>> {
    let gap = |point: &SVector<f64, N>| {
        let mut gap = point - start;
        if let Some(angle) = angle {
            gap[angle] = libm::remainder(gap[angle], TAU);
        }
        gap
    };
    let [past, now] = [gap(before), gap(after)];
    let near = past.norm().max(now.norm()) <= (after - before).norm() * (1.0 + turn);
    (near && past.dot(&onwards) < 0.0 && now.dot(&onwards) >= 0.0).then(|| {
        let mut back = start;
        if let Some(angle) = angle {
            back[angle] = after[angle] - now[angle];
        }
        back
    })
}

/// The unit null vector of the first N − 1 rows of a matrix, at an acute angle with its last row;
/// from the matrix's factors.
fn tangent<const N: usize>(factors: &LU<f64, Const<N>, Const<N>>) -> Option<SVector<f64, N>>
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    let mut last = SVector::zeros();
    last[N - 1] = 1.0;
    let tangent = factors.solve(&last)?;
    let norm = tangent.norm();
    (norm.is_finite() && norm > 0.0).then(|| tangent / norm)
}
