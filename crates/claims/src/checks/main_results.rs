//! Section 2: main results.

mod theorems;

use super::{Check, checks};

pub(crate) const CHECKS: &[Check] = checks!["main_results":
    theorems::generic_grazing_one_loop,
    theorems::generic_grazing_p_loops,
    theorems::resonant_grazing_one_loop,
    theorems::resonant_grazing_p_loops,
];
