//! Motion of the linear oscillator between impacts, as a function of time alone.

use super::oscillator::LinearOscillator;
use super::response::{Stride, multiply};
use crate::motion::{BoundedMotion, DerivativeBounds, Enclosure, Kinematics, Walk};
use crate::state::State;
use crate::tolerances::MOST_STRIDES;

/// The motion x(t) = e^{−ζt}(p cos ω₁t + q sin ω₁t) + u cos ωt + v sin ωt − 1.
#[derive(Clone, Copy, Debug)]
pub struct LinearMotion {
    damping_ratio: f64,
    natural_frequency: f64,
    frequency: f64,
    transient: [f64; 2],
    forced: [f64; 2],
    stride: Stride,
    /// The time after which the motion has ended, in either direction.
    reach: f64,
}

/// A walk along the motion, held as the two rotating factors e^{(−ζ+iω₁)t} and e^{iωt}.
#[derive(Clone, Copy, Debug)]
struct Rotation<'a> {
    motion: &'a LinearMotion,
    transient: [f64; 2],
    forced: [f64; 2],
}

impl Walk for Rotation<'_> {
    #[inline]
    fn position(&self) -> f64 {
        let LinearMotion { transient: [p, q], forced: [u, v], .. } = self.motion;
        p * self.transient[0] + q * self.transient[1] + u * self.forced[0] + v * self.forced[1] - 1.0
    }

    #[inline]
    fn kinematics(&self) -> Kinematics {
        self.motion.assemble(self.transient, self.forced)
    }

    #[inline]
    fn advance(&mut self) {
        let [transient, forced] = self.motion.stride.turn;
        self.transient = multiply(self.transient, transient);
        self.forced = multiply(self.forced, forced);
    }
}

impl LinearMotion {
    pub(super) fn new(oscillator: &LinearOscillator, from: State) -> Self {
        let response = oscillator.response.at(from.phase);
        let position = from.position + 1.0 - oscillator.amplitude * response.value[0];
        let velocity = from.velocity - oscillator.amplitude * response.value[1];
        let stride = oscillator.stride;
        // A motion that does not exist, or is so large that nothing about it can be bounded, has no
        // reach.
        let exists = (position * position + velocity * velocity).is_finite();
        let reach = if exists { MOST_STRIDES as f64 * stride.length } else { 0.0 };
        Self {
            damping_ratio: oscillator.damping_ratio,
            natural_frequency: oscillator.natural_frequency,
            frequency: oscillator.frequency,
            transient: [
                position,
                (velocity + oscillator.damping_ratio * position) / oscillator.natural_frequency,
            ],
            forced: [oscillator.amplitude * response.value[0], oscillator.amplitude * response.d_phase[0]],
            stride,
            reach,
        }
    }

    /// Kinematics from the two rotating factors e^{(−ζ+iω₁)t} and e^{iωt}.
    #[inline]
    fn assemble(&self, transient: [f64; 2], forced: [f64; 2]) -> Kinematics {
        let [p, q] = self.transient;
        let x = p * transient[0] + q * transient[1];
        let quadrature = q * transient[0] - p * transient[1];
        let y = self.natural_frequency * quadrature - self.damping_ratio * x;
        let a = -x - 2.0 * self.damping_ratio * y;
        let [u, v] = self.forced;
        let forced_x = u * forced[0] + v * forced[1];
        let forced_y = self.frequency * (v * forced[0] - u * forced[1]);
        let square = self.frequency * self.frequency;
        Kinematics {
            position: x + forced_x - 1.0,
            velocity: y + forced_y,
            acceleration: a - square * forced_x,
            jerk: -y - 2.0 * self.damping_ratio * a - square * forced_y,
        }
    }
}

impl BoundedMotion for LinearMotion {
    #[inline]
    fn kinematics_at(&self, time: f64) -> Kinematics {
        let time = if time.abs() <= self.reach { time } else { f64::NAN };
        let decay = libm::exp(-self.damping_ratio * time);
        let (sin, cos) = libm::sincos(self.natural_frequency * time);
        let (forced_sin, forced_cos) = libm::sincos(self.frequency * time);
        self.assemble([decay * cos, decay * sin], [forced_cos, forced_sin])
    }

    #[inline]
    fn enclose(&self, horizon: f64) -> impl Enclosure {
        // |−ζ + iω₁| = 1: all derivatives of the transient have the amplitude of the transient itself.
        let [p, q] = self.transient;
        let growth = if horizon < 0.0 { libm::exp(-self.damping_ratio * horizon) } else { 1.0 };
        let transient = (p * p + q * q).sqrt() * growth;
        let [u, v] = self.forced;
        let square = self.frequency * self.frequency;
        let forced = (u * u + v * v).sqrt() * square;
        let bounds = DerivativeBounds {
            acceleration: transient + forced,
            jerk: transient + forced * self.frequency,
            snap: transient + forced * square,
        };
        Amplitudes { motion: self, horizon, bounds }
    }
}

/// An enclosure with the amplitudes of the derivatives.
struct Amplitudes<'a> {
    motion: &'a LinearMotion,
    horizon: f64,
    bounds: DerivativeBounds,
}

impl Enclosure for Amplitudes<'_> {
    fn bounds(&self) -> DerivativeBounds {
        self.bounds
    }

    #[inline]
    fn bounds_between(&self, from: f64, to: f64) -> DerivativeBounds {
        // The transient does not grow forwards in time, so these bounds hold for ever.
        let earliest = from.min(to);
        if earliest >= 0.0 || earliest >= self.horizon { self.bounds } else { DerivativeBounds::UNKNOWN }
    }

    fn stride(&self) -> f64 {
        self.motion.stride.length
    }

    fn strides(&self) -> usize {
        let LinearMotion { reach, .. } = *self.motion;
        let horizon = if self.horizon > reach { reach } else { self.horizon };
        libm::floor(horizon / self.stride()) as usize
    }

    #[inline]
    fn time_after(&self, strides: usize) -> f64 {
        strides as f64 * self.stride()
    }

    fn walk(&self) -> impl Walk {
        Rotation { motion: self.motion, transient: [1.0, 0.0], forced: [1.0, 0.0] }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::Motion;
    use crate::oscillator::ImpactOscillator;

    #[test]
    fn no_search_for_events_goes_on_for_ever() {
        let linear = LinearOscillator::new(0.03, 0.9, 0.3, 0.8).unwrap();
        let from = State::at_rest(-1.0, 0.0);
        // Almost without forcing, far beyond any time of practical interest, and for no motion at
        // all.
        for frequency in [0.0, -1.0, f64::NAN] {
            let motion = linear.with_parameters([0.3, frequency]).motion(from);
            let horizon = core::f64::consts::TAU / frequency;
            assert!(motion.first_crossing(horizon).is_none_or(|crossing| crossing.time.is_finite()));
            assert!(motion.at(f64::INFINITY).position.is_nan());
        }
        for velocity in [1e308, f64::INFINITY, f64::NAN] {
            let motion = linear.motion(State { velocity, ..from });
            assert_eq!((motion.first_crossing(1e9), motion.highest_maximum(1e9)), (None, None));
            assert!(motion.at(1.0).position.is_nan());
        }
        // The motion ends far beyond two thousand forcing periods a hundred times as long as the
        // oscillator's own.
        let slow = linear.with_parameters([0.3, 0.01]);
        assert!(slow.motion(from).at(2000.0 * slow.forcing_period()).position.is_finite());
    }
}
