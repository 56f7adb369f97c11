//! Solutions of more loops: coefficients in closed form, and on the curves of Figure 7.

use grazing_beyond::loops::BeyondLoops;
use grazing_continuation::bifurcation::Bifurcation;
use grazing_reproduction::figures::fig07::Figure7;
use grazing_results::plane::PlanePoint;
use grazing_results::{Names, Tables};

use super::{study, theory};

#[test]
fn coefficients_of_more_loops_are_those_measured_on_the_curves() {
    let shown = study().shown::<BeyondLoops>().expect("it can be computed");
    let tables = shown.tables(&Names::of_the_paper());
    let measured = tables.last().expect("there are measurements");
    let column = |name: &str| {
        let cells = measured.column(name).expect("the column is there");
        cells.map(|cell| cell.number().unwrap_or(f64::NAN)).collect::<Vec<_>>()
    };
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
    let shown = study().shown::<BeyondLoops>().expect("it can be computed");
    let zeta = theory().damping_ratio();
    let figure = study().shown::<Figure7>().expect("it can be computed");
    let mut seen = 0;
    for row in shown.measured.iter().filter(|row| row.loops == 2 && row.zeta.to_bits() == zeta.to_bits()) {
        let resonance = theory().resonance(1, row.n).expect("it is there").forcing_frequency();
        // μ/η² equals the coefficient up to terms of first order in y; at smaller η it is dominated by
        // rounding.
        let near = |point: &&PlanePoint| {
            let eta = point.at.secondary - resonance;
            point.loops == 2 && (1e-5..4e-4).contains(&eta.abs()) && point.at.impact_velocity < 0.03
        };
        for point in figure.curves.iter().filter(near) {
            let eta = point.at.secondary - resonance;
            let grazing = theory().grazing(point.at.secondary).expect("it grazes").amplitude();
            let expected = if point.kind == Bifurcation::Grazing { row.to } else { row.from };
            let found = (point.at.primary - grazing) / (eta * eta);
            assert!(
                (found / expected - 1.0).abs() < 0.1,
                "{point:?} n = {} {eta}: {found} {expected}",
                row.n
            );
            seen += 1;
        }
    }
    assert!(seen >= 8, "{seen}");
}
