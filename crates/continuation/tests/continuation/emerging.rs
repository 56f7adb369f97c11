//! Curves of solutions with more loops that leave a one-loop resonance: the directions in which
//! they leave, by theory, and their ends.

use grazing_continuation::curve::{Curve, CurveEnd, CurvePoint};
use grazing_continuation::locate::{Condition, locate, same_point};
use grazing_continuation::mps::{Formulation, LoopEquations, unknown};
use grazing_continuation::resonance::LocatedResonance;
use grazing_model::ImpactOscillator;
use grazing_theorems::iterated::{EndEvent, VelocityBound};

use crate::specimens::{DUFFING, EPSILON, ZETA, duffing, located, resonances, route};

/// The curves of solutions with `loops` loops, each with its bound by theory.
fn curves<O: ImpactOscillator>(
    resonance: &LocatedResonance<O>,
    loops: u32,
) -> Vec<(VelocityBound, LoopEquations<O>, Curve)> {
    let window = route([0.0, 1.3], [0.3, 1.02], true);
    let (curves, missing) = resonance.unfold_iterated(loops, &window);
    assert!(missing.is_empty(), "{missing:?}");
    let emerging = resonance.iterated(loops).expect("it is one of one loop").emerging();
    let bounds: Vec<VelocityBound> = emerging
        .iter()
        .flat_map(|solutions| [Some(solutions.slowest), solutions.fastest])
        .flatten()
        .collect();
    assert_eq!(bounds.len(), curves.len());
    let oscillator = resonance.orbit().oscillator().clone();
    let equations = LoopEquations::new(oscillator, loops, Formulation::FixedPhase);
    bounds.into_iter().zip(curves).map(|(bound, curve)| (bound, equations.clone(), curve)).collect()
}

/// The difference between the ratio of impact velocity to η on a curve, at this distance in η from
/// the resonance, and the limit of that ratio by theory.
fn deviation<O: ImpactOscillator>(
    resonance: &LocatedResonance<O>,
    (bound, equations, curve): &(VelocityBound, LoopEquations<O>, Curve),
    eta: f64,
) -> f64 {
    let secondary = resonance.unknowns()[unknown::SECONDARY] + eta;
    let beyond = |point: &CurvePoint| point.solution.parameters()[1] - secondary;
    let pair = curve.points.windows(2).find(|pair| beyond(&pair[0]) * beyond(&pair[1]) <= 0.0);
    let pair = pair.expect("the curve passes this eta");
    let way = beyond(&pair[0]) / (beyond(&pair[0]) - beyond(&pair[1]));
    let [a, b] = [0, 1].map(|k| pair[k].solution.unknowns.clone());
    let conditions = [curve.condition, Condition::Secondary(secondary)];
    let found = locate(equations, conditions, &a + (b - &a) * way, &mut pair[0].times.clone()).unwrap();
    found[unknown::VELOCITY] / (eta * bound.velocity_slope) - 1.0
}

fn assert_leaves_as_theory_has_it<O: ImpactOscillator>(resonance: &LocatedResonance<O>, loops: u32) -> usize {
    let all = curves(resonance, loops);
    for curve in &all {
        // The relative error is of first order in η, up to terms of second order.
        let slope = curve.0.velocity_slope;
        let etas = curve.2.points.iter().map(|point| point.solution.parameters()[1]);
        let reach =
            etas.map(|eta| (eta - resonance.unknowns()[unknown::SECONDARY]).abs()).fold(0.0, f64::max);
        let far = (4e-3 / slope.abs()).min(0.2 * reach).copysign(slope);
        let [far, near] = [far, 0.5 * far].map(|eta| deviation(resonance, curve, eta));
        assert!(far.abs() < 0.2 && near.abs() < 0.7 * far.abs() + 1e-4, "{:?}: {far} {near}", curve.0);
        // GZ curves are followed in both directions and end in the resonance; others begin there.
        let at_resonance = match curve.0.boundary {
            EndEvent::Visit(_) => {
                assert!(matches!(curve.2.end, CurveEnd::Grazing), "{:?}", curve.2.end);
                curve.2.points.last()
            }
            _ => curve.2.points.first(),
        };
        assert!(same_point(&at_resonance.unwrap().solution.unknowns, &resonance.unknowns()));
    }
    all.len()
}

#[test]
fn curves_of_two_loops_leave_one_loop_resonances_as_theory_has_it() {
    for closed_form in resonances(ZETA, EPSILON, &[1], [0.3, 1.02]) {
        assert_eq!(assert_leaves_as_theory_has_it(&located(&closed_form), 2), 2);
    }
    // Everything is nonlinear here, and impacts take time.
    let (loops, place) = DUFFING[0];
    assert_eq!(assert_leaves_as_theory_has_it(&duffing(loops, place), 2), 2);
}

#[test]
fn curves_of_three_loops_leave_one_loop_resonances_where_motion_is_damped() {
    let found = resonances(0.17, 0.5, &[1], [0.3, 1.02]);
    let counts = found.iter().map(|closed_form| assert_leaves_as_theory_has_it(&located(closed_form), 3));
    assert!(counts.sum::<usize>() >= 2);
}

#[test]
fn slivers_of_two_loops_end_where_saddle_node_and_grazing_meet() {
    // Found by an independent program, for n = 5 and 3.
    let ends = [(5, 0.406456), (3, 0.675530)];
    for closed_form in resonances(ZETA, EPSILON, &[1], [0.3, 1.02]) {
        let Some((_, omega)) = ends.iter().find(|(n, _)| *n == closed_form.index()) else { continue };
        let (_, _, saddle_node) = curves(&located(&closed_form), 2).swap_remove(0);
        let CurveEnd::Event(event) = &saddle_node.end else { panic!("{:?}", saddle_node.end) };
        assert_eq!(event.condition, Condition::InteriorGrazing);
        assert!((event.solution.parameters()[1] - omega).abs() < 1e-6);
        // Every solution on the way is admissible over the whole orbit.
        assert!(saddle_node.points.iter().skip(1).all(|point| point.solution.admissible()));
    }
}
