//! Appendix A: sums over the eigenvalues of A, their closed and polar forms.

use core::f64::consts::PI;

use grazing_theorems::auxiliary::{admissibility_sum, lucas_partial_sum, lucas_sequence, resonance_boundary};
use nalgebra::Complex;

use crate::eigenvalues::{Pair, power};
use crate::outcome::{CheckResult, Outcome};
use crate::sampling::Sampler;
use crate::tally::{Deviations, Votes};

/// Each of the two routes makes some p² roundings of the terms by which deviations are divided, p up to 15.
pub(crate) const ROUNDING: f64 = 1e-13;

const POINTS: &str = "points of the trapesium up to 10⁻⁶ from its slanted sides, p = 2 to 15";

/// The deviation of a sum from a quotient, relative to the moduli of the terms of the numerator over the denominator: near a
/// double eigenvalue and near τ = δ + 1 these cancel, and no more digits can be expected.
fn quotient_deviation(sum: f64, numerator: Complex<f64>, size: f64, denominator: Complex<f64>) -> f64 {
    (numerator / denominator - sum).norm() * denominator.norm() / size
}

/// The largest deviation over sampled points with distinct eigenvalues.
fn over_trapesium(seed: u64, deviation: impl Fn(i32, f64, f64, &Pair) -> f64) -> Outcome {
    let mut sampler = Sampler::new(seed);
    let mut deviations = Deviations::default();
    for index in 0..3000 {
        let p = 2 + index % 14;
        let (mut tau, delta) = sampler.trapesium();
        // Every fifth point lies near the double eigenvalues, on either side of them.
        if index % 5 == 0 {
            let nearness = libm::pow(10.0, sampler.between(-8.0, -2.0)) * sampler.one_of(&[-1.0, 1.0]);
            tau = 2.0 * delta.sqrt() * (1.0 + nearness) * sampler.one_of(&[-1.0, 1.0]);
        }
        if tau.abs() < delta + 1.0 && tau * tau != 4.0 * delta {
            deviations.see(deviation(p, tau, delta, &Pair::new(tau, delta)));
        }
    }
    deviations.outcome(ROUNDING, POINTS)
}

/// eq:HpAgain.
pub(crate) fn definition_of_h() -> CheckResult {
    Ok(over_trapesium(1, |p, tau, delta, pair| {
        (pair.h(p) - admissibility_sum(p as u32, tau, delta)).norm() / pair.moduli().h(p).re
    }))
}

/// Where λ₁ = 1, and where λ₁ = λ₂: the text before eq:Hp2.
pub(crate) fn unit_and_double_eigenvalues() -> CheckResult {
    let (mut votes, mut print) = (Votes::default(), Votes::default());
    for k in 1..64_i32 {
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
            let pair = Pair::new(tau, delta);
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
    }
    let over = "τ = ±2√δ, δ + 1 and between, for 63 determinants with exact roots";
    Ok(votes.outcome(over).against_print(print.measure()))
}

/// eq:Hp2; as printed also for τ = −2√δ, where the quotient has no value.
pub(crate) fn h_by_powers() -> CheckResult {
    let deviation = |p: i32, tau: f64, delta: f64, pair: &Pair| {
        let sum: Complex<f64> = (1..p).map(|j| -pair.difference_of_powers(-j)).sum();
        let size: f64 = (1..p).map(|j| pair.size_of_powers(-j)).sum();
        let product = pair.monomial(1, 1);
        let expected = admissibility_sum(p as u32, tau, delta);
        quotient_deviation(expected, product * sum, product.norm() * size, pair.first - pair.second)
    };
    let mut print = Deviations::default();
    for r in [0.25, 0.5, 0.75] {
        print.see(deviation(3, -2.0 * r, r * r, &Pair::new(-2.0 * r, r * r)));
    }
    Ok(over_trapesium(2, deviation).against_print(print.measure(ROUNDING)))
}

/// The line between eq:Hp2 and eq:Hp3.
pub(crate) fn h_by_geometric_series() -> CheckResult {
    Ok(over_trapesium(3, |p, tau, delta, pair| {
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
    }))
}

/// eq:Hp3.
pub(crate) fn h_in_closed_form() -> CheckResult {
    Ok(over_trapesium(4, |p, tau, delta, pair| {
        let difference = pair.first - pair.second;
        let product = pair.monomial(p - 1, p - 1);
        let numerator =
            product * difference - pair.difference_of_powers(p) + pair.difference_of_powers(p - 1);
        let size =
            product.norm() * pair.size_of_powers(1) + pair.size_of_powers(p) + pair.size_of_powers(p - 1);
        let denominator = pair.gap() * difference * pair.monomial(p - 2, p - 2);
        quotient_deviation(admissibility_sum(p as u32, tau, delta), numerator, size, denominator)
    }))
}

/// eq:Tp2.
pub(crate) fn t_by_powers() -> CheckResult {
    Ok(over_trapesium(5, |p, tau, delta, pair| {
        let sum: Complex<f64> = (1..p).map(|j| pair.difference_of_powers(j)).sum();
        let size: f64 = (1..p).map(|j| pair.size_of_powers(j)).sum();
        quotient_deviation(lucas_partial_sum(p as u32, tau, delta), sum, size, pair.first - pair.second)
    }))
}

/// eq:Tp3.
pub(crate) fn t_in_closed_form() -> CheckResult {
    Ok(over_trapesium(6, |p, tau, delta, pair| {
        let difference = pair.first - pair.second;
        let product = pair.monomial(1, 1);
        let numerator =
            difference - pair.difference_of_powers(p) + product * pair.difference_of_powers(p - 1);
        let size =
            pair.size_of_powers(1) + pair.size_of_powers(p) + product.norm() * pair.size_of_powers(p - 1);
        let expected = lucas_partial_sum(p as u32, tau, delta);
        quotient_deviation(expected, numerator, size, pair.gap() * difference)
    }))
}

/// eq:Sp2; with the condition that the proof of le:dets states instead of λ₁ ≠ λ₂, the quotient has no value at a double
/// eigenvalue.
pub(crate) fn s_as_quotient() -> CheckResult {
    let deviation = |p: i32, tau: f64, delta: f64, pair: &Pair| {
        let expected = lucas_sequence(p as u32, tau, delta);
        let (numerator, size) = (pair.difference_of_powers(p), pair.size_of_powers(p));
        quotient_deviation(expected, numerator, size, pair.first - pair.second)
    };
    let mut print = Deviations::default();
    for r in [0.25, 0.5, 0.75] {
        for tau in [2.0 * r, -2.0 * r] {
            print.see(deviation(3, tau, r * r, &Pair::new(tau, r * r)));
        }
    }
    // The quotient is right at τ = δ + 1, which the print excludes.
    let mut inside = Deviations::default();
    for k in 1..100 {
        let delta = f64::from(k) / 100.0;
        inside.see(deviation(2 + k % 14, delta + 1.0, delta, &Pair::new(delta + 1.0, delta)));
    }
    if !inside.measure(ROUNDING).holds() {
        return Err(format!("the quotient fails at τ = δ + 1: {inside:?}").into());
    }
    Ok(over_trapesium(7, deviation).against_print(print.measure(ROUNDING)))
}

/// A point with complex eigenvalues, r = √δ and θ in (0, π).
struct Polar {
    p: i32,
    r: f64,
    theta: f64,
    tau: f64,
    delta: f64,
}

impl Polar {
    fn sine(&self, k: i32) -> f64 {
        libm::sin(f64::from(k) * self.theta)
    }

    fn r_to(&self, k: i32) -> f64 {
        libm::pow(self.r, f64::from(k))
    }

    /// δ − τ + 1 as |1 − λ₁|², which does not cancel.
    fn gap(&self) -> f64 {
        let real = 1.0 - self.r * libm::cos(self.theta);
        let imaginary = self.r * libm::sin(self.theta);
        real * real + imaginary * imaginary
    }

    fn s(&self, j: i32) -> f64 {
        lucas_sequence(j as u32, self.tau, self.delta)
    }

    fn t(&self) -> f64 {
        lucas_partial_sum(self.p as u32, self.tau, self.delta)
    }

    fn h(&self) -> f64 {
        admissibility_sum(self.p as u32, self.tau, self.delta)
    }

    /// Relative to the terms, as for [`quotient_deviation`].
    fn deviation(&self, value: f64, terms: &[f64], denominator: f64) -> f64 {
        let (sum, size) = terms.iter().fold((0.0, 0.0), |(sum, size), term| (sum + term, size + term.abs()));
        (sum - value * denominator) / size.max((value * denominator).abs())
    }
}

/// Sines of angles up to pθ are off by p roundings of 2π; τ, which the sums see, is off by a rounding, on which they depend
/// up to p/sin θ times as strongly.
const POLAR_ROUNDING: f64 = 1e-12;

fn over_polar(seed: u64, deviation: impl Fn(&Polar) -> f64) -> Outcome {
    let mut sampler = Sampler::new(seed);
    let mut deviations = Deviations::default();
    for index in 0..3000 {
        let delta = sampler.between(0.001, 0.999);
        let theta = sampler.between(0.01, PI - 0.01);
        let r = delta.sqrt();
        let tau = 2.0 * r * libm::cos(theta);
        deviations.see(deviation(&Polar { p: 2 + index % 14, r, theta, tau, delta }));
    }
    deviations.outcome(POLAR_ROUNDING, "complex eigenvalues, 0.01 < θ < π − 0.01, p = 2 to 15")
}

/// eq:polarCoords.
pub(crate) fn polar_coordinates() -> CheckResult {
    Ok(over_polar(11, |polar| {
        let pair = Pair::new(polar.tau, polar.delta);
        let modulus = polar.delta.sqrt();
        // The arccosine loses digits where its argument is near ±1, as 1/sin θ.
        let theta = libm::acos(polar.tau / (2.0 * modulus));
        let first = Complex::new(modulus * libm::cos(theta), modulus * libm::sin(theta));
        let angle = (theta - polar.theta).abs() * libm::sin(polar.theta);
        (first - pair.first).norm().max((first.conj() - pair.second).norm()).max(angle)
    }))
}

/// eq:lam1kminuslam2k, k of either sign.
pub(crate) fn differences_of_powers() -> CheckResult {
    Ok(over_polar(12, |polar| {
        let pair = Pair::new(polar.tau, polar.delta);
        [polar.p, -polar.p, 1, 0].into_iter().fold(0.0, |largest: f64, k| {
            let expected = Complex::new(0.0, 2.0 * polar.r_to(k) * polar.sine(k));
            largest.max((pair.difference_of_powers(k) - expected).norm() / polar.r_to(k))
        })
    }))
}

/// eq:Hp4.
pub(crate) fn h_as_sum_of_sines() -> CheckResult {
    Ok(over_polar(13, |polar| {
        let terms: Vec<f64> = (1..polar.p).map(|j| polar.r_to(1 - j) * polar.sine(j)).collect();
        polar.deviation(polar.h(), &terms, polar.sine(1))
    }))
}

/// eq:Hp5.
pub(crate) fn h_in_polar_form() -> CheckResult {
    Ok(over_polar(14, |polar| {
        let Polar { p, r, .. } = *polar;
        let terms = [polar.r_to(p) * polar.sine(1), -r * polar.sine(p), polar.sine(p - 1)];
        polar.deviation(polar.h(), &terms, polar.gap() * polar.r_to(p - 2) * polar.sine(1))
    }))
}

/// eq:Sp3.
pub(crate) fn s_in_polar_form() -> CheckResult {
    Ok(over_polar(15, |polar| {
        // Near its zeros S_p is compared to r^(p−1).
        let term = polar.r_to(polar.p - 1) * polar.sine(polar.p);
        (term - polar.s(polar.p) * polar.sine(1)) / polar.r_to(polar.p - 1)
    }))
}

/// eq:Tp6.
pub(crate) fn t_in_polar_form() -> CheckResult {
    Ok(over_polar(16, |polar| {
        let p = polar.p;
        let terms = [polar.sine(1), -polar.r_to(p - 1) * polar.sine(p), polar.r_to(p) * polar.sine(p - 1)];
        polar.deviation(polar.t(), &terms, polar.gap() * polar.sine(1))
    }))
}

/// eq:Tp4.
pub(crate) fn t_as_sum_of_sines() -> CheckResult {
    Ok(over_polar(17, |polar| {
        let terms: Vec<f64> = (1..polar.p).map(|j| polar.r_to(j - 1) * polar.sine(j)).collect();
        polar.deviation(polar.t(), &terms, polar.sine(1))
    }))
}

/// Ξ(θ) as it is defined after eq:Tp5.
pub(super) fn xi(p: u32, theta: f64) -> f64 {
    let p = f64::from(p);
    libm::sin(theta) - libm::sin(p * theta) + libm::sin((p - 1.0) * theta)
}

/// eq:Tp5, with Ξ as it is defined.
pub(crate) fn t_grouped() -> CheckResult {
    Ok(over_polar(18, |polar| {
        let Polar { p, r, theta, .. } = *polar;
        let top = polar.r_to(p - 1);
        let terms =
            [top * xi(p as u32, theta), -top * (1.0 - r) * polar.sine(p - 1), (1.0 - top) * polar.sine(1)];
        polar.deviation(polar.t(), &terms, polar.gap() * polar.sine(1))
    }))
}

/// The factorisation of Ξ, an identity for all angles.
pub(crate) fn factored_xi() -> CheckResult {
    let mut sampler = Sampler::new(19);
    let mut deviations = Deviations::default();
    for index in 0..3000 {
        let p = 1 + index % 20;
        let theta = sampler.between(-7.0, 7.0);
        let half = |k: u32| libm::sin(0.5 * f64::from(k) * theta);
        deviations.see(xi(p, theta) - 4.0 * half(1) * half(p - 1) * half(p));
    }
    // Three sines of angles up to 140, each off by 10⁻¹⁴.
    Ok(deviations.outcome(1e-13, "angles between −7 and 7, p = 1 to 20"))
}

/// S_p = 0 exactly at τ = g_(p/m), m = 1, …, p − 1, among complex eigenvalues: the text after eq:Sp3.
pub(crate) fn zeros_of_s() -> CheckResult {
    let mut votes = Votes::default();
    let mut sampler = Sampler::new(20);
    for p in 2..=15_u32 {
        for _ in 0..20 {
            let delta = sampler.between(0.001, 0.999);
            let scale = libm::pow(delta, 0.5 * f64::from(p - 1));
            let at = |m: f64, shift: f64| {
                let tau = resonance_boundary(f64::from(p) / m, delta) + shift;
                lucas_sequence(p, tau, delta) / scale
            };
            // A zero within rounding at each g_(p/m), with a change of sign: they are p − 1, as many as the degree in τ.
            let step = 1e-4 * delta.sqrt();
            votes.see((1..p).all(|m| {
                let m = f64::from(m);
                at(m, 0.0).abs() < 1e-11 && at(m, step) * at(m, -step) < 0.0
            }));
        }
    }
    Ok(votes.outcome("twenty determinants for each of p = 2 to 15, all m"))
}
