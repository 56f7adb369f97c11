//! Errors for arguments outside the domain of a formula.

use thiserror::Error;

/// An argument for which a formula of the paper has no value; a theorem that does not apply is not
/// an error of this kind but a [`HypothesesViolated`](crate::hypothesis::HypothesesViolated).
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum TheoryError {
    /// The determinant `delta` lies outside the open interval (0, 1) in which `h_p` is defined.
    #[error("the determinant delta must lie in (0, 1), but is {delta}")]
    DeterminantOutsideUnitInterval {
        /// The determinant, delta.
        delta: f64,
    },
    /// The number of loops is smaller than the formula allows.
    #[error("the number of loops p must be at least {minimum}, but is {loops}")]
    TooFewLoops {
        /// The number of loops, p.
        loops: u32,
        /// The smallest number that is allowed.
        minimum: u32,
    },
    /// 1 is an eigenvalue of `A`, so `I - A` has no inverse.
    #[error("the non-impacting orbit has no unique continuation: det(I - A) = {determinant}")]
    UnitEigenvalue {
        /// The value of det(I - A) = delta - tau + 1: zero, or NaN.
        determinant: f64,
    },
    /// The Jacobian matrix of the VIVID function has no inverse, as happens at a resonance.
    #[error("the VIVID function cannot be solved for y and z: det(J) = {determinant}")]
    SingularVividJacobian {
        /// The value of det(J): zero, or NaN.
        determinant: f64,
    },
    /// No resonance has a limit map with these numbers.
    #[error("no resonance has a limit map with such numbers")]
    NoLimitMap,
    /// The damping ratio lies outside the open interval (0, 1).
    #[error("the damping ratio zeta must lie in (0, 1), but is {zeta}")]
    DampingRatio {
        /// The damping ratio, zeta.
        zeta: f64,
    },
    /// The coefficient of restitution is not a positive number.
    #[error("the coefficient of restitution epsilon must be positive and finite, but is {epsilon}")]
    CoefficientOfRestitution {
        /// The coefficient of restitution, epsilon.
        epsilon: f64,
    },
    /// The forcing frequency is not a positive number.
    #[error("the forcing frequency omega must be positive and finite, but is {omega}")]
    ForcingFrequency {
        /// The forcing frequency, omega.
        omega: f64,
    },
    /// No positive forcing frequency belongs to this index of a resonance.
    #[error("the index n of a resonance with p = {loops} must be at least {minimum}, but is {index}")]
    ResonanceIndex {
        /// The number of loops, p.
        loops: u32,
        /// The index, n.
        index: u32,
        /// The smallest index that is allowed.
        minimum: u32,
    },
    /// The window of forcing frequencies is not of the form 0 < lowest <= highest < infinity.
    #[error("the frequency window [{lowest}, {highest}] must satisfy 0 < lowest <= highest < infinity")]
    FrequencyWindow {
        /// The lowest forcing frequency of the window.
        lowest: f64,
        /// The highest forcing frequency of the window.
        highest: f64,
    },
    /// The window reaches so far down that it contains more resonances than can be listed.
    #[error(
        "the frequency window holds about {count:.3e} resonances with p = {loops}; at most {limit} are listed"
    )]
    TooManyResonances {
        /// The number of loops, p.
        loops: u32,
        /// The approximate number of resonances of this p in the window.
        count: f64,
        /// The largest number of resonances of one p that is listed.
        limit: u32,
    },
}
