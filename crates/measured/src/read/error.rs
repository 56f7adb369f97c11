//! Errors in files of measurements.

use grazing_input::SourceError;
use thiserror::Error;

/// An error in a file of measurements.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum MeasurementError {
    /// The file cannot be read.
    #[error(transparent)]
    Unreadable(#[from] SourceError),
    /// Something in the file is wrong.
    #[error("{place}: {reason}")]
    Wrong {
        /// The file, with the line where there is one.
        place: String,
        /// The mistake, and how to correct it.
        reason: String,
    },
}
