//! The figures of the paper as SVG, drawn from rows.
//!
//! For the two parameters of any oscillator there are [`Diagram`] with [`draw_diagram`], and [`Magnifications`] with
//! [`draw_magnifications`]; Figures 7 and 8 of the paper are two of them. For each of its other figures there is a
//! function of its own: [`draw_fig01`], [`draw_fig02`], and so on. A function gets rows ([`grazing_results`]) and windows, and returns the text of an SVG file. This crate
//! knows rows, windows and ink; it computes nothing about impacts, and equal input gives equal bytes.
//!
//! plotters maps data to the sheet, whose lengths are points, and draws on a backend of ours, which writes SVG with two decimals. Curves and
//! polygons are clipped in data space, so that they leave a window at their own slope, and are split at NaN. Text stays
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
mod captions;
mod clip;
mod cloud;
mod diagram;
mod error;
mod fig01;
mod fig02;
mod fig03;
mod fig04;
mod fig05;
mod fig06;
mod fig09;
mod fig10;
mod font;
mod kinds;
mod labels;
mod magnifications;
mod magnified;
mod markup;
mod numbers;
mod panel_grid;
mod passing;
mod placement;
mod plane;
mod portraits;
mod scene;
mod sheet;
mod simplify;
mod style;
mod svg;
mod ticks;

pub use clip::Window;
pub use diagram::{Diagram, Section, draw_diagram};
pub use error::DrawingError;
pub use fig01::draw_fig01;
pub use fig02::{Figure02, draw_fig02};
pub use fig03::draw_fig03;
pub use fig04::draw_fig04;
pub use fig05::{Figure05, draw_fig05};
pub use fig06::draw_fig06;
pub use fig09::draw_fig09;
pub use fig10::draw_fig10;
pub use font::FONT_FILES;
pub use magnifications::{Magnifications, MagnifiedPanel, draw_magnifications};
pub use plane::{Axis, Plane};
pub use scene::SpaceFigure;
pub use style::SheetWidth;
