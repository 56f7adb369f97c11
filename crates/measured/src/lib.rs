//! What a rig did, beside what is computed of it.
//!
//! [`read`] reads measurements from CSV: places of the parameter plane with what was seen there
//! ([`Observation`]), and records of impacts ([`Series`]). [`compare()`] holds such places against
//! the regions and curves of a diagram, [`apart`] curves of another program. [`identify()`] finds constants of the oscillator by least
//! squares, with their covariance and what it makes of the resonances.

mod associate;
mod compare;
mod fit;
mod identify;
pub mod read;

pub use associate::{Located, associate};
pub use compare::{Apart, NOT_FINISHED, apart, compare};
pub use fit::{Datum, Fit, FitError, Rig, Segment, Weight, fit};
pub use identify::{IdentifyError, Measurements, Task, identify};
pub use read::{MeasurementError, Observation, Seen, Series};
