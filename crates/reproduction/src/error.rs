//! Errors of the reproduction with valid parameters.

use grazing_model::OscillatorError;
use grazing_theorems::{HypothesesViolated, TheoryError};
use grazing_unfold::UnfoldError;

use crate::parameters::ParameterError;

/// The reason why a computation of the reproduction failed.
#[derive(Clone, Debug, thiserror::Error)]
pub enum StudyError {
    /// The section of the parameter file is invalid.
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
    /// The solution of a portrait does not exist at its amplitude: the key in the file that requests it,
    /// and a remedy.
    #[error("{0}")]
    NoPortrait(String),
    /// Another object does not exist at these parameters; the text is a sentence.
    #[error("{0}")]
    Failed(String),
    /// A case of the sweep over the theorems could not be computed.
    #[error("theorems 2.2 to 2.5: {0}")]
    Sweep(String),
}
