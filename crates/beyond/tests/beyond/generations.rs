//! Resonances of motion with impacts: theorems and curves.

use grazing_beyond::generations::BeyondGenerations;
use grazing_continuation::bifurcation::CodimensionTwo;
use grazing_reproduction::figures::fig07::Figure7;

use super::study;

#[test]
fn resonances_of_motion_with_impacts_have_the_coefficients_that_are_measured() {
    let shown = study().shown::<BeyondGenerations>().expect("it can be computed");
    let (hold, fail): (Vec<_>, Vec<_>) = shown.resonances.iter().partition(|row| row.fails.is_empty());
    assert!(hold.len() >= 9 && !fail.is_empty());
    for row in hold {
        assert_eq!((row.impacts, row.periods), (row.rounds + 1, row.rounds * row.base_loops));
        let pairs = [
            (row.saddle_node, row.saddle_node_fit, row.saddle_node_error),
            (row.period_doubling, row.period_doubling_fit, row.period_doubling_error),
        ];
        for (theorem, fit, error) in pairs {
            assert!((theorem - fit).abs() <= 3.0 * error + 1e-9 * fit.abs(), "{row:?}");
        }
        // Curves leave it.
        let of_it = shown.curves.iter().filter(|point| point.number == row.number);
        assert!(
            of_it
                .clone()
                .any(|point| (point.primary - row.primary).abs() < 1e-9 && point.impact_velocity == 0.0)
        );
        assert!(of_it.count() > 20, "{row:?}");
    }
    // κ_q vanishes where a₁₂ has the wrong sign: the solutions go through the wall.
    assert!(fail.iter().all(|row| row.rounds >= 2 && row.off_diagonal < 0.0));
    assert_eq!(shown.panels.len(), 3);
    assert!(shown.missing.is_empty(), "{:?}", shown.missing);
    // Where the impact elsewhere loses its velocity, at the end of a GZ curve on a resonance, P_global is not smooth.
    let figure = study().shown::<Figure7>().expect("it can be computed");
    let resonances = figure.points.iter().filter(|point| point.kind == CodimensionTwo::Resonance);
    let ends: Vec<[f64; 2]> = resonances.map(|point| [point.primary, point.secondary]).collect();
    for lost in &shown.unlocated {
        let at_end = |end: &[f64; 2]| (0..2).all(|k| (end[k] - lost.near[k]).abs() < 1e-3);
        assert!(ends.iter().any(at_end), "{lost:?}");
    }
}
