//! Motion between impacts and the exact location of its events.
//!
//! Generic event detection evaluates at steps and misses events within one, such as an impact of
//! low velocity that is followed at once by the return. Here each cell between two evaluations is
//! *proved* free of events from bounds on the derivatives, or narrowed down until the event is
//! isolated between two evaluations and solved for: local maxima first, then the crossing before
//! the maximum.

mod cell;
mod enclosure;
mod search;

pub use cell::{Crossing, Maximum};
pub use enclosure::{BoundedMotion, DerivativeBounds, Enclosure, Kinematics, Walk};

/// A smooth motion x(t), t being the time since it began, with its events.
pub trait Motion {
    /// The motion at a time of either sign; NaN where it has ceased to exist.
    fn at(&self, time: f64) -> Kinematics;

    /// The first crossing of x = 0 upwards, at a time in (0, horizon], by a motion that begins with
    /// x ≤ 0.
    ///
    /// A maximum that only touches the wall (x ≤ 0 to rounding) is no crossing.
    fn first_crossing(&self, horizon: f64) -> Option<Crossing>;

    /// All local maxima of x(t) for t in (0, horizon), in order of time.
    fn local_maxima(&self, horizon: f64) -> Vec<Maximum>;

    /// The highest local maximum of x(t) for t in (0, horizon), or `None` if there is no local
    /// maximum.
    fn highest_maximum(&self, horizon: f64) -> Option<Maximum>;

    /// The zero of the velocity nearest to time 0 in the given direction of time, at most `horizon`
    /// away.
    ///
    /// For a motion that begins with a velocity other than zero; paper: the evolution time of
    /// P_virt.
    fn first_rest(&self, forwards: bool, horizon: f64) -> Option<f64>;
}

impl<M: BoundedMotion> Motion for M {
    #[inline]
    fn at(&self, time: f64) -> Kinematics {
        self.kinematics_at(time)
    }

    #[inline]
    fn first_crossing(&self, horizon: f64) -> Option<Crossing> {
        search::first_crossing(self, horizon)
    }

    fn local_maxima(&self, horizon: f64) -> Vec<Maximum> {
        search::local_maxima(self, horizon)
    }

    fn highest_maximum(&self, horizon: f64) -> Option<Maximum> {
        search::highest_maximum(self, horizon)
    }

    fn first_rest(&self, forwards: bool, horizon: f64) -> Option<f64> {
        search::first_rest(self, forwards, horizon)
    }
}
