//! Helpers for the tests of figures: samples to draw, and inspection of the drawn result.

pub(crate) mod inspection;
mod legends;
pub(crate) mod sample_oscillator;
pub(crate) mod samples;
