//! Figure 2 (fig:Z): the one-parameter bifurcation diagram at a fixed frequency, with phase portraits.

mod attractor;
mod branches;
mod portraits;

use grazing_model::LinearOscillator;
use grazing_theorems::GrazingState;

use crate::StudyError;
use crate::parameters::Parameters;
use crate::table::Table;
use grazing_unfold::progress::Progress;

/// The frames of Figure 2.
#[derive(Clone, Debug)]
pub struct Figure2 {
    /// `fig02_branches`: the non-impacting solution (p = 0) and the branches of MPSs.
    pub branches: Table,
    /// `fig02_bifurcations`: grazing of the non-impacting solution, PD, SN and GZ of MPSs.
    pub bifurcations: Table,
    /// `fig02_attractor`: long-time behaviour of forward orbits between GZ and PD.
    pub attractor: Table,
    /// `fig02_portraits`: orbits in the (x, y) plane.
    pub portraits: Table,
}

/// What the parts of the figure share: the oscillator at grazing.
struct Setting<'a> {
    parameters: &'a Parameters,
    grazing: GrazingState,
}

impl Setting<'_> {
    fn oscillator(&self, amplitude: f64) -> Result<LinearOscillator, StudyError> {
        let frequency = self.parameters.fig02().frequency();
        let (zeta, epsilon) = (self.parameters.zeta(), self.parameters.epsilon());
        Ok(LinearOscillator::new(zeta, epsilon, amplitude, frequency)?)
    }
}

impl Figure2 {
    /// All tables.
    pub fn tables(&self) -> Vec<Table> {
        vec![self.branches.clone(), self.bifurcations.clone(), self.attractor.clone(), self.portraits.clone()]
    }

    pub(crate) fn compute(parameters: &Parameters, progress: &dyn Progress) -> Result<Self, StudyError> {
        let theory = grazing_theorems::LinearOscillator::new(parameters.zeta(), parameters.epsilon())?;
        let grazing = theory.grazing(parameters.fig02().frequency())?;
        let setting = Setting { parameters, grazing };
        let branches = branches::follow(&setting)?;
        let bifurcations = branches::bifurcations(&setting, &branches);
        Ok(Self {
            branches: branches::table(&setting, &branches)?,
            attractor: attractor::table(&setting, &bifurcations, progress)?,
            portraits: portraits::table(&setting, &branches)?,
            bifurcations: branches::bifurcation_table(&bifurcations)?,
        })
    }
}
