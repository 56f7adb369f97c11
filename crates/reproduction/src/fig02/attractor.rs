//! Long-time behaviour of forward orbits from random initial points.

use grazing_continuation::bifurcation::Bifurcation;
use grazing_results::branches::{AttractorPoint, BranchBifurcation};
use grazing_unfold::one_parameter::long_time_behaviour;
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
    let sampling = (&setting.figure.attractor, lowest(setting));
    let (visits, _) =
        long_time_behaviour(&oscillator, setting.figure.frequency, [gz, pd], sampling, progress);
    Ok(visits.into_iter().map(|[primary, x]| AttractorPoint { primary, x }).collect())
}

/// The lowest x at which orbits begin: the lower edge of the figure.
pub(super) fn lowest(setting: &Setting) -> f64 {
    setting.figure.x[0].min(0.0)
}
