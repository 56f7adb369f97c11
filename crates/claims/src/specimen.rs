//! Generic oscillators to measure on: members of the class of section 2.1.
//!
//! The paper's oscillator has a linear force, Φ = ε and Ψ = 0, so that γ = ω², α = 1 + ε, a₁₁ = a₂₂ where
//! a₁₂ = 0, β > 0 and complex eigenvalues: many errors in sections 2, 4 and 5 are invisible on it. A
//! [`Law`] may have a hardening spring, damping that depends on the position, and Φ and Ψ that vary with
//! impact and parameters. A [`Specimen`] moves in closed form where its force is linear.

pub(crate) mod generic;
pub(crate) mod resonant;

use crate::*;
use grazing_continuation::resonance::LocatedResonance;
use grazing_model::flow_variable::{PRIMARY, SECONDARY};
use grazing_model::smooth::{Function, Integrated, Scalar, SmoothOscillator, Taylor};
use grazing_model::{AnyMotion, FlowJet, LinearOscillator, MapJet, ParameterJet, ThirdOrder};

/// A function of impact and parameters of one sign: `size · exp(rates · (y, sin z, μ, η))`.
///
/// All quantities are dimensionless. Derivatives of all orders are nonzero, unless a rate is zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exponential {
    /// The factor in front, including its sign.
    pub size: f64,
    /// The coefficients of y, sin z, μ and η in the exponent.
    pub rates: [f64; 4],
}

impl Exponential {
    /// A function that is the same at all impacts.
    pub const fn constant(size: f64) -> Self {
        Self { size, rates: [0.0; 4] }
    }

    /// The value at (y, z; μ, η).
    pub fn at<S: Scalar>(&self, [y, z, mu, eta]: [S; 4]) -> S {
        let arguments = [y, z.apply(Function::Sin), mu, eta];
        let terms = arguments.into_iter().zip(self.rates).map(|(argument, rate)| argument.scale(rate));
        let exponent = terms.fold(S::constant(0.0), |sum, term| sum + term);
        exponent.apply(Function::Exp).scale(self.size)
    }
}

/// A generic reset law: every derivative of Φ and Ψ is nonzero, and α > 0.
pub const RESTITUTION: Exponential = Exponential { size: 0.7, rates: [-0.4, 0.3, -0.2, 0.15] };
/// The Ψ that belongs to [`RESTITUTION`].
pub const DELAY: Exponential = Exponential { size: 0.25, rates: [0.5, -0.35, 0.2, 0.3] };

/// ü + 2ζ (1 + d u) u̇ + u + κ u³ = 𝒜 cos(ωt), u = x + 1, wall at x = 0, R = (−y Φ, z + y Ψ).
///
/// Paper: eq:F, eq:R. With d = κ = 0, Φ = ε and Ψ = 0 it is the oscillator of section 3.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Law {
    /// The damping ratio ζ.
    pub damping: f64,
    /// The coefficient d: how fast the damping grows with the position.
    pub damping_slope: f64,
    /// The coefficient κ of the restoring force.
    pub stiffening: f64,
    /// The function Φ, of positive size, of the impact and of (𝒜, ω).
    pub restitution: Exponential,
    /// The function Ψ of the impact and of (𝒜, ω).
    pub delay: Exponential,
    /// Whether μ is the forcing frequency ω and η the amplitude 𝒜; otherwise they are exchanged.
    pub frequency_first: bool,
    /// The multiple of μ that is subtracted from η, so that both 𝒜 and ω change with μ.
    pub pull: f64,
}

/// A specimen at grazing.
pub type Grazing = GrazingOrbit<Specimen>;

/// The number of steps in which the grazing orbit of the linear oscillator is followed as d and κ grow:
/// Newton's method converges from each to the next for d up to 0.9 and κ up to 0.4 (empirical).
const STEPS: u32 = 6;

impl Law {
    /// The oscillator of section 3.
    pub const fn linear(damping: f64, restitution: f64) -> Self {
        Self {
            damping,
            damping_slope: 0.0,
            stiffening: 0.0,
            restitution: Exponential::constant(restitution),
            delay: Exponential::constant(0.0),
            frequency_first: false,
            pull: 0.0,
        }
    }

    /// The oscillator of section 3 with a variable reset law.
    pub const fn varying(damping: f64) -> Self {
        Self { restitution: RESTITUTION, delay: DELAY, ..Self::linear(damping, 1.0) }
    }

    /// An oscillator with a variable reset law and a nonlinear force: γ ≠ ω², and a₁₁ ≠ a₂₂ where a₁₂ =
    /// 0.
    pub const fn nonlinear(damping: f64) -> Self {
        Self {
            damping_slope: -0.9,
            stiffening: 0.4,
            delay: Exponential { size: 0.1, ..DELAY },
            ..Self::varying(damping)
        }
    }

    /// A random generic law, with Φ in (0, 1) and frequencies up to 3; one in ten is nonlinear.
    pub fn random(sampler: &mut Sampler, damping: f64) -> Self {
        let mut factor = |size: f64| Exponential {
            size,
            rates: [
                sampler.between(-0.4, -0.05),
                sampler.between(-0.15, 0.15),
                sampler.between(-0.05, 0.05),
                sampler.between(-0.05, 0.05),
            ],
        };
        let (mut restitution, mut delay) = (factor(1.0), factor(1.0));
        restitution.size = sampler.between(0.4, 0.6);
        delay.size = sampler.one_of(&[1.0, -1.0]) * sampler.between(0.05, 0.25);
        let linear = Self { restitution, delay, ..Self::linear(damping, 1.0) };
        // Integrated motion takes a hundred times as long.
        if sampler.between(0.0, 1.0) < 0.9 {
            return linear;
        }
        let damping_slope = sampler.one_of(&[1.0, -1.0]) * sampler.between(0.3, 0.6);
        Self { damping_slope, stiffening: sampler.between(0.1, 0.25), ..linear }
    }

    /// A random oscillator with a generic law at grazing.
    pub fn random_grazing(sampler: &mut Sampler) -> Result<Grazing, CheckError> {
        let damping = sampler.between(0.01, 0.25);
        let law = Self::random(sampler, damping);
        // At lower frequencies hardening springs have other resonances, whose loops graze first.
        let lowest = if law.force_is_linear() { 0.35 } else { 0.7 };
        law.grazing(sampler.between(lowest, 1.9))
    }

    /// The law with the frequency as the primary parameter.
    pub const fn frequency_first(self) -> Self {
        Self { frequency_first: true, ..self }
    }

    fn force_is_linear(&self) -> bool {
        self.damping_slope == 0.0 && self.stiffening == 0.0
    }

    /// The pair (𝒜, ω) for (μ, η).
    fn forcing<S: Scalar>(&self, [mu, eta]: [S; 2]) -> [S; 2] {
        let pulled = eta - mu.scale(self.pull);
        if self.frequency_first { [pulled, mu] } else { [mu, pulled] }
    }

    /// The pair (μ, η) for (𝒜, ω).
    fn parameters(&self, [amplitude, frequency]: [f64; 2]) -> [f64; 2] {
        let [mu, pulled] = if self.frequency_first { [frequency, amplitude] } else { [amplitude, frequency] };
        [mu, pulled + self.pull * mu]
    }

    /// The laws between the linear force and this one; the amplitude is the primary parameter.
    fn approach(self) -> impl Iterator<Item = Self> {
        let first = if self.force_is_linear() { STEPS } else { 1 };
        (first..=STEPS).map(move |step| {
            let share = f64::from(step) / f64::from(STEPS);
            Self {
                damping_slope: share * self.damping_slope,
                stiffening: share * self.stiffening,
                frequency_first: false,
                pull: 0.0,
                ..self
            }
        })
    }

    /// The oscillator at its grazing orbit at the forcing frequency ω.
    pub fn grazing(self, frequency: f64) -> Result<Grazing, CheckError> {
        // The linear oscillator's response has amplitude 1 and its maximum at phase z.
        let (stiffness, loss) = (1.0 - frequency * frequency, 2.0 * self.damping * frequency);
        let (mut amplitude, mut phase) = (libm::hypot(stiffness, loss), libm::atan2(loss, stiffness));
        for law in self.approach() {
            let orbit = GrazingOrbit::find(&Specimen::new(law, [amplitude, frequency]), phase)?;
            (amplitude, phase) = (orbit.primary(), orbit.phase());
        }
        let specimen = Specimen::new(self, self.parameters([amplitude, frequency]));
        Ok(GrazingOrbit::at(specimen, phase)?)
    }

    /// The oscillator at the resonance into which the resonance (p, n) of the linear oscillator is
    /// continued.
    pub fn resonance(self, loops: u32, index: u32) -> Result<LocatedResonance<Specimen>, CheckError> {
        let theory = grazing_theorems::LinearOscillator::new(self.damping, 1.0)?;
        let frequency = theory.resonance(loops, index)?.forcing_frequency();
        let start = Self { damping_slope: 0.0, stiffening: 0.0, frequency_first: false, pull: 0.0, ..self };
        let mut orbit = start.grazing(frequency)?;
        let mut parameters = orbit.oscillator().parameters();
        for law in self.approach() {
            let here = LocatedResonance::find(&Specimen::new(law, parameters), loops, orbit.phase())?;
            orbit = here.orbit().clone();
            parameters = orbit.oscillator().parameters();
        }
        let specimen = Specimen::new(self, self.parameters(parameters));
        Ok(LocatedResonance::find(&specimen, loops, orbit.phase())?)
    }
}

/// The ζ for which the linear oscillator has this E_p at its resonance (p, n).
pub fn damping_for_decay(loops: u32, index: u32, decay: f64) -> f64 {
    let p = f64::from(loops);
    let ratio = if loops == 1 { 0.5 * f64::from(index) } else { f64::from(index) + 0.5 / p };
    // E_p = e^{−2πpζ/ω} with ω₁/ω = ratio: ζ/ω₁ = −ln E_p/(2πp · ratio).
    let skew = -libm::log(decay) / (core::f64::consts::TAU * p * ratio);
    skew / (1.0 + skew * skew).sqrt()
}

/// The tally of random oscillators at grazing; for half of them the frequency is μ.
pub fn at_grazing<T: Default>(
    seed: u64,
    samples: usize,
    mut sample: impl FnMut(&mut Sampler, &Grazing, &mut T) -> Result<(), CheckError>,
) -> Result<T, CheckError> {
    drawn(seed, samples, |sampler, tally| {
        let orbit = Law::random_grazing(sampler)?;
        let exchanged = sampler.one_of(&[true, false]);
        let orbit = if exchanged { frequency_first(&orbit)? } else { orbit };
        sample(sampler, &orbit, tally)
    })
}

/// The grazing orbit with the frequency as its primary parameter instead of the amplitude.
pub fn frequency_first(orbit: &Grazing) -> Result<Grazing, CheckError> {
    let [amplitude, frequency] = orbit.oscillator().parameters();
    let law = orbit.oscillator().law().frequency_first();
    Ok(GrazingOrbit::at(Specimen::new(law, [frequency, amplitude]), orbit.phase())?)
}

impl SmoothOscillator for Law {
    fn force<S: Scalar>(&self, x: S, y: S, t: S, mu: S, eta: S) -> S {
        self.force_at(t, mu, eta)(x, y)
    }

    fn force_at<T: Scalar, S: Scalar + From<T>>(&self, t: T, mu: T, eta: T) -> impl FnMut(S, S) -> S {
        let [amplitude, frequency] = self.forcing([mu, eta]);
        let forcing = S::from(amplitude * (frequency * t).apply(Function::Cos));
        let one = S::constant(1.0);
        let (damping, slope, stiffening) = (2.0 * self.damping, self.damping_slope, self.stiffening);
        move |x, y| {
            let u = x + one;
            forcing - (one + u.scale(slope)) * y.scale(damping) - u * (one + u.square().scale(stiffening))
        }
    }

    fn forcing_frequency<S: Scalar>(&self, mu: S, eta: S) -> S {
        self.forcing([mu, eta])[1]
    }

    fn restitution<S: Scalar>(&self, y: S, z: S, mu: S, eta: S) -> S {
        let [amplitude, frequency] = self.forcing([mu, eta]);
        self.restitution.at([y, z, amplitude, frequency])
    }

    fn impact_duration<S: Scalar>(&self, y: S, z: S, mu: S, eta: S) -> S {
        let [amplitude, frequency] = self.forcing([mu, eta]);
        self.delay.at([y, z, amplitude, frequency])
    }
}

/// An oscillator with a [`Law`] at parameters (μ, η).
#[derive(Clone, Debug)]
pub struct Specimen {
    law: Integrated<Law>,
    /// An oscillator with the same motion in closed form, if the force is linear.
    linear: Option<LinearOscillator>,
}

impl Specimen {
    /// The oscillator with this law.
    pub fn new(law: Law, parameters: [f64; 2]) -> Self {
        let [amplitude, frequency] = law.forcing(parameters);
        // Its coefficient of restitution is not used.
        let linear = LinearOscillator::new(law.damping, 1.0, amplitude, frequency).ok();
        Self {
            law: Integrated::new(law, parameters),
            linear: linear.filter(|_| law.force_is_linear() && law.pull == 0.0),
        }
    }

    /// The law.
    pub fn law(&self) -> &Law {
        self.law.model()
    }

    /// Φ and Ψ at an impact.
    pub fn factors(&self, velocity: f64, phase: f64) -> [f64; 2] {
        let ([mu, eta], law) = (self.parameters(), self.law());
        [law.restitution(velocity, phase, mu, eta), law.impact_duration(velocity, phase, mu, eta)]
    }
}

impl ImpactOscillator for Specimen {
    type Motion = AnyMotion;

    fn parameters(&self) -> [f64; 2] {
        self.law.parameters()
    }

    fn with_parameters(&self, parameters: [f64; 2]) -> Self {
        let linear = self.linear.map(|linear| linear.with_parameters(self.law().forcing(parameters)));
        Self { law: self.law.with_parameters(parameters), linear }
    }

    fn forcing_frequency(&self) -> ParameterJet {
        self.law.forcing_frequency()
    }

    fn acceleration(&self, state: State) -> f64 {
        self.law.acceleration(state)
    }

    fn flow_along<const ORDER: usize>(&self, motion: &AnyMotion, from: State, duration: f64) -> FlowJet {
        let Some(linear) = &self.linear else {
            return match motion.downcast_ref() {
                Some(motion) => self.law.flow_along::<ORDER>(motion, from, duration),
                None => self.law.flow::<ORDER>(from, duration),
            };
        };
        let mut jet = linear.flow::<ORDER>(from, duration);
        if self.law().frequency_first {
            jet.jacobian.swap_columns(PRIMARY, SECONDARY);
            for hessian in &mut jet.hessians {
                hessian.swap_columns(PRIMARY, SECONDARY);
                hessian.swap_rows(PRIMARY, SECONDARY);
            }
        }
        jet
    }

    fn reset<const ORDER: usize>(&self, impact: OnWall) -> MapJet<OnWall, OnWall> {
        self.law.reset::<ORDER>(impact)
    }

    fn motion(&self, from: State) -> AnyMotion {
        match &self.linear {
            Some(linear) => AnyMotion::new(linear.motion(from)),
            None => AnyMotion::new(self.law.motion(from)),
        }
    }
}

impl ThirdOrder for Specimen {
    fn flow_series(&self, from: [Taylor; 3], duration: Taylor) -> [Taylor; 2] {
        self.law.flow_series(from, duration)
    }

    fn reset_series(&self, velocity: Taylor, phase: Taylor) -> [Taylor; 2] {
        self.law.reset_series(velocity, phase)
    }
}
