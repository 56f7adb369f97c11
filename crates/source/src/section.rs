//! A table of a file, read key by key.

use std::ops::{Range, RangeInclusive};

use serde::de::DeserializeOwned;
use toml::Spanned;
use toml::de::{DeTable, DeValue, ValueDeserializer};

use crate::error::{SourceError, place};
use crate::text::{Source, joined};

/// A table of a file, whose keys are known ones. Values are read one by one, each as what it is to be, so that whoever checks them
/// needs no other record of where they stand. What is missing, of the wrong type or fails its test is a [`SourceError`].
#[derive(Debug, Clone)]
pub struct Section<'d> {
    source: &'d Source<'d>,
    /// The key of the table with all that leads to it.
    key: String,
    span: Range<usize>,
    table: &'d DeTable<'d>,
}

impl<'d> Section<'d> {
    /// The whole file.
    pub(crate) fn whole(source: &'d Source<'d>, table: &'d DeTable<'d>) -> Self {
        Self { source, key: String::new(), span: 0..0, table }
    }

    /// The table that a value is.
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

    /// The key in this table with all that leads to it.
    pub fn key(&self, name: &str) -> String {
        joined(&self.key, name)
    }

    /// Whether the key is there.
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
        self.table.get(name).ok_or_else(|| self.source.missing(&self.key, name, self.span.start))
    }

    fn span(&self, name: &str) -> Range<usize> {
        self.table.get(name).map_or(self.span.clone(), Spanned::span)
    }

    /// The value of a key.
    pub fn value<T: DeserializeOwned>(&self, name: &str) -> Result<T, SourceError> {
        let value = self.find(name)?;
        T::deserialize(ValueDeserializer::from(value.clone())).map_err(|error| {
            let span = error.span().unwrap_or_else(|| value.span());
            // A table where a value should be is named as a member of its list.
            let members = (1..).zip(value.get_ref().as_array().into_iter().flat_map(|list| list.iter()));
            let mut tables = members.filter(|(_, member)| member.get_ref().is_table());
            let key = match tables.find(|(_, member)| member.span().contains(&span.start)) {
                Some((number, _)) => format!("{}[{number}]", self.key(name)),
                None => self.key(name),
            };
            self.source.refusal(&key, span)
        })
    }

    /// The value of a key that need not be there.
    pub fn optional<T: DeserializeOwned>(&self, name: &str) -> Result<Option<T>, SourceError> {
        if self.has(name) { self.value(name).map(Some) } else { Ok(None) }
    }

    /// A number that is finite and passes the test.
    pub fn number(&self, name: &str, holds: impl Fn(f64) -> bool) -> Result<f64, SourceError> {
        let number: f64 = self.value(name)?;
        if number.is_finite() && holds(number) { Ok(number) } else { Err(self.refusal(name)) }
    }

    /// A list of N finite numbers that passes the test.
    pub fn numbers<const N: usize>(
        &self,
        name: &str,
        holds: impl Fn([f64; N]) -> bool,
    ) -> Result<[f64; N], SourceError> {
        // For an array the reader would take the first N numbers and drop the rest.
        let numbers = <[f64; N]>::try_from(self.value::<Vec<f64>>(name)?).ok();
        numbers
            .filter(|list| list.iter().all(|number| number.is_finite()) && holds(*list))
            .ok_or_else(|| self.refusal(name))
    }

    /// A whole number.
    pub fn count(&self, name: &str, allowed: RangeInclusive<u32>) -> Result<u32, SourceError> {
        let count = self.value(name)?;
        if allowed.contains(&count) { Ok(count) } else { Err(self.refusal(name)) }
    }

    /// A list of different whole numbers, one at least.
    pub fn counts(&self, name: &str, allowed: RangeInclusive<u32>) -> Result<Vec<u32>, SourceError> {
        let mut counts = Vec::new();
        for written in self.value::<Vec<Spanned<u32>>>(name)? {
            let count = *written.get_ref();
            if !allowed.contains(&count) {
                return Err(self.source.refusal(&self.key(name), written.span()));
            }
            if counts.contains(&count) {
                return Err(self.forbid(name, format!("{count} is listed twice: list each number once")));
            }
            counts.push(count);
        }
        if counts.is_empty() { Err(self.refusal(name)) } else { Ok(counts) }
    }

    /// A table in this one.
    pub fn table(&self, name: &str) -> Result<Self, SourceError> {
        Self::of(self.source, self.key(name), self.find(name)?)
    }

    /// The tables of a list, as `[[fig08.panels]]`.
    pub fn tables(&self, name: &str) -> Result<Vec<Self>, SourceError> {
        let value = self.find(name)?;
        let DeValue::Array(members) = value.get_ref() else { return Err(self.refusal(name)) };
        let numbered = (1..).zip(members.iter());
        numbered
            .map(|(number, member)| Self::of(self.source, format!("{}[{number}]", self.key(name)), member))
            .collect()
    }

    /// The refusal of a value, with what its key must hold.
    pub fn refusal(&self, name: &str) -> SourceError {
        self.source.refusal(&self.key(name), self.span(name))
    }

    /// The refusal of a value; `allowed` says what would be right.
    pub fn forbid(&self, name: &str, allowed: String) -> SourceError {
        self.source.forbid_at(&self.key(name), self.span(name), allowed)
    }

    /// A value as the file has it.
    pub fn raw(&self, name: &str) -> &'d str {
        self.source.raw(self.span(name))
    }

    /// Where a value stands, as messages have it: `file:line`, or `--set`.
    pub fn place(&self, name: &str) -> String {
        self.place_within(name, 0)
    }

    /// Where so many bytes after the beginning of a value stand.
    pub fn place_within(&self, name: &str, offset: usize) -> String {
        let (file, line) = self.source.place(self.span(name).start + offset);
        place(&file, line)
    }

    /// A value with its place and key, as messages begin: `file:line: key = value`.
    pub fn told(&self, name: &str) -> String {
        format!("{}: {} = {}", self.place(name), self.key(name), self.raw(name))
    }
}
