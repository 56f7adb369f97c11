//! The figures and tables of the paper as rows.
//!
//! Parameters come in as TOML ([`parameters`]), a [`Study`] computes what is asked for, and each
//! figure is what it shows, as [`grazing_results`] has it. Nothing here draws or writes files.

mod coefficients;
mod described;
mod error;
pub mod family;
mod fig01;
mod fig02;
mod fig03;
mod fig04;
mod fig05;
mod fig06;
mod fig07;
mod fig08;
mod fig09;
mod fig10;
pub mod one_parameter;
pub mod parameters;
pub mod plane;
mod space;
mod study;
mod sweep;
pub mod unfolded;

pub use coefficients::{CoefficientTable, Coefficients};
pub use error::StudyError;
pub use study::Study;
pub use sweep::{Generic, Resonant, TheoremsInAction};
