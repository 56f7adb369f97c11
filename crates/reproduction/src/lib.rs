//! The figures and tables of the paper as data frames.
//!
//! Parameters come in as TOML ([`parameters`]), a [`Study`] computes what is asked for, and each figure is a struct of
//! [`Table`]s. Nothing here draws or writes files.

mod coefficients;
mod diagram;
mod error;
mod fig02;
mod fig07;
mod fig08;
mod grazing_curve;
pub mod parameters;
pub mod progress;
pub mod published;
mod regions;
mod study;
mod sweep;
mod table;

pub use coefficients::Coefficients;
pub use error::StudyError;
pub use fig02::Figure2;
pub use fig07::Figure7;
pub use fig08::Figure8;
pub use study::Study;
pub use sweep::TheoremsInAction;
pub use table::Table;
