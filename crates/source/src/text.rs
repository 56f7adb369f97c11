//! The text of a file, and the way back from a place in it to line, key and value.

use std::ops;

use serde::de::DeserializeOwned;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::error::SourceError;
use crate::requirements::Requirements;

/// A file's text with the name that messages use for it, and what its keys must hold.
#[derive(Debug, Clone, Copy)]
pub struct Source<'a> {
    text: &'a str,
    file: &'a str,
    requirements: Requirements,
}

impl<'a> Source<'a> {
    /// The text of a file; `file` is the name that messages use.
    pub fn new(text: &'a str, file: &'a str, requirements: Requirements) -> Source<'a> {
        Source { text, file, requirements }
    }

    /// The name of the file.
    pub fn file(&self) -> &'a str {
        self.file
    }

    /// The file's content with keys and types checked; `File` denies unknown fields and has none with a default.
    ///
    /// # Errors
    /// [`SourceError`]: no TOML, an unknown or missing key, or a value of the wrong type.
    pub fn read<File: DeserializeOwned>(&self) -> Result<File, SourceError> {
        let document = DeTable::parse(self.text).map_err(|error| self.syntax(&error))?;
        if let Some(unknown) = first_unknown_key(document.get_ref(), "", &self.requirements) {
            return Err(self.refuse(unknown));
        }
        toml::from_str(self.text).map_err(|error| self.explain(&error, document.get_ref()))
    }

    /// The refusal of the value that `place` holds; `allowed` says what would be right.
    pub fn forbid<T>(&self, key: &str, place: &Spanned<T>, allowed: String) -> SourceError {
        self.forbid_at(key, place.span(), allowed)
    }

    fn forbid_at(&self, key: &str, span: ops::Range<usize>, allowed: String) -> SourceError {
        SourceError::Forbidden {
            file: self.file.to_owned(),
            line: self.line(span.start),
            key: key.to_owned(),
            value: self.written(span),
            allowed,
        }
    }

    /// The text of a place as the file has it.
    pub fn raw(&self, span: ops::Range<usize>) -> &'a str {
        &self.text[span]
    }

    /// The text of a place on one line, as the file has it but for line breaks.
    fn written(&self, span: ops::Range<usize>) -> String {
        self.text[span].split_whitespace().collect::<Vec<_>>().join(" ")
    }

    /// The line of a position in the text, from 1.
    pub fn line(&self, position: usize) -> usize {
        1 + self.text[..position].matches('\n').count()
    }

    fn syntax(&self, error: &toml::de::Error) -> SourceError {
        let position = error.span().map_or(0, |span| span.start.min(self.text.len()));
        let line_start = self.text[..position].rfind('\n').map_or(0, |newline| newline + 1);
        SourceError::Syntax {
            file: self.file.to_owned(),
            line: self.line(position),
            column: 1 + self.text[line_start..position].chars().count(),
            reason: error.message().to_owned(),
        }
    }

    fn refuse(&self, unknown: UnknownKey) -> SourceError {
        let known = self.requirements.known_keys(&unknown.table);
        SourceError::UnknownKey {
            file: self.file.to_owned(),
            line: self.line(unknown.position),
            nearest: nearest(&unknown.name, &known).to_owned(),
            key: joined(&unknown.table, &unknown.name),
            known: known.into_iter().map(str::to_owned).collect(),
        }
    }

    /// Puts the reader's refusal of a type, or its lack of a key, into our words.
    ///
    /// The reader keeps no structure beside its message and a place, so the name of a missing key is taken from between
    /// the message's backticks.
    fn explain(&self, error: &toml::de::Error, document: &DeTable<'_>) -> SourceError {
        let span = error.span().unwrap_or(0..0);
        // What the top level lacks has no place, and the text may begin with a table.
        let path = if span.is_empty() {
            String::new()
        } else {
            path_in_table(document, span.start).unwrap_or_default()
        };
        let missing = error.message().strip_prefix("missing field `").and_then(|rest| rest.strip_suffix('`'));
        let Some(name) = missing else {
            return self.forbid_at(&path, span, self.requirements.of(&path).to_owned());
        };
        let key = joined(&path, name);
        let line = if !path.is_empty() {
            self.line(span.start)
        } else if self.requirements.known_keys(name).is_empty() {
            // A key of the top level must stand before the first table.
            1
        } else {
            self.text.lines().count().max(1)
        };
        let allowed = self.requirements.of(&key).to_owned();
        SourceError::MissingKey { file: self.file.to_owned(), line, key, allowed }
    }
}

/// A key that means nothing in its table.
struct UnknownKey {
    position: usize,
    table: String,
    name: String,
}

/// The unknown key that stands first in the text. The reader would find it too, but not before a missing one: of a table
/// whose name is misspelt it would say that it is missing.
fn first_unknown_key(table: &DeTable<'_>, path: &str, requirements: &Requirements) -> Option<UnknownKey> {
    let known = requirements.known_keys(path);
    let any = requirements.any_key(path);
    table
        .iter()
        .filter_map(|(key, value)| {
            let name = key.get_ref().to_string();
            if !any && !known.contains(&name.as_str()) {
                return Some(UnknownKey { position: key.span().start, table: path.to_owned(), name });
            }
            let path = joined(path, &name);
            match value.get_ref() {
                DeValue::Table(inner) => first_unknown_key(inner, &path, requirements),
                DeValue::Array(members) => members
                    .iter()
                    .zip(1..)
                    .filter_map(|(member, number)| Some((member.get_ref().as_table()?, number)))
                    .find_map(|(inner, number)| {
                        first_unknown_key(inner, &format!("{path}[{number}]"), requirements)
                    }),
                _ => None,
            }
        })
        .min_by_key(|unknown| unknown.position)
}

fn joined(table: &str, name: &str) -> String {
    if table.is_empty() { name.to_owned() } else { format!("{table}.{name}") }
}

/// The known name that is spelt most like `name`; the first of equals, and empty if there is none.
pub fn nearest<'a>(name: &str, known: &[&'a str]) -> &'a str {
    let mut best = (f64::NEG_INFINITY, "");
    for candidate in known {
        let likeness = strsim::jaro_winkler(name, candidate);
        if likeness > best.0 {
            best = (likeness, candidate);
        }
    }
    best.1
}

/// The key of the innermost table entry at `position`; a place inside a list of values belongs to the list.
fn path_in_table(table: &DeTable<'_>, position: usize) -> Option<String> {
    table.iter().find_map(|(key, value)| {
        let name = key.get_ref();
        match path_in_value(value, position) {
            Some(rest) => Some(format!("{name}{rest}")),
            None => {
                (key.span().contains(&position) || value.span().contains(&position)).then(|| name.to_string())
            }
        }
    })
}

/// What follows the key of `value` on the way to `position`: `.key` or `[number].key`.
fn path_in_value(value: &Spanned<DeValue<'_>>, position: usize) -> Option<String> {
    match value.get_ref() {
        DeValue::Table(table) => path_in_table(table, position).map(|path| format!(".{path}")),
        DeValue::Array(members) => members.iter().zip(1..).find_map(|(member, number)| {
            let table = member.get_ref().as_table()?;
            let inner = path_in_table(table, position).map(|path| format!(".{path}"));
            match inner {
                Some(path) => Some(format!("[{number}]{path}")),
                None => member.span().contains(&position).then(|| format!("[{number}]")),
            }
        }),
        _ => None,
    }
}
