//! Appendix B: the closed forms at resonances.

use super::printed_flow::{CLOSED, DIFFERENCES, Turn};
use crate::*;

/// Compares closed forms with numbers at resonances with p loops, E_p and ε at random.
fn at_resonances(
    loops: &[u32],
    over: &str,
    tolerance: f64,
    pairs: impl Fn(&Resonance) -> Result<Vec<(f64, f64)>, CheckError>,
) -> CheckResult {
    let largest = drawn(12, 300, |sampler, largest: &mut Deviations| {
        let (p, n) = (sampler.one_of(loops), sampler.one_of(&[1, 2, 3, 4]));
        let zeta = damping_for_decay(p, n, sampler.between(0.05, 0.95));
        let theory = grazing_theorems::LinearOscillator::new(zeta, sampler.between(0.1, 1.0))?;
        largest.pairs(pairs(&theory.resonance(p, n)?)?);
        Ok(())
    })?;
    Ok(largest.outcome(tolerance, over))
}

const ONE: &str = "resonances with p = 1, n = 1 to 4, E and ε at random";
const MANY: &str = "resonances with p = 2 to 6, n = 1 to 4, E and ε at random";
const MORE_LOOPS: &[u32] = &[2, 3, 4, 5, 6];
/// The tolerance of first differences at resonances: rounding over the step.
const SLOPES: f64 = 1e-11;

/// The sign (−1)ⁿ.
fn parity(resonance: &Resonance) -> f64 {
    if resonance.index().is_multiple_of(2) { 1.0 } else { -1.0 }
}

/// ξ_p of the iterated map at a resonance.
fn iterated(resonance: &Resonance) -> Result<f64, CheckError> {
    let grazing = resonance.grazing();
    let jet = global_iterate::<_, 2>(&grazing.model(), resonance.loops(), AtRest::new(0.0, grazing.phase()))?;
    Ok(jet.hessians[0][(1, 1)])
}

/// s^± by the general formula with numerical data, by the first line of the proof, and in its final form.
fn stability(loops: &[u32], over: &str, first_line: impl Fn(&Resonance, f64) -> f64) -> CheckResult {
    at_resonances(loops, over, 1e-13, |resonance| {
        let grazing = resonance.grazing();
        let orbit = GrazingOrbit::find(&grazing.model(), grazing.phase())?;
        let general = orbit.resonant_point(resonance.loops())?.stability_coefficients();
        let stated = resonance.stability_coefficients();
        let pairs = [(1.0, general.plus, stated.plus), (-1.0, general.minus, stated.minus)];
        let compared = |(side, general, stated)| [(first_line(resonance, side), stated), (general, stated)];
        Ok(pairs.into_iter().flat_map(compared).collect())
    })
}

/// The derivative in ω of a function of A along the grazing curve, by differences of P_global.
fn along_grazing(
    resonance: &Resonance,
    of: impl Fn(&nalgebra::Matrix2<f64>) -> f64,
) -> Result<f64, CheckError> {
    let theory = resonance.grazing().oscillator();
    // Angles 2πω₁/ω change rapidly at low ω, so the step decreases with ω².
    let step = 2e-3 * resonance.forcing_frequency() * resonance.forcing_frequency();
    let measured = slope(step, |h| {
        let state = theory.grazing(resonance.forcing_frequency() + h).ok()?;
        let landing = global_map::<_, 1>(&state.model(), AtRest::new(0.0, state.phase()), None).ok()?;
        Some(of(&landing.jet.derivative()))
    });
    Ok(measured.ok_or("P_global is not defined beside a resonance")?)
}

fn detuning(loops: u32) -> impl Fn(&nalgebra::Matrix2<f64>) -> f64 {
    move |a| a.trace() - 2.0 * a.determinant().sqrt() * libm::cos(PI / f64::from(loops))
}

checks! {
    /// a₁₁ = a₂₂ = (−1)ⁿ E₁ and the values of sine and cosine at resonance.
    diagonal_at_resonance: at_resonances(&[1], ONE, 1e-13, |resonance| {
        let grazing = resonance.grazing();
        let jet = global_map::<_, 1>(&grazing.model(), AtRest::new(0.0, grazing.phase()), None)?.jet;
        let stated = parity(resonance) * grazing.decay(1);
        let turn = Turn::new(&grazing, 1);
        let angles = [(turn.sine, 0.0), (turn.cosine, parity(resonance))];
        Ok([(jet.jacobian[(0, 0)], stated), (jet.jacobian[(1, 1)], stated)]
            .into_iter()
            .chain(angles)
            .collect())
    });
    /// The display of κ_p', also at resonances of numbers of loops other than p.
    detuning_derivative: at_resonances(&[1, 2, 3, 4, 5, 6], "grazing states, p = 2 to 5", DIFFERENCES, |resonance| {
        let pair =
            |p: u32| Ok((along_grazing(resonance, detuning(p))?, resonance.grazing().detuning_derivative(p)));
        (2..=5).map(pair).collect()
    });
    /// The last steps of both proofs: the general coefficients are those of the propositions.
    coefficients: at_resonances(&[1, 2, 3, 4, 5, 6], "resonances with p = 1 to 6, E and ε at random", 1e-11, |resonance| {
        let point = resonance.resonant_point();
        // Divided by the stated number, since sizes vary by orders of magnitude; c_PD loses digits where
        // s⁻ is small.
        Ok(vec![
            (point.saddle_node_coefficient() / resonance.saddle_node_coefficient(), 1.0),
            (point.period_doubling_coefficient() / resonance.period_doubling_coefficient(), 1.0),
        ])
    });
    /// eq:xi1proof3.
    resonant_second_derivative_of_one_loop: at_resonances(&[1], ONE, 1e-14, |resonance| {
        Ok(vec![(iterated(resonance)?, resonance.second_phase_derivative())])
    });
    /// eq:xipproof3.
    resonant_second_derivative_of_many_loops: at_resonances(MORE_LOOPS, MANY, 1e-13, |resonance| {
        Ok(vec![(iterated(resonance)?, resonance.second_phase_derivative())])
    });
    /// sin and cos of 2πp ω₁/ω and of 2πω₁/ω at a resonance with p ≥ 2.
    angles_at_resonance: at_resonances(MORE_LOOPS, MANY, CLOSED, |resonance| {
        let (once, whole) =
            (Turn::new(&resonance.grazing(), 1), Turn::new(&resonance.grazing(), resonance.loops()));
        let (sine, cosine) = libm::sincos(PI / f64::from(resonance.loops()));
        Ok(vec![(whole.sine, 0.0), (whole.cosine, -1.0), (once.sine, sine), (once.cosine, cosine)])
    });
    /// eq:xi1proof4.
    stability_of_one_loop: stability(&[1], ONE, |resonance, side| {
        let (decay, sign) = (resonance.grazing().decay(1), parity(resonance));
        let epsilon = resonance.grazing().oscillator().coefficient_of_restitution();
        let alpha = 1.0 + epsilon;
        (1.0 - side * sign * decay) * (sign * epsilon * epsilon * decay - side)
            + alpha * alpha * decay * (decay - sign) / (1.0 - sign * decay)
    });
    /// eq:xipproof4.
    stability_of_many_loops: stability(MORE_LOOPS, MANY, |resonance, side| {
        let decay = resonance.grazing().decay(resonance.loops());
        let epsilon = resonance.grazing().oscillator().coefficient_of_restitution();
        let alpha = 1.0 + epsilon;
        (1.0 + side * decay) * (-epsilon * epsilon * decay - side) + alpha * alpha * decay
    });
    /// eq:xi1proof5.
    slope_of_one_loop: at_resonances(&[1], ONE, SLOPES, |resonance| {
        let measured = along_grazing(resonance, |a| a.m12)?;
        let general = resonance.grazing().off_diagonal_derivative();
        Ok(vec![(measured, resonance.unfolding().derivative), (measured, general)])
    });
    /// eq:xipproof5.
    slope_of_many_loops: at_resonances(MORE_LOOPS, MANY, SLOPES, |resonance| {
        let measured = along_grazing(resonance, detuning(resonance.loops()))?;
        Ok(vec![(measured, resonance.unfolding().derivative)])
    });
}
