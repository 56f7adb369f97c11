//! Compares figures at parameters other than the paper's with the closed form.

use std::sync::Arc;

use grazing_beyond::parameters;
use grazing_continuation::bifurcation::Bifurcation;
use grazing_input::{Setting, Text};
use grazing_reproduction::Study;
use grazing_reproduction::figures::fig02::Figure2;
use grazing_reproduction::figures::fig07::Figure7;
use grazing_reproduction::parameters::Parameters;
use grazing_results::branches::{BranchPoint, OneParameter};
use grazing_results::plane::CurveSource;
use grazing_trials::closed_form::orbits;

use super::made;

const DEFAULT: &str = include_str!("../../../../../figures/parameters.toml");

/// The parameters with some values set.
fn with(settings: &[&str]) -> Parameters {
    let settings: Vec<Setting> = settings.iter().map(|text| text.parse().expect("it is a setting")).collect();
    parameters::parse(&Text::new(DEFAULT, &settings), "parameters.toml").expect("the values are valid")
}

fn fig02(settings: &[&str]) -> Arc<OneParameter> {
    Study::new(&with(settings)).shown::<Figure2>().expect("it can be computed")
}

/// Branch points with impacts at which solutions are stable and admissible.
fn good(figure: &OneParameter, loops: u32) -> Vec<BranchPoint> {
    let good = |point: &&BranchPoint| point.loops == loops && point.stable.is_stable() && point.admissible;
    figure.branches.iter().filter(good).cloned().collect()
}

#[test]
fn a_branch_that_leaves_figure_2_and_comes_back_is_there() {
    // It folds to the left of the window.
    let settings =
        ["oscillator.zeta=0.05", "oscillator.epsilon=0.5", "fig02.frequency=1.2", "fig02.x=[-3,3]"];
    let points = good(&fig02(&settings), 1);
    let amplitudes = || points.iter().map(|point| point.primary);
    assert!(amplitudes().fold(f64::INFINITY, f64::min) < 0.4413 && amplitudes().fold(0.0, f64::max) > 0.5757);
    for point in &points {
        let known = orbits(0.05, 0.5, point.primary, 1.2, 1);
        assert!(known.iter().any(|orbit| (orbit.velocity - point.impact_velocity).abs() < 1e-9));
    }
    // The fold of p = 3 lies to the left of this one, and its grazing inside.
    let settings = ["fig02.amplitude=[0.272,0.342]", "fig02.magnification.amplitude=[0.2725,0.2748]"];
    let figure = fig02(&settings);
    assert!(!good(&figure, 3).is_empty());
    let shown = |kind: Bifurcation| figure.bifurcations.iter().filter(move |found| found.kind == kind);
    assert!(shown(Bifurcation::Grazing).any(|found| found.loops == 3));
    assert!(figure.notes.iter().all(|note| !note.contains("no such portrait")), "{:?}", figure.notes);
}

#[test]
fn no_grazing_bifurcation_is_seen_where_branches_begin() {
    for settings in [
        &["fig02.frequency=0.79", "fig02.loops=[1,2,3,4,5]"][..],
        &["oscillator.zeta=0.05", "oscillator.epsilon=0.7", "fig02.frequency=0.72", "fig02.loops=[1,2,3,4]"],
    ] {
        let figure = fig02(settings);
        for found in figure.bifurcations.iter().filter(|found| found.kind == Bifurcation::Grazing) {
            assert!(found.impact_velocity > 1e-3, "{settings:?}: {found:?}");
        }
    }
}

#[test]
fn curves_of_a_panel_of_figure_8_have_the_p_and_n_of_figure_7() {
    let made = made();
    let continued = made.fig08.curves.iter().filter(|point| point.source == CurveSource::Continuation);
    let mut of_other_loops = 0;
    for point in continued {
        let panel = &made.fig08.panels[point.panel as usize - 1];
        of_other_loops += u32::from(point.loops != panel.loops && point.loops != 0);
        let there = made
            .fig07
            .curves
            .iter()
            .any(|known| (known.kind, known.loops, known.n) == (point.kind, point.loops, point.n));
        assert!(there, "{point:?}");
    }
    assert!(of_other_loops > 0);
}

#[test]
fn the_linear_oscillator_has_no_cusps() {
    let settings = [
        "oscillator.zeta=0.00585",
        "oscillator.epsilon=0.7",
        "fig07.frequency=[1.3589,4.9175]",
        "fig07.amplitude=[0,44.708]",
        "fig07.loops=[1,2,3]",
    ];
    let shown = Study::new(&with(&settings)).shown::<Figure7>().expect("it can be computed");
    let points = &shown.points;
    assert!(points.len() > 3 && points.iter().all(|point| point.kind.name() != "cusp"));
}

#[test]
fn what_is_lost_in_rounding_contradicts_nothing() {
    let parameters = with(&["oscillator.zeta=1e-5"]);
    let study = Study::new(&parameters);
    let rows = &study.coefficients().expect("they can be computed").rows;
    assert!(!rows.is_empty() && rows.iter().all(|row| !row.contradict()));
}
