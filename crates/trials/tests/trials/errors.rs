//! Deliberate errors: each can be introduced, and the table keeps earlier results.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use grazing_trials::errors::{DeliberateError, SeenBy, TABLE, list, table};

#[test]
fn every_error_can_be_put_in() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let list = list(&root).unwrap_or_else(|error| panic!("{error}"));
    assert!(list.len() >= 150);
    assert!(list.iter().all(|error| error.find != error.replace));
    let read = |file: &str| std::fs::read_to_string(root.join(file)).expect("it is there");
    let (validation, tried) = (read("docs/validation.md"), read(TABLE));
    // By whom: `3 claims: ...`, `1 test: ...`; frozen tests alone are not enough.
    let seen: Vec<&str> =
        tried.lines().filter_map(|line| line.trim_end_matches(" |").rsplit_once(" | ")?.1.into()).collect();
    let by = |who: &str| {
        seen.iter().filter(|cell| cell.split(' ').nth(1).is_some_and(|it| it.starts_with(who))).count()
    };
    let (claims, tests) = (by("claim"), by("test"));
    let trial = "`cargo run -p grazing-trials -- errors` with the numbers of the others";
    assert_eq!(claims + tests, list.len(), "some errors were not tried out, or are not seen: {trial}");
    let words = [
        format!("{} errors introduced into", list.len()),
        format!("all are caught, {claims} by claims, the others by tests"),
    ];
    for words in words {
        assert!(validation.contains(&words), "docs/validation.md does not say `{words}`");
    }
}

#[test]
fn rows_that_were_not_tried_out_stay() {
    let error = |meaning: &str| DeliberateError {
        meaning: meaning.to_owned(),
        file: PathBuf::new(),
        find: String::new(),
        replace: String::new(),
    };
    let list = [error("first"), error("second")];
    let once = table("", &list, &BTreeMap::from([(1, SeenBy::Claims(vec!["eq:A".to_owned()]))]));
    assert!(once.contains("| 1 | first | 1 claim: `eq:A` |") && once.contains("| 2 | second | not tried"));
    let twice = table(&once, &list, &BTreeMap::from([(2, SeenBy::Unseen)]));
    assert!(
        twice.contains("| 1 | first | 1 claim: `eq:A` |") && twice.contains("| 2 | second | **nobody** |")
    );
}
