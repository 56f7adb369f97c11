//! Errors of drawing.

/// The reason why a figure could not be drawn, in a sentence: a frame is empty, a required coordinate is
/// not finite, there are no panels or too many for a sheet, or a label cannot be set in the embedded
/// fonts.
#[derive(Debug, thiserror::Error)]
#[error("{0}")]
pub struct DrawingError(pub String);
