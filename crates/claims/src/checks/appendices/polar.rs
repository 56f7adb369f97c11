//! Appendix A: sums over complex eigenvalues in polar form.

use crate::*;

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

    /// The deviation relative to the size of the terms, as for [`quotient_deviation`].
    fn deviation(&self, value: f64, terms: &[f64], denominator: f64) -> f64 {
        let (sum, size) = terms.iter().fold((0.0, 0.0), |(sum, size), term| (sum + term, size + term.abs()));
        (sum - value * denominator) / size.max((value * denominator).abs())
    }
}

/// The tolerance: sines of angles up to pθ have errors of p roundings of 2π; τ has one rounding error, to
/// which the sums are up to p/sin θ times as sensitive; less where both sides use the same angle.
const POLAR_ROUNDING: f64 = 1e-12;

fn over_polar(seed: u64, tolerance: f64, deviation: impl Fn(&Polar) -> f64) -> CheckResult {
    let deviations = sampled(seed, 3000, 2..=15, |sampler, p, deviations: &mut Deviations| {
        let delta = sampler.between(0.001, 0.999);
        let theta = sampler.between(0.01, PI - 0.01);
        let r = delta.sqrt();
        let tau = 2.0 * r * libm::cos(theta);
        deviations.see(deviation(&Polar { p: p as i32, r, theta, tau, delta }));
        Ok(())
    })?;
    Ok(deviations.outcome(tolerance, "complex eigenvalues, 0.01 < θ < π − 0.01, p = 2 to 15"))
}

/// Ξ(θ) as defined after eq:Tp5.
pub(super) fn xi(p: u32, theta: f64) -> f64 {
    let p = f64::from(p);
    libm::sin(theta) - libm::sin(p * theta) + libm::sin((p - 1.0) * theta)
}

checks! {
    /// The text after eq:Sp3: S_p = 0 exactly at τ = g_(p/m), 0 < m < p, for complex eigenvalues.
    zeros_of_s: drawn_over(20, 2..=15_u32) |sampler, p; votes: Votes| {
        for _ in 0..20 {
            let delta = sampler.between(0.001, 0.999);
            let scale = libm::pow(delta, 0.5 * f64::from(p - 1));
            let at = |m: f64, shift: f64| {
                let tau = resonance_boundary(f64::from(p) / m, delta) + shift;
                lucas_sequence(p, tau, delta) / scale
            };
            // There is a zero with a change of sign at each g_(p/m): p − 1 in all, the degree in τ.
            let step = 1e-4 * delta.sqrt();
            votes.see((1..p).all(|m| {
                let m = f64::from(m);
                at(m, 0.0).abs() < 1e-11 && at(m, step) * at(m, -step) < 0.0
            }));
        }
    } => votes.outcome("twenty determinants for each of p = 2 to 15, all m");
    /// The factorisation of Ξ, an identity for all angles.
    // Three sines of angles up to 140, each with an error of 10⁻¹⁴.
    factored_xi: sampled(19, 3000, 1..=20) |sampler, p; deviations: Deviations| {
        let theta = sampler.between(-7.0, 7.0);
        let half = |k: u32| libm::sin(0.5 * f64::from(k) * theta);
        deviations.see(xi(p, theta) - 4.0 * half(1) * half(p - 1) * half(p));
    } => deviations.outcome(1e-13, "angles between −7 and 7, p = 1 to 20");
    /// eq:polarCoords.
    polar_coordinates: over_polar(11, 1e-13, |polar| {
        let pair = EigenvaluePair::new(polar.tau, polar.delta);
        let modulus = polar.delta.sqrt();
        // The arccosine loses digits where its argument is near ±1, like 1/sin θ.
        let theta = libm::acos(polar.tau / (2.0 * modulus));
        let first = Complex::new(modulus * libm::cos(theta), modulus * libm::sin(theta));
        let angle = (theta - polar.theta).abs() * libm::sin(polar.theta);
        (first - pair.first).norm().max((first.conj() - pair.second).norm()).max(angle)
    });
    /// eq:lam1kminuslam2k, k of either sign.
    differences_of_powers: over_polar(12, POLAR_ROUNDING, |polar| {
        let pair = EigenvaluePair::new(polar.tau, polar.delta);
        [polar.p, -polar.p, 1, 0].into_iter().fold(0.0, |largest: f64, k| {
            let expected = Complex::new(0.0, 2.0 * polar.r_to(k) * polar.sine(k));
            largest.max((pair.difference_of_powers(k) - expected).norm() / polar.r_to(k))
        })
    });
    /// eq:Hp4.
    h_as_sum_of_sines: over_polar(13, POLAR_ROUNDING, |polar| {
        let terms: Vec<f64> = (1..polar.p).map(|j| polar.r_to(1 - j) * polar.sine(j)).collect();
        polar.deviation(polar.h(), &terms, polar.sine(1))
    });
    /// eq:Hp5.
    h_in_polar_form: over_polar(14, POLAR_ROUNDING, |polar| {
        let Polar { p, r, .. } = *polar;
        let terms = [polar.r_to(p) * polar.sine(1), -r * polar.sine(p), polar.sine(p - 1)];
        polar.deviation(polar.h(), &terms, polar.gap() * polar.r_to(p - 2) * polar.sine(1))
    });
    /// eq:Sp3.
    s_in_polar_form: over_polar(15, POLAR_ROUNDING, |polar| {
        // Near its zeros S_p is compared to r^(p−1).
        let term = polar.r_to(polar.p - 1) * polar.sine(polar.p);
        (term - polar.s(polar.p) * polar.sine(1)) / polar.r_to(polar.p - 1)
    });
    /// eq:Tp6.
    t_in_polar_form: over_polar(16, POLAR_ROUNDING, |polar| {
        let p = polar.p;
        let terms = [polar.sine(1), -polar.r_to(p - 1) * polar.sine(p), polar.r_to(p) * polar.sine(p - 1)];
        polar.deviation(polar.t(), &terms, polar.gap() * polar.sine(1))
    });
    /// eq:Tp4.
    t_as_sum_of_sines: over_polar(17, 1e-13, |polar| {
        let terms: Vec<f64> = (1..polar.p).map(|j| polar.r_to(j - 1) * polar.sine(j)).collect();
        polar.deviation(polar.t(), &terms, polar.sine(1))
    });
    /// eq:Tp5, with Ξ as defined.
    t_grouped: over_polar(18, POLAR_ROUNDING, |polar| {
        let Polar { p, r, theta, .. } = *polar;
        let top = polar.r_to(p - 1);
        let terms =
            [top * xi(p as u32, theta), -top * (1.0 - r) * polar.sine(p - 1), (1.0 - top) * polar.sine(1)];
        polar.deviation(polar.t(), &terms, polar.gap() * polar.sine(1))
    });
}
