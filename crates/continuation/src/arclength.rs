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
//! from end to end ([`Walk`]).

use core::f64::consts::TAU;
use core::fmt;

use nalgebra::{Const, DimMin, LU, SVector};

use crate::newton::{self, Linearisation, NewtonFailure};
use crate::regula_falsi::zero_between;
use crate::tolerances::{self, CORRECTIONS, EVALUATIONS, FARTHEST_CORRECTION};

/// N − 1 smooth equations in N unknowns.
pub trait CurveEquations<const N: usize> {
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
        point: &SVector<f64, N>,
        carried: &mut Self::Carried,
    ) -> Result<Linearisation<N>, Self::Failure>;

    /// Whether the state carried from the last evaluation may change with one more correction, so
    /// that a rough point is not enough.
    fn is_unsettled(&self, _carried: &Self::Carried) -> bool {
        false
    }

    /// The unit of each unknown in lengths of steps and in turns.
    fn units(&self) -> SVector<f64, N> {
        SVector::repeat(1.0)
    }

    /// Called with every accepted point, to bring the carried state up to it.
    fn settle(&self, _point: &SVector<f64, N>, _carried: &mut Self::Carried) {}
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
    /// The corrector's last step is no longer than this; its square is about the error of a point.
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
pub struct Station<const N: usize, M> {
    /// The unknowns.
    pub point: SVector<f64, N>,
    /// The tangent, pointing onwards, of length one with each unknown divided by its unit.
    pub tangent: SVector<f64, N>,
    /// The state that the equations carry at this point.
    pub carried: M,
}

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
pub struct Continuation<'a, const N: usize, C: CurveEquations<N>> {
    equations: &'a C,
    control: StepControl,
    /// The unit of each unknown: all lengths are taken after division by these.
    units: SVector<f64, N>,
    here: Station<N, C::Carried>,
    step: f64,
    /// The last point and its tangent, in these units, and the previous ones.
    counted: Tangent<N>,
    past: Option<Tangent<N>>,
}

/// A new station and the angle by which the tangent turned on the way.
type Attempt<const N: usize, M> = (Station<N, M>, f64);

/// A step is repeated if the tangent turns by more than this multiple of the target angle
/// (empirical).
const OVERTURN: f64 = 3.0;
/// Bounds of the ratio of a new step, chosen by the turn, to the last one (empirical).
const GROWTH: [f64; 2] = [0.5, 1.6];
/// Factors by which a step shrinks if the tangent turns too far in it, and if no point is found
/// (empirical).
const TURNED: f64 = 0.5;
const NOT_FOUND: f64 = 0.25;
/// Steps up to this many times as long as the shortest are not repeated because of the turn
/// (empirical).
const SHORT: f64 = 4.0;

impl<'a, const N: usize, C: CurveEquations<N>> Continuation<'a, N, C>
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    /// Starts at a point of the curve, in the direction closer to `direction`.
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

    /// Limits the length of the next step.
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
                    // Avoids a division by zero where nothing turns.
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

    /// The cubic through the last two points with their tangents, extrapolated to the plane of the
    /// corrector.
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

    /// One predictor and corrector: the new station, with its unknowns divided by their units, and
    /// the angle between the two tangents.
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

/// The equations at a point whose unknowns are divided by their units.
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

/// The point of a curve near `near`, in the plane through another point across a direction; `None`
/// where Newton's method fails.
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

/// The value that `measure` returns at the point, between two points of a curve, where the number
/// returned with it vanishes; `None` if that number has the same sign at both, or the point is not
/// found.
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
pub type Tangent<const N: usize> = (SVector<f64, N>, SVector<f64, N>);

/// The settings with which a curve is followed from end to end.
#[derive(Clone, Copy, Debug)]
pub struct Walk<'a, const N: usize, C> {
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
type Walked<const N: usize, E, T> = Result<(Vec<Tangent<N>>, T), Stall<E>>;

impl<const N: usize, C: CurveEquations<N, Carried: Default>> Walk<'_, N, C>
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
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
        start: SVector<f64, N>,
        direction: SVector<f64, N>,
        leaves: impl Fn(&SVector<f64, N>, &Tangent<N>) -> Option<Tangent<N>>,
    ) -> Walked<N, C::Failure, [WalkEnd<C::Failure>; 2]> {
        let (mut after, last) = self.one_way(start, direction, &leaves)?;
        if matches!(last, WalkEnd::Closed) {
            return Ok((after, [last, last]));
        }
        let (mut points, first) = self.one_way(start, -direction, &leaves)?;
        // The start is in both lists; tangents point onwards.
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

/// The start of a curve, if the curve returns to it between two of its points, with the angle among
/// the unknowns increased by the whole turns made since. `onwards` is the direction in which the
/// curve left the start.
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

/// The unit null vector of the first N − 1 rows of a matrix, at an acute angle with its last row,
/// computed from the matrix's factors.
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
