//! The figures in the formats of journals, PDF and PNG.
//!
//! [`Drawing::read`] reads the SVG that `grazing-drawing` writes. [`Drawing::pdf`] keeps lines as
//! lines and text as text, with the glyphs that are used embedded; [`Drawing::png`] draws pixels at
//! a resolution; [`Drawing::tree`] has all elements, for checks of their positions; [`comparison`]
//! places two versions of a figure side by side. Sheets are measured in points (1/72 inch), as in
//! the SVG.
//!
//! Only the fonts of the figures are used here, never the system's, so that equal input gives equal
//! bytes on every machine. A character that these fonts lack is an error, not a box.
//!
//! svg2pdf and resvg are built without optimisation like all dependencies, except for the crates
//! that process every pixel.

mod comparison;
mod error;
mod figure;
mod pdf;
mod raster;

pub use comparison::comparison;
pub use error::FormatError;
pub use figure::Drawing;
