//! What puts ink on a sheet: fonts, pens, text and lines as SVG, labels and legends.

pub(crate) mod arrow;
pub(crate) mod canvas;
pub(crate) mod font;
pub(crate) mod labels;
pub(crate) mod legend;
pub(crate) mod markup;
pub(crate) mod sheet;
pub(crate) mod style;
pub(crate) mod svg;
