//! The two-parameter diagram of the paper's oscillator, which Figures 7 and 8 and the table share.

use grazing_continuation::arclength::StepControl;
use grazing_continuation::curve::{Route, Window};
use grazing_model::LinearOscillator;
use grazing_unfold::diagram::route;
use grazing_unfold::{Diagram, Scope};

use crate::{Study, StudyError};

impl Study<'_> {
    /// The diagram in the window of Figure 7: what `grazing_unfold` finds of an oscillator whose flow is known in closed form.
    pub(crate) fn diagram(&self) -> Result<&Diagram<LinearOscillator>, StudyError> {
        let compute = || {
            let figure = self.parameters.fig07.get()?;
            let scope = Scope { window: figure.window, loops: figure.loops.clone(), start: None };
            let theory = self.parameters.oscillator.get()?;
            let oscillator = forced(theory, scope.window.primary[0], scope.window.secondary[0])?;
            Ok(Diagram::compute(&oscillator, &scope, self.progress)?)
        };
        self.diagram.get_or_init(compute).as_ref().map_err(Clone::clone)
    }

    /// What Figure 7 and the table of coefficients lack: resonances that could not be located, and curves that could not be followed.
    ///
    /// # Errors
    /// As [`fig07`](Self::fig07).
    pub fn gaps(&self) -> Result<Vec<StudyError>, StudyError> {
        let diagram = self.diagram()?;
        let unlocated = diagram.unlocated.iter().map(|lost| StudyError::Unlocated {
            loops: lost.loops,
            near: lost.near,
            source: lost.reason.clone(),
        });
        let failed = diagram.not_unfolded.iter();
        Ok(unlocated
            .chain(failed.map(|failed| StudyError::resonance(failed.loops, failed.n, failed.reason.clone())))
            .collect())
    }
}

/// The oscillator of theory with its forcing.
pub(crate) fn forced(
    theory: &grazing_theorems::LinearOscillator,
    amplitude: f64,
    frequency: f64,
) -> Result<LinearOscillator, StudyError> {
    let (zeta, epsilon) = (theory.damping_ratio(), theory.coefficient_of_restitution());
    Ok(LinearOscillator::new(zeta, epsilon, amplitude, frequency)?)
}

/// The route along a branch of fixed frequency through a range of amplitudes, past all events.
pub(crate) fn branch_route(amplitude: [f64; 2]) -> Route {
    let window = Window { primary: amplitude, secondary: [0.0, f64::INFINITY] };
    Route { stop_at_events: false, ..route(window, StepControl::DRAWING) }
}
