//! Section 3.5: E_p, the signs of the coefficients, and the quadratic approximations.

use crate::checks::resonant::curves::quadratic_orders;
use crate::*;
use grazing_theorems::LinearOscillator;
use grazing_theorems::unfolding::StabilityCoefficients;

/// The least of −s⁺, s⁻, −c_SN and c_PD, each divided by the factor with which it vanishes; `rebound` is
/// εE_p.
fn least_of_four(stability: StabilityCoefficients, [sn, pd]: [f64; 2], rebound: f64, size: f64) -> f64 {
    let square = (1.0 - rebound) * (1.0 - rebound);
    let by_square = [-stability.plus, stability.minus].map(|value| value / square);
    by_square[0].min(by_square[1]).min(-sn / size).min(pd / (size * square.min(1.0)))
}

/// c_SN < 0, c_PD > 0, s⁺ < 0 < s⁻ wherever εE_p ≠ 1, by search over ζ and ε for each p and n.
///
/// εE_p < 1 for ε ≤ 1; for larger ε, on both sides of 1/E_p, the general formulas of section 2.6 are
/// used. All four are divided by factors that vanish with 1 − εE_p, E_p and 𝒜_graz.
pub(crate) fn signs() -> CheckResult {
    let closed_form = |p: u32, n: u32, [a, b]: [f64; 2]| {
        let (zeta, epsilon) = (0.002 + 0.9 * a * a, 0.01 + 0.99 * b);
        let resonance =
            LinearOscillator::new(zeta, epsilon).and_then(|theory| theory.resonance(p, n)).ok()?;
        let decay = resonance.grazing().decay(p);
        let coefficients = [resonance.saddle_node_coefficient(), resonance.period_doubling_coefficient()];
        let size = resonance.grazing().amplitude() * decay * decay;
        Some(least_of_four(resonance.stability_coefficients(), coefficients, epsilon * decay, size))
    };
    let general = |p: u32, n: u32, [a, b]: [f64; 2]| {
        let (zeta, rebound) = (0.002 + 0.1 * a, 4.0 * b);
        // Closer to ε = 1/E_p the coefficients are dominated by cancellation.
        if (rebound - 1.0).abs() < 1e-3 {
            return None;
        }
        let resonance = LinearOscillator::new(zeta, 1.0).and_then(|theory| theory.resonance(p, n)).ok()?;
        let mut point = resonance.resonant_point();
        point.grazing.phi = rebound / resonance.grazing().decay(p);
        let coefficients = [point.saddle_node_coefficient(), point.period_doubling_coefficient()];
        let size = resonance.grazing().amplitude();
        Some(least_of_four(point.stability_coefficients(), coefficients, rebound, size))
    };
    let mut least = Smallest::default();
    for (p, n) in INDICES {
        for start in 0..6 {
            let seed = u64::from(100 * p + 10 * n + start);
            least.see(smallest(seed, 1, |point| closed_form(p, n, point).unwrap_or(f64::NAN)).0);
            least.see(smallest(seed + 1000, 1, |point| general(p, n, point).unwrap_or(f64::NAN)).0);
        }
    }
    Ok(least
        .margin("searches over ζ and ε for the smallest of four scaled signs, p = 1 to 5, ε beyond 1 too"))
}

/// Representative numbers of loops and indices, with both parities for one loop.
const INDICES: [(u32, u32); 9] = [(1, 1), (1, 2), (1, 3), (1, 4), (2, 1), (2, 2), (3, 1), (4, 2), (5, 1)];

/// At the resonances of Figure 8 the dashed curve, (μ, η) = (𝒜 − 𝒜_graz, ω − ω*) inverted with the closed
/// forms of the coefficients, deviates from the continued curve in third order in η.
pub(crate) fn quadratic_approximation() -> CheckResult {
    let (zeta, epsilon) = (printed("zeta"), printed("epsilon"));
    let mut orders = Vec::new();
    for (p, n) in [(1, 3), (2, 1), (3, 2)] {
        let resonance = LinearOscillator::new(zeta, epsilon)?.resonance(p, n)?;
        let place = ResonantSpecimen::find(Law::linear(zeta, epsilon), p, n)?;
        orders.extend(quadratic_orders(&place, |curve, eta| {
            let coefficient = match curve.condition {
                Condition::SADDLE_NODE => resonance.saddle_node_coefficient(),
                _ => resonance.period_doubling_coefficient(),
            };
            coefficient * eta * eta
        }));
    }
    Ok(of_orders(&orders, "SN and PD curves at the three resonances of Figure 8, against the dashed ones"))
}

checks! {
    /// The continued SN and PD curves begin with different signs of η, as stated, and of μ.
    opposite_sides: drawn(133, 60) |sampler; cases: Votes| {
        let (zeta, epsilon) = (sampler.between(0.005, 0.1), sampler.between(0.3, 0.98));
        let (p, n) = sampler.one_of(&INDICES);
        let place = ResonantSpecimen::find(Law::linear(zeta, epsilon), p, n)?;
        let mut found = [[0.0; 2]; 2];
        for (found, curve) in found.iter_mut().zip(place.curves()) {
            // The impact velocity is so small that the quadratic term dominates.
            let eta = 1e-4 / curve.leading.impact_velocity_slope;
            let near = place.on_curve(&curve, eta).ok_or("no point of a curve")?;
            cases.see(curve.leading.eta_side.signum() * eta > 0.0 && near.unknowns[0] > 0.0);
            *found = [eta, near.relative()[1]];
        }
        let [[sn_eta, sn_mu], [pd_eta, pd_mu]] = found;
        cases.see(sn_eta * pd_eta < 0.0 && sn_mu < 0.0 && pd_mu > 0.0);
    } => cases.outcome("resonances of random oscillators: curves beside the resonance, and the theorem's sides");
    /// eq:Ep and E_p = δ^{p/2}: the decay of the free motion over p periods.
    // The exponent is up to a hundred; the determinant is a difference of products.
    decay: drawn(131, 1000) |sampler; largest: Deviations| {
        let (zeta, omega) = (sampler.between(0.005, 0.5), sampler.between(0.3, 3.0));
        let p = sampler.one_of(&[1, 2, 3, 4, 6, 9]);
        let grazing = LinearOscillator::new(zeta, 0.7)?.grazing(omega)?;
        let loops = f64::from(p);
        let stated = libm::exp(-2.0 * PI * loops * zeta / omega);
        largest.compare(grazing.decay(p), stated, stated);
        largest.compare(modulus_power(p, grazing.linearised_map().determinant()), stated, stated.max(1e-3));
        largest.compare(1.0 - grazing.decay_complement(p), stated, 1.0);
    } => largest.outcome(1e-13, "random damping ratios, frequencies and p");
}
