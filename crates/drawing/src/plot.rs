//! Parts of figures: axes, grids of panels, curves, points and regions by their kind, scenes in
//! phase space.

pub mod axes;
pub(crate) mod branches;
pub mod cloud;
pub mod kinds;
pub(crate) mod magnified;
pub(crate) mod measured;
pub(crate) mod numbers;
pub(crate) mod own;
pub(crate) mod panel_grid;
pub(crate) mod portraits;
pub mod scene;
pub(crate) mod ticks;
