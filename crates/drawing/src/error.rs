//! Errors of drawing.

/// Why a figure could not be drawn, in a sentence: a frame is empty, a coordinate that must be
/// there is not finite, there are more panels than a sheet has room for or none, or a label cannot
/// be set in the embedded fonts.
#[derive(Debug, thiserror::Error)]
#[error("{0}")]
pub struct DrawingError(pub String);
