//! Impact oscillators as hybrid systems: flow, reset law, Poincaré maps and orbits with impacts.
//!
//! The general class is the trait [`ImpactOscillator`] (section 2.1 of the paper, eq:F to eq:resetLaw); its first member
//! is the [`LinearOscillator`] (section 3, eq:oscf, eq:oscResetLaw), whose flow is known in closed form; any
//! other is given by its force and reset law ([`smooth`]), and its flow is integrated. The maps of
//! sections 2 and 4 stand in [`maps`], the search for maxima and impacts in [`motion`], and orbits with impacts in
//! [`orbit`]; third derivatives, for the criticality of bifurcations, come with [`ThirdOrder`].
//!
//! All quantities are dimensionless; [`smooth::Dimensionless`] makes an oscillator in other units so. Nothing here reads, writes or
//! prints; all transcendental functions come from `libm`, so that the same input gives the same bits on every machine.

mod jet;
mod linear;
pub mod maps;
pub mod motion;
pub mod orbit;
mod oscillator;
mod scalar;
pub mod smooth;
mod taylor;
mod third_order;
mod tolerances;

pub use jet::{FlowJet, MapJet, ParameterJet, flow_variable};
pub use linear::{LinearMotion, LinearOscillator, OscillatorError};
pub use oscillator::{ImpactOscillator, State};
pub use third_order::ThirdOrder;
