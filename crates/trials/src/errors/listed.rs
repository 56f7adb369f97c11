//! The list of deliberate errors.

use std::path::{Path, PathBuf};
use std::{fs, io};

use serde::Deserialize;

/// One deliberate error.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DeliberateError {
    /// A description of the error in words.
    pub meaning: String,
    /// The file, from the root of the project.
    pub file: PathBuf,
    /// The text to replace, which occurs once in the file.
    pub find: String,
    /// The replacement text.
    pub replace: String,
}

#[derive(Deserialize)]
struct List {
    error: Vec<DeliberateError>,
}

/// An error of input and output: what a file contains is wrong.
pub(super) fn invalid(message: String) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, message)
}

/// Reads the list of errors, and checks that each of them can be introduced.
///
/// # Errors
/// A file cannot be read, or the text to replace does not occur in it exactly once.
pub fn list(root: &Path) -> io::Result<Vec<DeliberateError>> {
    let text = fs::read_to_string(root.join("expected/deliberate_errors.toml"))?;
    let List { error } = toml::from_str(&text).map_err(|error| invalid(error.to_string()))?;
    for DeliberateError { file, find, meaning, .. } in &error {
        let times = fs::read_to_string(root.join(file))?.matches(find.as_str()).count();
        if times != 1 {
            return Err(invalid(format!("{meaning}: stands {times} times in {}", file.display())));
        }
    }
    Ok(error)
}
