//! Tests of the comparison of computed values with the paper's print. The numbers here are invented; none
//! is the paper's.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use grazing_claims::published::{Published, PublishedValue, Rounding, Tally};

use crate::files::rust_files;

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
fn what_is_computed_is_counted_apart_from_what_is_read_back() {
    let mut published = list("q", "1.5", "significant");
    published.values.extend(list("r", "0.5", "exact").values);
    let told = |q, r| {
        let computed = BTreeMap::from([("q".to_owned(), q), ("r".to_owned(), r)]);
        Tally::of(&published.compare(&computed)).to_string()
    };
    assert_eq!(told(1.5, 0.5), "All 1 computed published values are met; 1 more are parameters");
    let one = |met, inputs| {
        format!("{met} of 1 computed published values are met, and {inputs} of 1 that are parameters")
    };
    assert_eq!((told(1.6, 0.5), told(1.5, 0.6)), (one(0, 1), one(1, 0)));
    assert!(!Tally::default().is_complete(), "nothing is no proof");
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

/// The numbers of a text without signs, each with the text between it and the previous one.
fn numbers(text: &str) -> Vec<(&str, &str)> {
    let is_of_number = |c: char| c.is_ascii_digit() || c == '.' || c == '_';
    let (mut found, mut end) = (Vec::new(), 0);
    for (start, _) in text.match_indices(|c: char| c.is_ascii_digit()) {
        if start < end {
            continue;
        }
        let between = &text[end..start];
        let rest = &text[start..];
        end = start + rest.find(|c| !is_of_number(c)).unwrap_or(rest.len());
        // Digits within a name are not a number.
        if !between.ends_with(|c: char| c.is_alphanumeric() || c == '_') {
            found.push((between, text[start..end].trim_end_matches(['.', '_'])));
        }
    }
    found
}

/// The number of significant digits of a printed number.
fn digits(printed: &str) -> usize {
    printed.replace(['-', '.'], "").trim_start_matches('0').len()
}

#[test]
fn no_number_of_the_paper_stands_in_code() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut files = Vec::new();
    ["crates", "xtask", "examples"].iter().for_each(|folder| rust_files(&root.join(folder), &mut files));
    assert!(files.len() > 300, "{}", files.len());
    let values = &Published::printed().values;
    // Numbers with few digits may occur anywhere; the constants of the paper's oscillator may not occur
    // together.
    let (long, short): (Vec<&PublishedValue>, Vec<_>) =
        values.iter().partition(|value| digits(&value.printed) > 2);
    let [damping, restitution] = short[..] else { panic!("{short:?}") };
    assert!(short.iter().all(|value| value.rounding == Rounding::Exact), "{short:?}");
    let mut found = Vec::new();
    for file in &files {
        let text = fs::read_to_string(file).expect("a source file");
        let numbers = numbers(&text);
        let is = |number: &str, value: &PublishedValue| {
            number.replace('_', "") == value.printed.trim_start_matches('-')
        };
        let complain = |what: String| format!("{}: {what}", file.display());
        for value in &long {
            let there = numbers.iter().any(|(_, number)| is(number, value));
            found.extend(there.then(|| complain(format!("{} = {}", value.id, value.printed))));
        }
        // Tests and benchmarks may use any oscillators, including this one.
        if file.components().any(|part| ["tests", "benches"].iter().any(|name| part.as_os_str() == *name)) {
            continue;
        }
        let pairs = numbers.iter().zip(numbers.iter().skip(1));
        let of_the_paper = |((_, first), (between, second)): (&(&str, &str), &(&str, &str))| {
            is(first, damping) && is(second, restitution) && !between.contains([')', ']', '}', ';'])
        };
        found.extend(pairs.clone().any(of_the_paper).then(|| complain("the paper's oscillator".to_owned())));
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn numbers_are_found_in_code_by_their_digits() {
    let text = "f(0.12, -3.5e4, [x2; 1_000.]) // 7.25.";
    let found: Vec<&str> = numbers(text).into_iter().map(|(_, number)| number).collect();
    assert_eq!(found, ["0.12", "3.5", "1_000", "7.25"]);
    assert_eq!(["0.02", "0.9", "0.123", "-12.34"].map(digits), [1, 1, 3, 4]);
}
