//! Solutions with several impacts: the equations compared with differences, and solutions with simulation.

use core::f64::consts::TAU;

use grazing_continuation::locate::{Condition, locate};
use grazing_continuation::mps::{EventTimes, Formulation, LoopEquations, Round, Unknowns};
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
