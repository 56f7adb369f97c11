//! Everything that is reproduced, computed once each.

use std::sync::{Arc, OnceLock};

use grazing_analysis::limits::{AtLimit, LimitTable};
use grazing_model::LinearOscillator;
use grazing_unfold::Diagram;
use grazing_unfold::progress::{Progress, Silent};

use crate::StudyError;
use crate::coefficients::CoefficientTable;
use crate::parameters::Parameters;

/// The reproduction at one set of parameters, of which each figure and table is a function. What
/// several of them share is computed when it is first needed.
pub struct Study {
    /// The parameters.
    pub parameters: Parameters,
    pub(crate) progress: Arc<dyn Progress + Send>,
    pub(crate) diagram: OnceLock<Result<Diagram, StudyError>>,
    pub(crate) coefficients: OnceLock<Result<CoefficientTable, StudyError>>,
}

impl Study {
    /// The study of these parameters; nothing is computed yet.
    pub fn new(parameters: &Parameters) -> Self {
        Self {
            parameters: parameters.clone(),
            progress: Arc::new(Silent),
            diagram: OnceLock::new(),
            coefficients: OnceLock::new(),
        }
    }

    /// The same study, which reports how far long work has come.
    #[must_use]
    pub fn with_progress(self, progress: Arc<dyn Progress + Send>) -> Self {
        Self { progress, ..self }
    }

    /// Beyond the paper: the limit map at all resonances of Figure 7.
    ///
    /// # Errors
    /// There is no grazing in the window.
    pub fn limits(&self) -> Result<LimitTable, StudyError> {
        let found = self.diagram()?.unfolding();
        Ok(LimitTable { rows: found.map(|(resonance, _)| AtLimit::of(resonance)).collect() })
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
