//! Errors of drawing.

use plotters::drawing::DrawingAreaErrorKind;
use plotters_backend::DrawingErrorKind;

/// The reason why a figure could not be drawn, in a sentence: a frame is empty, a required coordinate is
/// not finite, there are no panels or too many for a sheet, or a label cannot be set in the embedded
/// fonts.
#[derive(Debug, thiserror::Error)]
#[error("{0}")]
pub struct DrawingError(pub String);

impl From<DrawingAreaErrorKind<DrawingError>> for DrawingError {
    fn from(error: DrawingAreaErrorKind<DrawingError>) -> Self {
        match error {
            DrawingAreaErrorKind::BackendError(DrawingErrorKind::DrawingError(own)) => own,
            other => DrawingError(other.to_string()),
        }
    }
}
