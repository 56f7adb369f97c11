//! The ledger is complete.

use std::collections::{BTreeMap, BTreeSet};

use grazing_claims::checks;
use grazing_claims::ledger::{Claim, Ledger};

/// The labels of the paper with their places.
fn labels() -> BTreeMap<&'static str, &'static str> {
    let lines = include_str!("../../../expected/labels.txt").lines().filter(|line| !line.starts_with('#'));
    lines.map(|line| line.split_once(' ').expect("a label and a place")).map(|(l, p)| (l, p.trim())).collect()
}

fn ledger() -> Ledger {
    Ledger::of_the_paper().unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn every_label_of_the_paper_stands_in_the_ledger_at_its_place() {
    let (labels, ledger) = (labels(), ledger());
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
fn every_check_is_asked_for_by_a_claim() {
    let ledger = ledger();
    let used: BTreeSet<&str> = ledger.claims.iter().filter_map(Claim::check_name).collect();
    let idle: Vec<_> = checks::all().map(|check| check.name).filter(|name| !used.contains(name)).collect();
    assert!(idle.is_empty(), "{idle:?}");
}
