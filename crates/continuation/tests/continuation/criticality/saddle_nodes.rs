//! Saddle-nodes against the branches that turn there, and the derivatives in the parameters against the curves.

use grazing_continuation::criticality::{period_doubling, saddle_node};
use grazing_continuation::locate::{Condition, locate};
use grazing_continuation::mps::{Formulation, LoopEquations, Memory, Unknowns, unknown};
use grazing_model::{ImpactOscillator, ThirdOrder};

use super::specimens::{BY_EXTRAPOLATION, at_velocity, curves, extrapolated, spread};
use crate::specimens::{DUFFING, EPSILON, ZETA, assert_within, duffing, located, resonances};

/// a from the branch of MPSs through a saddle-node.
///
/// At the impact velocities y ± q_y s the primary parameter is −(a/b) s² away, but for terms of third order, which cancel in
/// the sum of both, and of fourth. Returns the difference in proportion to a.
fn difference_from_branch<O: ThirdOrder>(equations: &LoopEquations<O>, fold: &Unknowns) -> f64 {
    let normal_form = saddle_node(equations, fold).unwrap();
    let (velocity, q_y) = (fold[unknown::VELOCITY], normal_form.direction[0]);
    let equations = equations.with_formulation(Formulation::FixedPhase);
    let measured = [32.0, 64.0].map(|part| {
        let dy = velocity / part;
        let moved = [dy, -dy].map(|dy| {
            let conditions =
                [Condition::Secondary(fold[unknown::SECONDARY]), Condition::ImpactVelocity(velocity + dy)];
            let found = locate(&equations, conditions, *fold, &mut Memory::default()).unwrap();
            found[unknown::PRIMARY] - fold[unknown::PRIMARY]
        });
        let s = dy / q_y;
        -0.5 * normal_form.parameter_slopes[0] * (moved[0] + moved[1]) / (s * s)
    });
    extrapolated(measured) / normal_form.coefficient - 1.0
}

#[test]
fn coefficient_of_a_saddle_node_is_the_curvature_of_the_branch() {
    for closed_form in resonances(ZETA, EPSILON, &[1, 2, 3], [0.35, 1.02]) {
        let resonance = located(&closed_form);
        let [folds, _] = curves(&resonance);
        for fold in spread(&folds, 5) {
            let difference = difference_from_branch(resonance.equations(), &fold);
            assert_within(difference, 0.0, BY_EXTRAPOLATION);
        }
    }
    for (loops, place) in DUFFING {
        let resonance = duffing(loops, place);
        let [folds, _] = curves(&resonance);
        for fold in spread(&folds, 5) {
            let difference = difference_from_branch(resonance.equations(), &fold);
            assert_within(difference, 0.0, BY_EXTRAPOLATION);
        }
    }
}

/// The slope dμ/dη of a curve at a point, by central differences.
fn slope<O: ImpactOscillator>(equations: &LoopEquations<O>, condition: Condition, point: &Unknowns) -> f64 {
    let equations = equations.with_formulation(Formulation::FixedPhase);
    // Curves bend within parameter changes of the order of y.
    let h = 1e-4 * point[unknown::VELOCITY];
    let primary = |eta: f64| {
        let conditions = [condition, Condition::Secondary(eta)];
        locate(&equations, conditions, *point, &mut Memory::default()).unwrap()[unknown::PRIMARY]
    };
    let eta = point[unknown::SECONDARY];
    (primary(eta + h) - primary(eta - h)) / (2.0 * h)
}

#[test]
fn parameter_slopes_vanish_along_the_curves() {
    let resonance = duffing(DUFFING[0].0, DUFFING[0].1);
    for y in [0.02, 0.05, 0.1] {
        let fold = at_velocity(&resonance, Condition::SADDLE_NODE, y);
        let flip = at_velocity(&resonance, Condition::PERIOD_DOUBLING, y);
        let equations = resonance.equations();
        for (slopes, slope) in [
            (
                saddle_node(equations, &fold).unwrap().parameter_slopes,
                slope(equations, Condition::SADDLE_NODE, &fold),
            ),
            (
                period_doubling(equations, &flip).unwrap().multiplier_slopes,
                slope(equations, Condition::PERIOD_DOUBLING, &flip),
            ),
        ] {
            // Differences with h = 10⁻⁴ y: (h/y)² times some hundred, and rounding of μ, 10⁻¹⁴/h.
            assert_within(slopes[0] * slope + slopes[1], 0.0, 1e-5 * slopes.norm());
        }
    }
}
