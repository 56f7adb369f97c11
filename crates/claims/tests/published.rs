//! How computed values are held against the paper's print. The numbers here are invented, none is
//! the paper's.

use std::collections::{BTreeMap, BTreeSet};

use grazing_claims::published::Published;

fn list(id: &str, value: &str, rounding: &str) -> Published {
    let list = format!(
        "[[value]]\nid = \"{id}\"\nquantity = \"q\"\nlabel = \"eq:q\"\nwhere = \"here\"\nvalue = \"{value}\"\n\
         rounding = \"{rounding}\"\n"
    );
    toml::from_str(&list).expect("a valid list")
}

fn is_met(printed: &str, rounding: &str, computed: f64) -> bool {
    let published = list("q", printed, rounding);
    let comparisons = published.compare(&BTreeMap::from([("q".to_owned(), computed)]));
    comparisons[0].is_met()
}

#[test]
fn a_value_is_met_when_it_rounds_to_the_printed_digits() {
    assert!(is_met("1.50", "significant", 1.5));
    assert!(is_met("1.50", "significant", 1.4951));
    assert!(is_met("1.50", "significant", 1.5049));
    assert!(!is_met("1.50", "significant", 1.4949));
    assert!(!is_met("1.50", "significant", 1.5051));
    assert!(is_met("-777.7", "significant", -777.7499));
    assert!(!is_met("-777.7", "significant", 777.7));
    assert!(is_met("10.00", "significant", 9.9951));
    assert!(!is_met("1.50", "significant", f64::NAN));
}

#[test]
fn trailing_zeros_of_the_print_count() {
    assert!(is_met("1.5", "significant", 1.54));
    assert!(!is_met("1.50", "significant", 1.54));
}

#[test]
fn a_chosen_number_must_be_met_exactly() {
    assert!(is_met("0.7", "exact", 0.7));
    assert!(!is_met("0.7", "exact", 0.70000001));
}

#[test]
fn a_value_that_was_not_computed_is_not_met() {
    let published = list("q", "1.5", "significant");
    let comparisons = published.compare(&BTreeMap::new());
    assert_eq!((comparisons[0].computed, comparisons[0].difference()), (None, None));
    assert!(!comparisons[0].is_met());
}

#[test]
fn computed_values_that_are_not_printed_are_passed_over() {
    let published = list("q", "1.5", "significant");
    let comparisons = published.compare(&BTreeMap::from([("q".to_owned(), 1.5), ("r".to_owned(), 1.0)]));
    assert_eq!(comparisons.len(), 1);
    assert!(comparisons[0].is_met());
}

#[test]
fn the_list_of_the_repository_is_valid_and_cites_the_paper() {
    let published = Published::printed();
    assert!(!published.values.is_empty());
    let mut seen = BTreeSet::new();
    for value in &published.values {
        assert!(seen.insert(&value.id), "{} stands there twice", value.id);
        let unsigned = value.printed.strip_prefix('-').unwrap_or(&value.printed);
        let mut parts = unsigned.splitn(2, '.');
        assert!(
            parts.all(|part| !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit())),
            "{}: {} is no number with its printed digits",
            value.id,
            value.printed
        );
        let known = ["eq:", "fig:", "sub:", "th:", "pr:", "le:"];
        assert!(known.iter().any(|prefix| value.label.starts_with(prefix)), "{}: {}", value.id, value.label);
        assert!(!value.place.is_empty() && !value.quantity.is_empty(), "{}", value.id);
    }
}
