//! The flow of the linear oscillator as printed, its derivatives by differences, and states.

use crate::*;
use grazing_model::LinearOscillator;

/// The printed flow eq:flow and solution eq:phip, implemented from the paper.
#[derive(Clone, Copy)]
pub(crate) struct Printed {
    pub(crate) zeta: f64,
    pub(crate) omega: f64,
}

impl Printed {
    /// The printed flow of an oscillator.
    pub(crate) fn of(oscillator: &LinearOscillator) -> Self {
        Self { zeta: oscillator.damping_ratio(), omega: oscillator.frequency() }
    }

    /// The solution φ_p and its derivative in t.
    pub(crate) fn periodic(&self, time: f64, amplitude: f64) -> [f64; 2] {
        let Self { zeta, omega } = *self;
        let stiffness = 1.0 - omega * omega;
        let factor = amplitude / (stiffness * stiffness + 4.0 * zeta * zeta * omega * omega);
        let (sine, cosine) = libm::sincos(omega * time);
        [
            -1.0 + factor * (stiffness * cosine + 2.0 * zeta * omega * sine),
            factor * omega * (-stiffness * sine + 2.0 * zeta * omega * cosine),
        ]
    }

    /// The flow φ(t; x₀, y₀, t₀; 𝒜).
    pub(crate) fn flow(&self, time: f64, [x, y]: [f64; 2], start: f64, amplitude: f64) -> f64 {
        let zeta = self.zeta;
        let natural = (1.0 - zeta * zeta).sqrt();
        let (sine, cosine) = libm::sincos(natural * (time - start));
        let [position, velocity] = self.periodic(start, amplitude);
        libm::exp(-zeta * (time - start))
            * ((cosine + zeta / natural * sine) * (x - position) + sine / natural * (y - velocity))
            + self.periodic(time, amplitude)[0]
    }
}

/// Derivatives of φ at grazing after p periods, by sixth-order differences in t, x, t₀ and 𝒜.
pub(crate) struct Derivatives {
    printed: Printed,
    end: f64,
    start: f64,
    amplitude: f64,
}

/// The step of the differences in time: 10⁻² of the shorter of the two time scales leaves an error of
/// 10⁻¹³ and, for second and third derivatives, rounding of 10⁻¹⁶ over its square or cube.
pub(crate) const STEP: f64 = 2e-2;

pub(crate) fn first(step: f64, f: impl Fn(f64) -> f64) -> f64 {
    slope(step, |h| Some(f(h))).unwrap_or(f64::NAN)
}

pub(crate) fn second(step: f64, f: impl Fn(f64) -> f64) -> f64 {
    curvature(step, |h| Some(f(h))).unwrap_or(f64::NAN)
}

impl Derivatives {
    pub(crate) fn new(state: &GrazingState, loops: u32) -> Self {
        let omega = state.forcing_frequency();
        let start = state.phase() / omega;
        Self {
            printed: Printed { zeta: state.oscillator().damping_ratio(), omega },
            end: start + TAU * f64::from(loops) / omega,
            start,
            amplitude: state.amplitude(),
        }
    }

    /// φ displaced in (t, x, t₀, 𝒜).
    pub(crate) fn at(&self, [time, x, start, amplitude]: [f64; 4]) -> f64 {
        self.printed.flow(self.end + time, [x, 0.0], self.start + start, self.amplitude + amplitude)
    }

    pub(crate) fn step(&self) -> f64 {
        STEP / self.printed.omega.max(1.0)
    }

    /// ∂ⁿφ/∂tⁿ displaced in (x, t₀, 𝒜), n ≤ 3.
    pub(crate) fn in_time(&self, n: u32, [x, start, amplitude]: [f64; 3]) -> f64 {
        let f = |time: f64| self.at([time, x, start, amplitude]);
        let step = self.step();
        match n {
            0 => f(0.0),
            1 => first(step, f),
            2 => second(step, f),
            _ => first(step, |time| second(step, |later| f(time + later))),
        }
    }

    /// The velocity φ̇.
    pub(crate) fn velocity(&self) -> f64 {
        self.in_time(1, [0.0; 3])
    }

    /// The acceleration φ̈.
    pub(crate) fn acceleration(&self) -> f64 {
        self.in_time(2, [0.0; 3])
    }

    /// The derivative in x, t₀ or 𝒜 (`variable` 0, 1, 2) of ∂ⁿφ/∂tⁿ.
    pub(crate) fn mixed(&self, n: u32, variable: usize) -> f64 {
        first(self.step(), |h| {
            let mut moved = [0.0; 3];
            moved[variable] = h;
            self.in_time(n, moved)
        })
    }

    /// ∂²/∂t₀² of ∂ⁿφ/∂tⁿ.
    pub(crate) fn twice_in_start(&self, n: u32) -> f64 {
        second(self.step(), |h| self.in_time(n, [0.0, h, 0.0]))
    }
}

/// Oscillators at grazing with random ζ, ε and ω.
pub(crate) fn states(count: usize) -> Result<Vec<GrazingState>, grazing_theorems::TheoryError> {
    let mut sampler = Sampler::new(11);
    let mut one = || {
        let theory =
            grazing_theorems::LinearOscillator::new(sampler.between(0.01, 0.9), sampler.between(0.1, 1.0))?;
        theory.grazing(sampler.between(0.3, 3.0))
    };
    (0..count).map(|_| one()).collect()
}

/// The tolerance of sixth-order differences: 10⁻¹², and about ten times that for nested ones.
pub(crate) const DIFFERENCES: f64 = 1e-10;
/// The tolerance of closed forms with the same rounding: angles of up to 2πp ω₁/ω ≈ 80 are rounded to
/// 10⁻¹⁴.
pub(crate) const CLOSED: f64 = 1e-12;
pub(crate) const STATES: &str = "grazing states with ζ in (0.01, 0.9) and ω in (0.3, 3)";

/// e^{−2πpζ/ω}, cos and sin of 2πp ω₁/ω, ζ/ω₁, ω₁.
pub(crate) struct Turn {
    pub(crate) decay: f64,
    pub(crate) cosine: f64,
    pub(crate) sine: f64,
    pub(crate) skew: f64,
    pub(crate) natural: f64,
}

impl Turn {
    pub(crate) fn new(state: &GrazingState, loops: u32) -> Self {
        let zeta = state.oscillator().damping_ratio();
        let natural = (1.0 - zeta * zeta).sqrt();
        let turns = TAU * f64::from(loops) / state.forcing_frequency();
        let (sine, cosine) = libm::sincos(turns * natural);
        Self { decay: libm::exp(-turns * zeta), cosine, sine, skew: zeta / natural, natural }
    }

    /// a₂₂ of the p-th iterate.
    pub(crate) fn entry(&self) -> f64 {
        self.decay * (self.cosine - self.skew * self.sine)
    }
}
