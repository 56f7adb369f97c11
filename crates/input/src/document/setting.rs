//! Values that the command line sets instead of those in a file.

use std::ops::Range;
use std::str::FromStr;

use thiserror::Error;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::error::Mistake;
use super::words::{SHOWN, joined, shortened};

/// A value for a key of a file: `oscillator.zeta=0.05`, `fig08.panels[2].n=1`, `analysis.loops=[1,
/// 2]`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Setting {
    key: String,
    value: String,
}

/// The reason why a text is not a setting.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("{0}")]
pub struct SettingError(String);

impl From<SettingError> for Mistake {
    fn from(error: SettingError) -> Self {
        Self::new(error.0)
    }
}

impl FromStr for Setting {
    type Err = SettingError;

    fn from_str(written: &str) -> Result<Setting, SettingError> {
        let (key, value) = written.split_once('=').ok_or_else(|| {
            SettingError("write KEY=VALUE, such as oscillator.zeta=0.05 or analysis.loops=[1,2]".to_owned())
        })?;
        let (key, value) = (checked(key.trim())?, value.trim().to_owned());
        // A line end could introduce unwanted keys.
        if value.contains(['\n', '\r']) || parsed(&assigned(&value)).is_none() {
            let value = shortened(&value, SHOWN);
            return Err(SettingError(format!(
                "{value} is not a value: write a number, true, a list [1, 2], or text \"in quotation marks\", with apostrophes around the whole so that the shell keeps the quotation marks: 'name=\"my oscillator\"'"
            )));
        }
        Ok(Setting { key, value })
    }
}

impl std::fmt::Display for Setting {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(formatter, "{}={}", self.key, self.value)
    }
}

/// The key, if it is valid.
fn checked(key: &str) -> Result<String, SettingError> {
    match steps(key) {
        Some(_) => Ok(key.to_owned()),
        None => Err(SettingError(format!(
            "{} is not a key: parts are joined by dots, and members of lists are counted from 1, such as fig08.panels[2].n",
            shortened(key, SHOWN)
        ))),
    }
}

impl SettingError {
    /// The error that there are more than [`Setting::MOST`] settings.
    pub fn too_many(count: usize) -> Self {
        Self(format!("{count} values are set: at most {} can be", Setting::MOST))
    }
}

impl Setting {
    /// The most settings over one file: more than any file has keys.
    pub const MOST: usize = 1000;

    /// A value for a key.
    ///
    /// # Errors
    /// The key is not valid.
    pub fn new(key: &str, value: impl Into<toml::Value>) -> Result<Setting, SettingError> {
        Ok(Setting { key: checked(key)?, value: value.into().to_string() })
    }

    /// The full path of the key.
    pub fn key(&self) -> &str {
        &self.key
    }

    /// The value as it was written.
    pub fn value(&self) -> &str {
        &self.value
    }

    /// The setting for the same key in a table.
    pub fn within(&self, table: &str) -> Setting {
        Setting { key: format!("{table}.{}", self.key), value: self.value.clone() }
    }

    /// The text from which [`apply`](Self::apply) reads the value.
    pub(crate) fn assigned(&self) -> String {
        assigned(&self.value)
    }

    /// Puts the value into a document, in whose text the setting begins at `position`.
    pub(crate) fn apply<'d>(
        &self,
        document: &mut DeTable<'d>,
        position: usize,
        assigned: &'d str,
    ) -> Result<(), Refusal> {
        let span = position..position + self.key.len();
        match (steps(&self.key), parsed(assigned)) {
            (Some(steps), Some(value)) => {
                let begins = span.end + "=".len();
                put(document, &steps, "", &span, moved(value, begins - ASSIGNED.len()))
            }
            _ => Ok(()),
        }
    }
}

/// Puts a value at the end of the steps from a table with this key, as if it stood in the text at
/// the span.
fn put<'d>(
    table: &mut DeTable<'d>,
    steps: &[KeyPart],
    above: &str,
    span: &Range<usize>,
    value: Spanned<DeValue<'d>>,
) -> Result<(), Refusal> {
    let [step, rest @ ..] = steps else { return Ok(()) };
    let name = step.name.as_str();
    let mut key = joined(above, name);
    let refuse = |key: String, allowed: &str| Err(Refusal { key, allowed: allowed.to_owned() });
    let named = || Spanned::new(span.clone(), name.to_owned().into());
    if step.member.is_none() && rest.is_empty() {
        // The key is removed as well, so that the place of the new one is that of the setting.
        table.remove(name);
        table.insert(named(), value);
        return Ok(());
    }
    if step.member.is_none() && !table.contains_key(name) {
        table.insert(named(), Spanned::new(span.clone(), DeValue::Table(DeTable::new())));
    }
    let Some(mut found) = table.get_mut(name) else { return refuse(key, "there is no such list") };
    if let Some(number) = step.member {
        let DeValue::Array(members) = found.get_mut() else { return refuse(key, "it is not a list") };
        let count = members.len();
        let Some(member) = number.checked_sub(1).and_then(|index| members.get_mut(index)) else {
            return refuse(key, &format!("there is no entry {number}: the list has {count}"));
        };
        key.push_str(&format!("[{number}]"));
        if rest.is_empty() {
            *member = value;
            return Ok(());
        }
        found = member;
    }
    match found.get_mut() {
        DeValue::Table(inner) => put(inner, rest, &key, span, value),
        _ => refuse(key, "it is not a table and has no keys"),
    }
}

/// The reason why a setting cannot be applied: the key at which it fails, and what is allowed
/// there.
pub(crate) struct Refusal {
    pub(crate) key: String,
    pub(crate) allowed: String,
}

/// A part of a key, with the number of a member, from 1, if there is one.
pub(crate) struct KeyPart {
    pub(crate) name: String,
    pub(crate) member: Option<usize>,
}

/// The parts of a key; `None` if it has an empty part or an invalid member number.
pub(crate) fn steps(key: &str) -> Option<Vec<KeyPart>> {
    let step = |part: &str| {
        let (name, member) = match part.split_once('[') {
            Some((name, rest)) => (name, Some(rest.strip_suffix(']')?.parse().ok()?)),
            None => (part, None),
        };
        let plain = |letter: char| letter.is_ascii_alphanumeric() || letter == '_' || letter == '-';
        (!name.is_empty() && name.chars().all(plain)).then(|| KeyPart { name: name.to_owned(), member })
    };
    key.split('.').map(step).collect()
}

/// The assignment under which a value is read by itself.
const ASSIGNED: &str = "v=";
const ASSIGNED_KEY: &str = "v";

/// A value with its assignment.
fn assigned(value: &str) -> String {
    format!("{ASSIGNED}{value}")
}

/// A value whose places are those in a text in which it stands farther behind.
fn moved(value: Spanned<DeValue<'_>>, by: usize) -> Spanned<DeValue<'_>> {
    let behind = |span: Range<usize>| span.start + by..span.end + by;
    let span = behind(value.span());
    let value = match value.into_inner() {
        DeValue::Array(members) => {
            DeValue::Array(members.into_iter().map(|member| moved(member, by)).collect())
        }
        DeValue::Table(table) => {
            let entries = table.into_iter().map(|(key, value)| {
                let span = behind(key.span());
                (Spanned::new(span, key.into_inner()), moved(value, by))
            });
            DeValue::Table(entries.collect())
        }
        value => value,
    };
    Spanned::new(span, value)
}

/// The value in a text with its assignment.
fn parsed(text: &str) -> Option<Spanned<DeValue<'_>>> {
    let mut document = DeTable::parse(text).ok()?.into_inner();
    let value = document.remove(ASSIGNED_KEY)?;
    document.is_empty().then_some(value)
}
