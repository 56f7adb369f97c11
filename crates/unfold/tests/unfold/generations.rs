//! Resonances on curves at which motion that already has impacts grazes: theorem, continuation and simulation.

use core::f64::consts::TAU;

use grazing_continuation::arclength::StepControl;
use grazing_continuation::bifurcation::Bifurcation;
use grazing_continuation::criticality::period_doubling;
use grazing_continuation::curve::{CurveEnd, Route, SolutionCurve, Window};
use grazing_continuation::fit::quadratic_coefficient;
use grazing_continuation::locate::{Condition, locate};
use grazing_continuation::mps::{EventTimes, Formulation, LoopEquations, Unknowns, unknown};
use grazing_continuation::resonance::ResonantGrazingPoint;
use grazing_input::Description;
use grazing_model::orbit::{FlightEnd, Orbit};
use grazing_model::{AnyOscillator, ImpactOscillator, LinearOscillator, OnWall, State};
use grazing_unfold::generations::{LaterResonance, bases, later};
use grazing_unfold::progress::Silent;
use grazing_unfold::{Diagram, Scope};

use crate::specimens::{EPSILON, ZETA, assert_within, closed_form, scope};

/// The resonances with up to four rounds on the curves of solutions of these numbers of loops.
fn found(oscillator: &AnyOscillator, scope: &Scope) -> (Diagram, Vec<LaterResonance>) {
    let located = Diagram::located(oscillator, scope, &Silent).expect("it grazes");
    let followed = located.follow(&Silent, &|_, _| ());
    let diagram = located.with_curves(followed);
    let rounds = Scope { loops: vec![1, 2, 3, 4], ..scope.clone() };
    let later = later(&diagram, &bases(&diagram), &rounds, &Silent);
    (diagram, later.resonances)
}

/// Checks that the coefficients of the theorem are those of the curves of the hybrid system.
fn assert_measured(point: &ResonantGrazingPoint) {
    let conditions = [Condition::SADDLE_NODE, Condition::PERIOD_DOUBLING];
    for (condition, leading) in conditions.into_iter().zip(point.leading().into_array()) {
        let fit = quadratic_coefficient(point, condition).expect("the curve is there");
        assert!(fit.error < 1e-3 * fit.value.abs(), "{fit:?}");
        assert_within(fit.value, leading.coefficient, 3.0 * fit.error + 1e-9 * fit.value.abs());
    }
}

/// Whether simulated motion that begins beside the first impact of a solution comes back to it.
fn attracts(oscillator: &AnyOscillator, point: &Unknowns, periods: u32) -> bool {
    let first = point.impact(0);
    let from = State::on_wall(first.velocity * (1.0 + 1e-4), first.phase);
    let span = f64::from(periods) * oscillator.forcing_period();
    let mut orbit = Orbit::new(oscillator, from, 400.5 * span, usize::MAX);
    let impacts = orbit.by_ref().filter_map(|flight| match flight.end {
        FlightEnd::Impact(at) => Some(OnWall::new(at.velocity, at.phase)),
        FlightEnd::TimeIsUp(_) => None,
    });
    let impacts: Vec<OnWall> = impacts.collect();
    let last = &impacts[impacts.len() - point.impacts()..];
    last.iter().any(|at| {
        (at.velocity - first.velocity).abs() < 1e-7
            && libm::remainder(at.phase - first.phase, TAU).abs() < 1e-7
    })
}

#[test]
fn on_the_grazing_curves_of_figure_7_the_theorems_hold_for_solutions_with_impacts() {
    let window = scope([0.0, 1.3], [0.35, 1.02], &[1, 2]);
    let (diagram, later) = found(&closed_form(), &window);
    // Of p, n = 2, 2, as an independent program has found it.
    let known = later.iter().find(|found| {
        let [amplitude, omega] = found.resonance.located.orbit().oscillator().parameters();
        (amplitude - 0.989607).abs() < 1e-6 && (omega - 0.486342).abs() < 1e-6
    });
    let known = known.expect("it is on the curve");
    let base = &diagram.curves[known.base.index];
    assert_eq!((base.loops, base.n, known.impacts(), known.periods()), (2, 2, 2, 2));
    let point = known.resonance.theorem.as_ref().expect("theorem 2.4 holds");
    let [saddle_node, period_doubling] = point.leading().into_array();
    assert_within(saddle_node.coefficient, -227.999, 1e-3);
    assert_within(period_doubling.coefficient, 536.632, 1e-3);
    let (mut measured, mut rounds, mut settled) = (0, [0; 5], [0; 5]);
    for found in &later {
        let q = found.resonance.loops;
        let base = &diagram.curves[found.base.index];
        assert_eq!(found.impacts(), q as usize + 1);
        assert_eq!(found.periods(), q * base.loops);
        let Ok(point) = &found.resonance.theorem else { continue };
        // Beside ω = 1/2 two loops of motion with one impact are nearly one loop twice, and the coefficients are
        // of the order of a million.
        if point.leading().into_array().iter().any(|leading| leading.coefficient.abs() > 1e5) {
            continue;
        }
        assert_measured(point);
        measured += 1;
        rounds[q as usize] += 1;
        // Between the saddle-node and the period doubling motion settles on the solution.
        let ends: Vec<_> = found.curves.iter().take(2).map(|curve| &curve.points[3].solution).collect();
        for end in ends {
            let equations = &found.resonance.located.equations();
            for velocity in [0.7, 0.9, 0.98, 1.02, 1.1, 1.4] {
                let velocity = velocity * end.unknowns[unknown::VELOCITY];
                let held = [Condition::Secondary(end.parameters()[1]), Condition::ImpactVelocity(velocity)];
                let start = end.unknowns.clone();
                let Ok(point) = locate(equations, held, start, &mut EventTimes::default()) else { continue };
                let solution = equations.solution(&point);
                if solution.attracts() && solution.multipliers.radius() < 0.9 {
                    let oscillator = equations.oscillator_at(&point);
                    assert!(attracts(&oscillator, &point, found.periods()), "{solution:?}");
                    settled[q as usize] += 1;
                }
            }
        }
    }
    assert!(measured >= 8 && rounds[1..].iter().all(|count| *count > 0), "{measured} {rounds:?}");
    // For two rounds the curves are too close to each other for these velocities.
    assert!(settled[1] >= 10 && settled[2..].iter().sum::<i32>() >= 4, "{settled:?}");
}

/// η and (μ − μ_graz)/η² where solutions with twice the impacts graze, which begin at the period doubling at which
/// the lowest impact velocity is `size`.
fn doubled_grazing(
    point: &ResonantGrazingPoint,
    periods: u32,
    near: &Unknowns,
    size: f64,
) -> Option<[f64; 2]> {
    let oscillator = point.orbit().oscillator();
    let halved = LoopEquations::new(oscillator.clone(), periods, Formulation::FixedPhase);
    let slow = near.beginning_with(near.lowest_velocity().0, periods);
    let held = [Condition::PERIOD_DOUBLING, Condition::ImpactVelocity(size)];
    let at = &locate(&halved, held, slow, &mut EventTimes::default()).ok()?;
    let maps = halved.maps::<1>(at, &mut EventTimes::default()).ok()?;
    let direction = maps.direction(-1.0)?;
    let aside = halved.with_others(at, Unknowns::new(direction[0], direction[1], 0.0, 0.0));
    let aside = &aside * (0.05 * at.lowest_velocity().1 / aside[unknown::VELOCITY].abs());
    let near = (at + &aside).followed_by(&(at - &aside), halved.loops());
    let eta = at[unknown::SECONDARY];
    let equations = LoopEquations::new(oscillator.clone(), 2 * periods, Formulation::FixedPhase);
    let condition = Condition::Secondary(eta);
    let held = [Condition::ImpactVelocity(near[unknown::VELOCITY]), condition];
    let start = locate(&equations, held, near, &mut EventTimes::default()).ok()?;
    let onwards = &start - &at.followed_by(at, halved.loops());
    let route = Route {
        window: Window { primary: [0.0, 1.3], secondary: [0.35, 1.02] },
        control: StepControl { first: 1e-6, shortest: 1e-9, ..StepControl::DRAWING },
        step_limit: 2000,
        stop_at_events: false,
        pace: None,
    };
    let branch =
        SolutionCurve { equations, condition }.follow(start, onwards, EventTimes::default(), &route).ok()?;
    let touch = branch.events.iter().find(|event| event.condition == Condition::InteriorGrazing);
    let end = matches!(branch.end, CurveEnd::Grazing).then(|| branch.points.last()).flatten();
    let grazing = touch.map(|event| &event.solution).or(end.map(|last| &last.solution))?;
    let away = eta - oscillator.parameters()[1];
    let touching = point.orbit().place().moved(oscillator, eta).ok()?.parameters[0];
    Some([away, (grazing.parameters()[0] - touching) / (away * away)])
}

/// The limit map of a resonance knows P_global alone, here that through the impacts of the motion that grazes; the
/// normal form comes from third derivatives of all flights of the solutions that leave.
#[test]
fn period_doublings_that_leave_resonances_with_impacts_are_as_critical_as_the_limit_map_says() {
    let (_, later) = found(&closed_form(), &scope([0.0, 1.3], [0.35, 1.02], &[1, 2]));
    let (mut compared, mut touched) = ([0; 2], 0);
    for found in &later {
        let Ok(point) = &found.resonance.theorem else { continue };
        if point.leading().into_array().iter().any(|leading| leading.coefficient.abs() > 1e4) {
            continue;
        }
        let expected = point.resonant_point().limit_map().criticality();
        let linear = LinearOscillator::new(ZETA, EPSILON, 1.0, 1.0).expect("it is in the domain");
        let equations = LoopEquations::new(linear, found.periods(), Formulation::FixedPhase);
        let flips = found.curves.iter().filter(|curve| curve.condition == Condition::PERIOD_DOUBLING);
        for flip in flips {
            let scaled = |near: &Unknowns| {
                let slow = near.beginning_with(near.lowest_velocity().0, found.periods());
                let conditions =
                    [Condition::PERIOD_DOUBLING, Condition::ImpactVelocity(slow[unknown::VELOCITY])];
                let exact = locate(&equations, conditions, slow, &mut EventTimes::default()).ok()?;
                let form = period_doubling(&equations, &exact).ok()?;
                let velocity = exact[unknown::VELOCITY];
                let along = velocity / form.direction[0];
                Some((velocity, along * along * form.coefficient))
            };
            let points = flip.points.iter().take(60).map(|point| &point.solution.unknowns);
            let near: Vec<(f64, f64)> =
                points.filter_map(scaled).filter(|(y, _)| (3e-4..1e-1).contains(y)).collect();
            let [(y, value), (farther, other)] = near[..2] else { panic!("the curve is too short") };
            // The error is of first order in y.
            let limit = value - y * (other - value) / (farther - y);
            assert_within(limit, expected, 0.05 * expected.abs());
            compared[usize::from(expected > 0.0)] += 1;
            // Where the solutions with twice the impacts graze, at three distances from the resonance.
            let coefficient = point.resonant_point().doubled_grazing_coefficient();
            let first = flip.points.iter().map(|point| &point.solution.unknowns);
            let near = first.clone().find(|near| near.lowest_velocity().1 > 1e-4).expect("the curve leaves");
            let sizes = [1.0, 2.0, 4.0].map(|times| 1e-5 * times);
            let seen = sizes.map(|size| doubled_grazing(point, found.periods(), near, size));
            let [Some(a), Some(b), Some(c)] = seen else { continue };
            // Their errors are of first order and of second.
            let weight = |[at, value]: [f64; 2], [p, _]: [f64; 2], [q, _]: [f64; 2]| {
                value * p * q / ((at - p) * (at - q))
            };
            let limit = weight(a, b, c) + weight(b, a, c) + weight(c, a, b);
            assert_within(limit, coefficient, 2e-3 * coefficient.abs());
            touched += 1;
        }
    }
    assert!(compared[0] >= 1 && compared[1] >= 7, "{compared:?}");
    assert!(touched >= 8, "{touched}");
}

#[test]
fn impacts_that_take_time_and_a_nonlinear_force_make_no_difference() {
    let text = "name = \"Test\"\n[parameters]\n[primary]\nname = \"mu\"\nrange = [0.1, 1.3]\n[secondary]\nname = \"eta\"\nrange = [0.4, 1.0]\n\
         [motion]\nforce = \"-0.04*v - x - 0.1*x^3 - 1 + mu*cos(eta*t)\"\nfrequency = \"eta\"\n[wall]\nposition = \"0\"\n\
         [impact]\nrestitution = \"0.9 - 0.05*y\"\nduration = \"0.02 + 0.01*y\"\n[analysis]\nloops = [1, 2]\n";
    let model = Description::parse(text, "test.toml").unwrap_or_else(|error| panic!("{error}"));
    let window = scope([0.1, 1.3], [0.4, 1.0], &[1, 2]);
    let (diagram, later) = found(&model.oscillator([0.5, 0.6]), &window);
    assert!(diagram.curves.iter().any(|curve| curve.kind == Bifurcation::Grazing));
    let points: Vec<_> = later.iter().filter_map(|found| found.resonance.theorem.as_ref().ok()).collect();
    assert!(points.len() >= 2, "{}", points.len());
    points.into_iter().for_each(assert_measured);
}
