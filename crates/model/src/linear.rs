//! The harmonically forced linear oscillator, section 3 of the paper.

mod flow;
mod motion;
mod oscillator;
mod response;
mod series;

pub use motion::LinearMotion;
pub use oscillator::{LinearOscillator, OscillatorError};

use nalgebra::{Matrix2, Vector2};

use crate::jet::{FlowJet, MapJet, ParameterJet};
use crate::oscillator::ImpactOscillator;
use crate::state::{OnWall, State};
use response::{Response, Stride};

impl ImpactOscillator for LinearOscillator {
    type Motion = LinearMotion;

    fn parameters(&self) -> [f64; 2] {
        [self.amplitude, self.frequency]
    }

    fn with_parameters(&self, [amplitude, frequency]: [f64; 2]) -> Self {
        if frequency == self.frequency {
            return Self { amplitude, ..*self };
        }
        Self {
            amplitude,
            frequency,
            response: Response::new(self.damping_ratio, frequency),
            stride: Stride::new(self.damping_ratio, self.natural_frequency, frequency),
            ..*self
        }
    }

    fn forcing_frequency(&self) -> ParameterJet {
        ParameterJet { value: self.frequency, gradient: Vector2::new(0.0, 1.0), hessian: Matrix2::zeros() }
    }

    fn acceleration(&self, state: State) -> f64 {
        self.amplitude * libm::cos(state.phase)
            - 2.0 * self.damping_ratio * state.velocity
            - state.position
            - 1.0
    }

    #[inline]
    fn flow_along<const ORDER: usize>(&self, _: &LinearMotion, from: State, duration: f64) -> FlowJet {
        flow::flow::<ORDER>(self, from, duration)
    }

    fn reset<const ORDER: usize>(&self, OnWall { velocity, phase }: OnWall) -> MapJet<OnWall, OnWall> {
        let mut jet = MapJet::identity(OnWall::new(-self.restitution * velocity, phase));
        jet.jacobian[(0, 0)] = -self.restitution;
        jet
    }

    fn motion(&self, from: State) -> LinearMotion {
        LinearMotion::new(self, from)
    }
}
