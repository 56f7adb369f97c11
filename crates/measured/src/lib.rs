//! Measurements of an oscillator, compared with computed results.
//!
//! [`read`] reads measurements from CSV: places of the parameter plane with the behaviour measured there
//! ([`Observation`]), and records of impacts ([`Series`]). [`compare()`] compares such places with the
//! regions and curves of a diagram, [`apart`] does so for curves of another program. [`identify()`] finds
//! constants of the oscillator by least squares, with their covariance and the resulting uncertainties of
//! the resonances.

mod associate;
mod compare;
mod fit;
mod identify;
pub mod read;
mod residuals;

pub use associate::{Known, Located, associate};
pub use compare::{Apart, NOT_FINISHED, apart, compare};
pub use fit::{Fit, FitError, Rig, Weight, fit};
pub use identify::{IdentifyError, Measurements, Task, identify};
pub use read::{MeasurementError, Observation, Seen, Series, Setup, Walls};
pub use residuals::{Datum, Missing, Segment};
