//! All results of the reproduction, each computed once.

use std::sync::{Arc, OnceLock};

use grazing_analysis::limits::{AtLimit, LimitTable};
use grazing_model::LinearOscillator;
use grazing_unfold::Diagram;
use grazing_unfold::progress::{Progress, Silent};

use crate::StudyError;
use crate::coefficients::CoefficientTable;
use crate::parameters::Parameters;

/// The reproduction for one set of parameters, on which all figures and tables depend. Results that
/// several of them use are computed when first needed.
pub struct Study {
    /// The parameters.
    pub parameters: Parameters,
    pub(crate) progress: Arc<dyn Progress + Send>,
    pub(crate) diagram: OnceLock<Result<Diagram, StudyError>>,
    pub(crate) coefficients: OnceLock<Result<CoefficientTable, StudyError>>,
}

impl Study {
    /// A study of these parameters, with nothing computed yet.
    pub fn new(parameters: &Parameters) -> Self {
        Self {
            parameters: parameters.clone(),
            progress: Arc::new(Silent),
            diagram: OnceLock::new(),
            coefficients: OnceLock::new(),
        }
    }

    /// Sets the receiver of progress reports.
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

/// The oscillator of the theory with its forcing.
pub(crate) fn forced(
    theory: &grazing_theorems::LinearOscillator,
    amplitude: f64,
    frequency: f64,
) -> Result<LinearOscillator, StudyError> {
    let (zeta, epsilon) = (theory.damping_ratio(), theory.coefficient_of_restitution());
    Ok(LinearOscillator::new(zeta, epsilon, amplitude, frequency)?)
}
