//! Links from the page to source files.

use std::fs;
use std::path::{Component, Path, PathBuf};

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

/// The address of `to` as seen from a page in the folder `from`, with a slash at its end, or nothing if they are the same.
pub(crate) fn relative(from: &Path, to: &Path) -> Option<String> {
    let (from, to) = (plain(from)?, plain(to)?);
    let common = from.iter().zip(&to).take_while(|(a, b)| a == b).count();
    // Different drives have no common beginning, and no address leads from one to the other.
    if common == 0 {
        return None;
    }
    let mut address = "../".repeat(from.len() - common);
    for part in &to[common..] {
        address.push_str(&encoded(part));
        address.push('/');
    }
    Some(address)
}

/// The parts of the absolute path, without `.` and `..`.
fn plain(path: &Path) -> Option<Vec<String>> {
    let path = if path.as_os_str().is_empty() { Path::new(".") } else { path };
    let mut parts = Vec::new();
    for part in std::path::absolute(path).ok()?.components() {
        match part {
            Component::CurDir => {}
            Component::ParentDir => {
                parts.pop();
            }
            part => parts.push(part.as_os_str().to_str()?.to_owned()),
        }
    }
    Some(parts)
}

/// The name with what has a meaning of its own in addresses as `%` and digits.
fn encoded(name: &str) -> String {
    let mut encoded = String::new();
    for character in name.chars() {
        match character {
            ' ' | '%' | '#' | '?' | '"' | '<' | '>' => {
                encoded.push_str(&format!("%{:02X}", u32::from(character)));
            }
            other => encoded.push(other),
        }
    }
    encoded
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses_lead_up_and_down() {
        let relative = |from: &str, to: &str| relative(Path::new(from), Path::new(to));
        assert_eq!(relative("/a/b", "/a/b").as_deref(), Some(""));
        assert_eq!(relative("/a/b/c/d", "/a/b").as_deref(), Some("../../"));
        assert_eq!(relative("/a/x", "/a/my clone").as_deref(), Some("../my%20clone/"));
        assert_eq!(relative("", "..").map(|address| address.starts_with("../")), Some(true));
        assert_eq!(relative("here/../out", "").as_deref(), Some("../"));
    }
}
