//! Errors in a section of the parameter file.

use grazing_input::SourceError;
use thiserror::Error;

/// The first error in a section of the parameter file, with a remedy.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ParameterError {
    /// The section is invalid for any oscillator: the text is not valid TOML, a key is unknown or
    /// missing, or a value is outside its domain.
    #[error(transparent)]
    Malformed(#[from] SourceError),
    /// The section does not fit the oscillator, or the window that goes with it; with another zeta it may
    /// be valid.
    #[error(transparent)]
    Unfit(SourceError),
}
