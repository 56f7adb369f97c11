//! Links from the page to source files.

use std::fs;
use std::path::{Path, PathBuf};

use grazing_claims::source::Sources;
use grazing_input::read_file;

use crate::folder::with_slashes;

/// The source files of the repository that can be read.
pub(crate) fn sources(root: &Path) -> Sources {
    let mut files = Vec::new();
    let mut folders = vec![PathBuf::from("crates")];
    while let Some(folder) = folders.pop() {
        let Ok(entries) = fs::read_dir(root.join(&folder)) else {
            continue;
        };
        for entry in entries.flatten() {
            let path = folder.join(entry.file_name());
            if root.join(&path).is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs")
                && let Ok(text) = read_file(&root.join(&path))
            {
                files.push((with_slashes(&path), text));
            }
        }
    }
    Sources::new(files)
}

/// The file and the key that give the address of the repository.
const CITATION: &str = "CITATION.cff";
const KEY: &str = "repository-code:";
/// The path from the address to the newest files, as on the common hosts.
const NEWEST: &str = "blob/HEAD/";

/// The address of the repository's files at its host, with a slash at its end, if the citation file
/// names the host.
pub(crate) fn files_at_host(root: &Path) -> Option<String> {
    address(&read_file(&root.join(CITATION)).ok()?)
}

fn address(citation: &str) -> Option<String> {
    let link = citation.lines().find_map(|line| line.strip_prefix(KEY))?;
    let link = link.split(" #").next()?.trim().trim_matches(['"', '\'']).trim_end_matches('/');
    let link = link.strip_suffix(".git").unwrap_or(link);
    link.strip_prefix("https://").filter(|place| !place.is_empty()).map(|_| format!("{link}/{NEWEST}"))
}

#[cfg(test)]
mod tests {
    use grazing_claims::checks::CHECKS;
    use grazing_claims::ledger::Ledger;

    use super::*;

    #[test]
    fn the_address_is_that_of_the_citation_file() {
        let found = Some("https://example.org/a/b/blob/HEAD/".to_owned());
        for link in [
            "\"https://example.org/a/b\"",
            "https://example.org/a/b.git # host",
            "'https://example.org/a/b/'",
        ] {
            let citation = format!("title: x\nrepository-code: {link}\nurl: https://other.org\n");
            assert_eq!(address(&citation), found, "{link}");
        }
        for none in
            ["title: x\n", "repository-code:\n", "repository-code: a/b\n", "  repository-code: https://a.b\n"]
        {
            assert_eq!(address(none), None, "{none}");
        }
    }
    fn of_the_workspace() -> Sources {
        sources(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../.."))
    }

    #[test]
    fn every_function_that_the_ledger_names_is_where_its_path_says() {
        let sources = of_the_workspace();
        let ledger = Ledger::of_the_paper();
        for claim in &ledger.claims {
            for path in &claim.holds {
                assert!(sources.item(path).is_some(), "{}: there is no {path}", claim.label);
            }
        }
    }

    #[test]
    fn every_check_is_where_its_name_says() {
        let sources = of_the_workspace();
        for check in CHECKS {
            let place = sources.check(check.name).unwrap_or_else(|| panic!("{} is not found", check.name));
            let section = check.name.split("::").next().unwrap_or_default();
            assert!(place.file.starts_with(&format!("crates/claims/src/checks/{section}")), "{place:?}");
        }
    }

    #[test]
    fn items_of_all_kinds_are_found() {
        let sources = of_the_workspace();
        for (path, file) in [
            ("grazing_theorems::auxiliary::resonance_boundary", "crates/theorems/src/auxiliary.rs"),
            ("grazing_theorems::ResonantGrazing", "crates/theorems/src/resonant_theorem.rs"),
            ("grazing_claims::outcome::Measure::Order", "crates/claims/src/outcome.rs"),
            ("grazing_claims::ledger::Claim::label", "crates/claims/src/ledger.rs"),
            ("grazing_claims::ledger::Claim::test", "crates/claims/src/ledger.rs"),
        ] {
            let place = sources.item(path).unwrap_or_else(|| panic!("{path} is not found"));
            assert_eq!(place.file, file, "{path}");
        }
        for path in
            ["grazing_theorems::auxiliary::no_such_function", "grazing_nothing::at_all", "std::mem::swap"]
        {
            assert_eq!(sources.item(path), None, "{path}");
        }
    }
}
