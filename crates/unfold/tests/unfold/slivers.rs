//! Regions, however narrow, in windows and in parts of them, compared with the closed form.

use grazing_continuation::bifurcation::Bifurcation;
use grazing_continuation::curve::Window;
use grazing_model::{AnyOscillator, LinearOscillator};
use grazing_trials::lines;
use grazing_trials::random::Random;
use grazing_unfold::progress::Silent;
use grazing_unfold::{Diagram, Scope};

const FIGURE_7: Window = Window { primary: [0.0, 1.3], secondary: [0.35, 1.02] };

fn diagram(window: Window, loops: &[u32]) -> Diagram {
    let oscillator = LinearOscillator::new(0.02, 0.9, 0.5, 0.8).expect("it is in the domain");
    let scope = Scope { window, loops: loops.to_vec(), start: None };
    Diagram::compute(&AnyOscillator::new(oscillator), &scope, &Silent).expect("there are solutions")
}

#[test]
fn slivers_of_two_loops_are_found_in_any_window_and_without_p_1() {
    // Their locations, by an independent program: from the resonances of n = 5 and 3.
    let slivers = [[0.399937, 0.406456], [0.666553, 0.675530]];
    let small = Window { primary: [0.4, 0.8], secondary: [0.6, 0.7] };
    for (window, loops) in [(FIGURE_7, &[1, 2, 3][..]), (FIGURE_7, &[2]), (small, &[2, 3])] {
        let diagram = diagram(window, loops);
        for [low, high] in slivers.into_iter().filter(|[low, _]| *low > window.secondary[0]) {
            for share in [0.3, 0.6, 0.9] {
                let omega = low + (high - low) * share;
                let exact = lines::exact(0.02, 0.9, window.primary, omega, 2).expect("there is a sliver");
                let [shaded, _] = lines::shown(&diagram.regions, 2, omega);
                let is_there = |[from, to]: &[f64; 2]| {
                    // Up to the chords between vertices at which curves were located.
                    (from - exact[0]).abs().max((to - exact[1]).abs()) < 1e-4
                        && ((to - from) / (exact[1] - exact[0]) - 1.0).abs() < 0.1
                };
                assert!(shaded.iter().any(is_there), "{window:?} {omega}: {shaded:?}, {exact:?}");
            }
        }
        assert!(diagram.regions.iter().all(|region| region.doubt.is_none()));
    }
}

#[test]
fn what_is_found_in_a_part_of_a_window_is_what_the_closed_form_has_there() {
    // More windows: `grazing-trials windows`.
    let mut random = Random::new(26);
    for [zeta, epsilon] in [[0.02, 0.9], [0.1, 0.7], [0.0131, 0.907]] {
        for part in 0..=10 {
            let window = if part == 0 { FIGURE_7 } else { lines::part(FIGURE_7, &mut random) };
            let outcome = lines::compare([zeta, epsilon], window, &[1, 2, 3], 100, &mut random);
            assert!(outcome.wrong.is_empty(), "{zeta} {epsilon} {window:?}: {:?}", outcome.wrong);
            assert!(outcome.hatched < 1e-3, "{window:?}: {}", outcome.hatched);
        }
    }
}

#[test]
fn a_curve_beside_grazing_ends_where_another_maximum_touches_the_wall_and_not_at_rest() {
    // A crescent of 1e-5 of the range, about a resonance. At y = 0, beside its curves, all maxima touch the wall.
    let window = Window { primary: [0.5356, 1.0336], secondary: [0.2864, 0.6559] };
    let outcome = lines::compare([0.12527, 0.3474], window, &[3], 500, &mut Random::new(31));
    assert!(outcome.wrong.is_empty(), "{:?}", outcome.wrong);
    assert_eq!(outcome.hatched, 0.0);
}

#[test]
fn what_enters_a_window_from_a_resonance_outside_of_it_is_found() {
    // A crescent of two loops lies between two of the first slices, and its resonance at 0.84; the others are the corner of a
    // crescent of three loops, and a tongue of one loop, whose resonances are farther from a narrow window than it is wide.
    let cases = [
        ([0.02209, 0.5089], [0.732, 0.79], [0.389, 1.088]),
        ([0.23053, 0.4492], [0.4207, 0.4489], [0.2765, 1.0645]),
        ([0.00461, 0.4187], [0.3438, 0.5848], [0.3133, 1.1286]),
    ];
    for (constants, primary, secondary) in cases {
        let window = Window { primary, secondary };
        let outcome = lines::compare(constants, window, &[1, 2, 3], 500, &mut Random::new(5));
        assert!(outcome.wrong.is_empty(), "{constants:?}: {:?}", outcome.wrong);
        assert_eq!(outcome.hatched, 0.0);
    }
}

#[test]
fn regions_that_begin_as_good_as_at_grazing_are_found_where_motion_is_strongly_damped() {
    // Saddle-nodes at impact velocities below 1e-6: their curve differs from the grazing curve by
    // 1e-12.
    let cases = [
        ([0.23437, 0.7167], [0.5164, 0.8869], [0.4578, 0.4799]),
        ([0.13219, 0.7928], [0.5, 1.2], [0.305, 0.33]),
    ];
    for ([zeta, epsilon], primary, secondary) in cases {
        let window = Window { primary, secondary };
        let exact = lines::exact(zeta, epsilon, primary, 0.5 * (secondary[0] + secondary[1]), 3);
        assert!(exact.is_some_and(|[from, to]| to - from > 1e-6), "{exact:?}");
        let outcome = lines::compare([zeta, epsilon], window, &[3], 50, &mut Random::new(1));
        assert!(outcome.wrong.is_empty(), "{zeta}: {:?}", outcome.wrong);
        assert_eq!(outcome.hatched, 0.0);
    }
}

#[test]
fn a_window_on_a_curve_far_from_grazing_shows_the_curve_and_the_region() {
    let whole = diagram(FIGURE_7, &[1, 2, 3]);
    let mut seen = 0;
    for curve in whole.curves.iter().filter(|curve| curve.loops > 0 && curve.curve.points.len() > 20) {
        let at = curve.curve.points[curve.curve.points.len() / 2].solution.parameters();
        for width in [1e-2, 1e-5] {
            let range = |middle: f64| [middle - 0.6 * width, middle + 0.4 * width];
            let window = Window { primary: range(at[0]), secondary: range(at[1]) };
            let part = diagram(window, &[curve.loops]);
            let same = part.curves.iter().filter(|found| found.kind == curve.kind);
            let near = same.flat_map(|found| found.curve.parameters()).any(|point| {
                let gap = [0, 1].map(|k| ((point[k] - at[k]) / width).abs());
                gap[0].max(gap[1]) < 0.6
            });
            // GZ curves between unstable solutions bound nothing.
            let bounds = curve.kind != Bifurcation::Grazing
                || part.regions.iter().any(|region| region.loops == curve.loops);
            assert!(near || !bounds, "{:?} p = {} {window:?}", curve.kind, curve.loops);
            seen += usize::from(near && part.grazing.is_empty());
        }
    }
    assert!(seen >= 10, "{seen}");
}

#[test]
fn a_tongue_that_comes_in_and_goes_out_at_the_edge_within_a_step_is_found() {
    // A tongue of period-doubled motion; along the edge 1 + T + D is negative by 5e-5, between two
    // points of a branch at which it is positive.
    let window = Window {
        primary: [0.771862183388759, 1.0540204522049585],
        secondary: [0.6791468505514304, 1.0638965454289793],
    };
    let outcome = lines::compare([0.00369, 0.9931], window, &[1], 500, &mut Random::new(1));
    assert!(outcome.wrong.is_empty(), "{:?}", outcome.wrong);
    assert_eq!(outcome.hatched, 0.0);
}

#[test]
fn an_island_beyond_the_end_of_a_curve_is_found_where_no_slice_crosses_it() {
    // Along the PD curve motion of two loops hits the wall in between from omega = 0.4946 to
    // 0.4980, except in this island, which is bounded by the curve and by grazing.
    let window = Window { primary: [0.77, 1.2], secondary: [0.325, 0.51] };
    let oscillator = LinearOscillator::new(0.00767, 0.5847, 1.0, 0.4).expect("it is in the domain");
    let scope = Scope { window, loops: vec![2], start: None };
    let diagram = Diagram::compute(&AnyOscillator::new(oscillator), &scope, &Silent).expect("it grazes");
    for omega in [0.4961, 0.4962, 0.4963] {
        let exact = lines::exact(0.00767, 0.5847, window.primary, omega, 2).expect("the island");
        let [shaded, _] = lines::shown(&diagram.regions, 2, omega);
        let [[from, to]] = shaded.as_slice() else { panic!("{omega}: {shaded:?}, {exact:?}") };
        assert!((from - exact[0]).abs().max((to - exact[1]).abs()) < 3e-5, "{omega}: {shaded:?}, {exact:?}");
    }
    for omega in [0.495, 0.497] {
        assert_eq!(lines::exact(0.00767, 0.5847, window.primary, omega, 2), None);
        assert!(lines::shown(&diagram.regions, 2, omega).iter().all(Vec::is_empty));
    }
}

#[test]
fn a_sliver_between_two_grazing_curves_is_one_region_up_to_their_corner() {
    // The sliver is bounded by a PD curve and by GZ curves of two maxima, which meet at an angle of
    // less than 1e-3.
    let window = Window { primary: [0.0, 2.0], secondary: [0.25, 1.3] };
    let oscillator = LinearOscillator::new(0.0069, 0.8293, 1.0, 0.4).expect("it is in the domain");
    let scope = Scope { window, loops: vec![2], start: None };
    let diagram = Diagram::compute(&AnyOscillator::new(oscillator), &scope, &Silent).expect("it grazes");
    assert!(diagram.regions.iter().all(|region| region.doubt.is_none()));
    let omega = 0.499_848_11;
    let exact = lines::exact(0.0069, 0.8293, window.primary, omega, 2).expect("the sliver");
    let [shaded, _] = lines::shown(&diagram.regions, 2, omega);
    let length = |intervals: &[[f64; 2]]| intervals.iter().map(|[from, to]| to - from).sum::<f64>();
    assert!((length(&shaded) - length(&[exact])).abs() < 1e-3, "{shaded:?} {exact:?}");
}

#[test]
fn curves_of_two_loops_are_followed_where_motion_hardly_loses_energy() {
    // Beside n = 2, where η changes by 1e-7 while y changes by 1e-3.
    let window = Window { primary: [0.0, 0.1], secondary: [0.95, 1.05] };
    let oscillator = LinearOscillator::new(0.001, 1.0, 0.05, 1.0).expect("it is in the domain");
    let scope = Scope { window, loops: vec![2], start: None };
    let diagram = Diagram::compute(&AnyOscillator::new(oscillator), &scope, &Silent).expect("it grazes");
    assert!(diagram.not_unfolded.is_empty(), "{:?}", diagram.not_unfolded);
    assert!(diagram.regions.iter().all(|region| region.doubt.is_none()));
    let curves = diagram.curves.iter().filter(|curve| curve.kind == Bifurcation::Grazing);
    assert_eq!(curves.count(), 1);
}
