//! Geometry on the sheet and in data space: clipping, thinning, outlines, positions of labels.

pub mod clip;
pub(crate) mod passing;
pub mod placement;
pub(crate) mod shapes;
pub mod sheet;
pub(crate) mod simplify;
