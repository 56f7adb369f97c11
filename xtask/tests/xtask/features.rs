//! The program, the package for Python and the tests are compiled with the same features of every library.

use std::collections::BTreeSet;
use std::env;
use std::process::Command;

/// The libraries and crates that cargo compiles for a selection of packages, each with its features.
fn compiled(selection: &[&str]) -> BTreeSet<String> {
    let run = Command::new(env!("CARGO"))
        .args(["tree", "--locked", "--offline", "--prefix", "none", "--format", "{p} {f}"])
        .args(selection)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .expect("cargo starts");
    let messages = String::from_utf8_lossy(&run.stderr);
    assert!(run.status.success(), "{messages}");
    let text = String::from_utf8(run.stdout).expect("cargo writes UTF-8");
    // A star marks what was listed before.
    text.lines().map(|line| line.trim_end_matches(" (*)").to_owned()).collect()
}

/// Otherwise `cargo test` would compile them once more after `cargo xtask`.
#[test]
fn libraries_of_the_program_have_the_features_that_tests_need() {
    let all = compiled(&["--workspace", "--edges", "normal,build,dev"]);
    for package in ["grazing-cli", "grazing-python"] {
        let program = compiled(&["--package", package, "--edges", "normal,build"]);
        assert!(program.len() > 200, "{}", program.len());
        let others: Vec<_> = program.difference(&all).collect();
        assert!(others.is_empty(), "with other features among the tests, see Cargo.toml: {others:#?}");
    }
}
