//! Finds the source files that define items, from the items' names.
//!
//! `grazing_theorems::auxiliary::resonance_boundary` is in `crates/theorems/src/auxiliary.rs`, or in a
//! file below it. Items that crates re-export at their root are found in the file that defines them.

use std::cmp::Reverse;
use std::collections::BTreeMap;

use regex::Regex;

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

    /// The place where a function, type, constant, method, field or variant of the workspace is defined.
    pub fn item(&self, path: &str) -> Option<Location> {
        let (crate_name, path) = path.strip_prefix("grazing_")?.split_once("::")?;
        self.find(&format!("crates/{}/src/", crate_name.replace('_', "-")), path)
    }

    /// The place where the check with this name in the ledger is defined.
    pub fn check(&self, name: &str) -> Option<Location> {
        self.find("crates/claims/src/checks/", name)
    }

    /// The line that defines the last name of a path, in a file with items of the type before it, if
    /// there is one: first in files whose path is most similar to that of the item.
    fn find(&self, folder: &str, path: &str) -> Option<Location> {
        let names: Vec<&str> = path.split("::").collect();
        let (item, before) = names.split_last()?;
        let mut files = Vec::new();
        for (file, text) in &self.files {
            let Some(module) = file.strip_prefix(folder).and_then(|file| file.strip_suffix(".rs")) else {
                continue;
            };
            let alike = module.split('/').zip(&names).take_while(|(one, other)| one == *other).count();
            files.push((Reverse(alike), file, text));
        }
        files.sort_by_key(|(alike, ..)| *alike);
        let item = definition(item);
        let place = |owner: Option<Regex>| {
            let owns = |text: &str| owner.as_ref().is_none_or(|owner| owner.is_match(text));
            files.iter().filter(|(.., text)| owns(text)).find_map(|(_, file, text)| {
                let before = &text[..item.find(text)?.start()];
                Some(Location { file: (*file).clone(), line: 1 + before.matches('\n').count() })
            })
        };
        match before.last().filter(|name| name.starts_with(char::is_uppercase)) {
            // Blocks may be far from the type.
            Some(owner) => place(Some(definition(owner))).or_else(|| place(Some(block(owner)))),
            None => place(None),
        }
    }
}

/// A pattern of lines that open a block of a type's own items.
fn block(name: &str) -> Regex {
    pattern(&format!(r"^impl\b(?:<[^>\n]*>)? {name}\b(?:<[^>\n]*>)? \{{"))
}

/// A pattern of lines that define something with this name: after a keyword, or as a field with its type
/// or, in capitals, as a variant, which ends its line or opens its own fields.
fn definition(name: &str) -> Regex {
    let variant = if name.starts_with(char::is_uppercase) { "|[,({]" } else { "" };
    pattern(&format!(
        r"^(?:[^/\n]* )?(?:fn|struct|enum|trait|type|const|static|mod) {name}\b|^ *(?:pub(?:\(crate\))? )?{name}\b *(?::(?:[^:]|$){variant})"
    ))
}

fn pattern(lines: &str) -> Regex {
    Regex::new(&format!("(?m){lines}")).expect("the names are those of items")
}
