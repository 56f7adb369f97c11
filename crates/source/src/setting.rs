//! Values that a command line sets in the place of a file's.

use std::str::FromStr;

use thiserror::Error;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A value for a key of a file: `oscillator.zeta=0.05`, `fig08.panels[2].n=1`, `analysis.loops=[1, 2]`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Setting {
    key: String,
    value: String,
}

/// What was written is no setting, and why not.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("{0}")]
pub struct SettingError(String);

impl FromStr for Setting {
    type Err = SettingError;

    fn from_str(written: &str) -> Result<Setting, SettingError> {
        let (key, value) = written.split_once('=').ok_or_else(|| {
            SettingError("write KEY=VALUE, as oscillator.zeta=0.05 or analysis.loops=[1,2]".to_owned())
        })?;
        let (key, value) = (key.trim().to_owned(), value.trim().to_owned());
        if steps(&key).is_none() {
            return Err(SettingError(format!(
                "{key} is no key: parts are joined by dots, members of lists counted from 1, as fig08.panels[2].n"
            )));
        }
        // A line end could bring in keys that nobody asks about.
        let single = padded(&value, ASSIGNED.len());
        if value.contains(['\n', '\r']) || parsed(&single).is_none() {
            return Err(SettingError(format!(
                "{value} is not a value: write a number, true, a list [1, 2], or text \"in quotation marks\", with apostrophes about the whole so that the shell leaves the quotation marks: 'name=\"my oscillator\"'"
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

impl Setting {
    /// The key with all that leads to it.
    pub fn key(&self) -> &str {
        &self.key
    }

    /// The value as it was written.
    pub fn value(&self) -> &str {
        &self.value
    }

    /// The same for a key in a table.
    pub fn within(&self, table: &str) -> Setting {
        Setting { key: format!("{table}.{}", self.key), value: self.value.clone() }
    }

    /// The text that [`apply`](Self::apply) reads the value from, for a setting that is written at a position of a longer text.
    pub(crate) fn padded(&self, position: usize) -> String {
        padded(&self.value, position + self.key.len() + 1)
    }

    /// Puts the value into a document, in whose text the setting is written from `position` on.
    pub(crate) fn apply<'d>(
        &self,
        document: &mut DeTable<'d>,
        position: usize,
        padded: &'d str,
    ) -> Result<(), Refusal> {
        let steps = steps(&self.key).unwrap_or_default();
        let value = parsed(padded);
        let (Some((last, way)), Some(value)) = (steps.split_last(), value) else { return Ok(()) };
        let span = position..position + self.key.len();
        let mut passed = String::new();
        let mut table = document;
        for step in way.iter().chain([last]) {
            if !passed.is_empty() {
                passed.push('.');
            }
            passed.push_str(&step.name);
            if std::ptr::eq(step, last) && step.member.is_none() {
                // The key goes as well, so that the place of the new one is that of the setting.
                table.remove(step.name.as_str());
                table.insert(Spanned::new(span.clone(), step.name.clone().into()), value);
                return Ok(());
            }
            if !table.contains_key(step.name.as_str()) {
                if step.member.is_some() {
                    return Err(Refusal { key: passed, allowed: "there is no such list".to_owned() });
                }
                let empty = Spanned::new(span.clone(), DeValue::Table(DeTable::new()));
                table.insert(Spanned::new(span.clone(), step.name.clone().into()), empty);
            }
            let mut found = table.get_mut(step.name.as_str()).map(Spanned::get_mut);
            if let Some(number) = step.member {
                let Some(DeValue::Array(members)) = found else {
                    return Err(Refusal { key: passed, allowed: "it is no list".to_owned() });
                };
                let count = members.len();
                let Some(member) = number.checked_sub(1).and_then(|index| members.get_mut(index)) else {
                    let allowed = format!("there is no entry {number}: the list has {count}");
                    return Err(Refusal { key: passed, allowed });
                };
                passed.push_str(&format!("[{number}]"));
                if std::ptr::eq(step, last) {
                    *member = value;
                    return Ok(());
                }
                found = Some(member.get_mut());
            }
            let Some(DeValue::Table(inner)) = found else {
                return Err(Refusal { key: passed, allowed: "it is no table, and holds no keys".to_owned() });
            };
            table = inner;
        }
        Ok(())
    }
}

/// Why a setting cannot be applied: where on its way, and what is in the way.
pub(crate) struct Refusal {
    pub(crate) key: String,
    pub(crate) allowed: String,
}

/// A part of a key, perhaps with the number of a member, from 1.
struct Step {
    name: String,
    member: Option<usize>,
}

/// The parts of a key; none if it has an empty part or a member number that is none.
fn steps(key: &str) -> Option<Vec<Step>> {
    let step = |part: &str| {
        let (name, member) = match part.split_once('[') {
            Some((name, rest)) => (name, Some(rest.strip_suffix(']')?.parse().ok()?)),
            None => (part, None),
        };
        let plain = |letter: char| letter.is_ascii_alphanumeric() || letter == '_' || letter == '-';
        (!name.is_empty() && name.chars().all(plain)).then(|| Step { name: name.to_owned(), member })
    };
    key.split('.').map(step).collect()
}

/// What a value is assigned to when it is read by itself.
const ASSIGNED: &str = "v=";
const ASSIGNED_KEY: &str = "v";

/// A text in which the value stands as it does in a longer one at `position`, and nothing before it but its assignment.
fn padded(value: &str, position: usize) -> String {
    format!("{}{ASSIGNED}{value}", " ".repeat(position - ASSIGNED.len()))
}

/// The value in a padded text.
fn parsed(text: &str) -> Option<Spanned<DeValue<'_>>> {
    let mut document = DeTable::parse(text).ok()?.into_inner();
    let value = document.remove(ASSIGNED_KEY)?;
    document.is_empty().then_some(value)
}
