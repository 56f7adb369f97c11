//! Conditions on MPSs, and the points at which two of them hold.

use grazing_model::ImpactOscillator;
use grazing_model::maps::MapError;
use nalgebra::{Matrix2, Matrix3, Vector2};

use crate::mps::{EventTimes, LoopEquations, Round, Unknowns, unknown};
use crate::newton::{self, Linearisation, NewtonFailure, Space};
use crate::tolerances::{self, EVALUATIONS, FARTHEST, SAME_POINT};

/// A scalar condition on an MPS. One condition defines a curve in (y, z, μ, η), two define a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Condition {
    /// A stability multiplier equals this: 1 at a saddle-node bifurcation, −1 at a period doubling.
    Multiplier(f64),
    /// A multiplier of symmetric motion without impacts, or with one impact at each of two stops, over half of
    /// its time is −1: a pitchfork.
    /// Motion that is not symmetric does not satisfy it.
    SymmetryBreaking,
    /// The product of both multipliers equals this: 1 at a torus bifurcation, where they are complex
    /// and so e^{±iθ}.
    Product(f64),
    /// The interior maximum whose event time is carried along touches the wall: a grazing
    /// bifurcation of the MPS.
    InteriorGrazing,
    /// A second interior maximum touches the wall, where one does already.
    SecondInteriorGrazing,
    /// The impact velocity, with several impacts that of the first, has this value; at 0 the MPS meets
    /// the non-impacting solution.
    ImpactVelocity(f64),
    /// The velocity of the impact with an index has this value.
    Velocity {
        /// The index of the impact, in the order of the unknowns.
        impact: usize,
        /// The velocity.
        value: f64,
    },
    /// The velocities of the first and the second impact differ by this.
    Difference(f64),
    /// The MPS is at this position when the forcing is at this phase, counted from that of the
    /// recoil.
    Position {
        /// The phase of the forcing, in radians.
        phase: f64,
        /// The position x.
        position: f64,
    },
    /// The primary parameter has this value.
    Primary(f64),
    /// The secondary parameter has this value: a one-parameter branch.
    Secondary(f64),
}

impl Condition {
    /// Saddle-node bifurcation (SN).
    pub const SADDLE_NODE: Self = Self::Multiplier(1.0);
    /// Period-doubling bifurcation (PD).
    pub const PERIOD_DOUBLING: Self = Self::Multiplier(-1.0);
    /// Torus bifurcation (NS), where the multipliers are complex.
    pub const TORUS: Self = Self::Product(1.0);

    /// The condition that an impact has no velocity.
    pub const fn stopped(impact: usize) -> Self {
        match impact {
            0 => Self::ImpactVelocity(0.0),
            _ => Self::Velocity { impact, value: 0.0 },
        }
    }

    /// Residual and gradient in the unknowns; the maps are of order 2 where
    /// [`needs_second_order`](Self::needs_second_order).
    pub(crate) fn evaluate<O: ImpactOscillator>(
        self,
        equations: &LoopEquations<O>,
        point: &Unknowns,
        maps: &Round,
        times: &mut EventTimes,
    ) -> Result<(f64, Unknowns), MapError> {
        let coordinate = |index: usize, value: f64| (point[index] - value, point.along(index));
        Ok(match self {
            Self::Multiplier(multiplier) => maps.characteristic(multiplier),
            // The maps are those of half a period.
            Self::SymmetryBreaking => maps.characteristic(-1.0),
            Self::Product(product) => maps.product_less(product),
            Self::InteriorGrazing | Self::SecondInteriorGrazing => {
                equations.maximum_near(point, self.maximum_time(times))?
            }
            Self::ImpactVelocity(value) => coordinate(unknown::VELOCITY, value),
            Self::Velocity { impact, value } => coordinate(unknown::velocity(impact), value),
            Self::Difference(value) => {
                let [first, second] = [0, 1].map(unknown::velocity);
                let gradient = point.along(first) - point.along(second);
                (point[first] - point[second] - value, gradient)
            }
            Self::Position { phase, position } => {
                let (there, gradient) = equations.position_at(point, phase);
                (there - position, gradient)
            }
            Self::Primary(value) => coordinate(unknown::PRIMARY, value),
            Self::Secondary(value) => coordinate(unknown::SECONDARY, value),
        })
    }

    /// The conditions that fix a point on the surface of solutions when it is carried to another η:
    /// y and η, or μ and η without impacts.
    pub fn beside<O: ImpactOscillator>(equations: &LoopEquations<O>, point: &Unknowns) -> [Self; 2] {
        let held = match equations.has_impacts() {
            true => Self::ImpactVelocity(point[unknown::VELOCITY]),
            false => Self::Primary(point[unknown::PRIMARY]),
        };
        [Self::Secondary(point[unknown::SECONDARY]), held]
    }

    /// The time of the interior maximum that touches the wall.
    pub(crate) fn maximum_time(self, times: &mut EventTimes) -> &mut f64 {
        match self {
            Self::SecondInteriorGrazing => &mut times.second_grazing_time,
            _ => &mut times.grazing_time,
        }
    }

    pub(crate) fn needs_second_order(self) -> bool {
        matches!(self, Self::Multiplier(_) | Self::SymmetryBreaking | Self::Product(_))
    }

    /// Whether one multiplier is 1 or −1 all along the curve.
    pub(crate) fn fixes_a_multiplier(self) -> bool {
        matches!(self, Self::SADDLE_NODE | Self::PERIOD_DOUBLING | Self::SymmetryBreaking)
    }
}

/// The reason why a point was not located.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum LocateFailure {
    /// Newton's method failed.
    #[error(transparent)]
    Newton(#[from] NewtonFailure<MapError>),
    /// Newton's method left the region where the point must lie.
    #[error("the point found lies {distance:.1e} away, on a step of length {step:.1e}")]
    Elsewhere {
        /// Distance from the expected place.
        distance: f64,
        /// Length of the step in which the point must lie.
        step: f64,
    },
}

/// The equations and the condition, with the last row left empty.
pub(crate) fn conditioned<O: ImpactOscillator>(
    equations: &LoopEquations<O>,
    condition: Condition,
    second_order: bool,
    point: &Unknowns,
    times: &mut EventTimes,
) -> Result<(Linearisation<Unknowns>, Round), MapError> {
    if condition == Condition::SymmetryBreaking && equations.has_impacts() {
        return equations.symmetry_breaking(point, times);
    }
    let halved = match condition {
        Condition::SymmetryBreaking => Some(equations.halved().ok_or(MapError::NotSymmetric)?),
        _ => None,
    };
    let equations = halved.as_ref().unwrap_or(equations);
    let maps = if second_order || condition.needs_second_order() {
        equations.maps::<2>(point, times)?
    } else {
        equations.maps::<1>(point, times)?
    };
    let (value, gradient) = condition.evaluate(equations, point, &maps, times)?;
    let mut system = maps.system();
    let row = point.size() - 2;
    system.residual[row] = value;
    (0..point.size()).for_each(|column| system.jacobian[[row, column]] = gradient[column]);
    Ok((system, maps))
}

/// The reason why an iteration ends.
#[derive(Clone, Copy)]
enum IterationEnd {
    Undefined(MapError),
    Lost,
}
use IterationEnd::{Lost, Undefined};

/// The MPS near `start` at which both conditions hold.
///
/// # Errors
/// Newton's method failed; the cause gives the iteration.
pub fn locate<O: ImpactOscillator>(
    equations: &LoopEquations<O>,
    conditions: [Condition; 2],
    start: Unknowns,
    times: &mut EventTimes,
) -> Result<Unknowns, LocateFailure> {
    locate_within(FARTHEST * (1.0 + start.norm()), equations, conditions, start, times)
}

/// Like [`locate`], but given up as soon as an iterate is farther from the start than `reach`.
///
/// # Errors
/// As [`locate`].
pub fn locate_within<O: ImpactOscillator>(
    reach: f64,
    equations: &LoopEquations<O>,
    conditions: [Condition; 2],
    start: Unknowns,
    times: &mut EventTimes,
) -> Result<Unknowns, LocateFailure> {
    // The condition that requires symmetry comes first, as it also changes the equations.
    let mut conditions = conditions;
    if conditions[1] == Condition::SymmetryBreaking {
        conditions.swap(0, 1);
    }
    let second_order = conditions[1].needs_second_order();
    let mut farthest = 0.0;
    let solution = newton::solve(start.clone(), EVALUATIONS, |point| {
        farthest = (point - &start).norm();
        // NaN counts as far away as well.
        if farthest.is_nan() || farthest > reach {
            return Err(Lost);
        }
        let (system, maps) =
            conditioned(equations, conditions[0], second_order, point, times).map_err(Undefined)?;
        let (value, gradient) = conditions[1].evaluate(equations, point, &maps, times).map_err(Undefined)?;
        Ok(system.bordered(value, &gradient))
    });
    let solution = solution.map_err(|failure| match failure {
        NewtonFailure::Undefined { cause: Lost, .. } => {
            LocateFailure::Elsewhere { distance: farthest, step: reach }
        }
        NewtonFailure::Undefined { iteration, cause: Undefined(cause) } => {
            NewtonFailure::Undefined { iteration, cause }.into()
        }
        NewtonFailure::Singular { iteration, residual } => {
            NewtonFailure::Singular { iteration, residual }.into()
        }
        NewtonFailure::NoConvergence { iterations, residual } => {
            NewtonFailure::NoConvergence { iterations, residual }.into()
        }
    })?;
    Ok(solution.point)
}

/// Whether two located points are the same codimension-two point.
pub fn same_point(a: &Unknowns, b: &Unknowns) -> bool {
    let gap = |index: usize| (a[index] - b[index]).abs();
    gap(unknown::PRIMARY).max(gap(unknown::SECONDARY)) < SAME_POINT
}

/// Locates the point at which a curve of interior grazing reaches y = 0.
///
/// For one impact. With y = 0 all loops coincide with the grazing orbit, so the interior maximum lies on the wall
/// for every η and the equations of [`locate`] are singular. The curve branches off this trivial
/// family where the maximum does not change to first order along the branch of MPSs: det ∂(V₁, V₂,
/// h)/∂(y, z, μ) = 0, which is solved for η by the secant method.
///
/// # Errors
/// Newton's method failed on the grazing orbit, or the secant method did not converge.
pub fn locate_grazing_end<O: ImpactOscillator>(
    equations: &LoopEquations<O>,
    near: Unknowns,
    times: &mut EventTimes,
) -> Result<Unknowns, LocateFailure> {
    let mut point = near.clone();
    point[unknown::VELOCITY] = 0.0;
    let mut degeneracy = |point: &mut Unknowns, secondary: f64| {
        point[unknown::SECONDARY] = secondary;
        grazing_orbit(equations, point, times)?;
        let undefined = |cause| NewtonFailure::Undefined { iteration: 0, cause };
        let maps = equations.maps::<1>(point, times).map_err(undefined)?;
        let (_, slopes) = equations.maximum_near(point, &mut times.grazing_time).map_err(undefined)?;
        let derivative = maps.system().jacobian;
        let entry = |row: usize, column: usize| match row {
            2 => slopes[column],
            _ => derivative[[row, column]],
        };
        let matrix = Matrix3::from_fn(entry);
        Ok::<f64, NewtonFailure<MapError>>(matrix.determinant())
    };
    // Two starting values closer together than the steps of a curve; the secant method needs no
    // more of them.
    let (mut a, mut b) = (near[unknown::SECONDARY], near[unknown::SECONDARY] + 1e-4);
    let mut value_a = degeneracy(&mut point, a)?;
    for _ in 0..EVALUATIONS {
        let value_b = degeneracy(&mut point, b)?;
        let step = value_b * (b - a) / (value_b - value_a);
        if step.abs() <= tolerances::STEP || value_b == value_a {
            degeneracy(&mut point, b - if step.is_finite() { step } else { 0.0 })?;
            return Ok(point);
        }
        (a, value_a) = (b, value_b);
        b -= step;
    }
    Err(NewtonFailure::NoConvergence { iterations: EVALUATIONS, residual: value_a }.into())
}

/// Moves (z, μ) of a point with y = 0 onto the grazing periodic orbit at the point's η.
fn grazing_orbit<O: ImpactOscillator>(
    equations: &LoopEquations<O>,
    point: &mut Unknowns,
    times: &mut EventTimes,
) -> Result<(), NewtonFailure<MapError>> {
    let fixed = point.clone();
    let solution =
        newton::solve(Vector2::new(point[unknown::PHASE], point[unknown::PRIMARY]), EVALUATIONS, |zm| {
            let mut trial = fixed.clone();
            trial[unknown::PHASE] = zm[0];
            trial[unknown::PRIMARY] = zm[1];
            let Linearisation { residual, jacobian } = equations.maps::<1>(&trial, times)?.system();
            let jacobian = Matrix2::from_fn(|row, column| jacobian[[row, column + 1]]);
            Ok(Linearisation { residual: Vector2::new(residual[0], residual[1]), jacobian })
        })?;
    point[unknown::PHASE] = solution.point[0];
    point[unknown::PRIMARY] = solution.point[1];
    Ok(())
}
