//! Section 2.6: g_SN and g_PD as curves, with ψ ≠ 0.

use grazing_continuation::locate::{Condition, locate};
use grazing_continuation::mps::{EventTimes, unknown};

use super::coefficients::resonant;
use crate::{CheckResult, Sampler, Smallest, Votes, order};

/// The order of μ − cη² along the SN (`curve` 0) or PD (1) curve as the impact velocity, to which η is proportional, tends to zero.
fn remainder(seed: u64, loops: &[u32], curve: usize) -> CheckResult {
    let mut sampler = Sampler::new(seed);
    let mut least = Smallest::default();
    for _ in 0..20 {
        let place = resonant(&mut sampler, loops)?;
        let curve = &place.curves()[curve];
        least.see_resolved(order(|velocity| {
            let eta = velocity / curve.leading.impact_velocity_slope;
            // Farther off, the leading terms are no good start.
            if eta.abs() > 0.01 {
                return None;
            }
            let [_, mu] = place.on_curve(curve, eta)?.relative();
            // No curve on the other side of η = 0: a value that makes the order fail.
            let Some(stated) = curve.leading.parameter(eta) else {
                return Some((1.0, 1e-16));
            };
            // 𝒜 and ω are numbers of order one; that of ω counts 2cη-fold. Newton's method leaves a few roundings.
            Some((mu - stated, 2e-15 * (1.0 + (curve.leading.coefficient * eta).abs())))
        }));
    }
    // Slack for the next order at the smallest resolved velocities.
    Ok(least.order(3.0, 0.3, "resonances of random oscillators with ψ ≠ 0, points of the continued curve"))
}

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

checks! {
    /// eq:sn1.
    saddle_node_one_loop: remainder(71, &[1], 0);
    /// eq:pd1.
    period_doubling_one_loop: remainder(72, &[1], 1);
    /// eq:snp.
    saddle_node_many_loops: remainder(73, &[2, 3, 4], 0);
    /// eq:pdp.
    period_doubling_many_loops: remainder(74, &[2, 3, 4], 1);
}
