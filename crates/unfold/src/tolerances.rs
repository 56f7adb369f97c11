//! What two things may differ by and still be one, each for what it separates, in dimensionless
//! motion of the order of one.
//!
//! What is solved for is known to some 10⁻¹⁰ (`grazing_continuation::tolerances`), and different
//! ones lie farther apart by orders of magnitude; what is simulated is known to what is left of its
//! transient.

/// Bifurcations on slices, in (y, z) and shares of the range of μ: both were located to some 10⁻¹⁰.
pub(crate) const BETWEEN_BIFURCATIONS: f64 = 1e-6;

/// Bifurcations on branches of a cut that overlap, in shares of the range: the same one is met on
/// both, located alike.
pub(crate) const BETWEEN_EVENTS_ON_A_CUT: f64 = 1e-8;

/// Zeros on lattices of impacts: Newton's method leaves some 10⁻¹⁰.
pub(crate) const BETWEEN_ZEROS: f64 = 1e-6;

/// Resonances, in z and the shares of the ranges: located to some 10⁻¹⁰.
pub(crate) const BETWEEN_RESONANCES: f64 = 1e-6;

/// Grazing orbits at one η, in the share of the range of μ and the cosine of the phase: Newton's
/// method leaves far less.
pub(crate) const BETWEEN_GRAZING_ORBITS: f64 = 1e-6;

/// Heights, in proportion: which of two that are equal is named is not left to rounding.
pub(crate) const BETWEEN_HEIGHTS: f64 = 1e-9;

/// Impacts and states of orbits that have settled, to far less.
pub(crate) const BETWEEN_ORBITS: f64 = 1e-3;

/// Impacts of attractors that wander about: of one attractor they lie this close to each other, as
/// so many fill it.
pub(crate) const BETWEEN_WANDERING_ORBITS: f64 = 0.03;

/// An impact and the next one, in proportion: the same one is met to rounding over y², which is
/// below this for y above 10⁻⁶.
pub(crate) const BETWEEN_RETURNS: f64 = 1e-3;
