//! The figures of the paper as SVG, drawn from rows.
//!
//! For each figure there is a function, such as [`draw_fig04`], that takes what it shows
//! ([`grazing_results`]) and returns a [`Sheet`]: what is drawn, and what the figure says of
//! itself. [`draw_diagram`] and [`draw_magnifications`] draw Figures 7 and 8, and the like of any
//! oscillator. This crate knows rows, frames and ink; it computes nothing about impacts, and equal
//! input gives equal bytes.
//!
//! The files stand on four floors, each of which uses only those below it: `figures`, `plot` (parts
//! of figures: axes, grids of panels, curves, scenes), `ink` (fonts, pens, SVG, labels, legends)
//! and `geometry`.
//!
//! plotters maps data to the sheet, whose lengths are points; SVG is written with two decimals.
//! Curves and polygons are clipped in data space, so that they leave a frame at their own slope,
//! and are split at NaN. Text stays text, in fonts that are embedded in each file and measured when
//! labels are placed.

mod error;
mod figures;
mod geometry;
mod ink;
mod plot;
#[cfg(test)]
mod tests;

pub use error::DrawingError;
pub use figures::diagram::draw_diagram;
pub use figures::family::draw_family;
pub use figures::fig04::draw_fig04;
pub use figures::fig05::draw_fig05;
pub use figures::fig06::draw_fig06;
pub use figures::fig10::draw_fig10;
pub use figures::magnifications::draw_magnifications;
pub use figures::one_parameter::{draw_fig02, draw_one_parameter};
pub use figures::space::{draw_fig01, draw_fig03, draw_fig09};
pub use geometry::sheet::Bounds;
pub use ink::font::{FONT_FILES, style_sheet};
pub use ink::sheet::{Element, PanelMark, Path, Sheet};
pub use ink::style::SheetWidth;
pub use ink::svg::POINTS_PER_MM;
pub use plot::axes::Heading;
