//! All results of the reproduction, each computed once.

use std::any::{Any, TypeId};
use std::collections::HashMap;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

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
    /// The receiver of progress reports.
    pub progress: Arc<dyn Progress + Send>,
    pub(crate) diagram: OnceLock<Result<Diagram, StudyError>>,
    pub(crate) coefficients: OnceLock<Result<CoefficientTable, StudyError>>,
    /// Other results, by whose they are.
    others: Mutex<HashMap<TypeId, Arc<OnceLock<Other>>>>,
}

/// A result of any type, or the reason why there is none.
type Other = Result<Arc<dyn Any + Send + Sync>, StudyError>;

impl Study {
    /// A study of these parameters, with nothing computed yet.
    pub fn new(parameters: &Parameters) -> Self {
        Self {
            parameters: parameters.clone(),
            progress: Arc::new(Silent),
            diagram: OnceLock::new(),
            coefficients: OnceLock::new(),
            others: Mutex::default(),
        }
    }

    /// What belongs to a type, such as the contents of a figure, computed once.
    pub(crate) fn once<Owner: 'static, T: Any + Send + Sync>(
        &self,
        compute: impl FnOnce() -> Result<T, StudyError>,
    ) -> Result<Arc<T>, StudyError> {
        let mut all = self.others.lock().unwrap_or_else(PoisonError::into_inner);
        let once = Arc::clone(all.entry(TypeId::of::<Owner>()).or_default());
        // Others can be computed meanwhile.
        drop(all);
        let compute = || Ok(Arc::new(compute()?) as Arc<dyn Any + Send + Sync>);
        let found = Arc::clone(once.get_or_init(compute).as_ref().map_err(Clone::clone)?);
        Ok(found.downcast().expect("an owner has results of one type"))
    }

    /// Sets the receiver of progress reports.
    #[must_use]
    pub fn with_progress(self, progress: Arc<dyn Progress + Send>) -> Self {
        Self { progress, ..self }
    }
}

/// The oscillator of the theory (eq:oscf, eq:oscResetLaw) under a forcing of this amplitude and frequency.
///
/// # Errors
/// [`StudyError::Oscillator`]: the frequency is not positive and finite, or the amplitude not finite.
pub fn forced(
    theory: &grazing_theorems::LinearOscillator,
    amplitude: f64,
    frequency: f64,
) -> Result<LinearOscillator, StudyError> {
    let (zeta, epsilon) = (theory.damping_ratio(), theory.coefficient_of_restitution());
    Ok(LinearOscillator::new(zeta, epsilon, amplitude, frequency)?)
}
