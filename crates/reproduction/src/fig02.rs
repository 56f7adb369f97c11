//! Figure 2 (fig:Z): the one-parameter bifurcation diagram at a fixed frequency, with phase portraits.

mod branches;
mod portraits;
mod subjects;

use grazing_continuation::bifurcation::Bifurcation;
use grazing_model::LinearOscillator;
use grazing_results::Frame;
use grazing_results::branches::{AttractorPoint, BranchBifurcation, Figure2};
use grazing_theorems::GrazingState;
use grazing_unfold::one_parameter::{Branch, long_time_behaviour};
use grazing_unfold::progress::Progress;

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

    /// The lowest x at which orbits begin: the lower edge of the figure.
    fn lowest(&self) -> f64 {
        self.figure.x[0].min(0.0)
    }

    /// x on Π along orbits from random points after a transient, at amplitudes between GZ and PD.
    ///
    /// Empty if the branches have no GZ or no PD in the window.
    fn long_time(
        &self,
        bifurcations: &[BranchBifurcation],
        progress: &dyn Progress,
    ) -> Result<Vec<AttractorPoint>, StudyError> {
        let first = |kind| bifurcations.iter().find(|b| b.kind == kind).map(|b| b.primary);
        let (Some(gz), Some(pd)) = (first(Bifurcation::Grazing), first(Bifurcation::PeriodDoubling)) else {
            return Ok(Vec::new());
        };
        let (oscillator, sampling) = (self.oscillator(gz)?, (&self.figure.attractor, self.lowest()));
        let (visits, _) =
            long_time_behaviour(&oscillator, self.figure.frequency, [gz, pd], sampling, progress);
        Ok(visits.into_iter().map(|[primary, x]| AttractorPoint { primary, x }).collect())
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
        let branches = branches::follow(&setting, self.progress)?;
        let shown: Vec<_> = branches.iter().map(Branch::shown).collect();
        let bifurcations = branches::bifurcations(&setting, &shown);
        let (portraits, more) = portraits::rows(&setting, &branches)?;
        Ok(Figure2 {
            branches: branches::rows(&setting, &shown)?,
            attractor: setting.long_time(&bifurcations, self.progress)?,
            portraits,
            frame: Frame { x: figure.amplitude, y: figure.x },
            magnified: Frame { x: figure.magnified_amplitude, y: figure.magnified_x },
            notes: [figure.notes.as_slice(), &more].concat(),
            bifurcations,
        })
    }
}
