//! The linear oscillator with impacts that take time: Ψ ≠ 0 in eq:R.

use grazing_model::{FlowJet, ImpactOscillator, LinearMotion, LinearOscillator, MapJet, ParameterJet, State};

/// eq:oscf with the reset law (y, z) ↦ (−εy, z + ψy).
///
/// α = 1 + ε − ωψ can have either sign (eq:alpha, with γ = ω²).
#[derive(Clone, Copy, Debug)]
pub(super) struct Delayed {
    pub(super) linear: LinearOscillator,
    pub(super) psi: f64,
}

impl ImpactOscillator for Delayed {
    type Motion = LinearMotion;

    fn parameters(&self) -> [f64; 2] {
        self.linear.parameters()
    }

    fn with_parameters(&self, parameters: [f64; 2]) -> Self {
        Self { linear: self.linear.with_parameters(parameters), ..*self }
    }

    fn forcing_frequency(&self) -> ParameterJet {
        self.linear.forcing_frequency()
    }

    fn acceleration(&self, state: State) -> f64 {
        self.linear.acceleration(state)
    }

    fn flow<const ORDER: usize>(&self, from: State, duration: f64) -> FlowJet {
        self.linear.flow::<ORDER>(from, duration)
    }

    fn reset<const ORDER: usize>(&self, velocity: f64, phase: f64) -> MapJet {
        let mut jet = self.linear.reset::<ORDER>(velocity, phase);
        jet.value[1] += self.psi * velocity;
        jet.jacobian[(1, 0)] = self.psi;
        jet
    }

    fn motion(&self, from: State) -> LinearMotion {
        self.linear.motion(from)
    }
}
