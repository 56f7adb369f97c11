//! Errors put in on purpose, one at a time: which claims and which tests see them.
//!
//! They stand in `expected/deliberate_errors.toml`. A copy of the project under `target/` gets all
//! of them at once, each behind a switch that an environment variable turns (`armed`), so that it
//! is built once for all; those that cannot stand behind a switch are put in by themselves. Only
//! tests that come to an error's switch are run with it. The project is never touched.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::{fs, io};

use rayon::prelude::*;
use serde::Deserialize;
use sha2::{Digest, Sha256};

use crate::errors::armed::{REACHED, SWITCH, VARIABLE, armed};

mod armed;

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
    /// Only tests that compare with what the program wrote before; their names.
    Frozen(Vec<String>),
    /// No test failed, but the tests did not end by themselves, or not in time.
    NotEnded,
    /// The program does not compile with it.
    DoesNotCompile,
    /// Nobody.
    Unseen,
}

/// The crates that are observers: their tests are run in this order, after those of the crate that
/// the error stands in.
const OBSERVERS: [&str; 15] = [
    "claims",
    "theorems",
    "model",
    "continuation",
    "source",
    "description",
    "results",
    "unfold",
    "analysis",
    "reproduction",
    "drawing",
    "report",
    "export",
    "trials",
    "cli",
];

/// Tests that compare with what the program wrote before, by parts of their names.
const FROZEN: [&str; 4] = ["snapshots::", "no_figure_changes_unnoticed", "examples::", "messages::"];
/// Tests that a copy fails with no error in it, or that say nothing of one: of the browser, of time,
/// of files that are compared with the checkout's, and of the list of errors itself.
const LEFT_OUT: [&str; 4] = ["explore::", "workflow::", "mutations::", "every_error_can_be_put_in"];

/// The table.
pub const TABLE: &str = "expected/deliberate_errors.md";

const HEAD: &str = "\
# Deliberate errors

Errors put in on purpose, one at a time (`expected/deliberate_errors.toml`), and who saw each: the claims of the ledger that fail, or, where none
does, the tests of the first crate whose tests do. \"Frozen tests\" are those that compare with pictures, tables and messages that the program wrote
before, and know nothing better; they stand here only where nothing else saw the error.
Made by `cargo run --release -p grazing-trials -- errors [NUMBER...]`.

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

/// A test program: its crate, and where it is.
struct TestProgram {
    of: String,
    program: PathBuf,
}

/// A copy of the project to put errors into.
pub struct Copy<'a> {
    root: PathBuf,
    /// The original.
    from: PathBuf,
    errors: &'a [DeliberateError],
    /// Whether each of them stands behind its switch.
    switched: Vec<bool>,
    programs: Vec<TestProgram>,
}

impl<'a> Copy<'a> {
    /// Brings the copy up to date and builds it with these errors behind their switches; files that
    /// have not changed stay, so that little is built again.
    ///
    /// # Errors
    /// A file cannot be read or written, the project is no checkout of git, or does not compile.
    pub fn of(from: &Path, errors: &'a [DeliberateError]) -> io::Result<Self> {
        let root = from.join("target/deliberate_errors");
        let listed = Command::new("git").args(["ls-files", "-z"]).current_dir(from).output()?;
        let files = String::from_utf8(listed.stdout).map_err(|error| invalid(error.to_string()))?;
        if !listed.status.success() || files.is_empty() {
            return Err(invalid(String::from_utf8_lossy(&listed.stderr).into_owned()));
        }
        fs::create_dir_all(root.join("target"))?;
        let switched = vec![true; errors.len()];
        let mut copy = Self { root, from: from.to_owned(), errors, switched, programs: Vec::new() };
        // What the project has no more goes.
        let record = copy.root.join("target/files");
        let before = fs::read_to_string(&record).unwrap_or_default();
        let now: BTreeSet<&str> = files.split_terminator('\0').collect();
        for file in before.split_terminator('\0').filter(|file| !now.contains(file)) {
            fs::remove_file(copy.root.join(file))?;
        }
        fs::write(record, &files)?;
        for file in now {
            let own = copy.switched_in(Path::new(file));
            if !own.is_empty() {
                let (_, left) = armed(&fs::read_to_string(from.join(file))?, &own);
                left.into_iter().for_each(|number| copy.switched[number - 1] = false);
            }
            copy.restore(Path::new(file))?;
        }
        // Whatever the compiler does not accept behind a switch is put in by itself.
        while let Err(error) = copy.build() {
            copy.unswitch(&error.to_string())?;
        }
        Ok(copy)
    }

    /// The file's content in the copy: with its errors behind switches, or as it is.
    fn content(&self, file: &Path) -> io::Result<Vec<u8>> {
        let original = fs::read(self.from.join(file))?;
        let own = self.switched_in(file);
        let folder = file.to_string_lossy();
        let is_root = self.errors.iter().any(|error| {
            let crate_of = error.file.components().take(2).collect::<PathBuf>();
            Path::new(folder.as_ref()) == crate_of.join("src/lib.rs")
        });
        if own.is_empty() && !is_root {
            return Ok(original);
        }
        let text = String::from_utf8(original).map_err(|error| invalid(error.to_string()))?;
        let (mut text, _) = armed(&text, &own);
        if is_root {
            text.push_str(SWITCH);
        }
        Ok(text.into_bytes())
    }

    /// The errors of a file that are behind switches, with their numbers.
    fn switched_in(&self, file: &Path) -> Vec<(usize, &'a DeliberateError)> {
        let numbered = (1..).zip(self.errors);
        numbered.filter(|(number, error)| error.file == file && self.switched[number - 1]).collect()
    }

    /// Brings a file up to date.
    fn restore(&self, file: &Path) -> io::Result<()> {
        let (content, here) = (self.content(file)?, self.root.join(file));
        if fs::read(&here).is_ok_and(|copy| copy == content) {
            return Ok(());
        }
        if let Some(folder) = here.parent() {
            fs::create_dir_all(folder)?;
        }
        fs::write(here, content)
    }

    /// Takes the errors from behind their switches that stand where the compiler found a mistake.
    fn unswitch(&mut self, messages: &str) -> io::Result<()> {
        let mut files = BTreeSet::new();
        let mut changed = false;
        for message in messages.lines().filter(|line| line.contains(": error")) {
            let mut parts = message.splitn(4, ':');
            let (Some(file), Some(Ok(line))) = (parts.next(), parts.next().map(str::parse::<usize>)) else {
                continue;
            };
            let text = fs::read_to_string(self.root.join(file))?;
            let end = text.match_indices('\n').nth(line - 1).map_or(text.len(), |(at, _)| at);
            // Every switch of the function, or the nearest one before.
            let mark = text[..end].rfind("crate::deliberate_error(").map(|at| &text[at..]);
            let number = mark.and_then(|mark| mark.split(['(', ')']).nth(1)?.parse::<usize>().ok());
            let Some(number) = number.filter(|number| self.switched[number - 1]) else { continue };
            self.switched[number - 1] = false;
            changed = true;
            files.insert(PathBuf::from(file));
        }
        if !changed {
            return Err(invalid(messages.to_owned()));
        }
        files.iter().try_for_each(|file| self.restore(file))
    }

    fn cargo(&self, arguments: &[&str]) -> io::Result<Output> {
        let packages = OBSERVERS.map(|name| format!("-pgrazing-{name}"));
        Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
            .args(arguments)
            .arg("--locked")
            .args(packages)
            .current_dir(&self.root)
            .env("CARGO_TARGET_DIR", self.root.join("target"))
            .output()
    }

    /// Builds the test programs.
    fn build(&mut self) -> io::Result<()> {
        let built = self.cargo(&["test", "--no-run", "--message-format=short"])?;
        let messages = String::from_utf8_lossy(&built.stderr);
        if !built.status.success() {
            return Err(invalid(messages.into_owned()));
        }
        // `Executable tests/claims.rs (target/debug/deps/claims-0123456789abcdef)`
        let program = |line: &str| {
            let (_, rest) = line.trim().strip_prefix("Executable ")?.rsplit_once('(')?;
            Some(PathBuf::from(rest.strip_suffix(')')?))
        };
        let mut programs = Vec::new();
        for program in messages.lines().filter_map(program) {
            let of = self.crate_of(&program)?;
            programs.push(TestProgram { of, program });
        }
        let place = |of: &str| OBSERVERS.iter().position(|name| *name == of);
        programs.sort_by_key(|test| place(&test.of));
        self.programs = programs;
        Ok(())
    }

    /// The crate of a test program, from cargo's list of the files that it is made of.
    fn crate_of(&self, program: &Path) -> io::Result<String> {
        let made_of = fs::read_to_string(self.root.join(program).with_extension("d"))?;
        let first = made_of.lines().next().and_then(|line| line.split_once(": ")?.1.split(' ').next());
        let of = first.and_then(|file| file.split("crates/").last()?.split('/').next());
        of.map(str::to_owned).ok_or_else(|| invalid(format!("{}: of no crate", program.display())))
    }

    /// Tries an error out, by its place in the list.
    ///
    /// # Errors
    /// A file cannot be read or written, or a program not be run.
    pub fn try_out(&mut self, index: usize) -> io::Result<Seen> {
        let error = &self.errors[index];
        if self.switched[index] {
            return self.seen(index);
        }
        let text = fs::read_to_string(self.from.join(&error.file))?;
        let mut wrong = text.replacen(&error.find, &error.replace, 1);
        let root_of_crate = error.file.ends_with("src/lib.rs");
        if root_of_crate {
            wrong.push_str(SWITCH);
        }
        fs::write(self.root.join(&error.file), wrong)?;
        let seen = match self.build() {
            Ok(()) => self.seen(index),
            Err(error) if error.to_string().contains("could not compile") => Ok(Seen::DoesNotCompile),
            Err(error) => Err(error),
        };
        self.restore(&error.file)?;
        self.build()?;
        seen
    }

    /// Who sees an error that is in, or is behind its switch: the claims, then the tests of its own
    /// crate, then those of the others, until one does that compares with nothing frozen.
    fn seen(&self, index: usize) -> io::Result<Seen> {
        let own = self.errors[index].file.components().nth(1).map(|part| part.as_os_str().to_owned());
        let is_own = |test: &&TestProgram| own.as_deref() == Some(test.of.as_ref());
        let (claims, rest): (Vec<_>, Vec<_>) =
            self.programs.iter().partition(|test| test.program.to_string_lossy().contains("/claims-"));
        let (first, others): (Vec<_>, Vec<_>) = rest.into_iter().partition(is_own);
        let (mut frozen, mut not_ended) = (Vec::new(), false);
        for test in claims.into_iter().chain(first).chain(others) {
            let reaching = if self.switched[index] { Some(self.reaching(test, index)?) } else { None };
            if reaching.as_ref().is_some_and(Vec::is_empty) {
                continue;
            }
            let Some(failed) = self.failures(test, index, &reaching.unwrap_or_default())? else {
                not_ended = true;
                continue;
            };
            let is_frozen = |name: &String| FROZEN.iter().any(|part| name.contains(part));
            let (old, failed): (Vec<_>, Vec<_>) = failed.into_iter().partition(is_frozen);
            frozen.extend(old);
            if !failed.is_empty() {
                let by_claims = test.program.to_string_lossy().contains("/claims-");
                return Ok(if by_claims { Seen::Claims(failed) } else { Seen::Tests(failed) });
            }
        }
        Ok(match (not_ended, frozen.is_empty()) {
            (true, _) => Seen::NotEnded,
            (_, false) => Seen::Frozen(frozen),
            _ => Seen::Unseen,
        })
    }

    /// The tests of a program that come to the switch of an error, themselves or by a program that they
    /// run. What each comes to is recorded once, in a run of it alone with no error in it.
    fn reaching(&self, test: &TestProgram, index: usize) -> io::Result<Vec<String>> {
        let program = self.root.join(&test.program);
        let record = program.with_extension("reached");
        // Of this very program: one that is built anew is the same if its source is.
        let digest = Sha256::digest(fs::read(&program)?);
        let of = digest.iter().map(|byte| format!("{byte:02x}")).chain(["\n".to_owned()]).collect::<String>();
        if !fs::read_to_string(&record).is_ok_and(|record| record.starts_with(&of)) {
            let listed = self.run(test, "unlimited").args(["--list", "--format", "terse"]).output()?;
            let listed = String::from_utf8_lossy(&listed.stdout);
            let names: Vec<&str> = listed.lines().filter_map(|line| line.strip_suffix(": test")).collect();
            let reached = |(number, name): (usize, &&str)| -> io::Result<String> {
                let own = program.with_extension(format!("reached-{number}"));
                fs::write(&own, "")?;
                self.run(test, "unlimited").args(["--exact", name]).env(REACHED, &own).output()?;
                let numbers = fs::read_to_string(&own)?.replace('\n', " ");
                fs::remove_file(own)?;
                Ok(format!("{name}\t{numbers}\n"))
            };
            let all = names.par_iter().enumerate().map(reached).collect::<io::Result<String>>()?;
            fs::write(&record, of + &all)?;
        }
        let number = (index + 1).to_string();
        let reaches = |line: &str| {
            let (name, numbers) = line.split_once('\t')?;
            numbers.split(' ').any(|one| one == number).then(|| name.to_owned())
        };
        Ok(fs::read_to_string(record)?.lines().filter_map(reaches).collect())
    }

    /// A run of a program's tests, with a limit to its seconds of CPU.
    fn run(&self, test: &TestProgram, longest: &str) -> Command {
        let mut run = Command::new("sh");
        run.args(["-c", "ulimit -t $0; exec \"$@\"", longest])
            .arg(self.root.join(&test.program))
            .args(LEFT_OUT.map(|part| format!("--skip={part}")))
            .current_dir(self.root.join("crates").join(&test.of))
            .env("INSTA_UPDATE", "no");
        run
    }

    /// Of these tests of a program, or of all, those that fail; nothing if it did not end by itself, or
    /// not in time.
    fn failures(&self, test: &TestProgram, index: usize, of: &[String]) -> io::Result<Option<Vec<String>>> {
        let mut run = self.run(test, LONGEST);
        if !of.is_empty() {
            run.arg("--exact").args(of);
        }
        let run = run.env(VARIABLE, (index + 1).to_string()).output()?;
        let output = String::from_utf8_lossy(&run.stdout);
        let failed =
            output.lines().filter_map(|line| line.strip_prefix("test ")?.strip_suffix(" ... FAILED"));
        let failed: Vec<String> = failed.map(str::to_owned).collect();
        Ok((run.status.success() || !failed.is_empty()).then_some(failed))
    }
}

/// In seconds of CPU: the tests of a program take minutes; with an error in a formula a search may go on
/// without end.
const LONGEST: &str = "600";

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
            Self::Frozen(names) => list("frozen test", names),
            Self::NotEnded => {
                write!(f, "tests that do not end by themselves, or not within {LONGEST} s of CPU")
            }
            Self::DoesNotCompile => f.write_str("the compiler"),
            Self::Unseen => f.write_str("**nobody**"),
        }
    }
}
