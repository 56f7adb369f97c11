//! Section 2.6: g_SN and g_PD as curves, with ψ ≠ 0.

use grazing_continuation::locate::{Condition, locate};
use grazing_continuation::mps::{EventTimes, Unknowns, unknown};
use grazing_continuation::resonance::ResonantGrazingPoint;
use grazing_model::ImpactOscillator;
use grazing_theorems::from_map::GrazingOrbit;

use super::coefficients::{Resonant, resonant};
use crate::convergence::order;
use crate::outcome::CheckResult;
use crate::sampling::Sampler;
use crate::specimen::Specimen;
use crate::tally::{Smallest, Votes};

/// The point of the SN or PD curve with this impact velocity, if it exists.
pub(super) fn on_curve(
    resonance: &ResonantGrazingPoint<Specimen>,
    condition: Condition,
    velocity: f64,
) -> Option<Unknowns> {
    let direction = resonance.direction(condition);
    // Farther off the direction is no good start.
    if velocity * direction[unknown::SECONDARY].abs() > 0.01 * direction[unknown::VELOCITY] {
        return None;
    }
    let start = resonance.unknowns() + direction * (velocity / direction[unknown::VELOCITY]);
    let conditions = [condition, Condition::ImpactVelocity(velocity)];
    locate(resonance.equations(), conditions, start, &mut EventTimes::default()).ok()
}

/// μ and η of a point.
pub(super) fn unfolded(resonance: &ResonantGrazingPoint<Specimen>, point: &Unknowns) -> Option<[f64; 2]> {
    let orbit =
        GrazingOrbit::find(&resonance.equations().oscillator_at(point), resonance.orbit().phase()).ok()?;
    let [_, origin] = resonance.orbit().oscillator().parameters();
    Some([point[unknown::PRIMARY] - orbit.primary(), point[unknown::SECONDARY] - origin])
}

/// The order of μ − cη² along the curve as the impact velocity, to which η is proportional, tends to zero.
fn remainder(seed: u64, loops: &[u32], condition: Condition) -> CheckResult {
    let mut sampler = Sampler::new(seed);
    let mut least = Smallest::default();
    for _ in 0..20 {
        let Resonant { point: resonance } = resonant(&mut sampler, loops)?;
        let theorem = resonance.theorem();
        let curve = if condition == Condition::SADDLE_NODE {
            theorem.saddle_node()
        } else {
            theorem.period_doubling()
        };
        least.see_resolved(order(|velocity| {
            let [mu, eta] = unfolded(&resonance, &on_curve(&resonance, condition, velocity)?)?;
            // No curve on the other side of η = 0: a value that makes the order fail.
            let Some(stated) = curve.parameter(eta) else {
                return Some((1.0, 1e-16));
            };
            // 𝒜 and ω are numbers of order one; that of ω counts 2cη-fold. Newton's method leaves a few roundings.
            Some((mu - stated, 2e-15 * (1.0 + (curve.coefficient * eta).abs())))
        }));
    }
    // Slack for the next order at the smallest resolved velocities.
    Ok(least.order(3.0, 0.3, "resonances of random oscillators with ψ ≠ 0, points of the continued curve"))
}

/// eq:sn1.
pub(super) fn saddle_node_one_loop() -> CheckResult {
    remainder(71, &[1], Condition::SADDLE_NODE)
}

/// eq:pd1.
pub(super) fn period_doubling_one_loop() -> CheckResult {
    remainder(72, &[1], Condition::PERIOD_DOUBLING)
}

/// eq:snp.
pub(super) fn saddle_node_many_loops() -> CheckResult {
    remainder(73, &[2, 3, 4], Condition::SADDLE_NODE)
}

/// eq:pdp.
pub(super) fn period_doubling_many_loops() -> CheckResult {
    remainder(74, &[2, 3, 4], Condition::PERIOD_DOUBLING)
}

/// Across the SN curve two MPSs on one side of μ become none, and across the PD curve a multiplier passes through −1.
pub(super) fn crossing() -> CheckResult {
    let mut sampler = Sampler::new(75);
    let mut cases = Votes::default();
    for _ in 0..30 {
        let Resonant { point: resonance } = resonant(&mut sampler, &[1, 2, 3])?;
        for condition in [Condition::SADDLE_NODE, Condition::PERIOD_DOUBLING] {
            // Small against the velocities of order one at which curves end.
            const VELOCITY: f64 = 2e-3;
            let centre =
                on_curve(&resonance, condition, VELOCITY).ok_or("no point of the curve was found")?;
            let neighbour = |factor: f64| {
                let velocity = VELOCITY * factor;
                let mut start = centre;
                start[unknown::VELOCITY] = velocity;
                let conditions =
                    [Condition::ImpactVelocity(velocity), Condition::Secondary(centre[unknown::SECONDARY])];
                locate(resonance.equations(), conditions, start, &mut EventTimes::default())
            };
            let [below, above] = [neighbour(0.9)?, neighbour(1.1)?];
            cases.see(if condition == Condition::SADDLE_NODE {
                // μ(y) has an extremum: both neighbours lie on the same side.
                let [a, b] = [below, above].map(|point| point[unknown::PRIMARY] - centre[unknown::PRIMARY]);
                a * b > 0.0
            } else {
                let [a, b] = [below, above].map(|point| {
                    let multipliers = resonance.equations().solution(&point).0.multipliers;
                    1.0 + multipliers.trace + multipliers.determinant
                });
                a * b < 0.0
            });
        }
    }
    Ok(cases.outcome("SN and PD curves of random oscillators, crossed along the branch at fixed η"))
}
