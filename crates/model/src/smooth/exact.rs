//! Oscillators whose motion is known in closed form: the force is linear in position and velocity, with
//! coefficients that depend on the parameters alone, and the forcing a sum of harmonics.
//!
//! The flow of ẍ = −k x − c ẋ + f(z), z = ωt, is that of the paper's section 3 with any stiffness k,
//! damping c and number of harmonics. Where such a formula loses digits, as next to critical damping or
//! at a resonance without damping, and for any other force, motion is integrated.

mod coefficients;
mod motion;
mod propagator;

use std::sync::Arc;

use self::coefficients::LinearForce;
pub use self::motion::ExactMotion;
use self::motion::Formula;
use super::jet::{FIRST, SECOND};
use super::oscillator::{Integrated, SmoothOscillator};
use crate::jet::{FlowJet, MapJet, ParameterJet};
use crate::oscillator::ImpactOscillator;
use crate::state::{OnWall, State};

/// A [`SmoothOscillator`] at parameters (μ, η), with its flow in closed form where there is one, and
/// integrated otherwise.
#[derive(Clone, Debug)]
pub struct Exact<M> {
    integrated: Integrated<M>,
    /// The coefficients of the force, if the flow is known in closed form.
    coefficients: Option<Arc<LinearForce>>,
}

impl<M: SmoothOscillator> Exact<M> {
    /// The oscillator at these parameters.
    pub fn new(model: M, parameters: [f64; 2]) -> Self {
        Self::of(Integrated::new(model, parameters))
    }

    fn of(integrated: Integrated<M>) -> Self {
        let coefficients = LinearForce::of(&integrated).map(Arc::new);
        Self { integrated, coefficients }
    }

    /// Whether the flow is in closed form at these parameters.
    pub fn is_closed(&self) -> bool {
        self.coefficients.is_some()
    }
}

impl<M: SmoothOscillator> ImpactOscillator for Exact<M> {
    type Motion = ExactMotion<M>;

    fn parameters(&self) -> [f64; 2] {
        self.integrated.parameters()
    }

    fn with_parameters(&self, parameters: [f64; 2]) -> Self {
        if parameters == self.parameters() {
            return self.clone();
        }
        Self::of(self.integrated.with_parameters(parameters))
    }

    fn roughly(&self) -> Self {
        Self { integrated: self.integrated.roughly(), ..self.clone() }
    }

    fn finely(&self) -> Option<Self> {
        match &self.coefficients {
            Some(_) => None,
            None => Some(Self { integrated: self.integrated.finely()?, coefficients: None }),
        }
    }

    fn forcing_frequency(&self) -> ParameterJet {
        self.integrated.forcing_frequency()
    }

    fn acceleration(&self, state: State) -> f64 {
        self.integrated.acceleration(state)
    }

    fn flow_along<const ORDER: usize>(&self, motion: &ExactMotion<M>, from: State, duration: f64) -> FlowJet {
        match (motion, &self.coefficients) {
            (ExactMotion::Integrated(motion), _) => {
                self.integrated.flow_along::<ORDER>(motion, from, duration)
            }
            (ExactMotion::Closed(formula), Some(coefficients)) if formula.reaches(duration) => match ORDER {
                2.. => coefficients.flow_jet::<SECOND>(from, duration),
                _ => coefficients.flow_jet::<FIRST>(from, duration),
            },
            (ExactMotion::Closed(_), _) => FlowJet::nowhere(),
        }
    }

    fn reset<const ORDER: usize>(&self, impact: OnWall) -> MapJet<OnWall, OnWall> {
        self.integrated.reset::<ORDER>(impact)
    }

    fn other_stop(&self) -> Option<Self> {
        self.integrated.other_stop().map(Self::of)
    }

    fn gap(&self, phase: f64) -> [ParameterJet; 2] {
        self.integrated.gap(phase)
    }

    fn motion(&self, from: State) -> ExactMotion<M> {
        match &self.coefficients {
            Some(coefficients) => {
                // Once the computation is cancelled the force is NaN.
                let begins = self.integrated.force_at_start(from).is_finite();
                ExactMotion::Closed(Formula::new(coefficients, from, begins))
            }
            None => ExactMotion::Integrated(self.integrated.motion(from)),
        }
    }
}
