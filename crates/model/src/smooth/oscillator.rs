//! The trait to implement for a smooth oscillator, and the integrated oscillator built from it.

use super::jet::{Jet, variable};
use super::partials::Partials;
use crate::scalar::Scalar;

/// An oscillator ẍ = F(x, ẋ, t; μ, η) with reset law y ↦ −y Φ, z ↦ z + y Ψ, all functions smooth.
///
/// Paper: eq:F, eq:R. F has the period 2π/ω(μ, η) in t; Φ is positive.
pub trait SmoothOscillator: Clone + Send + Sync {
    /// The force F(x, y, t; μ, η) per mass.
    fn force<S: Scalar>(&self, x: S, y: S, t: S, mu: S, eta: S) -> S;

    /// The force at one time as a function of position and velocity, which may be of another number
    /// type: jets, for instance, at a plain time.
    ///
    /// The integrator calls this many times at the same times: an implementor saves most of the
    /// work by computing everything that depends on time and parameters alone here, once.
    fn force_at<T: Scalar, S: Scalar + From<T>>(&self, t: T, mu: T, eta: T) -> impl FnMut(S, S) -> S {
        let [t, mu, eta] = [t, mu, eta].map(S::from);
        move |x, y| self.force(x, y, t, mu, eta)
    }

    /// F, F_x and F_y at one time as a function of position and velocity, if there are formulas for them; where
    /// only F is asked for, by `false`, the others mean nothing.
    ///
    /// The integrator otherwise evaluates [`force_at`](Self::force_at) with jets, to the same effect.
    fn slopes_at<S: Scalar>(&self, _t: S, _mu: S, _eta: S) -> Option<impl FnMut(S, S, bool) -> [S; 3]> {
        None::<fn(S, S, bool) -> [S; 3]>
    }

    /// Writes F with its derivatives of first and, by `true`, of second order, those that are zero everywhere apart;
    /// returns whether there are formulas for them.
    fn partials<S: Scalar>(&self, _arguments: &[S; 5], _second: bool, _partials: &mut Partials<S>) -> bool {
        false
    }

    /// The angular frequency ω(μ, η) of the forcing.
    fn forcing_frequency<S: Scalar>(&self, mu: S, eta: S) -> S;

    /// The restitution Φ(y, z; μ, η).
    fn restitution<S: Scalar>(&self, y: S, z: S, mu: S, eta: S) -> S;

    /// Ψ(y, z; μ, η): the phase that passes during an impact, divided by the impact velocity.
    fn impact_duration<S: Scalar>(&self, y: S, z: S, mu: S, eta: S) -> S;

    /// The number of harmonics of the forcing in the force, if this is linear in x and y with coefficients
    /// that depend on μ and η alone, and otherwise a sum of these harmonics: motion is then known in closed
    /// form ([`Exact`](super::Exact)).
    fn harmonics(&self) -> Option<u32> {
        None
    }

    /// The oscillator seen from its other stop, if it has two: with u = −D − x for x, D being the
    /// distance between the stops, and the force and reset law that hold there.
    fn other_stop(&self) -> Option<Self> {
        None
    }

    /// The distance D between the stops and its rate Ḋ at a time; infinite and zero for one stop.
    fn gap<S: Scalar>(&self, _t: S, _mu: S, _eta: S) -> [S; 2] {
        [f64::INFINITY, 0.0].map(S::constant)
    }
}

/// A [`SmoothOscillator`] at parameters (μ, η), with its flow integrated.
#[derive(Clone, Debug)]
pub struct Integrated<M> {
    pub(super) model: M,
    pub(super) parameters: [f64; 2],
    pub(super) frequency: f64,
    pub(super) accuracy: Accuracy,
}

/// The length of integration steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Accuracy {
    /// Longer steps, with which motion is right to some seven digits.
    Rough,
    /// Steps with which motion is right to some thirteen digits.
    Usual,
    /// Shorter steps, with which errors are some hundred times smaller.
    Fine,
}

impl<M: SmoothOscillator> Integrated<M> {
    /// The oscillator at these parameters.
    pub fn new(model: M, [mu, eta]: [f64; 2]) -> Self {
        let frequency = model.forcing_frequency(mu, eta);
        Self { model, parameters: [mu, eta], frequency, accuracy: Accuracy::Usual }
    }

    /// The oscillator without its parameters.
    pub fn model(&self) -> &M {
        &self.model
    }

    pub(super) fn force(&self, x: f64, y: f64, t: f64) -> f64 {
        let [mu, eta] = self.parameters;
        self.model.force(x, y, t, mu, eta)
    }

    pub(super) fn parameter_jets<const LENGTH: usize>(&self) -> [Jet<LENGTH>; 2] {
        let [mu, eta] = self.parameters;
        [Jet::variable(variable::PRIMARY, mu), Jet::variable(variable::SECONDARY, eta)]
    }

    /// The longest step, which gives the search for events cells of a reasonable size (empirical).
    pub(super) fn longest_step(&self) -> f64 {
        core::f64::consts::TAU / (if self.accuracy == Accuracy::Rough { 5.0 } else { 10.0 } * self.frequency)
    }
}
