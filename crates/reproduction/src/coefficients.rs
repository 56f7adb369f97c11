//! The table of coefficients: by closed form, by the general theorem, and by measurement on the continued curves.

use grazing_continuation::resonance::ResonantGrazingPoint;
use grazing_model::LinearOscillator;
use grazing_theorems::Resonance;
use grazing_unfold::Diagram;
use grazing_unfold::verdict::{self, Coefficient, Verdict};
use rayon::prelude::*;

use crate::StudyError;
use crate::parameters::Parameters;
use crate::table::{Table, columns, row};

/// The quadratic coefficients at one resonance, reached in three ways.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coefficients {
    /// Number of loops p.
    pub loops: u32,
    /// The integer n of the resonance.
    pub n: u32,
    /// ω*.
    pub frequency: f64,
    /// 𝒜_graz(ω*).
    pub amplitude: f64,
    /// s_p⁺ and s_p⁻ by closed form (Propositions 3.2, 3.3).
    pub stability: [f64; 2],
    /// c_SN,p and c_PD,p by closed form.
    pub closed_form: [f64; 2],
    /// c_SN,p and c_PD,p by Theorems 2.4, 2.5 from derivatives of the numerical P_global, and as limits of μ/η² on the continued
    /// curves, where these can be measured.
    pub measured: [Coefficient; 2],
}

impl Coefficients {
    fn of(closed_form: &Resonance, located: &ResonantGrazingPoint<LinearOscillator>) -> Self {
        let stability = closed_form.stability_coefficients();
        Self {
            loops: closed_form.loops(),
            n: closed_form.index(),
            frequency: closed_form.forcing_frequency(),
            amplitude: closed_form.grazing().amplitude(),
            stability: [stability.plus, stability.minus],
            closed_form: [closed_form.saddle_node_coefficient(), closed_form.period_doubling_coefficient()],
            measured: verdict::coefficients(located),
        }
    }

    /// What could not be measured, or is not as by the theorem, with the reason.
    pub fn doubts(&self) -> impl Iterator<Item = String> {
        ["c_SN", "c_PD"].into_iter().zip(&self.measured).filter_map(|(name, measured)| {
            let verdict = measured.verdict();
            let (told, reason) = (verdict.name(), verdict.reason());
            (verdict != Verdict::Agree)
                .then(|| format!("{name} at p = {}, n = {} {told}: {reason}", self.loops, self.n))
        })
    }
}

/// The coefficients at all resonances of Figure 7, by p and increasing frequency.
pub(crate) fn compute(
    parameters: &Parameters,
    diagram: &Diagram<LinearOscillator>,
) -> Result<Vec<Coefficients>, StudyError> {
    let theory = parameters.oscillator()?;
    let resonances: Vec<_> = diagram.unfolding().collect();
    resonances
        .into_par_iter()
        .map(|(found, located)| Ok(Coefficients::of(&theory.resonance(found.loops, found.n)?, located)))
        .collect()
}

/// `coefficients.csv`.
pub(crate) fn table(coefficients: &[Coefficients]) -> Result<Table, StudyError> {
    let mut columns = columns! {
        "p": 0, "n": 0, "omega_star": 0.0, "amplitude_graz": 0.0, "s_plus": 0.0, "s_minus": 0.0,
        "c_sn": 0.0, "c_pd": 0.0, "c_sn_theorem": 0.0, "c_pd_theorem": 0.0, "c_sn_fit": 0.0, "c_pd_fit": 0.0,
        "c_sn_fit_error": 0.0, "c_pd_fit_error": 0.0, "sn_verdict": "", "sn_reason": "", "pd_verdict": "", "pd_reason": "",
    };
    for c in coefficients {
        let [sn, pd] = &c.measured;
        let verdicts = [sn.verdict(), pd.verdict()];
        columns.push(row![
            c.loops,
            c.n,
            c.frequency,
            c.amplitude,
            c.stability[0],
            c.stability[1],
            c.closed_form[0],
            c.closed_form[1],
            sn.theorem.value,
            pd.theorem.value,
            sn.measured().value,
            pd.measured().value,
            sn.measured().error,
            pd.measured().error,
            verdicts[0].name(),
            verdicts[0].reason(),
            verdicts[1].name(),
            verdicts[1].reason(),
        ]);
    }
    Ok(columns.finish("coefficients")?)
}
