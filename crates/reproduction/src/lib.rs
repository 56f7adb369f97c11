//! The figures and tables of the paper: parameters in, rows and sheets out.
//!
//! Parameters are read from TOML ([`parameters`]), and a [`Study`] computes the requested results. Each
//! figure ([`PaperFigure`]) has a file in [`figures`] with its section of the parameter file, its rows,
//! and the functions that compute and draw it. This crate does not write files.

mod coefficients;
mod error;
mod figure;
pub mod figures;
pub mod parameters;
mod published;
mod space;
mod study;
mod sweep;

pub use coefficients::{CoefficientTable, Coefficients};
pub use error::StudyError;
pub use figure::{PaperFigure, Remarks};
pub use study::Study;
pub use sweep::{Generic, Resonant, TheoremsInAction};
