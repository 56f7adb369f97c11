//! Compares diagrams of parts of a window with that of the whole;
//! `cargo run -p grazing-trials -- windows FILE...` tests more parts of any oscillator.

use grazing_trials::lines;
use grazing_trials::parts::{Difference, Has, compare, part};
use grazing_trials::random::Random;

use crate::DIAGRAM as WHOLE;

#[test]
fn what_is_found_does_not_depend_on_the_window() {
    let mut random = Random::new(3);
    let (mut agreed, mut common) = (0, 0.0);
    for _ in 0..4 {
        let window = lines::part(WHOLE.scope.window, &mut random);
        let outcome = compare(&WHOLE, window, part(&WHOLE, window).as_ref(), 200, &mut random);
        assert_eq!(outcome.differences, [], "{window:?}");
        assert_eq!(outcome.hatched, [0.0; 2], "{window:?}");
        agreed += outcome.agreed;
        common += outcome.common;
    }
    assert!(agreed > 1000 && common > 1.0, "{agreed} {common}");
}

#[test]
fn what_one_diagram_lacks_is_noticed() {
    let window = WHOLE.scope.window;
    let mut less = WHOLE.clone();
    let lost =
        less.curves.iter().position(|curve| curve.curve.points.len() > 20).expect("there are long ones");
    less.curves.remove(lost);
    less.resonances.remove(0);
    less.regions.retain(|region| region.loops != 1);
    let mut random = Random::new(1);
    let outcome = compare(&WHOLE, window, Some(&less), 200, &mut random);
    let verdicts = |has: Has| {
        let of = |it: &&Difference| matches!(it, Difference::Verdict(which, 1, _) if *which == has);
        outcome.differences.iter().filter(of).count()
    };
    assert!(verdicts(Has::Whole) > 20 && verdicts(Has::Part) == 0, "{:?}", outcome.differences);
    let missing = outcome.differences.iter().filter(|it| matches!(it, Difference::Missing(Has::Whole, ..)));
    assert_eq!(missing.count(), 2, "{:?}", outcome.differences);
    assert!(compare(&less, window, Some(&WHOLE), 0, &mut random).differences.len() == 2);
    // An empty diagram lacks everything.
    assert!(compare(&WHOLE, window, None, 200, &mut random).differences.len() > 20);
}
