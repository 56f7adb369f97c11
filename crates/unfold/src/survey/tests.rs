//! Surveys of oscillators on whose slices much is found.

use grazing_continuation::curve::Window;
use grazing_continuation::mps::{Formulation, LoopEquations, Multipliers, PeriodicSolution};
use grazing_input::Description;
use grazing_model::AnyOscillator;
use grazing_model::motion::Maximum;

use super::*;
use crate::non_impacting::periodic_motion;
use crate::progress::Silent;
use crate::search;
use crate::slice_stability::SliceStability;
use crate::subharmonic::over_periods;

/// What slices show of p-loop MPSs on slices of a random oscillator to which nothing leads from
/// grazing, and the number of curves.
fn seen(number: u64, seed: u64, loops: u32, window: Window, levels: &[f64]) -> (usize, Vec<SliceStability>) {
    let text = grazing_trials::oscillators::description(seed, number);
    let model = Description::parse(&text, "two wells").expect("what is made at random is right");
    let oscillator = model.oscillator([window.primary[0], window.secondary[0]]);
    let found = search::on_slices(&oscillator, &[loops], window, levels, &Silent);
    let found = found.into_iter().map(|(_, solution)| solution).collect();
    let mut net = Net::new(LoopEquations::new(oscillator, loops, Formulation::FixedPhase));
    let scope = Scope { window, loops: vec![loops], start: None };
    let mut survey = Survey::new(&mut net, &scope, &[], found);
    survey.look_at(levels);
    while survey.goes_on(&Silent) {}
    (survey.lines().len(), survey.stabilities())
}

/// What is found in a survey of motion over two forcing periods from slices at some levels, at the first of which
/// motion over one period is known.
fn over_two_periods<T>(
    oscillator: &AnyOscillator,
    scope: &Scope,
    levels: &[f64],
    found: impl FnOnce(&Survey<'_>) -> T,
) -> T {
    let free = |oscillator: AnyOscillator| {
        Net::new(LoopEquations::without_impacts(oscillator, scope.window.widths()))
    };
    let mut once = free(oscillator.clone());
    let mut survey = Survey::new(&mut once, scope, &[], Vec::new());
    survey.add_slice(Slice::new(levels[0], periodic_motion(oscillator, scope, levels[0]).branches));
    while survey.goes_on(&Silent) {}
    let mut twice = free(over_periods(oscillator, 2));
    let mut survey = Survey::of_doubled(&mut twice, scope, 2, &once);
    survey.look_at(levels);
    while survey.goes_on(&Silent) {}
    found(&survey)
}

#[test]
fn motion_over_two_periods_is_followed_from_one_of_them_and_not_from_the_other_as_well() {
    // A well beside the wall's, over whose hill motion goes: doublings, and folds of doubled motion.
    let text = grazing_trials::oscillators::description(20_261_130, 2);
    let model = Description::parse(&text, "two wells").expect("what is made at random is right");
    let window = Window { primary: [0.0, 0.659], secondary: [0.3955, 1.0825] };
    let scope = Scope { window, loops: vec![2], start: None };
    let oscillator = model.oscillator([0.1, 0.4]);
    over_two_periods(&oscillator, &scope, &[0.4, 0.43], |survey| {
        for slice in &survey.slices {
            let known = slice.branches.len();
            for branch in &slice.branches {
                let middle = &branch.points[branch.points.len() / 2].solution.unknowns;
                let later = survey.slicer.half_its_time_later(middle).expect("it has two halves");
                let mut again = slice.clone();
                survey.slicer.add(&mut again, later, &EventTimes::default(), true);
                assert_eq!(again.branches.len(), known, "{middle:?}");
            }
            assert!(known > 3, "{known}");
        }
        let curves = &survey.net.curves;
        for DiagramCurve { kind, curve, .. } in curves {
            let CurvePoint { solution, times } = &curve.points[curve.points.len() / 2];
            let later = survey.slicer.half_its_time_later(&solution.unknowns).expect("it has two halves");
            let solution = survey.net.equations.solution(&later);
            let event = Event { condition: curve.condition, solution, index: 0, times: times.clone() };
            assert!(explained(survey.net, *kind, &event, window), "{kind:?} {later:?}");
        }
        assert!(curves.len() > 3, "{}", curves.len());
    });
}

#[test]
fn a_curve_of_free_motion_that_stays_behind_the_wall_is_given_up() {
    let point = |height: f64| {
        let highest_interior_maximum = Some(Maximum { time: 0.0, position: height });
        let multipliers = Multipliers { trace: 0.0, determinant: 0.5 };
        let solution = PeriodicSolution {
            loops: 0,
            unknowns: Unknowns::new(0.0, 0.0, 0.0, 0.0),
            multipliers,
            highest_interior_maximum,
        };
        CurvePoint { solution, times: EventTimes::default() }
    };
    let goes_on = |points: &[CurvePoint]| in_sight(points, &Unknowns::new(0.0, 0.0, 0.0, 0.0)).is_some();
    let mut points = vec![point(-0.1); 90];
    points.extend(vec![point(0.1); OUT_OF_SIGHT - 1]);
    assert!(goes_on(&points));
    points.push(point(0.1));
    assert!(!goes_on(&points));
    points.push(point(-0.1));
    assert!(goes_on(&points));
}

#[test]
fn a_sheet_of_solutions_between_two_points_of_the_edge_is_found() {
    // Two wells: inside this window nothing leads from grazing to these MPSs.
    let window = Window { primary: [0.7, 0.7616], secondary: [0.4483, 0.4917] };
    let (lines, stabilities) = seen(2, 1, 1, window, &[0.48, 0.4917]);
    // The last slice cuts off a corner.
    assert_eq!(lines, 4);
    // Simulation settles on a solution with one loop here.
    assert!(stabilities.iter().all(|stability| stability.share([0.73, 0.736]) == 1.0), "{stabilities:?}");
}

#[test]
fn solutions_of_two_loops_are_found_that_begin_where_motion_over_two_periods_grazes() {
    let window = Window { primary: [0.9, 1.2], secondary: [0.38, 0.46] };
    let scope = Scope { window, loops: vec![2], start: None };
    // An attraction that gives way to repulsion on the way to the wall.
    let force = "-0.06*v - (x + 1) + 1.2*(exp(4*x + 1) - exp(8*x + 2))";
    let oscillator = crate::specimens::forced(force, 0.7).oscillator([1.0, 0.4]);
    let grazing = over_two_periods(&oscillator, &scope, &[0.418], |survey| {
        // Half a turn on the same curve is met again.
        assert_eq!(survey.grazing.len(), 1);
        survey.grazing.clone()
    });
    let seen = |grazing: &[GrazingCurve]| {
        let mut net = Net::new(LoopEquations::new(oscillator.clone(), 2, Formulation::FixedPhase));
        let mut survey = Survey::new(&mut net, &scope, grazing, Vec::new());
        survey.look_at(&[0.418_093]);
        while survey.goes_on(&Silent) {}
        // Simulation settles on a solution with two loops here.
        survey.stabilities()[0].share([1.079, 1.08])
    };
    assert_eq!([seen(&[]), seen(&grazing)], [0.0, 1.0]);
}

#[test]
fn a_sheet_that_begins_where_motion_of_twice_the_period_grazes_is_found() {
    let window = Window { primary: [0.0, 0.5266], secondary: [0.5533, 0.5834] };
    let (_, stabilities) = seen(2, 20_261_122, 2, window, &[0.5533, 0.580_712_5]);
    // Simulation settles on solutions with two loops here.
    for place in [[0.2575, 0.269], [0.4135, 0.425]] {
        assert_eq!(stabilities[1].share(place), 1.0, "{stabilities:?}");
    }
}
