//! The results of every oscillator in examples/, to the last bit.

use std::fs;

use crate::program::{empty_folder, grazing, repository, snapshots};

/// Whether a file is a table or a figure; the page and the explanations change with the versions of
/// libraries and with their wording.
fn is_result(path: &str) -> bool {
    path.ends_with(".csv") || path.ends_with(".svg")
}

/// Accepts new results, after a change that moves numbers on purpose, with
///
/// ```text
/// INSTA_UPDATE=always cargo test -p grazing-cli --test cli examples
/// ```
#[test]
fn no_table_and_no_figure_of_an_example_changes_unnoticed() {
    let folder = empty_folder();
    let examples = fs::read_dir(repository().join("examples")).expect("there are examples");
    let paths = examples.map(|entry| entry.expect("they can be read").path());
    let mut files: Vec<_> = paths.filter(|path| path.extension().is_some_and(|end| end == "toml")).collect();
    files.sort();
    let named = files.iter().map(|file| file.to_str().expect("the repository has a plain name"));
    let line: Vec<&str> = ["unfold", "--output", "."].into_iter().chain(named).collect();
    let outcome = grazing(folder.path(), &line);
    assert_eq!((outcome.code, outcome.errors()), (Some(0), ""), "{}", outcome.messages);
    let mut digests = String::new();
    for file in &files {
        let name = file.file_stem().expect("it has a name").to_str().expect("it is plain");
        let list =
            fs::read_to_string(folder.path().join(name).join("manifest.sha256")).expect("it is written");
        for (digest, path) in list.lines().filter_map(|line| line.split_once("  ")) {
            if is_result(path) {
                digests.push_str(&format!("{digest}  {name}/{path}\n"));
            }
        }
    }
    snapshots().bind(|| insta::assert_snapshot!("example_digests", digests));
    let [shown, made] =
        [repository().join("examples/duffing.svg"), folder.path().join("duffing/diagram.svg")]
            .map(|path| fs::read(path).expect("it is there"));
    assert!(
        shown == made,
        "examples/duffing.svg, which docs/oscillator.md shows, is not what the code makes"
    );
}
