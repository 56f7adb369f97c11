//! Section 3.5: E_p, the signs of the coefficients, and the quadratic approximations.

use core::f64::consts::PI;

use crate::{
    CheckResult, Deviations, Failure, Measure, Outcome, Sampler, Smallest, Votes, order, printed, smallest,
};
use grazing_continuation::locate::{Condition, locate};
use grazing_continuation::mps::{EventTimes, unknown};
use grazing_continuation::resonance::ResonantGrazingPoint;
use grazing_model::LinearOscillator;
use grazing_theorems::auxiliary::modulus_power;
use grazing_theorems::unfolding::StabilityCoefficients;
use grazing_theorems::{Resonance, ResonantGrazing};

/// eq:Ep and E_p = δ^{p/2}: the decay of the free motion over p periods.
pub(crate) fn decay() -> CheckResult {
    let mut sampler = Sampler::new(131);
    let mut largest = Deviations::default();
    for _ in 0..1000 {
        let (zeta, omega) = (sampler.between(0.005, 0.5), sampler.between(0.3, 3.0));
        let p = sampler.one_of(&[1, 2, 3, 4, 6, 9]);
        let grazing = grazing_theorems::LinearOscillator::new(zeta, 0.7)?.grazing(omega)?;
        let loops = f64::from(p);
        let stated = libm::exp(-2.0 * PI * loops * zeta / omega);
        largest.compare(grazing.decay(p), stated, stated);
        largest.compare(modulus_power(p, grazing.linearised_map().determinant()), stated, stated.max(1e-3));
        largest.compare(1.0 - grazing.decay_complement(p), stated, 1.0);
    }
    // The exponent is up to a hundred; the determinant is a difference of products.
    Ok(largest.outcome(1e-13, "random damping ratios, frequencies and p"))
}

/// The least of −s⁺, s⁻, −c_SN and c_PD, each over what it vanishes with; `rebound` is εE_p.
fn least_of_four(stability: StabilityCoefficients, [sn, pd]: [f64; 2], rebound: f64, size: f64) -> f64 {
    let square = (1.0 - rebound) * (1.0 - rebound);
    let by_square = [-stability.plus, stability.minus].map(|value| value / square);
    by_square[0].min(by_square[1]).min(-sn / size).min(pd / (size * square.min(1.0)))
}

/// c_SN < 0, c_PD > 0, s⁺ < 0 < s⁻ wherever εE_p ≠ 1, by adversarial search over ζ and ε for each p and n.
///
/// For ε ≤ 1 the product εE_p stays below 1; for ε above 1 the general formulas are evaluated. All four are measured against
/// the factors that vanish with 1 − εE_p, E_p and 𝒜_graz.
pub(crate) fn signs() -> CheckResult {
    let mut least = f64::INFINITY;
    const STARTS: usize = 6;
    for (p, n) in INDICES {
        let (margin, _) = smallest(u64::from(10 * p + n), STARTS, |[a, b]: [f64; 2]| {
            let (zeta, epsilon) = (0.002 + 0.9 * a * a, 0.01 + 0.99 * b);
            let Ok(resonance) = grazing_theorems::LinearOscillator::new(zeta, epsilon)
                .and_then(|theory| theory.resonance(p, n))
            else {
                return f64::NAN;
            };
            let decay = resonance.grazing().decay(p);
            let coefficients = [resonance.saddle_node_coefficient(), resonance.period_doubling_coefficient()];
            let size = resonance.grazing().amplitude() * decay * decay;
            least_of_four(resonance.stability_coefficients(), coefficients, epsilon * decay, size)
        });
        least = least.min(margin);
        // ε beyond 1, on both sides of 1/E_p, by the general formulas of section 2.6 with φ = ε.
        let (margin, _) = smallest(u64::from(10 * p + n) + 500, STARTS, |[a, b]: [f64; 2]| {
            let (zeta, rebound) = (0.002 + 0.1 * a, 4.0 * b);
            // Nearer to ε = 1/E_p the coefficients are what cancellation leaves.
            if (rebound - 1.0).abs() < 1e-3 {
                return f64::NAN;
            }
            let Ok(resonance) =
                grazing_theorems::LinearOscillator::new(zeta, 1.0).and_then(|theory| theory.resonance(p, n))
            else {
                return f64::NAN;
            };
            let mut point = resonance.resonant_point();
            point.grazing.phi = rebound / resonance.grazing().decay(p);
            let coefficients = [point.saddle_node_coefficient(), point.period_doubling_coefficient()];
            let size = resonance.grazing().amplitude();
            least_of_four(point.stability_coefficients(), coefficients, rebound, size)
        });
        least = least.min(margin);
    }
    let over = "searches over ζ and ε for the smallest of four scaled signs, p = 1 to 5, ε beyond 1 too";
    Ok(Outcome::new(Measure::Margin { smallest: least }, 2 * STARTS * INDICES.len(), over))
}

/// Loops and indices that stand for all: both parities for one loop.
const INDICES: [(u32, u32); 9] = [(1, 1), (1, 2), (1, 3), (1, 4), (2, 1), (2, 2), (3, 1), (4, 2), (5, 1)];

/// A resonance with random ζ and ε, and what is found numerically there.
fn located(sampler: &mut Sampler) -> Result<(Resonance, ResonantGrazingPoint<LinearOscillator>), Failure> {
    let theory =
        grazing_theorems::LinearOscillator::new(sampler.between(0.005, 0.1), sampler.between(0.3, 0.98))?;
    let (p, n) = sampler.one_of(&INDICES);
    let resonance = theory.resonance(p, n)?;
    Ok((resonance, numerically(&resonance)?))
}

fn numerically(resonance: &Resonance) -> Result<ResonantGrazingPoint<LinearOscillator>, Failure> {
    let grazing = resonance.grazing();
    Ok(ResonantGrazingPoint::find(&grazing.model(), resonance.loops(), grazing.phase())?)
}

/// The continued SN and PD curves start with η of different signs and μ of different signs: the former as theorems 2.4 and 2.5 say.
pub(crate) fn opposite_sides() -> CheckResult {
    let mut sampler = Sampler::new(133);
    let mut cases = Votes::default();
    for _ in 0..60 {
        let (resonance, point) = located(&mut sampler)?;
        let origin = point.unknowns();
        let mut sides = [[0.0; 2]; 2];
        for (side, condition) in sides.iter_mut().zip([Condition::SADDLE_NODE, Condition::PERIOD_DOUBLING]) {
            let direction = point.direction(condition);
            // So small that the quadratic term rules.
            let velocity = 1e-4 * direction[unknown::VELOCITY].min(1.0);
            let start = origin + direction * (velocity / direction[unknown::VELOCITY]);
            let conditions = [condition, Condition::ImpactVelocity(velocity)];
            let found = locate(point.equations(), conditions, start, &mut EventTimes::default())?;
            let eta = found[unknown::SECONDARY] - origin[unknown::SECONDARY];
            let theory = resonance.grazing().oscillator();
            let grazing = theory.grazing(found[unknown::SECONDARY])?.amplitude();
            *side = [eta, found[unknown::PRIMARY] - grazing];
        }
        let [[sn_eta, sn_mu], [pd_eta, pd_mu]] = sides;
        cases.see(sn_eta * pd_eta < 0.0 && sn_mu < 0.0 && pd_mu > 0.0);
        let theorem = ResonantGrazing::check(&resonance.resonant_point(), 1e-11)?;
        cases.see(theorem.saddle_node().eta_side.signum() * sn_eta > 0.0);
        cases.see(theorem.period_doubling().eta_side.signum() * pd_eta > 0.0);
    }
    Ok(cases
        .outcome("resonances of random oscillators: curves beside the resonance, and the theorem's sides"))
}

/// At the three resonances of Figure 8: the dashed curve, (μ, η) = (𝒜 − 𝒜_graz, ω − ω*) inverted with the closed forms of
/// the coefficients, is off the continued curve by third order in η.
pub(crate) fn quadratic_approximation() -> CheckResult {
    let theory = grazing_theorems::LinearOscillator::new(printed("zeta"), printed("epsilon"))?;
    let mut least = Smallest::default();
    for (p, n) in [(1, 3), (2, 1), (3, 2)] {
        let resonance = theory.resonance(p, n)?;
        let point = numerically(&resonance)?;
        for (condition, coefficient) in [
            (Condition::SADDLE_NODE, resonance.saddle_node_coefficient()),
            (Condition::PERIOD_DOUBLING, resonance.period_doubling_coefficient()),
        ] {
            let direction = point.direction(condition);
            let per_velocity = direction / direction[unknown::VELOCITY];
            least.see_resolved(order(|h| {
                // A velocity at which η is about a fifth of the size.
                let velocity = 0.2 * h / per_velocity[unknown::SECONDARY].abs();
                let start = point.unknowns() + per_velocity * velocity;
                let conditions = [condition, Condition::ImpactVelocity(velocity)];
                let found = locate(point.equations(), conditions, start, &mut EventTimes::default()).ok()?;
                let eta = found[unknown::SECONDARY] - resonance.forcing_frequency();
                let grazing = theory.grazing(found[unknown::SECONDARY]).ok()?.amplitude();
                let dashed = grazing + coefficient * eta * eta;
                // Roundings of 𝒜, and of ω times 2cη.
                Some((found[unknown::PRIMARY] - dashed, 2e-15 * (1.0 + (coefficient * eta).abs())))
            }));
        }
    }
    // Slack for the next order at the smallest resolved sizes.
    Ok(least.order(3.0, 0.3, "SN and PD curves at the three resonances of Figure 8, against the dashed ones"))
}
