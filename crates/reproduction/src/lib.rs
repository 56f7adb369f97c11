//! The figures and tables of the paper: parameters in, rows and sheets out.
//!
//! Parameters come in as TOML ([`parameters`]), and a [`Study`] computes what is asked for. Each
//! figure ([`PaperFigure`]) has a file in [`figures`], with its section of the parameter file, its
//! rows, what computes and what draws them. Nothing here writes files.

mod coefficients;
mod error;
mod figure;
pub mod figures;
pub mod parameters;
mod published;
mod space;
mod study;
mod sweep;
#[cfg(test)]
mod tests;

pub use coefficients::{CoefficientTable, Coefficients};
pub use error::StudyError;
pub use figure::{PaperFigure, Remarks};
pub use study::Study;
pub use sweep::{Generic, Resonant, TheoremsInAction};
