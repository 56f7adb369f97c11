//! Largest differences between two results that count as one, for each kind of result, in
//! dimensionless motion of the order of one.
//!
//! Solutions are known to some 10⁻¹⁰ (`grazing_continuation::tolerances`), and different ones lie
//! farther apart by orders of magnitude; simulated motion is known up to the remainder of its
//! transient.

/// Bifurcations on slices, in (y, z) and fractions of the range of μ: both were located to some
/// 10⁻¹⁰.
pub(crate) const BETWEEN_BIFURCATIONS: f64 = 1e-6;

/// Bifurcations on overlapping branches of a cut, in fractions of the range: the same one is found
/// on both, located alike.
pub(crate) const BETWEEN_EVENTS_ON_A_CUT: f64 = 1e-8;

/// Zeros on lattices of impacts: Newton's method leaves some 10⁻¹⁰.
pub(crate) const BETWEEN_ZEROS: f64 = 1e-6;

/// Resonances, in z and the fractions of the ranges: located to some 10⁻¹⁰.
pub(crate) const BETWEEN_RESONANCES: f64 = 1e-6;

/// Grazing orbits at one η, in the fraction of the range of μ and the cosine of the phase: Newton's
/// method leaves far less.
pub(crate) const BETWEEN_GRAZING_ORBITS: f64 = 1e-6;

/// Heights, as a relative difference: the choice between two that are equal is not left to
/// rounding.
pub(crate) const BETWEEN_HEIGHTS: f64 = 1e-9;

/// Impacts and states of orbits that have settled, to far better accuracy.
pub(crate) const BETWEEN_ORBITS: f64 = 1e-3;

/// Phases at which the force releases motion from rest: zeros of the force at the wall, exact but for its
/// rounding.
pub(crate) const BETWEEN_RELEASES: f64 = 1e-9;

/// Impacts of irregular attractors: those of one attractor lie this close to each other, since so
/// many fill it.
pub(crate) const BETWEEN_WANDERING_ORBITS: f64 = 0.03;

/// An impact and the next one, as a relative difference: the same one is reached to rounding over
/// y², which is below this for y above 10⁻⁶.
pub(crate) const BETWEEN_RETURNS: f64 = 1e-3;

/// Accuracy of drawn curves, as a fraction of the ranges.
pub(crate) const DRAWN: f64 = 1e-4;
/// A point farther from curves than this, in fractions of the ranges, is on the side on which it is
/// drawn.
pub(crate) const CLEAR: f64 = 3.0 * DRAWN;
