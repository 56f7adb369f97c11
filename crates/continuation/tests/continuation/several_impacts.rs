//! Solutions with several impacts: the equations compared with differences, and solutions with simulation.

use core::f64::consts::TAU;

use grazing_continuation::arclength::StepControl;
use grazing_continuation::curve::{CurveEnd, Event, Route, SolutionCurve, Window};
use grazing_continuation::locate::{Condition, locate};
use grazing_continuation::mps::{EventTimes, Formulation, LoopEquations, Round, Unknowns, unknown};
use grazing_model::orbit::{FlightEnd, Orbit};
use grazing_model::smooth::Integrated;
use grazing_model::{ImpactOscillator, LinearOscillator, OnWall, State};

use crate::specimens::{EPSILON, Spring, ZETA, assert_within};

/// A function that vanishes at a bifurcation, with its gradient.
type Vanishing = fn(&Round) -> (f64, Unknowns);

#[test]
fn gradients_in_all_unknowns_agree_with_differences() {
    const H: f64 = 1e-5;
    let functions: [Vanishing; 4] = [
        |maps| maps.characteristic(1.0),
        |maps| maps.characteristic(-1.0),
        |maps| maps.product_less(1.0),
        |maps| maps.product_less(0.3),
    ];
    let oscillator = Integrated::new(Spring::DUFFING, [0.5, 0.6]);
    let equations = LoopEquations::new(oscillator, 2, Formulation::FixedPhase);
    // No solution is needed; one impact has no velocity.
    let impacts = [(0.3, 0.2), (0.0, 2.0), (0.15, 5.0), (0.4, 9.0)].map(|(y, z)| OnWall::new(y, z));
    for count in 1..=impacts.len() {
        let point = Unknowns::of_impacts(&impacts[..count], [0.5, 0.6]);
        let mut times = EventTimes::default();
        let maps = equations.maps::<2>(&point, &mut times).unwrap();
        let system = maps.system();
        let size = 2 * count + 2;
        for k in 0..size {
            let mut at = |h: f64| {
                let moved = &point + point.along(k) * h;
                equations.maps::<1>(&moved, &mut times).unwrap()
            };
            let around = [at(-2.0 * H), at(-H), at(H), at(2.0 * H)];
            // Rounding, 10⁻¹³/h; the error of fourth order in h is less.
            let difference = |of: &dyn Fn(&Round) -> f64| {
                let [a, b, c, d] = around.each_ref().map(of);
                (8.0 * (c - b) - (d - a)) / (12.0 * H)
            };
            for function in functions {
                let (_, gradient) = function(&maps);
                let expected = difference(&|maps| function(maps).0);
                assert_within(gradient[k], expected, 1e-7 * (1.0 + gradient.norm()));
            }
            for row in 0..2 * count {
                let expected = difference(&|maps| maps.system().residual[row]);
                assert_within(system.jacobian[[row, k]], expected, 1e-8 * (1.0 + expected.abs()));
            }
        }
    }
}

/// The impacts of motion that has settled, in the order of time, as far as it recurs after these many periods.
fn settled<O: ImpactOscillator>(oscillator: &O, from: State, periods: u32) -> Option<Vec<OnWall>> {
    let span = f64::from(periods) * oscillator.forcing_period();
    let omega = oscillator.forcing_frequency().value;
    let mut orbit = Orbit::new(oscillator, from, 1000.0 * span, usize::MAX);
    let mut impacts: Vec<(f64, OnWall)> = Vec::new();
    for flight in orbit.by_ref() {
        if let FlightEnd::Impact(at) = flight.end {
            impacts.push((flight.start + flight.duration, OnWall::new(at.velocity, at.phase)));
        }
    }
    let &(last, end) = impacts.last()?;
    let recent: Vec<&(f64, OnWall)> =
        impacts.iter().filter(|(time, _)| *time > last - span * (1.0 + 1e-6)).collect();
    let (first, begin) = recent[0];
    let recurs = (begin.velocity - end.velocity).abs() < 1e-10 && (last - first - span).abs() < 1e-9;
    // Phases are counted on.
    let counted = |(time, at): &&(f64, OnWall)| OnWall {
        phase: libm::fmod(begin.phase, TAU) + omega * (time - first),
        ..*at
    };
    recurs.then(|| recent[..recent.len() - 1].iter().map(counted).collect())
}

#[test]
fn what_simulation_settles_on_solves_the_equations_and_is_as_stable_as_they_say() {
    // Places at which motion with several impacts is stable, with their numbers of impacts and periods.
    let places = [([0.989607, 0.486342], 2, 2), ([0.28, 0.855], 2, 3), ([0.322, 0.855], 2, 4)];
    for ([amplitude, omega], count, periods) in places {
        let oscillator = LinearOscillator::new(ZETA, EPSILON, amplitude, omega).unwrap();
        let starts =
            (0..12).map(|k| State { position: -0.05 - 0.2 * f64::from(k), velocity: 0.3, phase: 0.0 });
        let found =
            starts.filter_map(|from| settled(&oscillator, from, periods)).find(|it| it.len() == count);
        let impacts = found.unwrap_or_else(|| panic!("{count} impacts in {periods} periods at {amplitude}"));
        let equations = LoopEquations::new(oscillator, periods, Formulation::FixedPhase);
        let start = Unknowns::of_impacts(&impacts, [amplitude, omega]);
        let held = [Condition::Primary(amplitude), Condition::Secondary(omega)];
        let point = locate(&equations, held, start.clone(), &mut EventTimes::default()).unwrap();
        assert_within((&point - &start).amax(), 0.0, 1e-7);
        let solution = equations.solution(&point);
        assert!(solution.attracts(), "{solution:?}");
        // The order in which impacts are listed does not matter.
        for turn in 1..count {
            let mut turned = impacts.clone();
            turned.rotate_left(turn);
            turned[count - turn..].iter_mut().for_each(|at| at.phase += TAU * f64::from(periods));
            let turned = equations.solution(&Unknowns::of_impacts(&turned, [amplitude, omega]));
            assert_within(turned.multipliers.trace, solution.multipliers.trace, 1e-6);
            assert_within(turned.multipliers.determinant, solution.multipliers.determinant, 1e-6);
            assert!(turned.admissible());
            // Without a maximum between impacts both are −∞.
            assert!(
                turned.ceiling() == solution.ceiling()
                    || (turned.ceiling() - solution.ceiling()).abs() < 1e-7
            );
        }
        // Each impact multiplies areas in (y, z) by ε y/y', and damping shrinks them.
        let decay = libm::exp(-2.0 * ZETA * f64::from(periods) * TAU / omega);
        let expected = libm::pow(EPSILON, 2.0 * count as f64) * decay;
        assert_within(solution.multipliers.determinant, expected, 1e-9);
    }
}

#[test]
fn impacts_may_be_numbered_from_any_of_them() {
    let oscillator = LinearOscillator::new(ZETA, EPSILON, 0.5, 0.6).unwrap();
    let equations = LoopEquations::new(oscillator, 3, Formulation::FixedPhase);
    let impacts = [(0.3, 0.2), (0.1, 4.0), (0.15, 9.0)].map(|(y, z)| OnWall::new(y, z));
    let point = Unknowns::of_impacts(&impacts, [0.5, 0.6]);
    for (first, impact) in impacts.iter().enumerate() {
        let other = point.beginning_with(first, 3);
        assert_eq!(other.impact(0).velocity, impact.velocity);
        // Phases go on rising, by no more than the whole time.
        let phases: Vec<f64> = (0..3).map(|index| other.impact(index).phase).collect();
        assert!(phases.is_sorted() && phases[2] - phases[0] < 3.0 * TAU);
        assert_within(equations.gap(&point, &other).norm(), 0.0, 1e-14);
        // Numbering is no solution: something else stays something else.
        let mut moved = other.clone();
        moved[0] += 0.01;
        assert_within(equations.gap(&point, &moved).norm(), 0.01, 1e-12);
    }
    assert!(!equations.recurs_sooner(&point));
    let once = Unknowns::of_impacts(&impacts[..1], [0.5, 0.6]);
    let thrice = once.followed_by(&once, 1).followed_by(&once, 2);
    assert!(equations.recurs_sooner(&thrice));
    assert!(equations.of_half_the_time().is_none() && equations.after_a_part(&thrice, 2).is_none());
    assert_eq!(thrice.first_impacts(1), once);
}

#[test]
fn a_branch_that_ends_where_an_impact_loses_its_velocity_has_the_bifurcations_just_before() {
    // Away from a resonance the trace tends to infinity there, so that a multiplier passes 1 or −1 on the way.
    let [amplitude, omega] = [0.279, 0.7578];
    let oscillator = LinearOscillator::new(ZETA, EPSILON, amplitude, omega).unwrap();
    // Two impacts in two periods, the second of them slow.
    let impacts = [(0.985, -0.51), (0.04, 7.68)].map(|(y, z)| OnWall::new(y, z));
    let equations = LoopEquations::new(oscillator, 2, Formulation::FixedPhase);
    let held = [Condition::Primary(amplitude), Condition::Secondary(omega)];
    let start = Unknowns::of_impacts(&impacts, [amplitude, omega]);
    let start = locate(&equations, held, start, &mut EventTimes::default()).unwrap();
    let branch = SolutionCurve { equations, condition: Condition::Secondary(omega) };
    let window = Window { primary: [0.2, 1.3], secondary: [0.0, 2.0] };
    // In steps so long that the last one begins where solutions are stable.
    let control = StepControl { first: 1e-3, longest: 0.1, shortest: 1e-6, turn: 0.07, tolerance: 1e-8 };
    let route = Route { window, control, step_limit: 5_000, stop_at_events: false, pace: None };
    let faster = start.along(unknown::PRIMARY);
    let branch = branch.follow_both_ways(start, faster, &EventTimes::default(), &route).unwrap();
    let mut stable_before = 0;
    let ends = [(branch.beginning.as_ref(), 0), (Some(&branch.end), branch.points.len() - 1)];
    for (end, index) in ends.into_iter().filter(|(end, _)| matches!(end, Some(CurveEnd::Grazing))) {
        let last = &branch.points[index].solution;
        assert!(last.multipliers.trace.is_infinite() && !last.stable(), "{end:?} {last:?}");
        let beside = &branch.points[if index == 0 { 1 } else { index - 1 }].solution;
        let sign = last.multipliers.trace.signum();
        // Nothing stable reaches grazing: either it was unstable before, or the loss was located.
        let lost = |event: &Event| event.condition == Condition::Multiplier(sign);
        assert!(!beside.stable() || branch.events.iter().any(lost), "{beside:?}");
        stable_before += u32::from(beside.stable());
    }
    assert!(stable_before > 0, "{:?} {:?}", branch.beginning, branch.end);
}
