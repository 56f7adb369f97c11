//! Drawing of figures: rows in, SVG out.
//!
//! [`draw_diagram`], [`draw_magnifications`], [`draw_straightened`], [`draw_one_parameter`],
//! [`draw_place`] and [`draw_family`] take the rows of a figure of any oscillator ([`grazing_results`])
//! and return a [`Sheet`]: the drawn elements, with title and description. The figures of the paper are
//! composed from these functions and from the parts below, each beside its rows. This crate knows rows,
//! frames and ink; it computes nothing about impacts, and equal input gives equal bytes.
//!
//! The files form four layers, each of which uses only those below it: `figures`, [`plot`]
//! (parts of figures: axes, grids of panels, curves, scenes), [`ink`] (fonts, pens, SVG, labels,
//! legends) and [`geometry`].
//!
//! plotters maps data to the sheet, whose lengths are in points; SVG is written with two decimals. Curves
//! and polygons are clipped in data space, so that they leave a frame with their own slope, and are split
//! at NaN. Text remains text, in fonts that are embedded in each file and measured when labels are
//! placed.

mod error;
mod figures;
pub mod geometry;
pub mod ink;
pub mod plot;
#[cfg(test)]
mod tests;

pub use error::DrawingError;
pub use figures::diagram::draw_diagram;
pub use figures::family::draw_family;
pub use figures::look::Look;
pub use figures::magnifications::{draw_magnifications, draw_straightened};
pub use figures::one_parameter::draw_one_parameter;
pub use figures::place::draw_place;
pub use geometry::sheet::Bounds;
pub use ink::font::{FONT_FILES, FORMULA_FONT, style_sheet};
pub use ink::markup::unmarked;
pub use ink::sheet::{Element, PanelMark, Path, Sheet};
pub use ink::style::SheetWidth;
pub use ink::svg::POINTS_PER_MM;
pub use plot::axes::Heading;
