//! The closed-form flow of the linear oscillator along a curve of arguments.

use super::oscillator::LinearOscillator;
use crate::scalar::{Function, Scalar};
use crate::taylor::Taylor;
use crate::third_order::ThirdOrder;

impl LinearOscillator {
    /// Position and velocity of the periodic response to forcing of this amplitude.
    fn response_series(&self, phase: Taylor) -> [Taylor; 2] {
        let [sin, cos] = [Function::Sin, Function::Cos].map(|function| phase.apply(function));
        let [re, im] = [self.response.re[0], self.response.im[0]];
        [0, 1].map(|i| (cos.scale(re[i]) - sin.scale(im[i])).scale(self.amplitude))
    }
}

impl ThirdOrder for LinearOscillator {
    /// The flow eq:flow, w(s) = E (w₀ + e₁ − 𝒜 f(z₀)) − e₁ + 𝒜 f(z₀ + ωs), in the notation of the
    /// flow's other derivatives.
    fn flow_series(&self, [position, velocity, phase]: [Taylor; 3], duration: Taylor) -> [Taylor; 2] {
        let zeta = self.damping_ratio;
        let decay = duration.scale(-zeta).apply(Function::Exp);
        let angle = duration.scale(self.natural_frequency);
        let c = decay * angle.apply(Function::Cos);
        let q = (decay * angle.apply(Function::Sin)).scale(1.0 / self.natural_frequency);

        let one = Taylor::constant(1.0);
        let start = self.response_series(phase);
        let end = self.response_series(phase + duration.scale(self.frequency));
        let [u, v] = [position + one - start[0], velocity - start[1]];
        [(c + q.scale(zeta)) * u + q * v + end[0] - one, (c - q.scale(zeta)) * v - q * u + end[1]]
    }

    fn reset_series(&self, velocity: Taylor, phase: Taylor) -> [Taylor; 2] {
        [velocity.scale(-self.restitution), phase]
    }
}
