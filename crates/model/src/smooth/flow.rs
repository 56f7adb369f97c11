//! The flow of an oscillator with its derivatives.

use nalgebra::{Matrix2x6, Matrix6, Vector2};

use super::enclosure::derivatives;
use super::jet::{FIRST, Jet, variable};
use super::motion::IntegratedMotion;
use super::oscillator::{Integrated, SmoothOscillator};
use super::variational::Surroundings;
use crate::jet::FlowJet;
use crate::scalar::Scalar;
use crate::state::State;
use crate::state::flow_variable as flow;

/// Columns of a [`FlowJet`] and the variables of the jets that are integrated.
const INTEGRATED: [(usize, usize); 4] = [
    (flow::POSITION, variable::POSITION),
    (flow::VELOCITY, variable::VELOCITY),
    (flow::PRIMARY, variable::PRIMARY),
    (flow::SECONDARY, variable::SECONDARY),
];

impl<M: SmoothOscillator> Integrated<M> {
    /// The jet of the flow; NaN if the solution does not exist for so long.
    pub(super) fn flow_jet<const LENGTH: usize>(
        &self,
        motion: &IntegratedMotion<M>,
        from: State,
        duration: f64,
    ) -> FlowJet {
        let along = self.integrate::<LENGTH>(motion, from, duration);
        along.map_or_else(FlowJet::nowhere, |along| along.flow_jet(from))
    }

    /// The variational equations along the motion, and the force at both ends.
    fn integrate<const LENGTH: usize>(
        &self,
        motion: &IntegratedMotion<M>,
        from: State,
        duration: f64,
    ) -> Option<AlongFlow<LENGTH>> {
        let [mu, eta] = self.parameter_jets::<LENGTH>();
        let start = from.phase / self.frequency;
        // t = z₀/ω + s.
        let origin = Jet::constant(from.phase) / self.model.forcing_frequency(mu, eta) - Jet::constant(start);
        let surroundings = Surroundings { origin, parameters: [mu, eta] };
        let end = start + duration;
        let mut jets = [
            Jet::variable(variable::POSITION, from.position),
            Jet::variable(variable::VELOCITY, from.velocity),
        ];
        motion.for_each_step(duration, |time, step| {
            jets = self.jets_after(&jets, time, step, &surroundings);
        })?;
        let [x, y] = jets;
        let acceleration = self.model.force(x, y, origin + Jet::constant(end), mu, eta);
        let [_, jerk] = derivatives(self, [x.value(), y.value()], end);

        let [mu, eta] = self.parameter_jets::<FIRST>();
        let frequency = self.model.forcing_frequency(mu, eta);
        let [x, y] = [(variable::POSITION, from.position), (variable::VELOCITY, from.velocity)]
            .map(|(i, value)| Jet::<FIRST>::variable(i, value));
        let force = self.model.force(x, y, Jet::constant(from.phase) / frequency, mu, eta);
        let [x, y] = [from.position, from.velocity].map(Jet::<FIRST>::constant);
        let [mu, eta] = self.parameters.map(Jet::constant);
        let time = Jet::variable(variable::PHASE, from.phase).scale(1.0 / self.frequency);
        let by_phase = self.model.force(x, y, time, mu, eta).first(variable::PHASE);
        Some(AlongFlow { end: jets, acceleration, jerk, frequency, force, by_phase })
    }
}

/// What is known of a flow, with derivatives in position, velocity and parameters.
pub(super) struct AlongFlow<const LENGTH: usize> {
    /// Position and velocity at the end.
    pub(super) end: [Jet<LENGTH>; 2],
    /// The acceleration at the end, and its derivative along the motion.
    pub(super) acceleration: Jet<LENGTH>,
    pub(super) jerk: f64,
    /// The forcing frequency.
    pub(super) frequency: Jet<FIRST>,
    /// The force at the beginning, at a phase that does not vary, and its derivative in the phase.
    pub(super) force: Jet<FIRST>,
    pub(super) by_phase: f64,
}

impl<const LENGTH: usize> AlongFlow<LENGTH> {
    /// The jet of the flow from a state.
    pub(super) fn flow_jet(&self, from: State) -> FlowJet {
        let [x, y] = self.end;
        let mut jet = FlowJet {
            value: Vector2::new(x.value(), y.value()),
            jacobian: Matrix2x6::zeros(),
            hessians: [Matrix6::zeros(); 2],
        };
        // d/ds: the velocity and the acceleration.
        let slopes = [y, self.acceleration];
        for i in 0..2 {
            for (column, variable) in INTEGRATED {
                jet.jacobian[(i, column)] = self.end[i].first(variable);
            }
            jet.jacobian[(i, flow::DURATION)] = slopes[i].value();
            if LENGTH == FIRST {
                continue;
            }
            let hessian = &mut jet.hessians[i];
            for (row, a) in INTEGRATED {
                for (column, b) in INTEGRATED {
                    hessian[(row, column)] = self.end[i].second(a, b);
                }
                hessian[(row, flow::DURATION)] = slopes[i].first(a);
                hessian[(flow::DURATION, row)] = slopes[i].first(a);
            }
            hessian[(flow::DURATION, flow::DURATION)] = [self.acceleration.value(), self.jerk][i];
        }
        self.add_phase(from, &mut jet);
        jet
    }

    /// Adds the derivatives in the phase z₀ to a jet that has all others.
    ///
    /// A motion that begins ε later on its own path and ends ε later arrives at the same point:
    /// with F₀ = F at the start (y₀ ∂x₀ + F₀ ∂y₀ + ω ∂z₀ − ∂s) φ = 0, identically, so that every
    /// derivative of this is zero as well.
    fn add_phase(&self, from: State, jet: &mut FlowJet) {
        let Self { frequency: omega, force, by_phase, .. } = self;
        let frequency = omega.value();
        let along = |entry: &dyn Fn(usize) -> f64| {
            entry(flow::DURATION)
                - from.velocity * entry(flow::POSITION)
                - force.value() * entry(flow::VELOCITY)
        };
        for i in 0..2 {
            let first = along(&|column| jet.jacobian[(i, column)]) / frequency;
            jet.jacobian[(i, flow::PHASE)] = first;
            if LENGTH == FIRST {
                continue;
            }
            let [by_position, by_velocity] =
                [jet.jacobian[(i, flow::POSITION)], jet.jacobian[(i, flow::VELOCITY)]];
            let hessian = &mut jet.hessians[i];
            let mut set = |column: usize, rate: f64| {
                let entry = (along(&|row| hessian[(row, column)]) - rate) / frequency;
                hessian[(flow::PHASE, column)] = entry;
                hessian[(column, flow::PHASE)] = entry;
            };
            for (column, variable) in INTEGRATED {
                let mut rate = force.first(variable) * by_velocity;
                match variable {
                    variable::POSITION => {}
                    variable::VELOCITY => rate += by_position,
                    _ => rate += omega.first(variable) * first,
                }
                set(column, rate);
            }
            set(flow::DURATION, 0.0);
            set(flow::PHASE, by_phase * by_velocity);
        }
    }
}
