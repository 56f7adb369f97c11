//! The table of coefficients: by closed form, by the general theorem, and measured on the continued
//! curves.

use grazing_continuation::bifurcation::Pair;
use grazing_results::{row, tables};
use grazing_theorems::Resonance;
use grazing_theorems::unfolding::StabilityCoefficients;
use grazing_unfold::verdict::{Coefficient, Verdict};

/// The quadratic coefficients at one resonance, obtained in three ways.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ComparedCoefficients {
    /// Number of loops p.
    pub loops: u32,
    /// The integer n of the resonance.
    pub n: u32,
    /// The resonant frequency ω*.
    pub frequency: f64,
    /// The grazing amplitude 𝒜_graz(ω*).
    pub amplitude: f64,
    /// s_p⁺ and s_p⁻ by closed form (Propositions 3.2, 3.3).
    pub stability: StabilityCoefficients,
    /// c_SN,p and c_PD,p by closed form.
    pub closed_form: Pair<f64>,
    /// c_SN,p and c_PD,p by Theorems 2.4, 2.5 from derivatives of the numerical P_global, and as
    /// limits of μ/η² on the continued curves, where these can be measured.
    pub measured: Pair<Coefficient>,
}

tables! {
    /// The coefficients at all resonances of Figure 7, by p and increasing frequency.
    CoefficientTable {
        rows: ComparedCoefficients = "coefficients", "a resonance of Figure 7",
    }
}

row! { ComparedCoefficients, |c| {
    let Pair { saddle_node: sn, period_doubling: pd } = c.measured;
    let [sn_verdict, pd_verdict] = c.measured.map(|coefficient| coefficient.verdict()).into_array();
} [
    LOOPS = c.loops,
    RESONANCE_INDEX = c.n,
    SECONDARY_AT_RESONANCE = c.frequency,
    PRIMARY_AT_GRAZING = c.amplitude,
    S_PLUS = c.stability.plus,
    S_MINUS = c.stability.minus,
    C_SN_CLOSED_FORM = c.closed_form.saddle_node,
    C_PD_CLOSED_FORM = c.closed_form.period_doubling,
    C_SN = sn.theorem.value,
    C_PD = pd.theorem.value,
    C_SN_FIT = sn.measured().value,
    C_PD_FIT = pd.measured().value,
    C_SN_FIT_ERROR = sn.measured().error,
    C_PD_FIT_ERROR = pd.measured().error,
    SN_VERDICT = sn_verdict.name(),
    SN_REASON = sn_verdict.reason(),
    PD_VERDICT = pd_verdict.name(),
    PD_REASON = pd_verdict.reason(),
] }

impl ComparedCoefficients {
    /// Whether theorem and curve contradict each other.
    pub fn contradict(&self) -> bool {
        self.measured.named().iter().any(|(_, measured)| measured.verdict() == Verdict::Contradict)
    }

    /// Descriptions of coefficients that could not be measured, or that disagree with the theorem, with
    /// the reason.
    pub fn doubts(&self) -> impl Iterator<Item = String> {
        self.measured.named().into_iter().filter_map(|(bifurcation, measured)| {
            let verdict = measured.verdict();
            let (name, told, reason) = (bifurcation.name(), verdict.name(), verdict.reason());
            (verdict != Verdict::Agree)
                .then(|| format!("c_{name} at p = {}, n = {} {told}: {reason}", self.loops, self.n))
        })
    }
}

/// c_SN,p and c_PD,p by closed form.
pub(crate) fn closed_form_coefficients(resonance: &Resonance) -> Pair<f64> {
    Pair {
        saddle_node: resonance.saddle_node_coefficient(),
        period_doubling: resonance.period_doubling_coefficient(),
    }
}
