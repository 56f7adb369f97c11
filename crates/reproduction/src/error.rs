//! What can go wrong in the reproduction with parameters that are valid.

use grazing_continuation::resonance::ResonanceError;
use grazing_model::OscillatorError;
use grazing_model::maps::MapError;
use grazing_theorems::{HypothesesViolated, TheoryError};
use grazing_unfold::UnfoldError;

use crate::parameters::ParameterError;

/// A computation of the reproduction failed.
#[derive(Clone, Debug, thiserror::Error)]
pub enum StudyError {
    /// The section of the parameter file is not right.
    #[error(transparent)]
    Parameters(#[from] ParameterError),
    /// A parameter is outside the oscillator's domain.
    #[error(transparent)]
    Oscillator(#[from] OscillatorError),
    /// A parameter is outside a formula's domain.
    #[error(transparent)]
    Theory(#[from] TheoryError),
    /// A theorem that a figure illustrates does not apply at its parameters.
    #[error(transparent)]
    Hypotheses(#[from] HypothesesViolated),
    /// There is no grazing in the window.
    #[error(transparent)]
    Unfold(#[from] UnfoldError),
    /// A resonance was seen and could not be located.
    #[error("the resonance of p = {loops} near {near:?} is missing: {source}")]
    Unlocated {
        /// Number of loops p.
        loops: u32,
        /// The parameters (A, omega) near which it was seen.
        near: [f64; 2],
        /// What went wrong.
        source: ResonanceError,
    },
    /// A resonance could not be unfolded.
    #[error("resonance p = {loops}, n = {n}: a curve is missing: {source}")]
    Resonance {
        /// Number of loops p.
        loops: u32,
        /// The integer n of the resonance.
        n: u32,
        /// What went wrong.
        source: ResonanceError,
    },
    /// A branch of Figure 2 could not be started at the grazing bifurcation.
    #[error("the branch of {loops}-loop solutions cannot be started at the grazing bifurcation: {reason}")]
    Branch {
        /// Number of loops p.
        loops: u32,
        /// Why not.
        reason: String,
    },
    /// A portrait's solution does not exist at its amplitude.
    #[error("{key}: no stable admissible {loops}-loop solution is there for a phase portrait; {remedy}")]
    NoPortrait {
        /// The key of the portrait, with file, line and value.
        key: String,
        /// Number of loops p.
        loops: u32,
        /// Where there is one.
        remedy: String,
    },
    /// No panel of Figure 8 has a resonance that was found in Figure 7.
    #[error(
        "the resonance p = {loops}, n = {n} of the first panel was not found, nor can another be shown; choose others in fig08.panels"
    )]
    NoPanel {
        /// Number of loops p.
        loops: u32,
        /// The integer n of the resonance.
        n: u32,
    },
    /// An orbit of Figure 1 is not there.
    #[error(
        "figure 1: the orbit through (0, {velocity}, {phase}) on Sigma, begun {before} in phase earlier, meets the wall at \
         another place first"
    )]
    Arrival {
        /// The velocity y on Σ.
        velocity: f64,
        /// The phase z on Σ.
        phase: f64,
        /// By how much phase earlier it begins.
        before: f64,
    },
    /// A map between Σ and Π is not defined at a point of a figure.
    #[error("figure {figure}: {source}")]
    Map {
        /// The figure's number.
        figure: u32,
        /// What went wrong.
        source: MapError,
    },
    /// A case of the sweep over the theorems could not be worked out.
    #[error("theorems 2.2 to 2.5: {0}")]
    Sweep(#[from] grazing_claims::sweep::SweepError),
}

impl StudyError {
    pub(crate) fn resonance(loops: u32, n: u32, source: ResonanceError) -> Self {
        Self::Resonance { loops, n, source }
    }
}
