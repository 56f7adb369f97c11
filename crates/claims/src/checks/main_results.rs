//! Section 2: main results.

use super::{Check, checks};

pub(crate) const CHECKS: &[Check] = checks!["main_results":];
