//! Resonances to measure at, and points near them.

use std::cell::RefCell;
use std::collections::BTreeMap;

use grazing_continuation::locate::{Condition, locate};
use grazing_continuation::mps::{Memory, Unknowns, unknown};
use grazing_continuation::resonance::ResonantGrazingPoint;
use grazing_model::maps::global_iterate;
use grazing_model::{ImpactOscillator, LinearOscillator};
use grazing_theorems::from_map::GrazingOrbit;
use grazing_theorems::resonant_theorem::BifurcationCurve;
use grazing_theorems::{GrazingPoint, Resonance, ResonantPoint};
use nalgebra::{Matrix2, Vector2};

use crate::convergence;
use crate::outcome::Measure;
use crate::sampling::Sampler;
use crate::specimen::{DELAY, RESTITUTION, VaryingReset, varying_at_grazing};

/// Why a check cannot be carried out.
pub(super) type Failure = Box<dyn std::error::Error + Send + Sync>;

/// A resonant grazing point of one oscillator.
pub(super) struct Place<O> {
    pub(super) resonance: ResonantGrazingPoint<O>,
}

/// Coordinates of a point near a resonance: y, z − z_graz,η, μ, η.
pub(super) type Offset = [f64; 4];

/// A point near a resonance, with the grazing orbit at its η.
#[derive(Clone)]
pub(super) struct Near<O> {
    pub(super) unknowns: Unknowns,
    pub(super) orbit: GrazingOrbit<O>,
}

/// The numbers of section 5 at a resonance, in the paper's symbols.
pub(super) struct Symbols {
    pub(super) alpha: f64,
    pub(super) omega: f64,
    pub(super) gamma: f64,
    pub(super) phi: f64,
    /// A^p at the resonance as section 5 writes it: A for p = 1, −δ^{p/2} I for p ≥ 2 (the upper right entry is zero).
    pub(super) power: Matrix2<f64>,
    /// ξ_p.
    pub(super) xi: f64,
    /// d_p.
    pub(super) d: f64,
    /// e_p.
    pub(super) e: f64,
    /// f_p along the grazing curve: a₁₂' and eq:fp.
    pub(super) f: f64,
}

impl<O: ImpactOscillator> Place<O> {
    fn find(orbit: &GrazingOrbit<O>, loops: u32) -> Result<Self, Failure> {
        Ok(Self { resonance: ResonantGrazingPoint::find(orbit.oscillator(), loops, orbit.phase())? })
    }

    pub(super) fn loops(&self) -> u32 {
        self.resonance.loops()
    }

    pub(super) fn point(&self) -> &ResonantPoint {
        self.resonance.resonant_point()
    }

    pub(super) fn symbols(&self) -> Result<Symbols, Failure> {
        let point = self.point();
        let GrazingPoint { map, forcing_frequency: omega, gamma, phi, .. } = point.grazing;
        let orbit = self.resonance.orbit();
        let jet = global_iterate::<O, 2>(orbit.oscillator(), self.loops(), 0.0, orbit.phase())?;
        let power = if self.loops() == 1 {
            Matrix2::new(map.a.m11, 0.0, map.a.m21, map.a.m22)
        } else {
            -Matrix2::identity() * libm::pow(map.determinant(), 0.5 * f64::from(self.loops()))
        };
        Ok(Symbols {
            alpha: point.grazing.alpha(),
            omega,
            gamma,
            phi,
            power,
            xi: point.second_phase_derivative,
            d: jet.hessians[0][(0, 1)],
            e: jet.hessians[0][(1, 2)],
            f: point.off_diagonal_slope(),
        })
    }

    /// The grazing orbit at a distance η from the resonance.
    pub(super) fn grazing(&self, eta: f64) -> Option<GrazingOrbit<O>> {
        let orbit = self.resonance.orbit();
        let [primary, secondary] = orbit.oscillator().parameters();
        let parameters = [primary + orbit.primary_slope() * eta, secondary + eta];
        let oscillator = orbit.oscillator().with_parameters(parameters);
        GrazingOrbit::find(&oscillator, orbit.phase() + orbit.phase_slope() * eta).ok()
    }

    /// The point at an offset from the resonance.
    pub(super) fn near(&self, [y, z, mu, eta]: Offset) -> Option<Near<O>> {
        let orbit = self.grazing(eta)?;
        let [primary, secondary] = orbit.oscillator().parameters();
        Some(Near { unknowns: Unknowns::new(y, orbit.phase() + z, primary + mu, secondary), orbit })
    }

    /// z_graz at the resonance itself.
    pub(super) fn fixed_phase(&self) -> f64 {
        self.resonance.orbit().phase()
    }

    /// The zero of the VIVID function with impact velocity y at η: (z, μ) = (Z, M)(y, η) of eq:ZM.
    pub(super) fn on_branch(&self, y: f64, eta: f64) -> Option<Near<O>> {
        let branch = self.resonance.theorem().branch();
        let near = self.near([y, branch.k_1 * y, branch.parameter(y, eta), eta])?;
        self.located([Condition::ImpactVelocity(y), Condition::Secondary(near.unknowns[3])], near)
    }

    /// The point of a bifurcation curve at η, from its leading terms.
    pub(super) fn on_curve(&self, curve: &Bifurcation, eta: f64) -> Option<Near<O>> {
        let leading = &curve.leading;
        let near = self.near([
            leading.impact_velocity_slope * eta,
            leading.impact_phase_slope * eta,
            leading.coefficient * eta * eta,
            eta,
        ])?;
        self.located([curve.condition, Condition::Secondary(near.unknowns[3])], near)
    }

    fn located(&self, conditions: [Condition; 2], near: Near<O>) -> Option<Near<O>> {
        let unknowns =
            locate(self.resonance.equations(), conditions, near.unknowns, &mut Memory::default()).ok()?;
        Some(Near { unknowns, ..near })
    }

    /// The saddle-node and the period-doubling curve.
    pub(super) fn curves(&self) -> [Bifurcation; 2] {
        let theorem = self.resonance.theorem();
        let stability = self.point().stability_coefficients();
        [
            Bifurcation {
                condition: Condition::SADDLE_NODE,
                leading: theorem.saddle_node(),
                stability: stability.plus,
            },
            Bifurcation {
                condition: Condition::PERIOD_DOUBLING,
                leading: theorem.period_doubling(),
                stability: stability.minus,
            },
        ]
    }
}

/// A bifurcation curve of the theorem.
pub(super) struct Bifurcation {
    pub(super) condition: Condition,
    pub(super) leading: BifurcationCurve,
    /// s_p^+ or s_p^-.
    pub(super) stability: f64,
}

impl<O: ImpactOscillator> Near<O> {
    /// (z − z_graz,η, μ).
    pub(super) fn relative(&self) -> [f64; 2] {
        [
            self.unknowns[unknown::PHASE] - self.orbit.phase(),
            self.unknowns[unknown::PRIMARY] - self.orbit.primary(),
        ]
    }

    /// The oscillator at the point's parameters.
    pub(super) fn oscillator(&self) -> O {
        self.orbit
            .oscillator()
            .with_parameters([self.unknowns[unknown::PRIMARY], self.unknowns[unknown::SECONDARY]])
    }

    /// The impact (y, z).
    pub(super) fn impact(&self) -> Vector2<f64> {
        self.unknowns.fixed_rows::<2>(0).into_owned()
    }
}

/// Which numbers of loops.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Loops {
    One,
    Many,
    Any,
}

impl Loops {
    fn includes(self, loops: u32) -> bool {
        match self {
            Self::One => loops == 1,
            Self::Many => loops > 1,
            Self::Any => true,
        }
    }
}

/// The indices (p, n) of the resonances that are looked at.
fn indices(which: Loops) -> impl Iterator<Item = (u32, u32)> {
    let all = (1..=5_u32).flat_map(|loops| (1..=if loops == 1 { 4 } else { 2 }).map(move |n| (loops, n)));
    all.filter(move |(loops, _)| which.includes(*loops))
}

/// The resonance (p, n) of the linear oscillator with this ε, damped so that E_p is about `decay`.
fn with_decay(loops: u32, n: u32, decay: f64, restitution: f64) -> Result<Resonance, Failure> {
    let p = f64::from(loops);
    let ratio = if loops == 1 { 0.5 * f64::from(n) } else { f64::from(n) + 0.5 / p };
    // E_p = e^{−2πpζ/ω} with ω₁/ω = ratio: ζ/ω₁ = −ln E_p/(2πp · ratio).
    let skew = -libm::log(decay) / (core::f64::consts::TAU * p * ratio);
    let zeta = skew / (1.0 + skew * skew).sqrt();
    Ok(grazing_theorems::LinearOscillator::new(zeta, restitution)?.resonance(loops, n)?)
}

/// Resonances of the linear oscillator, with E_p and ε drawn at random, three to each (p, n).
pub(super) fn linear_resonances(which: Loops) -> Result<Vec<Resonance>, Failure> {
    let mut sampler = Sampler::new(5);
    let mut found = Vec::new();
    for (loops, n) in indices(which) {
        for _ in 0..3 {
            // Smaller E_p make the leading terms so small that they drown in rounding.
            let decay = sampler.between(0.15, 0.8);
            found.push(with_decay(loops, n, decay, sampler.between(0.3, 1.0))?);
        }
    }
    Ok(found)
}

/// The linear oscillator at [`linear_resonances`].
pub(super) fn linear(which: Loops) -> Result<Vec<Place<LinearOscillator>>, Failure> {
    linear_resonances(which)?.iter().map(at_resonance).collect()
}

/// The linear oscillator at one resonance.
pub(super) fn at_resonance(resonance: &Resonance) -> Result<Place<LinearOscillator>, Failure> {
    let theory = resonance.grazing().oscillator();
    let orbit = crate::specimen::linear_at_grazing(
        theory.damping_ratio(),
        theory.coefficient_of_restitution(),
        resonance.forcing_frequency(),
    )?;
    Place::find(&orbit, resonance.loops())
}

/// The oscillator with a reset law that varies, at one resonance for each (p, n).
pub(super) fn varying(which: Loops) -> Result<Vec<Place<VaryingReset>>, Failure> {
    let mut sampler = Sampler::new(6);
    let mut found = Vec::new();
    for (loops, n) in indices(which) {
        let resonance = with_decay(loops, n, sampler.between(0.3, 0.8), 1.0)?;
        let zeta = resonance.grazing().oscillator().damping_ratio();
        let orbit = varying_at_grazing(zeta, RESTITUTION, DELAY, resonance.forcing_frequency())?;
        found.push(Place::find(&orbit, loops)?);
    }
    Ok(found)
}

/// What a function finds at all resonances with the given numbers of loops, of both kinds of oscillators.
macro_rules! everywhere {
    ($which:expr, $measure:ident) => {{
        let mut found = Vec::new();
        for place in $crate::checks::resonant::places::linear($which)? {
            found.extend($measure(&place)?);
        }
        for place in $crate::checks::resonant::places::varying($which)? {
            found.extend($measure(&place)?);
        }
        found
    }};
}
pub(super) use everywhere;

/// The words for the samples of [`everywhere`].
pub(super) const EVERYWHERE: &str =
    "remainders at resonances with p up to 5 of the linear oscillator and of one with a varying reset law";

/// How far the order may lie below the stated one: what the next term does at the sizes where the remainder still stands a
/// hundredfold above its rounding.
pub(super) const SLACK: f64 = 0.3;

/// The same function, which computes each value once: several remainders are taken from one solution.
pub(super) fn remembered<T: Clone>(f: impl Fn(f64) -> Option<T>) -> impl Fn(f64) -> Option<T> {
    let known: RefCell<BTreeMap<u64, Option<T>>> = RefCell::default();
    move |size| known.borrow_mut().entry(size.to_bits()).or_insert_with(|| f(size)).clone()
}

/// The observed order of a remainder that exists down to the smallest size that was looked at; not a number if it does not.
pub(super) fn order(mut remainder: impl FnMut(f64) -> Option<(f64, f64)>) -> f64 {
    let mut exists = false;
    let observed = convergence::order(|size| {
        let found = remainder(size);
        exists = found.is_some();
        found
    });
    if exists { observed } else { f64::NAN }
}

/// An observed order and the stated one.
pub(super) type Observed = (f64, f64);

/// The order that lies lowest in comparison with the stated one.
pub(super) fn lowest(orders: &[Observed]) -> Measure {
    let worst =
        orders.iter().copied().reduce(|a, b| if b.0 - b.1 < a.0 - a.1 || b.0.is_nan() { b } else { a });
    let (observed, stated) = worst.unwrap_or((f64::NAN, f64::NAN));
    Measure::Order { observed, stated, slack: SLACK }
}

/// The largest of some deviations, or what is not a number among them.
pub(super) fn largest(gaps: &[f64]) -> f64 {
    gaps.iter().copied().fold(0.0, |a: f64, b| if a.is_nan() || b <= a { a } else { b })
}

/// Directions (y, z, μ, η) in which points approach a resonance, y of either sign and never small.
pub(super) fn directions(count: usize) -> Vec<Offset> {
    let mut sampler = Sampler::new(7);
    let mut one = || {
        let y = sampler.between(0.4, 1.0) * sampler.one_of(&[1.0, -1.0]);
        [y, sampler.between(-1.0, 1.0), sampler.between(-1.0, 1.0), sampler.between(-1.0, 1.0)]
    };
    (0..count).map(|_| one()).collect()
}

/// The direction times a size.
pub(super) fn scaled(direction: &Offset, size: f64) -> Offset {
    direction.map(|share| share * size)
}
