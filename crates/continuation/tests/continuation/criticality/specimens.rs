//! Resonances and bifurcations for tests of normal forms, and functions that measure them.

use grazing_continuation::curve::Curve;
use grazing_continuation::locate::{Condition, locate};
use grazing_continuation::mps::{EventTimes, Formulation, Unknowns, unknown};
use grazing_continuation::resonance::ResonantGrazingPoint;
use grazing_model::{ImpactOscillator, LinearOscillator};

use crate::specimens::{EPSILON, ZETA, located, resonances, route};

/// The located resonance with one loop and an index.
pub(super) fn one_loop(index: u32) -> ResonantGrazingPoint<LinearOscillator> {
    let all = resonances(ZETA, EPSILON, &[1], [0.35, 1.02]);
    located(all.iter().find(|resonance| resonance.index() == index).unwrap())
}

/// The SN and PD curves of a resonance.
pub(super) fn curves<O: ImpactOscillator>(resonance: &ResonantGrazingPoint<O>) -> [Curve; 2] {
    let unfolded = resonance.unfold(&route([0.0, 1.3], [0.35, 1.02], true)).unwrap();
    [unfolded.saddle_node, unfolded.period_doubling]
}

/// Points of a curve away from y = 0, evenly spread over its length.
pub(super) fn spread(curve: &Curve, count: usize) -> Vec<Unknowns> {
    let all: Vec<Unknowns> = curve.points.iter().map(|point| point.solution.unknowns.clone()).collect();
    let away: Vec<Unknowns> = all.into_iter().filter(|point| point[unknown::VELOCITY] > 3e-2).collect();
    (0..count).map(|k| away[k * (away.len() - 1) / (count - 1)].clone()).collect()
}

/// The point of a resonance's curve with the impact velocity y.
pub(super) fn at_velocity<O: ImpactOscillator>(
    resonance: &ResonantGrazingPoint<O>,
    condition: Condition,
    y: f64,
) -> Unknowns {
    let direction = resonance.direction(condition);
    let start = resonance.unknowns() + &direction * (y / direction[0]);
    let equations = resonance.equations().with_formulation(Formulation::FixedPhase);
    let conditions = [condition, Condition::ImpactVelocity(y)];
    locate(&equations, conditions, start, &mut EventTimes::default()).unwrap()
}

/// An even function of s without its term of second order, from values at two sizes one of which is
/// half the other.
pub(super) fn extrapolated([coarse, fine]: [f64; 2]) -> f64 {
    (4.0 * fine - coarse) / 3.0
}

/// Tolerance after extrapolation: the remainder is of fourth order in s/y = 1/32. Rounding is 10⁻¹⁴
/// (y/s)²/y or so, for impact velocities of 0.03 and more. Values of y² c are 10⁻³ and more, except
/// next to a change of sign.
pub(super) const BY_EXTRAPOLATION: f64 = 1e-6;
