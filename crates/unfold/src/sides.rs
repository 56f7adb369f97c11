//! Whether the hybrid system, simulated from event to event, does on either side of a bifurcation curve what theory predicts.
//!
//! Close to the resonance two MPSs are taken at the η of a point of the curve, a slower and a faster one. With Υ± the impact
//! velocities on both curves at this η, 1 − T + D has the sign of s_p⁺ (Υ⁺ − y) and 1 + T + D that of s_p⁻ (y − Υ⁻)
//! (eq:Psi, eq:Upsilon1, eq:Upsilonp), which says which of the two is stable. Simulation starts at their impacts: both must return,
//! and the stable one alone must attract. Beyond the saddle-node no MPS is left, and motion must go elsewhere.

use grazing_continuation::locate::{Condition, LocateFailure, locate};
use grazing_continuation::mps::{Memory, Unknowns, unknown};
use grazing_continuation::resonance::ResonantGrazingPoint;
use grazing_model::ImpactOscillator;

use crate::diagram::Kind;
use crate::simulation::{Seen, Suspect};

/// What theory predicts of a slower and a faster MPS beside a bifurcation curve, and what the simulated hybrid system does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sides {
    /// Whether the slower and the faster MPS are stable, by the theorem.
    pub predicted: [bool; 2],
    /// What comes of their impacts.
    pub seen: [Seen; 2],
    /// Whether motion beside them comes nearer; `None` if this is undecided after many returns.
    pub attracts: [Option<bool>; 2],
    /// For the saddle-node: beyond the curve motion goes elsewhere.
    pub gone_beyond: Option<bool>,
}

impl Sides {
    /// Simulation lands on the predicted side.
    pub fn as_predicted(&self) -> bool {
        self.seen == [Seen::Returns; 2]
            && self.attracts == self.predicted.map(Some)
            && self.gone_beyond != Some(false)
    }
}

/// Impact velocity on the curve, so small that the leading terms decide (empirical, as for the fit of coefficients).
const VELOCITY: f64 = 0.01;
/// The two MPSs lie this share of the gap between both curves aside, and of the velocity itself.
const ASIDE: f64 = 0.4;

/// Simulates the hybrid system to both sides of the SN or PD curve close to its resonance.
///
/// # Errors
/// A point of the curve, or an MPS beside it, was not found.
pub fn simulate<O: ImpactOscillator>(
    point: &ResonantGrazingPoint<O>,
    kind: Kind,
) -> Result<Sides, LocateFailure> {
    let (own, other) = match kind {
        Kind::PeriodDoubling => (Condition::PERIOD_DOUBLING, Condition::SADDLE_NODE),
        _ => (Condition::SADDLE_NODE, Condition::PERIOD_DOUBLING),
    };
    let slope = |condition| {
        let direction = point.direction(condition);
        direction[unknown::VELOCITY] / direction[unknown::SECONDARY]
    };
    let ratio = slope(other) / slope(own);
    let equations = point.equations();
    let find = |conditions, near| locate(equations, conditions, near, &mut Memory::default());

    let direction = point.direction(own);
    let near = point.unknowns() + direction * (VELOCITY / direction[unknown::VELOCITY]);
    let middle = find([own, Condition::ImpactVelocity(VELOCITY)], near)?;
    let aside = ASIDE * (1.0 - ratio).abs().min(1.0);
    let branch = Condition::Secondary(middle[unknown::SECONDARY]);
    let beside = |share: f64| {
        let velocity = share * VELOCITY;
        let mut near = middle;
        near[unknown::VELOCITY] = velocity;
        find([branch, Condition::ImpactVelocity(velocity)], near)
    };
    let solutions = [beside(1.0 - aside)?, beside(1.0 + aside)?];

    let stability = point.resonant_point().stability_coefficients();
    let [saddle_node, period_doubling] = match kind {
        Kind::PeriodDoubling => [ratio * VELOCITY, VELOCITY],
        _ => [VELOCITY, ratio * VELOCITY],
    };
    let grazing = &point.resonant_point().grazing;
    let contracts =
        libm::pow(grazing.map.determinant(), f64::from(point.loops())) * grazing.phi * grazing.phi < 1.0;
    let predicted = solutions.map(|solution| {
        let velocity = solution[unknown::VELOCITY];
        contracts
            && stability.plus * (velocity - saddle_node) < 0.0
            && stability.minus * (velocity - period_doubling) > 0.0
    });

    let oscillators = solutions.map(|solution| equations.oscillator_at(&solution));
    let suspects = [0, 1].map(|k| suspect(&oscillators[k], point.loops(), &solutions[k]));
    let gone_beyond = (kind == Kind::SaddleNode).then(|| {
        let mut beyond = middle;
        // As far to the other side of the curve as the MPSs lie on theirs.
        beyond[unknown::PRIMARY] -= solutions[1][unknown::PRIMARY] - middle[unknown::PRIMARY];
        suspect(&equations.oscillator_at(&beyond), point.loops(), &beyond).attracts() == Some(false)
    });
    Ok(Sides {
        predicted,
        seen: suspects.each_ref().map(Suspect::follow),
        attracts: suspects.each_ref().map(Suspect::attracts),
        gone_beyond,
    })
}

fn suspect<'a, O: ImpactOscillator>(oscillator: &'a O, loops: u32, at: &Unknowns) -> Suspect<'a, O> {
    Suspect { oscillator, loops, velocity: at[unknown::VELOCITY], phase: at[unknown::PHASE] }
}
