//! The flow and the reset law of an integrated oscillator along a curve of arguments.

use super::oscillator::{Integrated, SmoothOscillator};
use crate::oscillator::ImpactOscillator;
use crate::scalar::Scalar;
use crate::state::State;
use crate::taylor::Taylor;
use crate::third_order::ThirdOrder;

impl<M: SmoothOscillator> ThirdOrder for Integrated<M> {
    /// The flow along a curve: the steps between start and end at s = 0 stay where the integration
    /// on plain numbers has put them, and the forcing is shifted over them with the phase; after
    /// the last step the solution is continued by the variation of the duration along the curve.
    fn flow_series(&self, [position, velocity, phase]: [Taylor; 3], duration: Taylor) -> [Taylor; 2] {
        let from = State { position: position.value(), velocity: velocity.value(), phase: phase.value() };
        let delay = phase.movement().scale(1.0 / self.frequency);
        let mut state = Some([position, velocity]);
        let passed = self.motion(from).for_each_step(duration.value(), |time, step| {
            state = state.and_then(|state| self.series_after(state, Taylor::constant(time) + delay, step));
        });
        let (Some(()), Some(state)) = (passed, state) else {
            return [Taylor::constant(f64::NAN); 2];
        };
        let end = Taylor::constant(from.phase / self.frequency + duration.value());
        self.series_shifted(state, end + delay, duration.movement())
    }

    fn reset_series(&self, velocity: Taylor, phase: Taylor) -> [Taylor; 2] {
        let [mu, eta] = self.parameters.map(Taylor::constant);
        [
            -velocity * self.model.restitution(velocity, phase, mu, eta),
            phase + velocity * self.model.impact_duration(velocity, phase, mu, eta),
        ]
    }
}
