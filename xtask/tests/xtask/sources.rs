//! What the source files of a crate use of each other and of other crates, as their tokens say: neither comments and strings nor
//! anything under `#[cfg(test)]` counts.

use std::collections::{BTreeMap, BTreeSet, VecDeque};

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};

/// A path as segments: of a module from the crate's root, or of anything as it is written in a module.
type Path = Vec<String>;

/// A module, in a file of its own or not.
#[derive(Default)]
struct Module {
    file: usize,
    /// Names that are imported, with what they stand for.
    imports: BTreeMap<String, Path>,
    /// Modules of which everything is imported.
    globs: Vec<Path>,
    /// Paths in imports and in code.
    paths: BTreeSet<Path>,
    /// All identifiers.
    words: BTreeSet<String>,
    /// The names of items, apart from what macros make.
    items: BTreeSet<String>,
}

/// The source of a crate, or of one of its programs.
#[derive(Default)]
pub(crate) struct Sources {
    files: Vec<String>,
    modules: BTreeMap<Path, Module>,
    /// The files of macros that belong to the crate's root, wherever they stand.
    exported: BTreeMap<String, usize>,
    /// Macros that print, by file.
    pub(crate) prints: BTreeSet<(String, String)>,
    /// What takes a text apart that was written just before, by file.
    pub(crate) taken_apart: BTreeSet<(String, String)>,
    /// The names of public types and traits, also of those that a macro makes of a list of names.
    pub(crate) types: BTreeSet<String>,
}

/// What a path leads to.
#[derive(Clone, PartialEq)]
enum Target {
    File(usize),
    External(Path),
}

const ITEMS: [&str; 9] = ["struct", "enum", "union", "fn", "const", "static", "type", "trait", "macro_rules"];
const TYPES: [&str; 5] = ["struct", "enum", "union", "type", "trait"];
const PRINTING: [&str; 5] = ["print", "println", "eprint", "eprintln", "dbg"];
/// What looks for something in a text.
const TAKING_APART: [&str; 18] = [
    "contains",
    "ends_with",
    "find",
    "match_indices",
    "matches",
    "rfind",
    "rsplit",
    "rsplit_once",
    "rsplitn",
    "split",
    "split_once",
    "split_whitespace",
    "splitn",
    "starts_with",
    "strip_prefix",
    "strip_suffix",
    "trim_end_matches",
    "trim_start_matches",
];

impl Sources {
    /// Reads a root file and all modules that it declares, each by `text`, which knows what is in a file.
    pub(crate) fn read(root: &str, text: &dyn Fn(&str) -> Option<String>) -> Self {
        let mut sources = Self::default();
        let (folder, _) = root.rsplit_once('/').expect("it is in a folder");
        sources.read_file(root.to_owned(), folder, Vec::new(), text);
        sources
    }

    fn read_file(&mut self, file: String, folder: &str, module: Path, text: &dyn Fn(&str) -> Option<String>) {
        let content = text(&file).unwrap_or_else(|| panic!("there is no {file}"));
        let tokens: TokenStream = content.parse().unwrap_or_else(|error| panic!("{file}: {error}"));
        let number = self.files.len();
        self.files.push(file);
        let mut declared = Vec::new();
        self.scan(tokens, module, number, &mut declared);
        for module in declared {
            let inside = format!("{folder}/{}", module.join("/"));
            let mut places = [format!("{inside}.rs"), format!("{inside}/mod.rs")].into_iter();
            let file = places.find(|place| text(place).is_some());
            self.read_file(file.unwrap_or_else(|| panic!("{inside}: no file")), folder, module, text);
        }
    }

    /// Reads the tokens of a module, and what it declares as modules in files of their own.
    fn scan(&mut self, tokens: TokenStream, at: Path, file: usize, declared: &mut Vec<Path>) {
        let tokens: Vec<TokenTree> = tokens.into_iter().collect();
        let taken = taken_apart(&tokens).into_iter().map(|how| (self.files[file].clone(), how));
        self.taken_apart.extend(taken);
        self.modules.entry(at.clone()).or_default().file = file;
        let child = |name: &str| at.iter().cloned().chain([name.to_owned()]).collect::<Path>();
        let mut k = 0;
        while let Some(token) = tokens.get(k) {
            k += 1;
            match token {
                TokenTree::Group(_) if is_for_tests(&tokens[..k]) => k = end_of_item(&tokens, k),
                TokenTree::Group(group) => self.scan(group.stream(), at.clone(), file, declared),
                TokenTree::Ident(word) => {
                    let word = word.to_string();
                    let next = tokens.get(k).map(ToString::to_string).unwrap_or_default();
                    self.modules.get_mut(&at).expect("it is there").words.insert(word.clone());
                    self.types.extend(made_by_macro(&tokens[k..]));
                    match (&*word, tokens.get(k)) {
                        ("mod", Some(TokenTree::Ident(name))) => match tokens.get(k + 1) {
                            Some(TokenTree::Group(body)) => {
                                self.scan(body.stream(), child(&name.to_string()), file, declared);
                                k += 2;
                            }
                            _ => declared.push(child(&name.to_string())),
                        },
                        ("use", _) if next != "<" => k = self.import(&tokens, k, &at, &[]),
                        // Visibility, which is no use.
                        ("pub", Some(TokenTree::Group(group))) if limits_visibility(group) => k += 1,
                        ("pub", _) if TYPES.contains(&&*next) => {
                            self.types.extend(tokens.get(k + 1).and_then(name_of));
                        }
                        _ => k = self.word(word, &tokens, k, &at, file),
                    }
                }
                _ => {}
            }
        }
    }

    /// Notes the path, or the item, that begins or stands before token `k`; returns where it ends.
    fn word(&mut self, word: String, tokens: &[TokenTree], mut k: usize, at: &Path, file: usize) -> usize {
        let module = self.modules.get_mut(at).expect("it is there");
        let is =
            |k: usize, sign: char| matches!(tokens.get(k), Some(TokenTree::Punct(p)) if p.as_char() == sign);
        if let (true, Some(TokenTree::Ident(name))) =
            (ITEMS.contains(&&*word), tokens.get(k + usize::from(is(k, '!'))))
        {
            module.items.insert(name.to_string());
            let exported =
                tokens[..k].iter().rev().take(8).any(|token| token.to_string().contains("macro_export"));
            if word == "macro_rules" && exported {
                self.exported.insert(name.to_string(), file);
            }
            return k;
        }
        if PRINTING.contains(&&*word) && is(k, '!') {
            self.prints.insert((self.files[file].clone(), format!("{word}!")));
        }
        // What follows the end of a type's arguments belongs to that type; a leading `::` does not.
        let after_type =
            k > 3 && is(k - 2, ':') && is(k - 3, ':') && is(k - 4, '>') && !(k > 4 && is(k - 5, '-'));
        let continues = after_type || k > 1 && is(k - 2, '.');
        let mut path = vec![word];
        while is(k, ':')
            && is(k + 1, ':')
            && let Some(TokenTree::Ident(next)) = tokens.get(k + 2)
        {
            module.words.insert(next.to_string());
            path.push(next.to_string());
            k += 3;
        }
        if path.len() > 1 && !continues {
            module.paths.insert(path);
        }
        k
    }

    /// Notes what a `use` from token `k` imports below a path; returns where it ends.
    fn import(&mut self, tokens: &[TokenTree], mut k: usize, at: &Path, below: &[String]) -> usize {
        let mut path = below.to_vec();
        let mut name = None;
        while let Some(token) = tokens.get(k) {
            k += 1;
            match token {
                TokenTree::Ident(word) if *word == "as" => {
                    name = tokens.get(k).map(ToString::to_string);
                    k += 1;
                }
                TokenTree::Ident(word) if *word == "self" && !path.is_empty() => {}
                TokenTree::Ident(word) => path.push(word.to_string()),
                TokenTree::Punct(sign) if matches!(sign.as_char(), ':' | '$') => {}
                TokenTree::Punct(sign) if sign.as_char() == '*' => {
                    self.modules.get_mut(at).expect("it is there").globs.push(core::mem::take(&mut path));
                }
                TokenTree::Group(group) => {
                    let inner: Vec<TokenTree> = group.stream().into_iter().collect();
                    let mut from = 0;
                    while from < inner.len() {
                        from = self.import(&inner, from, at, &path);
                    }
                    path.clear();
                }
                // The comma in a list, or the end.
                _ => break,
            }
        }
        if let Some(last) = path.last() {
            let module = self.modules.get_mut(at).expect("it is there");
            module.imports.entry(name.unwrap_or_else(|| last.clone())).or_insert_with(|| path.clone());
            module.paths.insert(path);
        }
        k
    }

    /// What a path leads to, written in a module: the file where it is defined, or a path outside of the crate.
    fn target(&self, module: &Path, path: &[String], depth: usize) -> Option<Target> {
        let mut at = match &*path[0] {
            "crate" => Vec::new(),
            "self" => module.clone(),
            "super" => module[..module.len().checked_sub(1)?].to_vec(),
            _ if depth == 0 => return None,
            _ => return self.inside(module, path, depth).or_else(|| Some(Target::External(path.to_vec()))),
        };
        let mut rest = &path[1..];
        while rest.first().is_some_and(|next| next == "super") {
            at.pop()?;
            rest = &rest[1..];
        }
        self.inside(&at, rest, depth).or_else(|| Some(Target::File(self.modules.get(&at)?.file)))
    }

    /// What a path leads to, below a module; nothing if it does not know the first name of the path.
    fn inside(&self, at: &Path, path: &[String], depth: usize) -> Option<Target> {
        let depth = depth.checked_sub(1)?;
        let own = self.modules.get(at)?;
        let Some((first, rest)) = path.split_first() else { return Some(Target::File(own.file)) };
        let child: Path = at.iter().chain([first]).cloned().collect();
        if let Some(module) = self.modules.get(&child) {
            return self.inside(&child, rest, depth).or(Some(Target::File(module.file)));
        }
        if let Some(file) = self.exported.get(first).filter(|_| at.is_empty()) {
            return Some(Target::File(*file));
        }
        if own.items.contains(first) {
            return Some(Target::File(own.file));
        }
        if let Some(import) = own.imports.get(first).filter(|import| *import != &path[..1]) {
            let whole: Path = import.iter().chain(rest).cloned().collect();
            return self.target(at, &whole, depth);
        }
        // Only modules of this crate: where other crates lead is not asked, and would be asked again by every such import.
        own.globs.iter().find_map(|glob| self.inside(&self.module(at, glob)?, path, depth))
    }

    /// The module that a path in a module leads to, if it is one of this crate.
    fn module(&self, from: &Path, path: &[String]) -> Option<Path> {
        let (first, rest) = path.split_first()?;
        let mut at = match &**first {
            "crate" => Vec::new(),
            "self" => from.clone(),
            "super" => from[..from.len().checked_sub(1)?].to_vec(),
            name => from.iter().cloned().chain([name.to_owned()]).collect(),
        };
        for name in rest {
            if name == "super" {
                at.pop()?;
            } else {
                at.push(name.clone());
            }
        }
        self.modules.contains_key(&at).then_some(at)
    }

    /// All that the modules use, by file.
    fn uses(&self) -> impl Iterator<Item = (usize, Target)> {
        self.modules.iter().flat_map(move |(at, module)| {
            let paths = module.paths.iter().filter_map(move |path| self.target(at, path, DEEPEST));
            let globs = module.globs.iter().filter_map(move |glob| self.module(at, glob));
            let words = globs.flat_map(move |glob| {
                let known = move |word: &String| self.inside(&glob, core::slice::from_ref(word), DEEPEST);
                module.words.iter().filter_map(known)
            });
            let elsewhere = module.globs.iter().filter_map(move |glob| self.target(at, glob, DEEPEST));
            let elsewhere = elsewhere.filter(|target| matches!(target, Target::External(_)));
            paths.chain(words).chain(elsewhere).map(|target| (module.file, target))
        })
    }

    /// The paths outside of the crate that its files use, with the file.
    pub(crate) fn external(&self) -> BTreeSet<(String, String)> {
        let external = self.uses().filter_map(|(file, target)| match target {
            Target::External(path) => Some((self.files[file].clone(), path.join("::"))),
            Target::File(_) => None,
        });
        external.collect()
    }

    /// Circles of files that use each other: of every file that is in one, the shortest. A submodule belongs to the
    /// module above it, and may use what stands there.
    pub(crate) fn circles(&self) -> BTreeSet<String> {
        let folder = |file: usize| self.files[file].trim_end_matches("/mod.rs").trim_end_matches(".rs");
        let belongs = |file: usize, other: usize| {
            folder(file).strip_prefix(folder(other)).is_some_and(|rest| rest.starts_with('/'))
        };
        let mut used = vec![BTreeSet::new(); self.files.len()];
        for (file, target) in self.uses() {
            if let Target::File(other) = target
                && other != file
                && !belongs(file, other)
            {
                used[file].insert(other);
            }
        }
        (0..used.len())
            .filter_map(|file| shortest_circle(&used, file))
            .map(|circle| self.shown(&circle))
            .collect()
    }

    /// A circle, from its first file by name.
    fn shown(&self, circle: &[usize]) -> String {
        let mut names: Vec<&str> = circle.iter().map(|file| &*self.files[*file]).collect();
        let first = (0..names.len()).min_by_key(|k| names[*k]).unwrap_or(0);
        names.rotate_left(first);
        names.push(names[0]);
        names.join(" → ")
    }
}

/// The most imports that lead from one to the next.
const DEEPEST: usize = 20;

/// The shortest way from a file through those that it uses back to itself.
pub(crate) fn shortest_circle(used: &[BTreeSet<usize>], file: usize) -> Option<Vec<usize>> {
    let mut before: BTreeMap<usize, usize> = BTreeMap::new();
    let mut queue = VecDeque::from([file]);
    while let Some(now) = queue.pop_front() {
        for &next in &used[now] {
            if next == file {
                let mut circle = vec![now];
                while let Some(earlier) = before.get(circle.last()?) {
                    circle.push(*earlier);
                }
                circle.reverse();
                return Some(circle);
            }
            if let std::collections::btree_map::Entry::Vacant(entry) = before.entry(next) {
                entry.insert(now);
                queue.push_back(next);
            }
        }
    }
    None
}

/// The name that a token is.
fn name_of(token: &TokenTree) -> Option<String> {
    matches!(token, TokenTree::Ident(_)).then(|| token.to_string())
}

/// The types that a macro makes, if its arguments in braces begin these tokens after an exclamation mark: as `A` and `B` of
/// `rows! { A { … } B: Kind { … } }`.
fn made_by_macro(tokens: &[TokenTree]) -> Vec<String> {
    let [TokenTree::Punct(sign), TokenTree::Group(group), ..] = tokens else { return Vec::new() };
    if sign.as_char() != '!' || group.delimiter() != Delimiter::Brace {
        return Vec::new();
    }
    let tokens: Vec<TokenTree> = group.stream().into_iter().collect();
    let is_body = |token: Option<&TokenTree>| matches!(token, Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Brace);
    let is_made = |k: &usize| {
        let begins = k.checked_sub(1).is_none_or(|before| matches!(tokens[before], TokenTree::Group(_)));
        let kind = if is_sign(tokens.get(k + 1), ':') { 2 } else { 0 };
        begins && is_body(tokens.get(k + 1 + kind))
    };
    (0..tokens.len()).filter(is_made).filter_map(|k| name_of(&tokens[k])).collect()
}

/// Whether a token is this sign.
fn is_sign(token: Option<&TokenTree>, sign: char) -> bool {
    matches!(token, Some(TokenTree::Punct(punct)) if punct.as_char() == sign)
}

/// Whether the tokens end with a text that is written there: `x.to_string()` or `format!("{x}")`.
fn writes_text(tokens: &[TokenTree]) -> bool {
    match tokens {
        [.., dot, TokenTree::Ident(word), TokenTree::Group(_)] if *word == "to_string" => {
            is_sign(Some(dot), '.')
        }
        [.., TokenTree::Ident(word), sign, TokenTree::Group(_)] => {
            *word == "format" && is_sign(Some(sign), '!')
        }
        _ => false,
    }
}

/// How a text, which ends before these tokens, is taken apart by them.
fn taking_apart(tokens: &[TokenTree]) -> Option<String> {
    let (dot, TokenTree::Ident(method)) = (tokens.first(), tokens.get(1)?) else { return None };
    let method = method.to_string();
    (is_sign(dot, '.') && TAKING_APART.contains(&&*method)).then_some(method)
}

/// How texts are taken apart that are written in the same place, or kept in a variable of the same block.
fn taken_apart(tokens: &[TokenTree]) -> Vec<String> {
    let direct = (1..tokens.len()).filter(|k| writes_text(&tokens[..*k]));
    let direct = direct.filter_map(|k| taking_apart(&tokens[k..])).map(|method| format!("text.{method}"));
    let bindings =
        (0..tokens.len()).filter(|k| matches!(&tokens[*k], TokenTree::Ident(word) if *word == "let"));
    let kept = bindings.flat_map(|k| {
        let length = tokens[k..].iter().position(|token| is_sign(Some(token), ';'));
        let (binding, rest) = tokens[k..].split_at(length.unwrap_or(tokens.len() - k));
        texts(binding).into_iter().flat_map(|name| looked_into(&name, rest)).collect::<Vec<_>>()
    });
    direct.chain(kept).collect()
}

/// The variables of a `let` that are texts written there: its only one, or some of a tuple.
fn texts(binding: &[TokenTree]) -> Vec<String> {
    let Some(equals) = binding.iter().position(|token| is_sign(Some(token), '=')) else { return Vec::new() };
    let (names, values) = (&binding[1..equals], &binding[equals + 1..]);
    let name = |tokens: &[TokenTree]| {
        let mut words =
            tokens.iter().filter(|token| matches!(token, TokenTree::Ident(word) if *word != "mut"));
        words.next().map(ToString::to_string)
    };
    match (names, values) {
        ([TokenTree::Group(names)], [TokenTree::Group(values)]) => {
            let [names, values] = [names, values].map(|group| group.stream().into_iter().collect::<Vec<_>>());
            let [names, values] = [&names, &values].map(|all| all.split(|token| is_sign(Some(token), ',')));
            names.zip(values).filter(|(_, value)| writes_text(value)).filter_map(|(of, _)| name(of)).collect()
        }
        _ => name(names).filter(|_| writes_text(values)).into_iter().collect(),
    }
}

/// How a variable is taken apart in these tokens, until another one has its name.
fn looked_into(name: &str, tokens: &[TokenTree]) -> Vec<String> {
    let mut found = Vec::new();
    for (k, token) in tokens.iter().enumerate() {
        match token {
            TokenTree::Group(group) => {
                let inner: Vec<TokenTree> = group.stream().into_iter().collect();
                found.extend(looked_into(name, &inner));
            }
            TokenTree::Ident(word) if *word == name => {
                let before = k.checked_sub(1).map(|k| &tokens[k]);
                if matches!(before, Some(TokenTree::Ident(word)) if *word == "let" || *word == "mut") {
                    break;
                }
                let how = taking_apart(&tokens[k + 1..]).filter(|_| !is_sign(before, '.'));
                found.extend(how.map(|method| format!("{name}.{method}")));
            }
            _ => {}
        }
    }
    found
}

/// Whether a group after `pub` says for whom, as `(crate)` does.
fn limits_visibility(group: &Group) -> bool {
    let first = group.stream().into_iter().next().map(|token| token.to_string());
    first.is_some_and(|word| ["crate", "super", "self", "in"].contains(&&*word))
}

/// Whether the tokens end with `#[cfg(test)]` or the like.
fn is_for_tests(tokens: &[TokenTree]) -> bool {
    let [.., TokenTree::Punct(sign), TokenTree::Group(group)] = tokens else { return false };
    let text: String = group.stream().to_string().split_whitespace().collect();
    let condition = text.strip_prefix("cfg(").unwrap_or_default();
    sign.as_char() == '#' && (condition.starts_with("test") || condition.starts_with("all(test"))
}

/// The place behind the item that begins at token `k`.
fn end_of_item(tokens: &[TokenTree], k: usize) -> usize {
    let imports =
        tokens[k..].iter().take(3).any(|token| matches!(token, TokenTree::Ident(word) if *word == "use"));
    let ends = |token: &TokenTree| match token {
        TokenTree::Group(group) => !imports && group.delimiter() == Delimiter::Brace,
        TokenTree::Punct(sign) => sign.as_char() == ';',
        _ => false,
    };
    tokens[k..].iter().position(ends).map_or(tokens.len(), |length| k + length + 1)
}
