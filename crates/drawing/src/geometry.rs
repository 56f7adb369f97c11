//! Geometry on the sheet and in data space: clipping, thinning, outlines, places for labels.

pub(crate) mod clip;
pub(crate) mod passing;
pub(crate) mod placement;
pub(crate) mod shapes;
pub(crate) mod sheet;
pub(crate) mod simplify;
