//! The names in a description: none may mean two things.

use grazing_source::{Section, SourceError};

use crate::expression::is_function;
use crate::file::REQUIREMENTS;

/// What the name of a variable of force or reset law means.
pub(crate) fn variable(name: &str) -> Option<&'static str> {
    Some(match name {
        "x" => "the position",
        "v" => "the velocity",
        "t" => "the time",
        "y" => "the impact velocity",
        "z" => "the impact phase",
        _ => return None,
    })
}

/// What a name means before any file says anything.
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
pub(crate) fn check(constants: &Section<'_>, axes: &[Section<'_>; 2]) -> Result<(), SourceError> {
    let mut seen: Vec<(String, &'static str)> = Vec::new();
    for name in constants.names() {
        let meaning = "a constant in [parameters]";
        if let Some(allowed) = wrong(name, meaning, &seen) {
            return Err(constants.forbid(name, allowed));
        }
        seen.push((name.to_owned(), meaning));
    }
    for (axis, meaning) in axes.iter().zip(["the primary parameter", "the secondary parameter"]) {
        let name: String = axis.value("name")?;
        if let Some(allowed) = wrong(&name, meaning, &seen) {
            return Err(axis.forbid("name", allowed));
        }
        seen.push((name, meaning));
    }
    Ok(())
}

/// What is wrong with a name, and what would be right, after these names with their meanings.
fn wrong(name: &str, meaning: &str, seen: &[(String, &'static str)]) -> Option<String> {
    if !is_name(name) {
        return Some(REQUIREMENTS.of("primary.name").to_owned());
    }
    let taken = own_meaning(name)
        .or_else(|| seen.iter().find(|(other, _)| *other == name).map(|(_, meaning)| *meaning))?;
    Some(format!(
        "the name {name} would mean two things, {taken} and {meaning}: choose another name here and in the expressions"
    ))
}
