//! The package `grazing` for Python. It computes nothing itself: [`grazing_cli::library`] does, as for the command line.
//!
//! | module | |
//! |---|---|
//! | `model` | an oscillator and what is computed of it |
//! | `compute` | computations in a thread of their own, which Ctrl-C ends and which tell how far they are |
//! | `table` | tables, which leave by Arrow's C interface |

mod compute;
mod model;
mod table;

use pyo3::prelude::*;

/// What `grazing` is made of.
#[pymodule]
mod _grazing {
    #[pymodule_export]
    use super::model::{Model, Results, looks, outputs, read, reproduce};
    #[pymodule_export]
    use super::table::Table;
}
