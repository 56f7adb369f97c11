//! A motion, and the bounds of its derivatives over a stretch of time.

use crate::state::State;

/// Position and its first three derivatives at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kinematics {
    /// Position x.
    pub position: f64,
    /// Velocity y = ẋ.
    pub velocity: f64,
    /// Acceleration ẍ.
    pub acceleration: f64,
    /// Jerk d³x/dt³.
    pub jerk: f64,
}

impl Kinematics {
    /// The state at this phase of the forcing.
    pub fn state(&self, phase: f64) -> State {
        State { position: self.position, velocity: self.velocity, phase }
    }

    /// The kinematics a very short time later, by Taylor's formula.
    pub(super) fn after(&self, time: f64) -> Self {
        let Self { position, velocity, acceleration, jerk } = *self;
        Self {
            position: position + (velocity + (0.5 * acceleration + jerk * time / 6.0) * time) * time,
            velocity: velocity + (acceleration + 0.5 * jerk * time) * time,
            acceleration: acceleration + jerk * time,
            jerk,
        }
    }
}

/// Bounds of |ẍ|, |d³x/dt³| and |d⁴x/dt⁴| on an interval of time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DerivativeBounds {
    /// Bound of |ẍ|.
    pub acceleration: f64,
    /// Bound of |d³x/dt³|.
    pub jerk: f64,
    /// Bound of |d⁴x/dt⁴|.
    pub snap: f64,
}

impl DerivativeBounds {
    /// Bounds where nothing is known, so that nothing can be proved.
    pub(crate) const UNKNOWN: Self = Self::all(f64::INFINITY);
    /// Bounds over an interval of zero length, in which nothing happens.
    pub(crate) const NO_TIME: Self = Self::all(0.0);

    const fn all(bound: f64) -> Self {
        Self { acceleration: bound, jerk: bound, snap: bound }
    }

    /// Bounds that hold on both intervals.
    pub(crate) fn joined(&self, other: &Self) -> Self {
        Self {
            acceleration: self.acceleration.max(other.acceleration),
            jerk: self.jerk.max(other.jerk),
            snap: self.snap.max(other.snap),
        }
    }
}

/// A smooth motion x(t), t being the time since it began, whose derivatives can be bounded; every
/// such motion is a [`Motion`](super::Motion) by the search for events.
pub trait BoundedMotion {
    /// The motion at a time of either sign; NaN where it has ceased to exist.
    fn kinematics_at(&self, time: f64) -> Kinematics;

    /// The derivatives bounded from the beginning to a horizon, which may lie in the past.
    fn enclose(&self, horizon: f64) -> impl Enclosure;

    /// How far ahead bounds are worth computing when the first event may come sooner; infinite
    /// where they cost nothing.
    #[inline]
    fn foresight(&self) -> f64 {
        f64::INFINITY
    }
}

/// The time from a motion's beginning to a horizon, over which its derivatives have been bounded:
/// the only source of bounds.
///
/// The interval is divided into strides, between which the motion is cheap to evaluate.
pub trait Enclosure {
    /// Bounds for the whole enclosure, as far as the motion exists.
    fn bounds(&self) -> DerivativeBounds;

    /// The bound of |ẍ| for the whole enclosure; those of higher derivatives may cost more.
    #[inline]
    fn acceleration(&self) -> f64 {
        self.bounds().acceleration
    }

    /// Bounds between two times, in this order; infinite outside the enclosure. An implementation
    /// may return those for the whole enclosure where they are about as good.
    fn bounds_between(&self, from: f64, to: f64) -> DerivativeBounds;

    /// The length of the longest stride.
    fn stride(&self) -> f64;

    /// The number of whole strides in the enclosure.
    fn strides(&self) -> usize;

    /// The time after `strides` strides, at most [`strides`](Self::strides).
    fn time_after(&self, strides: usize) -> f64;

    /// A walk through the times after 0, 1, 2, … strides, standing at 0.
    fn walk(&self) -> impl Walk;
}

/// A walk along a motion in strides: the position is available at once, the derivatives on request.
pub trait Walk: Copy {
    /// The position x.
    fn position(&self) -> f64;

    /// The position x and its derivatives.
    fn kinematics(&self) -> Kinematics;

    /// Goes on by one stride.
    fn advance(&mut self);
}
