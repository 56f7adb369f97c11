//! Section 4.2: iterates of the global map.

use crate::checks::appendices::signs::{along, determinant, search};
use crate::*;

/// The tolerance: each route makes about p² roundings of the terms by which deviations are divided, p up
/// to 15.
const ROUNDING: f64 = 1e-13;

/// The iterate of a map by repeated application, and the size of the largest intermediate number.
fn repeated(map: &LinearisedMap, p: u32) -> (LinearisedMap, f64) {
    let mut iterate = LinearisedMap { a: Matrix2::identity(), b: Vector2::zeros() };
    let mut size = 1.0_f64;
    for _ in 0..p {
        iterate = LinearisedMap { a: map.a * iterate.a, b: map.a * iterate.b + map.b };
        size = size.max(iterate.a.amax()).max(iterate.b.amax());
    }
    (iterate, size * (1.0 + map.a.amax()) * (1.0 + map.a.amax()))
}

/// The tolerance: tens of roundings of numbers by which deviations are divided; τ and δ are rounded too.
const MATRIX_ROUNDING: f64 = 1e-14;

/// le:SpTp: all three parts where their hypotheses hold, and their failure where these do not.
pub(crate) fn signs_and_values() -> CheckResult {
    let mut sampler = Sampler::new(9);
    let mut votes = Votes::default();
    for index in 0..2000 {
        let p = 2 + index % 14;
        let loops = f64::from(p);
        let delta = sampler.between(0.001, 0.999);
        let (g, h) = (resonance_boundary(loops, delta), admissibility_boundary(p, delta)?);
        let half = resonance_boundary(0.5 * loops, delta);
        let tau = sampler.between(h, delta + 1.0);
        votes.see(lucas_sequence(p, tau, delta) * (tau - g) > 0.0);
        let tau = sampler.between(half, delta + 1.0);
        votes.see(lucas_partial_sum(p, tau, delta) > 0.0);
        let modulus = modulus_power(p, delta);
        votes.see((lucas_sequence(p + 1, g, delta) / modulus + 1.0).abs() < 1e-12);
        // Away from the resonance the value is different.
        let off = g + 0.01 * delta.sqrt();
        votes.see((lucas_sequence(p + 1, off, delta) / modulus + 1.0).abs() > 1e-6);
        if p >= 3 {
            // Just below g_(p/2) < h_p the sign is opposite.
            let below = half - 1e-3 * delta.sqrt() / (loops * loops);
            votes.see(below < h && lucas_sequence(p, below, delta) * (below - g) < 0.0);
        }
    }
    for p in 3..=15_u32 {
        // Near δ = 1 T_p < 0 at a θ in (2π/p, 4π/p) at which Ξ is least; for p = 3 at τ < −1.
        let delta = 0.9999;
        let share = (1..100).map(|k| 0.5 * f64::from(p) / (1.0 + f64::from(k) / 100.0));
        let lowest = share
            .map(|q| lucas_partial_sum(p, resonance_boundary(q, delta), delta))
            .fold(f64::INFINITY, f64::min);
        votes.see(lowest < 0.0);
    }
    Ok(votes.outcome("points where the hypotheses hold and points where they do not, p = 2 to 15"))
}

checks! {
    /// eq:Pglobalp: the order of the remainder.
    // The next term is of relative size h < 10⁻⁴ at the last resolved sizes.
    iterated_map: drawn_over(4, specimens_with(1..=4)?) |sampler, (grazing, p); orders: Smallest| {
        let (phase, [primary, secondary]) = (grazing.phase(), grazing.oscillator().parameters());
        let LinearisedMap { a, b } = grazing.grazing_point().map.iterate(p);
        let directions = directions::<3>(sampler, 4);
        for component in 0..2 {
            orders.see(uniform_order(&directions, |direction, h| {
                let [dx, dz, dmu] = direction.map(|share| share * h);
                let oscillator = grazing.oscillator().with_parameters([primary + dmu, secondary]);
                let image = global_iterate::<_, 1>(&oscillator, p, AtRest::new(dx, phase + dz)).ok()?.value;
                let remainder = image - Vector2::new(0.0, phase) - a * Vector2::new(dx, dz) - b * dmu;
                // Positions of order one and phases up to 2π, p times.
                Some((remainder[component], 2e-15 * f64::from(p)))
            }));
        }
    } => orders.order(2.0, 0.1, "both components on twelve oscillators, p = 1 to 4, seven directions in (x, z, μ) at once");
    /// The step of the induction: the printed forms for p, with the map applied once more, are those for
    /// p + 1.
    // One product, of numbers of the size by which deviations are divided.
    induction: sampled(7, 2000, 0..=14) |sampler, p; deviations: Deviations| {
        let map = sampled_map(sampler);
        let (here, next) = (map.iterate(p), map.iterate(p + 1));
        let size = (1.0 + here.a.amax() + here.b.amax()) * (1.0 + map.a.amax()) * (1.0 + map.a.amax());
        deviations.see((map.a * here.a - next.a).amax() / size);
        deviations.see((map.a * here.b + map.b - next.b).amax() / size);
    } => deviations.outcome(1e-15, "affine maps with (τ, δ) in the trapesium, p = 0 to 14");
    /// eq:SpTp: the printed double sums against the recurrence.
    sums_of_eigenvalues: sampled(1, 2000, 1..=15) |sampler, p; deviations: Deviations| {
        let (tau, delta) = sampler.trapesium();
        let pair = EigenvaluePair::new(tau, delta);
        let size = pair.moduli();
        deviations.see((pair.s(p) - lucas_sequence(p, tau, delta)).norm() / size.s(p).re);
        if p > 1 {
            deviations.see((pair.t(p) - lucas_partial_sum(p, tau, delta)).norm() / size.t(p).re);
        }
    } => deviations.outcome(ROUNDING, "S_p and T_p at points of the trapesium, p = 1 to 15");
    /// H_p is the sum of the S_j / δ^(j−1).
    h_as_sum_of_s: sampled(2, 2000, 2..=15) |sampler, p; deviations: Deviations| {
        let (tau, delta) = sampler.trapesium();
        let pair = EigenvaluePair::new(tau, delta);
        let sum: f64 =
            (1..p).map(|j| lucas_sequence(j, tau, delta) / libm::pow(delta, f64::from(j - 1))).sum();
        deviations.see((pair.h(p) - sum).norm() / pair.moduli().h(p).re);
        deviations.see((admissibility_sum(p, tau, delta) - sum) / pair.moduli().h(p).re);
    } => deviations.outcome(ROUNDING, "points of the trapesium, p = 2 to 15");
    /// eq:Hp9, multiplied by δ^(p−2) to avoid problems with small δ.
    // The terms are positive: one rounding each.
    difference_of_products: sampled(3, 2000, 1..=15) |sampler, p; deviations: Deviations| {
        let (tau, delta) = sampler.trapesium();
        let raised = libm::pow(delta, f64::from(p) - 2.0);
        let size = EigenvaluePair::new(tau, delta).moduli();
        let terms = (size.s(p - 1) * size.t(p) + size.s(p) * size.t(p - 1) + size.h(p) * raised).re;
        let (s, s_before) = (lucas_sequence(p, tau, delta), lucas_sequence(p - 1, tau, delta));
        let (t, t_before) = (lucas_partial_sum(p, tau, delta), lucas_partial_sum(p - 1, tau, delta));
        let difference = s_before * t - s * t_before - raised * admissibility_sum(p, tau, delta);
        // For p = 1 all terms vanish.
        deviations.see(if terms > 0.0 { difference / terms } else { difference });
    } => deviations.outcome(1e-14, "points of the trapesium, p = 1 to 15");
    /// eq:Ap and eq:b1pb2p: the printed forms against repeated application.
    powers: sampled(5, 2000, 1..=15) |sampler, p; deviations: Deviations| {
        let map = sampled_map(sampler);
        let (expected, size) = repeated(&map, p);
        deviations.see((map.iterate(p).a - expected.a).amax() / size);
        deviations.see((map.iterate(p).b - expected.b).amax() / size);
    } => deviations.outcome(MATRIX_ROUNDING, "affine maps with (τ, δ) in the trapesium, p = 1 to 15");
    /// le:SpTp(b).
    // S_(p+1) and T_p are at most p² times as sensitive to the rounding of τ.
    values_at_resonance: sampled(8, 2000, 2..=24) |sampler, p; deviations: Deviations| {
        let delta = sampler.between(0.001, 0.999);
        let tau = resonance_boundary(f64::from(p), delta);
        let modulus = modulus_power(p, delta);
        deviations.see((lucas_sequence(p + 1, tau, delta) + modulus) / modulus);
        deviations.see(lucas_partial_sum(p, tau, delta) * (delta - tau + 1.0) - 1.0 - modulus);
    } => deviations.outcome(1e-12, "determinants, p = 2 to 24");
    /// le:SpTp(a) by search: S_p / (τ − g_p) > 0 for h_p < τ ≤ δ + 1, also at τ = g_p.
    sign_of_s: search(2..=15, "h_p < τ ≤ δ + 1", "r^(2−p) S_p / (τ − g_p)", |p, [x, y]| {
        let delta = determinant(x);
        let Ok(lowest) = admissibility_boundary(p, delta) else { return f64::NEG_INFINITY };
        let tau = along(along(y, 1e-9, 1.0), lowest, delta + 1.0);
        let kappa = tau - resonance_boundary(f64::from(p), delta);
        // At τ = g_p the quotient is 0/0; at this distance S_p still has six correct digits.
        let distance = if kappa.abs() < 1e-8 { 1e-8_f64.copysign(kappa) } else { kappa };
        let s = lucas_sequence(p, tau - kappa + distance, delta);
        s / distance * libm::pow(delta, 0.5 * (2.0 - f64::from(p)))
    });
    /// le:SpTp(c) by search.
    sign_of_t: search(2..=15, "g_(p/2) ≤ τ ≤ δ + 1", "T_p", |p, [x, y]| {
        let delta = determinant(x);
        let lowest = resonance_boundary(0.5 * f64::from(p), delta);
        lucas_partial_sum(p, along(y, lowest, delta + 1.0), delta)
    });
}
