//! All checks, by section of the paper.

pub(crate) mod appendices;
pub(crate) mod generic;
pub(crate) mod main_results;
pub(crate) mod oscillator;
pub(crate) mod resonant;

use crate::outcome::CheckResult;

/// A check under the name that the ledger gives: section, module and function, as `resonant::stability::trace`, which
/// stands in `src/checks/resonant/stability.rs`.
#[derive(Debug, Clone, Copy)]
pub struct Check {
    /// The name.
    pub name: &'static str,
    /// Measures how well the statement holds.
    pub run: fn() -> CheckResult,
}

/// The checks of all sections, in the order of the paper.
pub fn all() -> impl Iterator<Item = &'static Check> {
    [main_results::CHECKS, oscillator::CHECKS, generic::CHECKS, resonant::CHECKS, appendices::CHECKS]
        .into_iter()
        .flatten()
}

/// The checks of a section: `checks!("generic": maps::virtual_points, vivid::determinants)`.
macro_rules! checks {
    ($section:literal: $($module:ident :: $function:ident),* $(,)?) => {
        &[$($crate::checks::Check {
            name: concat!($section, "::", stringify!($module), "::", stringify!($function)),
            run: $module::$function,
        }),*]
    };
}

pub(crate) use checks;
