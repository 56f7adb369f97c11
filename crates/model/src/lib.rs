//! Impact oscillators as hybrid systems: flow, reset law, Poincaré maps and orbits with impacts.
//!
//! The general class is the trait [`ImpactOscillator`] (section 2.1 of the paper, eq:F to
//! eq:resetLaw); its first member is the [`LinearOscillator`] (section 3, eq:oscf, eq:oscResetLaw),
//! whose flow is known in closed form; any other is given by its force and reset law ([`smooth`]),
//! and its flow is integrated. The maps of sections 2 and 4 are in [`maps`], the search for maxima
//! and impacts in [`motion`], and orbits with impacts in [`orbit`]; third derivatives, for the
//! criticality of bifurcations, come from [`ThirdOrder`].
//!
//! All quantities are dimensionless; [`smooth::Dimensionless`] nondimensionalises an oscillator
//! given in other units. This crate does no I/O and never prints; all transcendental functions come
//! from `libm`, so that the same input gives the same bits on every machine.
//!
//! A user's own oscillator is defined by its force, frequency and reset law; orbits with impacts
//! follow:
//!
//! ```
//! use grazing_model::orbit::{FlightEnd, Orbit};
//! use grazing_model::smooth::{Integrated, Scalar, SmoothOscillator};
//! use grazing_model::State;
//!
//! /// A spring that stiffens, at rest one unit below the wall.
//! #[derive(Clone)]
//! struct Duffing;
//!
//! impl SmoothOscillator for Duffing {
//!     fn force<S: Scalar>(&self, x: S, v: S, t: S, amplitude: S, omega: S) -> S {
//!         amplitude * (omega * t).cos() - v * 0.04 - x - x * x * x * 0.1 - 1.0
//!     }
//!
//!     fn forcing_frequency<S: Scalar>(&self, _: S, omega: S) -> S {
//!         omega
//!     }
//!
//!     fn restitution<S: Scalar>(&self, _: S, _: S, _: S, _: S) -> S {
//!         S::constant(0.9)
//!     }
//!
//!     fn impact_duration<S: Scalar>(&self, _: S, _: S, _: S, _: S) -> S {
//!         S::constant(0.0)
//!     }
//! }
//!
//! let duffing = Integrated::new(Duffing, [0.6, 0.8]);
//! let flights = Orbit::new(&duffing, State::at_rest(-1.0, 0.0), 100.0, 1000);
//! let impacts = flights.filter(|flight| matches!(flight.end, FlightEnd::Impact(state) if state.velocity > 0.0));
//! assert!(impacts.count() > 5);
//! ```

mod any;
mod jet;
mod linear;
pub mod maps;
pub mod motion;
pub mod orbit;
mod oscillator;
mod passage;
pub mod phase;
pub mod rest;
mod scalar;
pub mod smooth;
mod state;
mod taylor;
mod third_order;
mod tolerances;

pub use any::{AnyMotion, AnyOscillator};
pub use jet::{FlowJet, MapJet, ParameterJet};
pub use linear::{LinearMotion, LinearOscillator, OscillatorError};
pub use oscillator::ImpactOscillator;
pub use passage::{Passage, Passed};
pub use state::{AtPhase, AtRest, OnWall, State, Surface, flow_variable};
pub use third_order::ThirdOrder;
