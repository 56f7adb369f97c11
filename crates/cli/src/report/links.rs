//! Links from the page to source files.

use std::fs;
use std::path::{Path, PathBuf};

use grazing_claims::source::Sources;

/// The source files of the repository; those that can be read.
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
                && let Ok(text) = fs::read_to_string(root.join(&path))
            {
                files.push((with_slashes(&path), text));
            }
        }
    }
    Sources::new(files)
}

/// The path with slashes between its parts, on any system.
pub(crate) fn with_slashes(path: &Path) -> String {
    path.components().map(|part| part.as_os_str().to_string_lossy()).collect::<Vec<_>>().join("/")
}

/// Where the address of the repository is looked up, and under which key.
const CITATION: &str = "CITATION.cff";
const KEY: &str = "repository-code:";
/// What leads from the address to the files of the newest state, as the common hosts have it.
const NEWEST: &str = "blob/HEAD/";

/// The address of the repository's files at its host, with a slash at its end, if the citation file names the host.
pub(crate) fn files_at_host(root: &Path) -> Option<String> {
    address(&fs::read_to_string(root.join(CITATION)).ok()?)
}

fn address(citation: &str) -> Option<String> {
    let told = citation.lines().find_map(|line| line.strip_prefix(KEY))?;
    let told = told.split(" #").next()?.trim().trim_matches(['"', '\'']).trim_end_matches('/');
    let told = told.strip_suffix(".git").unwrap_or(told);
    told.strip_prefix("https://").filter(|place| !place.is_empty()).map(|_| format!("{told}/{NEWEST}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_address_is_that_of_the_citation_file() {
        let found = Some("https://example.org/a/b/blob/HEAD/".to_owned());
        for told in [
            "\"https://example.org/a/b\"",
            "https://example.org/a/b.git # host",
            "'https://example.org/a/b/'",
        ] {
            let citation = format!("title: x\nrepository-code: {told}\nurl: https://other.org\n");
            assert_eq!(address(&citation), found, "{told}");
        }
        for none in
            ["title: x\n", "repository-code:\n", "repository-code: a/b\n", "  repository-code: https://a.b\n"]
        {
            assert_eq!(address(none), None, "{none}");
        }
    }
}
