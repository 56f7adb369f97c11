//! Keys are declared once, each with the kind of its value: how it is read, its requirement, and its part of a JSON schema.

use std::fmt::Display;
use std::ops::{Bound, RangeBounds, RangeInclusive};

use serde::de::DeserializeOwned;
use toml::{Spanned, Value};

use super::error::SourceError;
use super::keys::{Key, Requirements, Schema, object, schema};
use super::section::Section;
use super::source::Source;
use super::text::Text;
use super::words::joined;

/// A struct whose fields are the keys of a table: see [`keys!`](crate::keys).
pub trait Keys: Sized {
    /// Reads the table.
    ///
    /// # Errors
    /// [`SourceError`]: the first key in the order of the declaration that is missing or does not
    /// hold what it must.
    fn read(section: &Section<'_>) -> Result<Self, SourceError>;

    /// Adds the keys of the table, whose name is `table`, and of those in it.
    fn list(table: &str, keys: &mut Vec<Key>);
}

/// Declares a table of a file as a struct that is read from it ([`Keys`]): a field for each key,
/// with its meaning, its type, how it is read ([`Kind`](crate::kind::Kind)), and its requirement,
/// in which the limits replace `{}`. Checks that involve several keys are made where the struct is
/// used.
///
/// ```
/// use grazing_input::{keys, kind::{count, number}};
///
/// keys! {
///     /// The spring of a figure.
///     pub struct Spring {
///         /// The coils.
///         coils: u32 = count(1..=30), "the number of coils must be a whole number from {} to {}";
///         /// The stiffness.
///         stiffness: f64 = number(0.0..), "the stiffness must be a number from {} on";
///     }
/// }
/// ```
#[macro_export]
macro_rules! keys {
    ($(#[$about:meta])* $vis:vis struct $name:ident {
        $($(#[doc = $meaning:literal])+ $key:ident: $type:ty = $kind:expr $(, $requirement:expr)?;)+
    }) => {
        $(#[$about])*
        #[derive(Debug, Clone, PartialEq)]
        $vis struct $name {
            $($(#[doc = $meaning])+ pub $key: $type,)+
        }

        impl $crate::Keys for $name {
            fn read(section: &$crate::Section<'_>) -> Result<Self, $crate::SourceError> {
                Ok(Self { $($key: $crate::kind::Kind::<$type>::read(&$kind, section, stringify!($key))?,)+ })
            }

            fn list(table: &str, keys: &mut Vec<$crate::Key>) {
                $({
                    let words = [stringify!($key), concat!($($meaning),+), [$($requirement,)? ""][0]];
                    $crate::kind::Kind::<$type>::list(&$kind, table, words, keys);
                })+
            }
        }
    };
}

/// The way in which the value of a key is read.
pub struct Kind<V> {
    read: Reader<V>,
    /// The limits of the value, in the order in which they replace `{}` in the requirement.
    limits: Vec<String>,
    list: Lister,
    /// What a JSON schema says of the value.
    schema: Schema,
    /// Whether the key must be there.
    required: bool,
}

/// A type of values, and what a JSON schema says of it.
pub trait Typed: DeserializeOwned + 'static {
    /// The keywords of the schema.
    fn schema() -> Schema;
}

macro_rules! typed {
    ($($type:ty: $($keyword:literal = $says:expr),+;)+) => {$(
        impl Typed for $type {
            fn schema() -> Schema {
                schema([$(($keyword, Value::from($says))),+])
            }
        }
    )+};
}

typed! {
    bool: "type" = "boolean";
    f64: "type" = "number";
    u32: "type" = "integer", "minimum" = 0;
    u64: "type" = "integer", "minimum" = 0;
    String: "type" = "string";
    Vec<f64>: "type" = "array", "items" = f64::schema();
    Vec<String>: "type" = "array", "items" = String::schema();
}

type Reader<V> = Box<dyn Fn(&Section<'_>, &str) -> Result<V, SourceError>>;
type Lister = Box<dyn Fn(Key, &mut Vec<Key>)>;

impl<V: 'static> Kind<V> {
    fn new(schema: Schema, read: impl Fn(&Section<'_>, &str) -> Result<V, SourceError> + 'static) -> Self {
        let list = Box::new(|key, keys: &mut Vec<Key>| keys.push(key));
        Self { read: Box::new(read), limits: Vec::new(), list, schema, required: true }
    }

    /// Tells the range of the number, or of those in the list.
    fn within<T: Display + Clone + Into<Value>>(mut self, range: &impl RangeBounds<T>) -> Self {
        let ends = [
            (range.start_bound(), ["minimum", "exclusiveMinimum"]),
            (range.end_bound(), ["maximum", "exclusiveMaximum"]),
        ];
        let limits = ends.into_iter().filter_map(|(bound, [included, excluded])| match bound {
            Bound::Included(end) => Some((included.to_owned(), end)),
            Bound::Excluded(end) => Some((excluded.to_owned(), end)),
            Bound::Unbounded => None,
        });
        let limits: Vec<(String, &T)> = limits.collect();
        let numbers = match self.schema.get_mut("items") {
            Some(Value::Table(items)) => items,
            _ => &mut self.schema,
        };
        numbers.extend(limits.iter().map(|(keyword, end)| (keyword.clone(), T::clone(end).into())));
        self.limits = limits.into_iter().map(|(_, end)| end.to_string()).collect();
        self
    }

    /// Says more of the value in the schema.
    #[must_use]
    pub fn with(mut self, keyword: &str, says: impl Into<Value>) -> Self {
        self.schema.insert(keyword.to_owned(), says.into());
        self
    }

    fn listed(self, list: impl Fn(Key, &mut Vec<Key>) + 'static) -> Self {
        Self { list: Box::new(list), ..self }
    }

    /// Restricts the values to those that pass a test.
    #[must_use]
    pub fn such(self, test: impl Fn(&V) -> bool + 'static) -> Self {
        self.map(
            move |value, section, name| if test(&value) { Ok(value) } else { Err(section.refusal(name)) },
        )
    }

    /// Converts the value by a function, which may fail.
    #[must_use]
    pub fn map<U: 'static>(
        self,
        make: impl Fn(V, &Section<'_>, &str) -> Result<U, SourceError> + 'static,
    ) -> Kind<U> {
        let Self { read, limits, list, schema, required } = self;
        let read =
            Box::new(move |section: &Section<'_>, name: &str| make(read(section, name)?, section, name));
        Kind { read, limits, list, schema, required }
    }

    /// Reads the value of a key.
    ///
    /// # Errors
    /// [`SourceError`]: the key is missing, or its value is not allowed.
    pub fn read(&self, section: &Section<'_>, name: &str) -> Result<V, SourceError> {
        (self.read)(section, name)
    }

    /// Words that replace `{}` in the requirement, in their order.
    #[must_use]
    pub fn saying(self, words: impl IntoIterator<Item = String>) -> Self {
        Self { limits: words.into_iter().collect(), ..self }
    }

    /// Adds a key in a table, with its meaning and requirement, and the keys in it if it is a table
    /// itself.
    #[doc(hidden)]
    pub fn list(&self, table: &str, [name, meaning, requirement]: [&str; 3], keys: &mut Vec<Key>) {
        let filled = |text: String, limit: &String| text.replacen("{}", limit, 1);
        let requirement = self.limits.iter().fold(requirement.to_owned(), filled);
        let (path, meaning) = (joined(table, name), meaning.trim().to_owned());
        let (schema, required) = (self.schema.clone(), self.required);
        (self.list)(Key { path, requirement, meaning, schema, required }, keys);
    }
}

/// Any value of a type.
pub fn value<T: Typed>() -> Kind<T> {
    Kind::new(T::schema(), |section, name| section.value(name))
}

/// A finite number in a range.
pub fn number(range: impl RangeBounds<f64> + Clone + 'static) -> Kind<f64> {
    let inside = range.clone();
    value::<f64>().such(move |number| number.is_finite() && inside.contains(number)).within(&range)
}

/// A positive number.
pub fn positive() -> Kind<f64> {
    number((Bound::Excluded(0.0), Bound::Unbounded))
}

/// The range of numbers strictly between two.
pub const fn strictly(from: f64, to: f64) -> (Bound<f64>, Bound<f64>) {
    (Bound::Excluded(from), Bound::Excluded(to))
}

/// The range of numbers above one and at most another.
pub const fn above(from: f64, to: f64) -> (Bound<f64>, Bound<f64>) {
    (Bound::Excluded(from), Bound::Included(to))
}

/// A list of N finite numbers.
pub fn numbers<const N: usize>() -> Kind<[f64; N]> {
    let kind = Kind::new(Vec::<f64>::schema(), |section, name| {
        // For an array the reader would take the first N numbers and ignore the rest.
        let numbers = <[f64; N]>::try_from(section.value::<Vec<f64>>(name)?).ok();
        let finite = numbers.filter(|list| list.iter().all(|number| number.is_finite()));
        finite.ok_or_else(|| section.refusal(name))
    });
    kind.with("minItems", N as i64).with("maxItems", N as i64)
}

/// A list of finite numbers, at most so many.
pub fn list(most: usize) -> Kind<Vec<f64>> {
    let right = move |all: &Vec<f64>| all.len() <= most && all.iter().all(|number| number.is_finite());
    value().such(right).with("maxItems", most as i64)
}

/// Two numbers in a range, the first less than the second.
pub fn interval(within: impl RangeBounds<f64> + Clone + 'static) -> Kind<[f64; 2]> {
    let inside = within.clone();
    let kind = numbers().such(move |[lower, upper]: &[f64; 2]| {
        inside.contains(lower) && inside.contains(upper) && lower < upper
    });
    kind.within(&within)
}

/// A whole number.
pub fn count(range: RangeInclusive<u32>) -> Kind<u32> {
    let allowed = range.clone();
    value().such(move |count| allowed.contains(count)).within(&range)
}

/// A list of different whole numbers, at least one.
pub fn counts(range: RangeInclusive<u32>) -> Kind<Vec<u32>> {
    let allowed = range.clone();
    let list = schema([("type", "array".into()), ("items", u32::schema().into())]);
    let kind = Kind::new(list, move |section, name| {
        let mut counts = Vec::new();
        for written in section.value::<Vec<Spanned<u32>>>(name)? {
            let count = *written.get_ref();
            if !allowed.contains(&count) {
                return Err(section.refusal_at(name, written.span()));
            }
            if counts.contains(&count) {
                return Err(section.forbid(name, format!("{count} is listed twice: list each number once")));
            }
            counts.push(count);
        }
        if counts.is_empty() { Err(section.refusal(name)) } else { Ok(counts) }
    });
    kind.within(&range).with("minItems", 1).with("uniqueItems", true)
}

/// One of several words, each of which stands for a value.
pub fn choice<T: Clone + 'static>(words: impl IntoIterator<Item = (&'static str, T)>) -> Kind<T> {
    let words: Vec<(&str, T)> = words.into_iter().collect();
    let names: Vec<&str> = words.iter().map(|(word, _)| *word).collect();
    let meant = move |written: String, section: &Section<'_>, name: &str| {
        let found = words.iter().find(|(word, _)| *word == written);
        found.map(|(_, meaning)| meaning.clone()).ok_or_else(|| section.refusal(name))
    };
    value().map(meant).with("enum", names)
}

/// A list of such words.
pub fn choices<T: Clone + 'static>(words: impl IntoIterator<Item = (&'static str, T)>) -> Kind<Vec<T>> {
    let words: Vec<(&str, T)> = words.into_iter().collect();
    let one = schema([("enum", words.iter().map(|(word, _)| *word).collect::<Vec<_>>().into())]);
    let meant = move |written: Vec<String>, section: &Section<'_>, name: &str| {
        let of =
            |one: &String| words.iter().find(|(word, _)| word == one).map(|(_, meaning)| meaning.clone());
        written.iter().map(of).collect::<Option<_>>().ok_or_else(|| section.refusal(name))
    };
    value().map(meant).with("items", one)
}

/// A key that may be left out.
pub fn maybe<V: 'static>(kind: Kind<V>) -> Kind<Option<V>> {
    let Kind { read, limits, list, schema, .. } = kind;
    let read =
        move |section: &Section<'_>, name: &str| section.has(name).then(|| read(section, name)).transpose();
    Kind { read: Box::new(read), limits, list, schema, required: false }
}

/// A key that may be left out and then has this value, as it would be written.
pub fn or<V: 'static>(kind: Kind<V>, usual: impl Into<toml::Value>) -> Kind<V> {
    let usual = usual.into();
    let default = usual.clone();
    let Kind { read, limits, list, schema, .. } = kind;
    let read = move |section: &Section<'_>, name: &str| {
        if section.has(name) { read(section, name) } else { as_written(name, &usual, &read) }
    };
    Kind { read: Box::new(read), limits, list, schema, required: false }.with("default", default)
}

/// What is read where a value is written.
fn as_written<V>(name: &str, value: &toml::Value, read: &Reader<V>) -> Result<V, SourceError> {
    let (text, requirements) = (Text::new(&format!("{name} = {value}"), &[]), Requirements::new(""));
    Source::new(&text, "", &requirements).unchecked(|section| read(&section, name))
}

/// A table.
pub fn table<T: Keys + 'static>() -> Kind<T> {
    Kind::new(object(), |section, name| T::read(&section.table(name)?)).listed(list_table::<T>)
}

/// A table all of whose keys are left out.
pub fn usual<T: Keys>() -> T {
    let table = toml::Value::Table(toml::Table::new());
    let read: Reader<T> = Box::new(|section, name| T::read(&section.table(name)?));
    as_written("usual", &table, &read).expect("all keys of such a table may be left out")
}

/// A list of tables, such as `[[fig08.panels]]`; empty if the key is missing and no table is
/// required.
pub fn tables<T: Keys + 'static>(range: RangeInclusive<usize>) -> Kind<Vec<T>> {
    let [least, most] = [*range.start(), *range.end()];
    let kind = Kind::new(schema([("type", "array".into())]), move |section, name| {
        if least == 0 && !section.has(name) {
            return Ok(Vec::new());
        }
        let tables = section.tables(name)?;
        if !range.contains(&tables.len()) {
            return Err(section.refusal(name));
        }
        tables.iter().map(T::read).collect()
    });
    let kind = kind.with("minItems", least as i64).with("maxItems", most as i64);
    let kind = kind.saying([least, most].map(|end| end.to_string())).listed(list_table::<T>);
    Kind { required: least > 0, ..kind }
}

fn list_table<T: Keys>(key: Key, keys: &mut Vec<Key>) {
    let path = key.path.clone();
    keys.push(key);
    T::list(&path, keys);
}

/// A table in which any names may stand, each with a value of a kind; `requirement` is that of each
/// value.
pub fn any_names<V: 'static>(kind: Kind<V>, requirement: impl Into<String>) -> Kind<Vec<(String, V)>> {
    let (requirement, schema) = (requirement.into(), kind.schema.clone());
    let read = move |section: &Section<'_>, name: &str| {
        let table = section.table(name)?;
        let named = |name: &str| Ok((name.to_owned(), kind.read(&table, name)?));
        table.names().into_iter().map(named).collect()
    };
    Kind::new(object(), read).listed(move |key, keys| {
        let (path, requirement, schema) = (joined(&key.path, "*"), requirement.clone(), schema.clone());
        let any = Key { path, requirement, meaning: key.meaning.clone(), schema, required: false };
        keys.extend([key, any]);
    })
}

/// A value computed from other keys of the same table, such as the constants of an oscillator.
pub fn derived<T: Keys + 'static, V: 'static>(
    make: impl Fn(T, &Section<'_>) -> Result<V, SourceError> + 'static,
) -> Kind<V> {
    Kind::new(Schema::new(), move |section, _| make(T::read(section)?, section)).listed(|key, keys| {
        T::list(key.path.rsplit_once('.').map_or("", |(table, _)| table), keys);
    })
}

/// A field without a key, which is filled after the keys have been read, and holds the default
/// value until then.
pub fn unwritten<V: Default + 'static>() -> Kind<V> {
    Kind::new(Schema::new(), |_, _| Ok(V::default())).listed(|_, _| {})
}
