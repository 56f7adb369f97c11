//! From an oscillator alone to its two-parameter diagram: neither a grazing orbit nor a resonance
//! need be known in advance.
//!
//! ```text
//! non_impacting  periodic motion without the wall, followed in the primary parameter until it touches the wall
//!   └─ grazing   the curve of grazing bifurcations through that point, with all that the theorems need along it
//!        └─ resonances   where a₁₂ (p = 1) or κ_p (p ≥ 2) vanishes on it: located, numbered, checked against the theorems
//!             └─ diagram   SN, PD and GZ curves from every resonance, codimension-two points
//!                  ├─ generations     resonances where solutions with impacts graze, and what leaves them
//!                  ├─ regions         where solutions are stable, as polygons
//!                  ├─ magnification   the same curves close to one resonance, with the quadratic approximations
//!                  ├─ straightened    their distance from the grazing curve, with its digits at any scale
//!                  ├─ verdict         whether the theorem's coefficients are those of the curves
//!                  ├─ verification    whether the hybrid system, simulated (simulation), does what is predicted
//!                  └─ one_parameter   branches on a line of the plane, with simulation (long_time) and phase portraits
//!
//! described      an oscillator from a text file, prepared for an analysis, as each of its walls sees it
//!   ├─ unfolded   all of the above for it, as the rows of its tables
//!   ├─ family     its resonances as constants vary
//!   └─ nothing    why there is nothing to unfold, in words
//! ```
//!
//! All quantities are in units in which motion is of the order of one:
//! [`Dimensionless`](grazing_model::smooth::Dimensionless) converts any oscillator to this form.
//! Results give their rows in the same units ([`plane::rows`], [`Sequences::rows`](sequences::Sequences::rows),
//! [`Place::rows`](place::Place::rows)), and [`Dimensioned`](grazing_results::Dimensioned) converts these to
//! the oscillator's own.
//!
//! All functions take [`AnyOscillator`](grazing_model::AnyOscillator): the paper's oscillator with
//! its closed form and one that is integrated from a text file differ only in their flow.
//!
//! A user's own oscillator is defined by its force, frequency and reset law:
//!
//! ```
//! use grazing_continuation::curve::Window;
//! use grazing_model::AnyOscillator;
//! use grazing_model::smooth::{Integrated, Scalar, SmoothOscillator};
//! use grazing_unfold::{Diagram, Scope, progress::Silent};
//!
//! /// A pendulum at rest beside a wall, its point of suspension forced to and fro.
//! #[derive(Clone)]
//! struct Pendulum {
//!     damping: f64,
//! }
//!
//! impl SmoothOscillator for Pendulum {
//!     fn force<S: Scalar>(&self, x: S, y: S, t: S, amplitude: S, omega: S) -> S {
//!         amplitude * (omega * t).cos() - y * self.damping - (x + 0.5).sin()
//!     }
//!
//!     fn forcing_frequency<S: Scalar>(&self, _: S, omega: S) -> S {
//!         omega
//!     }
//!
//!     fn restitution<S: Scalar>(&self, _: S, _: S, _: S, _: S) -> S {
//!         S::constant(0.8)
//!     }
//!
//!     fn impact_duration<S: Scalar>(&self, _: S, _: S, _: S, _: S) -> S {
//!         S::constant(0.0)
//!     }
//! }
//!
//! let window = Window { primary: [0.0, 0.4], secondary: [0.62, 0.67] };
//! let scope = Scope { window, loops: vec![1], start: None };
//! let pendulum = Integrated::new(Pendulum { damping: 0.05 }, [0.0, 0.6]);
//! let diagram = Diagram::compute(&AnyOscillator::new(pendulum), &scope, &Silent)?;
//! for (resonance, point) in diagram.unfolding() {
//!     // Three half-swings in a forcing period; the saddle-node curve bends to greater amplitudes.
//!     assert_eq!((resonance.loops, resonance.n), (1, 3));
//!     assert!(point.theorem().saddle_node().coefficient > 0.0);
//! }
//! assert_eq!(diagram.unfolding().count(), 1);
//! # Ok::<(), grazing_unfold::UnfoldError>(())
//! ```

mod beyond_grazing;
mod close_curves;
mod copies;
pub mod curves;
pub mod described;
pub mod diagram;
mod entering_curves;
mod error;
pub mod escape;
mod faces;
pub mod family;
pub mod generations;
pub mod grazing;
pub mod limit_map;
pub mod long_time;
pub mod magnification;
mod missed_bifurcations;
pub mod non_impacting;
pub mod nothing;
pub mod one_parameter;
mod origin;
pub mod own_curves;
mod parallel;
pub mod place;
pub mod plane;
pub mod progress;
mod region;
pub mod regions;
pub mod resonances;
mod scope;
mod search;
mod segments;
pub mod sequences;
mod settled;
pub mod simulation;
mod slice_stability;
mod slices;
#[cfg(test)]
mod specimens;
mod step_limits;
pub mod straightened;
mod subharmonic;
mod suggestion;
mod survey;
mod tolerances;
pub mod unfinished;
pub mod unfolded;
pub mod verdict;
pub mod verification;
mod winding;
mod window_edge;

pub use diagram::Diagram;
pub use error::UnfoldError;
pub use scope::Scope;
