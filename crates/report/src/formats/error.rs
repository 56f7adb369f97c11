//! Errors in reading and writing figures.

/// The fault of a figure, or of a request for it, in a sentence.
#[derive(Debug, thiserror::Error)]
#[error("{0}")]
pub struct FormatError(pub(crate) String);

impl From<resvg::usvg::Error> for FormatError {
    fn from(error: resvg::usvg::Error) -> Self {
        Self(format!("not a drawable SVG: {error}"))
    }
}

impl From<png::EncodingError> for FormatError {
    fn from(error: png::EncodingError) -> Self {
        Self(format!("no PNG could be written: {error}"))
    }
}
