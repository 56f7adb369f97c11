//! What a figure of the paper, or beyond it, is to the program.

use grazing_drawing::{DrawingError, Sheet, SheetWidth};
use grazing_results::{TablePlan, Tables};

use crate::parameters::{FileSection, ParameterError};
use crate::{Study, StudyError};

/// What the file of every figure uses.
pub(crate) mod prelude {
    pub(crate) use grazing_drawing::{DrawingError, Sheet, SheetWidth};
    pub(crate) use grazing_results::{TablePlan, Tables};
    pub(crate) use grazing_source::{Section, keys};

    pub(crate) use super::{PaperFigure, Remarks};
    pub(crate) use crate::parameters::{FileSection, ParameterError, Parameters};
    pub(crate) use crate::{Study, StudyError};
}

/// A figure of the paper: the section of the parameter file that says what it shows, what computes
/// that, and what draws it. The name of the section is also that of the output and of its file.
pub trait PaperFigure: FileSection {
    /// Its label in the paper, or in LaTeX.
    const LABEL: &'static str;
    /// Whether it answers what the paper leaves open.
    const BEYOND: bool = false;
    /// What it shows, in one line.
    const TITLE: &'static str;
    /// Its tables, in the order of what it shows.
    const TABLES: &'static [TablePlan];
    /// The keys to change where it cannot be computed.
    const REMEDY: &'static str;
    /// What it shows.
    type Shown: Tables;

    /// Computes it.
    ///
    /// # Errors
    /// [`StudyError`]: it cannot be computed at these parameters.
    fn compute(&self, study: &Study) -> Result<Self::Shown, StudyError>;

    /// Draws it.
    ///
    /// # Errors
    /// [`DrawingError`]: there is nothing to be seen, or no room for it.
    fn draw(shown: &Self::Shown, width: SheetWidth) -> Result<Sheet, DrawingError>;

    /// What is to be said of it.
    ///
    /// # Errors
    /// As [`compute`](Self::compute).
    fn remarks(&self, _study: &Study, _shown: &Self::Shown) -> Result<Remarks, StudyError> {
        Ok(Remarks::default())
    }

    /// The constants with which it is computed, by their symbols in LaTeX, as far as a document
    /// must say them; sketches have none.
    ///
    /// # Errors
    /// The section that holds them is not right.
    fn constants(_study: &Study) -> Result<Vec<(&'static str, f64)>, ParameterError> {
        Ok(Vec::new())
    }
}

/// What is to be said of a figure, in sentences.
#[derive(Clone, Debug, Default)]
pub struct Remarks {
    /// What it shows otherwise than asked for.
    pub notes: Vec<String>,
    /// What it lacks, so that it is not what was asked for.
    pub gaps: Vec<String>,
}

impl Study {
    /// What a figure shows.
    ///
    /// # Errors
    /// Its section is not right, or it cannot be computed.
    pub fn shown<F: PaperFigure>(&self) -> Result<F::Shown, StudyError> {
        self.parameters.section::<F>()?.compute(self)
    }

    /// The constants of the paper's oscillator, by their symbols in LaTeX.
    pub(crate) fn oscillator_constants(&self) -> Result<Vec<(&'static str, f64)>, ParameterError> {
        let oscillator = self.parameters.oscillator()?;
        let (zeta, epsilon) = (oscillator.damping_ratio(), oscillator.coefficient_of_restitution());
        Ok(vec![(r"\zeta", zeta), (r"\epsilon", epsilon)])
    }
}
