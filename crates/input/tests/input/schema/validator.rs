//! A strict reader of the JSON schemas that are written here: a keyword that it does not know is an error.

use toml::{Table, Value};

/// The first reason why a value does not fit a schema; none if it fits.
///
/// # Panics
/// The schema has a keyword that is not known, or a default that does not fit.
pub(crate) fn refusal(schema: &Table, value: &Value) -> Option<String> {
    let number = |value: &Value| value.as_float().or(value.as_integer().map(|whole| whole as f64));
    let against = |limit: &Value, right: fn(f64, f64) -> bool| {
        number(value).is_none_or(|value| right(value, number(limit).expect("a limit is a number")))
    };
    let members = || value.as_array().into_iter().flatten();
    let entries = || value.as_table().into_iter().flatten();
    let length = |limit: &Value, right: fn(usize, usize) -> bool| {
        let limit =
            usize::try_from(limit.as_integer().expect("a length is a whole number")).expect("it is a length");
        value.as_array().is_none_or(|list| right(list.len(), limit))
    };
    let inside = |schema: &Value, value: &Value| refusal(schema.as_table().expect("it is a schema"), value);
    for (keyword, says) in schema {
        let fits = match keyword.as_str() {
            "$schema" | "title" | "description" => says.is_str(),
            "default" => {
                let mut plain = schema.clone();
                plain.remove("default");
                assert_eq!(refusal(&plain, says), None, "the default {says}");
                true
            }
            "type" => match says.as_str().expect("a type is a word") {
                "object" => value.is_table(),
                "array" => value.is_array(),
                "string" => value.is_str(),
                "boolean" => value.is_bool(),
                "integer" => value.is_integer(),
                // JSON has no others.
                "number" => number(value).is_some_and(f64::is_finite),
                other => panic!("no type: {other}"),
            },
            "enum" => says.as_array().expect("it is a list").contains(value),
            "minimum" => against(says, |value, limit| value >= limit),
            "exclusiveMinimum" => against(says, |value, limit| value > limit),
            "maximum" => against(says, |value, limit| value <= limit),
            "exclusiveMaximum" => against(says, |value, limit| value < limit),
            "minItems" => length(says, |length, limit| length >= limit),
            "maxItems" => length(says, |length, limit| length <= limit),
            "uniqueItems" => {
                (1..).zip(members()).all(|(next, one)| !members().skip(next).any(|other| one == other))
            }
            "items" => match members().find_map(|member| inside(says, member)) {
                Some(reason) => return Some(reason),
                None => true,
            },
            "properties" => {
                let known = |(key, value)| Some(format!("{key}: {}", inside(says.get(key)?, value)?));
                match entries().find_map(known) {
                    Some(reason) => return Some(reason),
                    None => true,
                }
            }
            "required" => {
                let needed = says.as_array().expect("it is a list");
                needed.iter().all(|key| value.get(key.as_str().expect("a key is a word")).is_some())
            }
            "additionalProperties" => {
                let known = schema.get("properties");
                entries()
                    .filter(|(key, _)| known.is_none_or(|known| known.get(key).is_none()))
                    .all(|(_, value)| says.as_bool().unwrap_or_else(|| inside(says, value).is_none()))
            }
            "propertyNames" => entries().all(|(key, _)| inside(says, &key.as_str().into()).is_none()),
            other => panic!("no keyword: {other}"),
        };
        if !fits {
            return Some(format!("{value}: {keyword} {says}"));
        }
    }
    None
}
