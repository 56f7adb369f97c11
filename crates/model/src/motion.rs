//! Motion between impacts and the exact location of its events.
//!
//! Generic event detection evaluates at steps and misses what happens within one, such as an impact of low velocity
//! followed at once by the way back. Here each cell between two evaluations is *proved* free of events from bounds on the
//! derivatives, or narrowed down until the event is isolated between two evaluations and solved for: local maxima first,
//! then the crossing before the maximum.

mod cell;
mod enclosure;
mod search;

pub use cell::{Crossing, Maximum};
pub use enclosure::{Bounds, Enclosure, Kinematics, Motion, Walk};
pub use search::{first_crossing, first_rest, highest_maximum, local_maxima};
