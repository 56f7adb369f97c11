//! Invariance of normal forms, and points without one.

use core::f64::consts::TAU;

use grazing_continuation::criticality::{CriticalityError, period_doubling};
use grazing_continuation::locate::{Condition, locate};
use grazing_continuation::mps::{EventTimes, Formulation, LoopEquations, Unknowns, unknown};
use grazing_model::smooth::Integrated;
use grazing_model::{ImpactOscillator, LinearOscillator};
use nalgebra::Vector2;

use super::specimens::{at_velocity, one_loop};
use crate::specimens::{DUFFING, EPSILON, Spring, ZETA, assert_close, assert_within, duffing};

#[test]
fn another_unit_of_length_changes_coefficients_as_it_must() {
    let length = 2.5;
    for (loops, place) in DUFFING {
        let resonance = duffing(loops, place);
        let other = Integrated::new(Spring { length, ..Spring::DUFFING }, [place[1], place[2]]);
        let other = LoopEquations::new(other, loops, Formulation::FixedPhase);
        let moved = |point: &Unknowns| {
            let mut point = point.clone();
            point[unknown::VELOCITY] /= length;
            point
        };
        // The length in one oscillator of a unit vector of the other.
        let stretch = |q: Vector2<f64>| Vector2::new(length * q[0], q[1]).norm();
        for y in [0.02, 0.1] {
            let flip = at_velocity(&resonance, Condition::PERIOD_DOUBLING, y);
            let ours = period_doubling(resonance.equations(), &flip).unwrap();
            let theirs = period_doubling(&other, &moved(&flip)).unwrap();
            let factor = stretch(theirs.direction);
            // Both are integrated to 10⁻¹² or so, divided by y² at most.
            assert_close(theirs.coefficient, ours.coefficient * factor * factor, 1e-7);
            assert_eq!(theirs.supercritical(), ours.supercritical());
        }
    }
}

#[test]
fn integrated_and_closed_form_have_the_same_normal_forms() {
    let closed = one_loop(3);
    let integrated = LoopEquations::new(
        Integrated::new(Spring::LINEAR, closed.orbit().oscillator().parameters()),
        1,
        Formulation::FixedPhase,
    );
    for y in [0.01, 0.1, 0.3] {
        let flip = at_velocity(&closed, Condition::PERIOD_DOUBLING, y);
        let [a, b] = [period_doubling(closed.equations(), &flip), period_doubling(&integrated, &flip)];
        // Derivatives agree to 10⁻¹², and are divided by y² at most.
        assert_close(b.unwrap().coefficient, a.unwrap().coefficient, 1e-8);
    }
}

#[test]
fn points_that_are_no_simple_bifurcation_have_no_normal_form() {
    let resonance = one_loop(3);
    let equations = resonance.equations();
    assert_eq!(period_doubling(equations, &resonance.unknowns()), Err(CriticalityError::Grazing));

    let flip = at_velocity(&resonance, Condition::PERIOD_DOUBLING, 0.1);
    let off = &flip + Unknowns::new(0.0, 0.01, 0.0, 0.0);
    let Err(CriticalityError::NotPeriodic { distance }) = period_doubling(equations, &off) else {
        panic!("a point that is no MPS has a normal form");
    };
    assert!(distance > 1e-4);

    let fold = at_velocity(&resonance, Condition::SADDLE_NODE, 0.1);
    let Err(CriticalityError::NotABifurcation { distance }) = period_doubling(equations, &fold) else {
        panic!("a saddle-node is taken for a period doubling");
    };
    // With the multipliers 1 and D, 1 + T + D is 2 (1 + D), and the multiplier 1 is no nearer.
    let determinant = equations.solution(&fold).multipliers.determinant;
    assert_within(distance, 2.0 * (1.0 + determinant) / (1.0 - determinant), 1e-6);

    // With a restitution that compensates the loss of energy, D = 1, both multipliers are −1 there.
    let omega = flip[unknown::SECONDARY];
    let elastic = libm::exp(TAU * ZETA / omega);
    let mut point = flip;
    for k in 1..=20 {
        let epsilon = EPSILON + (elastic - EPSILON) * f64::from(k) / 20.0;
        let oscillator = LinearOscillator::new(ZETA, epsilon, point[unknown::PRIMARY], omega).unwrap();
        let equations = LoopEquations::new(oscillator, 1, Formulation::FixedPhase);
        let conditions = [Condition::PERIOD_DOUBLING, Condition::Secondary(omega)];
        point = locate(&equations, conditions, point, &mut EventTimes::default()).unwrap();
        let outcome = period_doubling(&equations, &point);
        let degenerate = matches!(outcome, Err(CriticalityError::Degenerate { .. }));
        assert_eq!(degenerate, k == 20, "{outcome:?}");
    }
}
