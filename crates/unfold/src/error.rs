//! Reasons why there is nothing to unfold.

use grazing_results::{Dimension, Dimensioned};

use crate::escape::Escape;
use crate::non_impacting::Height;

/// The reason why no grazing curve was found.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum UnfoldError {
    /// The computation was cancelled before anything was found.
    #[error("the search was ended during this: {stage}")]
    Stopped {
        /// The stage that was running.
        stage: &'static str,
    },
    /// Motion without the wall runs away from every start that was tried.
    #[error("without the wall all motion that was tried runs away or ends, at {:?} for one", escape.parameters)]
    RunsAway {
        /// The end of one of the motions.
        escape: Escape,
    },
    /// No periodic motion with the period of the forcing was found.
    #[error("no periodic motion with the period of the forcing was found without the wall")]
    NoOrbit,
    /// Periodic motion stays on one side of the wall wherever it was followed in the ranges.
    #[error("periodic motion touches the wall nowhere in the ranges as far as it was followed: its highest points lie between x = {} and x = {}", lowest.position, highest.position)]
    NoGrazing {
        /// The lowest of the highest points.
        lowest: Height,
        /// The highest of them.
        highest: Height,
        /// Whether every periodic motion that was found was followed through the whole range of the
        /// primary parameter.
        whole: bool,
    },
    /// Periodic motion is not turned back where it reaches the wall.
    #[error("the wall is touched with F = {} at {:?}, which must be negative", at.acceleration, at.parameters)]
    Pushed {
        /// The point at which it touches the wall.
        at: Height,
    },
}

impl Dimensioned for UnfoldError {
    fn each_number(&mut self, visit: &mut dyn FnMut(Dimension, &mut f64)) {
        match self {
            Self::RunsAway { escape } => escape.each_number(visit),
            Self::NoGrazing { lowest, highest, .. } => {
                lowest.each_number(visit);
                highest.each_number(visit);
            }
            Self::Pushed { at } => at.each_number(visit),
            Self::NoOrbit | Self::Stopped { .. } => {}
        }
    }
}
