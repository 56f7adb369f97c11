//! Section 2.6: g_SN and g_PD as curves, with ψ ≠ 0.

use grazing_continuation::locate::{Condition, locate};
use grazing_continuation::mps::{EventTimes, unknown};

use super::coefficients::resonant;
use crate::{CheckResult, Sampler, Votes};

/// Across the SN curve two MPSs on one side of μ become none, and across the PD curve a multiplier passes through −1.
pub(crate) fn crossing() -> CheckResult {
    let mut sampler = Sampler::new(75);
    let mut cases = Votes::default();
    for _ in 0..30 {
        let place = resonant(&mut sampler, &[1, 2, 3])?;
        for curve in &place.curves() {
            // Small against the velocities of order one at which curves end.
            const VELOCITY: f64 = 2e-3;
            let centre = place.on_curve(curve, VELOCITY / curve.leading.impact_velocity_slope);
            let centre = centre.ok_or("no point of the curve was found")?.unknowns;
            let equations = place.resonance.equations();
            let neighbour = |factor: f64| {
                let velocity = factor * centre[unknown::VELOCITY];
                let mut start = centre;
                start[unknown::VELOCITY] = velocity;
                let conditions =
                    [Condition::ImpactVelocity(velocity), Condition::Secondary(centre[unknown::SECONDARY])];
                locate(equations, conditions, start, &mut EventTimes::default())
            };
            let [below, above] = [neighbour(0.9)?, neighbour(1.1)?];
            cases.see(if curve.condition == Condition::SADDLE_NODE {
                // μ(y) has an extremum: both neighbours lie on the same side.
                let [a, b] = [below, above].map(|point| point[unknown::PRIMARY] - centre[unknown::PRIMARY]);
                a * b > 0.0
            } else {
                let [a, b] = [below, above].map(|point| {
                    let multipliers = equations.solution(&point).0.multipliers;
                    1.0 + multipliers.trace + multipliers.determinant
                });
                a * b < 0.0
            });
        }
    }
    Ok(cases.outcome("SN and PD curves of random oscillators, crossed along the branch at fixed η"))
}
