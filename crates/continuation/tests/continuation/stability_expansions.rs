//! y T and y D near a resonance: eq:yT1, eq:yD1, eq:yTp, eq:yDp (Lemmas 5.1 and 5.2).
//!
//! The paper prints z − z_graz,0 together with a₁₂' and f_p, which are derivatives along the grazing curve. These belong to
//! z − z_graz,η; with z_graz,0 the derivative has to be the partial one at fixed z. The two differ by ξ_p dz_graz/dη.

use grazing_continuation::mps::{EventTimes, Formulation, LoopEquations, Unknowns};
use grazing_model::AtRest;
use grazing_model::maps::global_iterate;
use grazing_theorems::Resonance;

use crate::specimens::{EPSILON, ZETA, assert_within, at_grazing, order, oscillator_at, resonances};

/// Every resonance with p = 1, …, 4 and 0.3 < ω < 2.
fn all() -> Vec<Resonance> {
    let list = resonances(ZETA, EPSILON, &[1, 2, 3, 4], [0.3, 2.0]);
    assert!(list.len() > 10);
    list
}

/// Second derivatives of P_global,1^p at the resonance: ∂²/∂z∂μ at fixed η, and ∂²/∂z∂η at fixed z and μ.
///
/// μ = 𝒜 − 𝒜_graz(ω), so that a change of η at fixed μ changes both 𝒜 and ω.
fn mixed_derivatives(resonance: &Resonance) -> [f64; 2] {
    let grazing = resonance.grazing();
    let oscillator = oscillator_at(resonance);
    let jet =
        global_iterate::<_, 2>(&oscillator, resonance.loops(), AtRest::new(0.0, grazing.phase())).unwrap();
    let by_phase = jet.hessians[0].row(1).into_owned();
    [by_phase[2], by_phase[3] + by_phase[2] * grazing.amplitude_derivative()]
}

/// The distances from the resonance in the ratio in which the tests let them shrink: y, z − z_graz,η, μ, η.
const RATIO: [f64; 4] = [1.0, -0.7, 0.6, 0.3];

/// (y T, y D) at the distances `size` · [`RATIO`], and z − z_graz,0.
fn at(resonance: &Resonance, size: f64) -> ([f64; 2], f64) {
    let [y, z, mu, eta] = RATIO.map(|ratio| ratio * size);
    let (grazing, oscillator) = at_grazing(ZETA, EPSILON, resonance.forcing_frequency() + eta);
    let phase = grazing.phase() + z;
    let point = Unknowns::new(y, phase, grazing.amplitude() + mu, grazing.forcing_frequency());
    let equations = LoopEquations::new(oscillator, resonance.loops(), Formulation::Vivid);
    let multipliers = equations.pair::<1>(&point, &mut EventTimes::default()).unwrap().multipliers();
    ([y * multipliers.trace, y * multipliers.determinant], phase - resonance.grazing().phase())
}

/// The linear part of y T with the phase measured from somewhere and the derivative in η that is said to go with it.
fn trace_expansion(resonance: &Resonance, size: f64, phase: f64, slope: f64) -> f64 {
    let [y, _, mu, eta] = RATIO.map(|ratio| ratio * size);
    let point = resonance.resonant_point();
    let (grazing, xi) = (point.grazing, point.second_phase_derivative);
    let (alpha, omega, gamma, phi) = (grazing.alpha(), grazing.forcing_frequency, grazing.gamma, grazing.phi);
    let loops = if resonance.loops() == 1 {
        grazing.map.a.m11 * phi * phi + grazing.map.a.m22
    } else {
        -(1.0 + phi * phi) * libm::pow(grazing.map.determinant(), 0.5 * f64::from(resonance.loops()))
    };
    let [by_mu, _] = mixed_derivatives(resonance);
    (loops - alpha * xi * omega * omega * (1.0 - alpha) / gamma) * y
        - alpha * omega * (xi * phase + by_mu * mu + slope * eta)
}

/// Two sizes at which a second-order remainder of 10⁻⁷ and less stands far above rounding.
const SIZES: [f64; 2] = [2e-4, 1e-4];

#[test]
fn trace_expands_about_the_moving_grazing_phase() {
    for resonance in all() {
        let slope = resonance.resonant_point().off_diagonal_slope();
        let remainders = SIZES.map(|size| {
            let ([trace, _], _) = at(&resonance, size);
            trace - trace_expansion(&resonance, size, RATIO[1] * size, slope)
        });
        // Second order; slack for the third at these sizes.
        assert_within(order(remainders), 2.0, 0.1);
    }
}

#[test]
fn printed_expansion_of_the_trace_is_wrong_in_first_order() {
    for resonance in all() {
        let point = resonance.resonant_point();
        let slope = point.off_diagonal_slope();
        let sizes = [2e-5, 1e-5];
        let quotients = sizes.map(|size| {
            let ([trace, _], from_fixed_phase) = at(&resonance, size);
            (trace - trace_expansion(&resonance, size, from_fixed_phase, slope)) / size
        });
        // Remainder over size, extrapolated to size zero, is α ω ξ_p (dz_graz/dη) η over size and not zero. What is left is
        // the remainder's third-order term, some 10⁻¹⁰ times derivatives up to 10⁴, and rounding 10⁻¹⁴ over size.
        let drift = resonance.grazing().phase_derivative() * RATIO[3];
        let missing =
            point.grazing.alpha() * point.grazing.forcing_frequency * point.second_phase_derivative * drift;
        assert!(missing.abs() > 1e-3);
        assert_within(2.0 * quotients[1] - quotients[0], missing, 1e-5);
    }
}

#[test]
fn partial_derivative_goes_with_the_fixed_grazing_phase() {
    for resonance in all() {
        let [_, partial] = mixed_derivatives(&resonance);
        let remainders = SIZES.map(|size| {
            let ([trace, _], from_fixed_phase) = at(&resonance, size);
            trace - trace_expansion(&resonance, size, from_fixed_phase, partial)
        });
        assert_within(order(remainders), 2.0, 0.1);
    }
}

#[test]
fn printed_slope_is_the_derivative_along_the_grazing_curve() {
    // eq:fp, and a₁₂' for p = 1: ∂²P/∂z∂η + ξ_p dz_graz/dη.
    for resonance in all() {
        let [_, partial] = mixed_derivatives(&resonance);
        let drift = resonance.second_phase_derivative() * resonance.grazing().phase_derivative();
        let total = resonance.resonant_point().off_diagonal_slope();
        // Sums of second derivatives of size up to 10³ (for small ω and p = 4), rounded some tens of times.
        assert_within(partial + drift, total, 1e-11 * (partial.abs() + drift.abs()));
    }
}

#[test]
fn determinant_expands_as_printed() {
    for resonance in all() {
        let point = resonance.resonant_point().grazing;
        let coefficient =
            point.phi * point.phi * libm::pow(point.map.determinant(), f64::from(resonance.loops()));
        let remainders = SIZES.map(|size| {
            let ([_, determinant], _) = at(&resonance, size);
            determinant - coefficient * RATIO[0] * size
        });
        assert_within(order(remainders), 2.0, 0.1);
    }
}
