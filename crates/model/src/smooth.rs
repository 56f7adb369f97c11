//! Oscillators that are given by their force and reset law: the flow is integrated, with its derivatives.
//!
//! An implementor of [`SmoothOscillator`] writes F, ω, Φ and Ψ once, generically in the kind of number ([`Scalar`]);
//! [`Integrated`] makes an [`ImpactOscillator`] of it. With plain numbers the integrator chooses its steps; along the same
//! steps it carries jets in (x₀, y₀, z₀, μ, η), which is to solve the variational equations of first and second order; with
//! intervals it proves bounds on the derivatives of a motion, which the search for events needs.

mod integrator;
mod interval;
mod jet;
mod motion;
mod scalar;
mod series;
mod tableau;

use nalgebra::{Matrix2, Matrix2x6, Matrix6, Vector2};

use crate::jet::{FlowJet, MapJet, ParameterJet, flow_variable};
use crate::oscillator::{ImpactOscillator, State};
use integrator::{Node, step};
use jet::Jet;
pub use motion::IntegratedMotion;
pub use scalar::{Function, Scalar};

/// The variables of a jet, by number.
mod variable {
    pub(super) const POSITION: usize = 0;
    pub(super) const VELOCITY: usize = 1;
    pub(super) const PHASE: usize = 2;
    pub(super) const PRIMARY: usize = 3;
    pub(super) const SECONDARY: usize = 4;
}

/// An oscillator ẍ = F(x, ẋ, t; μ, η) with reset law y ↦ −y Φ, z ↦ z + y Ψ, all functions smooth.
///
/// Paper: eq:F, eq:R. F has the period 2π/ω(μ, η) in t; Φ is positive.
pub trait SmoothOscillator: Clone + Send + Sync {
    /// The force F(x, y, t; μ, η) per mass.
    fn force<S: Scalar>(&self, x: S, y: S, t: S, mu: S, eta: S) -> S;

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

    fn parameter_jets<const ORDER: usize>(&self) -> [Jet<ORDER>; 2] {
        let [mu, eta] = self.parameters;
        [Jet::variable(variable::PRIMARY, mu), Jet::variable(variable::SECONDARY, eta)]
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
        let [mu, eta] = self.parameter_jets::<2>();
        let jet = self.model.forcing_frequency(mu, eta);
        let columns = [variable::PRIMARY, variable::SECONDARY];
        ParameterJet {
            value: jet.value(),
            gradient: Vector2::from_fn(|i, _| jet.first(columns[i])),
            hessian: Matrix2::from_fn(|i, j| jet.second(columns[i], columns[j])),
        }
    }

    fn acceleration(&self, state: State) -> f64 {
        let [mu, eta] = self.parameters;
        self.model.force(state.position, state.velocity, state.phase / self.frequency, mu, eta)
    }

    fn flow<const ORDER: usize>(&self, from: State, duration: f64) -> FlowJet {
        let [mu, eta] = self.parameters;
        let [mu_jet, eta_jet] = self.parameter_jets::<ORDER>();
        let start = from.phase / self.frequency;
        // t = z₀/ω + s.
        let origin = Jet::<ORDER>::variable(variable::PHASE, from.phase)
            / self.model.forcing_frequency(mu_jet, eta_jet);
        let time_jet = |t: f64| origin + Jet::constant(t - start);
        let force = |x, y, t: f64| self.model.force(x, y, t, mu, eta);
        let jet_force = |x, y, t: f64| self.model.force(x, y, time_jet(t), mu_jet, eta_jet);

        let end = start + duration;
        let longest = core::f64::consts::TAU / (16.0 * self.frequency);
        let mut node = Node {
            time: start,
            state: [from.position, from.velocity],
            proposal: if duration < 0.0 { -longest } else { longest },
        };
        let mut jets = [
            Jet::variable(variable::POSITION, from.position),
            Jet::variable(variable::VELOCITY, from.velocity),
        ];
        while node.time != end {
            let Some(mut next) = node.next(&force, end - node.time) else {
                return unknown_flow();
            };
            if (end - next.time).abs() <= 4.0 * f64::EPSILON * end.abs().max(start.abs()) {
                next.time = end;
            }
            jets = step(&jet_force, jets, node.time, next.time - node.time);
            node = next;
        }
        let acceleration = jet_force(jets[0], jets[1], end);
        let jerk = {
            let [x, y] = jets;
            // dF/dt along the motion: F's derivatives with x and y as variables of their own.
            let probe = self.model.force(
                Jet::<1>::variable(0, x.value()),
                Jet::<1>::variable(1, y.value()),
                Jet::<1>::variable(2, end),
                Jet::constant(mu),
                Jet::constant(eta),
            );
            probe.first(0) * y.value() + probe.first(1) * acceleration.value() + probe.first(2)
        };
        flow_jet::<ORDER>(&jets, &acceleration, jerk)
    }

    fn reset<const ORDER: usize>(&self, velocity: f64, phase: f64) -> MapJet {
        let [mu, eta] = self.parameter_jets::<ORDER>();
        let y = Jet::<ORDER>::variable(variable::VELOCITY, velocity);
        let z = Jet::<ORDER>::variable(variable::PHASE, phase);
        let image =
            [-y * self.model.restitution(y, z, mu, eta), z + y * self.model.impact_duration(y, z, mu, eta)];
        let columns = [variable::VELOCITY, variable::PHASE, variable::PRIMARY, variable::SECONDARY];
        let mut jet = MapJet::identity(Vector2::new(image[0].value(), image[1].value()));
        for (i, component) in image.iter().enumerate() {
            for (a, &column) in columns.iter().enumerate() {
                jet.jacobian[(i, a)] = component.first(column);
                if ORDER >= 2 {
                    for (b, &other) in columns.iter().enumerate() {
                        jet.hessians[i][(a, b)] = component.second(column, other);
                    }
                }
            }
        }
        jet
    }

    fn motion(&self, from: State) -> IntegratedMotion<M> {
        IntegratedMotion::new(self, from)
    }
}

/// The flow's jet from those of position and velocity in the other variables, and of the acceleration at the end.
fn flow_jet<const ORDER: usize>(jets: &[Jet<ORDER>; 2], acceleration: &Jet<ORDER>, jerk: f64) -> FlowJet {
    use flow_variable as flow;
    let places = [
        (variable::POSITION, flow::POSITION),
        (variable::VELOCITY, flow::VELOCITY),
        (variable::PHASE, flow::PHASE),
        (variable::PRIMARY, flow::PRIMARY),
        (variable::SECONDARY, flow::SECONDARY),
    ];
    let [x, y] = jets;
    let mut flow_jet = FlowJet {
        value: Vector2::new(x.value(), y.value()),
        jacobian: Matrix2x6::zeros(),
        hessians: [Matrix6::zeros(); 2],
    };
    // d/ds: the velocity and the acceleration.
    let slopes = [y, acceleration];
    for i in 0..2 {
        for (variable, column) in places {
            flow_jet.jacobian[(i, column)] = jets[i].first(variable);
        }
        flow_jet.jacobian[(i, flow::DURATION)] = slopes[i].value();
        if ORDER >= 2 {
            let hessian = &mut flow_jet.hessians[i];
            for (a, row) in places {
                for (b, column) in places {
                    hessian[(row, column)] = jets[i].second(a, b);
                }
                hessian[(row, flow::DURATION)] = slopes[i].first(a);
                hessian[(flow::DURATION, row)] = slopes[i].first(a);
            }
            hessian[(flow::DURATION, flow::DURATION)] = [acceleration.value(), jerk][i];
        }
    }
    flow_jet
}

/// What is known of a flow that could not be integrated to the end.
fn unknown_flow() -> FlowJet {
    FlowJet {
        value: Vector2::repeat(f64::NAN),
        jacobian: Matrix2x6::repeat(f64::NAN),
        hessians: [Matrix6::repeat(f64::NAN); 2],
    }
}
