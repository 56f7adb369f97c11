//! Shaded regions of nonlinear oscillators against continuation and simulation; `cargo run --release -p grazing-trials -- nonlinear` takes the
//! examples and many more, on a finer lattice.

use grazing_description::Description;
use grazing_trials::nonlinear::{Disagreement, compare, unfolded};
use grazing_trials::oscillators;
use grazing_unfold::regions::{Region, RegionKind};

/// A random oscillator of seed 1: the spring that stiffens.
fn stiffening(loops: &[u32]) -> Description {
    let text = oscillators::description(1, 10);
    let description = Description::parse(&text, "random").expect("what is made at random is right");
    description.with_loops(loops).expect("they are right")
}

#[test]
fn what_is_shaded_is_where_continuation_finds_solutions_and_motion_settles() {
    let diagram = unfolded(&stiffening(&[1, 2])).expect("it grazes");
    let outcome = compare(&diagram, 10, 2);
    assert_eq!(outcome.wrong, []);
    assert_eq!(outcome.hatched, 0.0, "{:?}", outcome.doubts);
    assert!(outcome.confirmed > 40 && outcome.seen > 40, "{outcome:?}");
}

#[test]
fn wrong_shading_is_noticed() {
    let mut diagram = unfolded(&stiffening(&[1])).expect("it grazes");
    let right = compare(&diagram, 8, 1);
    assert_eq!(right.wrong, []);
    let regions = core::mem::take(&mut diagram.regions);
    let white = compare(&diagram, 8, 1);
    assert!(white.count(Disagreement::FoundUnshaded) >= right.confirmed);
    assert!(white.count(Disagreement::SeenUnshaded) > 0);
    let [[left, right], [low, high]] = [diagram.scope.window.primary, diagram.scope.window.secondary];
    let rings = vec![vec![[left, low], [right, low], [right, high], [left, high]]];
    diagram.regions = vec![Region { kind: RegionKind::Mps, loops: 1, n: 0, rings }];
    let grey = compare(&diagram, 8, 0);
    assert!(grey.count(Disagreement::NotFound) > 10, "{:?}", grey.wrong);
    assert_eq!(grey.count(Disagreement::FoundUnshaded), 0);
    // The share of the lattice that is shaded is all of it.
    assert!(grey.shaded > 0.99 && !regions.is_empty());
}

#[test]
fn random_oscillators_can_be_read_and_their_numbers_lead_to_others() {
    let texts: Vec<String> = (0..30).map(|number| oscillators::description(3, number)).collect();
    for (number, text) in texts.iter().enumerate() {
        Description::parse(text, "random").unwrap_or_else(|error| panic!("{number}: {error}\n{text}"));
        assert!(texts[..number].iter().all(|other| other != text));
    }
}
