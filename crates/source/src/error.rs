//! What can be wrong with a file.

use std::fmt::{self, Display};

use crate::words::suggestion;

/// The first thing in a file that is not right, and what would be.
///
/// Keys are written with dots, members of a list of tables counted from 1: `fig08.panels[2].loops`.
/// Values are given as the file writes them.
#[derive(Debug, Clone, PartialEq)]
pub enum SourceError {
    /// The file is not there, is no text, or may not be read.
    Unreadable {
        /// The file.
        file: String,
        /// What the system says.
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
        /// What the TOML reader says.
        reason: String,
    },
    /// A key that means nothing here, most often a misspelt one.
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
    MissingKey {
        /// The file.
        file: String,
        /// The line, from 1, of the table that lacks the key, which is 1 at the top level; the last
        /// line for a table that is missing itself.
        line: usize,
        /// The key with all that leads to it.
        key: String,
        /// What has to be written there.
        allowed: String,
    },
    /// A value of the wrong type, outside its domain, or at odds with another value.
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
    /// What is wrong, without its place.
    fn reason(&self) -> String {
        match self {
            Self::Unreadable { reason, .. } => format!("cannot be read: {reason}"),
            Self::Syntax { reason, .. } => format!("this is not TOML: {reason}"),
            Self::UnknownKey { key, nearest, known, .. } => {
                let suggestion = suggestion(nearest.as_deref());
                format!("unknown key {key}{suggestion} Known here: {}", known.join(", "))
            }
            Self::MissingKey { key, allowed, .. } => format!("{key} is missing: {allowed}"),
            Self::Forbidden { key, value, allowed, .. } => format!("{key} = {value}: {allowed}"),
        }
    }

    /// Where it is wrong.
    fn place(&self) -> Place {
        let (file, line, span) = match self {
            Self::Unreadable { file, .. } => (file, 0, None),
            Self::Syntax { file, line, column, .. } => (file, *line, Some([column - 1, *column])),
            Self::UnknownKey { file, line, .. }
            | Self::MissingKey { file, line, .. }
            | Self::Forbidden { file, line, .. } => (file, *line, None),
        };
        Place { file: file.clone(), line, span }
    }

    /// What is wrong and where, apart.
    pub fn mistake(&self) -> Mistake {
        self.place().mistake(self.reason())
    }
}

/// A mistake for whoever shows the file: what is wrong, and the line (from 1) and the characters of
/// it (from 0) that are to blame, as far as they are known.
#[derive(Debug, Clone, PartialEq)]
pub struct Mistake {
    /// What is wrong; the place is part of it only where there is no line, as for a setting.
    pub message: String,
    /// The line.
    pub line: Option<usize>,
    /// The first character, and the one after the last.
    pub span: Option<[usize; 2]>,
}

impl Mistake {
    /// One without a place.
    pub fn new(message: impl Into<String>) -> Self {
        Self { message: message.into(), line: None, span: None }
    }
}

/// Where something stands in a file; a setting has no line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Place {
    pub(crate) file: String,
    /// The line, from 1; 0 for a setting.
    pub(crate) line: usize,
    pub(crate) span: Option<[usize; 2]>,
}

impl Place {
    /// A mistake that is here.
    pub fn mistake(&self, message: String) -> Mistake {
        match self.line {
            0 => Mistake::new(format!("{self}: {message}")),
            line => Mistake { message, line: Some(line), span: self.span },
        }
    }
}

impl Display for Place {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.line {
            0 => formatter.write_str(&self.file),
            line => write!(formatter, "{}:{line}", self.file),
        }
    }
}
