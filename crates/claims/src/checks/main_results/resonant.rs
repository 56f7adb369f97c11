//! Section 2.6: the assumption, ξ_p, the sketch of the unfolding, and the remark.

use super::coefficients::resonant;
use super::returns::iterated;
use crate::*;

/// fig:E: in the case c_SN < 0 < c_PD and β > 0, the non-impacting solution exists for μ < 0 and is
/// stable, and the curves lie on opposite sides of the grazing curve and of η = 0.
pub(crate) fn sketch() -> CheckResult {
    let mut sampler = Sampler::new(53);
    let mut cases = Votes::default();
    let mut places = 0;
    while places < 20 {
        let place = resonant(&mut sampler, &[1, 2, 3])?;
        let point = place.point();
        let (sn, pd) = (point.saddle_node_coefficient(), point.period_doubling_coefficient());
        let map = &point.grazing.map;
        if !(sn < 0.0 && pd > 0.0 && map.transversality() > 0.0) {
            continue;
        }
        places += 1;
        // The fixed point of P_global moves to x < 0 for μ < 0.
        let slope = map.fixed_point_position_slope()?;
        cases.see(slope > 0.0 && map.eigenvalues().spectral_radius() < 1.0);
        for (curve, side) in place.curves().iter().zip([-1.0, 1.0]) {
            // The velocity is small, so that the quadratic term dominates.
            let eta = 1e-4 / curve.leading.impact_velocity_slope;
            let found = place.on_curve(curve, eta).ok_or("no point of the curve was found")?;
            let [_, mu] = found.relative();
            let admissible = eta * curve.leading.eta_side.signum() > 0.0 && found.unknowns[0] > 0.0;
            cases.see(mu * side > 0.0 && admissible);
        }
    }
    Ok(cases.outcome("resonances of random oscillators in the case of the caption"))
}

checks! {
    /// ass:grazing2: grazing orbits along a range of η, with F < 0, varying continuously as stated.
    grazing_orbits: drawn(51, 40) |sampler; cases: Votes| {
        let mut orbit = Law::random_grazing(sampler)?;
        let [_, start] = orbit.oscillator().parameters();
        const STEP: f64 = 1e-3;
        for k in 1..=40 {
            let predicted = [orbit.primary() + STEP * orbit.primary_slope(), start + STEP * f64::from(k)];
            let near = orbit.phase() + STEP * orbit.phase_slope();
            let next = GrazingOrbit::find(&orbit.oscillator().with_parameters(predicted), near)?;
            let from = State::at_rest(0.0, next.phase());
            let motion = next.oscillator().motion(from);
            let top = motion.highest_maximum(1.5 * next.oscillator().forcing_period());
            // The contact one period later is the highest maximum, at the wall to rounding.
            let touches = top.is_some_and(|top| top.position.abs() < 1e-12);
            // The prediction error is h²/2 times second derivatives, which are below 10⁴ for ζ ≥ 0.01.
            let smooth =
                (next.phase() - near).abs() + (next.primary() - predicted[0]).abs() < 5e3 * STEP * STEP;
            cases.see(touches && smooth && next.oscillator().acceleration(from) < 0.0);
            orbit = next;
        }
    } => cases.outcome("values of η along the grazing curves of random oscillators");
    /// eq:xi: compared with second differences of iterated event location.
    // Rounding 10⁻¹⁵ over h², and h⁶ times eighth derivatives: empirical, thirty times the largest
    // deviation.
    second_phase_derivative: drawn(52, 60) |sampler; largest: Deviations| {
        let orbit = Law::random_grazing(sampler)?;
        let loops = sampler.one_of(&[1, 2, 3, 4]);
        let xi = orbit.second_phase_derivative(loops)?;
        let measured =
            curvature(2e-3, |h| Some(iterated(orbit.oscillator(), loops, [0.0, orbit.phase() + h]).ok()?[0]))
                .ok_or("P_global is not defined near grazing")?;
        largest.compare(measured, xi, xi.abs().max(1.0));
    } => largest.outcome(1e-7, "random oscillators, p = 1 to 4, by second differences");
    /// Remark 2.1: with a₁₂ = 0, β = (1 − a₂₂) b₁, so β ≠ 0 is a₂₂ ≠ 1 and b₁ ≠ 0.
    // The same product.
    remark: drawn_over(54, 0..1000) |sampler, k; largest: Deviations| {
        let entry = |k: i32, sampler: &mut Sampler, special: f64| {
            if k == 0 { special } else { sampler.between(-1.5, 1.5) }
        };
        let a22 = entry(k % 5, sampler, 1.0);
        let b1 = entry(k % 7, sampler, 0.0);
        let a = Matrix2::new(sampler.between(-1.0, 1.0), 0.0, sampler.between(-1.0, 1.0), a22);
        let map = grazing_theorems::LinearisedMap { a, b: Vector2::new(b1, sampler.between(-1.0, 1.0)) };
        largest.compare(map.transversality(), (1.0 - a22) * b1, 1.0);
        let implied = (map.transversality() != 0.0) == (a22 != 1.0 && b1 != 0.0);
        largest.require(implied);
    } => largest.outcome(0.0, "random A with a₁₂ = 0 and b, a₂₂ = 1 and b₁ = 0 among them");
}
