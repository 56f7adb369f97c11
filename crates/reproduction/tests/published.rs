//! How computed values are held against the paper's print. The numbers here are invented, none is the paper's.

use std::collections::BTreeMap;

use grazing_reproduction::published::{Published, PublishedError};

fn entry(id: &str, value: &str, rounding: &str) -> String {
    format!(
        "[[value]]\nid = \"{id}\"\nquantity = \"q\"\nlabel = \"eq:q\"\nwhere = \"here\"\nvalue = \"{value}\"\n\
         rounding = \"{rounding}\"\n"
    )
}

fn is_met(printed: &str, rounding: &str, computed: f64) -> bool {
    let published = Published::parse(&entry("q", printed, rounding)).expect("a valid list");
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
    let published = Published::parse(&entry("q", "1.5", "significant")).expect("a valid list");
    let comparisons = published.compare(&BTreeMap::new());
    assert_eq!((comparisons[0].computed, comparisons[0].difference()), (None, None));
    assert!(!comparisons[0].is_met());
}

#[test]
fn computed_values_that_are_not_printed_are_passed_over() {
    let published = Published::parse(&entry("q", "1.5", "significant")).expect("a valid list");
    let comparisons = published.compare(&BTreeMap::from([("q".to_owned(), 1.5), ("r".to_owned(), 1.0)]));
    assert_eq!(comparisons.len(), 1);
    assert!(comparisons[0].is_met());
}

#[test]
fn a_list_with_a_repeated_id_or_an_undecimal_value_is_rejected() {
    let twice = format!("{0}{0}", entry("q", "1.5", "significant"));
    assert_eq!(Published::parse(&twice), Err(PublishedError::Twice { id: "q".to_owned() }));
    for wrong in ["", "-", "1.", ".5", "1e3", "nan", "+1", "1,5", "1.5.2"] {
        let result = Published::parse(&entry("q", wrong, "significant"));
        assert!(matches!(result, Err(PublishedError::NotDecimal { .. })), "{wrong}: {result:?}");
    }
    let misspelt = entry("q", "1.5", "significant").replace("quantity", "quantitty");
    assert!(matches!(Published::parse(&misspelt), Err(PublishedError::Unreadable { line: 3, .. })));
}

#[test]
fn the_list_of_the_repository_is_valid_and_cites_the_paper() {
    let published = Published::printed().expect("expected/published.toml is valid");
    assert!(!published.values.is_empty());
    for value in &published.values {
        let known = ["eq:", "fig:", "sub:", "th:", "pr:", "le:"];
        assert!(known.iter().any(|prefix| value.label.starts_with(prefix)), "{}: {}", value.id, value.label);
        assert!(!value.place.is_empty() && !value.quantity.is_empty(), "{}", value.id);
    }
}
