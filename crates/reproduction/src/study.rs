//! Everything that is reproduced, computed once each.

use std::collections::BTreeMap;
use std::sync::{Arc, OnceLock};

use grazing_model::LinearOscillator;
use grazing_unfold::Diagram;
use grazing_unfold::progress::{Progress, Silent};

use crate::StudyError;
use crate::coefficients::CoefficientTable;
use crate::parameters::Parameters;

/// The reproduction at one set of parameters: each figure and table is a function of it, in the
/// module of its name. What several outputs share is computed when it is first needed. Each is an
/// error if a section of the parameter file that it needs is not right, or for what its docs name.
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

    /// The computed values of what the paper prints, under the names of `expected/published.toml`.
    ///
    /// # Errors
    /// There is no grazing in the window of Figure 7.
    pub fn published_values(&self) -> Result<BTreeMap<String, f64>, StudyError> {
        let theory = self.parameters.oscillator.get()?;
        let frequency = *self.parameters.fig02_frequency.get()?;
        let grazing = theory.grazing(frequency)?;
        let mut values = BTreeMap::from([
            ("zeta".to_owned(), theory.damping_ratio()),
            ("epsilon".to_owned(), theory.coefficient_of_restitution()),
            ("fig02_frequency".to_owned(), frequency),
            ("fig02_amplitude_graz".to_owned(), grazing.amplitude()),
            ("fig02_tau".to_owned(), grazing.trace()),
            ("fig02_delta".to_owned(), grazing.determinant()),
        ]);
        for c in &self.coefficients()?.rows {
            let name = |quantity: &str| format!("{quantity}_p{}_n{}", c.loops, c.n);
            values.insert(name("omega"), c.frequency);
            values.insert(name("c_sn"), c.closed_form.saddle_node);
            values.insert(name("c_pd"), c.closed_form.period_doubling);
        }
        Ok(values)
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
