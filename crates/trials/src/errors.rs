//! Errors put into formulas on purpose, one at a time: which claims and which tests see them.
//!
//! They stand in `expected/deliberate_errors.toml`. Each is put into a copy of the project under
//! `target/`, and the copy's file is put back before the next. The project is never touched.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{fs, io};

use serde::Deserialize;

/// One error.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DeliberateError {
    /// What is wrong with it, in words.
    pub meaning: String,
    /// The file, from the root of the project.
    pub file: PathBuf,
    /// What stands there, once.
    pub find: String,
    /// What is put in its place.
    pub replace: String,
}

#[derive(Deserialize)]
struct List {
    error: Vec<DeliberateError>,
}

/// Who saw an error.
#[derive(Debug, PartialEq)]
pub enum Seen {
    /// Labels of claims that failed.
    Claims(Vec<String>),
    /// No claim did; names of tests that failed.
    Tests(Vec<String>),
    /// No test failed, but the tests did not end by themselves, or not in time.
    NotEnded,
    /// The program does not compile with it.
    DoesNotCompile,
    /// Nobody.
    Unseen,
}

/// The crates whose tests are run where no claim sees an error: those that the errors stand in.
const TESTED: [&str; 3] = ["grazing-theorems", "grazing-model", "grazing-continuation"];

/// The table.
pub const TABLE: &str = "expected/deliberate_errors.md";

const HEAD: &str = "\
# Deliberate errors

Errors put into formulas on purpose, one at a time (`expected/deliberate_errors.toml`), and who saw each: the claims of the ledger that fail,
or, where none does, the tests of the crates that they stand in. Made by `cargo run --release -p grazing-trials -- errors [NUMBER...]`.

| number | error | seen by |
|---|---|---|
";

fn invalid(message: String) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, message)
}

/// The list under the root of the project; each of its errors can be put in.
///
/// # Errors
/// A file cannot be read, or what is to be replaced does not stand in it exactly once.
pub fn list(root: &Path) -> io::Result<Vec<DeliberateError>> {
    let text = fs::read_to_string(root.join("expected/deliberate_errors.toml"))?;
    let List { error } = toml::from_str(&text).map_err(|error| invalid(error.to_string()))?;
    for DeliberateError { file, find, meaning, .. } in &error {
        let times = fs::read_to_string(root.join(file))?.matches(find.as_str()).count();
        if times != 1 {
            return Err(invalid(format!("{meaning}: stands {times} times in {}", file.display())));
        }
    }
    Ok(error)
}

/// A copy of the project to put errors into.
pub struct Copy {
    root: PathBuf,
    /// The original.
    from: PathBuf,
}

impl Copy {
    /// Brings the copy up to date; files that have not changed stay, so that little is built again.
    ///
    /// # Errors
    /// A file cannot be read or written, or the project is no checkout of git.
    pub fn of(from: &Path) -> io::Result<Self> {
        let root = from.join("target/deliberate_errors");
        let listed = Command::new("git").args(["ls-files", "-z"]).current_dir(from).output()?;
        let files = String::from_utf8(listed.stdout).map_err(|error| invalid(error.to_string()))?;
        if !listed.status.success() || files.is_empty() {
            return Err(invalid(String::from_utf8_lossy(&listed.stderr).into_owned()));
        }
        fs::create_dir_all(root.join("target"))?;
        let copy = Self { root, from: from.to_owned() };
        // What the project has no more goes.
        let record = copy.root.join("target/files");
        let before = fs::read_to_string(&record).unwrap_or_default();
        let now: BTreeSet<&str> = files.split_terminator('\0').collect();
        for file in before.split_terminator('\0').filter(|file| !now.contains(file)) {
            fs::remove_file(copy.root.join(file))?;
        }
        for file in now {
            copy.restore(Path::new(file))?;
        }
        fs::write(record, &files)?;
        Ok(copy)
    }

    /// Puts a file back.
    fn restore(&self, file: &Path) -> io::Result<()> {
        let (original, here) = (fs::read(self.from.join(file))?, self.root.join(file));
        if fs::read(&here).is_ok_and(|copy| copy == original) {
            return Ok(());
        }
        if let Some(folder) = here.parent() {
            fs::create_dir_all(folder)?;
        }
        fs::write(here, original)
    }

    /// Puts the error in, runs claims and tests, and puts the file back.
    ///
    /// # Errors
    /// A file cannot be read or written, or cargo not be run.
    pub fn try_out(&self, error: &DeliberateError) -> io::Result<Seen> {
        let text = fs::read_to_string(self.from.join(&error.file))?;
        fs::write(self.root.join(&error.file), text.replacen(&error.find, &error.replace, 1))?;
        let seen = self.seen();
        self.restore(&error.file)?;
        seen
    }

    fn seen(&self) -> io::Result<Seen> {
        let by_claims = self.seen_in(&["-p", "grazing-claims", "--test", "claims"], Seen::Claims)?;
        if !matches!(by_claims, Seen::Unseen | Seen::NotEnded) {
            return Ok(by_claims);
        }
        let packages: Vec<&str> = TESTED.iter().flat_map(|package| ["-p", package]).collect();
        let by_tests = self.seen_in(&packages, Seen::Tests)?;
        Ok(if by_tests == Seen::Unseen { by_claims } else { by_tests })
    }

    /// Who sees the error among these tests. They are built first, without a time limit.
    fn seen_in(&self, what: &[&str], failures: fn(Vec<String>) -> Seen) -> io::Result<Seen> {
        // `timeout` ends the tests with cargo, which by itself would leave them running.
        let run = |limit: &str, more: &[&str]| {
            let mut run = Command::new("timeout");
            run.args(["--signal=KILL", limit])
                .arg(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
            run.args(["test", "--locked", "--no-fail-fast"]).args(what).args(more).current_dir(&self.root);
            run.env("CARGO_TARGET_DIR", self.root.join("target")).env("INSTA_UPDATE", "no").output()
        };
        let build = run("0", &["--no-run"])?;
        if !build.status.success() {
            let message = String::from_utf8_lossy(&build.stderr).into_owned();
            let wrong = message.contains("could not compile");
            return if wrong { Ok(Seen::DoesNotCompile) } else { Err(invalid(message)) };
        }
        let tests = run(LONGEST, &[])?;
        let output = String::from_utf8_lossy(&tests.stdout);
        let failed =
            output.lines().filter_map(|line| line.strip_prefix("test ")?.strip_suffix(" ... FAILED"));
        let failed: Vec<String> = failed.map(str::to_owned).collect();
        Ok(if !failed.is_empty() {
            failures(failed)
        } else if tests.status.success() {
            Seen::Unseen
        } else {
            Seen::NotEnded
        })
    }
}

/// In seconds: tests take half a minute; with an error in a formula a search may go on without end.
const LONGEST: &str = "180";

/// The table with new rows in it, in the list's order; other rows stay if still listed.
pub fn table(before: &str, list: &[DeliberateError], new: &BTreeMap<usize, Seen>) -> String {
    let cells = |line: &str| {
        let mut cells = line.trim_matches(['|', ' ']).splitn(3, " | ").map(str::to_owned);
        Some([cells.next()?, cells.next()?, cells.next()?])
    };
    let old: BTreeMap<String, String> =
        before.lines().filter_map(cells).map(|[_, meaning, seen]| (meaning, seen)).collect();
    let mut table = HEAD.to_owned();
    for (number, error) in (1..).zip(list) {
        let seen = match new.get(&number) {
            Some(seen) => seen.to_string(),
            None => old.get(&error.meaning).cloned().unwrap_or_else(|| "not tried out yet".to_owned()),
        };
        // Writing to a string cannot fail.
        let _ = writeln!(table, "| {number} | {} | {seen} |", error.meaning);
    }
    table
}

impl std::fmt::Display for Seen {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let mut list = |kind: &str, names: &[String]| {
            let first: Vec<String> = names.iter().take(3).map(|name| format!("`{name}`")).collect();
            let more = if names.len() > first.len() { ", …" } else { "" };
            let plural = if names.len() == 1 { "" } else { "s" };
            write!(f, "{} {kind}{plural}: {}{more}", names.len(), first.join(", "))
        };
        match self {
            Self::Claims(labels) => list("claim", labels),
            Self::Tests(names) => list("test", names),
            Self::NotEnded => write!(f, "tests that do not end by themselves, or not within {LONGEST} s"),
            Self::DoesNotCompile => f.write_str("the compiler"),
            Self::Unseen => f.write_str("**nobody**"),
        }
    }
}
