//! Section 5: calculations for resonant grazing bifurcations.

use super::{Check, checks};

pub(crate) const CHECKS: &[Check] = checks!["resonant":];
