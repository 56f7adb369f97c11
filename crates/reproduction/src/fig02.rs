//! Figure 2 (fig:Z): the one-parameter bifurcation diagram at a fixed frequency, with phase portraits.

mod attractor;
mod branches;
mod portraits;
mod subjects;

use grazing_model::LinearOscillator;
use grazing_theorems::GrazingState;

use crate::StudyError;
use crate::diagram::forced;
use crate::parameters::{Figure2 as Figure2Parameters, Parameters};
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
    /// What is shown elsewhere than the parameters ask for, or not at all, in sentences.
    pub notes: Vec<String>,
}

/// What the parts of the figure share: the oscillator at grazing.
struct Setting<'a> {
    figure: &'a Figure2Parameters,
    theory: &'a grazing_theorems::LinearOscillator,
    grazing: GrazingState,
}

impl Setting<'_> {
    fn oscillator(&self, amplitude: f64) -> Result<LinearOscillator, StudyError> {
        forced(self.theory, amplitude, self.figure.frequency())
    }
}

impl Figure2 {
    /// All tables.
    pub fn tables(&self) -> Vec<Table> {
        vec![self.branches.clone(), self.bifurcations.clone(), self.attractor.clone(), self.portraits.clone()]
    }

    pub(crate) fn compute(parameters: &Parameters, progress: &dyn Progress) -> Result<Self, StudyError> {
        let (figure, theory) = (parameters.fig02()?, parameters.oscillator()?);
        let setting = Setting { figure, theory, grazing: theory.grazing(figure.frequency())? };
        let branches = branches::follow(&setting)?;
        let bifurcations = branches::bifurcations(&setting, &branches);
        let (portraits, more) = portraits::table(&setting, &branches)?;
        Ok(Self {
            branches: branches::table(&setting, &branches)?,
            attractor: attractor::table(&setting, &bifurcations, progress)?,
            portraits,
            notes: [figure.notes(), &more].concat(),
            bifurcations: branches::bifurcation_table(&bifurcations)?,
        })
    }
}
