//! The figures available for any oscillator, one file each.

pub(crate) mod diagram;
pub(crate) mod family;
pub(crate) mod look;
pub(crate) mod magnifications;
pub(crate) mod one_parameter;
pub(crate) mod place;
