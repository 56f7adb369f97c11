//! Appendices A and B.

use super::{Check, checks};

pub(crate) const CHECKS: &[Check] = checks!["appendices":];
