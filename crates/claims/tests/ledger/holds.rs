//! Tests that the items in a claim's `holds` are called by its check, by searching the source of the
//! check and of the functions that it reaches.
//!
//! Source is read as text, without comments and string literals. A free function is called where its name
//! occurs before `(` or `::<`, or after `::`, in a file without a function of that name; for an item of a
//! type, the name occurs after `.` or `::`, and the type's name, or that of something declared with the
//! type, occurs anywhere. The same holds for a type's own name.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use grazing_claims::ledger::Ledger;
use grazing_claims::source::Sources;

use crate::files::rust_files;

/// The functions of some files, by name: the file, and the words that occur in them, including forms that
/// show their use ([`used`]).
type Functions = BTreeMap<String, Vec<(PathBuf, BTreeSet<String>)>>;

/// The text without comments and string literals.
fn code(text: &str) -> String {
    let (mut code, mut rest) = (String::new(), text);
    while let Some(at) = rest.find(['"', '/']) {
        let (before, after) = rest.split_at(at);
        code.push_str(before);
        rest = &after[1..];
        if after.starts_with("//") {
            rest = after.find('\n').map_or("", |end| &after[end..]);
        } else if after.starts_with('"') && !before.ends_with('\'') {
            let mut escaped = false;
            let end = rest.find(|c| {
                let is_end = c == '"' && !escaped;
                escaped = c == '\\' && !escaped;
                is_end
            });
            rest = end.map_or("", |end| &rest[end + 1..]);
        }
    }
    code + rest
}

fn is_of_word(character: char) -> bool {
    character.is_alphanumeric() || character == '_'
}

/// The words of a text, with those that are called as `name(`, and those that belong to something as
/// `.name`.
fn words(text: &str) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    let mut rest = 0;
    while let Some(start) = text[rest..].find(is_of_word).map(|at| rest + at) {
        rest = text[start..].find(|c| !is_of_word(c)).map_or(text.len(), |length| start + length);
        let (before, word, after) = (text[..start].trim_end(), &text[start..rest], &text[rest..]);
        let belongs = before.ends_with("::") || before.ends_with('.') && !before.ends_with("..");
        if belongs {
            found.insert(format!(".{word}"));
        }
        if before.ends_with("::") || !belongs && (after.starts_with('(') || after.starts_with("::<")) {
            found.insert(format!("{word}("));
        }
        found.insert(word.to_owned());
    }
    found
}

/// The form in which the use of an item occurs among the words of a function.
fn used(item: &str) -> String {
    let names: Vec<&str> = item.split("::").collect();
    let is_type = |name: &str| name.starts_with(char::is_uppercase);
    match names[..] {
        [.., last] if is_type(last) && last.chars().any(char::is_lowercase) => last.to_owned(),
        [.., owner, last] if is_type(owner) => format!(".{last}"),
        [.., last] => format!("{last}("),
        [] => String::new(),
    }
}

/// For each type, the names that indicate it among the words of a function: its own, those of its
/// aliases, and those of items declared to have or to return one of them.
fn names_of_types(files: &[(String, String)]) -> BTreeMap<String, BTreeSet<String>> {
    let mut names: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    let mut aliases: Vec<(String, String)> = Vec::new();
    let types = |of: &str| {
        let all = of.split(|c| !is_of_word(c)).filter(|word| word.starts_with(char::is_uppercase));
        all.map(str::to_owned).collect::<Vec<_>>()
    };
    let first = |declared: &str| declared.split(|c| !is_of_word(c)).next().unwrap_or_default().to_owned();
    for (_, text) in files {
        let code = code(text).replace('\n', " ");
        // `name: Type`, `fn name(..) -> Type {` and `type Name = Type;`.
        for (at, _) in code.match_indices(": ") {
            let name = code[..at].rsplit(|c| !is_of_word(c)).next().unwrap_or_default();
            let of = code[at + 2..].split([',', ';', '=', '{', '(', ')']).next().unwrap_or_default();
            types(of).into_iter().for_each(|of| {
                names.entry(of).or_default().insert(name.to_owned());
            });
        }
        for (at, _) in code.match_indices("fn ") {
            let signature = code[at + 3..].split(['{', ';']).next().unwrap_or_default();
            let Some((declared, of)) = signature.rsplit_once("->") else { continue };
            types(of).into_iter().for_each(|of| {
                names.entry(of).or_default().insert(first(declared));
            });
        }
        for (at, _) in code.match_indices("type ") {
            let declared = code[at + 5..].split(';').next().unwrap_or_default();
            let Some((alias, of)) = declared.split_once(" = ") else { continue };
            aliases.extend(types(of).into_iter().map(|of| (first(alias), of)));
        }
    }
    for (alias, of) in aliases {
        let more = names.get(&alias).cloned().unwrap_or_default();
        names.entry(of).or_default().extend(more.into_iter().chain([alias]));
    }
    names
}

/// The type to which an item belongs, unless that is a trait, which any oscillator implements.
fn owner(item: &str) -> Option<&str> {
    let owner = item.rsplit("::").nth(1).filter(|owner| owner.starts_with(char::is_uppercase))?;
    (owner != "ImpactOscillator").then_some(owner)
}

/// Whether the crate defines an item, and the named module, or one below it, contains it or its type,
/// possibly re-exported.
fn is_defined(sources: &Sources, files: &[(String, String)], item: &str) -> bool {
    let names: Vec<&str> = item.split("::").collect();
    let outer = names.iter().position(|name| name.starts_with(char::is_uppercase)).unwrap_or(names.len() - 1);
    let crate_name = names[0].trim_start_matches("grazing_");
    let module =
        ["crates", crate_name, "src"].iter().chain(&names[1..outer]).copied().collect::<Vec<_>>().join("/");
    let inside = |path: &str| path.strip_prefix(&module).is_some_and(|rest| rest.starts_with(['.', '/']));
    let has = |(path, text): &(String, String)| inside(path) && words(text).contains(names[outer]);
    sources.item(item).is_some() && files.iter().any(has)
}

/// The text up to the brace that closes the first opened one; empty for a declaration without a body.
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

/// All functions in files under these folders, without comments.
fn functions(folders: &[PathBuf]) -> Functions {
    let mut files = Vec::new();
    folders.iter().for_each(|folder| rust_files(folder, &mut files));
    let mut functions = Functions::new();
    for file in files {
        let text = fs::read_to_string(&file).expect("a source file");
        let code = code(&text);
        for (start, _) in code.match_indices("fn ") {
            let rest = &code[start + 3..];
            let name: String = rest.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
            // Arrays in a signature have a semicolon that does not end it.
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

/// All words in a function and in the functions of the crate that it calls, with the files in which they
/// occur.
///
/// A name refers to a function in the same file, or to the only one elsewhere; names that occur in
/// several files are ignored.
fn reached(functions: &Functions, file: &Path, name: &str) -> BTreeMap<String, BTreeSet<PathBuf>> {
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
    let mut places: BTreeMap<String, BTreeSet<PathBuf>> = BTreeMap::new();
    for (place, word) in seen {
        places.entry(word.clone()).or_default().insert(place.clone());
    }
    places
}

/// Whether an item is used in at least one of these files that does not itself have a function of that
/// name.
fn is_called(functions: &Functions, places: &BTreeMap<String, BTreeSet<PathBuf>>, item: &str) -> bool {
    let used = used(item);
    let own: Vec<&PathBuf> = used
        .strip_suffix('(')
        .and_then(|name| functions.get(name))
        .map_or(Vec::new(), |own| own.iter().map(|(place, _)| place).collect());
    places.get(&used).is_some_and(|places| places.iter().any(|place| !own.contains(&place)))
}

#[test]
fn what_a_claim_says_that_holds_it_is_called_by_its_check() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let functions = functions(&[root.join("src")]);
    let workspace = root.join("../..");
    let mut files = Vec::new();
    rust_files(&workspace.join("crates"), &mut files);
    let source = |file: &PathBuf| {
        let path = file.strip_prefix(&workspace).expect("a file of the workspace");
        (path.to_string_lossy().replace('\\', "/"), fs::read_to_string(file).expect("a source file"))
    };
    let files: Vec<(String, String)> = files.iter().map(source).collect();
    let sources = Sources::new(files.clone());
    let ledger = Ledger::of_the_paper();
    let (mut missing, names) = (Vec::new(), names_of_types(&files));
    // Names that occur in every check must not stand for any type.
    for owner in ["Resonance", "ResonantPoint", "GrazingState", "BranchExpansion"] {
        let common = ["oscillator", "forcing_frequency", "sampler", "deviations", "p", "x"];
        assert!(common.iter().all(|word| !names[owner].contains(*word)), "{owner}: {:?}", names[owner]);
    }
    for claim in &ledger.claims {
        let Some(check) = claim.check_name() else { continue };
        let [section, module, function] = check.split("::").collect::<Vec<_>>()[..] else {
            panic!("{check}: a section, a module and a function")
        };
        let reached = reached(&functions, Path::new(&format!("checks/{section}/{module}.rs")), function);
        assert!(!reached.is_empty(), "{check} was not found");
        let place = sources.check(check).map(|location| location.file);
        assert_eq!(place, Some(format!("crates/claims/src/checks/{section}/{module}.rs")), "{check}");
        for item in &claim.holds {
            if !is_defined(&sources, &files, item) {
                missing.push(format!("{}: {item} is not defined there", claim.label));
            }
            if !is_called(&functions, &reached, item) {
                missing.push(format!("{} ({check}): {item} is not called", claim.label));
            }
            let Some(owner) = owner(item) else { continue };
            let of_type = names.get(owner).into_iter().flatten();
            if !of_type.chain([&owner.to_owned()]).any(|name| reached.contains_key(name)) {
                missing.push(format!("{} ({check}): there is no {owner} to call {item} of", claim.label));
            }
        }
    }
    assert!(missing.is_empty(), "{} wrong:\n{}", missing.len(), missing.join("\n"));
}

#[test]
fn what_is_only_named_or_is_of_the_file_itself_is_not_called() {
    let text = "{ // detuning(x)\n(\"detuning(\\\"y)\", '\"', detune(x), \"\")";
    let found = words(&code(text));
    assert!(found.contains("detune(") && !found.contains("detuning("), "{found:?}");
    let [own, other] = ["own.rs", "other.rs"].map(PathBuf::from);
    let functions = Functions::from([("detuning".to_owned(), vec![(own.clone(), BTreeSet::new())])]);
    let is_called_in = |place: &PathBuf| {
        let places = BTreeMap::from([("detuning(".to_owned(), BTreeSet::from([place.clone()]))]);
        is_called(&functions, &places, "grazing_theorems::auxiliary::detuning")
    };
    assert!(is_called_in(&other) && !is_called_in(&own));
}
