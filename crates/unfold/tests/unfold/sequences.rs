//! Regions of solutions with several impacts, against simulation.

use core::f64::consts::TAU;

use grazing_continuation::bifurcation::Bifurcation;
use grazing_continuation::curve::CurveEnd;
use grazing_model::{ImpactOscillator, State};
use grazing_trials::random::Random;
use grazing_unfold::long_time::{Horizon, MotionKind, Patience};
use grazing_unfold::place::seen;
use grazing_unfold::progress::Silent;
use grazing_unfold::sequences::{Sequence, Sequences, sequences};
use grazing_unfold::{Diagram, Scope};

use crate::specimens::{closed_form, linear, scope};

/// The solutions with several impacts of the second generation in a part of Figure 7's window.
fn found(window: &Scope, rounds: &[u32]) -> (Diagram, Sequences) {
    let diagram = Diagram::compute(&closed_form(), window, &Silent).expect("it grazes");
    let sequences = sequences(&diagram, rounds, 2, &Silent);
    (diagram, sequences)
}

fn of(all: &Sequences, impacts: usize, periods: u32) -> &Sequence {
    let found = all.solutions.iter().find(|found| (found.impacts, found.periods) == (impacts, periods));
    found.unwrap_or_else(|| panic!("{impacts} impacts in {periods} periods"))
}

/// Whether a place lies in a region of these solutions; `None` where that is undecided.
fn holds(found: &Sequence, place: [f64; 2]) -> Option<bool> {
    let in_one = |decided: bool| {
        found.regions.iter().any(|region| region.doubt.is_none() == decided && region.contains(place))
    };
    if in_one(true) { Some(true) } else { (!in_one(false)).then_some(false) }
}

#[test]
fn motion_settles_on_solutions_with_several_impacts_where_their_regions_say_so() {
    let window = scope([0.3, 1.3], [0.47, 0.85], &[1, 2]);
    let (diagram, all) = found(&window, &[1, 2]);
    let horizon = Horizon { transient: 60, counted: 24, patience: Patience::Unsettled, longest: 400 };
    let mut random = Random::new(46);
    let (mut settled, mut inside) = (0, 0);
    for _ in 0..400 {
        let place = window.window.parameters([random.uniform(0.0, 1.0), random.uniform(0.0, 1.0)]);
        let here = diagram.oscillator.with_parameters(place);
        let starts: Vec<State> =
            (0..4).map(|_| State::at_rest(-random.uniform(0.0, 2.0), random.uniform(0.0, TAU))).collect();
        let known = all.solutions.iter().filter(|found| holds(found, place) == Some(true));
        inside += known.count();
        for seen in seen(&here, &starts, horizon).iter().filter(|it| it.fate.kind == MotionKind::Periodic) {
            let periods = seen.fate.periods.unwrap_or(0);
            let impacts = libm::round(seen.fate.impacts * f64::from(periods)) as usize;
            let numbers = |found: &&Sequence| (found.impacts, found.periods) == (impacts, periods);
            if let Some(found) = all.solutions.iter().find(numbers) {
                assert_ne!(
                    holds(found, place),
                    Some(false),
                    "{impacts} impacts in {periods} periods at {place:?}"
                );
                settled += 1;
            }
        }
    }
    assert!(settled > 100 && inside >= settled, "{settled} {inside}");
}

#[test]
fn regions_do_not_depend_on_the_window() {
    let wide = found(&scope([0.3, 1.3], [0.47, 0.85], &[1, 2]), &[1, 2]).1;
    let narrow = scope([0.6, 1.0], [0.6, 0.75], &[1, 2]);
    let inner = found(&narrow, &[1, 2]).1;
    let mut random = Random::new(7);
    let mut compared = 0;
    for _ in 0..2_000 {
        let place = narrow.window.parameters([random.uniform(0.0, 1.0), random.uniform(0.0, 1.0)]);
        for found in &inner.solutions {
            let (here, there) = (holds(found, place), holds(of(&wide, found.impacts, found.periods), place));
            // Borders are drawn to 1e-4 of the window.
            let beside = [-1.0, 1.0].map(|side| holds(found, [place[0] + 1e-3 * side, place[1]]));
            if beside == [here; 2] && here.is_some() && there.is_some() {
                assert_eq!(here, there, "{} in {} at {place:?}", found.impacts, found.periods);
                compared += 1;
            }
        }
    }
    assert!(compared > 2_000, "{compared}");
}

#[test]
fn curves_of_doubled_solutions_end_where_these_become_solutions_of_half_the_time() {
    let (diagram, all) = found(&scope([0.3, 1.3], [0.35, 1.02], &[1, 2]), &[1, 2]);
    // Two impacts in two periods branch off MPSs, four off two impacts a period.
    let mut halved = 0;
    for found in &all.solutions {
        let equations = diagram.equations(found.periods);
        for curve in &found.curves {
            assert_eq!(curve.loops, found.periods);
            let [first, last] =
                [0, curve.curve.points.len() - 1].map(|end| &curve.curve.points[end].solution);
            let ends = [(curve.curve.beginning.as_ref(), first), (Some(&curve.curve.end), last)];
            for (_, solution) in ends.into_iter().filter(|(end, _)| matches!(end, Some(CurveEnd::Halved))) {
                let apart = equations.after_a_part(&solution.unknowns, 2).expect("it can be halved");
                assert!(apart.norm() < 1e-7, "{solution:?}");
                // The multiplier −1 of the shorter one, squared.
                let at_one = 1.0 - solution.multipliers.trace + solution.multipliers.determinant;
                assert!(at_one.abs() < 1e-6, "{solution:?}");
                halved += 1;
            }
            let inner = &curve.curve.points[1..curve.curve.points.len() - 1];
            assert!(inner.iter().all(|point| !equations.recurs_sooner(&point.solution.unknowns)));
        }
    }
    assert!(halved > 0);
    let kinds = [Bifurcation::SaddleNode, Bifurcation::PeriodDoubling, Bifurcation::Grazing];
    assert!(kinds.iter().all(|kind| of(&all, 2, 1).curves.iter().any(|curve| curve.kind == *kind)));
}

#[test]
fn nothing_is_sought_in_the_first_generation_or_where_nothing_hits_the_wall() {
    let window = scope([0.6, 1.0], [0.6, 0.75], &[1]);
    let diagram = Diagram::compute(&closed_form(), &window, &Silent).expect("it grazes");
    assert!(sequences(&diagram, &[1, 2], 1, &Silent).solutions.is_empty());
    assert!(sequences(&diagram, &[], 2, &Silent).solutions.is_empty());
    // Strong damping.
    let damped = Diagram::located(&linear(0.9, 0.3, [0.5, 0.8]), &window, &Silent).expect("it moves");
    assert!(sequences(&damped, &[1], 2, &Silent).resonances.is_empty());
}
