//! A claim's `holds` names what its check calls: found in the source of the check and of the functions that this calls.
//!
//! Source is read as text: a function is its name and what stands in it, a call is its name anywhere in that. This decides for
//! functions; where a type is named, it or one of its methods has to stand there.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use grazing_claims::ledger::Ledger;

/// The functions of some files, by name: the file and the words that stand in them.
type Functions = BTreeMap<String, Vec<(PathBuf, BTreeSet<String>)>>;

fn rust_files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a folder of the project") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            rust_files(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            found.push(path);
        }
    }
}

fn words(text: &str) -> BTreeSet<String> {
    let boundary = |character: char| !(character.is_alphanumeric() || character == '_');
    text.split(boundary).filter(|word| !word.is_empty()).map(str::to_owned).collect()
}

/// What follows up to the brace that closes the first one that is opened; nothing for a declaration without a body.
fn block(text: &str) -> &str {
    let (mut depth, mut opened) = (0, false);
    for (index, character) in text.char_indices() {
        match character {
            ';' if !opened => return "",
            '{' => (depth, opened) = (depth + 1, true),
            '}' => depth -= 1,
            _ => {}
        }
        if opened && depth == 0 {
            return &text[..index];
        }
    }
    text
}

/// All functions under these folders; comments do not count.
fn functions(folders: &[PathBuf]) -> Functions {
    let mut files = Vec::new();
    folders.iter().for_each(|folder| rust_files(folder, &mut files));
    let mut functions = Functions::new();
    for file in files {
        let text = fs::read_to_string(&file).expect("a source file");
        let code: Vec<&str> = text.lines().map(|line| line.split("//").next().unwrap_or_default()).collect();
        let code = code.join("\n");
        for (start, _) in code.match_indices("fn ") {
            let rest = &code[start + 3..];
            let name: String = rest.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
            // Arrays in a signature have a semicolon that ends nothing.
            let body = rest.find('{').map_or("", |brace| block(&rest[brace..]));
            functions.entry(name).or_default().push((file.clone(), words(body)));
        }
        for (start, _) in code.match_indices("\nchecks! {") {
            // A row begins with its name.
            let mut name = String::new();
            for line in block(&code[start..]).lines().skip(2) {
                let row = line.strip_prefix("    ").and_then(|row| row.split_once(": "));
                if let Some((new, _)) = row.filter(|(new, _)| words(new).contains(*new)) {
                    name = new.to_owned();
                }
                functions.entry(name.clone()).or_default().push((file.clone(), words(line)));
            }
        }
    }
    functions
}

/// All words in a function and in those of the crate that it calls.
///
/// A name is that of a function in the same file, or of the only one elsewhere: names that several files use decide nothing.
fn reached(functions: &Functions, file: &Path, name: &str) -> BTreeSet<String> {
    let called = |from: &Path, name: &str| {
        let all: Vec<_> = functions.get(name).into_iter().flatten().collect();
        let here: Vec<_> = all.iter().copied().filter(|(place, _)| place.ends_with(from)).collect();
        let unique = all.iter().map(|(place, _)| place).collect::<BTreeSet<_>>().len() == 1;
        if here.is_empty() && unique { all } else { here }
    };
    let mut seen = BTreeSet::new();
    let mut open = called(file, name);
    while let Some((place, words)) = open.pop() {
        for word in words {
            if seen.insert((place, word)) {
                open.extend(called(place, word));
            }
        }
    }
    seen.into_iter().map(|(_, word)| word.clone()).collect()
}

#[test]
fn what_a_claim_says_that_holds_it_is_called_by_its_check() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let functions = functions(&[root.join("src")]);
    let ledger = Ledger::of_the_paper();
    let mut missing = Vec::new();
    for claim in &ledger.claims {
        let Some(check) = claim.check_name() else { continue };
        let [section, module, function] = check.split("::").collect::<Vec<_>>()[..] else {
            panic!("{check}: a section, a module and a function")
        };
        let reached = reached(&functions, Path::new(&format!("checks/{section}/{module}.rs")), function);
        assert!(!reached.is_empty(), "{check} was not found");
        for item in &claim.holds {
            let last = item.rsplit("::").next().unwrap_or(item);
            if !reached.contains(last) {
                missing.push(format!("{} ({check}): {item}", claim.label));
            }
        }
    }
    assert!(missing.is_empty(), "{} not called:\n{}", missing.len(), missing.join("\n"));
}
