//! What a figure of a study is, of the paper or beyond it.

use std::sync::Arc;

use grazing_drawing::{DrawingError, Sheet, SheetWidth};
use grazing_results::{TablePlan, Tables, Title};

use crate::parameters::{FileSection, ParameterError};
use crate::{Study, StudyError};

/// The imports that the file of every figure uses, of the paper or beyond it.
pub mod prelude {
    pub use grazing_drawing::{DrawingError, Sheet, SheetWidth};
    pub use grazing_input::{Section, keys};
    pub use grazing_results::{TablePlan, Tables, Title};

    pub use super::{Remarks, StudyFigure};
    pub use crate::parameters::{FileSection, ParameterError, Parameters};
    pub use crate::{Study, StudyError};
}

/// A figure of a study: a section of the parameter file, with the functions that compute and draw the
/// figure. The name of the section is also that of the output and of its file.
pub trait StudyFigure: FileSection + 'static {
    /// The label in the paper, or in LaTeX.
    const LABEL: &'static str;
    /// The title, which says which figure of the paper it is, or that it goes beyond the paper.
    const TITLE: Title<&'static str>;
    /// The tables of the figure, in the order of its contents.
    const TABLES: &'static [TablePlan];
    /// The keys to change if the figure cannot be computed.
    const REMEDY: &'static str;
    /// The contents of the figure.
    type Shown: Tables + Send + Sync + 'static;

    /// Computes the contents of the figure.
    ///
    /// # Errors
    /// [`StudyError`]: the figure cannot be computed at these parameters.
    fn compute(&self, study: &Study) -> Result<Self::Shown, StudyError>;

    /// Draws the figure.
    ///
    /// # Errors
    /// [`DrawingError`]: there is nothing visible, or no room for it.
    fn draw(shown: &Self::Shown, width: SheetWidth) -> Result<Sheet, DrawingError>;

    /// Remarks on the contents of the figure.
    ///
    /// # Errors
    /// As [`compute`](Self::compute).
    fn remarks(&self, _study: &Study, _shown: &Self::Shown) -> Result<Remarks, StudyError> {
        Ok(Remarks::default())
    }

    /// The constants used for the figure, by their symbols in LaTeX, as far as a document must state
    /// them; sketches have none.
    ///
    /// # Errors
    /// The section that holds the constants is invalid.
    fn constants(_study: &Study) -> Result<Vec<(&'static str, f64)>, ParameterError> {
        Ok(Vec::new())
    }
}

/// Remarks on a figure, in sentences.
#[derive(Clone, Debug, Default)]
pub struct Remarks {
    /// Contents that differ from those requested.
    pub notes: Vec<String>,
    /// Missing contents, without which the figure is not the one requested.
    pub gaps: Vec<String>,
}

impl Study {
    /// The contents of a figure, computed once.
    ///
    /// # Errors
    /// The section is invalid, or the figure cannot be computed.
    pub fn shown<F: StudyFigure>(&self) -> Result<Arc<F::Shown>, StudyError> {
        self.once::<F, _>(|| self.parameters.section::<F>()?.compute(self))
    }

    /// The constants of the paper's oscillator, ζ and ε, by their symbols in LaTeX, as
    /// [`StudyFigure::constants`] gives them.
    ///
    /// # Errors
    /// The section of the oscillator is invalid.
    pub fn oscillator_constants(&self) -> Result<Vec<(&'static str, f64)>, ParameterError> {
        let oscillator = self.parameters.oscillator()?;
        let (zeta, epsilon) = (oscillator.damping_ratio(), oscillator.coefficient_of_restitution());
        Ok(vec![(r"\zeta", zeta), (r"\epsilon", epsilon)])
    }
}
