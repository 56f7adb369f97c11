//! What can go wrong in the reproduction with parameters that are valid.

use grazing_model::OscillatorError;
use grazing_theorems::{HypothesesViolated, TheoryError};
use grazing_unfold::UnfoldError;

use crate::parameters::ParameterError;

/// A computation of the reproduction failed.
#[derive(Clone, Debug, thiserror::Error)]
pub enum StudyError {
    /// The section of the parameter file is not right.
    #[error(transparent)]
    Parameters(#[from] ParameterError),
    /// A parameter is outside the oscillator's domain.
    #[error(transparent)]
    Oscillator(#[from] OscillatorError),
    /// A parameter is outside a formula's domain.
    #[error(transparent)]
    Theory(#[from] TheoryError),
    /// A theorem that a figure illustrates does not apply at its parameters.
    #[error(transparent)]
    Hypotheses(#[from] HypothesesViolated),
    /// There is no grazing in the window.
    #[error(transparent)]
    Unfold(#[from] UnfoldError),
    /// A portrait's solution does not exist at its amplitude: the key of the file that asks for it,
    /// and what would be right.
    #[error("{0}")]
    NoPortrait(String),
    /// Something else is not there at these parameters, in a sentence.
    #[error("{0}")]
    Failed(String),
    /// A case of the sweep over the theorems could not be worked out.
    #[error("theorems 2.2 to 2.5: {0}")]
    Sweep(String),
}
