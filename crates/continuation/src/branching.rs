//! The curves that begin at codimension-two points.

use grazing_model::ImpactOscillator;

use crate::curve::{Curve, Event, MpsCurve, Route};
use crate::locate::{Condition, same_point};
use crate::mps::{LoopEquations, MaximalPeriodicSolution, Unknowns};
use crate::resonance::ResonanceError;

impl<O: ImpactOscillator> LoopEquations<O> {
    /// Follows the other curve of a codimension-two point at which one curve ends: GZ to the side where the MPS is stable, SN and PD
    /// to the side where it is admissible.
    ///
    /// # Errors
    /// There is no such side, or the curve cannot be started.
    pub fn branch_off(&self, point: &Event, route: &Route) -> Result<Curve, ResonanceError> {
        let condition = point.condition;
        let bounds = |solution: &MaximalPeriodicSolution| match condition {
            Condition::InteriorGrazing => {
                solution.stable() && solution.ceiling() <= MaximalPeriodicSolution::TOUCH
            }
            _ => solution.ceiling() <= MaximalPeriodicSolution::TOUCH,
        };
        // A curve to the inadmissible side of a point at which two maxima touch the wall ends there at once.
        let onwards = |solution: &MaximalPeriodicSolution| {
            bounds(solution) && !same_point(&solution.unknowns, &point.solution.unknowns)
        };
        let mut reason = "it bounds no region of stable solutions to either side".to_owned();
        for sign in [1.0, -1.0] {
            let curve = MpsCurve { equations: self.clone(), condition };
            let direction = Unknowns::new(sign, 0.0, 0.0, 0.0);
            match curve.follow(point.solution.unknowns, direction, point.times.clone(), route) {
                Ok(curve) if curve.points.get(1).is_some_and(|next| onwards(&next.solution)) => {
                    return Ok(curve);
                }
                Ok(_) => {}
                Err(stall) => reason = stall.to_string(),
            }
        }
        Err(ResonanceError::not_started(condition, reason))
    }
}
