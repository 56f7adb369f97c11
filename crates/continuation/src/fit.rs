//! Quadratic coefficients measured on the continued curves.
//!
//! An SN or PD curve is smooth in the impact velocity y, and so through y = 0 and the resonance:
//! with η(y) and μ(y) = primary − primary_graz(η), measured from the resonance,
//!
//! ```text
//! η = e₁ y + e₂ y² + …,   μ = m₂ y² + m₃ y³ + …,   lim μ/η² = m₂/e₁².
//! ```
//!
//! Both functions are interpolated at Chebyshev's nodes to either side of y = 0, where derivatives
//! of the interpolants lose least to rounding. The expansions converge however small e₁ is, as
//! where s_p^± is nearly zero and the ratio μ/η² itself changes at once. Neither η* nor μ_graz at
//! the resonance enters, so that errors of these, the same at all nodes, drop out.

use core::f64::consts::{FRAC_PI_2, PI};

use grazing_model::ImpactOscillator;
use grazing_theorems::from_map::{GrazingOrbitError, GrazingPlace};

use crate::locate::{Condition, LocateFailure, locate};
use crate::mps::{EventTimes, LoopEquations, unknown};
use crate::resonance::ResonantGrazingPoint;

/// A coefficient could not be measured.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum FitError {
    /// A point of the curve was not found.
    #[error("no point of the curve at impact velocity {velocity:.1e}: {failure}")]
    NoPoint {
        /// The impact velocity asked for.
        velocity: f64,
        /// What happened.
        failure: LocateFailure,
    },
    /// The grazing orbit at the point's η was not found.
    #[error(transparent)]
    GrazingOrbit(#[from] GrazingOrbitError),
    /// Whoever measured was asked to end.
    #[error("an end was asked for before it was measured")]
    NotFinished,
}

/// A value with an estimate of its error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// The value.
    pub value: f64,
    /// Estimated absolute error.
    pub error: f64,
}

/// What was measured on a curve at its resonance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measurement {
    /// lim μ/η².
    pub coefficient: Estimate,
    /// e₁ and e₂ of η = e₁ y + e₂ y² + ….
    pub eta: [f64; 2],
    /// m₂ and m₃ of μ = m₂ y² + m₃ y³ + ….
    pub mu: [f64; 2],
    /// The greatest impact velocity at which it was measured.
    pub velocity: f64,
}

/// lim μ/η² along the SN or PD curve as it runs into the resonance.
///
/// # Errors
/// A point of the curve or its grazing orbit was not found, even close to the resonance.
pub fn quadratic_coefficient<O: ImpactOscillator>(
    resonance: &ResonantGrazingPoint<O>,
    condition: Condition,
) -> Result<Estimate, FitError> {
    measure(resonance, condition).map(|measurement| measurement.coefficient)
}

/// Nodes of an interpolant, an even number so that none is y = 0.
const NODES: usize = 12;
/// Coefficients at the end of an interpolant that are taken for its error: what is in them is
/// truncation and rounding.
const TAIL: usize = 4;
/// The first nodes reach to this part of the velocity up to which the curve is known to stay near
/// its tangent ([`scale`]).
const FIRST: f64 = 0.25;
/// No nodes are nearer to y = 0 than 2⁻³⁰ of the first: there nothing is left of μ but rounding.
const DEEPEST: f64 = 1e-9;
/// Halving the distance of the nodes divides truncation, of order eight at least, by hundreds, and
/// leaves rounding as it is.
const FALLING: f64 = 0.25;
/// The nodes come nearer by this factor at least: what is far from y = 0 says little of what is
/// near.
const LONGEST: f64 = 1.0 / 16.0;
/// An error that has grown from level to level this often grows for good.
const GROWING: usize = 3;
/// Rounding scatters, and a tail may be small by chance: the error is this many times what the tail
/// says (empirical: the calibration in the tests of `unfold`).
const SAFETY: f64 = 3.0;

/// The coefficient of the quadratic term and those next to it.
///
/// From level to level the nodes come nearer to y = 0, as far as the terms beyond the interpolant
/// ask for, until these vanish in rounding. The level with the least error is kept.
///
/// # Errors
/// A point of the curve or its grazing orbit was not found, even close to the resonance.
pub fn measure<O: ImpactOscillator>(
    resonance: &ResonantGrazingPoint<O>,
    condition: Condition,
) -> Result<Measurement, FitError> {
    let equations = resonance.equations();
    let mut reach = FIRST * scale(resonance, condition);
    let deepest = DEEPEST * reach;
    let [primary, secondary] = resonance.orbit().oscillator().parameters();
    let rounding = [secondary, primary].map(|parameter| f64::EPSILON * parameter.abs());
    let mut levels: Vec<Level> = Vec::new();
    let (mut best, mut failure) = (0, None);
    while reach > deepest {
        let level = match Level::of(resonance, equations, condition, reach) {
            Ok(level) => level,
            Err(error) => {
                failure = Some(error);
                reach *= 0.5;
                continue;
            }
        };
        reach *= level.remedy(rounding);
        let settled = levels.last().is_some_and(|last| level.settles(last));
        levels.push(level);
        let error = |index: usize| levels[index].measured(levels[index].tails).coefficient.error;
        if error(levels.len() - 1) < error(best) {
            best = levels.len() - 1;
        }
        if settled || levels.len() > best + GROWING {
            break;
        }
    }
    match (levels.get(best), failure) {
        (Some(level), _) => {
            // Rounding is the same nearer to y = 0: where the tail is small by chance here, it is
            // not there as well.
            let nearer = levels.get(best + 1).unwrap_or(level);
            let tails = [0, 1].map(|k| level.tails[k].max(nearer.tails[k]));
            // Differences without any scatter are all zero: far below rounding.
            let tails = [0, 1].map(|k| if tails[k] > 0.0 { tails[k] } else { rounding[k] });
            let measured = level.measured(tails);
            // The error of integration may vary with y as smoothly as the curve does, and no tail
            // shows it.
            let Some(finer) = equations.finely() else { return Ok(measured) };
            let mut fine = Level::of(resonance, &finer, condition, level.reach)?.measured(tails);
            fine.coefficient.error += (fine.coefficient.value - measured.coefficient.value).abs();
            Ok(fine)
        }
        (None, Some(failure)) => Err(failure),
        (None, None) => unreachable!("a level without points has a failure"),
    }
}

/// The velocity up to which a curve may stay near its tangent: γ/ω, the scale of the motion at the
/// wall, and no further than to where, at the tangent's η, the map P_global has become another one.
fn scale<O: ImpactOscillator>(resonance: &ResonantGrazingPoint<O>, condition: Condition) -> f64 {
    let grazing = &resonance.resonant_point().grazing;
    let direction = resonance.direction(condition);
    let slope = (direction[unknown::VELOCITY] / direction[unknown::SECONDARY]).abs();
    let turn = grazing.map.a.norm() / resonance.orbit().derivative_of_map().norm();
    (grazing.gamma / grazing.forcing_frequency).min(slope * turn)
}

/// η and μ as functions of y/`reach`.
struct Level {
    reach: f64,
    eta: Interpolant,
    mu: Interpolant,
    /// The size of the coefficients of η and of μ that are in error.
    tails: [f64; 2],
}

impl Level {
    fn of<O: ImpactOscillator>(
        resonance: &ResonantGrazingPoint<O>,
        equations: &LoopEquations<O>,
        condition: Condition,
        reach: f64,
    ) -> Result<Self, FitError> {
        let origin = resonance.unknowns();
        let direction = resonance.direction(condition);
        let tangent = direction / direction[unknown::VELOCITY];
        let (mut eta, mut mu) = ([0.0; NODES], [0.0; NODES]);
        // To either side outwards, along the line through the last two points.
        for outwards in [NODES / 2..NODES, 0..NODES / 2] {
            let mut indices: Vec<usize> = outwards.collect();
            indices.sort_by(|a, b| node(*a).abs().total_cmp(&node(*b).abs()));
            let (mut last, mut along) = (origin, tangent);
            let mut times = EventTimes::default();
            for index in indices {
                let velocity = reach * node(index);
                let near = last + along * (velocity - last[unknown::VELOCITY]);
                let conditions = [condition, Condition::ImpactVelocity(velocity)];
                let no_point = |failure| FitError::NoPoint { velocity, failure };
                let mut point = locate(equations, conditions, near, &mut times).map_err(no_point)?;
                // Newton's method ends when a step is small; one more is exact to rounding.
                point = locate(equations, conditions, point, &mut times).map_err(no_point)?;
                eta[index] = point[unknown::SECONDARY] - origin[unknown::SECONDARY];
                let phase = resonance.orbit().phase() + resonance.orbit().phase_slope() * eta[index];
                let place = GrazingPlace::find(&equations.oscillator_at(&point), phase)?;
                mu[index] = point[unknown::PRIMARY] - place.parameters[0];
                along = (point - last) / (velocity - last[unknown::VELOCITY]);
                last = point;
            }
        }
        let (eta, mu) = (Interpolant::through(&eta), Interpolant::through(&mu));
        Ok(Self { reach, tails: [eta.tail(), mu.tail()], eta, mu })
    }

    /// The factor by which the nodes have to come nearer for the tails to come down to rounding: a
    /// half at most.
    fn remedy(&self, rounding: [f64; 2]) -> f64 {
        let excess = (self.tails[0] / rounding[0]).max(self.tails[1] / rounding[1]);
        // The tail begins with lower powers than this: it is not overdone.
        libm::pow(excess, -1.0 / NODES as f64).clamp(LONGEST, 0.5)
    }

    /// Nothing but rounding is left in the tails, as in those of a level that is farther away.
    fn settles(&self, farther: &Self) -> bool {
        let stays = |k: usize| self.tails[k] > FALLING * farther.tails[k];
        // η is a straight line there, or at most a parabola.
        stays(0) && stays(1) && self.tails[0] < 1e-3 * self.eta.size()
    }

    fn measured(&self, tails: [f64; 2]) -> Measurement {
        let Self { reach, eta, mu, .. } = self;
        let degrees = [eta.degree(tails[0]).max(1), mu.degree(tails[1]).max(2)];
        let [_, e1, e2, _] = eta.taylor(degrees[0]);
        let [_, _, m2, m3] = mu.taylor(degrees[1]);
        let value = m2 / (e1 * e1);
        // The weights in e₁ and in m₂ of the first coefficient that is left out, larger than those
        // that are not.
        let next = degrees.map(|degree| (degree + 1) as f64);
        let [of_e1, of_m2] = [next[0] * tails[0], 0.5 * next[1] * next[1] * tails[1]];
        let square = reach * reach;
        Measurement {
            coefficient: Estimate {
                value,
                error: SAFETY * (2.0 * of_e1 * (value / e1).abs() + of_m2 / (e1 * e1)),
            },
            eta: [e1 / reach, e2 / square],
            mu: [m2 / square, m3 / (square * reach)],
            velocity: *reach,
        }
    }
}

/// The nodes in (−1, 1), from the right to the left.
fn node(index: usize) -> f64 {
    libm::cos(PI * (index as f64 + 0.5) / NODES as f64)
}

/// Coefficients of Chebyshev's polynomials.
struct Interpolant([f64; NODES]);

impl Interpolant {
    fn through(values: &[f64; NODES]) -> Self {
        Self(core::array::from_fn(|degree| {
            let term = |(index, value): (usize, &f64)| {
                value * libm::cos(PI * degree as f64 * (index as f64 + 0.5) / NODES as f64)
            };
            let sum: f64 = values.iter().enumerate().map(term).sum();
            sum * if degree == 0 { 1.0 } else { 2.0 } / NODES as f64
        }))
    }

    /// The degree above which no coefficient stands out of the tail.
    fn degree(&self, tail: f64) -> usize {
        self.0.iter().rposition(|coefficient| coefficient.abs() > tail).unwrap_or(0)
    }

    /// The terms of the expansion about zero up to the third order, from the coefficients up to a
    /// degree.
    fn taylor(&self, degree: usize) -> [f64; 4] {
        let mut terms = [0.0; 4];
        for (degree, coefficient) in self.0[..=degree].iter().enumerate() {
            let n = degree as f64;
            let (sine, cosine) = (libm::sin(FRAC_PI_2 * n), libm::cos(FRAC_PI_2 * n));
            // Derivatives of cos(n arccos x) at x = 0.
            let derivatives = [cosine, n * sine, -n * n * cosine / 2.0, n * (1.0 - n * n) * sine / 6.0];
            for (term, derivative) in terms.iter_mut().zip(derivatives) {
                *term += coefficient * derivative;
            }
        }
        terms
    }

    /// The largest coefficient.
    fn size(&self) -> f64 {
        self.0.iter().fold(0.0, |largest: f64, entry| largest.max(entry.abs()))
    }

    /// The largest of the last coefficients, and the value at zero, where the resonance is.
    fn tail(&self) -> f64 {
        let [at_zero, ..] = self.taylor(NODES - 1);
        self.0[NODES - TAIL..].iter().fold(at_zero.abs(), |largest, entry| largest.max(entry.abs()))
    }
}
