//! The table of coefficients: by closed form, by the general theorem, and by measurement on the continued curves.

use grazing_continuation::fit::Estimate;
use grazing_continuation::resonance::ResonantGrazingPoint;
use grazing_model::LinearOscillator;
use grazing_theorems::Resonance;
use grazing_unfold::Diagram;
use grazing_unfold::verdict;
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
    /// c_SN,p and c_PD,p by Theorems 2.4, 2.5 from derivatives of the numerical P_global.
    pub theorem: [f64; 2],
    /// c_SN,p and c_PD,p as limits of μ/η² on the continued curves.
    pub fit: [Estimate; 2],
}

impl Coefficients {
    fn of(
        closed_form: &Resonance,
        located: &ResonantGrazingPoint<LinearOscillator>,
    ) -> Result<Self, StudyError> {
        let (loops, n) = (closed_form.loops(), closed_form.index());
        let [saddle_node, period_doubling] = verdict::coefficients(located);
        let theorem = [saddle_node.theorem.value, period_doubling.theorem.value];
        let fitted = |curve, coefficient: verdict::Coefficient| match coefficient.fit {
            Ok(fit) => Ok(fit.coefficient),
            Err(source) => Err(StudyError::Fit { curve, loops, n, source }),
        };
        let stability = closed_form.stability_coefficients();
        Ok(Self {
            loops,
            n,
            frequency: closed_form.forcing_frequency(),
            amplitude: closed_form.grazing().amplitude(),
            stability: [stability.plus, stability.minus],
            closed_form: [closed_form.saddle_node_coefficient(), closed_form.period_doubling_coefficient()],
            theorem,
            fit: [fitted("SN", saddle_node)?, fitted("PD", period_doubling)?],
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
        .map(|(found, located)| Coefficients::of(&theory.resonance(found.loops, found.n)?, located))
        .collect()
}

/// `coefficients.csv`.
pub(crate) fn table(coefficients: &[Coefficients]) -> Result<Table, StudyError> {
    let mut columns = columns! {
        "p": 0, "n": 0, "omega_star": 0.0, "amplitude_graz": 0.0, "s_plus": 0.0, "s_minus": 0.0,
        "c_sn": 0.0, "c_pd": 0.0, "c_sn_theorem": 0.0, "c_pd_theorem": 0.0, "c_sn_fit": 0.0, "c_pd_fit": 0.0,
        "c_sn_fit_error": 0.0, "c_pd_fit_error": 0.0,
    };
    for c in coefficients {
        columns.push(row![
            c.loops,
            c.n,
            c.frequency,
            c.amplitude,
            c.stability[0],
            c.stability[1],
            c.closed_form[0],
            c.closed_form[1],
            c.theorem[0],
            c.theorem[1],
            c.fit[0].value,
            c.fit[1].value,
            c.fit[0].error,
            c.fit[1].error,
        ]);
    }
    Ok(columns.finish("coefficients")?)
}
