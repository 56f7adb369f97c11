//! What the tests of figures share: samples to draw, and a look at what was drawn.

pub(crate) mod inspection;
mod legends;
pub(crate) mod sample_oscillator;
pub(crate) mod samples;
