//! Section 3: the harmonically forced linear oscillator.

use super::{Check, checks};

pub(crate) const CHECKS: &[Check] = checks!["oscillator":];
