//! The flow and the reset law of an integrated oscillator along a curve of arguments.

use super::{Integrated, Scalar, SmoothOscillator, Taylor};
use crate::oscillator::{ImpactOscillator, State};
use crate::third_order::ThirdOrder;

impl<M: SmoothOscillator> ThirdOrder for Integrated<M> {
    /// The steps between start and end at s = 0 stay where plain numbers have put them; before the first and after the last the
    /// solution is continued by as much as the ends move along the curve.
    fn flow_series(&self, [position, velocity, phase]: [Taylor; 3], duration: Taylor) -> [Taylor; 2] {
        let from = State { position: position.value(), velocity: velocity.value(), phase: phase.value() };
        let start = from.phase / self.frequency;
        // How much later than at s = 0 the motion begins, and ends.
        let delay = phase.movement().scale(1.0 / self.frequency);
        let begin = Taylor::constant(start) + delay;
        let mut state = Some(self.series_shifted([position, velocity], begin, -delay));
        let passed = self.motion(from).for_each_step(duration.value(), |time, step| {
            state = state.and_then(|state| self.series_after(state, time, step));
        });
        let (Some(()), Some(state)) = (passed, state) else {
            return [Taylor::constant(f64::NAN); 2];
        };
        let end = Taylor::constant(start + duration.value());
        self.series_shifted(state, end, delay + duration.movement())
    }

    fn reset_series(&self, velocity: Taylor, phase: Taylor) -> [Taylor; 2] {
        let [mu, eta] = self.parameters.map(Taylor::constant);
        [
            -velocity * self.model.restitution(velocity, phase, mu, eta),
            phase + velocity * self.model.impact_duration(velocity, phase, mu, eta),
        ]
    }
}
