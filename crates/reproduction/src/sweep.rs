//! Theorems 2.2 to 2.5 in action: the tables of what they predict and what is seen.

use grazing_claims::sweep::resonant::CurveRow;
use grazing_claims::sweep::{
    Existence, GenericRow, ResonantRow, generic_cases, generic_rows, resonant_cases, resonant_rows,
};
use grazing_results::theorems::{Generic, Resonant};
use grazing_results::{Names, Table};
use grazing_theorems::Side;
use grazing_theorems::hypothesis::Quantity;
use grazing_unfold::progress::Progress;

use crate::StudyError;

/// The four theorems against continuation and simulation.
#[derive(Clone, Debug)]
pub struct TheoremsInAction {
    /// Theorems 2.2 and 2.3, a row for each oscillator at grazing.
    pub generic: Vec<Generic>,
    /// Theorems 2.4 and 2.5, a row for each resonance.
    pub resonant: Vec<Resonant>,
}

impl TheoremsInAction {
    pub(crate) fn compute(progress: &dyn Progress) -> Result<Self, StudyError> {
        let generic = generic_cases()?;
        let resonant = resonant_cases()?;
        let what = "theorems 2.2 to 2.5";
        progress.begin(what, (generic.len() + resonant.len()) as u64);
        let step = || progress.step(what);
        let generic = generic_rows(&generic, step)?.iter().map(self::generic).collect();
        let resonant = resonant_rows(&resonant, step)?.iter().map(self::resonant).collect();
        progress.end(what);
        Ok(Self { generic, resonant })
    }

    /// The tables in the order of their names.
    pub fn tables(&self) -> Vec<Table> {
        let names = Names::of_the_paper();
        vec![
            Table::new("theorems_generic", &names, &self.generic),
            Table::new("theorems_resonant", &names, &self.resonant),
        ]
    }
}

/// What a theorem says that may be silent.
fn predicted(side: Option<Side>, names: [&'static str; 2]) -> &'static str {
    match side {
        Some(Side::Positive) => names[0],
        Some(Side::Negative) => names[1],
        None => "silent",
    }
}

const OF_MU: [&str; 2] = ["mu > 0", "mu < 0"];
const OF_ETA: [&str; 2] = ["eta > 0", "eta < 0"];

fn seen(existence: Existence, names: [&'static str; 2]) -> &'static str {
    match existence {
        Existence::On(Side::Positive) => names[0],
        Existence::On(Side::Negative) => names[1],
        Existence::Nowhere => "none",
        Existence::Unclear => "unclear",
    }
}

fn generic(r: &GenericRow) -> Generic {
    let value = |quantity| r.hypothesis(quantity).unwrap_or(f64::NAN);
    let map = &r.point.map;
    let [first_order, exact, fit] = r.slopes;
    Generic {
        theorem: r.theorem(),
        zeta: r.case.zeta,
        epsilon: r.case.epsilon,
        loops: r.case.loops,
        n: r.case.n,
        omega: r.case.omega,
        tau: map.trace(),
        delta: map.determinant(),
        trapesium_margin: value(Quantity::StabilityMargin),
        alpha: r.point.alpha(),
        beta: map.transversality(),
        a12: map.a.m12,
        a12_alpha: map.a.m12 * r.point.alpha(),
        tau_minus_h: value(Quantity::AdmissibilityMargin),
        a12_beta: value(Quantity::OffDiagonalTimesTransversality),
        beta_kappa: value(Quantity::TransversalityTimesDetuning),
        predicted: predicted(r.predicted, OF_MU),
        first_order: seen(r.first_order, OF_MU),
        continuation: seen(r.continued, OF_MU),
        simulation: seen(r.simulated, OF_MU),
        unstable_branch: r.unstable[0],
        unstable_simulation: r.unstable[1],
        dy_dmu: first_order[0],
        dz_dmu: first_order[1],
        dy_dmu_exact: exact[0],
        dz_dmu_exact: exact[1],
        dy_dmu_fit: fit[0],
        dz_dmu_fit: fit[1],
        slope_difference: r.slope_difference(),
        verdict: r.verdict.name(),
        reason: r.verdict.reason().to_owned(),
    }
}

fn resonant(r: &ResonantRow) -> Resonant {
    let stability = r.point.stability_coefficients();
    let map = &r.point.grazing.map;
    let value = |quantity| r.hypothesis(quantity).unwrap_or(f64::NAN);
    let shift = match (r.case.loops, r.case.negative) {
        (1, _) => "n/2",
        (_, false) => "n + 1/(2p)",
        (_, true) => "n - 1/(2p)",
    };
    let [sn, pd] = &r.curves;
    Resonant {
        theorem: r.theorem(),
        zeta: r.case.zeta,
        epsilon: r.case.epsilon,
        loops: r.case.loops,
        n: r.case.n,
        ratio: shift,
        omega: r.case.omega,
        amplitude: r.amplitude,
        e_p: r.decay,
        epsilon_e_p: r.rebound(),
        trapesium_margin: value(Quantity::StabilityMargin),
        alpha: r.point.grazing.alpha(),
        beta: map.transversality(),
        a12_alpha: map.a.m12 * r.point.grazing.alpha(),
        unfolding: r.point.unfolding.derivative,
        s_plus: stability.plus,
        s_minus: stability.minus,
        sn_predicted: predicted(sn.predicted, OF_ETA),
        sn_continuation: continued(sn),
        sn_simulation: seen(sn.simulated, OF_ETA),
        sn_crossed: sn.crossed,
        sn_stability_changes: yes_or_no(sn.stability_changes),
        c_sn_theorem: sn.theorem,
        c_sn: sn.proposition,
        c_sn_exact: sn.quadratic_equation,
        c_sn_fit: fit(sn)[0],
        c_sn_fit_error: fit(sn)[1],
        c_sn_difference: sn.difference(),
        c_sn_fit_difference: sn.fit_difference(),
        pd_predicted: predicted(pd.predicted, OF_ETA),
        pd_continuation: continued(pd),
        pd_simulation: seen(pd.simulated, OF_ETA),
        pd_crossed: pd.crossed,
        pd_stability_changes: yes_or_no(pd.stability_changes),
        c_pd_theorem: pd.theorem,
        c_pd: pd.proposition,
        c_pd_exact: pd.quadratic_equation,
        c_pd_fit: fit(pd)[0],
        c_pd_fit_error: fit(pd)[1],
        c_pd_difference: pd.difference(),
        c_pd_fit_difference: pd.fit_difference(),
        verdict: r.verdict.name(),
        reason: r.verdict.reason().to_owned(),
    }
}

fn continued(curve: &CurveRow) -> &'static str {
    curve.continued.map_or("", |existence| seen(existence, OF_ETA))
}

fn yes_or_no(answer: Option<bool>) -> &'static str {
    match answer {
        Some(true) => "yes",
        Some(false) => "no",
        None => "",
    }
}

/// Value and estimated error.
fn fit(curve: &CurveRow) -> [f64; 2] {
    curve.fit.map_or([f64::NAN; 2], |fit| [fit.value, fit.error])
}
