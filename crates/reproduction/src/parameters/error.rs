//! What can be wrong with a section of the parameter file.

use grazing_source::SourceError;
use thiserror::Error;

/// The first thing in a section of the parameter file that is not right, and what would be.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ParameterError {
    /// It would be wrong whatever the oscillator is: no TOML, an unknown or missing key, a value
    /// outside its domain.
    #[error(transparent)]
    Malformed(#[from] SourceError),
    /// It does not fit the oscillator, or the window that goes with it: with another zeta it may
    /// well be right.
    #[error(transparent)]
    Unfit(SourceError),
}
