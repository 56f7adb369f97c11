//! One-parameter branches: through grazing, through folds, with their events, and the ends of
//! VIVID.

use grazing_continuation::arclength::StepControl;
use grazing_continuation::curve::{Curve, CurveEnd, CurvePoint, Event, Route, SolutionCurve};
use grazing_continuation::locate::{Condition, locate};
use grazing_continuation::mps::{EventTimes, Formulation, LoopEquations, Unknowns, unknown};
use grazing_model::LinearOscillator;

use crate::hybrid::{assert_returns, assert_returns_unhindered, impacts_early, simulated_multipliers};
use crate::specimens::{EPSILON, OMEGA, ZETA, assert_vanishes, assert_within, at_grazing, branch, route};

fn amplitude_branch(loops: u32, amplitudes: [f64; 2]) -> (LoopEquations<LinearOscillator>, Curve) {
    let route = route(amplitudes, [0.1, 2.0], false);
    branch([ZETA, EPSILON, OMEGA], loops, Formulation::Vivid, 1.0, &route)
}

#[test]
fn branches_cross_the_grazing_bifurcation_smoothly() {
    for loops in 1..=5 {
        let (grazing, oscillator) = at_grazing(ZETA, EPSILON, OMEGA);
        let equations = LoopEquations::new(oscillator, loops, Formulation::Vivid);
        let at = |y: f64| {
            let start = Unknowns::new(y, grazing.phase(), grazing.amplitude(), OMEGA);
            let conditions = [Condition::ImpactVelocity(y), Condition::Secondary(OMEGA)];
            locate(&equations, conditions, start, &mut EventTimes::default()).ok()
        };
        // The third difference across y = 0 of a smooth curve is of third order. If 𝒜(y) or z(y)
        // were only once differentiable at y = 0, with a term y|y|, it would be of second order.
        for coordinate in [1, 2] {
            assert_vanishes(3.0, 1e-14, |size| {
                let [a, b, c, d] =
                    [at(-3.0 * size)?, at(-size)?, at(size)?, at(3.0 * size)?].map(|point| point[coordinate]);
                Some(d - 3.0 * c + 3.0 * b - a)
            });
        }
    }
}

#[test]
fn branches_that_come_back_to_grazing_end_on_the_grazing_orbit() {
    for loops in 1..=3 {
        let (equations, real) = amplitude_branch(loops, [0.2, 0.4]);
        let CurvePoint { solution, times } = &real.points[8];
        let down = Unknowns::new(-1.0, 0.0, 0.0, 0.0);
        let back = SolutionCurve { equations, condition: Condition::Secondary(OMEGA) };
        let route = route([0.2, 0.4], [0.1, 2.0], false);
        let curve = back.follow(solution.unknowns.clone(), down, times.clone(), &route).unwrap();
        assert!(matches!(curve.end, CurveEnd::Grazing), "{:?}", curve.end);
        let end = curve.points.last().unwrap().solution.unknowns.clone();
        let (grazing, _) = at_grazing(ZETA, EPSILON, OMEGA);
        // Located by Newton's method, to rounding.
        assert!(end[0] == 0.0 && (end[2] - grazing.amplitude()).abs() < 1e-13);
    }
}

#[test]
fn every_admissible_point_of_a_branch_is_an_orbit_of_the_hybrid_system() {
    for loops in 1..=5 {
        let (equations, curve) = amplitude_branch(loops, [0.1, 0.7]);
        assert!(matches!(curve.end, CurveEnd::LeftWindow), "{:?}", curve.end);
        let mut checked = 0;
        for CurvePoint { solution, .. } in &curve.points {
            if solution.impact_velocity() < 5e-3 || solution.ceiling() > -1e-4 {
                continue;
            }
            let oscillator = equations.oscillator_at(&solution.unknowns);
            assert_returns(&oscillator, solution);
            // As on the two-parameter curves; where the solution is very unstable, the displaced
            // orbits diverge.
            let step = (1e-3 * solution.impact_velocity() * solution.impact_velocity()).min(1e-6);
            let multipliers = solution.multipliers;
            let scale = 1.0 + multipliers.trace.abs();
            let simulated = simulated_multipliers(&oscillator, solution, step).unwrap();
            assert_within(simulated.trace, multipliers.trace, 1e-5 * scale);
            assert_within(simulated.determinant, multipliers.determinant, 1e-5 * scale);
            checked += 1;
        }
        assert!(checked > 5, "p = {loops}: {checked}");
    }
}

#[test]
fn no_admissible_orbit_is_called_inadmissible() {
    // Where the ceiling is above the wall, the simulated orbit meets the wall before p periods are
    // over.
    let mut checked = 0;
    for loops in 2..=5 {
        let (equations, curve) = amplitude_branch(loops, [0.1, 0.7]);
        for CurvePoint { solution, .. } in &curve.points {
            if solution.impact_velocity() > 1e-3 && solution.ceiling() > 1e-9 {
                let oscillator = equations.oscillator_at(&solution.unknowns);
                assert!(!solution.admissible());
                assert!(impacts_early(&oscillator, solution), "p = {loops}: {solution:?}");
                checked += 1;
            }
        }
    }
    assert!(checked > 50, "{checked}");
}

#[test]
fn branches_outlive_the_virtual_points() {
    let mut outlived = 0;
    for (loops, frequency) in [(1, 0.5), (2, 0.5), (2, 0.67), (3, 0.605), (4, 0.665)] {
        let route = route([0.0, 1.8], [0.1, 2.0], false);
        let parameters = [ZETA, EPSILON, frequency];
        let (equations, curve) = branch(parameters, loops, Formulation::FixedPhase, 1.0, &route);
        assert!(matches!(curve.end, CurveEnd::LeftWindow), "{:?}", curve.end);
        let (_, vivid) = branch(parameters, loops, Formulation::Vivid, 1.0, &route);
        let last = |curve: &Curve| curve.points.last().unwrap().solution.unknowns.clone();
        if matches!(vivid.end, CurveEnd::LeftWindow) {
            // Where the maximum on which a loop ends disappears, a corrector can also land on
            // another maximum of the same orbit and VIVID goes on: whether it ends depends on the
            // steps, and not every branch needs to show it. Located on the edge of the window to
            // rounding, with condition numbers below 10³.
            assert_within((last(&vivid) - last(&curve)).norm(), 0.0, 1e-11);
            continue;
        }
        assert!(matches!(vivid.end, CurveEnd::Stalled(_)), "{:?}", vivid.end);
        let reached = last(&vivid)[unknown::VELOCITY];
        let beyond: Vec<_> =
            curve.points.iter().filter(|point| point.solution.impact_velocity() > reached).collect();
        outlived += usize::from(!beyond.is_empty());
        for CurvePoint { solution, .. } in beyond {
            assert_returns_unhindered(&equations.oscillator_at(&solution.unknowns), solution);
        }
    }
    assert!(outlived >= 2, "VIVID ended on {outlived} branches only");
}

#[test]
fn events_are_the_same_in_both_formulations() {
    let route = route([0.1, 0.7], [0.1, 2.0], false);
    for loops in 1..=5 {
        let events = [Formulation::Vivid, Formulation::FixedPhase].map(|formulation| {
            let (_, curve) = branch([ZETA, EPSILON, OMEGA], loops, formulation, 1.0, &route);
            curve.events
        });
        assert!(!events[0].is_empty());
        assert_eq!(events[0].len(), events[1].len());
        for (a, b) in events[0].iter().zip(&events[1]) {
            assert_eq!(a.condition, b.condition);
            // Same tolerance as for the ends of the branches above.
            assert_within((&a.solution.unknowns - &b.solution.unknowns).norm(), 0.0, 1e-11);
        }
    }
}

#[test]
fn a_bifurcation_from_which_a_branch_is_followed_is_one_of_its_events() {
    let mut checked = 0;
    for loops in 1..=5 {
        let (equations, whole) = amplitude_branch(loops, [0.1, 0.7]);
        for start in &whole.events {
            let Condition::Multiplier(multiplier) = start.condition else { continue };
            let equations = equations.with_formulation(Formulation::FixedPhase);
            let curve = SolutionCurve { equations, condition: Condition::Secondary(OMEGA) };
            let through = start.solution.unknowns.clone();
            let route = route([0.1, 0.7], [0.1, 2.0], false);
            let up = Unknowns::new(1.0, 0.0, 0.0, 0.0);
            let both = curve.follow_both_ways(through.clone(), up, &start.times, &route).unwrap();
            let met = both.events.iter().filter(|event| (&event.solution.unknowns - &through).norm() < 1e-9);
            let met: Vec<_> = met.collect();
            let [event] = met.as_slice() else { panic!("p = {loops}: {met:?}") };
            assert_eq!(event.condition, start.condition);
            // The multiplier passes at the index given, and all events are in the order of the
            // branch.
            let side = |index: usize| {
                let multipliers = both.points[index].solution.multipliers;
                multipliers.determinant - multiplier * multipliers.trace + 1.0
            };
            assert!(side(event.index - 1) * side(event.index) < 0.0);
            assert!(both.events.is_sorted_by_key(|event| event.index));
            assert!(
                both.points
                    .windows(2)
                    .all(|pair| pair[0].solution.unknowns[0] > pair[1].solution.unknowns[0])
            );
            checked += 1;
        }
    }
    assert!(checked >= 5, "{checked}");
}

#[test]
fn where_two_maxima_come_to_the_wall_within_a_step_the_first_is_the_grazing_bifurcation() {
    // Beside the point at which two GZ curves of p = 2 meet; in long steps, as where nothing is
    // drawn.
    let control = StepControl { first: 1e-3, longest: 0.1, shortest: 1e-6, turn: 0.07, tolerance: 1e-4 };
    let mut met = 0;
    for k in 0..20 {
        let omega = 0.49913 + 4e-6 * f64::from(k);
        let route = Route { control, ..route([0.7, 1.3], [0.1, 2.0], false) };
        let (_, curve) = branch([ZETA, EPSILON, omega], 2, Formulation::FixedPhase, 1.0, &route);
        let grazes = |event: &&Event| event.condition == Condition::InteriorGrazing;
        for event in curve.events.iter().filter(grazes) {
            assert!(event.solution.ceiling().abs() < 1e-11, "{omega}: {}", event.solution.ceiling());
            met += 1;
        }
    }
    assert!(met >= 20, "{met}");
}

#[test]
fn what_happens_beyond_the_edge_of_the_window_is_not_on_the_branch() {
    let follow = |right: f64| {
        let window = route([0.2, right], [0.8, 0.9], false);
        branch([ZETA, EPSILON, OMEGA], 2, Formulation::FixedPhase, 1.0, &window).1
    };
    let whole = follow(0.4);
    let first = whole.events.first().expect("the period doubling of Figure 2");
    let [amplitude, _] = first.solution.parameters();
    // Far less than a step before it, and after it.
    for (edge, events) in [(amplitude - 1e-6, 0), (amplitude + 1e-6, 1)] {
        let cut = follow(edge);
        assert!(matches!(cut.end, CurveEnd::LeftWindow), "{:?}", cut.end);
        assert_eq!(cut.events.len(), events);
        let [last, _] = cut.points.last().expect("there are points").solution.parameters();
        assert_eq!(last, edge);
    }
}

#[test]
fn a_branch_that_turns_beyond_the_edge_within_a_step_has_its_fold() {
    let mut turned = 0;
    for (loops, frequency) in [(1, 0.5), (2, 0.5), (2, 0.67), (3, 0.605), (4, 0.665)] {
        let follow = |[left, right]: [f64; 2]| {
            let window = route([left, right], [0.1, 2.0], false);
            branch([ZETA, EPSILON, frequency], loops, Formulation::FixedPhase, 1.0, &window).1
        };
        let whole = follow([0.0, 1.8]);
        let folds = whole.events.iter().filter(|event| event.condition == Condition::SADDLE_NODE);
        for Event { solution, index, .. } in folds {
            let [fold, _] = solution.parameters();
            let [before, after] = [index - 1, *index].map(|at| whole.points[at].solution.parameters()[0]);
            // Only the fold lies beyond the edge, not the points beside it.
            let nearer = if before < fold { before.max(after) } else { before.min(after) };
            let edge = fold + 0.01 * (nearer - fold);
            let cut = follow(if before < fold { [0.0, edge] } else { [edge, 1.8] });
            let found = cut.events.iter().filter(|event| event.condition == Condition::SADDLE_NODE);
            let found = found.filter(|event| (event.solution.parameters()[0] - fold).abs() < 1e-9);
            assert_eq!(
                (found.count(), cut.points.len()),
                (1, whole.points.len()),
                "{loops} {frequency}: {edge}"
            );
            turned += 1;
        }
    }
    assert!(turned >= 3, "{turned}");
}
