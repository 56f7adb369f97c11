//! The program, the tests and the package for Python are compiled with the same features and the same optimisation of every library.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::process::Command;
use std::{env, fs};

use toml::{Table, Value};

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
    let program = compiled(&["--package", "grazing-cli", "--edges", "normal,build"]);
    let all = compiled(&["--workspace", "--edges", "normal,build,dev"]);
    assert!(program.len() > 200, "{}", program.len());
    let others: Vec<_> = program.difference(&all).collect();
    assert!(others.is_empty(), "with other features among the tests, see Cargo.toml: {others:#?}");
}

/// The profile of development in the manifest of a folder, and the level of optimisation of each package that it names.
fn profile(folder: &str) -> (Table, BTreeMap<String, i64>) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder).join("Cargo.toml");
    let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let manifest: Table = text.parse().expect("it is TOML");
    let mut profile = manifest["profile"]["dev"].as_table().expect("it is a table").clone();
    let packages = profile.remove("package").expect("packages have levels of their own");
    let level = |(name, package): (&String, &Value)| {
        assert_eq!(package.as_table().expect("it is a table").len(), 1, "{name}");
        (name.clone(), package["opt-level"].as_integer().expect("it is a number"))
    };
    (profile, packages.as_table().expect("it is a table").iter().map(level).collect())
}

/// Otherwise the package would compile nearly everything once more. Crates of this workspace are other people's libraries to its
/// workspace, so that it names all of them.
#[test]
fn the_package_for_python_is_compiled_as_the_program_is() {
    let (own, levels) = profile("..");
    let (other, package) = profile("../packaging/python");
    assert_eq!(own, other);
    let usual = own["opt-level"].as_integer().expect("it is a number");
    for (name, level) in &package {
        let here = if name.starts_with("grazing-") { usual } else { levels["*"] };
        assert_eq!(levels.get(name).unwrap_or(&here), level, "{name}");
    }
    // Nothing that the package is made of may be left out.
    let program = compiled(&["--package", "grazing-cli", "--edges", "normal"]);
    let parts = program.iter().filter_map(|line| line.split(' ').next());
    let named = |name: &&str| name.starts_with("grazing-") || levels.contains_key(*name);
    let missing: Vec<&str> = parts.filter(named).filter(|name| !package.contains_key(*name)).collect();
    assert!(missing.is_empty(), "packaging/python/Cargo.toml: {missing:?}");
}
