//! Compares shaded regions of nonlinear oscillators with continuation and simulation;
//! `cargo run -p grazing-trials -- nonlinear` tests the examples and many more, on a finer
//! lattice.

use grazing_input::Description;
use grazing_trials::nonlinear::{Disagreement, compare};
use grazing_trials::oscillators;
use grazing_unfold::regions::Region;

use crate::DIAGRAM;

#[test]
fn what_is_shaded_is_where_continuation_finds_solutions_and_motion_settles() {
    let outcome = compare(&DIAGRAM, 8, 1);
    assert_eq!(outcome.wrong, []);
    assert_eq!(outcome.hatched, 0.0, "{:?}", outcome.doubts);
    // Half of the 64 points are shaded.
    assert!(outcome.confirmed > 20 && outcome.seen > 10, "{outcome:?}");
}

#[test]
fn wrong_shading_is_noticed() {
    let mut diagram = DIAGRAM.clone();
    diagram.scope.loops = vec![1];
    diagram.regions.clear();
    let white = compare(&diagram, 8, 1);
    assert!(white.count(Disagreement::FoundUnshaded) > 10, "{:?}", white.wrong);
    assert!(white.count(Disagreement::SeenUnshaded) > 0, "{:?}", white.wrong);
    let [[left, right], [low, high]] = [diagram.scope.window.primary, diagram.scope.window.secondary];
    let rings = vec![vec![[left, low], [right, low], [right, high], [left, high]]];
    diagram.regions = vec![Region { loops: 1, n: 0, rings, doubt: None }];
    let grey = compare(&diagram, 8, 0);
    assert!(grey.count(Disagreement::NotFound) > 10, "{:?}", grey.wrong);
    assert_eq!((grey.count(Disagreement::FoundUnshaded), grey.shaded), (0, 1.0));
}

#[test]
fn random_oscillators_can_be_read_and_their_numbers_lead_to_others() {
    let texts: Vec<String> = (0..30).map(|number| oscillators::description(3, number)).collect();
    for (number, text) in texts.iter().enumerate() {
        Description::parse(text, "random").unwrap_or_else(|error| panic!("{number}: {error}\n{text}"));
        assert!(texts[..number].iter().all(|other| other != text));
    }
}
