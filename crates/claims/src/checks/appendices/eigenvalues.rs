//! Appendix A: sums over the eigenvalues of A and their closed forms.

use crate::*;

/// The tolerance: each route makes about p² roundings of the terms by which deviations are divided, p up
/// to 15.
const ROUNDING: f64 = 1e-13;
const POINTS: &str = "points of the trapesium up to 10⁻⁶ from its slanted sides, p = 2 to 15";

/// The deviation of a sum from a quotient, relative to the moduli of the numerator's terms over the
/// denominator: near a double eigenvalue and near τ = δ + 1 the terms cancel.
fn quotient_deviation(sum: f64, numerator: Complex<f64>, size: f64, denominator: Complex<f64>) -> f64 {
    (numerator / denominator - sum).norm() * denominator.norm() / size
}

/// The largest deviation over sampled points with distinct eigenvalues.
fn over_trapesium(seed: u64, deviation: impl Fn(i32, f64, f64, &EigenvaluePair) -> f64) -> CheckResult {
    let mut sampler = Sampler::new(seed);
    let mut deviations = Deviations::default();
    for index in 0..3000 {
        let p = 2 + index % 14;
        let (mut tau, delta) = sampler.trapesium();
        // Every fifth point is near the double eigenvalues, on either side of them.
        if index % 5 == 0 {
            let nearness = libm::pow(10.0, sampler.between(-8.0, -2.0)) * sampler.one_of(&[-1.0, 1.0]);
            tau = 2.0 * delta.sqrt() * (1.0 + nearness) * sampler.one_of(&[-1.0, 1.0]);
        }
        if tau.abs() < delta + 1.0 && tau * tau != 4.0 * delta {
            deviations.see(deviation(p, tau, delta, &EigenvaluePair::new(tau, delta)));
        }
    }
    Ok(deviations.outcome(ROUNDING, POINTS))
}

/// The deviation of S_p from the quotient of eq:Sp2.
fn deviation_of_s(p: i32, tau: f64, delta: f64, pair: &EigenvaluePair) -> f64 {
    let expected = lucas_sequence(p as u32, tau, delta);
    let (numerator, size) = (pair.difference_of_powers(p), pair.size_of_powers(p));
    quotient_deviation(expected, numerator, size, pair.first - pair.second)
}

checks! {
    /// Where λ₁ = 1, and where λ₁ = λ₂: the text before eq:Hp2.
    unit_and_double_eigenvalues: over(1..64_i32) |k; (votes, print): (Votes, Votes)| {
        // Dyadic roots, so that the discriminants are exact.
        let r = f64::from(k) / 64.0;
        let delta = r * r;
        for (tau, unit, double) in [
            (2.0 * r, false, true),
            (-2.0 * r, false, true),
            (delta + 1.0, true, false),
            (0.5 * r, false, false),
            (-1.5 * r, false, false),
            (r + 0.5 * (delta + 1.0), false, false),
        ] {
            let pair = EigenvaluePair::new(tau, delta);
            let not_zero = pair.first.norm() > 0.0 && pair.second.norm() > 0.0;
            let second_not_one = (pair.second - 1.0).norm() > 0.0;
            votes.see(
                not_zero
                    && second_not_one
                    && (pair.first == Complex::new(1.0, 0.0)) == unit
                    && (pair.first == pair.second) == double,
            );
            print.see((pair.first == pair.second) == (tau == 2.0 * r));
        }
    } =>
        votes.outcome("τ = ±2√δ, δ + 1 and between, for 63 determinants with exact roots")
            .against_print(print.measure());
    /// The line between eq:Hp2 and eq:Hp3.
    h_by_geometric_series: over_trapesium(3, |p, tau, delta, pair| {
        let series = |lambda: Complex<f64>| {
            let top = power(lambda, p - 1);
            (top - 1.0) / (top * (lambda - 1.0))
        };
        let size = |lambda: Complex<f64>| {
            let top = power(lambda, p - 1).norm();
            (top + 1.0) / (top * (lambda - 1.0).norm())
        };
        let product = pair.monomial(1, 1);
        let numerator = product * (series(pair.second) - series(pair.first));
        let size = product.norm() * (size(pair.second) + size(pair.first));
        let expected = admissibility_sum(p as u32, tau, delta);
        quotient_deviation(expected, numerator, size, pair.first - pair.second)
    });
    /// The condition of eq:Sp2 is λ₁ ≠ λ₂: the quotient is right at τ = δ + 1, and has no value at
    /// τ = ±2√δ, where the condition that the proof of le:dets prints, τ ≠ δ + 1, holds.
    condition_of_quotient: over(1..100) |k; (deviations, print): (Deviations, Deviations)| {
        let (p, delta) = (2 + k % 14, f64::from(k) / 100.0);
        for tau in [delta + 1.0, 2.0 * delta.sqrt() * 1.001, -2.0 * delta.sqrt() * 0.999] {
            deviations.see(deviation_of_s(p, tau, delta, &EigenvaluePair::new(tau, delta)));
        }
        // A dyadic root, so that the eigenvalues are equal exactly.
        let r = f64::from(k) / 128.0;
        for tau in [2.0 * r, -2.0 * r] {
            print.see(deviation_of_s(p, tau, r * r, &EigenvaluePair::new(tau, r * r)));
        }
    } =>
        deviations.outcome(ROUNDING, "τ = δ + 1 and near ±2√δ for 99 determinants, p = 2 to 15; the print at τ = ±2√δ, where it is 0/0")
            .against_print(print.measure(ROUNDING));
    /// eq:Hp3.
    h_in_closed_form: over_trapesium(4, |p, tau, delta, pair| {
        let difference = pair.first - pair.second;
        let product = pair.monomial(p - 1, p - 1);
        let numerator =
            product * difference - pair.difference_of_powers(p) + pair.difference_of_powers(p - 1);
        let size =
            product.norm() * pair.size_of_powers(1) + pair.size_of_powers(p) + pair.size_of_powers(p - 1);
        let denominator = pair.gap() * difference * pair.monomial(p - 2, p - 2);
        quotient_deviation(admissibility_sum(p as u32, tau, delta), numerator, size, denominator)
    });
    /// eq:Tp3.
    t_in_closed_form: over_trapesium(6, |p, tau, delta, pair| {
        let difference = pair.first - pair.second;
        let product = pair.monomial(1, 1);
        let numerator =
            difference - pair.difference_of_powers(p) + product * pair.difference_of_powers(p - 1);
        let size =
            pair.size_of_powers(1) + pair.size_of_powers(p) + product.norm() * pair.size_of_powers(p - 1);
        let expected = lucas_partial_sum(p as u32, tau, delta);
        quotient_deviation(expected, numerator, size, pair.gap() * difference)
    });
    /// eq:Sp2.
    s_as_quotient: over_trapesium(7, deviation_of_s);
    /// eq:HpAgain.
    definition_of_h: over_trapesium(1, |p, tau, delta, pair| {
        (pair.h(p as u32) - admissibility_sum(p as u32, tau, delta)).norm() / pair.moduli().h(p as u32).re
    });
    /// eq:Hp2.
    h_by_powers: over_trapesium(2, |p, tau, delta, pair| {
        let sum: Complex<f64> = (1..p).map(|j| -pair.difference_of_powers(-j)).sum();
        let size: f64 = (1..p).map(|j| pair.size_of_powers(-j)).sum();
        let product = pair.monomial(1, 1);
        let expected = admissibility_sum(p as u32, tau, delta);
        quotient_deviation(expected, product * sum, product.norm() * size, pair.first - pair.second)
    });
    /// eq:Tp2.
    t_by_powers: over_trapesium(5, |p, tau, delta, pair| {
        let sum: Complex<f64> = (1..p).map(|j| pair.difference_of_powers(j)).sum();
        let size: f64 = (1..p).map(|j| pair.size_of_powers(j)).sum();
        quotient_deviation(lucas_partial_sum(p as u32, tau, delta), sum, size, pair.first - pair.second)
    });
}
