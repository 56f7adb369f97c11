//! Section 2.6: s_p^±, c_SN and c_PD with ψ ≠ 0, against multipliers and continued curves.

use crate::*;

/// A resonance with one of these numbers of loops at which |s^±| > 1/20 and the impact velocity along
/// either curve exceeds η/5, so that the curves are resolved at small velocities.
pub(crate) fn resonant(sampler: &mut Sampler, loops: &[u32]) -> Result<ResonantSpecimen, CheckError> {
    loop {
        let loops = sampler.one_of(loops);
        let zeta = sampler.between(0.01, 0.15);
        let law = Law::random(sampler, zeta);
        // For p = 1 and n = 1 the frequency is about twice the natural one.
        let Ok(place) = ResonantSpecimen::find(law, loops, sampler.one_of(&[1, 2])) else { continue };
        let clear = |curve: &TheoremCurve| {
            curve.stability.abs() > 0.05 && curve.leading.impact_velocity_slope.abs() > 0.2
        };
        if place.curves().iter().all(clear) {
            return Ok(place);
        }
    }
}

/// s^± as limits of T − D − 1 and T + D + 1 on the branch at η = 0, T and D of numerical orbits.
fn stability(seed: u64, loops: &[u32], over: &str) -> CheckResult {
    let least = drawn(seed, 30, |sampler, least: &mut Smallest| {
        let place = resonant(sampler, loops)?;
        let stated = place.point().stability_coefficients();
        for (stated, sign) in [(stated.plus, 1.0), (stated.minus, -1.0)] {
            least.see_resolved(order(|velocity| {
                let multipliers = place.solution(&place.on_branch(velocity, 0.0)?).multipliers;
                let limit = multipliers.trace - sign * (multipliers.determinant + 1.0);
                // Numerator and denominator of T vanish with y: rounding of order ten over y.
                Some((limit - stated, 1e-14 / velocity))
            }));
        }
        Ok(())
    })?;
    // Slack for the term of second order at the smallest resolved velocities.
    Ok(least.order(1.0, 0.3, &format!("{over}; T ∓ (D + 1) on the branch as y → 0")))
}

/// Compares c_SN and c_PD with the limits of μ/η² on continued curves.
///
/// The accuracy of a fit is that of interpolation in y; the tolerance is empirical, several tens of times
/// the largest deviation.
fn fitted(seed: u64, loops: &[u32], tolerance: f64, over: &str) -> CheckResult {
    let largest = drawn(seed, 20, |sampler, largest: &mut Deviations| {
        let place = resonant(sampler, loops)?;
        let (sn, pd) = (place.point().saddle_node_coefficient(), place.point().period_doubling_coefficient());
        for (condition, stated) in [(Condition::SADDLE_NODE, sn), (Condition::PERIOD_DOUBLING, pd)] {
            let measured = quadratic_coefficient(&place.resonance, condition)?;
            largest.compare(measured.value, stated, stated.abs().max(sn.abs()));
        }
        Ok(())
    })?;
    Ok(largest.outcome(tolerance, &format!("c_SN and c_PD at {over}, against fits to continued curves")))
}

checks! {
    /// a₁₂′ and κ_p′: total derivatives along the grazing curve, by differences of grazing orbits.
    // Rounding 10⁻¹⁴ over the step 10⁻⁴.
    unfolding_derivatives: drawn(65, 30) |sampler; largest: Deviations| {
        let place = resonant(sampler, &[1, 2, 3, 4])?;
        let measured = place.along_grazing(1e-4, |loops, LinearisedMap { a, .. }| {
            let cosine = libm::cos(PI / f64::from(loops));
            if loops == 1 { a.m12 } else { a.trace() - 2.0 * a.determinant().sqrt() * cosine }
        })?;
        let stated = place.point().unfolding.derivative;
        largest.compare(measured, stated, stated.abs().max(1.0));
    } => largest.outcome(1e-10, "resonances p = 1 to 4, by differences along the grazing curve");
    /// eq:c1.
    stability_one_loop: stability(61, &[1], "resonances p = 1 with ψ ≠ 0");
    /// eq:cp.
    stability_many_loops: stability(62, &[2, 3, 4], "resonances p = 2, 3, 4 with ψ ≠ 0");
    /// eq:coeffs1.
    curves_one_loop: fitted(63, &[1], 1e-8, "resonances p = 1 with ψ ≠ 0");
    /// eq:coeffsp.
    curves_many_loops: fitted(64, &[2, 3, 4], 1e-7, "resonances p = 2, 3, 4 with ψ ≠ 0");
}
