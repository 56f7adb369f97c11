//! Period doublings, compared with the doubled orbits, and their limits at resonances.

use grazing_continuation::criticality::{changes, period_doubling};
use grazing_continuation::doubled::DoubledEquations;
use grazing_continuation::locate::{Condition, locate};
use grazing_continuation::mps::{EventTimes, Formulation, LoopEquations, Unknowns, unknown};
use grazing_model::ThirdOrder;

use super::specimens::{BY_EXTRAPOLATION, curves, extrapolated, spread};
use crate::specimens::{DUFFING, EPSILON, ZETA, assert_within, duffing, located, resonances};

/// The coefficient c from the stability of the doubled orbits.
///
/// The impacts of a doubled orbit are X(±s), 2qs apart up to terms of third order, so that their
/// velocities are 2 q_y s apart. With −s = λs + c s³ the derivative of g∘g there, (λ + 3cs²)² = 1 −
/// 4cs² + …, gives c from 1 − T + D, in which the other multiplier is the square of the MPS's.
/// Returns y² times the difference.
fn difference_from_doubled_orbits<O: ThirdOrder>(equations: &LoopEquations<O>, flip: &Unknowns) -> f64 {
    let normal_form = period_doubling(equations, flip).unwrap();
    let determinant = equations.solution(flip).multipliers.determinant;
    let doubled = DoubledEquations::new(equations);
    let measured = [32.0, 64.0].map(|part| {
        let s = flip[unknown::VELOCITY] / part;
        let orbit = doubled.near(flip, 2.0 * s * normal_form.direction[0]).unwrap();
        let multipliers = doubled.multipliers(&orbit).unwrap();
        let product = 1.0 - multipliers.trace + multipliers.determinant;
        0.25 * product / (1.0 - determinant * determinant) / (s * s)
    });
    let velocity = flip[unknown::VELOCITY];
    velocity * velocity * (extrapolated(measured) - normal_form.coefficient)
}

#[test]
fn coefficient_of_a_period_doubling_is_that_of_the_doubled_orbits() {
    for closed_form in resonances(ZETA, EPSILON, &[1, 2, 3], [0.35, 1.02]) {
        let resonance = located(&closed_form);
        let [_, flips] = curves(&resonance);
        for flip in spread(&flips, 7) {
            let difference = difference_from_doubled_orbits(resonance.equations(), &flip);
            assert_within(difference, 0.0, BY_EXTRAPOLATION);
        }
    }
}

#[test]
fn coefficient_is_that_of_the_doubled_orbits_of_a_duffing_oscillator_with_a_varying_reset_law() {
    for (loops, place) in DUFFING {
        let resonance = duffing(loops, place);
        let [_, flips] = curves(&resonance);
        for flip in spread(&flips, 5) {
            let difference = difference_from_doubled_orbits(resonance.equations(), &flip);
            assert_within(difference, 0.0, BY_EXTRAPOLATION);
        }
    }
}

#[test]
fn doubled_orbits_are_stable_to_one_side_of_a_change_of_criticality() {
    let mut found = Vec::new();
    for closed_form in resonances(ZETA, EPSILON, &[1, 2, 3], [0.35, 1.02]) {
        let resonance = located(&closed_form);
        let [_, flips] = curves(&resonance);
        let equations = resonance.equations().with_formulation(Formulation::FixedPhase);
        let doubled = DoubledEquations::new(&equations);
        for change in changes(resonance.equations(), &flips) {
            found.push([closed_form.loops(), closed_form.index()]);
            let beside = |offset: f64| {
                let conditions = [
                    Condition::PERIOD_DOUBLING,
                    Condition::Secondary(change.unknowns[unknown::SECONDARY] + offset),
                ];
                let start = &change.unknowns + Unknowns::new(0.0, 0.0, 0.0, offset);
                let flip = locate(&equations, conditions, start, &mut EventTimes::default()).unwrap();
                let orbit = doubled.near(&flip, 0.01 * flip[unknown::VELOCITY]).unwrap();
                let multipliers = doubled.multipliers(&orbit).unwrap();
                let stable = 1.0 - multipliers.trace + multipliers.determinant > 0.0;
                assert_eq!(period_doubling(&equations, &flip).unwrap().supercritical(), stable);
                stable
            };
            let way = change.unknowns[unknown::SECONDARY] - resonance.unknowns()[unknown::SECONDARY];
            assert_ne!(beside(0.02 * way).clone(), beside(-0.02 * way));
        }
    }
    // One curve joins the resonances n = 2 and n = 3 of one loop.
    found.sort_unstable();
    assert_eq!(found, [[1, 2], [1, 3], [1, 4], [2, 1]]);
}
