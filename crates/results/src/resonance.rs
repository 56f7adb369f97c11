//! What tables of resonances have in common.

use grazing_theorems::hypothesis::Hypothesis;
use grazing_theorems::{ResonantGrazing, ResonantPoint, Unfolding};
use serde::{Deserialize, Serialize};

use crate::plane::SpecialPoint;
use crate::{row, rows, tables};

rows! {
    /// The coefficients of the SN and PD curves that leave a resonance, by Theorem 2.4 or 2.5; NaN where its hypotheses fail.
    #[derive(Serialize, Deserialize)]
    Coefficients {
        s_plus: f64 = S_PLUS,
        s_minus: f64 = S_MINUS,
        c_sn: f64 = C_SN,
        c_pd: f64 = C_PD,
    }

    /// The accuracy of the coefficients by the theorem, and the same as measured on continued curves; NaN where that was not done.
    #[derive(Serialize, Deserialize)]
    Measured {
        c_sn_error: f64 = C_SN_ERROR,
        c_pd_error: f64 = C_PD_ERROR,
        c_sn_fit: f64 = C_SN_FIT,
        c_pd_fit: f64 = C_PD_FIT,
    }

    /// The quantities of a resonance from which its coefficients follow.
    #[derive(Serialize, Deserialize)]
    Quantities {
        tau: f64 = TAU,
        delta: f64 = DELTA,
        alpha: f64 = ALPHA,
        beta: f64 = BETA,
        gamma: f64 = GAMMA,
        xi: f64 = XI,
        a12_prime: f64 = A12_PRIME,
        kappa_prime: f64 = KAPPA_PRIME,
    }

    /// A resonance at which the theorem holds, with the results for its SN and PD curves, and c_2GZ as
    /// measured.
    CoefficientRow {
        loops: u32 = LOOPS,
        wall: u32 = WALL,
        n: u32 = RESONANCE_INDEX,
        secondary: f64 = SECONDARY_AT_RESONANCE,
        primary: f64 = PRIMARY_AT_GRAZING,
        coefficients: Coefficients,
        measured: Measured,
        c_sn_fit_error: f64 = C_SN_FIT_ERROR,
        c_pd_fit_error: f64 = C_PD_FIT_ERROR,
        sn_verdict: &'static str = SN_VERDICT,
        sn_reason: String = SN_REASON,
        pd_verdict: &'static str = PD_VERDICT,
        pd_reason: String = PD_REASON,
        quantities: Quantities,
        sigma: f64 = SIGMA,
        pd_criticality: f64 = PD_CRITICALITY,
        c_2gz: f64 = C_2GZ,
        c_2gz_fit: f64 = C_2GZ_FIT,
        sn_as_simulated: &'static str = SN_AS_SIMULATED,
        sn_simulation_reason: String = SN_SIMULATION_REASON,
        pd_as_simulated: &'static str = PD_AS_SIMULATED,
        pd_simulation_reason: String = PD_SIMULATION_REASON,
    }

    /// A resonance, whether or not the theorem holds there.
    CheckedResonance {
        at: SpecialPoint,
        coefficients: Coefficients,
        holds: bool = THEOREM_HOLDS,
        failing: String = FAILING,
    }

    /// A hypothesis of the theorem at a resonance, whether or not all of them hold.
    CheckedHypothesis {
        loops: u32 = LOOPS,
        wall: u32 = WALL,
        n: u32 = RESONANCE_INDEX,
        secondary: f64 = SECONDARY,
        primary: f64 = PRIMARY,
        theorem: &'static str = THEOREM,
        hypothesis: Hypothesis,
    }
}

row! { Hypothesis, |own| {} [
    HYPOTHESIS = own.statement().to_string(),
    HYPOTHESIS_VALUE = own.value,
    HOLDS = own.holds(),
] }

tables! {
    /// Results at resonances.
    AtResonances: Dimensioned {
        coefficients: CoefficientRow = "coefficients",
            "a resonance at which Theorem 2.4 (p = 1) or 2.5 (p ≥ 2) holds",
        hypotheses: CheckedHypothesis = "hypotheses",
            "a hypothesis of the theorem at a resonance, whether or not it holds",
    }
}

impl From<&ResonantPoint> for Coefficients {
    fn from(point: &ResonantPoint) -> Self {
        let stability = point.stability_coefficients();
        let theorem = ResonantGrazing::check(point, f64::INFINITY).ok();
        let [c_sn, c_pd] = theorem.map_or([f64::NAN; 2], |theorem| {
            [theorem.saddle_node(), theorem.period_doubling()].map(|curve| curve.coefficient)
        });
        Self { s_plus: stability.plus, s_minus: stability.minus, c_sn, c_pd }
    }
}

impl Measured {
    /// Nothing was measured.
    pub const NOT: Self =
        Self { c_sn_error: f64::NAN, c_pd_error: f64::NAN, c_sn_fit: f64::NAN, c_pd_fit: f64::NAN };
}

impl From<&ResonantPoint> for Quantities {
    fn from(point: &ResonantPoint) -> Self {
        let (grazing, [a12_prime, kappa_prime]) = (&point.grazing, slopes(point));
        Self {
            tau: grazing.map.trace(),
            delta: grazing.map.determinant(),
            alpha: grazing.alpha(),
            beta: grazing.map.transversality(),
            gamma: grazing.gamma,
            xi: point.second_phase_derivative,
            a12_prime,
            kappa_prime,
        }
    }
}

/// a₁₂' for p = 1 or κ_p' for p ≥ 2; the other is NaN.
pub fn slopes(point: &ResonantPoint) -> [f64; 2] {
    let Unfolding { loops, derivative } = point.unfolding;
    if loops == 1 { [derivative, f64::NAN] } else { [f64::NAN, derivative] }
}
