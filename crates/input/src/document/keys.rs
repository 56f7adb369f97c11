//! The keys of a kind of file.

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
        self.keys.push(Key { path, requirement, meaning: String::new() });
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
        let plain = without_numbers(table);
        let name = |key: &'_ Key| match key.path.rsplit_once('.') {
            Some((parent, name)) => (parent == plain).then_some(name.len()),
            None => plain.is_empty().then_some(key.path.len()),
        };
        self.keys.iter().filter_map(|key| Some(&key.path[key.path.len() - name(key)?..])).collect()
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
