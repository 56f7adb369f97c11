//! The figures, one file each.

pub(crate) mod diagram;
pub(crate) mod family;
pub(crate) mod fig04;
pub(crate) mod fig05;
pub(crate) mod fig06;
pub(crate) mod fig10;
pub(crate) mod magnifications;
pub(crate) mod one_parameter;
pub(crate) mod space;
