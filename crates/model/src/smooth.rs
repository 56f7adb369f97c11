//! Oscillators that are given by their force and reset law: the flow is integrated, with its derivatives.
//!
//! An implementor of [`SmoothOscillator`] writes F, ω, Φ and Ψ once, generically in the kind of number ([`Scalar`]);
//! [`Integrated`] makes an [`ImpactOscillator`] of it. With plain numbers the integrator chooses its steps; through the same
//! steps go jets in (x₀, y₀, μ, η), which solves the variational equations of first and second order; derivatives in z₀
//! follow from the invariance of the flow under its own motion. With intervals it proves bounds on the derivatives of a
//! motion, which the search for events needs.
//!
//! The integrator is Gauss's collocation of order 12 with six points. Its steps are long and its stages solve a system whose
//! matrix is that of the variational equations: jets of any order cost one more evaluation of F at each of the six points,
//! which is made at several points side by side. An explicit method of the same accuracy takes many times as many.
//!
//! **Why no library.** Control of the step in those that we know goes through `std`'s powers, so that the bits would depend on
//! the machine; and none carries variational equations of second order along with the solution.
//!
//! **What is proved and what is not.** The bounds of [`Motion::bounds`](crate::motion::Motion::bounds) hold for the exact
//! solution through the computed nodes, by Picard's criterion: a box that the integral operator maps into itself holds the
//! solution. Rounding is ignored in intervals (they are not rounded outwards), and so is the error of the nodes, which is
//! controlled and not proved: about 10⁻¹³ over a period for forces that vary on scales of order one. Below such errors an event
//! that is only just one can be missed.
//!
//! A solution that ceases to exist is not a number from there on, and no event is found beyond.

mod enclosure;
mod flow;
mod integrator;
mod interval;
mod jet;
mod motion;
mod scalar;
mod series;
mod stages;
mod tableau;
mod taylor;
mod third_order;
mod units;
mod variational;

use nalgebra::{Matrix2, Matrix4, RowVector4, Vector2};

use crate::jet::{FlowJet, MapJet, ParameterJet};
use crate::oscillator::{ImpactOscillator, State};
use integrator::Node;
use jet::{FIRST, Jet, SECOND};
pub use motion::IntegratedMotion;
pub use scalar::{Function, Scalar};
pub use taylor::Taylor;
pub use units::{Dimensionless, Units};

/// The variables of jets, by number.
///
/// The phase needs no place in the jets that are integrated: the flow's derivatives in z₀ follow from the others. Where
/// there is no position, it takes the place of that.
mod variable {
    pub(super) const POSITION: usize = 0;
    pub(super) const PHASE: usize = 0;
    pub(super) const VELOCITY: usize = 1;
    pub(super) const PRIMARY: usize = 2;
    pub(super) const SECONDARY: usize = 3;
}

/// An oscillator ẍ = F(x, ẋ, t; μ, η) with reset law y ↦ −y Φ, z ↦ z + y Ψ, all functions smooth.
///
/// Paper: eq:F, eq:R. F has the period 2π/ω(μ, η) in t; Φ is positive.
pub trait SmoothOscillator: Clone + Send + Sync {
    /// The force F(x, y, t; μ, η) per mass.
    fn force<S: Scalar>(&self, x: S, y: S, t: S, mu: S, eta: S) -> S;

    /// The force at one time, as a function of position and velocity.
    ///
    /// The integrator asks for it again and again at the same times: an implementor saves most of its work who computes
    /// here, once, what depends on time and parameters alone.
    fn force_at<S: Scalar>(&self, t: S, mu: S, eta: S) -> impl FnMut(S, S) -> S {
        move |x, y| self.force(x, y, t, mu, eta)
    }

    /// The angular frequency ω(μ, η) of the forcing.
    fn forcing_frequency<S: Scalar>(&self, mu: S, eta: S) -> S;

    /// The restitution Φ(y, z; μ, η).
    fn restitution<S: Scalar>(&self, y: S, z: S, mu: S, eta: S) -> S;

    /// Ψ(y, z; μ, η): the phase that passes during an impact, over the impact velocity.
    fn impact_duration<S: Scalar>(&self, y: S, z: S, mu: S, eta: S) -> S;
}

/// A [`SmoothOscillator`] at parameters (μ, η), with its flow integrated.
#[derive(Clone, Debug)]
pub struct Integrated<M> {
    model: M,
    parameters: [f64; 2],
    frequency: f64,
}

impl<M: SmoothOscillator> Integrated<M> {
    /// The oscillator at these parameters.
    pub fn new(model: M, [mu, eta]: [f64; 2]) -> Self {
        let frequency = model.forcing_frequency(mu, eta);
        Self { model, parameters: [mu, eta], frequency }
    }

    /// The oscillator without its parameters.
    pub fn model(&self) -> &M {
        &self.model
    }

    fn force(&self, x: f64, y: f64, t: f64) -> f64 {
        let [mu, eta] = self.parameters;
        self.model.force(x, y, t, mu, eta)
    }

    fn parameter_jets<const LENGTH: usize>(&self) -> [Jet<LENGTH>; 2] {
        let [mu, eta] = self.parameters;
        [Jet::variable(variable::PRIMARY, mu), Jet::variable(variable::SECONDARY, eta)]
    }

    /// No step is longer, so that the search for events has cells of a reasonable size (empirical).
    fn longest_step(&self) -> f64 {
        core::f64::consts::TAU / (10.0 * self.frequency)
    }

    /// The start of an integration in the direction of time of `duration`.
    fn first_node(&self, from: State, duration: f64) -> Node {
        Node {
            time: from.phase / self.frequency,
            state: [from.position, from.velocity],
            proposal: (0.5 * self.longest_step()).copysign(duration),
            last: None,
        }
    }

    fn reset_jet<const LENGTH: usize>(&self, velocity: f64, phase: f64) -> MapJet {
        let [mu, eta] = self.parameter_jets::<LENGTH>();
        let y = Jet::variable(variable::VELOCITY, velocity);
        let z = Jet::variable(variable::PHASE, phase);
        let image =
            [-y * self.model.restitution(y, z, mu, eta), z + y * self.model.impact_duration(y, z, mu, eta)];
        let columns = [variable::VELOCITY, variable::PHASE, variable::PRIMARY, variable::SECONDARY];
        let mut jet = MapJet::identity(Vector2::new(image[0].value(), image[1].value()));
        for (i, component) in image.iter().enumerate() {
            jet.jacobian.set_row(i, &RowVector4::from_fn(|_, a| component.first(columns[a])));
            jet.hessians[i] = Matrix4::from_fn(|a, b| component.second(columns[a], columns[b]));
        }
        jet
    }
}

impl<M: SmoothOscillator> ImpactOscillator for Integrated<M> {
    type Motion = IntegratedMotion<M>;

    fn parameters(&self) -> [f64; 2] {
        self.parameters
    }

    fn with_parameters(&self, parameters: [f64; 2]) -> Self {
        Self::new(self.model.clone(), parameters)
    }

    fn forcing_frequency(&self) -> ParameterJet {
        let [mu, eta] = self.parameter_jets::<SECOND>();
        let jet = self.model.forcing_frequency(mu, eta);
        let columns = [variable::PRIMARY, variable::SECONDARY];
        ParameterJet {
            value: jet.value(),
            gradient: Vector2::from_fn(|i, _| jet.first(columns[i])),
            hessian: Matrix2::from_fn(|i, j| jet.second(columns[i], columns[j])),
        }
    }

    fn acceleration(&self, state: State) -> f64 {
        self.force(state.position, state.velocity, state.phase / self.frequency)
    }

    fn flow<const ORDER: usize>(&self, from: State, duration: f64) -> FlowJet {
        self.flow_along::<ORDER>(&self.motion(from), from, duration)
    }

    fn flow_along<const ORDER: usize>(
        &self,
        motion: &IntegratedMotion<M>,
        from: State,
        duration: f64,
    ) -> FlowJet {
        if ORDER >= 2 {
            self.flow_jet::<SECOND>(motion, from, duration)
        } else {
            self.flow_jet::<FIRST>(motion, from, duration)
        }
    }

    fn reset<const ORDER: usize>(&self, velocity: f64, phase: f64) -> MapJet {
        if ORDER >= 2 {
            self.reset_jet::<SECOND>(velocity, phase)
        } else {
            self.reset_jet::<FIRST>(velocity, phase)
        }
    }

    fn motion(&self, from: State) -> IntegratedMotion<M> {
        IntegratedMotion::new(self, from)
    }
}
