//! Cusps of saddle-node curves: points at which a curve that is smooth in (y, z, μ, η) turns back
//! in the plane of the parameters.
//!
//! Three MPSs meet at a cusp, and the branch at fixed η that has its fold there is no longer a
//! parabola. The tangent lies in the plane of (y, z): its part in (μ, η) is zero, and has opposite
//! directions before and after.

use grazing_model::ImpactOscillator;
use nalgebra::Vector2;

use crate::arclength::zero_on;
use crate::curve::{Curve, Event, SolutionCurve};
use crate::locate::Condition;
use crate::mps::{EventTimes, LoopEquations, Unknowns, unknown};
use crate::newton::{Root, Space};
use crate::tolerances::{AT_CUSP, IN_THE_PLANE};

/// The cusps of a saddle-node curve, in the order of the curve. Two within one step are missed.
pub fn cusps<O: ImpactOscillator>(equations: &LoopEquations<O>, curve: &Curve) -> Vec<Event> {
    let points: Vec<Unknowns> = curve.points.iter().map(|point| point.solution.unknowns.clone()).collect();
    let forwards = |k: usize| in_plane(&(&points[k + 1] - &points[k]));
    let turns_back = |k: &usize| forwards(*k).dot(&forwards(k + 1)) < 0.0;
    let cusp = |k: usize| {
        let unknowns =
            turning_point(equations, [k, k + 2].map(|k| points[k].clone()), &forwards(k).normalize())?;
        let solution = equations.solution(&unknowns);
        Some(Event { condition: curve.condition, solution, index: k + 1, times: EventTimes::default() })
    };
    (0..points.len().saturating_sub(2)).filter(turns_back).filter_map(cusp).collect()
}

/// The part of a displacement in the plane of the parameters.
fn in_plane(displacement: &Unknowns) -> Vector2<f64> {
    Vector2::new(displacement[unknown::PRIMARY], displacement[unknown::SECONDARY])
}

/// The point between two points of the curve at which its tangent has no part along `forwards`.
fn turning_point<O: ImpactOscillator>(
    equations: &LoopEquations<O>,
    points: [Unknowns; 2],
    forwards: &Vector2<f64>,
) -> Option<Unknowns> {
    let folds = SolutionCurve { equations: equations.clone(), condition: Condition::SADDLE_NODE };
    let measure = |solution: Root<Unknowns>| {
        let tangent = in_plane(&solution.point.null_direction(&solution.factors)?);
        Some(((solution.point, tangent), tangent.dot(forwards)))
    };
    let (point, tangent) = zero_on(&folds, points, measure, IN_THE_PLANE)?;
    // Where the curve turns sharply within a step without a cusp, it continues across there.
    (tangent.norm() <= AT_CUSP).then_some(point)
}
