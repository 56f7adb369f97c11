//! The integrated oscillator as an impact oscillator.

use nalgebra::{Matrix2, Matrix4, RowVector4, Vector2};

use super::jet::{FIRST, Jet, SECOND, variable};
use super::motion::IntegratedMotion;
use super::oscillator::{Accuracy, Integrated, SmoothOscillator};
use crate::jet::{FlowJet, MapJet, ParameterJet};
use crate::oscillator::ImpactOscillator;
use crate::state::{OnWall, State};

impl<M: SmoothOscillator> Integrated<M> {
    /// The force where a motion begins, counted like a step of it.
    pub(super) fn force_at_start(&self, from: State) -> f64 {
        let [mu, eta] = self.parameters;
        let mut force = self.model.force_at(from.phase / self.frequency, mu, eta);
        force(from.position, from.velocity)
    }

    fn reset_jet<const LENGTH: usize>(&self, OnWall { velocity, phase }: OnWall) -> MapJet<OnWall, OnWall> {
        let [mu, eta] = self.parameter_jets::<LENGTH>();
        let y = Jet::variable(variable::VELOCITY, velocity);
        let z = Jet::variable(variable::PHASE, phase);
        let image =
            [-y * self.model.restitution(y, z, mu, eta), z + y * self.model.impact_duration(y, z, mu, eta)];
        let columns = [variable::VELOCITY, variable::PHASE, variable::PRIMARY, variable::SECONDARY];
        let mut jet = MapJet::constant(Vector2::new(image[0].value(), image[1].value()));
        for (i, component) in image.iter().enumerate() {
            jet.jacobian.set_row(i, &RowVector4::from_fn(|_, a| component.first(columns[a])));
            jet.hessians[i] = Matrix4::from_fn(|a, b| component.second(columns[a], columns[b]));
        }
        jet
    }
}

/// The value with its derivatives in μ and η.
fn in_parameters(jet: Jet<SECOND>) -> ParameterJet {
    let columns = [variable::PRIMARY, variable::SECONDARY];
    ParameterJet {
        value: jet.value(),
        gradient: Vector2::from_fn(|i, _| jet.first(columns[i])),
        hessian: Matrix2::from_fn(|i, j| jet.second(columns[i], columns[j])),
    }
}

impl<M: SmoothOscillator> ImpactOscillator for Integrated<M> {
    type Motion = IntegratedMotion<M>;

    fn parameters(&self) -> [f64; 2] {
        self.parameters
    }

    fn with_parameters(&self, parameters: [f64; 2]) -> Self {
        Self { accuracy: self.accuracy, ..Self::new(self.model.clone(), parameters) }
    }

    fn roughly(&self) -> Self {
        Self { accuracy: Accuracy::Rough, ..self.clone() }
    }

    fn finely(&self) -> Option<Self> {
        Some(Self { accuracy: Accuracy::Fine, ..self.clone() })
    }

    fn forcing_frequency(&self) -> ParameterJet {
        let [mu, eta] = self.parameter_jets::<SECOND>();
        in_parameters(self.model.forcing_frequency(mu, eta))
    }

    fn other_stop(&self) -> Option<Self> {
        Some(Self { model: self.model.other_stop()?, ..self.clone() })
    }

    fn gap(&self, phase: f64) -> [ParameterJet; 2] {
        let [mu, eta] = self.parameter_jets::<SECOND>();
        let time = Jet::fixed(phase) / self.model.forcing_frequency(mu, eta);
        self.model.gap(time, mu, eta).map(in_parameters)
    }

    fn acceleration(&self, state: State) -> f64 {
        self.force(state.position, state.velocity, state.phase / self.frequency)
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

    fn reset<const ORDER: usize>(&self, impact: OnWall) -> MapJet<OnWall, OnWall> {
        if ORDER >= 2 { self.reset_jet::<SECOND>(impact) } else { self.reset_jet::<FIRST>(impact) }
    }

    fn motion(&self, from: State) -> IntegratedMotion<M> {
        IntegratedMotion::new(self, from)
    }
}
