//! Thresholds for motion of the order of one: which numbers count as zero, as lost and as too long.
//! Constants that belong to a single method are defined beside it: the step of the collocation, the
//! choice of units.

/// Below this width two zeros of the velocity count as one (empirical: far above rounding, far
/// below any motion).
pub(crate) const NARROWEST_CELL: f64 = 1e-9;

/// A step of Halley's method this short is the last on the way to an event: its error is of third
/// order, about 10⁻¹⁸, and the kinematics at its end follow by Taylor's formula, exact to rounding
/// as well.
pub(crate) const LAST_STEP_TO_EVENT: f64 = 1e-6;

/// Upper bound on the iterations towards an event: bisection alone empties a bracket of doubles in
/// at most about 60 steps near 1; twice that is ample.
pub(crate) const STEPS_TO_EVENT: usize = 128;

/// Upper bound on the cells that the search for a zero of the velocity examines. Motion visible to
/// the eye needs some hundred; where the oscillator is at rest except for rounding, or the forcing
/// hardly moves, the search would never end (empirical: some milliseconds).
pub(crate) const MOST_CELLS: u32 = 100_000;

/// A step of Halley's method this short is the last on the way to Π: its error is of third order,
/// about 10⁻¹⁵, as rounding of the time; the flow is evaluated at its end.
pub(crate) const LAST_STEP_TO_SECTION: f64 = 1e-5;

/// Newton's method for P_virt⁻¹, of second order, ends with a step of this fraction of the
/// evolution time: what is left is of the order of its square.
pub(crate) const LAST_STEP_TO_WALL: f64 = 1e-9;

/// An event time this many forcing periods from where it was expected is rejected: an oscillator at
/// rest, for instance, satisfies the equation at any time.
pub(crate) const MOST_PERIODS: f64 = 20.0;

/// Either method for an event time converges within this many steps or is lost.
pub(crate) const MOST_ITERATIONS: usize = 50;

/// Recoil slower than this, pressed by ẍ > 0, may be too slow to be followed impact by impact.
pub(crate) const SLOW_RECOIL: f64 = 1e-3;

/// Rounding of the position of motion of the order of one.
pub(crate) const ROUNDING_OF_POSITION: f64 = 1e-15;

/// Time by which the last flights of impacts that accumulate, as a geometric series, may be wrong.
pub(crate) const GEOMETRIC: f64 = 1e-13;

/// A flight that rises less than this from the wall is lost in rounding of x, some 10⁻¹⁶, of which
/// two or three digits must be left.
pub(crate) const LEAST_RISE: f64 = 1e-13;

/// Impacts that are too slow to be followed are summed up to this number: with a restitution of
/// 0.9999 a hundred thousand are left, and with more flights soon are below rounding, as rest is.
pub(crate) const MOST_IMPACTS_LEFT: u32 = 200_000;

/// Motion that leaves the wall from rest is clear of it at this distance, far above rounding of x.
pub(crate) const CLEAR_OF_WALL: f64 = 1e-12;

/// A time in which motion that leaves the wall from rest is not clear of it, for forces that change by
/// less than 10³ in a unit of time (0.6 · 10⁻⁵ would be).
pub(crate) const NOT_CLEAR_YET: f64 = 1e-6;

/// A motion in closed form ends after this many strides: no orbit is followed for more than some
/// thousand forcing periods, which are as many strides at a thousandth of the natural frequency,
/// and walking through them takes a tenth of a second.
pub(crate) const MOST_STRIDES: usize = 10_000_000;

/// A motion ends after this many steps: a few hundred make a period of a spring sixty times as fast
/// as its forcing, and ten thousand of one that is a thousand times as fast; a hundred thousand
/// take fifteen megabytes and some tenths of a second.
pub(crate) const MOST_STEPS: usize = 100_000;
