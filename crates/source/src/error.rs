//! What can be wrong with a file.

use thiserror::Error;

use crate::words::suggestion;

/// The first thing in a file that is not right, and what would be.
///
/// Keys are written with dots, members of a list of tables counted from 1: `fig08.panels[2].loops`. Values are given as
/// the file writes them.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum SourceError {
    /// The file is not there, is no text, or may not be read.
    #[error("{file}: cannot be read: {reason}")]
    Unreadable {
        /// The file.
        file: String,
        /// What the system says.
        reason: String,
    },
    /// The file is not TOML.
    #[error("{file}:{line}:{column}: this is not TOML: {reason}")]
    Syntax {
        /// The file.
        file: String,
        /// The line, from 1.
        line: usize,
        /// The character in the line, from 1.
        column: usize,
        /// What the TOML reader says.
        reason: String,
    },
    /// A key that means nothing here, most often a misspelt one.
    #[error("{}: unknown key {key}{} Known here: {}", place(file, *line), suggestion(nearest.as_deref()), known.join(", "))]
    UnknownKey {
        /// The file, or the setting.
        file: String,
        /// The line, from 1; 0 for a setting.
        line: usize,
        /// The key with all that leads to it.
        key: String,
        /// The known key that is spelt like it, if there is one.
        nearest: Option<String>,
        /// All keys that are known in this place.
        known: Vec<String>,
    },
    /// A key that must be there and is not.
    #[error("{}: {key} is missing: {allowed}", place(file, *line))]
    MissingKey {
        /// The file.
        file: String,
        /// The line, from 1, of the table that lacks the key, which is 1 at the top level; the last line for a table that
        /// is missing itself.
        line: usize,
        /// The key with all that leads to it.
        key: String,
        /// What has to be written there.
        allowed: String,
    },
    /// A value of the wrong type, outside its domain, or at odds with another value.
    #[error("{}: {key} = {value}: {allowed}", place(file, *line))]
    Forbidden {
        /// The file, or the setting.
        file: String,
        /// The line, from 1; 0 for a setting.
        line: usize,
        /// The key with all that leads to it.
        key: String,
        /// The value as the file writes it.
        value: String,
        /// What is allowed.
        allowed: String,
    },
}

/// A file and a line as messages have them; a setting has no line.
pub(crate) fn place(file: &str, line: usize) -> String {
    if line == 0 { file.to_owned() } else { format!("{file}:{line}") }
}
