//! Long-time behaviour of forward orbits from random initial points.

use grazing_continuation::bifurcation::Bifurcation;
use grazing_results::branches::{AttractorPoint, BranchBifurcation};
use grazing_unfold::one_parameter::{Plan, long_time_behaviour};
use grazing_unfold::progress::Progress;

use super::Setting;
use crate::StudyError;

/// x on Π along orbits after a transient, at amplitudes between GZ and PD.
///
/// Empty if the branches have no GZ or no PD in the window.
pub(super) fn rows(
    setting: &Setting,
    bifurcations: &[BranchBifurcation],
    progress: &dyn Progress,
) -> Result<Vec<AttractorPoint>, StudyError> {
    let first = |kind| bifurcations.iter().find(|b| b.kind == kind).map(|b| b.primary);
    let (Some(gz), Some(pd)) = (first(Bifurcation::Grazing), first(Bifurcation::PeriodDoubling)) else {
        return Ok(Vec::new());
    };
    let oscillator = setting.oscillator(gz)?;
    let sampling = (&plan(setting), lowest(setting));
    let (visits, _) =
        long_time_behaviour(&oscillator, setting.figure.frequency, [gz, pd], sampling, progress);
    Ok(visits.into_iter().map(|[primary, x]| AttractorPoint { primary, x }).collect())
}

/// How long-time behaviour is sampled.
pub(super) fn plan(setting: &Setting) -> Plan {
    let plan = &setting.figure.attractor;
    Plan {
        values: plan.amplitudes,
        orbits: plan.orbits,
        transient: plan.transient,
        recorded: plan.recorded,
        seed: plan.seed,
    }
}

/// The lowest x at which orbits begin: the lower edge of the figure.
pub(super) fn lowest(setting: &Setting) -> f64 {
    setting.figure.x[0].min(0.0)
}
