//! The package `grazing` for Python. All computations are those of [`grazing_cli::library`], as for
//! the command line.
//!
//! | module | |
//! |---|---|
//! | `model` | an oscillator and its computations |
//! | `compute` | computations in a separate thread, which Ctrl-C cancels and which report their progress |
//! | `table` | tables, which are exported by Arrow's C interface |

mod compute;
mod model;
mod table;

use pyo3::prelude::*;

/// The contents of `grazing` that are written in Rust.
#[pymodule]
mod _grazing {
    #[pymodule_export]
    use super::model::{Model, Results, looks, outputs, read, reproduce};
    #[pymodule_export]
    use super::table::Table;
}
