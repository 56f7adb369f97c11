//! A table of a file, read key by key.

use std::ops::Range;

use serde::de::DeserializeOwned;
use toml::Spanned;
use toml::de::{DeTable, DeValue, ValueDeserializer};

use super::error::{SourceError, SourcePlace};
use super::setting::steps;
use super::source::Source;
use super::words::joined;

/// A table of a file, whose keys are all known. Values are read one by one, each as its own type,
/// so that code that checks them needs no other record of their places. A value that is missing,
/// has the wrong type or fails its test is a [`SourceError`].
#[derive(Debug, Clone)]
pub struct Section<'d> {
    source: &'d Source<'d>,
    /// The full path of the table.
    key: String,
    span: Range<usize>,
    table: &'d DeTable<'d>,
}

impl<'d> Section<'d> {
    /// The whole file.
    pub(crate) fn whole(source: &'d Source<'d>, table: &'d DeTable<'d>) -> Self {
        Self { source, key: String::new(), span: 0..0, table }
    }

    /// The table that is stored in a value.
    pub(crate) fn of(
        source: &'d Source<'d>,
        key: String,
        value: &'d Spanned<DeValue<'d>>,
    ) -> Result<Self, SourceError> {
        match value.get_ref() {
            DeValue::Table(table) => Ok(Self { source, key, span: value.span(), table }),
            _ => Err(source.refusal(&key, value.span())),
        }
    }

    /// The full path of a key in this table.
    pub fn key(&self, name: &str) -> String {
        joined(&self.key, name)
    }

    /// Whether the key exists.
    pub fn has(&self, name: &str) -> bool {
        self.table.contains_key(name)
    }

    /// The keys, in the order of the file.
    pub fn names(&self) -> Vec<&'d str> {
        let mut keys: Vec<_> = self.table.keys().collect();
        keys.sort_by_key(|key| key.span().start);
        keys.into_iter().map(|key| key.get_ref().as_ref()).collect()
    }

    fn find(&self, name: &str) -> Result<&'d Spanned<DeValue<'d>>, SourceError> {
        self.table.get(name).ok_or_else(|| self.lack(name))
    }

    /// The span of a value in the text.
    fn span(&self, name: &str) -> Range<usize> {
        // A name in quotation marks may look like a path.
        if let Some(value) = self.table.get(name) {
            return value.span();
        }
        let mut found = None;
        let mut table = Some(self.table);
        for step in steps(name).unwrap_or_default() {
            let mut value = table.and_then(|table| table.get(step.name.as_str()));
            if let Some(number) = step.member {
                let members = value.and_then(|value| value.get_ref().as_array());
                value = members.and_then(|members| members.get(number.checked_sub(1)?));
            }
            table = value.and_then(|value| value.get_ref().as_table());
            found = value;
        }
        found.map_or_else(|| self.span.clone(), Spanned::span)
    }

    /// The value of a key.
    pub fn value<T: DeserializeOwned>(&self, name: &str) -> Result<T, SourceError> {
        let value = self.find(name)?;
        T::deserialize(ValueDeserializer::from(value.clone())).map_err(|error| {
            let span = error.span().unwrap_or_else(|| value.span());
            // A table in place of a value is named as a member of its list.
            let members = (1..).zip(value.get_ref().as_array().into_iter().flat_map(|list| list.iter()));
            let mut tables = members.filter(|(_, member)| member.get_ref().is_table());
            let key = match tables.find(|(_, member)| member.span().contains(&span.start)) {
                Some((number, _)) => format!("{}[{number}]", self.key(name)),
                None => self.key(name),
            };
            self.source.refusal(&key, span)
        })
    }

    /// A table in this one.
    pub fn table(&self, name: &str) -> Result<Self, SourceError> {
        Self::of(self.source, self.key(name), self.find(name)?)
    }

    /// The tables of a list, such as `[[fig08.panels]]`.
    pub fn tables(&self, name: &str) -> Result<Vec<Self>, SourceError> {
        let value = self.find(name)?;
        let DeValue::Array(members) = value.get_ref() else { return Err(self.refusal(name)) };
        let numbered = (1..).zip(members.iter());
        numbered
            .map(|(number, member)| Self::of(self.source, format!("{}[{number}]", self.key(name)), member))
            .collect()
    }

    /// The error that a key is missing.
    pub fn lack(&self, name: &str) -> SourceError {
        self.source.missing(&self.key, name, self.span.start)
    }

    /// The error that a value does not meet its requirement; names may lead to it through tables
    /// and lists, as in `orbits[2].phase`.
    pub fn refusal(&self, name: &str) -> SourceError {
        self.refusal_at(name, self.span(name))
    }

    /// The error that a part of a value does not meet its requirement.
    pub(crate) fn refusal_at(&self, name: &str, span: Range<usize>) -> SourceError {
        self.source.refusal(&self.key(name), span)
    }

    /// The error that a value is not allowed; `allowed` gives the remedy.
    pub fn forbid(&self, name: &str, allowed: String) -> SourceError {
        self.source.forbid_at(&self.key(name), self.span(name), allowed)
    }

    /// The place of a value.
    pub fn place(&self, name: &str) -> SourcePlace {
        self.source.place(self.span(name).start)
    }

    /// The place of a part of the text stored in a value, its characters marked unless escapes or a
    /// line end lie among them.
    pub fn place_in(&self, name: &str, text: &str, part: &Range<usize>) -> SourcePlace {
        let span = self.span(name);
        // With escapes in it, the text's lines are not those of the file.
        match self.source.raw(span.clone()).find(text) {
            Some(offset) => {
                let start = span.start + offset;
                self.source.marked(start + part.start..start + part.end)
            }
            None => self.place(name),
        }
    }

    /// A value with its place and key, in the form in which messages begin:
    /// `file:line: key = value`.
    pub fn shown(&self, name: &str) -> String {
        format!("{}: {} = {}", self.place(name), self.key(name), self.source.raw(self.span(name)))
    }
}
