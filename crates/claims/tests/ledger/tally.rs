//! Tallies: what is kept of many measurements.

use grazing_claims::outcome::{Measure, Outcome};
use grazing_claims::tally::{Deviations, Smallest, Votes};

fn deviations(values: &[f64], tolerance: f64) -> Outcome {
    Deviations::of(values.iter().copied()).outcome(tolerance, "")
}

fn margin(values: &[f64]) -> Outcome {
    let mut smallest = Smallest::default();
    values.iter().for_each(|value| smallest.see(*value));
    smallest.margin("")
}

#[test]
fn the_extreme_is_kept_and_what_is_not_a_number_stays() {
    let outcome = deviations(&[1.0, -3.0, 2.0], 3.0);
    assert_eq!(outcome, Outcome::new(Measure::Deviation { largest: 3.0, tolerance: 3.0 }, 3, ""));
    assert_eq!(margin(&[1.0, -3.0, 2.0]).measure, Measure::Margin { smallest: -3.0 });
    let spoiled = [1.0, f64::NAN, 2.0];
    assert!(!deviations(&spoiled, 10.0).passes() && !margin(&spoiled).passes());
}

#[test]
fn a_remainder_that_was_never_seen_and_a_broken_condition_count_against_the_statement() {
    let mut smallest = Smallest::default();
    smallest.see_resolved(2.0);
    assert!(smallest.order(2.0, 0.1, "").passes());
    smallest.see_resolved(f64::INFINITY);
    assert!(!smallest.order(2.0, 0.1, "").passes());
    let (mut deviations, mut smallest) = (Deviations::default(), Smallest::default());
    deviations.require(false);
    smallest.require(false);
    assert!(!deviations.measure(1.0).holds() && !smallest.margin("").passes());
}

#[test]
fn votes_count_both_sides() {
    let mut votes = Votes::of([true, false]);
    votes.silent();
    assert_eq!(votes.measure(), Measure::Agreement { agreeing: 1, cases: 2 });
    assert!(votes.outcome("").over.contains("silent on 1 more"));
}
