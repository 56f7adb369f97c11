//! The text of a file, and the way back from a place in it to line, key and value.

use std::fs::File as OpenFile;
use std::io::{self, Read};
use std::ops;
use std::path::Path;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::error::SourceError;
use crate::requirements::Requirements;
use crate::section::Section;
use crate::setting::Setting;
use crate::words::{nearest, shortened};

/// A file with more bytes than this was not written by a person.
const MOST_BYTES: u64 = 1_000_000;

/// The most characters of a value or a name that a message repeats.
const SHOWN: usize = 100;

/// The text of a file of reasonable size.
///
/// # Errors
/// [`SourceError::Unreadable`].
pub fn read_file(path: &Path) -> Result<String, SourceError> {
    let read = || -> io::Result<String> {
        let file = OpenFile::open(path)?;
        if !file.metadata()?.is_file() {
            return Err(io::Error::other("it is not a file"));
        }
        let mut bytes = Vec::new();
        file.take(MOST_BYTES + 1).read_to_end(&mut bytes)?;
        if bytes.len() as u64 > MOST_BYTES {
            return Err(io::Error::other(format!(
                "it is longer than {MOST_BYTES} bytes; files of this kind are far shorter"
            )));
        }
        String::from_utf8(bytes).map_err(|_| io::Error::other("it is not a text in UTF-8"))
    };
    read().map_err(|reason| SourceError::Unreadable {
        file: path.display().to_string(),
        reason: reason.to_string(),
    })
}

/// The text of a file with the settings that take the place of some of its values.
#[derive(Debug, Clone)]
pub struct Text {
    /// The file's text, and after it a line for each setting.
    whole: String,
    /// Where the file's text ends.
    end: usize,
    /// The settings, with the places at which they stand in the whole text.
    settings: Vec<(usize, Setting)>,
}

impl Text {
    /// The text of a file, with settings of which later ones go before earlier ones.
    pub fn new(text: &str, settings: &[Setting]) -> Text {
        let mut whole = text.to_owned();
        let mut placed = Vec::new();
        for setting in settings {
            whole.push('\n');
            placed.push((whole.len(), setting.clone()));
            whole.push_str(&setting.to_string());
        }
        Text { whole, end: text.len(), settings: placed }
    }
}

/// A file's text with the name that messages use for it, and what its keys must hold.
#[derive(Debug, Clone, Copy)]
pub struct Source<'a> {
    text: &'a Text,
    file: &'a str,
    requirements: Requirements,
}

impl<'a> Source<'a> {
    /// The text of a file; `file` is the name that messages use.
    pub fn new(text: &'a Text, file: &'a str, requirements: Requirements) -> Source<'a> {
        Source { text, file, requirements }
    }

    /// The file's content, with the settings applied.
    fn document<T, E: From<SourceError>>(
        &self,
        read: impl FnOnce(Spanned<DeTable<'_>>) -> Result<T, E>,
    ) -> Result<T, E> {
        let Text { whole, end, settings } = self.text;
        let padded: Vec<String> =
            settings.iter().map(|(position, setting)| setting.padded(*position)).collect();
        let mut document = DeTable::parse(&whole[..*end]).map_err(|error| self.syntax(&error))?;
        for ((position, setting), padded) in settings.iter().zip(&padded) {
            self.must_be_there(setting, *position, document.get_ref())?;
            setting.apply(document.get_mut(), *position, padded).map_err(|refusal| {
                let (file, line) = self.place(*position);
                let (value, allowed) =
                    (setting.value().to_owned(), format!("{}: {}", refusal.key, refusal.allowed));
                SourceError::Forbidden { file, line, key: setting.key().to_owned(), value, allowed }
            })?;
        }
        read(document)
    }

    /// Refuses a setting for a name that the file would have to bring in: any may stand in its table, and this one does not.
    fn must_be_there(
        &self,
        setting: &Setting,
        position: usize,
        document: &DeTable<'_>,
    ) -> Result<(), SourceError> {
        let Some((table, name)) =
            setting.key().rsplit_once('.').filter(|(table, _)| self.requirements.any_key(table))
        else {
            return Ok(());
        };
        let names = document.get(table).and_then(|value| value.get_ref().as_table());
        let names: Vec<&str> = names.into_iter().flatten().map(|(key, _)| key.get_ref().as_ref()).collect();
        if names.contains(&name) {
            return Ok(());
        }
        Err(self.unknown(position, setting.key().to_owned(), name, &names))
    }

    /// The file with the line of a position in the text, or the setting that stands there.
    pub(crate) fn place(&self, position: usize) -> (String, usize) {
        let setting = self.text.settings.iter().rev().find(|(start, _)| *start <= position);
        match setting {
            Some(_) => ("--set".to_owned(), 0),
            None => (self.file.to_owned(), self.line(position)),
        }
    }

    /// The whole file, read by `read`.
    ///
    /// # Errors
    /// [`SourceError`]: no TOML, or an unknown key; and whatever `read` finds wrong.
    pub fn whole<T, E: From<SourceError>>(
        &self,
        read: impl FnOnce(Section<'_>) -> Result<T, E>,
    ) -> Result<T, E> {
        self.document(|document| match first_unknown_key(document.get_ref(), "", &self.requirements) {
            Some(unknown) => Err(self.refuse(unknown).into()),
            None => read(Section::whole(self, document.get_ref())),
        })
    }

    /// Checks that the file is TOML and that its top level has known keys only.
    ///
    /// # Errors
    /// [`SourceError`]: no TOML, or an unknown key.
    pub fn check_top_level(&self) -> Result<(), SourceError> {
        self.document(|document| {
            let known = self.requirements.known_keys("");
            let keys = document.get_ref().keys();
            let unknown = keys.filter(|key| !known.contains(&key.get_ref().as_ref()));
            match unknown.min_by_key(|key| key.span().start) {
                Some(key) => Err(self.refuse(UnknownKey {
                    position: key.span().start,
                    table: String::new(),
                    name: key.get_ref().to_string(),
                })),
                None => Ok(()),
            }
        })
    }

    /// One table of the top level, read by `read`; what stands in the others does not matter.
    ///
    /// # Errors
    /// [`SourceError`]: no TOML, no such table, or an unknown key in it; and whatever `read` finds wrong.
    pub fn section<T, E: From<SourceError>>(
        &self,
        name: &str,
        read: impl FnOnce(Section<'_>) -> Result<T, E>,
    ) -> Result<T, E> {
        self.document(|document| {
            let Some(value) = document.get_ref().get(name) else {
                return Err(self.missing("", name, 0).into());
            };
            let section = Section::of(self, name.to_owned(), value)?;
            match value
                .get_ref()
                .as_table()
                .and_then(|table| first_unknown_key(table, name, &self.requirements))
            {
                Some(unknown) => Err(self.refuse(unknown).into()),
                None => read(section),
            }
        })
    }

    /// The refusal of the value at a place, with what its key must hold.
    pub(crate) fn refusal(&self, key: &str, span: ops::Range<usize>) -> SourceError {
        self.forbid_at(key, span, self.requirements.of(key).to_owned())
    }

    pub(crate) fn forbid_at(&self, key: &str, span: ops::Range<usize>, allowed: String) -> SourceError {
        let (file, line) = self.place(span.start);
        SourceError::Forbidden { file, line, key: key.to_owned(), value: self.written(span), allowed }
    }

    /// The text of a place as the file has it.
    pub(crate) fn raw(&self, span: ops::Range<usize>) -> &'a str {
        &self.text.whole[span]
    }

    /// The text of a place on one line, as the file has it but for line breaks.
    fn written(&self, span: ops::Range<usize>) -> String {
        shortened(&self.text.whole[span].split_whitespace().collect::<Vec<_>>().join(" "), SHOWN)
    }

    /// The line of a position in the text, from 1.
    fn line(&self, position: usize) -> usize {
        1 + self.text.whole[..position].matches('\n').count()
    }

    fn syntax(&self, error: &toml::de::Error) -> SourceError {
        let position = error.span().map_or(0, |span| span.start.min(self.text.end));
        let line_start = self.text.whole[..position].rfind('\n').map_or(0, |newline| newline + 1);
        SourceError::Syntax {
            file: self.file.to_owned(),
            line: self.line(position),
            column: 1 + self.text.whole[line_start..position].chars().count(),
            reason: self.syntax_problem(error, line_start),
        }
    }

    /// What is wrong with a line that is not TOML: what people mean by it most often, or else what the reader says.
    fn syntax_problem(&self, error: &toml::de::Error, line_start: usize) -> String {
        let place = error.span().map_or("", |span| self.text.whole.get(span).unwrap_or_default());
        if error.message().starts_with("duplicate key") {
            let key = shortened(place.trim(), SHOWN);
            return format!("the key {key} is given twice: remove one of them, or give it another name");
        }
        if error.message().contains("recurs") {
            return "lists or tables stand too deep inside one another".to_owned();
        }
        let line = self.text.whole[line_start..].lines().next().unwrap_or_default();
        let Some((key, value)) = line.split_once('=') else { return error.message().to_owned() };
        let value = value.split('#').next().unwrap_or_default().trim();
        let (key, shown) = (key.trim(), shortened(value, SHOWN));
        let number = value.split_whitespace().next().filter(|word| word.parse::<f64>().is_ok());
        match number {
            Some(number) if number != value => format!(
                "{shown} is not a number: quantities have no units here; write {key} = {number}, and the unit, if you like, \
                 after a #"
            ),
            None if value.starts_with(char::is_alphabetic) && !value.contains(['"', '\'']) => {
                format!("text must be in quotation marks: write {key} = \"{shown}\"")
            }
            None if value.starts_with(|first: char| first.is_ascii_digit() || "+-.".contains(first)) => {
                format!("{shown} is not a number")
            }
            _ if value.is_empty() => format!("the value of {key} is missing"),
            _ => error.message().to_owned(),
        }
    }

    fn refuse(&self, unknown: UnknownKey) -> SourceError {
        let UnknownKey { position, table, name } = unknown;
        let key = joined(&table, &shortened(&name, SHOWN));
        self.unknown(position, key, &name, &self.requirements.known_keys(&table))
    }

    /// The refusal of a key, of which `name` is the last part, where others are known.
    fn unknown(&self, position: usize, key: String, name: &str, known: &[&str]) -> SourceError {
        let (file, line) = self.place(position);
        let nearest = nearest(name, known).map(str::to_owned);
        let known = known.iter().map(|&known| known.to_owned()).collect();
        SourceError::UnknownKey { file, line, key, nearest, known }
    }

    /// The lack of a key in the table that stands at a position.
    pub(crate) fn missing(&self, table: &str, name: &str, position: usize) -> SourceError {
        let key = joined(table, name);
        let (file, line) = self.place(position);
        let line = if !table.is_empty() {
            line
        } else if self.requirements.known_keys(name).is_empty() {
            // A key of the top level must stand before the first table.
            1
        } else {
            self.text.whole[..self.text.end].lines().count().max(1)
        };
        let allowed = self.requirements.of(&key).to_owned();
        SourceError::MissingKey { file, line, key, allowed }
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
            if requirements.known_keys(&path).is_empty() {
                // Not to be a table: that is told of the whole value.
                return None;
            }
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

pub(crate) fn joined(table: &str, name: &str) -> String {
    if table.is_empty() { name.to_owned() } else { format!("{table}.{name}") }
}
