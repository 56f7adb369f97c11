//! Figure 2 (fig:Z): the one-parameter bifurcation diagram at a fixed frequency, with phase portraits.

mod attractor;
mod branches;
mod portraits;
mod subjects;

use grazing_model::LinearOscillator;
use grazing_results::branches::{AttractorPoint, BranchBifurcation, BranchPoint, PortraitPoint};
use grazing_results::{Names, Table};
use grazing_theorems::GrazingState;
use grazing_unfold::progress::Progress;

use crate::StudyError;
use crate::diagram::forced;
use crate::parameters::{Figure2 as Figure2Parameters, Parameters};

/// What Figure 2 shows.
#[derive(Clone, Debug)]
pub struct Figure2 {
    /// The non-impacting solution (p = 0) and the branches of MPSs.
    pub branches: Vec<BranchPoint>,
    /// Grazing of the non-impacting solution, PD, SN and GZ of MPSs.
    pub bifurcations: Vec<BranchBifurcation>,
    /// Long-time behaviour of forward orbits between GZ and PD.
    pub attractor: Vec<AttractorPoint>,
    /// Orbits in the (x, y) plane.
    pub portraits: Vec<PortraitPoint>,
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
        let names = Names::of_the_paper();
        vec![
            Table::new("fig02_branches", &names, &self.branches),
            Table::new("fig02_bifurcations", &names, &self.bifurcations),
            Table::new("fig02_attractor", &names, &self.attractor),
            Table::new("fig02_portraits", &names, &self.portraits),
        ]
    }

    pub(crate) fn compute(parameters: &Parameters, progress: &dyn Progress) -> Result<Self, StudyError> {
        let (figure, theory) = (parameters.fig02()?, parameters.oscillator()?);
        let setting = Setting { figure, theory, grazing: theory.grazing(figure.frequency())? };
        let branches = branches::follow(&setting)?;
        let bifurcations = branches::bifurcations(&setting, &branches);
        let (portraits, more) = portraits::rows(&setting, &branches)?;
        Ok(Self {
            branches: branches::rows(&setting, &branches)?,
            attractor: attractor::rows(&setting, &bifurcations, progress)?,
            portraits,
            notes: [figure.notes(), &more].concat(),
            bifurcations,
        })
    }
}
