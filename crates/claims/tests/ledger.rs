//! The ledger is complete, and what it says holds.

use std::collections::{BTreeMap, BTreeSet};

use grazing_claims::audit::{Verdict, audit};
use grazing_claims::checks;
use grazing_claims::ledger::{Claim, Ledger, Test};

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

/// Whether the claim is misprinted in a way that has values.
fn decided_by_computation(claim: &Claim) -> bool {
    claim.misprint.as_ref().is_some_and(|misprint| !misprint.typographic)
}

#[test]
fn every_check_is_asked_for_by_a_claim() {
    let ledger = ledger();
    let used: BTreeSet<&str> = ledger.claims.iter().filter_map(Claim::check_name).collect();
    let idle: Vec<_> = checks::all().map(|check| check.name).filter(|name| !used.contains(name)).collect();
    assert!(idle.is_empty(), "{idle:?}");
}

#[test]
fn every_check_passes_and_every_misprint_is_decided() {
    let ledger = ledger();
    let measured: Vec<&Claim> =
        ledger.claims.iter().filter(|claim| matches!(claim.test(), Test::Check(_))).collect();
    assert!(!measured.is_empty());
    let mut failing = Vec::new();
    for finding in audit(&measured, |_| None, || {}) {
        let decided = match &finding.verdict {
            Verdict::Measured(outcome) => outcome.print.is_some() == decided_by_computation(finding.claim),
            _ => false,
        };
        if finding.verdict.fails() || !decided {
            failing.push(format!("{}: {:?}", finding.claim.label, finding.verdict));
        }
    }
    if std::env::var_os("SHOW").is_some() {
        for finding in audit(&measured, |_| None, || {}) {
            eprintln!(
                "TIME {:.2} {} {:?}",
                finding.time.as_secs_f64(),
                finding.claim.check_name().unwrap_or(""),
                finding.verdict
            );
        }
    }
    assert!(failing.is_empty(), "{}", failing.join("\n"));
}
