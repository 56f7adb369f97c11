//! Oscillators defined by their force and reset law: the flow is integrated, with its derivatives.
//!
//! An implementor of [`SmoothOscillator`] writes F, ω, Φ and Ψ once, generically in the kind of
//! number ([`Scalar`]); [`Integrated`] makes an [`ImpactOscillator`](crate::ImpactOscillator) of
//! it. With plain numbers the integrator chooses its steps; through the same steps go jets in (x₀,
//! y₀, μ, η), which solves the variational equations of first and second order; derivatives in z₀
//! follow from the invariance of the flow under its own motion. With intervals it proves bounds on
//! the derivatives of a motion, which the search for events needs. Where the force is linear,
//! [`Exact`] has all of this in closed form.
//!
//! The integrator is Gauss's collocation of order 12 with six points. Its steps are long and its
//! stages solve a system whose matrix is that of the variational equations: jets of any order cost
//! one more evaluation of F at each of the six points, by formulas for its derivatives where there
//! are any ([`SmoothOscillator::partials`]). An explicit method of the same accuracy takes many times as many.
//!
//! **Why no library.** The step control of the libraries we know goes through `std`'s powers, so
//! that the bits would depend on the machine; and none carries variational equations of second
//! order along with the solution.
//!
//! **What is proved and what is not.** The bounds of
//! [`BoundedMotion::enclose`](crate::motion::BoundedMotion::enclose) hold for the exact solution
//! through the computed nodes, by Picard's criterion: a box that the integral operator maps into
//! itself holds the solution. Rounding is ignored in intervals (they are not rounded outwards), and
//! so is the error of the nodes, which is controlled and not proved: about 10⁻¹³ over a period for
//! forces that vary on scales of order one. A marginal event can be missed below such errors. For
//! rough motion nothing is proved: its bounds are those of the polynomials on its steps.
//!
//! A solution that ceases to exist is NaN from there on, and no event is found beyond.

mod enclosure;
mod exact;
mod factors;
mod flow;
mod integrated;
mod integrator;
mod interval;
mod jet;
mod motion;
mod oscillator;
mod partials;
mod purpose;
mod series;
mod stages;
mod stop;
mod tableau;
mod third_order;
mod units;
mod variational;

pub use crate::scalar::{Function, Scalar};
pub use crate::taylor::Taylor;
pub use exact::{Exact, ExactMotion};
pub use motion::IntegratedMotion;
pub use oscillator::{Integrated, SmoothOscillator};
pub use partials::{Partials, partial};
pub use purpose::Purpose;
pub use stop::{Stop, Stoppable, StoppableMotion};
pub use units::{Dimensionless, Units};
