//! The versions of the program, the compiler and the libraries, as the repository fixes them.

use std::collections::BTreeMap;

use grazing_report::Manifest;
use toml::{Table, Value};

const LOCK: &str = include_str!("../../../Cargo.lock");
const TOOLCHAIN: &str = include_str!("../../../rust-toolchain.toml");

/// A manifest with the versions alone.
pub(crate) fn manifest() -> Manifest {
    let program = format!("grazing {}", env!("CARGO_PKG_VERSION"));
    Manifest { program, rust: rust(), libraries: libraries(), ..Manifest::default() }
}

/// The version of the compiler.
fn rust() -> String {
    let version = TOOLCHAIN
        .parse::<Table>()
        .ok()
        .and_then(|file| Some(file.get("toolchain")?.get("channel")?.as_str()?.to_owned()));
    version.unwrap_or_default()
}

/// The libraries that the crates of the workspace use themselves, those of the tests included, with
/// their versions.
fn libraries() -> Vec<(String, String)> {
    let lock: Table = LOCK.parse().unwrap_or_default();
    let packages: Vec<&Value> = lock.get("package").and_then(Value::as_array).into_iter().flatten().collect();
    let text = |package: &Value, key: &str| package.get(key).and_then(Value::as_str).map(str::to_owned);
    let mut versions: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for package in packages.iter().filter(|package| package.get("source").is_some()) {
        if let (Some(name), Some(version)) = (text(package, "name"), text(package, "version")) {
            versions.entry(name).or_default().push(version);
        }
    }
    let mut used = BTreeMap::new();
    // What has no source is a crate of the workspace.
    for package in packages.iter().filter(|package| package.get("source").is_none()) {
        for dependency in package.get("dependencies").and_then(Value::as_array).into_iter().flatten() {
            // The version is given only where there are several.
            let mut words = dependency.as_str().unwrap_or_default().split(' ');
            let name = words.next().unwrap_or_default();
            let given = words.next().map(str::to_owned);
            let known = versions.get(name).and_then(|versions| versions.first().cloned());
            if let (true, Some(version)) = (versions.contains_key(name), given.or(known)) {
                used.insert(name.to_owned(), version);
            }
        }
    }
    used.into_iter().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_libraries_are_those_of_the_workspace() {
        let libraries = libraries();
        let version =
            |name: &str| libraries.iter().find(|library| library.0 == name).map(|library| &library.1);
        for name in ["libm", "nalgebra", "plotters", "polars", "rayon"] {
            assert!(version(name).is_some_and(|version| version.contains('.')), "{name}");
        }
        assert_eq!(version("polars-core"), None, "what libraries use themselves is left out");
        assert_eq!(version("grazing-model"), None);
    }

    #[test]
    fn the_compiler_is_the_pinned_one() {
        assert!(rust().split('.').count() == 3, "{}", rust());
    }
}
