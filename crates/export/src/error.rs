//! Why a figure could not be read or written.

/// What is wrong with a figure, or with what is asked of it.
#[derive(Debug, thiserror::Error)]
pub enum ExportError {
    /// The text is not an SVG that can be drawn.
    #[error("not a drawable SVG: {0}")]
    Unreadable(#[from] resvg::usvg::Error),
    /// A label needs a character that the figures' fonts lack.
    #[error("label `{label}` needs a character that the embedded fonts do not have")]
    Glyph {
        /// The label.
        label: String,
    },
    /// The PDF could not be written.
    #[error("no PDF could be written: {0}")]
    Pdf(String),
    /// The PDF is not laid out as expected.
    #[error("the PDF cannot be put in order: {0}")]
    Layout(&'static str),
    /// The picture would have no or far too many pixels.
    #[error("a picture of {width} by {height} pixels cannot be drawn")]
    Pixels {
        /// Pixels across.
        width: u32,
        /// Pixels down.
        height: u32,
    },
    /// The PNG could not be written.
    #[error("no PNG could be written: {0}")]
    Png(#[from] png::EncodingError),
}
