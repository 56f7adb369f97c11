//! The two-parameter diagram of the paper's oscillator, which Figures 7 and 8 and the table share.

use grazing_continuation::resonance::ResonanceError;
use grazing_model::LinearOscillator;
use grazing_unfold::diagram::NotUnfolded;
use grazing_unfold::resonances::Unlocated;
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

    /// What Figure 7 and the table of coefficients lack: resonances that could not be located, in sentences.
    ///
    /// # Errors
    /// As [`fig07`](Self::fig07).
    pub fn unlocated(&self) -> Result<Vec<String>, StudyError> {
        let told = |lost: &Unlocated| {
            format!("the resonance of p = {} near {:?} is missing: {}", lost.loops, lost.near, lost.reason)
        };
        Ok(self.diagram()?.unlocated.iter().map(told).collect())
    }

    /// What only Figure 7 lacks: curves that could not be followed, in sentences.
    pub(crate) fn not_followed(&self) -> Result<Vec<String>, StudyError> {
        let told = |lost: &NotUnfolded| not_followed(lost.loops, lost.n, &lost.reason);
        Ok(self.diagram()?.not_unfolded.iter().map(told).collect())
    }
}

/// That a curve of a resonance is missing.
pub(crate) fn not_followed(loops: u32, n: u32, reason: &ResonanceError) -> String {
    format!("resonance p = {loops}, n = {n}: a curve is missing: {reason}")
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
