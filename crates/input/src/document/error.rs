//! Errors in a file.

use std::fmt::{self, Display};

use serde::Serialize;

use super::words::suggestion;

/// The first error in a file, with its remedy.
///
/// Keys are written with dots, members of a list of tables counted from 1: `fig08.panels[2].loops`.
/// Values are given as written in the file.
#[derive(Debug, Clone, PartialEq)]
pub enum SourceError {
    /// The file does not exist, is not a text, or may not be read.
    Unreadable {
        /// The file.
        file: String,
        /// The message of the operating system.
        reason: String,
    },
    /// The file is not TOML.
    Syntax {
        /// The file.
        file: String,
        /// The line, from 1.
        line: usize,
        /// The character in the line, from 1.
        column: usize,
        /// The message of the TOML reader.
        reason: String,
    },
    /// A key without meaning here, most often a misspelt one.
    UnknownKey {
        /// The file, or the setting.
        file: String,
        /// The line, from 1; 0 for a setting.
        line: usize,
        /// The key with its full path.
        key: String,
        /// The known key that is spelt like it, if there is one.
        nearest: Option<Box<str>>,
        /// All keys that are known here.
        known: Vec<String>,
        /// What the table holds, if it has a name and no known key is spelt like this one.
        about: Option<Box<str>>,
    },
    /// A required key that is missing.
    MissingKey {
        /// The file.
        file: String,
        /// The line, from 1, of the table that lacks the key, which is 1 at the top level; the last
        /// line for a table that is missing itself.
        line: usize,
        /// The key with its full path.
        key: String,
        /// The requirement of the key.
        allowed: String,
    },
    /// A value of the wrong type, outside its domain, or inconsistent with another value.
    Forbidden {
        /// The file, or the setting.
        file: String,
        /// The line, from 1; 0 for a setting.
        line: usize,
        /// The key with its full path.
        key: String,
        /// The value as written in the file.
        value: String,
        /// The values that are allowed.
        allowed: String,
    },
}

impl std::error::Error for SourceError {}

impl Display for SourceError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Syntax { file, line, column, .. } => write!(formatter, "{file}:{line}:{column}")?,
            _ => write!(formatter, "{}", self.place())?,
        }
        write!(formatter, ": {}", self.reason())
    }
}

impl SourceError {
    /// The error without its place.
    fn reason(&self) -> String {
        match self {
            Self::Unreadable { reason, .. } => format!("cannot be read: {reason}"),
            Self::Syntax { reason, .. } => format!("this is not TOML: {reason}"),
            Self::UnknownKey { key, nearest, known, about, .. } => {
                let suggestion = suggestion(nearest.as_deref());
                let about = about.as_ref().map_or(String::new(), |about| format!("; {about}"));
                format!("unknown key {key}{suggestion} Known here: {}{about}", known.join(", "))
            }
            Self::MissingKey { key, allowed, .. } => format!("{key} is missing: {allowed}"),
            Self::Forbidden { key, value, allowed, .. } => format!("{key} = {value}: {allowed}"),
        }
    }

    /// The place of the error.
    fn place(&self) -> SourcePlace {
        let (file, line, span) = match self {
            Self::Unreadable { file, .. } => (file, 0, None),
            Self::Syntax { file, line, column, .. } => (file, *line, Some([column - 1, *column])),
            Self::UnknownKey { file, line, .. }
            | Self::MissingKey { file, line, .. }
            | Self::Forbidden { file, line, .. } => (file, *line, None),
        };
        SourcePlace { file: file.clone(), line, span }
    }

    /// The key that is wrong, or missing.
    fn key(&self) -> Option<&str> {
        match self {
            Self::Unreadable { .. } | Self::Syntax { .. } => None,
            Self::UnknownKey { key, .. } | Self::MissingKey { key, .. } | Self::Forbidden { key, .. } => {
                Some(key)
            }
        }
    }

    /// The message and its place, separately.
    pub fn mistake(&self) -> Mistake {
        Mistake { key: self.key().map(str::to_owned), ..self.place().mistake(self.reason()) }
    }
}

/// A mistake for display beside the file: the message, the key, and the line (from 1) and the
/// characters in it (from 0) that are wrong, as far as they are known.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Mistake {
    /// The message; it includes the place only where there is no line, as for a setting.
    pub message: String,
    /// The key with its full path.
    pub key: Option<String>,
    /// The line.
    pub line: Option<usize>,
    /// The first character, and the one after the last.
    pub span: Option<[usize; 2]>,
}

impl Mistake {
    /// A mistake without a place.
    pub fn new(message: impl Into<String>) -> Self {
        Self { message: message.into(), key: None, line: None, span: None }
    }
}

/// A place in a file; a setting has no line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SourcePlace {
    pub(crate) file: String,
    /// The line, from 1; 0 for a setting.
    pub(crate) line: usize,
    pub(crate) span: Option<[usize; 2]>,
}

impl SourcePlace {
    /// A mistake at this place.
    pub fn mistake(&self, message: String) -> Mistake {
        match self.line {
            0 => Mistake::new(format!("{self}: {message}")),
            line => Mistake { line: Some(line), span: self.span, ..Mistake::new(message) },
        }
    }
}

impl Display for SourcePlace {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.line {
            0 => formatter.write_str(&self.file),
            line => write!(formatter, "{}:{line}", self.file),
        }
    }
}
