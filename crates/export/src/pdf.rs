//! PDF: one page of the figure's size, lines as lines, text as text.

use svg2pdf::{ConversionOptions, PageOptions, to_pdf};

use crate::{ExportError, Figure, canonical};

impl Figure {
    /// The figure as a PDF of one page.
    ///
    /// The page has the physical size of the SVG. Text can be searched and copied; of the fonts only the glyphs that are
    /// used are embedded. The title is that of the SVG; there is no date, so equal figures give equal bytes.
    ///
    /// # Errors
    /// [`ExportError::Pdf`], [`ExportError::Layout`].
    pub fn pdf(&self) -> Result<Vec<u8>, ExportError> {
        let options = ConversionOptions { compress: true, embed_text: true, ..ConversionOptions::default() };
        let pdf = to_pdf(&self.tree, options, PageOptions::default())
            .map_err(|error| ExportError::Pdf(error.to_string()))?;
        canonical::ordered(&pdf, self.title())
    }
}
