//! Theorems 2.2 to 2.5 in action: tables of their predictions and of computed results.

use grazing_claims::outcome::CheckError;
use grazing_claims::sweep::resonant::CurveRow;
use grazing_claims::sweep::{
    CaseVerdict, Existence, GenericRow, ResonantRow, generic_cases, resonant_cases, rows,
};
use grazing_results::{Cell, Tone, row, tables};
use grazing_theorems::Side;
use grazing_theorems::hypothesis::{Hypothesis, Quantity};

use crate::{Study, StudyError};

tables! {
    /// Comparison of the four theorems with continuation and simulation.
    TheoremsInAction {
        /// Theorems 2.2 and 2.3, a row for each oscillator at grazing.
        generic: Generic = "theorems_generic", "an oscillator at grazing, independent of the parameter file",
        /// Theorems 2.4 and 2.5, a row for each resonance.
        resonant: Resonant = "theorems_resonant", "an oscillator at a resonance, independent of the parameter file",
    }
}

/// An oscillator at grazing, for Theorems 2.2 and 2.3.
#[derive(Clone, Debug)]
pub struct Generic(pub GenericRow);

/// An oscillator at a resonance, for Theorems 2.4 and 2.5.
#[derive(Clone, Debug)]
pub struct Resonant(pub ResonantRow);

impl Study {
    /// Compares Theorems 2.2 to 2.5 with continuation and simulation for many oscillators; the parameters
    /// of this study are not used.
    ///
    /// # Errors
    /// A case could not be computed.
    pub fn theorems_in_action(&self) -> Result<TheoremsInAction, StudyError> {
        let (generic, resonant) = (generic_cases()?, resonant_cases()?);
        let what = "theorems 2.2 to 2.5";
        self.progress.begin(what, (generic.len() + resonant.len()) as u64);
        let step = || self.progress.step(what);
        let failed = |failure: CheckError| StudyError::Sweep(failure.to_string());
        let generic = rows(&generic, GenericRow::of, step).map_err(failed)?;
        let resonant = rows(&resonant, ResonantRow::of, step).map_err(failed)?;
        self.progress.end(what);
        Ok(TheoremsInAction {
            generic: generic.into_iter().map(Generic).collect(),
            resonant: resonant.into_iter().map(Resonant).collect(),
        })
    }
}

/// The value of a quantity in a hypothesis of the theorem; NaN if there is no such hypothesis.
fn value(hypotheses: &[Hypothesis], quantity: Quantity) -> f64 {
    hypotheses.iter().find(|found| found.quantity == quantity).map_or(f64::NAN, |found| found.value)
}

const OF_MU: [&str; 2] = ["mu > 0", "mu < 0"];
const OF_ETA: [&str; 2] = ["eta > 0", "eta < 0"];

/// The prediction of a theorem, which may make none.
fn predicted(side: Option<Side>, names: [&'static str; 2]) -> &'static str {
    side.map_or("silent", |side| seen(Existence::On(side), names))
}

fn seen(existence: Existence, names: [&'static str; 2]) -> &'static str {
    match existence {
        Existence::On(Side::Positive) => names[0],
        Existence::On(Side::Negative) => names[1],
        Existence::Nowhere => "none",
        Existence::Unclear => "unclear",
    }
}

row! { Generic, |this| {
    let r = &this.0;
    let value = |quantity| value(&r.hypotheses, quantity);
    let map = &r.point.map;
    let [first_order, exact, fit] = r.slopes;
} [
    THEOREM = if r.case.loops == 1 { "2.2" } else { "2.3" },
    ZETA = r.case.zeta,
    EPSILON = r.case.epsilon,
    LOOPS = r.case.loops,
    RESONANCE_INDEX = r.case.n,
    OMEGA = r.case.omega,
    TAU = map.trace(),
    DELTA = map.determinant(),
    TRAPESIUM_MARGIN = value(Quantity::StabilityMargin),
    ALPHA = r.point.alpha(),
    BETA = map.transversality(),
    A12 = map.a.m12,
    A12_ALPHA = (map.a.m12 * r.point.alpha()),
    TAU_MINUS_H = value(Quantity::AdmissibilityMargin),
    A12_BETA = value(Quantity::OffDiagonalTimesTransversality),
    BETA_KAPPA = value(Quantity::TransversalityTimesDetuning),
    PREDICTED = predicted(r.predicted, OF_MU),
    FIRST_ORDER = seen(r.first_order, OF_MU),
    CONTINUATION = seen(r.continued, OF_MU),
    SIMULATION = seen(r.simulated, OF_MU),
    UNSTABLE_BRANCH = r.unstable[0],
    UNSTABLE_SIMULATION = r.unstable[1],
    DY_DMU = first_order[0],
    DZ_DMU = first_order[1],
    DY_DMU_EXACT = exact[0],
    DZ_DMU_EXACT = exact[1],
    DY_DMU_FIT = fit[0],
    DZ_DMU_FIT = fit[1],
    SLOPE_DIFFERENCE = r.slope_difference(),
    VERDICT = cell(r.verdict()),
    REASON = r.verdict().reason().to_owned(),
] }

row! { Resonant, |this| {
    let r = &this.0;
    let stability = r.point.stability_coefficients();
    let map = &r.point.grazing.map;
    let [sn, pd] = &r.curves;
} [
    THEOREM = if r.case.loops == 1 { "2.4" } else { "2.5" },
    ZETA = r.case.zeta,
    EPSILON = r.case.epsilon,
    LOOPS = r.case.loops,
    RESONANCE_INDEX = r.case.n,
    RATIO = match (r.case.loops, r.case.negative) {
        (1, _) => "n/2",
        (_, false) => "n + 1/(2p)",
        (_, true) => "n - 1/(2p)",
    },
    SECONDARY_AT_RESONANCE = r.case.omega,
    PRIMARY_AT_GRAZING = r.amplitude,
    E_P = r.decay,
    EPSILON_E_P = (r.case.epsilon * r.decay),
    TRAPESIUM_MARGIN = value(&r.hypotheses, Quantity::StabilityMargin),
    ALPHA = r.point.grazing.alpha(),
    BETA = map.transversality(),
    A12_ALPHA = (map.a.m12 * r.point.grazing.alpha()),
    UNFOLDING = r.point.unfolding.derivative,
    S_PLUS = stability.plus,
    S_MINUS = stability.minus,
    SN_PREDICTED = predicted(sn.predicted, OF_ETA),
    SN_CONTINUATION = continued(sn),
    SN_SIMULATION = seen(sn.simulated, OF_ETA),
    SN_CROSSED = sn.crossed,
    SN_STABILITY_CHANGES = yes_or_no(sn.stability_changes),
    C_SN = sn.theorem,
    C_SN_CLOSED_FORM = sn.proposition,
    C_SN_EXACT = sn.quadratic_equation,
    C_SN_FIT = fit(sn)[0],
    C_SN_FIT_ERROR = fit(sn)[1],
    C_SN_DIFFERENCE = sn.difference(),
    C_SN_FIT_DIFFERENCE = sn.fit_difference(),
    PD_PREDICTED = predicted(pd.predicted, OF_ETA),
    PD_CONTINUATION = continued(pd),
    PD_SIMULATION = seen(pd.simulated, OF_ETA),
    PD_CROSSED = pd.crossed,
    PD_STABILITY_CHANGES = yes_or_no(pd.stability_changes),
    C_PD = pd.theorem,
    C_PD_CLOSED_FORM = pd.proposition,
    C_PD_EXACT = pd.quadratic_equation,
    C_PD_FIT = fit(pd)[0],
    C_PD_FIT_ERROR = fit(pd)[1],
    C_PD_DIFFERENCE = pd.difference(),
    C_PD_FIT_DIFFERENCE = pd.fit_difference(),
    VERDICT = cell(r.verdict()),
    REASON = r.verdict().reason().to_owned(),
] }

fn cell(verdict: CaseVerdict) -> Cell {
    let tone = match verdict {
        CaseVerdict::Agreement => Tone::Passed,
        CaseVerdict::Explained(_) => Tone::Unchecked,
        CaseVerdict::Unexplained => Tone::Failed,
    };
    Cell::Verdict(verdict.name(), tone)
}

fn continued(curve: &CurveRow) -> &'static str {
    curve.continued.map_or("", |existence| seen(existence, OF_ETA))
}

fn yes_or_no(answer: Option<bool>) -> &'static str {
    answer.map_or("", |yes| if yes { "yes" } else { "no" })
}

/// The measured coefficient and its estimated error.
fn fit(curve: &CurveRow) -> [f64; 2] {
    curve.fit.map_or([f64::NAN; 2], |fit| [fit.value, fit.error])
}
