//! Figure 2 (fig:Z): the one-parameter bifurcation diagram at a fixed frequency, with phase portraits.

mod attractor;
mod branches;
mod portraits;
mod subjects;

use grazing_model::LinearOscillator;
use grazing_results::Frame;
use grazing_results::branches::Figure2;
use grazing_theorems::GrazingState;
use grazing_unfold::one_parameter::Branch;

use crate::diagram::forced;
use crate::{Study, StudyError, parameters};

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
        let shown: Vec<_> = branches.iter().map(Branch::shown).collect();
        let bifurcations = branches::bifurcations(&setting, &shown);
        let (portraits, more) = portraits::rows(&setting, &branches)?;
        Ok(Figure2 {
            branches: branches::rows(&setting, &shown)?,
            attractor: attractor::rows(&setting, &bifurcations, self.progress)?,
            portraits,
            frame: Frame { x: figure.amplitude, y: figure.x },
            magnified: Frame { x: figure.magnified_amplitude, y: figure.magnified_x },
            notes: [figure.notes.as_slice(), &more].concat(),
            bifurcations,
        })
    }
}
