//! The versions of the program, and of the compiler and the libraries that built it.

use std::collections::BTreeMap;

use grazing_report::Manifest;
use serde::Deserialize;

const LOCK: &str = include_str!("../../../Cargo.lock");

/// A manifest with the versions alone.
pub(crate) fn manifest() -> Manifest {
    let program = format!("grazing {}", env!("CARGO_PKG_VERSION"));
    Manifest { program, rust: COMPILER.to_owned(), libraries: libraries(), ..Manifest::default() }
}

/// The program, by its version and the digest from `build.rs` of what its numbers depend on.
pub(crate) fn program() -> String {
    concat!("grazing ", env!("CARGO_PKG_VERSION"), " of source ", env!("GRAZING_SOURCE")).to_owned()
}

/// The version of the compiler that built the program, as `build.rs` found it.
const COMPILER: &str = env!("GRAZING_COMPILER");

/// The parts of `Cargo.lock` that are read.
#[derive(Default, Deserialize)]
struct Lock {
    package: Vec<Package>,
}

#[derive(Deserialize)]
struct Package {
    name: String,
    version: String,
    /// The source of a library; a crate of the workspace has none.
    source: Option<String>,
    /// The names of dependencies, with the version where there are several.
    #[serde(default)]
    dependencies: Vec<String>,
}

/// The libraries that the crates of the workspace use themselves, those of the tests included, with
/// their versions.
fn libraries() -> Vec<(String, String)> {
    let lock: Lock = toml::from_str(LOCK).unwrap_or_default();
    let (libraries, own): (Vec<_>, Vec<_>) =
        lock.package.into_iter().partition(|package| package.source.is_some());
    let library = |dependency: &String| {
        let mut words = dependency.split(' ');
        let (name, version) = (words.next()?, words.next());
        let is_meant =
            |known: &&Package| known.name == name && version.is_none_or(|given| known.version == given);
        libraries.iter().find(is_meant).map(|found| (found.name.clone(), found.version.clone()))
    };
    let used: BTreeMap<_, _> =
        own.iter().flat_map(|package| &package.dependencies).filter_map(library).collect();
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
    fn the_compiler_is_at_least_the_one_that_the_workspace_asks_for() {
        let parts =
            |version: &str| -> Vec<u32> { version.split('.').filter_map(|part| part.parse().ok()).collect() };
        assert!(parts(COMPILER) >= parts(env!("CARGO_PKG_RUST_VERSION")), "{COMPILER}");
    }
}
