//! Drawing on a sheet: fonts, pens, text and lines as SVG, labels and legends.

pub mod arrow;
mod backend;
pub mod canvas;
pub mod elements;
pub mod font;
pub mod labels;
pub mod legend;
pub mod markers;
pub mod markup;
pub(crate) mod measured;
pub(crate) mod sheet;
pub mod style;
pub mod svg;
