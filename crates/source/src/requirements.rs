//! What each key of a file must hold.

/// Every key of a kind of file with what it must hold, in words for whoever has to mend one.
#[derive(Debug, Clone, Copy)]
pub struct Requirements {
    keys: &'static [(&'static str, &'static str)],
    otherwise: &'static str,
}

/// The [`Requirements`] of keys, in the order of the file, and what is said of any other key.
///
/// Keys have dots, members of lists of tables are without their number: `fig08.panels.loops`. The key `table.*` stands for any name in a
/// table.
///
/// `requirements! { otherwise "see the manual"; "analysis": "the table [analysis] holds loops"; "analysis.loops": "a whole number"; }`
#[macro_export]
macro_rules! requirements {
    (otherwise $otherwise:literal; $($key:literal: $requirement:expr;)+) => {
        $crate::Requirements::new(&[$(($key, $requirement),)+], $otherwise)
    };
}

impl Requirements {
    /// As [`requirements!`](crate::requirements) makes them.
    #[doc(hidden)]
    pub const fn new(keys: &'static [(&'static str, &'static str)], otherwise: &'static str) -> Requirements {
        Requirements { keys, otherwise }
    }

    /// What the key must hold; the numbers of list members in the key do not matter. A key inside a value that is no table is
    /// wrong because of that value.
    pub fn of(&self, key: &str) -> &'static str {
        let plain = without_numbers(key);
        let mut key = plain.as_str();
        loop {
            let above = key.rsplit_once('.').map(|(table, _)| table);
            let any = above.map(|table| format!("{table}.*"));
            let found = self.keys.iter().find(|(known, _)| *known == key || Some(*known) == any.as_deref());
            match (found, above) {
                (Some((_, requirement)), _) => return requirement,
                (None, Some(above)) => key = above,
                (None, None) => return self.otherwise,
            }
        }
    }

    /// The keys that are known in a table, in the order of the file; the top level is the table with the empty name.
    /// `*` is a table's only key where any name may stand.
    pub fn known_keys(&self, table: &str) -> Vec<&'static str> {
        let plain = without_numbers(table);
        self.keys
            .iter()
            .filter_map(|(known, _)| match known.rsplit_once('.') {
                Some((parent, name)) => (parent == plain).then_some(name),
                None => plain.is_empty().then_some(*known),
            })
            .collect()
    }

    /// Whether any name may stand in the table.
    pub(crate) fn any_key(&self, table: &str) -> bool {
        self.known_keys(table) == ["*"]
    }
}

/// `fig08.panels` for `fig08.panels[2]`.
fn without_numbers(key: &str) -> String {
    key.split('[').map(|part| part.split_once(']').map_or(part, |(_, rest)| rest)).collect()
}
