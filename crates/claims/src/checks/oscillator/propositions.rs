//! Propositions 3.2 and 3.3: the printed formulas against the general theorem fed from the numerical map, over random
//! parameters.

use core::f64::consts::PI;

use grazing_model::LinearOscillator;
use grazing_theorems::from_map::GrazingOrbit;
use grazing_theorems::{GrazingState, Resonance, ResonantPoint};

use crate::outcome::CheckResult;
use crate::sampling::Sampler;
use crate::tally::Deviations;

type Failure = Box<dyn core::error::Error + Send + Sync>;

/// The derivative that unfolds the resonance, s⁺, s⁻, c_SN and c_PD.
type Quantities = [f64; 5];

/// The general theory with A, b, ξ_p and their derivatives along the grazing curve from the numerical P_global.
fn numerical(resonance: &Resonance) -> Result<Quantities, Failure> {
    let (theory, grazing) = (resonance.grazing().oscillator(), resonance.grazing());
    let oscillator = LinearOscillator::new(
        theory.damping_ratio(),
        theory.coefficient_of_restitution(),
        grazing.amplitude(),
        grazing.forcing_frequency(),
    )?;
    let point: ResonantPoint =
        GrazingOrbit::find(&oscillator, grazing.phase())?.resonant_point(resonance.loops())?;
    let stability = point.stability_coefficients();
    Ok([
        point.unfolding.derivative(),
        stability.plus,
        stability.minus,
        point.saddle_node_coefficient(),
        point.period_doubling_coefficient(),
    ])
}

/// The formulas as printed, with E standing for E_p where the free motion makes an odd number of half turns.
fn printed(grazing: &GrazingState, p: u32, derivative: f64, e: f64) -> Quantities {
    let epsilon = grazing.oscillator().coefficient_of_restitution();
    let (omega, loops) = (grazing.forcing_frequency(), f64::from(p));
    let (lessened, raised) =
        ((1.0 - epsilon * e) * (1.0 - epsilon * e), (1.0 + epsilon * e) * (1.0 + epsilon * e));
    let quotient = (1.0 + epsilon) * e / ((1.0 - epsilon * e) * (1.0 + e));
    let sn = -2.0 * PI * PI * loops * loops * grazing.amplitude() / (omega * omega) * quotient * quotient;
    let pd = -lessened * (raised + 2.0 * (1.0 + epsilon * epsilon * e * e)) / (raised * raised) * sn;
    [derivative, -lessened, raised, sn, pd]
}

/// The public functions that hold the proposition.
fn functions(resonance: &Resonance) -> Quantities {
    let stability = resonance.stability_coefficients();
    [
        resonance.unfolding().derivative(),
        stability.plus,
        stability.minus,
        resonance.saddle_node_coefficient(),
        resonance.period_doubling_coefficient(),
    ]
}

/// Holds print and functions against the numerical theory over random ζ, ε and these indices.
fn compared(
    seed: u64,
    loops: &[u32],
    indices: &[u32],
    formulas: impl Fn(&Resonance) -> Quantities,
) -> Result<Deviations, Failure> {
    let mut sampler = Sampler::new(seed);
    let mut largest = Deviations::default();
    for _ in 0..150 {
        let (p, n) = (sampler.one_of(loops), sampler.one_of(indices));
        let theory = grazing_theorems::LinearOscillator::new(
            sampler.between(0.005, 0.08),
            sampler.between(0.05, 0.95),
        )?;
        let resonance = theory.resonance(p, n)?;
        let (measured, stated, held) = (numerical(&resonance)?, formulas(&resonance), functions(&resonance));
        for i in 0..5 {
            let size = stated[i].abs().max(if i < 3 { 1.0 } else { 0.0 });
            largest.compare(measured[i], stated[i], size);
            largest.compare(held[i], stated[i], size);
        }
    }
    Ok(largest)
}

/// What jets leave: second derivatives up to 10³ rounded, relative to s^± that may be down to (1 − 0.95)².
const JETS: f64 = 1e-11;

/// pr:imp1: both parities of n.
pub(super) fn one_loop() -> CheckResult {
    let largest = compared(146, &[1], &[1, 2, 3, 4, 5, 6, 7], |resonance| {
        let grazing = resonance.grazing();
        let e = if resonance.index() % 2 == 1 { grazing.decay(1) } else { -grazing.decay(1) };
        printed(&grazing, 1, 2.0 * PI * e / grazing.forcing_frequency(), e)
    })?;
    Ok(largest.outcome(JETS, "all five formulas at random ζ and ε, n = 1 to 7, against the numerical map"))
}

/// eq:impFormula1odd.
pub(super) fn one_loop_odd() -> CheckResult {
    let largest = compared(141, &[1], &[1, 3, 5], |resonance| {
        let grazing = resonance.grazing();
        let e = grazing.decay(1);
        printed(&grazing, 1, 2.0 * PI * e / grazing.forcing_frequency(), e)
    })?;
    Ok(largest.outcome(JETS, "all five formulas at random ζ and ε, n = 1, 3, 5, against the numerical map"))
}

/// eq:impFormula1even: E₁ with the other sign, as the print has it.
pub(super) fn one_loop_even() -> CheckResult {
    let largest = compared(142, &[1], &[2, 4, 6], |resonance| {
        let grazing = resonance.grazing();
        let e = grazing.decay(1);
        printed(&grazing, 1, -2.0 * PI * e / grazing.forcing_frequency(), -e)
    })?;
    Ok(largest.outcome(JETS, "all five formulas at random ζ and ε, n = 2, 4, 6, against the numerical map"))
}

/// κ_p′ as printed.
fn detuning_derivative(resonance: &Resonance) -> f64 {
    let grazing = resonance.grazing();
    let (zeta, omega) = (grazing.oscillator().damping_ratio(), grazing.forcing_frequency());
    let omega_1 = (1.0 - zeta * zeta).sqrt();
    let sine = libm::sin(PI / f64::from(resonance.loops()));
    4.0 * PI * omega_1 / (omega * omega) * libm::exp(-2.0 * PI * zeta / omega) * sine
}

/// The formulas of proposition 3.3.
fn many_loop_formulas(resonance: &Resonance) -> Quantities {
    let (grazing, p) = (resonance.grazing(), resonance.loops());
    printed(&grazing, p, detuning_derivative(resonance), grazing.decay(p))
}

/// pr:impp: the proposition as it holds, for the s of p loops.
pub(super) fn many_loops() -> CheckResult {
    let largest = compared(143, &[2, 3, 4, 5, 6], &[1, 2, 3], many_loop_formulas)?;
    Ok(largest.outcome(
        JETS,
        "all five formulas at random ζ and ε, p = 2 to 6, n = 1, 2, 3, against the numerical map",
    ))
}

/// eq:impFormulap: with s_p^±; the print, which names s_1^±, fails for eq:c1 evaluated at the same resonance.
pub(super) fn many_loops_misprint() -> CheckResult {
    let largest = compared(144, &[2, 3, 4, 5, 6], &[1, 2, 3], many_loop_formulas)?;
    let mut sampler = Sampler::new(145);
    let mut named = Deviations::default();
    for _ in 0..50 {
        let theory = grazing_theorems::LinearOscillator::new(
            sampler.between(0.005, 0.08),
            sampler.between(0.05, 0.95),
        )?;
        let resonance = theory.resonance(sampler.one_of(&[2, 3, 4]), 1)?;
        let grazing = resonance.grazing();
        let point = grazing.grazing_point();
        // s_1^± of eq:c1 at this frequency.
        let (a11, a22) = (point.map.a.m11, point.map.a.m22);
        let phi = point.phi * point.phi;
        let alpha_omega = point.alpha() * point.forcing_frequency;
        let curvature =
            alpha_omega * alpha_omega * grazing.second_phase_derivative(1) / ((1.0 - a22) * point.gamma);
        let [_, plus, minus, ..] = many_loop_formulas(&resonance);
        named.compare((1.0 - a22) * (a11 * phi - 1.0) + curvature, plus, 1.0);
        named.compare((1.0 + a22) * (a11 * phi + 1.0) + curvature, minus, 1.0);
    }
    let outcome = largest
        .outcome(JETS, "s^± of p = 2 to 6 loops against the numerical map; the print against s_1^± of eq:c1");
    Ok(outcome.against_print(named.measure(JETS)))
}
