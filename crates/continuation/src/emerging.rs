//! The curves that bound the solutions of more loops at a one-loop resonance.

use core::f64::consts::TAU;

use grazing_model::ImpactOscillator;
use grazing_theorems::iterated::{Boundary, IteratedResonance, VelocityBound};

use crate::curve::{Curve, Route, SolutionCurve};
use crate::locate::{Condition, locate};
use crate::mps::{EventTimes, Formulation, LoopEquations, Unknowns, parameters, unknown};
use crate::resonance::{LocatedResonance, ResonanceError};

/// Impact velocities at which a GZ curve is looked for beside a resonance, one after the other: the
/// first where leading terms are good enough for Newton's method, the last where rounding of
/// positions, of the order of their squares, is still far below (empirical: the first does nearly
/// always).
const VELOCITIES: [f64; 4] = [1e-2, 3e-3, 1e-3, 3e-4];
/// A solution found there is the one that was looked for if its impact velocity and its distance
/// from the resonance in η are off by no more than this share.
const OFF: f64 = 0.3;

impl<O: ImpactOscillator> LocatedResonance<O> {
    /// What the MPSs of `loops` loops do at this resonance, to leading order; none unless it is one
    /// of p = 1.
    pub fn iterated(&self, loops: u32) -> Option<IteratedResonance> {
        (self.loops() == 1).then(|| IteratedResonance::new(self.resonant_point(), loops))
    }

    /// The curves between which MPSs of `loops` ≥ 2 loops are stable and admissible beside this
    /// resonance, and why others are missing; none unless it is one of p = 1. A GZ curve of which
    /// the window has next to nothing is not followed.
    pub fn unfold_iterated(&self, loops: u32, route: &Route<'_>) -> (Vec<Curve>, Vec<ResonanceError>) {
        let (mut curves, mut missing) = (Vec::new(), Vec::new());
        let Some(iterated) = self.iterated(loops) else { return (curves, missing) };
        for solutions in iterated.emerging() {
            for bound in [Some(solutions.slowest), solutions.fastest].into_iter().flatten() {
                match self.bounding_curve(&iterated, bound, route) {
                    Ok(curve) => curves.extend(curve),
                    Err(reason) => missing.push(reason),
                }
            }
        }
        (curves, missing)
    }

    fn bounding_curve(
        &self,
        iterated: &IteratedResonance,
        bound: VelocityBound,
        route: &Route<'_>,
    ) -> Result<Option<Curve>, ResonanceError> {
        let oscillator = self.orbit().oscillator().clone();
        let equations = LoopEquations::new(oscillator, iterated.loops(), Formulation::FixedPhase);
        let condition = match bound.boundary {
            Boundary::SaddleNode => Condition::SADDLE_NODE,
            Boundary::PeriodDoubling => Condition::PERIOD_DOUBLING,
            Boundary::Visit(visit) => return self.visit_curve(equations, iterated, bound, visit, route),
        };
        let slope = bound.velocity_slope;
        let phase_slope = self.orbit().phase_slope() + iterated.point().branch_expansion().k_1 * slope;
        let along = Unknowns::new(slope, phase_slope, self.orbit().primary_slope(), 1.0).normalize();
        SolutionCurve { equations, condition }
            .follow(self.unknowns(), along * slope.signum(), EventTimes::default(), route)
            .map(Some)
            .map_err(|stall| ResonanceError::not_started(condition, stall.to_string()))
    }

    /// The GZ curve along which a visit touches the wall. At the resonance its equations are
    /// singular, since all visits touch the wall along the whole grazing curve: it is located a
    /// little beside, and followed to both sides.
    fn visit_curve(
        &self,
        equations: LoopEquations<O>,
        iterated: &IteratedResonance,
        bound: VelocityBound,
        visit: u32,
        route: &Route<'_>,
    ) -> Result<Option<Curve>, ResonanceError> {
        let [_, resonance] = self.orbit().oscillator().parameters();
        let branch = iterated.point().branch_expansion();
        let condition = Condition::InteriorGrazing;
        let (mut is_outside, mut reason) =
            (false, "no solution with a visit that touches the wall was found beside it".to_owned());
        // Held at its η or, where motion hardly loses energy, at its velocity: there η differs by
        // orders of magnitude less, and the height hardly changes with the velocity.
        for (velocity, at_velocity) in VELOCITIES.into_iter().flat_map(|it| [(it, false), (it, true)]) {
            let eta = velocity / bound.velocity_slope;
            let Ok(place) = self.orbit().place().moved(self.orbit().oscillator(), resonance + eta) else {
                continue;
            };
            let [grazing, secondary] = place.parameters;
            let phase = place.phase + branch.k_1 * velocity;
            let start = Unknowns::new(velocity, phase, grazing + branch.parameter(velocity, eta), secondary);
            let until_visit = place.phase + TAU * f64::from(visit) - equations.departure(&start).phase;
            let frequency = equations.oscillator_at(&start).forcing_frequency().value;
            let mut times = EventTimes::default().touching(until_visit / frequency);
            let held = match at_velocity {
                true => Condition::ImpactVelocity(velocity),
                false => Condition::Secondary(secondary),
            };
            match locate(&equations, [condition, held], start, &mut times) {
                Ok(found) if !route.window.contains(parameters(&found)) => {
                    is_outside = true;
                }
                Ok(found)
                    if ((found[unknown::SECONDARY] - resonance) / eta - 1.0).abs() <= OFF
                        && (found[unknown::VELOCITY] / velocity - 1.0).abs() <= OFF =>
                {
                    let curve = SolutionCurve { equations, condition };
                    return curve
                        .follow_both_ways(found, Unknowns::x(), &times, route)
                        .map(Some)
                        .map_err(|stall| ResonanceError::not_started(condition, stall.to_string()));
                }
                Ok(_) => {}
                Err(failure) => reason = failure.to_string(),
            }
        }
        if is_outside { Ok(None) } else { Err(ResonanceError::not_started(condition, reason)) }
    }
}
