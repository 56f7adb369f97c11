//! Why a resonance could not be analysed.

use grazing_model::maps::MapError;
use grazing_theorems::HypothesesViolated;
use grazing_theorems::from_map::GrazingOrbitError;

use crate::locate::LocateFailure;

/// A resonant grazing point could not be analysed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ResonanceError {
    /// Newton's method for det J = 0 on the grazing curve failed.
    #[error("the resonance was not located: {0}")]
    NotLocated(LocateFailure),
    /// The grazing orbit was not found.
    #[error(transparent)]
    GrazingOrbit(#[from] GrazingOrbitError),
    /// P_global is not smooth there.
    #[error(transparent)]
    Map(#[from] MapError),
    /// A theorem's hypothesis does not hold.
    #[error(transparent)]
    Hypotheses(#[from] HypothesesViolated),
    /// The theory gives a direction in which the numerical equations have no curve.
    #[error("the {curve} curve cannot be started: {reason}")]
    NotStarted {
        /// Which curve.
        curve: &'static str,
        /// Why not.
        reason: String,
    },
}
