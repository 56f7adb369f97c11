//! Section 2.3: existence and stability of the non-impacting periodic solution.

use crate::specimen::frequency_first;
use crate::*;
use grazing_theorems::spectrum::{Eigenvalues, in_trapesium};

/// The fixed point (x*, z*) of P_global at μ by Newton's method.
fn fixed_point(orbit: &Grazing, mu: f64) -> Result<Vector2<f64>, CheckError> {
    let [primary, secondary] = orbit.oscillator().parameters();
    let oscillator = orbit.oscillator().with_parameters([primary + mu, secondary]);
    let mut point = Vector2::new(0.0, orbit.phase());
    for _ in 0..20 {
        let jet = global_map::<_, 1>(&oscillator, AtRest::new(point[0], point[1]), None)?.jet;
        let step = (jet.derivative() - Matrix2::identity()).try_inverse().ok_or("1 is an eigenvalue of A")?
            * (jet.value - point);
        point -= step;
        // The convergence is quadratic: the next step would be rounding.
        if step.amax() < 1e-9 {
            return Ok(point);
        }
    }
    Err("no fixed point of P_global was found".into())
}

/// A grazing orbit with the frequency as μ, which enters nonlinearly, away from the fold of 𝒜_graz(ω).
fn nonlinear_orbit(sampler: &mut Sampler) -> Result<Grazing, CheckError> {
    loop {
        let orbit = Law::random_grazing(sampler)?;
        let map = orbit.grazing_point().map;
        // At the fold grazing is not transversal; with eigenvalue 1 the fixed point folds.
        if orbit.primary_slope().abs() > 0.1 && map.determinant() - map.trace() + 1.0 > 0.2 {
            return frequency_first(&orbit);
        }
    }
}

/// eq:beta: β = det(I − A) dx*/dμ by Cramer's rule; x* crosses the wall with its sign.
pub(crate) fn transversality() -> CheckResult {
    let mut sampler = Sampler::new(24);
    let mut largest = Deviations::default();
    for _ in 0..500 {
        let map = sampled_map(&mut sampler);
        let (a, b) = (map.a, map.b);
        // Cramer: the first column of I − A replaced by b.
        let replaced = Matrix2::new(b.x, -a.m12, b.y, 1.0 - a.m22);
        largest.compare(map.transversality(), replaced.determinant(), a.amax().max(1.0));
    }
    for _ in 0..100 {
        let orbit = nonlinear_orbit(&mut sampler)?;
        let (ahead, back) = (fixed_point(&orbit, 1e-5)?, fixed_point(&orbit, -1e-5)?);
        let agrees = (ahead[0] - back[0]) * orbit.grazing_point().map.transversality() > 0.0;
        largest.require(agrees && ahead[0] * back[0] < 0.0);
    }
    // The same two products.
    Ok(largest.outcome(0.0, "random A and b with (τ, δ) in the trapesium; crossings of random oscillators"))
}

checks! {
    /// eq:eigs: the two numbers are the eigenvalues, a real pair in order or a conjugate pair.
    // Numbers of order one and a handful of operations.
    eigenvalues: drawn(25, 2000) |sampler; largest: Deviations| {
        let (tau, delta) = sampler.trapesium();
        match Eigenvalues::from_trace_and_determinant(tau, delta) {
            Eigenvalues::Real { lambda_1, lambda_2 } => {
                largest.require(lambda_1 >= lambda_2 && tau * tau >= 4.0 * delta);
                for (lambda, sign) in [(lambda_1, 1.0), (lambda_2, -1.0)] {
                    largest.see((lambda * lambda - tau * lambda + delta).abs());
                    // Near a double eigenvalue the square root amplifies errors, so the radicands are
                    // compared.
                    let root = 2.0 * lambda - tau;
                    largest.require(root * sign >= -1e-15);
                    largest.see(root * root - tau * tau + 4.0 * delta);
                }
            }
            Eigenvalues::ComplexPair { modulus, argument } => {
                let (im, re) = libm::sincos(argument);
                largest.see((2.0 * modulus * re - tau).abs());
                largest.see((modulus * modulus - delta).abs());
                largest.require(im > 0.0 && tau * tau < 4.0 * delta);
            }
        }
    } => largest.outcome(1e-14, "points of the trapesium");
    /// eq:cT: with δ > 0, powers of A tend to zero if and only if (τ, δ) lies in the trapesium.
    trapesium: drawn_over(26, 0..2000) |sampler, k; cases: Votes| {
        let (mut delta, mut tau) = (sampler.between(1e-3, 1.5), sampler.between(-3.0, 3.0));
        // Every third matrix lies within 10⁻⁶ of one of the three sides at which stability is lost.
        match k % 6 {
            0 => tau = sampler.one_of(&[1.0, -1.0]) * (delta + 1.0) + sampler.between(-1e-6, 1e-6),
            1 => delta = 1.0 + sampler.between(-1e-6, 1e-6),
            _ => {}
        }
        let mut power = map_with(sampler, tau, delta).a;
        // A to the power 2⁴⁰, with its size kept separately: log|Aᴺ| = log of the size.
        let mut log_size = 0.0;
        for _ in 0..40 {
            let size = power.amax();
            power /= size;
            log_size = 2.0 * (log_size + libm::log(size));
            power *= power;
        }
        log_size += libm::log(power.amax());
        cases.see((log_size < 0.0) == in_trapesium(tau, delta));
    } => cases.outcome("random matrices with δ > 0, a third of them within 10⁻⁶ of a side");
    /// For small μ with βμ < 0 orbits that start near the non-impacting solution approach it.
    stability: at_grazing(27, 60) |sampler, orbit; cases: Votes| {
        let map = orbit.grazing_point().map;
        let slope = map.fixed_point_position_slope()?;
        let size = 1e-3 / slope.abs();
        let mu = if slope > 0.0 { -size } else { size };
        let [primary, secondary] = orbit.oscillator().parameters();
        let oscillator = orbit.oscillator().with_parameters([primary + mu, secondary]);
        let [x, z] = fixed_point(orbit, mu)?.into();
        // Loops contract like |λ|ⁿ: their number makes this 10⁻³, from a tenth of the distance.
        let radius = map.eigenvalues().spectral_radius();
        let loops = libm::ceil(libm::log(1e-4) / libm::log(radius));
        let from = State::at_rest(x + 0.1 * x * sampler.between(-1.0, 1.0), z);
        let horizon = loops * oscillator.forcing_period();
        let approached = match Orbit::new(&oscillator, from, horizon, 5).finish() {
            OrbitEnd::TimeIsUp(end) => libm::hypot(end.position - x, end.velocity) < 0.05 * x.abs(),
            _ => false,
        };
        cases.see(x < 0.0 && approached);
    } => cases.outcome("random oscillators just below grazing");
    /// τ and δ are those of the flow over one period in (x, y), the wall ignored.
    // Products and sums of a dozen rounded numbers of the size of the entries.
    trace_and_determinant: at_grazing(21, 500) |_, orbit; largest: Deviations| {
        let map = orbit.grazing_point().map;
        let from = State::at_rest(0.0, orbit.phase());
        let jet = orbit.oscillator().flow::<1>(from, orbit.oscillator().forcing_period());
        let monodromy: Matrix2<f64> = jet.jacobian.fixed_columns::<2>(0).into_owned();
        let size = map.a.amax().max(1.0);
        largest.compare(map.trace(), monodromy.trace(), size);
        largest.compare(map.determinant(), monodromy.determinant(), size * size);
    } => largest.outcome(1e-13, "grazing orbits of random oscillators, against the monodromy matrix");
    /// eq:xStarzStar: the fixed point of P_global to first order.
    // Slack for the next order at the smallest resolved μ.
    fixed_point_expansion: drawn(22, 100) |sampler; least: Smallest| {
        let orbit = nonlinear_orbit(sampler)?;
        let slope = orbit.grazing_point().map.fixed_point_slope()?;
        least.see_resolved(order(|mu| {
            let found = fixed_point(&orbit, mu).ok()?;
            let remainder = found - Vector2::new(0.0, orbit.phase()) - slope * mu;
            // (I − A)⁻¹ amplifies rounding by up to a factor of a hundred.
            Some((remainder.norm(), 1e-13))
        }));
    } => least.order(2.0, 0.3, "random oscillators with the frequency as μ");
    /// eq:xStarzStarDeriv: dx*/dμ by differences of numerical fixed points.
    // h⁶ = 10⁻¹⁸ times seventh derivatives of 𝒜/𝒜_graz(ω), whose resonance has width ζ: empirical.
    position_slope: drawn(23, 100) |sampler; largest: Deviations| {
        let orbit = nonlinear_orbit(sampler)?;
        let map = orbit.grazing_point().map;
        let measured =
            slope(1e-3, |mu| Some(fixed_point(&orbit, mu).ok()?[0])).ok_or("no fixed point near grazing")?;
        let stated = map.transversality() / (map.determinant() - map.trace() + 1.0);
        largest.compare(measured, stated, stated.abs().max(1.0));
        largest.compare(map.fixed_point_position_slope()?, stated, stated.abs().max(1.0));
    } => largest.outcome(1e-7, "random oscillators with the frequency as μ");
}
