//! The figures and tables of the paper as rows.
//!
//! Parameters come in as TOML ([`parameters`]), a [`Study`] computes what is asked for, and each figure is a struct of
//! lists of rows ([`grazing_results`]), declared with the names of their tables. Nothing here draws or writes files.

mod coefficients;
mod diagram;
mod error;
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
pub mod parameters;
pub mod plane;
pub mod published;
mod space;
mod study;
mod sweep;
pub mod unfolded;

pub use coefficients::{CoefficientTable, Coefficients};
pub use error::StudyError;
pub use fig02::Figure2;
pub use fig04::Figure4;
pub use fig05::Figure5;
pub use fig06::Figure6;
pub use fig07::Figure7;
pub use fig08::{Figure8, ShownPanel};
pub use fig10::Figure10;
pub use space::Scene;
pub use study::Study;
pub use sweep::{Generic, Resonant, TheoremsInAction};
