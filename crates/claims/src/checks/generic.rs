//! Section 4: calculations for generic grazing bifurcations.

use super::{Check, checks};

pub(crate) const CHECKS: &[Check] = checks!["generic":];
