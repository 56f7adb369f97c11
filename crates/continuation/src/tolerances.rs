//! What counts as zero, as equal and as lost. The numbers rest on one another, from the last step
//! of Newton's method down to what is said of a solution, and are measured in dimensionless motion
//! of the order of one. What merely shapes a method stands beside it.
//!
//! ```text
//! STEP 1e-7  ─►  a point is off by the square of it, 1e-14 times the curvature of the equations, which is 1 to 100
//!   ─►  TOUCH, STABILITY, NO_VELOCITY, ON_TWO_CURVES: above what is left at a located point, with some digits to spare
//!   ─►  SAME_POINT, LOCATED: above what points of a drawn curve are off by, far below the distance of different ones
//! ```

/// A Newton step shorter than this is the last. By quadratic convergence the point it leads to is
/// then exact to about 10⁻¹⁴ times the curvature of the equations, which is of order one to a
/// hundred in the variables used here.
pub const STEP: f64 = 1e-7;

/// Newton's method for isolated points either converges within this many evaluations or is lost.
pub(crate) const EVALUATIONS: usize = 25;

/// An iterate this many times farther from the start than the start from the origin is lost; far
/// away motion may be so fast that nothing more would come of it in any reasonable time
/// (empirical).
pub(crate) const FARTHEST: f64 = 10.0;

/// A curve's corrector converges in about three evaluations or the step is too long.
pub(crate) const CORRECTIONS: usize = 6;

/// The corrector is lost as soon as it is farther from the prediction than so many steps
/// (empirical; far away motion may be so fast that an evaluation takes seconds).
pub(crate) const FARTHEST_CORRECTION: f64 = 4.0;

/// An event is not the one that was seen if it is found so many steps of the curve away: it lies
/// within one.
pub(crate) const FARTHEST_EVENT: f64 = 2.0;
/// Newton's method is given up on the way to an event so many steps away: it may go round about,
/// but not to where a forcing period takes for ever.
pub(crate) const FARTHEST_ITERATE: f64 = 20.0;

/// How often a step is cut about an event that Newton's method does not find from its middle: ten
/// halvings lead to some 10⁻³ of it, where multipliers that change by a hundred in a step change by
/// a tenth, but where a curve turns the cut is nearer to the step's beginning (empirical: three are
/// enough in most cases, beside a pole of the force eighteen are needed).
pub(crate) const CUTS: usize = 40;

/// A zero of a function along a curve is sought with this many evaluations at most; regula falsi
/// needs about ten, and near a pole all are in vain.
pub(crate) const FALSE_POSITIONS: usize = 50;

/// An interior maximum this little above the wall touches it: event times are exact to rounding,
/// and positions at maxima far more so.
pub const TOUCH: f64 = 1e-11;

/// On the boundary of stability, that is within this of it, an MPS does not count as stable:
/// bifurcations are located to better than that.
pub(crate) const STABILITY: f64 = 1e-9;

/// Motion that half a period, mirrored or not, brings back nearer than this recurs after it: points
/// of curves are off by less, but by more than rounding where two branches cross.
pub const RECURS: f64 = 1e-5;

/// Impact velocities at or below this count as zero (empirical: y = 0 is approached transversally).
pub(crate) const NO_VELOCITY: f64 = 1e-9;

/// A curve begins at a codimension-two point if what vanishes at another kind of bifurcation is
/// below this there: a located zero is off by 10⁻¹⁰ at most, and on any other curve the first point
/// lies much farther away.
pub(crate) const ON_TWO_CURVES: f64 = 1e-9;

/// The same for the height of another interior maximum above the wall (empirical: a digit more,
/// since heights change several times as fast with the unknowns).
pub(crate) const TOUCHES_TOO: f64 = 1e-8;

/// Two located points are the same codimension-two point: located to 10⁻¹⁰, different ones are much
/// farther apart.
pub(crate) const SAME_POINT: f64 = 1e-7;

/// The residual that Newton's method leaves in a₁₂ or κ_p at a located resonance is a few roundings
/// of terms of order one,
pub(crate) const AT_RESONANCE: f64 = 1e-12;

/// and what they change by over this share of η*: a step of Newton's method of 10⁻⁷ is the last,
/// which leaves less at the sixtieth resonance too, where they change sixty times as fast as at the
/// first.
pub(crate) const OFF_RESONANCE: f64 = 1e-10;

/// An MPS this far off, or a multiplier, makes a bifurcation still; located ones are off by 10⁻⁹ at
/// most, and the coefficients are then exact to about as much.
pub(crate) const LOCATED: f64 = 1e-6;

/// At a cusp the tangent, of length one, has no part in (μ, η) above this: rounding over the
/// curvature of the curve.
pub(crate) const IN_THE_PLANE: f64 = 1e-12;
/// And none in another direction above this: the error of the place leaves 10⁻⁸, and a curve that
/// goes on there has 10⁻³ or more (empirical).
pub(crate) const AT_CUSP: f64 = 1e-5;

/// A sketch goes nowhere that has so many points in a row (empirical)
pub(crate) const LOST_POINTS: usize = 60;

/// with multipliers larger than this: it runs into motion that escapes, over a hill of the
/// potential say, which has any number of such solutions. Beside grazing multipliers are as large
/// at no more than a few points.
pub(crate) const LOST_MULTIPLIERS: f64 = 1e4;

/// Multipliers beyond this change so fast that no sign of anything is known for long.
pub(crate) const UNSETTLED_MULTIPLIERS: f64 = 1e3;

/// Rough motion, with errors of some 10⁻⁷, does not show on which side of the wall a maximum lies
/// that is so near it.
pub(crate) const UNSURE_HEIGHT: f64 = 1e-5;

/// Motion this far away, the wall's distance from rest being of order one, has run away.
pub const FAR: f64 = 1e6;

/// Motion through less than this is rest: maxima of what rounding leaves are none.
pub(crate) const REST: f64 = 1e-9;
