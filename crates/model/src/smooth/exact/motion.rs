//! Motion in closed form, as a function of time alone.

use core::f64::consts::TAU;

use smallvec::SmallVec;

use super::super::motion::IntegratedMotion;
use super::super::oscillator::SmoothOscillator;
use super::coefficients::LinearForce;
use crate::motion::{
    BoundedMotion, Crossing, DerivativeBounds, Enclosure, Kinematics, Maximum, Motion, Walk,
};
use crate::state::State;
use crate::tolerances::MOST_STRIDES;

/// A motion of an [`Exact`](super::Exact) oscillator.
#[derive(Debug)]
pub enum ExactMotion<M> {
    /// In closed form.
    Closed(Formula),
    /// Integrated.
    Integrated(IntegratedMotion<M>),
}

impl<M: SmoothOscillator> ExactMotion<M> {
    fn either(&self) -> &dyn Motion {
        match self {
            Self::Closed(motion) => motion,
            Self::Integrated(motion) => motion,
        }
    }
}

impl<M: SmoothOscillator> Motion for ExactMotion<M> {
    fn at(&self, time: f64) -> Kinematics {
        self.either().at(time)
    }

    fn first_crossing(&self, horizon: f64) -> Option<Crossing> {
        self.either().first_crossing(horizon)
    }

    fn local_maxima(&self, horizon: f64) -> Vec<Maximum> {
        self.either().local_maxima(horizon)
    }

    fn highest_maximum(&self, horizon: f64) -> Option<Maximum> {
        self.either().highest_maximum(horizon)
    }

    fn first_rest(&self, forwards: bool, horizon: f64) -> Option<f64> {
        self.either().first_rest(forwards, horizon)
    }
}

/// The motion without forcing.
#[derive(Clone, Copy, Debug)]
enum Transient {
    /// e^{−at} (p cos νt + q sin νt).
    Turning { decay: f64, frequency: f64, parts: [f64; 2] },
    /// α e^{λ₁t} + β e^{λ₂t}.
    Straight { rates: [f64; 2], parts: [f64; 2] },
}

/// Number of coefficients of the power series at the beginning, and the angle by which the fastest part of
/// the motion turns meanwhile: what is left out is below rounding.
const TERMS: usize = 14;
const TURN: f64 = 0.15;

/// The motion x(t) as a sum of a motion without forcing, a polynomial and harmonics.
#[derive(Clone, Debug)]
pub struct Formula {
    stiffness: f64,
    damping: f64,
    transient: Transient,
    /// The coefficients of 1, t and t².
    polynomial: [f64; 3],
    /// The frequency of each harmonic, and the parts in phase and in quadrature with it at the beginning.
    harmonics: SmallVec<[(f64, [f64; 2]); 1]>,
    /// The coefficients of a power series and the time for which it is used: in the shortest flights the sum
    /// of large parts is nothing but rounding.
    series: [f64; TERMS],
    soon: f64,
    /// The length of a stride.
    stride: f64,
    /// The time after which the motion has ended, in either direction.
    reach: f64,
}

impl Formula {
    /// The motion from a state, which does not exist unless it `begins`.
    pub(super) fn new(coefficients: &LinearForce, from: State, begins: bool) -> Self {
        let [k, c, load, omega] =
            [&coefficients.stiffness, &coefficients.damping, &coefficients.load, &coefficients.frequency]
                .map(|jet| jet.value());
        let [mut position, mut velocity] = [from.position, from.velocity];
        let mut fastest = omega;
        let harmonics = coefficients.harmonics.iter().map(|harmonic| {
            let rate = harmonic.multiple * omega;
            let (sin, cos) = libm::sincos(harmonic.multiple * from.phase);
            let [p, q] = harmonic.position.map(|jet| jet.value());
            let parts = [p * cos + q * sin, q * cos - p * sin];
            position -= parts[0];
            velocity -= rate * parts[1];
            fastest = fastest.max(rate);
            (rate, parts)
        });
        let harmonics: SmallVec<[(f64, [f64; 2]); 1]> = harmonics.collect();
        let polynomial = match &coefficients.rest {
            Some(rest) => [rest.value(), 0.0, 0.0],
            None if c == 0.0 => [position, velocity, 0.5 * load],
            None => [0.0, load / c, 0.0],
        };
        if coefficients.rest.is_none() && c == 0.0 {
            (position, velocity) = (0.0, 0.0);
        } else {
            position -= polynomial[0];
            velocity -= polynomial[1];
        }
        let decay = 0.5 * c;
        let discriminant = k - decay * decay;
        let transient = if discriminant > 0.0 {
            let frequency = discriminant.sqrt();
            fastest = fastest.max(frequency);
            Transient::Turning {
                decay,
                frequency,
                parts: [position, (velocity + decay * position) / frequency],
            }
        } else {
            let rise = (-discriminant).sqrt();
            // Without rounding where one of them is zero.
            let rates = if k == 0.0 { [0.0, -c] } else { [rise - decay, -rise - decay] };
            let apart = rates[0] - rates[1];
            let parts = match apart == 0.0 {
                true => [0.0; 2],
                false => [(velocity - rates[1] * position) / apart, (rates[0] * position - velocity) / apart],
            };
            Transient::Straight { rates, parts }
        };
        let stride = TAU / (8.0 * fastest);
        let soon = TURN / fastest.max(k.abs().sqrt()).max(c.abs());
        let series = series(coefficients, from);
        // A motion that does not exist, or is so large that nothing about it can be bounded, has no reach.
        let exists = begins && (position * position + velocity * velocity).is_finite();
        let reach = if exists { MOST_STRIDES as f64 * stride } else { 0.0 };
        Self { stiffness: k, damping: c, transient, polynomial, harmonics, series, soon, stride, reach }
    }

    /// Whether the motion exists for a time of either sign.
    pub(super) fn reaches(&self, time: f64) -> bool {
        time.abs() <= self.reach && self.reach > 0.0
    }

    /// Bounds of the derivatives between two times.
    fn bounds_between(&self, times: [f64; 2]) -> DerivativeBounds {
        let (mut acceleration, mut jerk, mut snap) = (2.0 * self.polynomial[2].abs(), 0.0, 0.0);
        let mut add = |size: f64, rate: f64| {
            let square = rate * rate;
            acceleration += size * square;
            jerk += size * square * rate;
            snap += size * square * square;
        };
        // Times may be infinite.
        let size = |rate: f64, time: f64| if rate == 0.0 { 1.0 } else { libm::exp(rate * time) };
        let greatest = |rate: f64| size(rate, times[0]).max(size(rate, times[1]));
        match self.transient {
            Transient::Turning { decay, parts: [p, q], .. } => {
                // |−a + iν| = √k.
                add((p * p + q * q).sqrt() * greatest(-decay), self.stiffness.sqrt());
            }
            Transient::Straight { rates, parts } => {
                for (rate, part) in rates.into_iter().zip(parts).filter(|(_, part)| *part != 0.0) {
                    add(part.abs() * greatest(rate), rate.abs());
                }
            }
        }
        for (rate, [p, q]) in &self.harmonics {
            add((p * p + q * q).sqrt(), *rate);
        }
        DerivativeBounds { acceleration, jerk, snap }
    }
}

/// The power series of x(t) at the beginning: (n + 2)(n + 1) x_{n+2} = f_n − k x_n − (n + 1) c x_{n+1}.
fn series(coefficients: &LinearForce, from: State) -> [f64; TERMS] {
    let [k, c, load, omega] =
        [&coefficients.stiffness, &coefficients.damping, &coefficients.load, &coefficients.frequency]
            .map(|jet| jet.value());
    let mut series = [0.0; TERMS];
    [series[0], series[1]] = [from.position, from.velocity];
    let mut force = [0.0; TERMS];
    force[0] = load;
    for harmonic in &coefficients.harmonics {
        let rate = harmonic.multiple * omega;
        let (sin, cos) = libm::sincos(harmonic.multiple * from.phase);
        let [a, b] = harmonic.force.map(|jet| jet.value());
        let [mut p, mut q] = [a * cos + b * sin, b * cos - a * sin];
        for (n, term) in force.iter_mut().enumerate() {
            *term += p;
            let by = rate / (n as f64 + 1.0);
            [p, q] = [q * by, -p * by];
        }
    }
    for n in 0..TERMS - 2 {
        let next = n as f64 + 1.0;
        series[n + 2] = (force[n] - k * series[n] - next * c * series[n + 1]) / (next * (next + 1.0));
    }
    series
}

/// The motion a short time after its beginning.
fn beginning(series: &[f64; TERMS], time: f64) -> Kinematics {
    // The value of a polynomial and its first three derivatives, by Horner's scheme.
    let [mut value, mut first, mut second, mut third] = [0.0; 4];
    for coefficient in series.iter().rev() {
        third = third * time + 3.0 * second;
        second = second * time + 2.0 * first;
        first = first * time + value;
        value = value * time + coefficient;
    }
    Kinematics { position: value, velocity: first, acceleration: second, jerk: third }
}

impl BoundedMotion for Formula {
    fn kinematics_at(&self, time: f64) -> Kinematics {
        let time = if self.reaches(time) { time } else { f64::NAN };
        if time.abs() <= self.soon {
            return beginning(&self.series, time);
        }
        let [x, y] = match self.transient {
            Transient::Turning { decay, frequency, parts: [p, q] } => {
                let size = libm::exp(-decay * time);
                let (sin, cos) = libm::sincos(frequency * time);
                let [x, quadrature] = [size * (p * cos + q * sin), size * (q * cos - p * sin)];
                [x, frequency * quadrature - decay * x]
            }
            Transient::Straight { rates, parts } => {
                let part =
                    |k: usize| if parts[k] == 0.0 { 0.0 } else { parts[k] * libm::exp(rates[k] * time) };
                let [slow, fast] = [part(0), part(1)];
                [slow + fast, rates[0] * slow + rates[1] * fast]
            }
        };
        let acceleration = -self.stiffness * x - self.damping * y;
        let [one, first, second] = self.polynomial;
        let mut all = Kinematics {
            position: x + (one + (first + second * time) * time),
            velocity: y + first + 2.0 * second * time,
            acceleration: acceleration + 2.0 * second,
            jerk: -self.stiffness * y - self.damping * acceleration,
        };
        for (rate, [p, q]) in &self.harmonics {
            let (sin, cos) = libm::sincos(rate * time);
            let [x, y] = [p * cos + q * sin, rate * (q * cos - p * sin)];
            all.position += x;
            all.velocity += y;
            all.acceleration -= rate * rate * x;
            all.jerk -= rate * rate * y;
        }
        all
    }

    fn enclose(&self, horizon: f64) -> impl Enclosure {
        Bounded { motion: self, horizon, bounds: self.bounds_between([0.0, horizon]) }
    }
}

/// An enclosure by the amplitudes of what a motion consists of.
struct Bounded<'a> {
    motion: &'a Formula,
    horizon: f64,
    bounds: DerivativeBounds,
}

impl Enclosure for Bounded<'_> {
    fn bounds(&self) -> DerivativeBounds {
        self.bounds
    }

    fn bounds_between(&self, from: f64, to: f64) -> DerivativeBounds {
        // They hold at any time; the last stride may end beyond the horizon by rounding.
        self.motion.bounds_between([from, to])
    }

    fn stride(&self) -> f64 {
        self.motion.stride
    }

    fn strides(&self) -> usize {
        let horizon = if self.horizon > self.motion.reach { self.motion.reach } else { self.horizon };
        libm::floor(horizon / self.stride()) as usize
    }

    fn time_after(&self, strides: usize) -> f64 {
        strides as f64 * self.stride()
    }

    fn walk(&self) -> impl Walk {
        Strides { motion: self.motion, count: 0 }
    }
}

/// A walk from stride to stride.
#[derive(Clone, Copy, Debug)]
struct Strides<'a> {
    motion: &'a Formula,
    count: usize,
}

impl Walk for Strides<'_> {
    fn position(&self) -> f64 {
        self.kinematics().position
    }

    fn kinematics(&self) -> Kinematics {
        self.motion.kinematics_at(self.count as f64 * self.motion.stride)
    }

    fn advance(&mut self) {
        self.count += 1;
    }
}
