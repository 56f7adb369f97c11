//! The figures and tables of the paper: parameters in, rows and sheets out.
//!
//! Parameters are read from TOML ([`parameters`]), and a [`Study`] computes the requested results. Each
//! figure ([`StudyFigure`]) has a file in [`figures`] with its section of the parameter file, its rows,
//! and the functions that compute and draw it. Figures beyond the paper are made in the same way, with the
//! same imports ([`prelude`]), in `grazing_beyond`, where the list of all figures stands and so the whole
//! parameter file is read. This crate does not write files.

mod coefficients;
mod error;
mod figure;
pub mod figures;
pub mod parameters;
mod published;
mod space;
mod study;
mod sweep;

pub use coefficients::{CoefficientTable, ComparedCoefficients};
pub use error::StudyError;
pub use figure::{Remarks, StudyFigure, prelude};
pub use study::{Study, forced};
pub use sweep::{Generic, Resonant, TheoremsInAction};
