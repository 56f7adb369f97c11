//! Curves that leave a resonance in straightened coordinates, and measurement of their quadratic
//! coefficients.
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
//!
//! As differences of solutions η and μ lose all digits towards the resonance, μ as η². The
//! interpolants do not: divided by y and by y², which takes no difference
//! (`Interpolant::quotients`), they are E and M in
//!
//! ```text
//! η = y E(y),   μ = y² M(y),   μ/η² = M/E²,
//! ```
//!
//! whose relative error is the same at all scales ([`Straightened::at`]). That holds for any
//! oscillator, integrated or not, since only solutions at moderate y are used. GZ curves that leave
//! a resonance are such curves as well.

use core::f64::consts::PI;

use grazing_model::ImpactOscillator;
use grazing_theorems::from_map::{GrazingOrbitError, GrazingPlace};

use crate::locate::{Condition, LocateFailure, locate};
use crate::mps::{EventTimes, LoopEquations, Unknowns, unknown};
use crate::resonance::{LeavingCurve, ResonantGrazingPoint};

/// The reason why a coefficient could not be measured.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum CoefficientError {
    /// A point of the curve was not found.
    #[error("no point of the curve at impact velocity {velocity:.1e}: {failure}")]
    NoPoint {
        /// The requested impact velocity.
        velocity: f64,
        /// The reason why the point was not found.
        failure: LocateFailure,
    },
    /// The grazing orbit at the point's η was not found.
    #[error(transparent)]
    GrazingOrbit(#[from] GrazingOrbitError),
    /// The computation was cancelled.
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

/// The quantities measured on a curve at its resonance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measurement {
    /// The quadratic coefficient lim μ/η².
    pub coefficient: Estimate,
    /// The coefficients e₁ and e₂ of η = e₁ y + e₂ y² + ….
    pub eta: [f64; 2],
    /// The coefficients m₂ and m₃ of μ = m₂ y² + m₃ y³ + ….
    pub mu: [f64; 2],
    /// The greatest impact velocity used.
    pub velocity: f64,
}

/// The quadratic coefficient lim μ/η² of the SN or PD curve at the resonance.
///
/// # Errors
/// A point of the curve or its grazing orbit was not found, even close to the resonance.
pub fn quadratic_coefficient<O: ImpactOscillator>(
    resonance: &ResonantGrazingPoint<O>,
    condition: Condition,
) -> Result<Estimate, CoefficientError> {
    measure(resonance, condition).map(|measurement| measurement.coefficient)
}

/// Number of nodes of an interpolant, even so that none is y = 0.
const NODES: usize = 20;
/// Number of coefficients at the end of an interpolant that are taken for its error: they consist
/// of truncation and rounding.
const TAIL: usize = 4;
/// The first nodes reach to this fraction of the velocity up to which the curve is known to stay
/// near its tangent ([`scale`]).
const FIRST: f64 = 0.25;
/// No nodes are nearer to y = 0 than 2⁻³⁰ of the first: at that distance μ is lost in rounding.
const DEEPEST: f64 = 1e-9;
/// Halving the distance of the nodes divides truncation, of order eight at least, by hundreds, and
/// leaves rounding as it is.
const FALLING: f64 = 0.25;
/// The nodes approach y = 0 by at least this factor from level to level: points far from y = 0
/// carry little information about points near it.
const LONGEST: f64 = 1.0 / 16.0;
/// An error that has grown from level to level this many times keeps growing.
const GROWING: usize = 3;
/// Rounding scatters, and a tail may be small by chance: the error is this many times the estimate
/// from the tail (empirical: the calibration in the tests of `unfold`).
const SAFETY: f64 = 3.0;

/// The coefficient of the quadratic term and the neighbouring ones.
///
/// # Errors
/// A point of the curve or its grazing orbit was not found, even close to the resonance.
pub fn measure<O: ImpactOscillator>(
    resonance: &ResonantGrazingPoint<O>,
    condition: Condition,
) -> Result<Measurement, CoefficientError> {
    resonance.leaving(condition).straightened().map(|curve| curve.measurement)
}

impl<O: ImpactOscillator> LeavingCurve<'_, O> {
    /// The curve with η and μ as interpolants in y.
    ///
    /// From level to level the nodes come nearer to y = 0, as far as the terms beyond the
    /// interpolant require, until these vanish in rounding. The level with the least error is kept.
    ///
    /// # Errors
    /// A point of the curve or its grazing orbit was not found, even close to the resonance.
    pub fn straightened(&self) -> Result<Straightened, CoefficientError> {
        let mut reach = FIRST * self.scale();
        let deepest = DEEPEST * reach;
        let [primary, secondary] = self.resonance.orbit().oscillator().parameters();
        let rounding = [secondary, primary].map(|parameter| f64::EPSILON * parameter.abs());
        let mut levels: Vec<Level> = Vec::new();
        let (mut best, mut failure) = (0, None);
        while reach > deepest {
            let level = match self.level(&self.equations, reach) {
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
                // Rounding is the same nearer to y = 0: a tail that is small by chance here is not
                // small there as well.
                let nearer = levels.get(best + 1).unwrap_or(level);
                let tails = [0, 1].map(|k| level.tails[k].max(nearer.tails[k]));
                // Tails without any scatter are exactly zero, far below rounding.
                let tails = [0, 1].map(|k| if tails[k] > 0.0 { tails[k] } else { rounding[k] });
                let mut level = Level { tails, ..level.clone() };
                let mut measurement = level.measured(tails);
                let mut integration = 0.0;
                // The error of integration may vary with y as smoothly as the curve does, and no
                // tail shows it.
                if let Some(finer) = self.equations.finely() {
                    level = Level { tails, ..self.level(&finer, level.reach)? };
                    let usual = core::mem::replace(&mut measurement, level.measured(tails)).coefficient;
                    let fine = &mut measurement.coefficient;
                    integration = (fine.value - usual.value).abs();
                    fine.error += integration;
                    integration /= fine.value.abs();
                }
                Ok(Straightened { measurement, level, integration })
            }
            (None, Some(failure)) => Err(failure),
            (None, None) => unreachable!("a level without points has a failure"),
        }
    }

    /// The velocity up to which a curve may stay near its tangent: γ/ω, the scale of the motion at
    /// the wall, limited to velocities at which, at the tangent's η, the map P_global has not
    /// changed by its own size.
    fn scale(&self) -> f64 {
        let grazing = &self.resonance.resonant_point().grazing;
        let turn = grazing.map.a.norm() / self.resonance.orbit().derivative_of_map().norm();
        (grazing.gamma / grazing.forcing_frequency).min(self.leading.impact_velocity_slope.abs() * turn)
    }

    /// Event times at a point near the resonance.
    fn times(&self, equations: &LoopEquations<O>, near: &Unknowns) -> EventTimes {
        match self.visit {
            Some(visit) => {
                let orbit = self.resonance.orbit();
                let eta = near[unknown::SECONDARY] - self.resonance.unknowns()[unknown::SECONDARY];
                let phase = orbit.phase() + orbit.phase_slope() * eta;
                equations.touching_at_visit(near, phase, visit)
            }
            None => EventTimes::default(),
        }
    }

    /// The interpolants through nodes up to `reach`, computed from solutions of these equations.
    fn level(&self, equations: &LoopEquations<O>, reach: f64) -> Result<Level, CoefficientError> {
        let (origin, orbit) = (self.resonance.unknowns(), self.resonance.orbit());
        let direction = self.direction();
        let tangent = &direction / direction[unknown::VELOCITY];
        let (mut eta, mut mu) = ([0.0; NODES], [0.0; NODES]);
        // To either side outwards, along the line through the last two points.
        for outwards in [NODES / 2..NODES, 0..NODES / 2] {
            let mut indices: Vec<usize> = outwards.collect();
            indices.sort_by(|a, b| node(*a).abs().total_cmp(&node(*b).abs()));
            let (mut last, mut along) = (origin.clone(), tangent.clone());
            let mut times = None;
            for index in indices {
                let velocity = reach * node(index);
                let near = &last + &along * (velocity - last[unknown::VELOCITY]);
                let times = times.get_or_insert_with(|| self.times(equations, &near));
                let conditions = [self.condition, Condition::ImpactVelocity(velocity)];
                let no_point = |failure| CoefficientError::NoPoint { velocity, failure };
                let mut point = locate(equations, conditions, near, times).map_err(no_point)?;
                // Newton's method ends when a step is small; one more is exact to rounding.
                point = locate(equations, conditions, point, times).map_err(no_point)?;
                eta[index] = point[unknown::SECONDARY] - origin[unknown::SECONDARY];
                let phase = orbit.phase() + orbit.phase_slope() * eta[index];
                let there = equations.oscillator_at(&point);
                let place = GrazingPlace::along(&there, phase, orbit.passage().clone())?;
                mu[index] = point[unknown::PRIMARY] - place.parameters[0];
                along = (&point - &last) / (velocity - last[unknown::VELOCITY]);
                last = point;
            }
        }
        let (eta, mu) = (Interpolant::through(&eta), Interpolant::through(&mu));
        Ok(Level { reach, tails: [eta.tail(), mu.tail()], eta, mu })
    }
}

/// A curve near its resonance, with the same number of digits at any scale.
#[derive(Clone, Debug)]
pub struct Straightened {
    /// The measurement at the resonance.
    pub measurement: Measurement,
    level: Level,
    /// The relative error of integration.
    integration: f64,
}

impl Straightened {
    /// μ/η² at this η, measured from the resonance; `None` where the curve, with y > 0, does not
    /// exist or leaves the nodes.
    pub fn at(&self, eta: f64) -> Option<Estimate> {
        let mut share = 0.0;
        // η = s E(s) with s = y/`reach`; at the resonance a straight line.
        for _ in 0..ITERATIONS {
            let [_, slope, _, _] = self.level.quotients(share)[0];
            let next = eta / slope;
            if !(next > 0.0 && next <= 1.0) {
                return None;
            }
            if (next - share).abs() <= 4.0 * f64::EPSILON * next {
                let mut distance = self.level.distance(next);
                distance.error += self.integration * distance.value.abs();
                return Some(distance);
            }
            share = next;
        }
        None
    }
}

/// Largest number of fixed-point iterations for y: where more are needed the curve turns within the
/// nodes.
const ITERATIONS: u32 = 200;

/// η and μ as functions of y/`reach`.
#[derive(Clone, Debug)]
struct Level {
    reach: f64,
    eta: Interpolant,
    mu: Interpolant,
    /// The size of the errors in the coefficients of η and of μ.
    tails: [f64; 2],
}

impl Level {
    /// The factor by which the nodes have to come nearer for the tails to fall to rounding, at most
    /// a half.
    fn remedy(&self, rounding: [f64; 2]) -> f64 {
        let excess = (self.tails[0] / rounding[0]).max(self.tails[1] / rounding[1]);
        // The tail begins with lower powers than this, so the factor is not too small.
        libm::pow(excess, -1.0 / NODES as f64).clamp(LONGEST, 0.5)
    }

    /// Whether only rounding remains in the tails, as in those of a level that is farther away.
    fn settles(&self, farther: &Self) -> bool {
        let stays = |k: usize| self.tails[k] > FALLING * farther.tails[k];
        // η is a straight line at this level, or at most a parabola.
        stays(0) && stays(1) && self.tails[0] < 1e-3 * self.eta.size()
    }

    /// Values, slopes and so on of η and of μ at a share of the reach.
    fn quotients(&self, share: f64) -> [[f64; 4]; 2] {
        let [of_eta, of_mu] = self.degrees(self.tails);
        [self.eta.quotients(of_eta, share), self.mu.quotients(of_mu, share)]
    }

    fn degrees(&self, tails: [f64; 2]) -> [usize; 2] {
        [self.eta.degree(tails[0]).max(1), self.mu.degree(tails[1]).max(2)]
    }

    /// μ/η² at a share of the reach.
    fn distance(&self, share: f64) -> Estimate {
        let [[_, slope, ..], [_, _, curvature, _]] = self.quotients(share);
        // The weights in E and in M of the first coefficient that is neglected, larger than those
        // of the others: at the resonance, and by the polynomial's size elsewhere.
        let [of_eta, of_mu] = self.degrees(self.tails).map(|degree| (degree + 1) as f64);
        let of_slope = of_eta.min(2.0 / share) * self.tails[0];
        let of_curvature = (0.5 * of_mu * of_mu).min((2.0 + of_mu * share) / (share * share)) * self.tails[1];
        let (value, square) = (curvature / (slope * slope), slope * slope);
        Estimate { value, error: SAFETY * (2.0 * of_slope * (value / slope).abs() + of_curvature / square) }
    }

    fn measured(&self, tails: [f64; 2]) -> Measurement {
        let level = Self { tails, ..self.clone() };
        let [[_, e1, e2, _], [_, _, m2, m3]] = level.quotients(0.0);
        let (reach, square) = (self.reach, self.reach * self.reach);
        Measurement {
            coefficient: level.distance(0.0),
            eta: [e1 / reach, e2 / square],
            mu: [m2 / square, m3 / (square * reach)],
            velocity: reach,
        }
    }
}

/// A node in (−1, 1); indices run from right to left.
fn node(index: usize) -> f64 {
    libm::cos(PI * (index as f64 + 0.5) / NODES as f64)
}

/// An interpolant, as coefficients of Chebyshev polynomials.
#[derive(Clone, Debug)]
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

    /// The degree above which no coefficient exceeds the tail.
    fn degree(&self, tail: f64) -> usize {
        self.0.iter().rposition(|coefficient| coefficient.abs() > tail).unwrap_or(0)
    }

    /// The value f(x), and its successive quotients by x, once, twice and three times: (f(x) −
    /// f(0))/x is the first, and each of the others follows from the previous one in the same way.
    /// At zero these are the terms of the expansion about zero.
    ///
    /// No difference is taken: from T_(k+1) = 2x T_k − T_(k−1) follows the same recurrence for the
    /// quotients, with those of the previous order instead of x T_k.
    fn quotients(&self, degree: usize, x: f64) -> [f64; 4] {
        let (mut before, mut here) = ([0.0; 4], [1.0, 0.0, 0.0, 0.0]);
        let mut sum = [0.0; 4];
        for (k, coefficient) in self.0[..=degree].iter().enumerate() {
            for order in 0..4 {
                sum[order] += coefficient * here[order];
            }
            // T_1 is x alone.
            let twice = if k == 0 { 1.0 } else { 2.0 };
            let next = core::array::from_fn(|order| match order {
                0 => twice * x * here[0] - before[0],
                _ => twice * here[order - 1] - before[order],
            });
            (before, here) = (here, next);
        }
        sum
    }

    /// The largest coefficient.
    fn size(&self) -> f64 {
        self.0.iter().fold(0.0, |largest: f64, entry| largest.max(entry.abs()))
    }

    /// The largest of the last coefficients, and the value at zero, where the resonance is.
    fn tail(&self) -> f64 {
        let [at_zero, ..] = self.quotients(NODES - 1, 0.0);
        self.0[NODES - TAIL..].iter().fold(at_zero.abs(), |largest, entry| largest.max(entry.abs()))
    }
}
