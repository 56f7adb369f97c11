//! Period doublings against the doubled orbits, and towards resonances.

use grazing_continuation::criticality::{codimension_two::generalised_period_doublings, period_doubling};
use grazing_continuation::mps::{LoopEquations, Unknowns, unknown};
use grazing_model::ThirdOrder;

use super::doubled::doubled;
use super::specimens::{BY_EXTRAPOLATION, curves, extrapolated, spread};
use crate::specimens::{DUFFING, EPSILON, ZETA, assert_within, duffing, located, resonances};

/// c from the doubled orbits, twice: from the parameter at which they are, and from their stability.
///
/// The impacts of a doubled orbit are X(±s), 2qs apart but for terms of third order. With λ = −1 + λ'δ, −s = λs + c s³ gives
/// δ = −c s²/λ', and the derivative of g∘g there, (λ + 3cs²)² = 1 − 4cs² + …, makes c from 1 − T + D, in which the other
/// multiplier is the square of the MPS's. Returns y² times the greatest difference.
fn difference_from_doubled_orbits<O: ThirdOrder>(equations: &LoopEquations<O>, flip: &Unknowns) -> f64 {
    let normal_form = period_doubling(equations, flip).unwrap();
    let determinant = equations.solution(flip).0.multipliers.determinant;
    let measured = [32.0, 64.0].map(|part| {
        let s = flip[unknown::VELOCITY] / part;
        let orbit = doubled(equations, flip, normal_form.direction, s).unwrap();
        let moved = orbit.impacts[0][unknown::PRIMARY] - flip[unknown::PRIMARY];
        let product = 1.0 - orbit.multipliers.trace + orbit.multipliers.determinant;
        let slope = normal_form.multiplier_slopes[0];
        [-slope * moved, 0.25 * product / (1.0 - determinant * determinant)].map(|value| value / (s * s))
    });
    let velocity = flip[unknown::VELOCITY];
    let differences = [0, 1].map(|i| extrapolated(measured.map(|m| m[i])) - normal_form.coefficient);
    velocity * velocity * differences[0].abs().max(differences[1].abs())
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
fn criticality_changes_where_two_ways_along_one_curve_say_that_it_does() {
    let mut found = Vec::new();
    for closed_form in resonances(ZETA, EPSILON, &[1, 2, 3], [0.35, 1.02]) {
        let resonance = located(&closed_form);
        let [_, flips] = curves(&resonance);
        for point in generalised_period_doublings(resonance.equations(), &flips.points) {
            let point = point.unwrap();
            let flip = point.unknowns;
            let y = flip[unknown::VELOCITY];
            // To rounding of c, whose terms are of the order of y⁻².
            assert_within(y * y * point.normal_form.coefficient, 0.0, 1e-11);
            let ends = [point.index - 1, point.index].map(|k| {
                let end = flips.points[k].solution.unknowns;
                period_doubling(resonance.equations(), &end).unwrap().supercritical()
            });
            assert_ne!(ends[0], ends[1]);
            // Doubled orbits are then at the parameters of the MPS to higher order.
            let difference = difference_from_doubled_orbits(resonance.equations(), &flip);
            assert_within(difference, 0.0, BY_EXTRAPOLATION);
            found.push((closed_form.loops(), closed_form.index(), flip));
        }
    }
    let names: Vec<(u32, u32)> = found.iter().map(|(loops, index, _)| (*loops, *index)).collect();
    assert_eq!(names, [(1, 4), (1, 3), (2, 1), (1, 2)]);
    // The curve from the resonance with n = 3 is that from the one with n = 2.
    assert_within((found[1].2 - found[3].2).amax(), 0.0, 1e-9);
}
