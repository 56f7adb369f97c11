//! Cusps of saddle-node curves: where a curve that is smooth in (y, z, μ, η) turns back in the plane of the parameters.
//!
//! There three MPSs come together, and the normal form's coefficient of
//! [`criticality::saddle_node`](crate::criticality::saddle_node) vanishes. The tangent lies in the plane of (y, z): its part in
//! (μ, η) is zero, and has opposite directions before and after.

use grazing_model::ImpactOscillator;
use grazing_model::maps::MapError;
use nalgebra::{Vector2, Vector4};

use crate::curve::{Curve, Event};
use crate::locate::{Condition, conditioned};
use crate::mps::{Formulation, LoopEquations, Memory, Unknowns, unknown};
use crate::newton;

/// Newton's method starts within a step of the curve, and needs a few evaluations.
const LIMIT: usize = 25;

/// Evaluations of the tangent; the Illinois method needs about ten.
const EVALUATIONS: usize = 40;

/// The tangent, of length one, has no part in (μ, η) below this: rounding over the curvature of the curve.
const ZERO: f64 = 1e-12;

/// The cusps of a saddle-node curve, in its order. Two within one step are not seen.
pub fn cusps<O: ImpactOscillator>(equations: &LoopEquations<O>, curve: &Curve) -> Vec<Event> {
    let equations = equations.with_formulation(Formulation::FixedPhase);
    let points: Vec<Unknowns> = curve.points.iter().map(|point| point.solution.unknowns).collect();
    let forwards = |k: usize| in_plane(&(points[k + 1] - points[k]));
    let turns_back = |k: &usize| forwards(*k).dot(&forwards(k + 1)) < 0.0;
    let cusp = |k: usize| {
        let unknowns = between(&equations, [points[k], points[k + 2]], &forwards(k).normalize())?;
        let (solution, _) = equations.solution(&unknowns);
        Some(Event { condition: curve.condition, solution, index: k + 1, memory: Memory::default() })
    };
    (0..points.len().saturating_sub(2)).filter(turns_back).filter_map(cusp).collect()
}

/// The part of a displacement in the plane of the parameters.
fn in_plane(displacement: &Unknowns) -> Vector2<f64> {
    Vector2::new(displacement[unknown::PRIMARY], displacement[unknown::SECONDARY])
}

/// The point between two points of the curve at which its tangent has no part along `forwards`.
fn between<O: ImpactOscillator>(
    equations: &LoopEquations<O>,
    [a, b]: [Unknowns; 2],
    forwards: &Vector2<f64>,
) -> Option<Unknowns> {
    let chord = (b - a).normalize();
    let at = |share: f64| -> Option<(Unknowns, f64)> {
        let start = a + (b - a) * share;
        let mut memory = Memory::default();
        let solution = newton::solve(start, LIMIT, |point| {
            let (mut system, _) = conditioned(equations, Condition::SADDLE_NODE, true, point, &mut memory)?;
            system.residual[3] = chord.dot(&(point - start));
            system.jacobian.set_row(3, &chord.transpose());
            Ok::<_, MapError>(system)
        });
        let solution = solution.ok()?;
        let tangent = solution.factors.solve(&Vector4::w())?.normalize();
        Some((solution.point, in_plane(&tangent).dot(forwards)))
    };
    let ([mut low, mut high], mut at_low) = ([0.0, 1.0], at(0.0)?.1);
    let (mut point, mut at_high) = at(1.0)?;
    if at_low * at_high >= 0.0 {
        return None;
    }
    for _ in 0..EVALUATIONS {
        let share = (low * at_high - high * at_low) / (at_high - at_low);
        let (found, value) = at(share)?;
        point = found;
        if value.abs() <= ZERO || share == high {
            break;
        }
        // The end that stays counts half, so that both ends come close.
        if value * at_high < 0.0 {
            (low, at_low) = (high, at_high);
        } else {
            at_low *= 0.5;
        }
        (high, at_high) = (share, value);
    }
    Some(point)
}
