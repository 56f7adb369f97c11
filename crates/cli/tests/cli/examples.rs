//! The results of every oscillator in examples/, to the last bit.

use std::fs;
use std::path::{Path, PathBuf};

use crate::program::{empty_folder, grazing, repository, snapshots};

/// Whether a file is a table or a figure; the page and the explanations change with the versions of
/// libraries and with words.
fn is_result(path: &str) -> bool {
    path.ends_with(".csv") || path.ends_with(".svg")
}

/// The files of the examples, in the order of their names.
fn files() -> Vec<PathBuf> {
    let examples = fs::read_dir(repository().join("examples")).expect("there are examples");
    let paths = examples.map(|entry| entry.expect("they can be read").path());
    let mut files: Vec<_> = paths.filter(|path| path.extension().is_some_and(|end| end == "toml")).collect();
    files.sort();
    files
}

fn name(file: &Path) -> &str {
    file.file_stem().and_then(|name| name.to_str()).expect("it has a plain name")
}

/// The digests of all tables and figures in a folder of results.
fn digests(folder: &Path, name: &str) -> String {
    let list = fs::read_to_string(folder.join(name).join("manifest.sha256")).expect("it is written");
    let lines = list.lines().filter_map(|line| line.split_once("  "));
    lines
        .filter(|(_, path)| is_result(path))
        .map(|(digest, path)| format!("{digest}  {name}/{path}\n"))
        .collect()
}

/// Settings for a small window around the first resonance of an example at which a theorem applies, as
/// `expected/example_NAME.snap` has it, with the p of that resonance alone; without a resonance the whole window,
/// which is quick then.
fn about_a_resonance(name: &str) -> Vec<String> {
    let without_diagrams = "diagrams=[]".to_owned();
    let set = |settings: Vec<String>| -> Vec<String> {
        settings.into_iter().flat_map(|setting| ["--set".to_owned(), setting]).collect()
    };
    let path = format!("expected/example_{name}.snap");
    let text = fs::read_to_string(repository().join(&path)).expect("every example has a snapshot");
    let Some(line) = text.lines().find(|line| line.contains(", c_SN")) else {
        return set(vec![without_diagrams]);
    };
    let after = |word: &str| -> f64 {
        let rest = line.split_once(word).expect("the line has it").1;
        rest.split([',', ':']).next().and_then(|number| number.trim().parse().ok()).expect("a number follows")
    };
    let (loops, eta, mu) = (after("p = "), after("eta "), after(", mu "));
    let range = |key: &str, at: f64, share: f64| {
        format!("{key}.range=[{}, {}]", (1.0 - share) * at, (1.0 + share) * at)
    };
    set(vec![
        range("primary", mu, 0.1),
        range("secondary", eta, 0.02),
        format!("analysis.loops=[{loops}]"),
        without_diagrams,
    ])
}

/// After a change that is meant to move numbers:
///
/// ```text
/// INSTA_UPDATE=always GRAZING_EXAMPLES=whole cargo test -p grazing-cli --test cli examples
/// ```
///
/// With GRAZING_EXAMPLES=whole every example is computed in its whole ranges, which takes some minutes of CPU, and
/// otherwise around one of its resonances.
#[test]
fn no_table_and_no_figure_of_an_example_changes_unnoticed() {
    let folder = empty_folder();
    let run = |place: &str, arguments: &[String]| {
        let begin = ["unfold", "--output", place];
        let arguments: Vec<&str> = begin.into_iter().chain(arguments.iter().map(String::as_str)).collect();
        let outcome = grazing(folder.path(), &arguments);
        assert_eq!((outcome.code, outcome.errors()), (Some(0), ""), "{}", outcome.messages);
    };
    let files = files();
    let named = |file: &PathBuf| file.to_str().expect("the repository has a plain name").to_owned();
    let is_whole = std::env::var_os("GRAZING_EXAMPLES").is_some_and(|which| which == "whole");
    if is_whole {
        run(".", &files.iter().map(named).collect::<Vec<_>>());
        let svg = [repository().join("examples/duffing.svg"), folder.path().join("duffing/diagram.svg")];
        let [shown, computed] = svg.map(|path| fs::read(path).expect("it is there"));
        assert!(shown == computed, "examples/duffing.svg is not what the code computes");
    } else {
        for file in &files {
            run(name(file), &[vec![named(file)], about_a_resonance(name(file))].concat());
        }
    }
    let all: String = files.iter().map(|file| digests(folder.path(), name(file))).collect();
    let snapshot = if is_whole { "example_digests" } else { "example_digests_about_resonances" };
    snapshots().bind(|| insta::assert_snapshot!(snapshot, all));
}
