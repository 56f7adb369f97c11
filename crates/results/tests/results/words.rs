//! Motion in words.

use grazing_results::place::{loops, struck};

#[test]
fn impacts_and_rests_are_counted_and_infinitely_many_impacts_are_chatter() {
    for (periods, rates, words) in [
        (2.0, [1.5, 0.0], "3 impacts in 2 periods"),
        (1.0, [1.0, 1.0], "1 impact and a rest in 1 period"),
        (3.0, [1.0, 2.0 / 3.0], "3 impacts and 2 rests in 3 periods"),
        (1.0, [f64::INFINITY, 1.0], "chatter and a rest in 1 period"),
        (2.0, [f64::INFINITY, 1.0], "chatter and 2 rests in 2 periods"),
    ] {
        assert_eq!(struck(periods, rates), words);
        assert_eq!(loops(periods, rates), None, "{words}");
    }
    // A plastic impact that rests is no MPS; one that leaves the wall at once is.
    assert_eq!([loops(1.0, [1.0, 1.0]), loops(1.0, [1.0, 0.0])], [None, Some(1)]);
}
