//! Measurements of an oscillator, compared with computed results.
//!
//! [`read`] reads measurements from CSV: places of the parameter plane with the behaviour measured there
//! ([`Observation`]), and records of impacts ([`ImpactRecord`]). [`compare()`] compares such places with the
//! regions and curves of a diagram, [`apart`] does so for curves of another program. [`identify()`] finds
//! constants of the oscillator by least squares, with their covariance and the resulting uncertainties of
//! the resonances.

mod associate;
mod compare;
mod fit;
mod identify;
pub mod read;
mod residuals;

pub use associate::{KnownCurves, Located, associate};
pub use compare::{Apart, NOT_FINISHED, apart, compare};
pub use fit::{Fit, FitError, Loss, Rig, fit};
pub use identify::{IdentificationTask, IdentifyError, Measurements, identify};
pub use read::{Behaviour, ImpactRecord, MeasuredWalls, MeasurementError, Observation, Setup};
pub use residuals::{Datum, Missing, Segment};
