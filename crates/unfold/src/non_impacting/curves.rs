//! Curves of folds and period doublings of periodic motion without impacts.

use core::f64::consts::TAU;

use grazing_continuation::arclength::{StepControl, Tangent, Walk};
use grazing_continuation::bifurcation::Bifurcation;
use grazing_continuation::curve::{Curve, CurveEnd, CurvePoint};
use grazing_continuation::mps::{EventTimes, MaximalPeriodicSolution, Unknowns};
use grazing_model::ImpactOscillator;

use super::branch::Crossing;
use super::orbits::{OrbitPoint, PRIMARY, PeriodicOrbit, PeriodicOrbitCurve, PeriodicOrbits, SECONDARY};
use crate::curves::DiagramCurve;
use crate::edges::leaves;

/// A curve of this many points has lost its way.
const STEP_LIMIT: usize = 20_000;

impl<O: ImpactOscillator> PeriodicOrbits<'_, O> {
    /// The curve of folds or period doublings through one that was located, to both sides.
    pub(crate) fn curve(&self, through: &Crossing) -> Option<DiagramCurve> {
        let condition = through.condition;
        let kind = Bifurcation::of(condition)?;
        let equations = PeriodicOrbitCurve { orbits: self, condition };
        let control = StepControl::DRAWING;
        let walk = Walk { equations: &equations, control, step_limit: STEP_LIMIT, angle: None };
        let (points, ends) = walk.both_ways(through.near.orbit, OrbitPoint::w(), on_the_edge).ok()?;
        let point = |(orbit, _): &Tangent<4>| CurvePoint {
            solution: self.as_solution(&self.seen(orbit)),
            times: EventTimes::default(),
        };
        let [beginning, end] = ends.map(CurveEnd::from);
        let curve = Curve {
            condition,
            points: points.iter().map(point).collect(),
            events: Vec::new(),
            end,
            beginning: Some(beginning),
        };
        Some(DiagramCurve { kind, loops: 0, n: 0, curve })
    }

    /// An orbit without impacts in the place of an MPS: no impact velocity, and the phase of its highest point.
    fn as_solution(&self, orbit: &PeriodicOrbit) -> MaximalPeriodicSolution {
        let [primary, secondary] = self.parameters(&orbit.orbit);
        let phase = orbit.phase_of_highest - TAU * libm::floor(orbit.phase_of_highest / TAU);
        MaximalPeriodicSolution {
            loops: 0,
            unknowns: Unknowns::new(0.0, phase, primary, secondary),
            multipliers: orbit.multipliers,
            highest_interior_maximum: Some(orbit.highest),
        }
    }
}

/// The point on the edge of the ranges, along the chord: regions end there, and nothing else depends on it.
fn on_the_edge(before: &OrbitPoint, (after, tangent): &Tangent<4>) -> Option<Tangent<4>> {
    let parameters = [PRIMARY, SECONDARY];
    let (way, ..) = leaves(parameters, [before, after])?;
    let mut edge = before + (after - before) * way;
    for k in parameters {
        edge[k] = edge[k].clamp(0.0, 1.0);
    }
    Some((edge, *tangent))
}
