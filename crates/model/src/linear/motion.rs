//! Motion of the linear oscillator between impacts, as a function of time alone.

use super::oscillator::LinearOscillator;
use super::response::{Stride, multiply};
use crate::motion::{BoundedMotion, Bounds, Enclosure, Kinematics, Walk};
use crate::state::State;

/// x(t) = e^{−ζt}(p cos ω₁t + q sin ω₁t) + u cos ωt + v sin ωt − 1.
#[derive(Clone, Copy, Debug)]
pub struct LinearMotion {
    damping_ratio: f64,
    natural_frequency: f64,
    frequency: f64,
    transient: [f64; 2],
    forced: [f64; 2],
    stride: Stride,
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
        Self {
            damping_ratio: oscillator.damping_ratio,
            natural_frequency: oscillator.natural_frequency,
            frequency: oscillator.frequency,
            transient: [
                position,
                (velocity + oscillator.damping_ratio * position) / oscillator.natural_frequency,
            ],
            forced: [oscillator.amplitude * response.value[0], oscillator.amplitude * response.d_phase[0]],
            stride: oscillator.stride,
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
        let bounds = Bounds {
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
    bounds: Bounds,
}

impl Enclosure for Amplitudes<'_> {
    fn bounds(&self) -> Bounds {
        self.bounds
    }

    #[inline]
    fn bounds_between(&self, from: f64, to: f64) -> Bounds {
        // Forwards nothing grows, so that these bounds hold for ever.
        let earliest = from.min(to);
        if earliest >= 0.0 || earliest >= self.horizon { self.bounds } else { Bounds::UNKNOWN }
    }

    fn stride(&self) -> f64 {
        self.motion.stride.length
    }

    fn strides(&self) -> usize {
        libm::floor(self.horizon / self.stride()) as usize
    }

    #[inline]
    fn time_after(&self, strides: usize) -> f64 {
        strides as f64 * self.stride()
    }

    fn walk(&self) -> impl Walk {
        Rotation { motion: self.motion, transient: [1.0, 0.0], forced: [1.0, 0.0] }
    }
}
