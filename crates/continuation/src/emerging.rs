//! The curves that bound the solutions of more loops at a one-loop resonance.

use core::f64::consts::TAU;

use grazing_model::ImpactOscillator;
use grazing_theorems::generic_theorem::Side;
use grazing_theorems::iterated::{EndEvent, IteratedResonance, VelocityBound};
use grazing_theorems::resonant_theorem::BifurcationCurve;

use crate::curve::{Curve, Route, SolutionCurve};
use crate::locate::{Condition, locate};
use crate::mps::{EventTimes, Formulation, LoopEquations, Unknowns, parameters, unknown};
use crate::resonance::{LeavingCurve, LocatedResonance, ResonanceError};

/// Impact velocities at which a GZ curve is looked for beside a resonance, in this order: at the
/// first leading terms are good enough for Newton's method, at the last rounding of positions, of
/// the order of their squares, is still far below (empirical: the first almost always suffices).
const VELOCITIES: [f64; 4] = [1e-2, 3e-3, 1e-3, 3e-4];
/// Largest relative error in impact velocity and in distance from the resonance in η at which a
/// solution counts as the one that was sought.
const OFF: f64 = 0.3;

impl<O: ImpactOscillator> LocatedResonance<O> {
    /// The behaviour of the MPSs of `loops` loops at this resonance, to leading order; `None`
    /// unless it is a resonance of p = 1.
    pub fn iterated(&self, loops: u32) -> Option<IteratedResonance> {
        (self.loops() == 1).then(|| IteratedResonance::new(self.resonant_point(), loops))
    }

    /// The curves between which MPSs of `loops` ≥ 2 loops are stable and admissible beside this
    /// resonance, by theory; empty unless it is a resonance of p = 1.
    pub fn leaving_iterated(&self, loops: u32) -> Vec<LeavingCurve<'_, O>> {
        let Some(iterated) = self.iterated(loops) else { return Vec::new() };
        let oscillator = self.orbit().oscillator().clone();
        let equations = LoopEquations::new(oscillator, loops, Formulation::FixedPhase);
        let branch = iterated.point().branch_expansion();
        let curve = |bound| {
            let VelocityBound { boundary, velocity_slope: slope } = bound;
            let (condition, visit) = match boundary {
                EndEvent::SaddleNode => (Condition::SADDLE_NODE, None),
                EndEvent::PeriodDoubling => (Condition::PERIOD_DOUBLING, None),
                EndEvent::Visit(visit) => (Condition::InteriorGrazing, Some(visit)),
            };
            let leading = BifurcationCurve {
                coefficient: iterated.coefficient(&bound),
                eta_side: Side::of(slope),
                impact_velocity_slope: slope,
                impact_phase_slope: branch.k_1 * slope,
            };
            LeavingCurve { resonance: self, equations: equations.clone(), condition, leading, visit }
        };
        let bounds = iterated.emerging().into_iter().flat_map(|found| [Some(found.slowest), found.fastest]);
        bounds.flatten().map(curve).collect()
    }

    /// The curves that bound MPSs of `loops` loops, and the reasons why others are missing. A GZ
    /// curve of which the window contains next to nothing is not followed.
    pub fn unfold_iterated(&self, loops: u32, route: &Route<'_>) -> (Vec<Curve>, Vec<ResonanceError>) {
        let (mut curves, mut missing) = (Vec::new(), Vec::new());
        for leaving in self.leaving_iterated(loops) {
            let followed = match leaving.visit {
                Some(visit) => self.visit_curve(&leaving, visit, route),
                None => leaving.follow(route).map(Some),
            };
            match followed {
                Ok(curve) => curves.extend(curve),
                Err(reason) => missing.push(reason),
            }
        }
        (curves, missing)
    }

    /// The GZ curve along which a visit touches the wall. At the resonance its equations are
    /// singular, since all visits touch the wall along the whole grazing curve: it is located at a
    /// small distance, and followed in both directions.
    fn visit_curve(
        &self,
        leaving: &LeavingCurve<'_, O>,
        visit: u32,
        route: &Route<'_>,
    ) -> Result<Option<Curve>, ResonanceError> {
        let [_, resonance] = self.orbit().oscillator().parameters();
        let &LeavingCurve { ref equations, condition, leading, .. } = leaving;
        let (mut is_outside, mut reason) =
            (false, "no solution with a visit that touches the wall was found beside it".to_owned());
        // Held at its η or, where motion hardly loses energy, at its velocity: η then differs by
        // orders of magnitude less, and the height hardly changes with the velocity.
        for (velocity, at_velocity) in VELOCITIES.into_iter().flat_map(|it| [(it, false), (it, true)]) {
            let eta = velocity / leading.impact_velocity_slope;
            let Ok(place) = self.orbit().place().moved(self.orbit().oscillator(), resonance + eta) else {
                continue;
            };
            let [grazing, secondary] = place.parameters;
            let phase = place.phase + leading.impact_phase_slope * eta;
            let primary = grazing + leading.coefficient * eta * eta;
            let start = Unknowns::new(velocity, phase, primary, secondary);
            let mut times = equations.touching_at_visit(&start, place.phase, visit);
            let held = match at_velocity {
                true => Condition::ImpactVelocity(velocity),
                false => Condition::Secondary(secondary),
            };
            match locate(equations, [condition, held], start, &mut times) {
                Ok(found) if !route.window.contains(parameters(&found)) => {
                    is_outside = true;
                }
                Ok(found)
                    if ((found[unknown::SECONDARY] - resonance) / eta - 1.0).abs() <= OFF
                        && (found[unknown::VELOCITY] / velocity - 1.0).abs() <= OFF =>
                {
                    let curve = SolutionCurve { equations: equations.clone(), condition };
                    return curve
                        .follow_both_ways(found.clone(), found.along(unknown::VELOCITY), &times, route)
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

impl<O: ImpactOscillator> LoopEquations<O> {
    /// The event times of an MPS near the grazing orbit whose visit with the number `visit`, near
    /// the grazing phase, is to touch the wall.
    pub(crate) fn touching_at_visit(&self, near: &Unknowns, grazing_phase: f64, visit: u32) -> EventTimes {
        let until_visit = grazing_phase + TAU * f64::from(visit) - self.departure(near).phase;
        EventTimes::default().touching(until_visit / self.oscillator_at(near).forcing_frequency().value)
    }
}
