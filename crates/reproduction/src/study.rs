//! Everything that is reproduced, computed once each.

use std::collections::BTreeMap;
use std::sync::OnceLock;

use grazing_model::LinearOscillator;
use grazing_results::Table;
use grazing_results::sketches::{PartPoint, Visit};
use grazing_unfold::Diagram;
use grazing_unfold::progress::{Progress, Silent};

use crate::StudyError;
use crate::coefficients::{self, Coefficients};
use crate::diagram;
use crate::fig02::Figure2;
use crate::fig04::Figure4;
use crate::fig05::Figure5;
use crate::fig07::Figure7;
use crate::fig08::{self, Figure8, ShownPanel};
use crate::parameters::Parameters;
use crate::space::Scene;
use crate::sweep::TheoremsInAction;
use crate::{fig01, fig03, fig06, fig09, fig10};

/// The reproduction at one set of parameters. What several outputs share is computed when it is first needed.
pub struct Study<'a> {
    parameters: Parameters,
    progress: &'a dyn Progress,
    diagram: OnceLock<Result<Diagram<LinearOscillator>, StudyError>>,
    coefficients: OnceLock<Result<Vec<Coefficients>, StudyError>>,
}

impl<'a> Study<'a> {
    /// The study of these parameters; nothing is computed yet.
    pub fn new(parameters: &Parameters) -> Self {
        Self {
            parameters: parameters.clone(),
            progress: &Silent,
            diagram: OnceLock::new(),
            coefficients: OnceLock::new(),
        }
    }

    /// The study with somebody to tell how far long work has come.
    pub fn with_progress(self, progress: &'a dyn Progress) -> Self {
        Self { progress, ..self }
    }

    /// The parameters.
    pub fn parameters(&self) -> &Parameters {
        &self.parameters
    }

    /// The coefficients at all resonances of Figure 7.
    ///
    /// # Errors
    /// There is no grazing in the window.
    pub fn coefficients(&self) -> Result<&[Coefficients], StudyError> {
        let computed =
            self.coefficients.get_or_init(|| coefficients::compute(&self.parameters, self.diagram()?));
        computed.as_deref().map_err(Clone::clone)
    }

    /// The table `coefficients`.
    ///
    /// # Errors
    /// As [`coefficients`](Self::coefficients).
    pub fn coefficient_table(&self) -> Result<Table, StudyError> {
        Ok(coefficients::table(self.coefficients()?))
    }

    /// What Figure 7 and the table of coefficients lack: resonances that could not be located, and curves that could not be followed.
    ///
    /// # Errors
    /// As [`fig07`](Self::fig07).
    pub fn gaps(&self) -> Result<Vec<StudyError>, StudyError> {
        Ok(diagram::gaps(self.diagram()?))
    }

    /// Figure 1.
    ///
    /// # Errors
    /// An orbit does not reach the wall where it should.
    pub fn fig01(&self) -> Result<Scene, StudyError> {
        fig01::compute(&self.parameters)
    }

    /// Figure 2.
    ///
    /// # Errors
    /// A branch could not be started, or a portrait's solution is not there.
    pub fn fig02(&self) -> Result<Figure2, StudyError> {
        Figure2::compute(&self.parameters, self.progress)
    }

    /// Figure 3.
    ///
    /// # Errors
    /// P_global is not defined at the point.
    pub fn fig03(&self) -> Result<Scene, StudyError> {
        fig03::compute(&self.parameters)
    }

    /// Figure 4.
    ///
    /// # Errors
    /// A section of the parameter file is not right.
    pub fn fig04(&self) -> Result<Figure4, StudyError> {
        Figure4::compute(&self.parameters)
    }

    /// Figure 5.
    ///
    /// # Errors
    /// The theorem of the figure does not apply at the resonance.
    pub fn fig05(&self) -> Result<Figure5, StudyError> {
        Figure5::compute(&self.parameters)
    }

    /// Figure 6.
    ///
    /// # Errors
    /// A section of the parameter file is not right.
    pub fn fig06(&self) -> Result<Vec<PartPoint>, StudyError> {
        fig06::compute(&self.parameters)
    }

    /// Figure 7.
    ///
    /// # Errors
    /// There is no grazing in the window.
    pub fn fig07(&self) -> Result<Figure7, StudyError> {
        Ok(Figure7::of(self.diagram()?))
    }

    /// Figure 8.
    ///
    /// # Errors
    /// A resonance could not be located, unfolded or measured.
    pub fn fig08(&self) -> Result<Figure8, StudyError> {
        Figure8::compute(&self.parameters, self.diagram()?)
    }

    /// The panels of Figure 8, without their curves.
    ///
    /// # Errors
    /// No panel can be shown.
    pub fn panels(&self) -> Result<Vec<ShownPanel>, StudyError> {
        fig08::panels(&self.parameters, self.diagram()?)
    }

    /// Figure 9.
    ///
    /// # Errors
    /// P_virt or P_global is not defined at a point.
    pub fn fig09(&self) -> Result<Scene, StudyError> {
        fig09::compute(&self.parameters)
    }

    /// Figure 10.
    ///
    /// # Errors
    /// A section of the parameter file is not right.
    pub fn fig10(&self) -> Result<Vec<Visit>, StudyError> {
        fig10::compute(&self.parameters)
    }

    /// Theorems 2.2 to 2.5 against continuation and simulation over many oscillators; the parameters of this study do not
    /// matter.
    ///
    /// # Errors
    /// A case could not be worked out.
    pub fn theorems_in_action(&self) -> Result<TheoremsInAction, StudyError> {
        TheoremsInAction::compute(self.progress)
    }

    /// The computed values of what the paper prints, under the names of `expected/published.toml`.
    ///
    /// # Errors
    /// There is no grazing in the window of Figure 7.
    pub fn published_values(&self) -> Result<BTreeMap<String, f64>, StudyError> {
        let parameters = &self.parameters;
        let theory = parameters.oscillator()?;
        let frequency = parameters.fig02_frequency()?;
        let grazing = theory.grazing(frequency)?;
        let mut values = BTreeMap::from([
            ("zeta".to_owned(), theory.damping_ratio()),
            ("epsilon".to_owned(), theory.coefficient_of_restitution()),
            ("fig02_frequency".to_owned(), frequency),
            ("fig02_amplitude_graz".to_owned(), grazing.amplitude()),
            ("fig02_tau".to_owned(), grazing.trace()),
            ("fig02_delta".to_owned(), grazing.determinant()),
        ]);
        for c in self.coefficients()? {
            let name = |quantity: &str| format!("{quantity}_p{}_n{}", c.loops, c.n);
            values.insert(name("omega"), c.frequency);
            values.insert(name("c_sn"), c.closed_form.saddle_node);
            values.insert(name("c_pd"), c.closed_form.period_doubling);
        }
        Ok(values)
    }

    fn diagram(&self) -> Result<&Diagram<LinearOscillator>, StudyError> {
        let computed = self.diagram.get_or_init(|| diagram::compute(&self.parameters, self.progress));
        computed.as_ref().map_err(Clone::clone)
    }
}
