//! The table of coefficients: by closed form, by the general theorem, and by measurement on the continued curves.

use grazing_continuation::bifurcation::Pair;
use grazing_continuation::resonance::ResonantGrazingPoint;
use grazing_model::LinearOscillator;
use grazing_results::resonances::PaperResonance;
use grazing_results::{Names, Table};
use grazing_theorems::Resonance;
use grazing_theorems::unfolding::StabilityCoefficients;
use grazing_unfold::Diagram;
use grazing_unfold::verdict::{self, Coefficient, Verdict};
use rayon::prelude::*;

use crate::StudyError;
use crate::parameters::Parameters;

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
    pub stability: StabilityCoefficients,
    /// c_SN,p and c_PD,p by closed form.
    pub closed_form: Pair<f64>,
    /// c_SN,p and c_PD,p by Theorems 2.4, 2.5 from derivatives of the numerical P_global, and as limits of μ/η² on the continued
    /// curves, where these can be measured.
    pub measured: Pair<Coefficient>,
}

impl Coefficients {
    fn of(closed_form: &Resonance, located: &ResonantGrazingPoint<LinearOscillator>) -> Self {
        Self {
            loops: closed_form.loops(),
            n: closed_form.index(),
            frequency: closed_form.forcing_frequency(),
            amplitude: closed_form.grazing().amplitude(),
            stability: closed_form.stability_coefficients(),
            closed_form: Pair {
                saddle_node: closed_form.saddle_node_coefficient(),
                period_doubling: closed_form.period_doubling_coefficient(),
            },
            measured: verdict::coefficients(located),
        }
    }

    /// What could not be measured, or is not as by the theorem, with the reason.
    pub fn doubts(&self) -> impl Iterator<Item = String> {
        self.measured.named().into_iter().filter_map(|(bifurcation, measured)| {
            let verdict = measured.verdict();
            let (name, told, reason) = (bifurcation.name(), verdict.name(), verdict.reason());
            (verdict != Verdict::Agree)
                .then(|| format!("c_{name} at p = {}, n = {} {told}: {reason}", self.loops, self.n))
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

impl From<&Coefficients> for PaperResonance {
    fn from(known: &Coefficients) -> Self {
        let Pair { saddle_node: sn, period_doubling: pd } = known.measured;
        let verdicts = known.measured.map(|coefficient| coefficient.verdict());
        Self {
            loops: known.loops,
            n: known.n,
            secondary: known.frequency,
            primary: known.amplitude,
            s_plus: known.stability.plus,
            s_minus: known.stability.minus,
            c_sn: known.closed_form.saddle_node,
            c_pd: known.closed_form.period_doubling,
            c_sn_theorem: sn.theorem.value,
            c_pd_theorem: pd.theorem.value,
            c_sn_fit: sn.measured().value,
            c_pd_fit: pd.measured().value,
            c_sn_fit_error: sn.measured().error,
            c_pd_fit_error: pd.measured().error,
            sn_verdict: verdicts.saddle_node.name(),
            sn_reason: verdicts.saddle_node.reason(),
            pd_verdict: verdicts.period_doubling.name(),
            pd_reason: verdicts.period_doubling.reason(),
        }
    }
}

/// `coefficients.csv`.
pub(crate) fn table(coefficients: &[Coefficients]) -> Table {
    let rows: Vec<PaperResonance> = coefficients.iter().map(PaperResonance::from).collect();
    Table::new("coefficients", &Names::of_the_paper(), &rows)
}
