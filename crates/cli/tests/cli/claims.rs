//! `grazing claims` tests the selected claims and prints the results.

use crate::program::{DEFAULT, edited, grazing, project};

#[test]
fn a_label_is_tested_and_told_of() {
    let project = project(DEFAULT);
    let outcome = grazing(project.path(), &["claims", "eq:gp", "--explain"]);
    assert_eq!(outcome.code, Some(0), "{}", outcome.messages);
    for told in ["holds", "eq:gp", "resonance_boundary", "grazing_claims::checks::", "1 claim: 1 hold"] {
        assert!(outcome.output.contains(told), "`{told}` is missing in\n{}", outcome.output);
    }
}

#[test]
fn a_star_chooses_all_labels_that_begin_alike() {
    let project = project(DEFAULT);
    let outcome = grazing(project.path(), &["claims", "pr:*"]);
    assert_eq!(outcome.code, Some(0), "{}", outcome.messages);
    for label in ["pr:oscAb", "pr:imp1", "pr:impp"] {
        assert!(outcome.output.contains(label), "{label} is missing in\n{}", outcome.output);
    }
    assert!(!outcome.output.contains(" eq:"), "{}", outcome.output);
}

#[test]
fn printed_numbers_are_held_against_the_parameters_in_use() {
    let project = project(&edited(DEFAULT, "[oscillator]", "zeta", "zeta = 0.021"));
    let outcome = grazing(project.path(), &["claims", "--kind", "number"]);
    assert_eq!(outcome.code, Some(1), "{}", outcome.messages);
    assert!(outcome.output.contains("FAILS"), "{}", outcome.output);
    assert!(outcome.errors().contains("claims do not hold"), "{}", outcome.messages);
}

#[test]
fn a_label_that_is_not_there_is_bad_input() {
    let project = project(DEFAULT);
    let outcome = grazing(project.path(), &["claims", "eq:nosuch"]);
    assert_eq!(outcome.code, Some(2));
    assert!(outcome.errors().contains("no claim matches eq:nosuch"), "{}", outcome.messages);
    assert_eq!(outcome.output, "");
}
