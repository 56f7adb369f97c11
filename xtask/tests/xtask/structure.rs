//! What ARCHITECTURE.md says of the files of every crate: they use each other in one direction, what computes does no input and
//! output, and one file of a program writes to the terminal.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;
use std::sync::LazyLock;

use crate::sources::{Sources, shortest_circle};

fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
}

/// The crates of the workspace, with the sources of libraries and programs.
static CRATES: LazyLock<BTreeMap<String, Vec<Sources>>> = LazyLock::new(|| {
    let folders = fs::read_dir(root().join("crates")).expect("it is there");
    let names =
        folders.map(|entry| entry.expect("it is there").file_name().into_string().expect("it is text"));
    let folders =
        names.map(|name| (name.clone(), format!("crates/{name}"))).chain([("xtask".into(), "xtask".into())]);
    let read = |(name, folder): (String, String)| {
        let text = |file: &str| fs::read_to_string(root().join(file)).ok();
        let roots = ["lib.rs", "main.rs"].map(|name| format!("{folder}/src/{name}"));
        let roots = roots.into_iter().filter(|file| root().join(file).is_file());
        (name, roots.map(|file| Sources::read(&file, &text)).collect())
    };
    folders.map(read).collect()
});

/// The crates that do no input and output, as ARCHITECTURE.md lists them.
fn pure() -> Vec<String> {
    let text = fs::read_to_string(root().join("ARCHITECTURE.md")).expect("it is there");
    let (before, _) = text.split_once("do no I/O and never").expect("there is such a sentence");
    let (_, sentence) = before.rsplit_once("\n- ").expect("it is in a list");
    sentence.split('`').skip(1).step_by(2).map(str::to_owned).collect()
}

/// What does input or output, or asks the system.
const SYSTEM: [&str; 8] = ["fs", "net", "process", "env", "os", "io::stdin", "io::stdout", "io::stderr"];
/// What writes to the terminal.
const STREAMS: [&str; 2] = ["io::stdout", "io::stderr"];
/// The one file of each program that writes to the terminal.
const TERMINALS: [&str; 3] = ["crates/cli/src/terminal.rs", "crates/trials/src/main.rs", "xtask/src/main.rs"];

/// The uses of any of these parts of std, by file.
fn uses(sources: &Sources, parts: &[&str]) -> BTreeSet<(String, String)> {
    let parts: Vec<String> = parts.iter().map(|part| format!("std::{part}")).collect();
    knowing(sources, &parts.iter().map(String::as_str).collect::<Vec<_>>())
}

/// What writes to the terminal, by file.
fn writes(sources: &Sources) -> impl Iterator<Item = (String, String)> {
    let own = |(file, _): &(String, String)| !TERMINALS.contains(&&**file);
    sources.prints.iter().cloned().chain(uses(sources, &STREAMS)).filter(own)
}

/// Files that look into a text which they write, since it is the only way to what another library knows: the digits of a
/// number, causes that an error repeats, and what cargo says.
const LOOKING: [&str; 3] =
    ["crates/certify/src/statement.rs", "crates/cli/src/failure.rs", "crates/trials/src/errors.rs"];

/// What only one place knows: the beginnings of its paths, and that place.
const KNOWN_ONCE: [(&[&str], &str); 3] = [
    (&["polars", "polars_arrow", "polars_parquet"], "crates/cli/src/tables.rs"),
    (&["plotters", "plotters_backend"], "crates/drawing/"),
    (&["std::net", "tokio", "hyper", "hyper_util", "http_body_util"], "crates/explore/src/server"),
];

/// Whether a path is this part, or lies in it.
fn lies_in(path: &str, part: &str) -> bool {
    path.strip_prefix(part).is_some_and(|rest| rest.is_empty() || rest.starts_with("::"))
}

/// The uses of any of these, by file.
fn knowing(sources: &Sources, parts: &[&str]) -> BTreeSet<(String, String)> {
    let known = |(_, path): &(String, String)| parts.iter().any(|part| lies_in(path, part));
    sources.external().into_iter().filter(known).collect()
}

#[test]
fn files_of_a_crate_do_not_use_each_other_in_circles() {
    let circles: BTreeSet<String> = CRATES.values().flatten().flat_map(Sources::circles).collect();
    assert!(circles.is_empty(), "{circles:#?}");
}

#[test]
fn files_of_the_page_do_not_import_each_other_in_circles() {
    let folder = root().join("crates/explore/page");
    let names =
        fs::read_dir(&folder).expect("it is there").map(|entry| entry.expect("it is there").file_name());
    let names = names.map(|name| name.into_string().expect("it is text"));
    let files: Vec<String> = names.filter(|name| name.ends_with(".js")).collect();
    let imports = |name: &String| -> BTreeSet<usize> {
        let text = fs::read_to_string(folder.join(name)).expect("it is text");
        let from = text.lines().filter(|line| line.starts_with("import "));
        let from = from.filter_map(|line| line.split_once("\"./")?.1.split_once('"')).map(|(other, _)| other);
        // One is made from the table of kinds.
        from.filter_map(|other| files.iter().position(|file| file == other)).collect()
    };
    let used: Vec<BTreeSet<usize>> = files.iter().map(imports).collect();
    assert!(used.iter().map(BTreeSet::len).sum::<usize>() > files.len(), "{used:?}");
    let circles = (0..files.len()).filter_map(|file| shortest_circle(&used, file));
    let circles: Vec<Vec<&str>> =
        circles.map(|circle| circle.into_iter().map(|file| &*files[file]).collect()).collect();
    assert!(circles.is_empty(), "{circles:?}");
}

#[test]
fn what_computes_does_no_input_and_output() {
    let pure = pure();
    assert!(pure.len() > 6, "{pure:?}");
    for name in pure {
        let sources =
            CRATES.get(&name).unwrap_or_else(|| panic!("ARCHITECTURE.md: there is no crate {name}"));
        let found: Vec<_> = sources.iter().flat_map(|sources| uses(sources, &SYSTEM)).collect();
        assert!(found.is_empty(), "{name}: {found:#?}");
    }
}

#[test]
fn one_file_of_a_program_writes_to_the_terminal() {
    let all = || CRATES.values().flatten();
    let found: Vec<_> = all().flat_map(writes).collect();
    assert!(found.is_empty(), "{found:#?}");
    let files: BTreeSet<_> =
        all().flat_map(|sources| uses(sources, &STREAMS)).map(|(file, _)| file).collect();
    assert!(files.contains(TERMINALS[0]), "it is found where it may be: {files:?}");
}

#[test]
fn nothing_takes_apart_a_text_that_it_writes() {
    let all = || CRATES.values().flatten().flat_map(|sources| &sources.taken_apart);
    let found: Vec<_> = all().filter(|(file, _)| !LOOKING.contains(&&**file)).collect();
    assert!(found.is_empty(), "{found:#?}");
    let exceptions: BTreeSet<_> = all().map(|(file, _)| &**file).collect();
    assert_eq!(exceptions, BTreeSet::from(LOOKING), "exceptions that are none");
}

#[test]
fn what_one_place_knows_no_other_does() {
    for (parts, place) in KNOWN_ONCE {
        let found: BTreeSet<_> =
            CRATES.values().flatten().flat_map(|sources| knowing(sources, parts)).collect();
        let (inside, elsewhere): (Vec<_>, Vec<_>) =
            found.into_iter().partition(|(file, _)| file.starts_with(place));
        assert!(elsewhere.is_empty(), "{elsewhere:#?}");
        assert!(!inside.is_empty(), "it is found where it may be: {place}");
    }
    // What starts the program has no library, apart from those of its tests.
    let manifest = fs::read_to_string(root().join("xtask/Cargo.toml")).expect("it is there");
    assert!(manifest.contains("\n[dev-dependencies]") && !manifest.contains("\n[dependencies"), "{manifest}");
}

/// Names that types of several crates have, each with the reason.
const SHARED_NAMES: [(&str, &str); 1] = [(
    "LinearOscillator",
    "the paper's oscillator, in `model` with its forcing and in `theorems` for any: the ledger of claims names both",
)];

#[test]
fn no_two_crates_export_types_of_one_name() {
    // What is public can be seen from outside: the compiler says where it cannot (`unreachable_pub`).
    let mut crates: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    for (name, sources) in &*CRATES {
        for exported in sources.iter().flat_map(|sources| &sources.types) {
            crates.entry(exported).or_default().insert(name);
        }
    }
    assert!(crates.len() > 500, "{}", crates.len());
    crates.retain(|_, crates| crates.len() > 1);
    for (name, reason) in SHARED_NAMES {
        assert!(crates.remove(name).is_some(), "an exception that is none: {name}, {reason}");
    }
    assert!(crates.is_empty(), "one word for several things: {crates:#?}");
}

#[test]
fn types_that_are_exported_are_seen() {
    for (text, names) in [
        ("pub struct A; pub(crate) struct B; struct C;", "A"),
        ("mod inner { pub enum A {} pub trait B {} pub type C = A; }", "A B C"),
        ("keys! { /// A table.\n pub struct A { b: u32 = count(), \"…\"; } }", "A"),
        (
            "tables! { /// All.\n A: Dimensioned { rows: R = \"r\", \"a row\", } #[derive(Clone)] B { } }",
            "A B",
        ),
        ("fn f() { vec![A { b }]; let c = A { b }; } row! { A, |own| {} [B = own.b,] }", ""),
        ("impl T for A { type B = C; } #[cfg(test)] mod tests { pub struct D; } // pub struct E;", ""),
    ] {
        let found = planted(&[("lib.rs", text)]).types;
        assert_eq!(found.iter().map(String::as_str).collect::<Vec<_>>().join(" "), names, "{text}");
    }
}

/// The sources of a crate of these files, in `src/`, the first of which is its root.
fn planted(files: &[(&str, &str)]) -> Sources {
    let text = |wanted: &str| {
        let found = files.iter().find(|(name, _)| wanted.strip_prefix("src/") == Some(*name));
        found.map(|(_, text)| (*text).to_owned())
    };
    Sources::read("src/lib.rs", &text)
}

#[test]
fn circles_are_seen_however_they_are_written() {
    let root = "pub mod a; mod b; pub use b::B;";
    let circle = BTreeSet::from(["src/a.rs → src/b.rs → src/a.rs".to_owned()]);
    for to in
        ["use crate::b::B;", "use crate::{b::{self, B as C}};", "use crate::B;", "fn f() { crate::b::g(); }"]
    {
        for back in [
            "use super::a::A;",
            "fn g() { vec![super::a::f()]; }",
            "mod inner { use crate::a::*; const C: A = A; }",
        ] {
            let sources = planted(&[
                ("lib.rs", root),
                ("a.rs", &format!("{to} pub struct A;")),
                ("b.rs", &format!("{back} pub struct B;")),
            ]);
            assert_eq!(sources.circles(), circle, "{to} {back}");
        }
    }
    let three = planted(&[
        ("lib.rs", "mod a; mod b; mod c;"),
        ("a.rs", "mod inner; pub use inner::I;"),
        ("a/inner.rs", "use crate::b::B; pub struct I;"),
        ("b.rs", "use crate::c::C; pub struct B;"),
        ("c.rs", "use crate::a::I; pub struct C(I);"),
    ]);
    let circle = "src/a/inner.rs → src/b.rs → src/c.rs → src/a/inner.rs".to_owned();
    assert_eq!(three.circles(), BTreeSet::from([circle]));
    let none = planted(&[
        ("lib.rs", "mod a; mod b; pub use a::A;"),
        (
            "a.rs",
            "// use crate::b::B;\n#[cfg(test)] mod tests { use crate::b::*; use super::*; } pub struct A(&'static str);",
        ),
        ("b.rs", "mod inner; pub struct B; fn f() -> crate::A { inner::g(\"crate::b::B\") }"),
        // A submodule belongs to the module above it.
        ("b/inner.rs", "use super::B; pub fn g() -> crate::A { crate::A(B.text) }"),
    ]);
    assert_eq!(none.circles(), BTreeSet::new());
}

#[test]
fn input_and_output_is_seen_however_it_is_written() {
    for (text, path) in [
        ("use std::fs;", "std::fs"),
        ("use std::{io, fs::File as F};", "std::fs::File"),
        ("fn f() { std::env::var(\"HOME\"); }", "std::env::var"),
        ("use std::net::*;", "std::net"),
        ("fn f() -> ::std::fs::File {}", "std::fs::File"),
        ("macro_rules! m { () => { ::std::process::exit(1) } }", "std::process::exit"),
        ("use std::io; fn f() { json!({ \"a\": io::stdin() }) }", "std::io::stdin"),
    ] {
        let found = uses(&planted(&[("lib.rs", text)]), &SYSTEM);
        assert!(found.contains(&("src/lib.rs".to_owned(), path.to_owned())), "{text}: {found:?}");
    }
    let innocent = "//! std::fs\nconst A: &str = env!(\"OUT_DIR\"); #[cfg(test)] mod tests { use std::fs; } use std::fmt;";
    assert_eq!(uses(&planted(&[("lib.rs", innocent)]), &SYSTEM), BTreeSet::new());
}

#[test]
fn texts_that_are_taken_apart_are_seen() {
    for (text, how) in [
        ("fn f() { doubt.to_string().split(\": \").next() }", "text.split"),
        ("fn f() { g(|| format!(\"{x}\").strip_prefix('-')) }", "text.strip_prefix"),
        ("fn f() { let reason = doubt.to_string(); h(reason.split_once(\": \")) }", "reason.split_once"),
        (
            "fn f() { let (n, mut why) = (all.len(), doubt.to_string()); if why.contains(\"x\") {} }",
            "why.contains",
        ),
        (
            "fn f() { let key: String = format!(\"{kind} #{rank}\"); { key.rsplit('#').next() } }",
            "key.rsplit",
        ),
    ] {
        let found = planted(&[("lib.rs", text)]).taken_apart;
        assert_eq!(found, BTreeSet::from([("src/lib.rs".to_owned(), how.to_owned())]), "{text}");
    }
    for innocent in [
        "fn f() { let a = b.to_string(); a.len() }",
        "fn f() { let a = b.to_string(); let a = read(c); a.split(' ') }",
        "fn f() { let a = format!(\"{b}\"); other.a.split(' ') }",
        "fn f(a: &str) { { let a = b.to_string(); } a.split(' ') }",
        "fn f() { label.replace(' ', KEPT) }",
        "#[cfg(test)] mod tests { fn f() { a.to_string().contains(\"b\") } }",
    ] {
        assert_eq!(planted(&[("lib.rs", innocent)]).taken_apart, BTreeSet::new(), "{innocent}");
    }
}

#[test]
fn what_is_known_elsewhere_is_seen() {
    let [tables, drawing, server] = KNOWN_ONCE.map(|(parts, _)| parts);
    for (text, parts) in [
        ("use polars::prelude::*;", tables),
        ("fn f() { polars_parquet::write::g() }", tables),
        ("use plotters::{element::Text, prelude as p};", drawing),
        ("fn f() { std::net::TcpListener::bind(\"\") }", server),
    ] {
        assert!(!knowing(&planted(&[("lib.rs", text)]), parts).is_empty(), "{text}");
    }
    let innocent = "/// polars::prelude\nuse polarsome::A; const P: &str = \"plotters::prelude\";";
    let sources = planted(&[("lib.rs", innocent)]);
    assert!([tables, drawing, server].iter().all(|parts| knowing(&sources, parts).is_empty()));
}

#[test]
fn what_writes_to_the_terminal_is_seen() {
    for text in [
        "fn f() { println!(\"here\"); }",
        "fn f() { g(|| eprintln!()); }",
        "fn f() { print!(\"\"); }",
        "use std::io; fn f() { writeln!(io::stderr(), \"here\"); }",
    ] {
        assert_eq!(writes(&planted(&[("lib.rs", text)])).count(), 1, "{text}");
    }
    let innocent = "/// println!(\"here\")\nfn f() { let print = 1; writeln!(text, \"println!()\"); }";
    assert_eq!(writes(&planted(&[("lib.rs", innocent)])).count(), 0);
}
