//! All results of the reproduction, each computed once.

use std::any::{Any, TypeId};
use std::collections::HashMap;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use grazing_analysis::limits::{AtLimit, LimitTable};
use grazing_model::LinearOscillator;
use grazing_unfold::Diagram;
use grazing_unfold::progress::{Progress, Silent};

use crate::coefficients::CoefficientTable;
use crate::parameters::Parameters;
use crate::{PaperFigure, StudyError};

/// The reproduction for one set of parameters, on which all figures and tables depend. Results that
/// several of them use are computed when first needed.
pub struct Study {
    /// The parameters.
    pub parameters: Parameters,
    pub(crate) progress: Arc<dyn Progress + Send>,
    pub(crate) diagram: OnceLock<Result<Diagram, StudyError>>,
    pub(crate) coefficients: OnceLock<Result<CoefficientTable, StudyError>>,
    /// The contents of figures, by the figure's type.
    shown: Mutex<HashMap<TypeId, Arc<OnceLock<Shown>>>>,
}

/// The contents of a figure, or the reason why there are none.
type Shown = Result<Arc<dyn Any + Send + Sync>, StudyError>;

impl Study {
    /// A study of these parameters, with nothing computed yet.
    pub fn new(parameters: &Parameters) -> Self {
        Self {
            parameters: parameters.clone(),
            progress: Arc::new(Silent),
            diagram: OnceLock::new(),
            coefficients: OnceLock::new(),
            shown: Mutex::default(),
        }
    }

    /// The contents of a figure, computed once.
    ///
    /// # Errors
    /// The section is invalid, or the figure cannot be computed.
    pub fn shown<F: PaperFigure>(&self) -> Result<Arc<F::Shown>, StudyError> {
        let mut all = self.shown.lock().unwrap_or_else(PoisonError::into_inner);
        let once = Arc::clone(all.entry(TypeId::of::<F>()).or_default());
        // Other figures can be computed meanwhile.
        drop(all);
        let compute = || {
            let shown = self.parameters.section::<F>()?.compute(self)?;
            Ok(Arc::new(shown) as Arc<dyn Any + Send + Sync>)
        };
        let shown = Arc::clone(once.get_or_init(compute).as_ref().map_err(Clone::clone)?);
        Ok(shown.downcast().expect("the entry of a figure holds its contents"))
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
