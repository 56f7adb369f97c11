//! The figures of the paper as SVG, drawn from rows.
//!
//! For each figure of the paper there is a function, [`draw_fig01`] to [`draw_fig10`], that takes what it shows
//! ([`grazing_results`]) and returns the text of an SVG file. Figures 7 and 8 are a [`PlaneDiagram`] and [`Magnifications`], which
//! [`draw_diagram`] and [`draw_magnifications`] draw for the two parameters of any oscillator. This crate knows rows, frames and
//! ink; it computes nothing about impacts, and equal input gives equal bytes.
//!
//! plotters maps data to the sheet, whose lengths are points, and draws on a backend of ours, which writes SVG with two decimals. Curves and
//! polygons are clipped in data space, so that they leave a frame at their own slope, and are split at NaN. Text stays
//! text, in fonts that are embedded in each file and measured when labels are placed.

#[cfg(test)]
mod inspection;
#[cfg(test)]
mod sample_oscillator;
#[cfg(test)]
mod samples;

mod arrow;
mod axes;
mod backend;
mod branches;
mod canvas;
mod clip;
mod cloud;
mod diagram;
mod error;
mod family;
mod fig02;
mod fig04;
mod fig05;
mod fig06;
mod fig10;
mod font;
mod kinds;
mod labels;
mod legend;
mod magnifications;
mod magnified;
mod markup;
mod numbers;
mod one_parameter;
mod panel_grid;
mod passing;
mod placement;
mod portraits;
mod scene;
mod sheet;
mod simplify;
mod space;
mod style;
mod svg;
mod ticks;

pub use diagram::{PlaneDiagram, Section, draw_diagram, draw_fig07};
pub use error::DrawingError;
pub use family::draw_family;
pub use fig02::draw_fig02;
pub use fig04::draw_fig04;
pub use fig05::draw_fig05;
pub use fig06::draw_fig06;
pub use fig10::draw_fig10;
pub use font::FONT_FILES;
pub use magnifications::{Magnifications, draw_fig08, draw_magnifications};
pub use one_parameter::draw_one_parameter;
pub use sheet::Bounds;
pub use space::{draw_fig01, draw_fig03, draw_fig09};
pub use style::SheetWidth;
