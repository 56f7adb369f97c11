//! `expected/` holds what the tests use and nothing else.

use std::fs;
use std::path::Path;

use crate::program::repository;

/// Files in `expected/` that are not snapshots.
const BY_HAND: [&str; 7] = [
    "published.toml",
    "published_examples.toml",
    "claims.toml",
    "labels.txt",
    "deliberate_errors.toml",
    "deliberate_errors.md",
    // The certificate has a check of its own.
    "certificate",
];

/// The test file that a snapshot names as its source.
fn source(snapshot: &str) -> Option<&str> {
    snapshot.lines().take_while(|line| !line.is_empty()).find_map(|line| line.strip_prefix("source: "))
}

#[test]
fn every_snapshot_is_used_by_the_test_that_made_it() {
    let folder = repository().join("expected");
    let mut snapshots = 0;
    for entry in fs::read_dir(&folder).expect("expected/ can be read") {
        let path = entry.expect("expected/ can be read").path();
        let file = path.file_name().and_then(|name| name.to_str()).expect("a name in UTF-8").to_owned();
        if BY_HAND.contains(&file.as_str()) {
            continue;
        }
        let name = file.strip_suffix(".snap");
        let name =
            name.unwrap_or_else(|| panic!("expected/{file} is neither a snapshot nor known here: remove it"));
        // Some tests put their module before the name.
        let name = name.rsplit("__").next().unwrap_or(name);
        let text = fs::read_to_string(&path).expect("a snapshot is text");
        let source =
            source(&text).unwrap_or_else(|| panic!("expected/{file} does not say where it comes from"));
        let test = fs::read_to_string(repository().join(Path::new(source)));
        let test = test.unwrap_or_else(|_| panic!("expected/{file}: {source} is gone: remove the snapshot"));
        assert!(
            mentions(&test, name),
            "expected/{file}: {source} does not use it any more: remove the snapshot"
        );
        snapshots += 1;
    }
    assert!(snapshots > 0, "snapshots were found");
}

/// Whether a name stands in the text as a whole word, such as in quotes or as the name of a function.
fn mentions(text: &str, name: &str) -> bool {
    let is_part = |byte: u8| byte.is_ascii_alphanumeric() || byte == b'_';
    text.match_indices(name).any(|(start, _)| {
        let before = start.checked_sub(1).map(|index| text.as_bytes()[index]);
        let after = text.as_bytes().get(start + name.len()).copied();
        !before.is_some_and(is_part) && !after.is_some_and(is_part)
    })
}

#[test]
fn a_name_is_mentioned_only_as_a_word_of_its_own() {
    assert!(mentions("assert_snapshot!(\"points\", text)", "points"));
    assert!(mentions("fn points() {}", "points"));
    assert!(!mentions("assert_snapshot!(\"fig07_points\", text)", "points"));
    assert!(!mentions("", "points"));
}
