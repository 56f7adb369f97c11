//! Figure 2 (fig:Z): the one-parameter bifurcation diagram at a fixed frequency, with phase portraits.

mod attractor;
mod branches;
mod portraits;
mod subjects;

use grazing_model::LinearOscillator;
use grazing_results::branches::{AttractorPoint, BranchBifurcation, BranchPoint, PortraitPoint};
use grazing_results::tables;
use grazing_theorems::GrazingState;

use crate::diagram::forced;
use crate::{Study, StudyError, parameters};

tables! {
    /// What Figure 2 shows.
    Figure2 {
        /// The non-impacting solution (p = 0) and the branches of MPSs.
        branches: BranchPoint = "fig02_branches", "a point of a branch, on one loop of the solution",
        /// Grazing of the non-impacting solution, PD, SN and GZ of MPSs.
        bifurcations: BranchBifurcation = "fig02_bifurcations", "a bifurcation on a branch",
        /// Long-time behaviour of forward orbits between GZ and PD.
        attractor: AttractorPoint = "fig02_attractor", "a visit to Π of an orbit that has settled",
        /// Orbits in the (x, y) plane.
        portraits: PortraitPoint = "fig02_portraits", "a point of an orbit in a phase portrait",
        ;
        /// What is shown elsewhere than the parameters ask for, or not at all, in sentences.
        notes: Vec<String>,
    }
}

/// What the parts of the figure share: the oscillator at grazing.
struct Setting<'a> {
    figure: &'a parameters::Figure2,
    theory: &'a grazing_theorems::LinearOscillator,
    grazing: GrazingState,
}

impl Setting<'_> {
    fn oscillator(&self, amplitude: f64) -> Result<LinearOscillator, StudyError> {
        forced(self.theory, amplitude, self.figure.frequency)
    }
}

impl Study<'_> {
    /// Figure 2.
    ///
    /// # Errors
    /// A branch could not be started, or a portrait's solution is not there.
    pub fn fig02(&self) -> Result<Figure2, StudyError> {
        let (figure, theory) = (self.parameters.fig02.get()?, self.parameters.oscillator.get()?);
        let setting = Setting { figure, theory, grazing: theory.grazing(figure.frequency)? };
        let branches = branches::follow(&setting)?;
        let bifurcations = branches::bifurcations(&setting, &branches);
        let (portraits, more) = portraits::rows(&setting, &branches)?;
        Ok(Figure2 {
            branches: branches::rows(&setting, &branches)?,
            attractor: attractor::rows(&setting, &bifurcations, self.progress)?,
            portraits,
            notes: [figure.notes.as_slice(), &more].concat(),
            bifurcations,
        })
    }
}
