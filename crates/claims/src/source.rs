//! From the names of items to the source files that hold them.
//!
//! `grazing_theorems::auxiliary::resonance_boundary` stands in `crates/theorems/src/auxiliary.rs`,
//! or in a file below it. What crates re-export at their root is found in the file that defines it.

use std::cmp::Reverse;
use std::collections::BTreeMap;

/// A place in the source code.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Location {
    /// The file, from the root of the repository.
    pub file: String,
    /// The line, from 1.
    pub line: usize,
}

/// The source files of the workspace, by path from the root of the repository.
#[derive(Debug, Clone, Default)]
pub struct Sources {
    files: BTreeMap<String, String>,
}

impl Sources {
    /// The sources in these files: path from the root of the repository with `/`, and text.
    pub fn new(files: impl IntoIterator<Item = (String, String)>) -> Self {
        Self { files: files.into_iter().collect() }
    }

    /// Where a function, type, constant, method, field or variant of the workspace is defined.
    pub fn item(&self, path: &str) -> Option<Location> {
        let (crate_name, path) = path.strip_prefix("grazing_")?.split_once("::")?;
        self.find(&format!("crates/{}/src/", crate_name.replace('_', "-")), path)
    }

    /// Where the check with this name of the ledger is defined.
    pub fn check(&self, name: &str) -> Option<Location> {
        self.find("crates/claims/src/checks/", name)
    }

    /// The line that defines the last name of a path, in a file that has items of the type before
    /// it, if there is one: first in files whose path is most like that of the item.
    fn find(&self, folder: &str, path: &str) -> Option<Location> {
        let names: Vec<&str> = path.split("::").collect();
        let (item, before) = names.split_last()?;
        let owner = before.last().filter(|name| name.starts_with(char::is_uppercase));
        let mut files = Vec::new();
        for (file, text) in &self.files {
            let Some(module) = file.strip_prefix(folder).and_then(|file| file.strip_suffix(".rs")) else {
                continue;
            };
            let alike = module.split('/').zip(&names).take_while(|(one, other)| one == *other).count();
            files.push((Reverse(alike), file, text));
        }
        files.sort_by_key(|(alike, ..)| *alike);
        let place = |owns: fn(&str, &str) -> bool| {
            files.iter().find_map(|(_, file, text)| {
                let of_owner = |line: &str| owner.is_none_or(|owner| owns(line, owner));
                let line = text
                    .lines()
                    .any(of_owner)
                    .then(|| text.lines().position(|line| defines(line, item)))??;
                Some(Location { file: (*file).clone(), line: line + 1 })
            })
        };
        // Blocks may stand far from the type.
        place(defines).or_else(|| place(implements))
    }
}

/// Whether the line opens a block of a type's own items.
fn implements(line: &str, name: &str) -> bool {
    let header = line.strip_prefix("impl").filter(|_| !line.contains(" for "));
    header.is_some_and(|header| {
        header
            .split(|character: char| !character.is_alphanumeric() && character != '_')
            .any(|word| word == name)
    })
}

/// Whether the line defines something of this name.
fn defines(line: &str, name: &str) -> bool {
    const KEYWORDS: [&str; 8] = ["fn ", "struct ", "enum ", "trait ", "type ", "const ", "static ", "mod "];
    let line = line.trim_start();
    if line.starts_with("//") {
        return false;
    }
    let follows = |start: usize| {
        line.get(start..).and_then(|rest| rest.strip_prefix(name)).is_some_and(|rest| {
            !rest.starts_with(|character: char| character.is_alphanumeric() || character == '_')
        })
    };
    let by_keyword = KEYWORDS.iter().any(|keyword| {
        line.match_indices(keyword).any(|(at, _)| {
            let begins = at == 0 || line.as_bytes()[at - 1] == b' ';
            begins && follows(at + keyword.len())
        })
    });
    let field = ["", "pub ", "pub(crate) "].iter().any(|visibility| {
        line.starts_with(visibility) && follows(visibility.len()) && {
            let rest = line[visibility.len() + name.len()..].trim_start();
            // A field has a type after a colon; a variant ends its line, or opens its own fields.
            let variant = name.starts_with(char::is_uppercase) && rest.starts_with([',', '(', '{']);
            (rest.starts_with(':') && !rest.starts_with("::")) || variant
        }
    });
    by_keyword || field
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn calls_comments_and_longer_names_define_nothing() {
        assert!(defines("    pub const fn order(self) -> f64 {", "order"));
        assert!(defines("    pub label: String,", "label"));
        assert!(defines("    Order {", "Order"));
        for line in
            ["order(x);", "// fn order", "fn order_of(x: f64)", "label::new()", "let label = 1;", "Orders,"]
        {
            assert!(!["order", "label", "Order"].iter().any(|name| defines(line, name)), "{line}");
        }
    }
}
