//! Thresholds that define zero, equal and lost. They depend on one another, from the last step of
//! Newton's method down to the properties reported for a solution, and are measured in
//! dimensionless motion of the order of one. Constants that belong to a single method are defined
//! beside it.
//!
//! ```text
//! STEP 1e-7  ─►  a point is off by the square of it, 1e-14 times the curvature of the equations, which is 1 to 100
//!   ─►  TOUCH, STABILITY, NO_VELOCITY, ON_TWO_CURVES: above what is left at a located point, with some digits to spare
//!   ─►  SAME_POINT, LOCATED: above what points of a drawn curve are off by, far below the distance of different ones
//! ```

/// A Newton step shorter than this is the last. By quadratic convergence the resulting point is
/// then exact to about 10⁻¹⁴ times the curvature of the equations, which is of order one to a
/// hundred in the variables used here.
pub const STEP: f64 = 1e-7;

/// Limit on evaluations: Newton's method for isolated points either converges within this many or
/// is lost.
pub(crate) const EVALUATIONS: usize = 25;

/// An iterate is lost if it is this many times farther from the start than the start from the
/// origin; far away motion may be so fast that no result is reached in any reasonable time
/// (empirical).
pub(crate) const FARTHEST: f64 = 10.0;

/// Limit on corrections: a curve's corrector converges in about three evaluations or the step is
/// too long.
pub(crate) const CORRECTIONS: usize = 6;

/// The corrector is lost as soon as it is this many steps away from the prediction (empirical; far
/// away motion may be so fast that an evaluation takes seconds).
pub(crate) const FARTHEST_CORRECTION: f64 = 4.0;

/// An event found more than this many steps of the curve away is a different one: the one that was
/// detected lies within one step.
pub(crate) const FARTHEST_EVENT: f64 = 2.0;
/// Newton's method for an event is given up this many steps away: it may take a detour, but not to
/// where a forcing period takes for ever to compute.
pub(crate) const FARTHEST_ITERATE: f64 = 20.0;

/// Number of times that a step is cut about an event that Newton's method does not find from its
/// middle: ten halvings lead to some 10⁻³ of it, where multipliers that change by a hundred in a
/// step change by a tenth, but where a curve turns the cut is nearer to the step's beginning
/// (empirical: three are enough in most cases, beside a pole of the force eighteen are needed).
pub(crate) const CUTS: usize = 40;

/// Limit on the evaluations in the search for a zero of a function along a curve; regula falsi
/// needs about ten, and near a pole none suffices.
pub(crate) const FALSE_POSITIONS: usize = 50;

/// Height above the wall up to which an interior maximum touches it: event times are exact to
/// rounding, and positions at maxima far more so.
pub const TOUCH: f64 = 1e-11;

/// Distance from the boundary of stability within which an MPS does not count as stable:
/// bifurcations are located to better than that.
pub(crate) const STABILITY: f64 = 1e-9;

/// Distance, in the unknowns, from a resonance above which a trace without impact velocity has no limit: ends of
/// curves are located to 10⁻⁹ or better.
pub(crate) const WITHOUT_LIMIT: f64 = 1e-6;

/// Distance below which motion recurs after half a period, mirrored or not: points of curves are
/// off by less, but by more than rounding where two branches cross.
pub const RECURS: f64 = 1e-5;

/// Impact velocities at or below this count as zero (empirical: y = 0 is approached transversally).
pub(crate) const NO_VELOCITY: f64 = 1e-9;

/// A curve begins at a codimension-two point if the function that vanishes at another kind of
/// bifurcation is below this there: a located zero is off by 10⁻¹⁰ at most, and on any other curve
/// the first point lies much farther away.
pub(crate) const ON_TWO_CURVES: f64 = 1e-9;

/// A curve begins at a codimension-two point if the height of another interior maximum above the
/// wall is below this there (empirical: a digit more, since heights change several times as fast
/// with the unknowns).
pub(crate) const TOUCHES_TOO: f64 = 1e-8;

/// Distance below which two located points are the same codimension-two point: they are located to
/// 10⁻¹⁰, and different ones are much farther apart.
pub(crate) const SAME_POINT: f64 = 1e-7;

/// Constant part of the residual that Newton's method may leave in a₁₂ or κ_p at a located
/// resonance: a few roundings of terms of order one.
pub(crate) const AT_RESONANCE: f64 = 1e-12;

/// Second part of that residual, as the change of a₁₂ or κ_p over this fraction of η*: the last
/// step of Newton's method is 10⁻⁷, which leaves less even at the sixtieth resonance, where they
/// change sixty times as fast as at the first.
pub(crate) const OFF_RESONANCE: f64 = 1e-10;

/// Error of an MPS, or of a multiplier, up to which a point counts as a bifurcation; located ones
/// are off by 10⁻⁹ at most, and the coefficients are then exact to about as much.
pub(crate) const LOCATED: f64 = 1e-6;

/// Multipliers of motion without impacts below which a period leaves nothing of a small difference. Beside
/// grazing p-loop solutions gain or lose stability at impact velocities of the order of multipliers to
/// the power p, and heights and distances from grazing in μ are of the order of its square: that must
/// exceed [`TOUCH`]. What is less has no sign.
pub(crate) const FORGOTTEN: f64 = 3e-6;

/// Largest part in (μ, η) of the tangent, of length one, at a cusp: rounding over the curvature of
/// the curve.
pub(crate) const IN_THE_PLANE: f64 = 1e-12;
/// Largest part of the tangent in any other direction: the error of the location leaves 10⁻⁸, and a
/// curve that continues there has 10⁻³ or more (empirical).
pub(crate) const AT_CUSP: f64 = 1e-5;

/// A curve is abandoned after this many points in a row among violent motion (empirical).
pub(crate) const LOST_POINTS: usize = 40;

/// Motion is violent where neighbouring motion is stretched by more than this in a round trip: the
/// curve runs into motion that escapes, over a hill of the potential for instance, which has any
/// number of such solutions, and stable ones in strips too thin to be drawn.
pub(crate) const VIOLENT: f64 = 1e3;

/// Ratio of a step that is tried again to one on which an event was seen that could not be located.
pub(crate) const AGAIN: f64 = 0.25;

/// A step is very short if it is less than this fraction of the longest.
pub(crate) const SHORT_STEP: f64 = 1e-3;
/// A curve ends after this many very short steps in a row (empirical: sharp turns and cusps take fewer
/// than a hundred).
pub(crate) const MOST_SHORT_STEPS: usize = 500;

/// On a sketch the highest maximum is computed at one point in this many. Where it is higher than
/// [`OUT_OF_SIGHT`] above the wall, whose distance from rest is of order one, at more than
/// [`MOST_OUT_OF_SIGHT`] such points in a row, the sketch is abandoned (empirical).
pub(crate) const SOUNDED: usize = 10;
/// See [`SOUNDED`].
pub(crate) const OUT_OF_SIGHT: f64 = 1.0;
/// See [`SOUNDED`].
pub(crate) const MOST_OUT_OF_SIGHT: usize = 4;

/// The largest number of points for which a sketch is abandoned: the last point that was in sight is
/// followed by one of those that were not.
pub(crate) const ABANDONED_POINTS: usize = SOUNDED * (MOST_OUT_OF_SIGHT + 2);

/// Multipliers beyond this change so fast that no sign stays known for long.
pub(crate) const UNSETTLED_MULTIPLIERS: f64 = 1e3;

/// Height below which rough motion, with errors of some 10⁻⁷, does not show on which side of the
/// wall a maximum lies.
pub(crate) const UNSURE_HEIGHT: f64 = 1e-5;

/// Distance at which motion has run away, the wall's distance from rest being of order one.
pub const FAR: f64 = 1e6;

/// Amplitude below which motion is at rest: maxima due to rounding do not count.
pub(crate) const REST: f64 = 1e-9;
