//! From an oscillator alone to its two-parameter diagram: nothing is known beforehand, neither a grazing orbit nor a resonance.
//!
//! ```text
//! free           periodic motion without the wall, followed in the primary parameter until it touches the wall
//!   └─ grazing   the curve of grazing bifurcations through that point, with all that the theorems need along it
//!        └─ resonances   where a₁₂ (p = 1) or κ_p (p ≥ 2) vanishes on it: located, numbered, checked against the theorems
//!             └─ diagram   SN, PD and GZ curves from every resonance, codimension-two points, coefficients
//!                  ├─ regions         where solutions are stable, as polygons
//!                  ├─ magnification   the same curves close to one resonance, with the quadratic approximations
//!                  └─ simulation      whether the hybrid system does what is predicted
//! ```
//!
//! Everything is written against [`ImpactOscillator`](grazing_model::ImpactOscillator): the paper's oscillator with its closed
//! form and one that is integrated from a text file differ in their flow alone.

pub mod diagram;
mod error;
pub mod free;
pub mod grazing;
pub mod magnification;
pub mod progress;
pub mod regions;
pub mod resonances;
mod scope;
pub mod sides;
pub mod simulation;
mod winding;

pub use diagram::Diagram;
pub use error::UnfoldError;
pub use scope::Scope;
