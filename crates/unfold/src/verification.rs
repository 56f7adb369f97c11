//! A comparison of the hybrid system, simulated from event to event, with theory on either side of
//! a bifurcation curve.
//!
//! Close to the resonance two MPSs are taken at the η of a point of the curve, a slower and a
//! faster one. With Υ± the impact velocities on both curves at this η, 1 − T + D has the sign of
//! s_p⁺ (Υ⁺ − y) and 1 + T + D that of s_p⁻ (y − Υ⁻) (eq:Psi, eq:Upsilon1, eq:Upsilonp), which
//! decides which of the two is stable. Simulation starts at their impacts: both must return, and
//! only the stable one must attract. Beyond the saddle-node no MPS is left, and motion must go
//! elsewhere.
//!
//! All this is to leading order. The distance along the curve up to which the leading terms decide
//! follows from the expansions that were measured there.

use core::fmt;

use grazing_continuation::bifurcation::{Bifurcation, Pair};
use grazing_continuation::fit::Measurement;
use grazing_continuation::locate::{Condition, LocateFailure, locate};
use grazing_continuation::mps::{EventTimes, unknown};
use grazing_continuation::resonance::ResonantGrazingPoint;
use grazing_results::{Dimension, Dimensioned};

use crate::simulation::{MOST_RETURNS, ReturnOutcome, Suspect};
use crate::verdict::Coefficient;

/// The prediction for a slower and a faster MPS beside a bifurcation curve, and the result of
/// simulating the hybrid system.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sides {
    /// Impact velocity on the curve.
    pub velocity: f64,
    /// Whether the slower and the faster MPS are stable, by the theorem.
    pub predicted: [bool; 2],
    /// The outcomes of simulation from their impacts.
    pub seen: [ReturnOutcome; 2],
    /// Whether motion beside them approaches them; `None` if this is undecided after many returns.
    pub attracts: [Option<bool>; 2],
    /// Whether motion beyond a saddle-node goes elsewhere, `None` if this is undecided; true for
    /// other curves.
    pub gone_beyond: Option<bool>,
}

/// The result of simulating on both sides of a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Simulated {
    /// Motion does what the theorem predicts.
    AsPredicted(Sides),
    /// Motion contradicts the theorem at all velocities that were tried, of which this one is the
    /// smallest.
    Against(Sides),
    /// The simulation is inconclusive.
    Undecided(Inconclusive),
}

impl Dimensioned for Simulated {
    fn each_number(&mut self, visit: &mut dyn FnMut(Dimension, &mut f64)) {
        let mut seen = |velocity: &mut f64| visit(Dimension::of("length/time"), velocity);
        match self {
            Self::AsPredicted(sides) | Self::Against(sides) => seen(&mut sides.velocity),
            Self::Undecided(doubt) => match doubt {
                Inconclusive::TooSlow { leading, least } => [leading, least].into_iter().for_each(seen),
                Inconclusive::NoSolution { velocity, .. }
                | Inconclusive::SlowConvergence { velocity, .. }
                | Inconclusive::OtherStop { velocity }
                | Inconclusive::OnlyHere { velocity } => seen(velocity),
                Inconclusive::NotMeasured => {}
            },
        }
    }
}

/// The reason why simulation is inconclusive.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum Inconclusive {
    /// Where the leading terms decide, impacts are too slow to be distinguished from rounding.
    #[error(
        "the leading terms are decisive only up to impact velocity {leading:.0e}, but simulation is possible only from {least:.0e} on"
    )]
    TooSlow {
        /// The impact velocity up to which the leading terms decide.
        leading: f64,
        /// The least impact velocity that is simulated.
        least: f64,
    },
    /// The curve was not measured, so that the range of the leading terms is unknown.
    #[error("the curves were not measured, so that it is unknown how far the leading terms decide")]
    NotMeasured,
    /// No MPS was found beside the curve.
    #[error("no solution was found beside the curve at impact velocity {velocity:.0e}: {failure}")]
    NoSolution {
        /// The impact velocity on the curve.
        velocity: f64,
        /// The reason why it was not found.
        failure: LocateFailure,
    },
    /// Motion beside an MPS neither approaches it nor gets away.
    #[error(
        "slow convergence: at impact velocity {velocity:.0e} motion neither approaches nor leaves the solution in {returns} returns"
    )]
    SlowConvergence {
        /// The impact velocity on the curve.
        velocity: f64,
        /// The number of returns.
        returns: usize,
    },
    /// An MPS hits the other of two stops, of which the theorem knows nothing.
    #[error(
        "at impact velocity {velocity:.0e} a solution hits the other wall, of which the theorem knows nothing"
    )]
    OtherStop {
        /// The impact velocity on the curve.
        velocity: f64,
    },
    /// Motion is not as predicted, but it could not be simulated at enough smaller velocities to
    /// conclude that it never is.
    #[error(
        "not as predicted at impact velocity {velocity:.0e}, but closer to the resonance too few simulations are possible"
    )]
    OnlyHere {
        /// The impact velocity on the curve.
        velocity: f64,
    },
}

impl Simulated {
    /// Whether motion is as predicted, in one word.
    pub const fn name(&self) -> &'static str {
        match self {
            Self::AsPredicted(_) => "yes",
            Self::Against(_) => "no",
            Self::Undecided(_) => "undecided",
        }
    }

    /// The reason why motion is not as predicted or why that is undecided, in words; empty if it
    /// is.
    pub fn reason(&self) -> String {
        match self {
            Self::AsPredicted(_) => String::new(),
            Self::Against(sides) => sides.to_string(),
            Self::Undecided(doubt) => doubt.to_string(),
        }
    }
}

/// The largest and the least impact velocity that is simulated, in units of γ/ω, the scale of
/// motion at the wall (empirical): positions are known to some 10⁻¹⁵, velocities therefore to 10⁻¹⁵
/// over the velocity itself, and the displacements that are followed, down to some 10⁻⁵ of it, must
/// be larger.
const LARGEST: f64 = 0.02;
const LEAST: f64 = 2e-5;
/// Largest ratio of the terms of next order to the leading ones.
const SHARE: f64 = 0.2;
/// Displacement of the two MPSs, as a fraction of the gap between both curves, and of the velocity
/// itself.
const ASIDE: f64 = 0.4;
/// Number of velocities that are tried, each a quarter of the previous one: theory describes a
/// limit, and motion contradicts it only if it does so at all of them.
const VELOCITIES: usize = 3;

/// Simulates the hybrid system on both sides of the SN or PD curve close to its resonance, where
/// `coefficients` were measured.
pub fn simulate(
    point: &ResonantGrazingPoint,
    kind: Bifurcation,
    coefficients: &Pair<Coefficient>,
) -> Simulated {
    let measured = coefficients.as_ref().map(|coefficient| &coefficient.fit).starting_with(kind);
    let [Ok(own), Ok(other)] = measured else { return Simulated::Undecided(Inconclusive::NotMeasured) };
    let grazing = &point.resonant_point().grazing;
    let scale = grazing.gamma / grazing.forcing_frequency;
    let (leading, least) = (leading(own, other), LEAST * scale);
    let largest = leading.min(LARGEST * scale);
    if largest.is_nan() || largest < least {
        return Simulated::Undecided(Inconclusive::TooSlow { leading, least });
    }
    let (mut doubt, mut against, mut velocity) = (Inconclusive::NotMeasured, 0, largest);
    for _ in 0..VELOCITIES {
        if velocity < least {
            break;
        }
        match Sides::at(point, kind, velocity) {
            Ok(sides) => match sides.as_predicted() {
                Some(true) => return Simulated::AsPredicted(sides),
                None if sides.hits_the_other_stop() => doubt = Inconclusive::OtherStop { velocity },
                Some(false) => {
                    against += 1;
                    if against == VELOCITIES {
                        return Simulated::Against(sides);
                    }
                    doubt = Inconclusive::OnlyHere { velocity };
                }
                None => doubt = Inconclusive::SlowConvergence { velocity, returns: MOST_RETURNS },
            },
            Err(failure) => doubt = Inconclusive::NoSolution { velocity, failure },
        }
        velocity *= 0.25;
    }
    Simulated::Undecided(doubt)
}

/// The impact velocity up to which the terms of next order are small: in η along the curve itself,
/// compared with the displacement; in η along the other curve, compared with the gap between both;
/// in μ.
fn leading(own: &Measurement, other: &Measurement) -> f64 {
    let gap = (other.eta[0] - own.eta[0]).abs();
    let aside = ASIDE * gap.min(own.eta[0].abs());
    let limits = [aside / own.eta[1].abs(), gap / other.eta[1].abs(), (own.mu[0] / own.mu[1]).abs()];
    SHARE * limits.into_iter().fold(f64::INFINITY, f64::min)
}

/// The observed behaviour where it differs from the prediction.
impl fmt::Display for Sides {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut differences = Vec::new();
        for (k, which) in ["slower", "faster"].into_iter().enumerate() {
            let predicted = if self.predicted[k] { "stable" } else { "unstable" };
            match (self.seen[k], self.attracts[k]) {
                (ReturnOutcome::Returns, Some(seen)) if seen != self.predicted[k] => {
                    let verb = if seen { "attracts" } else { "repels" };
                    differences
                        .push(format!("the {which} solution is predicted to be {predicted} but {verb}"));
                }
                (ReturnOutcome::Returns, _) => {}
                (ReturnOutcome::NoImpact, _) => {
                    differences.push(format!("the {which} solution has no impact"))
                }
                (ReturnOutcome::MeetsTheWall, _) => {
                    differences.push(format!("the {which} solution hits the wall too early"))
                }
                (ReturnOutcome::HitsTheOtherStop, _) => {
                    differences.push(format!("the {which} solution hits the other wall"))
                }
                (ReturnOutcome::GoesElsewhere, _) => {
                    differences.push(format!("the {which} solution does not return"))
                }
            }
        }
        if self.gone_beyond == Some(false) {
            differences.push("motion stays although no solution remains".to_owned());
        }
        write!(formatter, "at impact velocity {:.0e} {}", self.velocity, differences.join(", "))
    }
}

impl Sides {
    /// Whether one of the MPSs hits the other of two stops.
    fn hits_the_other_stop(&self) -> bool {
        self.seen.contains(&ReturnOutcome::HitsTheOtherStop)
    }

    /// Whether simulation agrees with the prediction; `None` if that is undecided, also where the other of two
    /// stops is hit.
    pub fn as_predicted(&self) -> Option<bool> {
        if self.hits_the_other_stop() {
            return None;
        }
        let against = |(predicted, seen): (&bool, &Option<bool>)| seen.is_some_and(|seen| seen != *predicted);
        if self.seen != [ReturnOutcome::Returns; 2]
            || self.predicted.iter().zip(&self.attracts).any(against)
            || self.gone_beyond == Some(false)
        {
            return Some(false);
        }
        (!self.attracts.contains(&None) && self.gone_beyond.is_some()).then_some(true)
    }

    /// Simulates on both sides of the point of the curve with this impact velocity.
    fn at(point: &ResonantGrazingPoint, kind: Bifurcation, velocity: f64) -> Result<Self, LocateFailure> {
        let [own, other] = Pair::CONDITIONS.starting_with(kind);
        let slope = |condition| {
            let direction = point.direction(condition);
            direction[unknown::VELOCITY] / direction[unknown::SECONDARY]
        };
        let ratio = slope(other) / slope(own);
        let equations = point.equations();
        let find = |conditions, near| locate(equations, conditions, near, &mut EventTimes::default());

        let direction = point.direction(own);
        let near = point.unknowns() + &direction * (velocity / direction[unknown::VELOCITY]);
        let middle = find([own, Condition::ImpactVelocity(velocity)], near)?;
        let aside = ASIDE * (1.0 - ratio).abs().min(1.0);
        let branch = Condition::Secondary(middle[unknown::SECONDARY]);
        let beside = |share: f64| {
            let mut near = middle.clone();
            near[unknown::VELOCITY] = share * velocity;
            find([branch, Condition::ImpactVelocity(share * velocity)], near)
        };
        let solutions = [beside(1.0 - aside)?, beside(1.0 + aside)?];

        let stability = point.resonant_point().stability_coefficients();
        let [saddle_node, period_doubling] = match kind {
            Bifurcation::PeriodDoubling => [ratio * velocity, velocity],
            _ => [velocity, ratio * velocity],
        };
        let grazing = &point.resonant_point().grazing;
        let contracts =
            libm::pow(grazing.map.determinant(), f64::from(point.loops())) * grazing.phi * grazing.phi < 1.0;
        let predicted = solutions.each_ref().map(|solution| {
            let velocity = solution[unknown::VELOCITY];
            contracts
                && stability.plus * (velocity - saddle_node) < 0.0
                && stability.minus * (velocity - period_doubling) > 0.0
        });

        let oscillators = solutions.each_ref().map(|solution| equations.oscillator_at(solution));
        let suspects = [0, 1].map(|k| Suspect::of(&oscillators[k], point.loops(), &solutions[k]));
        let gone_beyond = if kind == Bifurcation::SaddleNode {
            let mut beyond = middle.clone();
            // As far on the other side of the curve as the MPSs lie on theirs.
            beyond[unknown::PRIMARY] -= solutions[1][unknown::PRIMARY] - middle[unknown::PRIMARY];
            Suspect::of(&equations.oscillator_at(&beyond), point.loops(), &beyond).leaves()
        } else {
            Some(true)
        };
        Ok(Self {
            velocity,
            predicted,
            seen: suspects.each_ref().map(Suspect::follow),
            attracts: suspects.each_ref().map(Suspect::attracts),
            gone_beyond,
        })
    }
}
