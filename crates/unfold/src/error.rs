//! Why there is nothing to unfold.

use crate::escape::Escape;
use crate::non_impacting::Height;

/// The search for a grazing curve found none.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum UnfoldError {
    /// An end was asked for before anything was found.
    #[error("the search was ended during this: {stage}")]
    Stopped {
        /// What was being done.
        stage: &'static str,
    },
    /// Motion without the wall runs away from wherever it was begun.
    #[error("without the wall all motion that was tried runs away or ends, at {:?} for one", escape.parameters)]
    RunsAway {
        /// How one of the motions ends.
        escape: Escape,
    },
    /// No periodic motion with the period of the forcing was found.
    #[error("no periodic motion with the period of the forcing was found without the wall")]
    NoOrbit,
    /// Periodic motion stays on one side of the wall wherever in the ranges it was followed.
    #[error("periodic motion touches the wall nowhere in the ranges as far as it was followed: its highest points lie between x = {} and x = {}", lowest.position, highest.position)]
    NoGrazing {
        /// The lowest of the highest points.
        lowest: Height,
        /// The highest of them.
        highest: Height,
        /// Every periodic motion that was met was followed through the whole range of the primary
        /// parameter.
        whole: bool,
    },
    /// Where periodic motion comes to the wall it is not turned back.
    #[error("the wall is touched with F = {} at {:?}, which must be negative", at.acceleration, at.parameters)]
    Pushed {
        /// Where it touches.
        at: Height,
    },
}
