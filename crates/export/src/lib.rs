//! The figures as a journal takes them, PDF and PNG.
//!
//! [`Drawing::read`] reads the SVG that `grazing-drawing` makes. [`Drawing::pdf`] keeps lines as
//! lines and text as text, with the glyphs that are used embedded; [`Drawing::png`] draws pixels at
//! a resolution; [`Drawing::tree`] has all elements, for checks of where they lie; [`comparison`]
//! sets two versions of a figure side by side. Sheets are measured in points (1/72 inch), as in the
//! SVG.
//!
//! Only the fonts of the figures are known here, never the system's, so that equal input gives
//! equal bytes on every machine. A character that these fonts lack is an error, not a box.
//!
//! svg2pdf and resvg are built without optimisation like all dependencies, but for the crates that
//! touch every pixel.

#![forbid(unsafe_code)]

mod comparison;
mod error;
mod figure;
mod pdf;
mod raster;

pub use comparison::comparison;
pub use error::ExportError;
pub use figure::Drawing;
