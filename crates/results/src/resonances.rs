//! Coefficients at resonances, what the theorems ask there, and what they are made of along the grazing curve.

use crate::table::rows;

rows! {
    /// A resonance of the paper's oscillator, with the coefficients reached in three ways.
    PaperResonance {
        loops: u32 = LOOPS,
        n: u32 = RESONANCE_INDEX,
        secondary: f64 = SECONDARY_AT_RESONANCE,
        primary: f64 = PRIMARY_AT_GRAZING,
        s_plus: f64 = S_PLUS,
        s_minus: f64 = S_MINUS,
        c_sn: f64 = C_SN_CLOSED_FORM,
        c_pd: f64 = C_PD_CLOSED_FORM,
        c_sn_theorem: f64 = C_SN_THEOREM,
        c_pd_theorem: f64 = C_PD_THEOREM,
        c_sn_fit: f64 = C_SN_FIT,
        c_pd_fit: f64 = C_PD_FIT,
        c_sn_fit_error: f64 = C_SN_FIT_ERROR,
        c_pd_fit_error: f64 = C_PD_FIT_ERROR,
        sn_verdict: &'static str = SN_VERDICT,
        sn_reason: String = SN_REASON,
        pd_verdict: &'static str = PD_VERDICT,
        pd_reason: String = PD_REASON,
    }

    /// A resonance of any oscillator at which Theorem 2.4 (p = 1) or 2.5 (p ≥ 2) holds.
    Resonance {
        loops: u32 = LOOPS,
        n: u32 = RESONANCE_INDEX,
        secondary: f64 = SECONDARY_AT_RESONANCE,
        primary: f64 = PRIMARY_AT_GRAZING,
        s_plus: f64 = S_PLUS,
        s_minus: f64 = S_MINUS,
        c_sn: f64 = C_SN,
        c_pd: f64 = C_PD,
        c_sn_error: f64 = C_SN_ERROR,
        c_pd_error: f64 = C_PD_ERROR,
        c_sn_fit: f64 = C_SN_FIT,
        c_pd_fit: f64 = C_PD_FIT,
        c_sn_fit_error: f64 = C_SN_FIT_ERROR,
        c_pd_fit_error: f64 = C_PD_FIT_ERROR,
        sn_verdict: &'static str = SN_VERDICT,
        sn_reason: String = SN_REASON,
        pd_verdict: &'static str = PD_VERDICT,
        pd_reason: String = PD_REASON,
        tau: f64 = TAU,
        delta: f64 = DELTA,
        alpha: f64 = ALPHA,
        beta: f64 = BETA,
        gamma: f64 = GAMMA,
        xi: f64 = XI,
        a12_prime: f64 = A12_PRIME,
        kappa_prime: f64 = KAPPA_PRIME,
        pd_criticality: f64 = PD_CRITICALITY,
        sn_as_simulated: &'static str = SN_AS_SIMULATED,
        sn_simulation_reason: String = SN_SIMULATION_REASON,
        pd_as_simulated: &'static str = PD_AS_SIMULATED,
        pd_simulation_reason: String = PD_SIMULATION_REASON,
    }

    /// A hypothesis of the theorem at a resonance, whether or not all of them hold.
    Asked {
        loops: u32 = LOOPS,
        n: u32 = RESONANCE_INDEX,
        secondary: f64 = SECONDARY,
        primary: f64 = PRIMARY,
        theorem: &'static str = RESONANT_THEOREM,
        hypothesis: String = HYPOTHESIS,
        value: f64 = HYPOTHESIS_VALUE,
        holds: bool = HOLDS,
    }

    /// A point of the grazing curve, with the grazing orbit and the Poincaré map around it.
    GrazingPoint {
        arc: u32 = ARC,
        secondary: f64 = SECONDARY,
        primary: f64 = PRIMARY,
        phase: f64 = GRAZING_PHASE,
        frequency: f64 = FREQUENCY,
        a11: f64 = A11,
        a12: f64 = A12,
        a21: f64 = A21,
        a22: f64 = A22,
        b1: f64 = B1,
        b2: f64 = B2,
        tau: f64 = TAU,
        delta: f64 = DELTA,
        alpha: f64 = ALPHA,
        beta: f64 = BETA,
        gamma: f64 = GAMMA,
        phi: f64 = PHI,
        psi: f64 = PSI,
        stable: bool = STABLE,
        admissible: bool = ADMISSIBLE,
    }

    /// A point of the grazing curve and a p, with what depends on p.
    GrazingLoops {
        loops: u32 = LOOPS,
        arc: u32 = ARC,
        secondary: f64 = SECONDARY,
        primary: f64 = PRIMARY,
        a12: f64 = A12,
        kappa: f64 = KAPPA,
        a12_prime: f64 = A12_PRIME,
        kappa_prime: f64 = KAPPA_PRIME,
        xi: f64 = XI,
        s_plus: f64 = S_PLUS,
        s_minus: f64 = S_MINUS,
    }
}
