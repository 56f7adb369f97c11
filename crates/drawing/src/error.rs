//! What can be wrong with what is handed in.

/// Why a figure could not be drawn: what is wrong with its rows or frames, in a sentence.
#[derive(Debug, thiserror::Error)]
#[error("{0}")]
pub struct DrawingError(pub(crate) String);
