//! Tests of the outcomes that pass, and of those that count as nothing tested.

use grazing_claims::outcome::{Measure, Outcome};

const RIGHT: Measure = Measure::Deviation { largest: 1e-15, tolerance: 1e-12 };
const WRONG: Measure = Measure::Deviation { largest: 1e-3, tolerance: 1e-12 };

#[test]
fn a_misprint_passes_only_if_the_print_is_wrong_and_nothing_where_nothing_was_looked_at() {
    assert!(Outcome::new(RIGHT, 1, "").passes());
    assert!(Outcome::new(RIGHT, 1, "").against_print(WRONG).passes());
    assert!(!Outcome::new(RIGHT, 1, "").against_print(RIGHT).passes());
    assert!(!Outcome::new(WRONG, 1, "").against_print(WRONG).passes());
    assert!(!Outcome::new(RIGHT, 0, "").passes());
}

#[test]
fn what_is_not_a_number_does_not_hold_nor_what_has_no_cases() {
    let nan = f64::NAN;
    for measure in [
        Measure::Deviation { largest: nan, tolerance: 1.0 },
        Measure::Order { observed: nan, stated: 2.0, slack: 0.3 },
        Measure::Order { observed: f64::INFINITY, stated: 2.0, slack: 0.3 },
        Measure::Margin { smallest: nan },
        Measure::Margin { smallest: f64::INFINITY },
        Measure::Agreement { agreeing: 0, cases: 0 },
    ] {
        assert!(!measure.holds(), "{measure:?}");
    }
}
