//! Section 2.6: g_SN and g_PD as curves, with ψ ≠ 0.

use super::coefficients::resonant;
use crate::*;

checks! {
    /// Across the SN curve two MPSs disappear, across the PD curve a multiplier passes −1.
    crossing: drawn(75, 30) |sampler; cases: Votes| {
        let place = resonant(sampler, &[1, 2, 3])?;
        for curve in &place.curves() {
            // Small compared with the velocities of order one at which curves end.
            const VELOCITY: f64 = 2e-3;
            let centre = place.on_curve(curve, VELOCITY / curve.leading.impact_velocity_slope);
            let centre = centre.ok_or("no point of the curve was found")?.unknowns;
            let equations = place.resonance.equations();
            let neighbour = |factor: f64| at_velocity(equations, &centre, factor * centre[unknown::VELOCITY]);
            let (below, above) = neighbour(0.9).zip(neighbour(1.1)).ok_or("no MPS beside a curve")?;
            cases.see(if curve.condition == Condition::SADDLE_NODE {
                // μ(y) has an extremum: both neighbours lie on the same side.
                let [a, b] = [below, above].map(|point| point[unknown::PRIMARY] - centre[unknown::PRIMARY]);
                a * b > 0.0
            } else {
                let [a, b] = [below, above].map(|point| {
                    let multipliers = equations.solution(&point).multipliers;
                    1.0 + multipliers.trace + multipliers.determinant
                });
                a * b < 0.0
            });
        }
    } => cases.outcome("SN and PD curves of random oscillators, crossed along the branch at fixed η");
}
