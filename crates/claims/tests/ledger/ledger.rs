//! Tests that the ledger is complete.

use std::collections::{BTreeMap, BTreeSet};

use grazing_claims::ledger::{Claim, Ledger, Test};
use grazing_claims::published::Published;

/// The labels of the paper with their places.
fn labels() -> BTreeMap<&'static str, &'static str> {
    let lines = include_str!("../../../../expected/labels.txt").lines().filter(|line| !line.starts_with('#'));
    lines.map(|line| line.split_once(' ').expect("a label and a place")).map(|(l, p)| (l, p.trim())).collect()
}

#[test]
fn every_label_of_the_paper_stands_in_the_ledger_at_its_place() {
    let (labels, ledger) = (labels(), Ledger::of_the_paper());
    assert!(labels.len() > 100);
    let listed: BTreeMap<&str, &Claim> =
        ledger.claims.iter().map(|claim| (claim.label.as_str(), claim)).collect();
    let missing: Vec<_> = labels.keys().filter(|label| !listed.contains_key(*label)).collect();
    assert!(missing.is_empty(), "missing in expected/claims.toml: {missing:?}");
    for (label, place) in labels {
        assert!(
            listed[label].place.starts_with(place),
            "{label}: {} instead of {place}",
            listed[label].place
        );
    }
}

#[test]
fn parameters_of_the_paper_are_not_counted_as_comparisons() {
    let ledger = Ledger::of_the_paper();
    let given = ledger.claims.iter().filter(|claim| matches!(claim.test(), Test::Given(_)));
    let given: Vec<&str> = given.map(|claim| claim.label.as_str()).collect();
    assert_eq!(given, ["fig:Z/parameters", "sub:2/parameters", "fig:G/parameters"]);
    for claim in &ledger.claims {
        if let Test::Published(ids) = claim.test() {
            assert!(!ids.iter().any(|id| Published::is_parameter(id)), "{}", claim.label);
        }
    }
}

#[test]
fn every_claim_stands_there_once_and_is_tested_in_one_way() {
    let ledger = Ledger::of_the_paper();
    let mut before = BTreeSet::new();
    for claim in &ledger.claims {
        let label = &claim.label;
        assert!(before.insert(label), "expected/claims.toml: {label} stands there twice");
        assert!(claim.has_one_test(), "{label} needs exactly one of check, published and unchecked");
        if let Test::Check(check) = claim.test() {
            assert_eq!(check.name.split("::").count(), 3, "{}: section, module and function", check.name);
        }
        if let Some(other) = claim.misprint.as_ref().and_then(|misprint| misprint.same_as.as_ref()) {
            assert!(before.contains(other), "{label}: the misprint of {other} is not listed before it");
        }
    }
}
