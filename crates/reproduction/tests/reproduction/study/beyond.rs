//! Beyond the paper: rows against routes that share nothing with them.

use grazing_reproduction::Study;
use grazing_reproduction::figures::beyond_loops::BeyondLoops;
use grazing_reproduction::figures::beyond_proofs::BeyondProofs;
use grazing_reproduction::figures::beyond_regions::BeyondRegions;
use grazing_theorems::auxiliary::scaled_visit_position;

use super::{integers, made, numbers, theory, words};

#[test]
fn coefficients_of_more_loops_are_those_measured_on_the_curves() {
    let shown = Study::new(&made().parameters).shown::<BeyondLoops>().expect("it can be computed");
    let column = |name: &str| numbers(&shown.measured, name);
    let mut resolved = 0;
    for end in ["slowest", "fastest"] {
        let [closed, fit] = ["", "_fit"].map(|kind| column(&format!("c_{end}{kind}")));
        for (closed, fit) in closed.iter().zip(&fit).filter(|(_, fit)| !fit.is_nan()) {
            assert!((fit / closed - 1.0).abs() < 2e-5, "{closed} {fit}");
            resolved += 1;
        }
    }
    assert!(resolved > 75, "{resolved}");
}

#[test]
fn two_loop_curves_of_figure_7_begin_with_these_coefficients() {
    let shown = Study::new(&made().parameters).shown::<BeyondLoops>().expect("it can be computed");
    let zeta = theory().damping_ratio();
    let curves = &made().fig07.curves;
    let (kinds, loops) = (words(curves, "kind"), integers(curves, "p"));
    let [omegas, amplitudes, velocities] =
        ["omega", "amplitude", "impact_velocity"].map(|name| numbers(curves, name));
    let mut seen = 0;
    for row in shown.measured.iter().filter(|row| row.loops == 2 && row.zeta.to_bits() == zeta.to_bits()) {
        let resonance = theory().resonance(1, row.n).expect("it is there").forcing_frequency();
        // μ/η² is as the coefficient but for terms of first order in y; at smaller η it is rounding.
        let near =
            |k: &usize| (1e-5..4e-4).contains(&(omegas[*k] - resonance).abs()) && velocities[*k] < 0.03;
        for k in (0..curves.len()).filter(|&k| loops[k] == 2).filter(near) {
            let eta = omegas[k] - resonance;
            let grazing = theory().grazing(omegas[k]).expect("it grazes").amplitude();
            let expected = if kinds[k] == "GZ" { row.to } else { row.from };
            let found = (amplitudes[k] - grazing) / (eta * eta);
            assert!(
                (found / expected - 1.0).abs() < 0.1,
                "{} n = {} {eta}: {found} {expected}",
                kinds[k],
                row.n
            );
            seen += 1;
        }
    }
    assert!(seen >= 8, "{seen}");
}

#[test]
fn all_visits_are_before_the_wall_inside_of_regions_and_one_is_not_beside_them() {
    let shown = Study::new(&made().parameters).shown::<BeyondRegions>().expect("it can be computed");
    let mut seen = 0;
    for row in
        shown.levels.iter().filter(|row| (0.1..0.999).contains(&row.delta) && row.high - row.low > 1e-6)
    {
        let sign = if 2 * row.turns <= row.loops { 1.0 } else { -1.0 };
        let before = |tau: f64| {
            (1..row.loops).all(|j| sign * scaled_visit_position(j, row.loops, tau, row.delta) < 0.0)
        };
        let width = row.high - row.low;
        assert!(before(0.5 * (row.low + row.high)), "{row:?}");
        for beside in [row.low - 0.01 * width, row.high + 0.01 * width] {
            if beside.abs() < 1.0 + row.delta {
                assert!(!before(beside), "{row:?} {beside}");
                seen += 1;
            }
        }
    }
    assert!(seen > 1000, "{seen}");
}

#[test]
fn what_is_drawn_in_figure_7_lies_where_it_is_proved_to_be() {
    let shown = Study::new(&made().parameters).shown::<BeyondProofs>().expect("it can be computed");
    assert!(shown.undecided.is_empty(), "{:?}", shown.undecided);
    let count = |object: &str| shown.items.iter().filter(|item| item.object == object).count();
    assert_eq!([count("point"), count("region")], [25, 12]);
    for item in &shown.items {
        // A corner may lie beyond the end of a stretch by rounding.
        assert!(item.within + u32::from(item.object != "point") >= item.drawn, "{item:?}");
        assert!(item.object == "point" || item.width <= 1e-6, "{item:?}");
    }
}
