//! Theorems 2.2 to 2.5 in action: the tables of what they predict and what is seen.

use grazing_claims::sweep::generic::Existence;
use grazing_claims::sweep::resonant::CurveRow;
use grazing_claims::sweep::{
    Extent, GenericRow, ResonantRow, generic_cases, generic_rows, resonant_cases, resonant_rows,
};
use grazing_theorems::Side;
use grazing_theorems::hypothesis::Quantity;

use crate::StudyError;
use crate::table::{Columns, Table, columns, row};
use grazing_unfold::progress::Progress;

/// The four theorems against continuation and simulation.
#[derive(Clone, Debug)]
pub struct TheoremsInAction {
    /// `theorems_generic`: theorems 2.2 and 2.3, a row for each oscillator at grazing.
    pub generic: Table,
    /// `theorems_resonant`: theorems 2.4 and 2.5, a row for each resonance.
    pub resonant: Table,
}

impl TheoremsInAction {
    pub(crate) fn compute(progress: &dyn Progress) -> Result<Self, StudyError> {
        let generic = generic_cases(Extent::Whole)?;
        let resonant = resonant_cases(Extent::Whole)?;
        let what = "theorems 2.2 to 2.5";
        progress.begin(what, (generic.len() + resonant.len()) as u64);
        let step = || progress.step(what);
        let generic = generic_rows(&generic, step)?;
        let resonant = resonant_rows(&resonant, step)?;
        progress.end(what);
        Ok(Self { generic: generic_table(&generic)?, resonant: resonant_table(&resonant)? })
    }

    /// The tables in the order of their names.
    pub fn tables(self) -> Vec<Table> {
        vec![self.generic, self.resonant]
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

fn generic_table(rows: &[GenericRow]) -> Result<Table, StudyError> {
    let mut columns = columns! {
        "theorem": "", "zeta": 0.0, "epsilon": 0.0, "p": 0, "n": 0, "omega": 0.0, "tau": 0.0, "delta": 0.0,
        "trapesium_margin": 0.0, "alpha": 0.0, "beta": 0.0, "a12": 0.0, "a12_alpha": 0.0, "tau_minus_h": 0.0,
        "a12_beta": 0.0, "beta_kappa": 0.0, "predicted": "", "first_order": "", "continuation": "",
        "simulation": "", "unstable_branch": true, "unstable_simulation": true, "dy_dmu": 0.0, "dz_dmu": 0.0,
        "dy_dmu_exact": 0.0, "dz_dmu_exact": 0.0, "dy_dmu_fit": 0.0, "dz_dmu_fit": 0.0,
        "slope_difference": 0.0, "verdict": "", "reason": "",
    };
    for r in rows {
        let value = |quantity| r.hypothesis(quantity).unwrap_or(f64::NAN);
        let map = &r.point.map;
        let [first_order, exact, fit] = r.slopes;
        columns.push(row![
            r.theorem(),
            r.case.zeta,
            r.case.epsilon,
            r.case.loops,
            r.case.n,
            r.case.omega,
            map.trace(),
            map.determinant(),
            value(Quantity::StabilityMargin),
            r.point.alpha(),
            map.transversality(),
            map.a.m12,
            map.a.m12 * r.point.alpha(),
            value(Quantity::AdmissibilityMargin),
            value(Quantity::OffDiagonalTimesTransversality),
            value(Quantity::TransversalityTimesDetuning),
            predicted(r.predicted, OF_MU),
            seen(r.first_order, OF_MU),
            seen(r.continued, OF_MU),
            seen(r.simulated, OF_MU),
            r.unstable[0],
            r.unstable[1],
            first_order[0],
            first_order[1],
            exact[0],
            exact[1],
            fit[0],
            fit[1],
            r.slope_difference(),
            r.verdict.name(),
            r.verdict.reason(),
        ]);
    }
    Ok(columns.finish("theorems_generic")?)
}

fn resonant_table(rows: &[ResonantRow]) -> Result<Table, StudyError> {
    let mut columns = resonant_columns();
    for r in rows {
        let stability = r.point.stability_coefficients();
        let map = &r.point.grazing.map;
        let value = |quantity| r.hypothesis(quantity).unwrap_or(f64::NAN);
        let shift = match (r.case.loops, r.case.negative) {
            (1, _) => "n/2",
            (_, false) => "n + 1/(2p)",
            (_, true) => "n - 1/(2p)",
        };
        let [sn, pd] = &r.curves;
        columns.push(row![
            r.theorem(),
            r.case.zeta,
            r.case.epsilon,
            r.case.loops,
            r.case.n,
            shift,
            r.case.omega,
            r.amplitude,
            r.decay,
            r.rebound(),
            value(Quantity::StabilityMargin),
            r.point.grazing.alpha(),
            map.transversality(),
            map.a.m12 * r.point.grazing.alpha(),
            r.point.unfolding.derivative(),
            stability.plus,
            stability.minus,
            predicted(sn.predicted, OF_ETA),
            continued(sn),
            seen(sn.simulated, OF_ETA),
            sn.crossed,
            yes_or_no(sn.stability_changes),
            sn.theorem,
            sn.proposition,
            sn.quadratic_equation,
            fit(sn)[0],
            fit(sn)[1],
            sn.difference(),
            sn.fit_difference(),
            predicted(pd.predicted, OF_ETA),
            continued(pd),
            seen(pd.simulated, OF_ETA),
            pd.crossed,
            yes_or_no(pd.stability_changes),
            pd.theorem,
            pd.proposition,
            pd.quadratic_equation,
            fit(pd)[0],
            fit(pd)[1],
            pd.difference(),
            pd.fit_difference(),
            r.verdict.name(),
            r.verdict.reason(),
        ]);
    }
    Ok(columns.finish("theorems_resonant")?)
}

fn resonant_columns() -> Columns {
    columns! {
        "theorem": "", "zeta": 0.0, "epsilon": 0.0, "p": 0, "n": 0, "ratio": "", "omega_star": 0.0,
        "amplitude_graz": 0.0, "e_p": 0.0, "epsilon_e_p": 0.0, "trapesium_margin": 0.0, "alpha": 0.0,
        "beta": 0.0, "a12_alpha": 0.0, "unfolding": 0.0, "s_plus": 0.0, "s_minus": 0.0,
        "sn_predicted": "", "sn_continuation": "", "sn_simulation": "", "sn_crossed": true,
        "sn_stability_changes": "", "c_sn_theorem": 0.0, "c_sn": 0.0, "c_sn_exact": 0.0, "c_sn_fit": 0.0,
        "c_sn_fit_error": 0.0, "c_sn_difference": 0.0, "c_sn_fit_difference": 0.0,
        "pd_predicted": "", "pd_continuation": "", "pd_simulation": "", "pd_crossed": true,
        "pd_stability_changes": "", "c_pd_theorem": 0.0, "c_pd": 0.0, "c_pd_exact": 0.0, "c_pd_fit": 0.0,
        "c_pd_fit_error": 0.0, "c_pd_difference": 0.0, "c_pd_fit_difference": 0.0,
        "verdict": "", "reason": "",
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
