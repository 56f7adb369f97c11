//! A file with the requirements of its keys, and the conversion from a position in its text to
//! line, key and value.

use std::ops;

use super::error::{SourceError, SourcePlace};
use super::keys::Requirements;
use super::text::Text;
use super::words::{SHOWN, joined, nearest, shortened};

/// A file's text with the name that messages use for it, and the requirements of its keys.
#[derive(Debug, Clone, Copy)]
pub struct Source<'a> {
    pub(crate) text: &'a Text,
    file: &'a str,
    pub(crate) requirements: &'a Requirements,
}

impl<'a> Source<'a> {
    /// The text of a file; `file` is the name that messages use.
    pub fn new(text: &'a Text, file: &'a str, requirements: &'a Requirements) -> Source<'a> {
        Source { text, file, requirements }
    }

    /// The file with the line of a position in the text, or the setting at that position.
    pub(crate) fn place(&self, position: usize) -> SourcePlace {
        let set = self.text.settings.iter().any(|(start, _)| *start <= position);
        let (file, line) = if set { ("--set", 0) } else { (self.file, self.line(position)) };
        SourcePlace { file: file.to_owned(), line, span: None }
    }

    /// The place of a part of the text, its characters marked as far as they are on one line.
    pub(crate) fn marked(&self, part: ops::Range<usize>) -> SourcePlace {
        let line = &self.text.whole[self.line_start(part.start)..part.start];
        let marked = self.text.whole[part.clone()].lines().next().unwrap_or_default();
        let from = line.chars().count();
        let span = Some([from, from + marked.chars().count().max(1)]);
        SourcePlace { span, ..self.place(part.start) }
    }

    /// The error that the value at a place does not meet its requirement.
    pub(crate) fn refusal(&self, key: &str, span: ops::Range<usize>) -> SourceError {
        self.forbid_at(key, span, self.requirements.of(key).to_owned())
    }

    pub(crate) fn forbid_at(&self, key: &str, span: ops::Range<usize>, allowed: String) -> SourceError {
        let SourcePlace { file, line, .. } = self.place(span.start);
        SourceError::Forbidden { file, line, key: key.to_owned(), value: self.written(span), allowed }
    }

    /// The text of a place as in the file.
    pub(crate) fn raw(&self, span: ops::Range<usize>) -> &'a str {
        &self.text.whole[span]
    }

    /// The text of a place on one line, as in the file except for line breaks.
    fn written(&self, span: ops::Range<usize>) -> String {
        shortened(&self.text.whole[span].split_whitespace().collect::<Vec<_>>().join(" "), SHOWN)
    }

    /// The line of a position in the text, from 1.
    fn line(&self, position: usize) -> usize {
        1 + self.text.whole[..position].matches('\n').count()
    }

    /// The position at which the line of a position begins.
    fn line_start(&self, position: usize) -> usize {
        self.text.whole[..position].rfind('\n').map_or(0, |newline| newline + 1)
    }

    pub(crate) fn syntax(&self, error: &toml::de::Error) -> SourceError {
        let position = error.span().map_or(0, |span| span.start.min(self.text.end));
        let line_start = self.line_start(position);
        SourceError::Syntax {
            file: self.file.to_owned(),
            line: self.line(position),
            column: 1 + self.text.whole[line_start..position].chars().count(),
            reason: self.syntax_problem(error, line_start),
        }
    }

    /// The error in a line that is not TOML: the most common mistake that fits, or else the message
    /// of the reader.
    fn syntax_problem(&self, error: &toml::de::Error, line_start: usize) -> String {
        let place = error.span().map_or("", |span| self.text.whole.get(span).unwrap_or_default());
        if error.message().starts_with("duplicate key") {
            let key = shortened(place.trim(), SHOWN);
            return format!("the key {key} is given twice: remove one of them, or give it another name");
        }
        if error.message().contains("recurs") {
            return "lists or tables are nested too deeply".to_owned();
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
            None if value.replacen(',', ".", 1).parse::<f64>().is_ok() => {
                format!("decimals are written with a point: write {key} = {}", value.replacen(',', ".", 1))
            }
            None if value.starts_with(|first: char| first.is_ascii_digit() || "+-.".contains(first)) => {
                format!("{shown} is not a number")
            }
            _ if value.is_empty() => format!("the value of {key} is missing"),
            _ => error.message().to_owned(),
        }
    }

    /// The error that a key, of which `name` is the last part, is unknown.
    pub(crate) fn unknown(&self, position: usize, key: String, name: &str, known: &[&str]) -> SourceError {
        let SourcePlace { file, line, .. } = self.place(position);
        let nearest = nearest(name, known).map(Box::from);
        let table = key.rsplit_once('.').filter(|_| nearest.is_none()).map(|(table, _)| table);
        let about = table.map(|table| self.requirements.of(table).into());
        let known = known.iter().map(|&known| known.to_owned()).collect();
        SourceError::UnknownKey { file, line, key, nearest, known, about }
    }

    /// The error that a key is missing in the table at a position.
    pub(crate) fn missing(&self, table: &str, name: &str, position: usize) -> SourceError {
        let key = joined(table, name);
        let SourcePlace { file, line, .. } = self.place(position);
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
