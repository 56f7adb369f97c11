//! The names in a description: none may mean two things.

use grazing_source::Source;
use toml::Spanned;

use crate::error::DescriptionError;
use crate::expression::is_function;
use crate::file::{File, REQUIREMENTS};

/// What a name means before any file says anything.
fn own_meaning(name: &str) -> Option<&'static str> {
    Some(match name {
        "x" => "the position",
        "v" => "the velocity",
        "t" => "the time",
        "y" => "the impact velocity",
        "z" => "the impact phase",
        "pi" => "the number 3.14159...",
        "e" => "the number 2.71828...",
        name if is_function(name) => "a function",
        _ => return None,
    })
}

/// Whether an expression can contain the name.
fn is_name(name: &str) -> bool {
    let mut characters = name.chars();
    characters.next().is_some_and(|first| first.is_ascii_alphabetic() || first == '_')
        && characters.all(|character| character.is_ascii_alphanumeric() || character == '_')
}

/// Checks the names of constants and of the two parameters.
pub(crate) fn check(file: &File, source: &Source<'_>) -> Result<(), DescriptionError> {
    let mut seen: Vec<(&str, &'static str)> = Vec::new();
    let axes = [
        ("primary.name", &file.primary.name, "the primary parameter"),
        ("secondary.name", &file.secondary.name, "the secondary parameter"),
    ];
    let mut constants: Vec<&Spanned<String>> = file.parameters.keys().collect();
    constants.sort_by_key(|name| name.span().start);
    let constants = constants.into_iter().map(|name| ("parameters", name, "a constant in [parameters]"));
    for (key, name, meaning) in constants.chain(axes) {
        let written = name.get_ref().as_str();
        if !is_name(written) {
            let allowed = REQUIREMENTS.of("primary.name").to_owned();
            return Err(source.forbid(key, name, allowed).into());
        }
        let taken = own_meaning(written)
            .or_else(|| seen.iter().find(|(other, _)| *other == written).map(|(_, meaning)| *meaning));
        if let Some(taken) = taken {
            let allowed = format!(
                "the name {written} would mean two things, {taken} and {meaning}: choose another one here, and in the \
                 expressions"
            );
            return Err(source.forbid(key, name, allowed).into());
        }
        seen.push((written, meaning));
    }
    Ok(())
}
