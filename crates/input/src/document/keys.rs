//! The keys of a kind of file.

use toml::{Table, Value};

/// A JSON schema: its keywords, with what they say.
pub type Schema = Table;

/// A schema with these keywords.
pub(super) fn schema<const N: usize>(keywords: [(&str, Value); N]) -> Schema {
    keywords.into_iter().map(|(keyword, says)| (keyword.to_owned(), says)).collect()
}

/// The schema of a table.
pub(super) fn object() -> Schema {
    schema([("type", "object".into())])
}

/// A declared key.
#[derive(Debug, Clone, PartialEq)]
pub struct Key {
    /// The key with its full path; members of lists of tables are without their number, as in
    /// `fig08.panels.loops`, and `*` stands for any name in a table.
    pub path: String,
    /// The requirement on the value, in words for error messages.
    pub requirement: String,
    /// The meaning of the key.
    pub meaning: String,
    /// What a JSON schema says of the value; if it is a table, what stands in it is not repeated.
    pub schema: Schema,
    /// Whether the key must be there.
    pub required: bool,
}

/// The keys of a kind of file, with their requirements.
#[derive(Debug, Clone)]
pub struct Requirements {
    keys: Vec<Key>,
    otherwise: &'static str,
}

impl Requirements {
    /// An empty list; `otherwise` is the requirement reported for any other key.
    pub const fn new(otherwise: &'static str) -> Self {
        Self { keys: Vec::new(), otherwise }
    }

    /// Adds the keys of the top level, as listed by [`Keys::list`](crate::Keys::list).
    #[must_use]
    pub fn with_keys(mut self, list: impl Fn(&str, &mut Vec<Key>)) -> Self {
        list("", &mut self.keys);
        self
    }

    /// Adds a table, with the requirement reported if it is missing.
    #[must_use]
    pub fn with_table(mut self, name: &str, requirement: &str, list: impl Fn(&str, &mut Vec<Key>)) -> Self {
        let (path, requirement) = (name.to_owned(), requirement.to_owned());
        self.keys.push(Key { path, requirement, meaning: String::new(), schema: object(), required: false });
        list(name, &mut self.keys);
        self
    }

    /// All keys, in the order of their declaration.
    pub fn keys(&self) -> &[Key] {
        &self.keys
    }

    /// The requirement of a key; the numbers of list members in the key do not matter. For a key
    /// inside a value that is not a table, the requirement is that of the value.
    pub fn of(&self, key: &str) -> &str {
        let plain = without_numbers(key);
        let mut key = plain.as_str();
        loop {
            let above = key.rsplit_once('.').map(|(table, _)| table);
            let any = above.map(|table| format!("{table}.*"));
            let known = |known: &&Key| known.path == key || Some(&known.path) == any.as_ref();
            match (self.keys.iter().find(known), above) {
                (Some(known), _) => return &known.requirement,
                (None, Some(above)) => key = above,
                (None, None) => return self.otherwise,
            }
        }
    }

    /// The keys that are known in a table, in the order of the declaration; the top level is the
    /// table with the empty name. If any name may stand in a table, `*` is its only key.
    pub fn known_keys(&self, table: &str) -> Vec<&str> {
        self.members(table).map(|(name, _)| name).collect()
    }

    /// The keys in a table, with their names in it.
    fn members(&self, table: &str) -> impl Iterator<Item = (&str, &Key)> {
        let plain = without_numbers(table);
        self.keys.iter().filter_map(move |key| {
            let (parent, name) = key.path.rsplit_once('.').unwrap_or(("", &key.path));
            (parent == plain).then_some((name, key))
        })
    }

    /// A JSON schema (draft 7) of files with these keys, by which editors complete them and mark mistakes. What depends on
    /// several keys, or on the meaning of a text, a schema does not say.
    pub fn schema(&self, title: &str) -> Schema {
        let head = [("$schema", "http://json-schema.org/draft-07/schema#".into()), ("title", title.into())];
        schema(head).into_iter().chain(self.table_schema("")).collect()
    }

    /// The schema of a table.
    fn table_schema(&self, table: &str) -> Schema {
        let members =
            || self.members(table).map(|(name, key)| (name.to_owned(), self.value_schema(key).into()));
        if self.any_key(table) {
            let any = members().map(|(_, any)| ("additionalProperties".to_owned(), any));
            return object().into_iter().chain(any).collect();
        }
        let required = self.members(table).filter(|(_, key)| key.required).map(|(name, _)| name);
        schema([
            ("type", "object".into()),
            ("properties", members().collect::<Schema>().into()),
            ("required", required.collect::<Vec<_>>().into()),
            ("additionalProperties", false.into()),
        ])
    }

    /// The schema of the value of a key.
    fn value_schema(&self, key: &Key) -> Schema {
        let mut letters = key.requirement.chars();
        let requirement =
            letters.next().map(|first| format!("{}{}.", first.to_uppercase(), letters.as_str()));
        let meaning = Some(key.meaning.clone()).filter(|meaning| !meaning.is_empty());
        let said: Vec<String> = meaning.into_iter().chain(requirement).collect();
        let said = schema([("description", said.join("\n\n").into())]);
        let inside = match (self.known_keys(&key.path).is_empty(), &key.schema["type"]) {
            (true, _) => Schema::new(),
            (false, Value::String(array)) if array == "array" => {
                schema([("items", self.table_schema(&key.path).into())])
            }
            (false, _) => self.table_schema(&key.path),
        };
        key.schema.clone().into_iter().chain(said).chain(inside).collect()
    }

    /// Whether any name may stand in the table.
    pub(crate) fn any_key(&self, table: &str) -> bool {
        self.known_keys(table) == ["*"]
    }
}

/// The key without numbers of list members: `fig08.panels` for `fig08.panels[2]`.
fn without_numbers(key: &str) -> String {
    key.split('[').map(|part| part.split_once(']').map_or(part, |(_, rest)| rest)).collect()
}
