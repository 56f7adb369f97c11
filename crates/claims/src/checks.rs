//! All checks, by section of the paper.

use crate::outcome::CheckResult;

/// A check with its name in the ledger, as `resonant::stability::trace`: section, module, function.
#[derive(Debug, Clone, Copy)]
pub struct Check {
    /// The name.
    pub name: &'static str,
    /// The function that measures how well the statement holds.
    pub run: fn() -> CheckResult,
}

/// The checks that claims name, by name; `build.rs` generates the table from the ledger.
pub const CHECKS: &[Check] = include!(concat!(env!("OUT_DIR"), "/checks.rs"));

/// Declares checks as rows of a table: a name, and a measurement.
///
/// `name: drawn(seed, samples) |sampler; largest: Deviations| { .. } =>
/// largest.outcome(..);` has a source of samples, a block that adds each sample to a tally, and the
/// outcome. The measurement may also be any other `CheckResult`.
macro_rules! checks {
    () => {};
    (
        $(#[$doc:meta])*
        $name:ident: $over:ident($($of:expr),*) |$($subject:tt),*; $tally:tt: $kind:ty| $body:block => $outcome:expr;
        $($rest:tt)*
    ) => {
        $(#[$doc])*
        pub(crate) fn $name() -> $crate::CheckResult {
            let tally = $over($($of,)* |$($subject,)* $tally: &mut $kind| {
                $body
                Ok(())
            });
            tally.map(|$tally| $outcome)
        }
        checks! { $($rest)* }
    };
    ($(#[$doc:meta])* $name:ident: $measured:expr; $($rest:tt)*) => {
        $(#[$doc])*
        pub(crate) fn $name() -> $crate::CheckResult {
            $measured
        }
        checks! { $($rest)* }
    };
}

/// Section 1, introduction, and section 2, main results.
pub(crate) mod main_results {
    pub(crate) mod auxiliary;
    pub(crate) mod coefficients;
    pub(crate) mod curves;
    pub(crate) mod first_figures;
    pub(crate) mod global_map;
    pub(crate) mod grazing_point;
    pub(crate) mod non_impacting;
    pub(crate) mod resonant;
    pub(crate) mod returns;
    pub(crate) mod system;
    pub(crate) mod theorems;
}

/// Section 3: the harmonically forced linear oscillator.
pub(crate) mod oscillator {
    pub(crate) mod coefficients;
    pub(crate) mod diagram;
    pub(crate) mod grazing;
    pub(crate) mod motion;
    pub(crate) mod propositions;
    pub(crate) mod resonances;
}

/// Section 4: calculations for generic grazing bifurcations.
pub(crate) mod generic {
    pub(crate) mod determinants;
    pub(crate) mod emerging;
    pub(crate) mod expansions;
    pub(crate) mod iterates;
    pub(crate) mod maps;
    pub(crate) mod path;
    pub(crate) mod polygon;
    pub(crate) mod vivid;
}

/// Section 5: calculations for resonant grazing bifurcations; section 6: discussion.
pub(crate) mod resonant {
    pub(crate) mod branch;
    pub(crate) mod criticality;
    pub(crate) mod curves;
    pub(crate) mod derivatives;
    pub(crate) mod discussion;
    pub(crate) mod more_loops;
    pub(crate) mod simulation;
    pub(crate) mod stability;
    pub(crate) mod visits;
}

/// Appendices A and B.
pub(crate) mod appendices {
    pub(crate) mod closed_forms;
    pub(crate) mod eigenvalues;
    pub(crate) mod oscillator;
    pub(crate) mod polar;
    pub(crate) mod printed_flow;
    pub(crate) mod signs;
}
