//! Appendix A: signs of H_p, S_p and T_p by search, and the proofs of lemmas 2.1, 4.2 and A.1.

use super::polar::xi;
use crate::*;

/// The number of local searches for each number of loops.
const STARTS: usize = 6;

/// The smallest value found by searches over the unit square for these numbers of loops.
pub(crate) fn search(
    loops: RangeInclusive<u32>,
    place: &str,
    what: &str,
    value: impl Fn(u32, [f64; 2]) -> f64,
) -> CheckResult {
    let mut margins = Smallest::default();
    for p in loops.clone() {
        for start in 0..STARTS {
            let seed = 100 * u64::from(p) + start as u64;
            let found = smallest(seed, 1, |point| value(p, point)).0;
            // A search that never reached the domain has found nothing.
            margins.see(if found == f64::INFINITY { f64::NAN } else { found });
        }
    }
    Ok(margins.margin(&format!(
        "searches over {place}, p = {} to {}: the smallest {what}",
        loops.start(),
        loops.end()
    )))
}

/// A determinant between 10⁻³ and 1 − 10⁻³, from a fraction between 0 and 1.
pub(crate) fn determinant(share: f64) -> f64 {
    0.001 + 0.998 * share
}

/// The number at this fraction of the way between two others.
pub(crate) fn along(share: f64, from: f64, to: f64) -> f64 {
    from + share * (to - from)
}

/// r^(p−2) H_p, which is of order one however small δ is.
pub(crate) fn scaled_h(p: u32, tau: f64, delta: f64) -> f64 {
    admissibility_sum(p, tau, delta) * libm::pow(delta, 0.5 * (f64::from(p) - 2.0))
}

/// A j between 1 and p − 1, from a fraction between 0 and 1.
pub(crate) fn loop_index(share: f64, p: u32) -> f64 {
    1.0 + libm::floor(share * f64::from(p - 2) + 0.5)
}

checks! {
    /// T_p at τ = g_p: the end of the proof of le:SpTp(b), where the print has δ{p/2} for a power.
    // T_p is at most p² times as sensitive to the rounding of τ.
    t_at_resonance: sampled(32, 1000, 2..=15) |sampler, p; (deviations, print): (Deviations, Deviations)| {
        let delta = sampler.between(0.001, 0.999);
        let tau = resonance_boundary(f64::from(p), delta);
        let (t, gap) = (lucas_partial_sum(p, tau, delta), delta - tau + 1.0);
        deviations.see(t * gap - (1.0 + modulus_power(p, delta)));
        print.see(t * gap - (1.0 + delta * 0.5 * f64::from(p)));
    } => deviations.outcome(1e-13, "determinants, p = 2 to 15").against_print(print.measure(1e-13));
    /// H_p at g_(p/2), p ≥ 3.
    // Both are of order one; τ has p roundings, to which H_p is p² times as sensitive.
    h_at_g_half: sampled(31, 1000, 3..=15) |sampler, p; deviations: Deviations| {
        let delta = sampler.between(0.001, 0.999);
        let tau = resonance_boundary(0.5 * f64::from(p), delta);
        let expected = (modulus_power(p, delta) - 1.0) / (delta - tau + 1.0);
        deviations.see(scaled_h(p, tau, delta) - expected);
    } => deviations.outcome(1e-12, "determinants, p = 3 to 15");
    /// T_2 = 1.
    // There is no rounding.
    t_two: drawn(33, 1000) |sampler; deviations: Deviations| {
        let (tau, delta) = sampler.trapesium();
        deviations.see(lucas_partial_sum(2, tau, delta) - 1.0);
    } => deviations.outcome(0.0, "points of the trapesium");
    /// The largest zero of H_p lies between g_(p/2) and g_(p−1), and H_p changes its sign there.
    bracket_of_h: search(3..=15, "the determinant", "distance of h_p from either end over √δ", |p, [x, _]| {
        let delta = determinant(x);
        let Ok(h) = admissibility_boundary(p, delta) else { return f64::NEG_INFINITY };
        let step = 1e-6 * delta.sqrt();
        if scaled_h(p, h - step, delta) >= 0.0 || scaled_h(p, h + step, delta) <= 0.0 {
            return f64::NEG_INFINITY;
        }
        let ends = [0.5 * f64::from(p), f64::from(p - 1)].map(|q| resonance_boundary(q, delta));
        (h - ends[0]).min(ends[1] - h) / delta.sqrt()
    });
    /// Ξ ≥ 0 for θ ≤ 2π/p, with zeros at the ends only: of third order at 0 and simple at 2π/p.
    xi_not_negative: search(3..=15, "0 < θ < 2π/p up to 10⁻³ of its length from the ends", "Ξ / (θ³ (2π/p − θ))", |p, [x, _]| {
        let end = 2.0 * PI / f64::from(p);
        let theta = along(x, 1e-3, 1.0 - 1e-3) * end;
        xi(p, theta) / (theta * theta * theta * (end - theta))
    });
    /// −sin((p − 1)θ) ≥ 0 for π/(p − 1) ≤ θ ≤ 2π/p, with a zero, a simple one, at the lower end.
    second_term_not_negative: search(3..=15, "π/(p − 1) < θ ≤ 2π/p", "−sin((p − 1)θ) / ((p − 1)θ − π)", |p, [x, _]| {
        let loops = f64::from(p);
        let theta = along(along(x, 1e-6, 1.0), PI / (loops - 1.0), 2.0 * PI / loops);
        -libm::sin((loops - 1.0) * theta) / ((loops - 1.0) * theta - PI)
    });
    /// (1 − r^(p−1)) sin θ > 0 for π/(p − 1) ≤ θ ≤ 2π/p.
    third_term_positive: search(3..=15, "π/(p − 1) ≤ θ ≤ 2π/p and the determinant", "(1 − r^(p−1)) sin θ", |p, [x, y]| {
        let (delta, loops) = (determinant(x), f64::from(p));
        let theta = along(y, PI / (loops - 1.0), 2.0 * PI / loops);
        (1.0 - modulus_power(p - 1, delta)) * libm::sin(theta)
    });
    /// eq:ujNumerator, over p: δʲ < 1 + (j/p)(δᵖ − 1); margins over (1 − δ)², as they vanish.
    numerator_of_u: search(2..=15, "0 < δ < 1 and 0 < j < p", "−(j (1 − δᵖ) − p (1 − δʲ)) / (1 − δ)²", |p, [x, y]| {
        let (delta, j, p) = (determinant(x), loop_index(y, p), f64::from(p));
        let numerator = j * (1.0 - libm::pow(delta, p)) - p * (1.0 - libm::pow(delta, j));
        -numerator / ((1.0 - delta) * (1.0 - delta))
    });
    /// H_p > 0 for τ ≥ 2√δ, with real eigenvalues.
    h_at_real_eigenvalues: search(2..=15, "2√δ ≤ τ ≤ δ + 1", "H_p", |p, [x, y]| {
        let delta = determinant(x);
        admissibility_sum(p, along(y, 2.0 * delta.sqrt(), delta + 1.0), delta)
    });
    /// H_p > 0 for g_(p−1) ≤ τ < 2√δ.
    h_above_g_before: search(3..=15, "0 < θ ≤ π/(p − 1)", "r^(p−2) H_p", |p, [x, y]| {
        let delta = determinant(x);
        let lowest = resonance_boundary(f64::from(p - 1), delta);
        scaled_h(p, along(y, lowest, 2.0 * delta.sqrt()), delta)
    });
    /// H_p at g_(p/2) is negative.
    h_negative_at_g_half: search(3..=15, "the determinant", "−r^(p−2) H_p", |p, [x, _]| {
        let delta = determinant(x);
        -scaled_h(p, resonance_boundary(0.5 * f64::from(p), delta), delta)
    });
    /// S_p > 0 for τ ≥ 2√δ.
    s_at_real_eigenvalues: search(2..=15, "2√δ ≤ τ ≤ δ + 1", "S_p / r^(p−1)", |p, [x, y]| {
        let delta = determinant(x);
        let scale = libm::pow(delta, 0.5 * f64::from(p - 1));
        lucas_sequence(p, along(y, 2.0 * delta.sqrt(), delta + 1.0), delta) / scale
    });
    /// No zero g_(p/m) of S_p with m ≥ 2 lies above h_p.
    other_zeros_of_s: search(3..=15, "the determinant and all m ≥ 2", "(h_p − g_(p/m)) / √δ", |p, [x, y]| {
        let delta = determinant(x);
        let Ok(h) = admissibility_boundary(p, delta) else { return f64::NEG_INFINITY };
        let m = 2.0 + libm::floor(y * f64::from(p - 3) + 0.5);
        (h - resonance_boundary(f64::from(p) / m, delta)) / delta.sqrt()
    });
    /// T_p > 0 for τ ≥ 2√δ.
    t_at_real_eigenvalues: search(2..=15, "2√δ ≤ τ ≤ δ + 1", "T_p", |p, [x, y]| {
        let delta = determinant(x);
        lucas_partial_sum(p, along(y, 2.0 * delta.sqrt(), delta + 1.0), delta)
    });
    /// Each term of eq:Tp4 is positive for 0 < θ < π/(p − 1).
    t_terms: search(3..=15, "0 < θ < π/(p − 1) up to 10⁻⁶ of its length from the ends", "sin jθ", |p, [x, _]| {
        let theta = along(x, 1e-6, 1.0 - 1e-6) * PI / f64::from(p - 1);
        (1..p).map(|j| libm::sin(f64::from(j) * theta)).fold(f64::INFINITY, f64::min)
    });
    /// The tangent of x^(j/p) at 1 lies above it.
    tangent_line: search(2..=15, "0 < x < 1 and 0 < j < p", "distance over (1 − x)²", |p, [x, y]| {
        let (x, exponent) = (determinant(x), loop_index(y, p) / f64::from(p));
        let distance = 1.0 + exponent * (x - 1.0) - libm::pow(x, exponent);
        distance / ((1.0 - x) * (1.0 - x))
    });
}
