//! The names in a description: each must have a single meaning.

use crate::document::{Section, SourceError};
use crate::expression::{is_function, variable};
use crate::file::{File, REQUIREMENTS};

/// The meaning of a name that is reserved, independently of any file.
fn own_meaning(name: &str) -> Option<&'static str> {
    variable(name).or_else(|| {
        Some(match name {
            "pi" => "the number 3.14159...",
            "e" => "the number 2.71828...",
            name if is_function(name) => "a function",
            _ => return None,
        })
    })
}

/// Whether an expression can contain the name.
fn is_name(name: &str) -> bool {
    let mut characters = name.chars();
    characters.next().is_some_and(|first| first.is_ascii_alphabetic() || first == '_')
        && characters.all(|character| character.is_ascii_alphanumeric() || character == '_')
}

/// Checks the names of constants and of the two parameters.
pub(crate) fn check(section: &Section<'_>, file: &File) -> Result<(), SourceError> {
    let constants = file
        .parameters
        .iter()
        .map(|(name, _)| ("parameters", name.as_str(), name, "a constant in [parameters]"));
    let axes = [
        ("primary", "name", &file.primary.name, "the primary parameter"),
        ("secondary", "name", &file.secondary.name, "the secondary parameter"),
    ];
    let mut seen: Vec<(&str, &'static str)> = Vec::new();
    for (table, key, name, meaning) in constants.chain(axes) {
        if let Some(allowed) = wrong(name, meaning, &seen) {
            return Err(section.table(table)?.forbid(key, allowed));
        }
        seen.push((name, meaning));
    }
    Ok(())
}

/// The error in a name, with its remedy, given the names seen before with their meanings.
fn wrong(name: &str, meaning: &str, seen: &[(&str, &'static str)]) -> Option<String> {
    if !is_name(name) {
        return Some(REQUIREMENTS.of("primary.name").to_owned());
    }
    let taken = own_meaning(name)
        .or_else(|| seen.iter().find(|(other, _)| *other == name).map(|(_, meaning)| *meaning))?;
    Some(format!(
        "the name {name} is ambiguous: it is {taken} and {meaning}; choose another name here and in the expressions"
    ))
}
