//! Section 2.5: the factor of the square root, the constants of the grazing point, and κ_p.

use crate::*;

checks! {
    /// eq:alpha: z⁽⁰⁾ − ẑ = −α ω√(2x̂/γ) + O(x̂) along P_disc of an oscillator with ψ ≠ 0.
    // Slack for the terms of third order in √x̂.
    square_root_factor: at_grazing(41, 60) |_, orbit; least: Smallest| {
        let point = orbit.grazing_point();
        // The size is √x̂, for which the remainder is of second order.
        least.see_resolved(order(|h| {
            let disc =
                discontinuity_map::<_, 1>(orbit.oscillator(), AtRest::new(h * h, orbit.phase())).ok()?.value;
            let stated = -point.alpha() * point.forcing_frequency * h * (2.0 / point.gamma).sqrt();
            // Times from 10⁻² to 10⁻⁵ are accurate to the rounding of phases of order one.
            Some((disc[1] - orbit.phase() - stated, 1e-14))
        }));
    } => least.order(2.0, 0.3, "random oscillators with ψ ≠ 0; order in √x̂");
    /// eq:phipsigamma: φ and ψ by differences of the reset law, γ by those of Γ; γ > 0.
    // Rounding 10⁻¹⁵ over the step 10⁻³; the fourth-order error is equally small.
    constants: at_grazing(42, 100) |_, orbit; largest: Deviations| {
        let (oscillator, point) = (orbit.oscillator(), orbit.grazing_point());
        let recoil = slope(1e-3, |y| Some(oscillator.reset::<1>(OnWall::new(y, orbit.phase())).value))
            .ok_or("a reset law has values everywhere")?;
        largest.compare(-recoil[0], point.phi, 1.0);
        largest.compare(recoil[1], point.psi, 1.0);
        let motion = oscillator.motion(State::at_rest(0.0, orbit.phase()));
        let deceleration = slope(1e-3, |t| Some(-motion.at(t).velocity)).ok_or("motion goes on")?;
        largest.compare(deceleration, point.gamma, point.gamma.max(1.0));
        largest.require(point.gamma > 0.0);
    } => largest.outcome(1e-11, "random oscillators with ψ ≠ 0");
    /// κ_p: it has the sign of (Aᵖ)₁₂/a₁₂ for τ > h_p, and vanishes with it.
    detuning_has_the_sign_of_the_entry: drawn(43, 3000) |sampler; cases: Votes| {
        let p = sampler.one_of(&[2, 3, 4, 5, 6, 8, 10]);
        let delta = sampler.between(0.01, 0.99);
        let boundary = grazing_theorems::admissibility_boundary::admissibility_boundary(p, delta)?;
        let tau = boundary + sampler.between(1e-6, 1.0) * (delta + 1.0 - boundary);
        let a = Matrix2::new(0.3, 0.7, (0.3 * (tau - 0.3) - delta) / 0.7, tau - 0.3);
        let entry = (1..p).fold(a, |power, _| power * a)[(0, 1)];
        let kappa = detuning(p, tau, delta);
        let definition = tau - 2.0 * delta.sqrt() * libm::cos(PI / f64::from(p));
        // The definition to two roundings; the sign is meaningless where κ_p is as small as its rounding.
        cases.see((kappa - definition).abs() < 1e-15 && (kappa.abs() < 1e-12 || kappa * entry > 0.0));
    } => cases.outcome("random p ≥ 2, δ and τ above h_p(δ)");
}
