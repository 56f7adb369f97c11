//! Curves of folds and period doublings of periodic motion without impacts.

use core::f64::consts::TAU;

use grazing_continuation::arclength::{Continuation, Stall, StepControl};
use grazing_continuation::bifurcation::Bifurcation;
use grazing_continuation::curve::{Curve, CurveEnd, CurvePoint};
use grazing_continuation::locate::Condition;
use grazing_continuation::mps::{EventTimes, MaximalPeriodicSolution, Unknowns};
use grazing_model::ImpactOscillator;

use super::branch::Crossing;
use super::orbits::{OrbitPoint, PRIMARY, PeriodicOrbit, PeriodicOrbitCurve, PeriodicOrbits, SECONDARY};
use crate::curves::DiagramCurve;

/// A curve of this many points has lost its way.
const STEP_LIMIT: usize = 20_000;

impl<O: ImpactOscillator> PeriodicOrbits<'_, O> {
    /// The curve of folds or period doublings through one that was located, to both sides.
    pub(crate) fn curve(&self, through: &Crossing) -> Option<DiagramCurve> {
        let condition = through.condition;
        let kind = Bifurcation::of(condition)?;
        let up = OrbitPoint::new(0.0, 0.0, 0.0, 1.0);
        let (mut orbits, beginning) = self.follow_curve(condition, &through.near.orbit, -up)?;
        orbits.reverse();
        let (after, end) = self.follow_curve(condition, &through.near.orbit, up)?;
        orbits.extend(after.into_iter().skip(1));
        let points = orbits
            .iter()
            .map(|orbit| CurvePoint { solution: self.as_solution(orbit), times: EventTimes::default() });
        let curve = Curve {
            condition,
            points: points.collect(),
            events: Vec::new(),
            end,
            beginning: Some(beginning),
            vivid_ended: None,
        };
        Some(DiagramCurve { kind, loops: 0, n: 0, curve })
    }

    fn follow_curve(
        &self,
        condition: Condition,
        start: &OrbitPoint,
        direction: OrbitPoint,
    ) -> Option<(Vec<PeriodicOrbit>, CurveEnd)> {
        let curve = PeriodicOrbitCurve { orbits: self, condition };
        let mut walker = Continuation::new(&curve, StepControl::DRAWING, *start, direction, ()).ok()?;
        let mut found = vec![self.seen(start)];
        let inside =
            |orbit: &OrbitPoint| [PRIMARY, SECONDARY].iter().all(|k| (0.0..=1.0).contains(&orbit[*k]));
        while found.len() < STEP_LIMIT {
            let before = walker.here().point;
            let after = match walker.advance() {
                Ok(station) => station.point,
                Err(Stall { step, failure }) => {
                    return Some((found, CurveEnd::Stalled(Stall { step, failure })));
                }
            };
            found.push(self.seen(&after));
            if !inside(&after) {
                // To the edge along the chord: regions end there, and nothing else depends on it.
                let way = [PRIMARY, SECONDARY].map(|k| {
                    let edge = after[k].clamp(0.0, 1.0);
                    if edge == after[k] { 1.0 } else { (edge - before[k]) / (after[k] - before[k]) }
                });
                let mut edge = before + (after - before) * way[0].min(way[1]);
                for k in [PRIMARY, SECONDARY] {
                    edge[k] = edge[k].clamp(0.0, 1.0);
                }
                found.pop();
                found.push(self.seen(&edge));
                return Some((found, CurveEnd::LeftWindow));
            }
            let [past, now] = [before - start, after - start];
            let first = found[1].orbit - start;
            let passes = past.norm().max(now.norm()) < 2.0 * (after - before).norm()
                && past.dot(&first) < 0.0
                && now.dot(&first) >= 0.0;
            if found.len() > 10 && passes {
                found.pop();
                found.push(self.seen(start));
                return Some((found, CurveEnd::Closed));
            }
        }
        Some((found, CurveEnd::StepLimit))
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
