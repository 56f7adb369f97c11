//! Mutation tests: errors are introduced one at a time, and the claims and tests that notice them are
//! recorded.
//!
//! The errors are listed in `expected/deliberate_errors.toml`. A copy of the project under `target/`
//! contains all of them at once, each behind a switch that an environment variable sets (`armed`), so
//! that it is built only once; those that do not compile behind a switch are introduced singly. Only
//! tests that reach an error's switch are run with it. The project itself is never changed.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::{fs, io};

use rayon::prelude::*;
use sha2::{Digest, Sha256};

mod armed;
mod listed;

pub use armed::armed;
use armed::{REACHED, SWITCH, VARIABLE};
use listed::invalid;
pub use listed::{DeliberateError, list};

/// The claims or tests that noticed an error.
#[derive(Debug, PartialEq)]
pub enum SeenBy {
    /// Labels of claims that failed.
    Claims(Vec<String>),
    /// No claim failed; names of tests that failed.
    Tests(Vec<String>),
    /// The only tests that failed compare with earlier output of the program; their names.
    Frozen(Vec<String>),
    /// No test failed, but some tests crashed or ran out of time.
    NotEnded,
    /// The program does not compile with the error.
    DoesNotCompile,
    /// No claim or test noticed the error.
    Unseen,
}

/// The crates whose tests are run, in this order, after those of the crate that contains the error.
const OBSERVERS: [&str; 14] = [
    "claims",
    "theorems",
    "model",
    "continuation",
    "input",
    "results",
    "unfold",
    "analysis",
    "reproduction",
    "beyond",
    "drawing",
    "report",
    "trials",
    "cli",
];

/// Parts of the names of tests that compare with earlier output of the program.
const FROZEN: [&str; 4] = ["snapshots::", "no_figure_changes_unnoticed", "examples::", "messages::"];
/// Parts of the names of tests that are not run: they fail in a copy even without an error, or do not
/// depend on one. They test the browser, timing, files that are compared with the checkout's, and the
/// list of errors itself.
const LEFT_OUT: [&str; 4] = ["explore::", "workflow::", "mutations::", "every_error_can_be_put_in"];

/// The table of results, from the root of the project.
pub const TABLE: &str = "expected/deliberate_errors.md";

const HEAD: &str = "\
# Deliberate errors

Errors put in on purpose, one at a time (`expected/deliberate_errors.toml`), and who saw each: the claims of the ledger that fail, or, where none
does, the tests of the first crate whose tests do. \"Frozen tests\" are those that compare with pictures, tables and messages that the program wrote
before, and know nothing better; they stand here only where nothing else saw the error.
Made by `cargo run -p grazing-trials -- errors [NUMBER...]`.

| number | error | seen by |
|---|---|---|
";

/// A test program, with its crate and its path.
struct TestProgram {
    of: String,
    program: PathBuf,
}

/// A copy of the project in which errors are introduced.
pub struct Copy<'a> {
    root: PathBuf,
    /// The root of the original project.
    from: PathBuf,
    errors: &'a [DeliberateError],
    /// Whether each error is behind a switch.
    switched: Vec<bool>,
    programs: Vec<TestProgram>,
}

impl<'a> Copy<'a> {
    /// Updates the copy and builds it with these errors behind their switches; unchanged files are kept,
    /// so that little is rebuilt.
    ///
    /// # Errors
    /// A file cannot be read or written, or the project is not a git checkout or does not compile.
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
        // Files that the project no longer has are deleted.
        let record = copy.root.join("target/files");
        let before = fs::read_to_string(&record).unwrap_or_default();
        let now: BTreeSet<&str> = files.split_terminator('\0').collect();
        for file in before.split_terminator('\0').filter(|file| !now.contains(file)) {
            let gone = copy.root.join(file);
            fs::remove_file(&gone)?;
            // Folders that are empty now: one of a crate without its manifest cannot be built.
            let _ = gone.ancestors().skip(1).map_while(|folder| fs::remove_dir(folder).ok()).count();
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
        // Errors that the compiler rejects behind a switch are introduced singly.
        while let Err(error) = copy.build() {
            copy.unswitch(&error.to_string())?;
        }
        Ok(copy)
    }

    /// The content of a file in the copy: with its errors behind switches, or unchanged.
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

    /// Updates a file in the copy.
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

    /// Removes the switches of the errors in which the compiler found a mistake.
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
            // The nearest switch before the mistake.
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

    /// The crate of a test program, from cargo's list of its source files.
    fn crate_of(&self, program: &Path) -> io::Result<String> {
        let made_of = fs::read_to_string(self.root.join(program).with_extension("d"))?;
        let first = made_of.lines().next().and_then(|line| line.split_once(": ")?.1.split(' ').next());
        let of = first.and_then(|file| file.split("crates/").last()?.split('/').next());
        of.map(str::to_owned).ok_or_else(|| invalid(format!("{}: of no crate", program.display())))
    }

    /// Tries one error, given by its index in the list.
    ///
    /// # Errors
    /// A file cannot be read or written, or a program cannot be run.
    pub fn try_out(&mut self, index: usize) -> io::Result<SeenBy> {
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
            Err(error) if error.to_string().contains("could not compile") => Ok(SeenBy::DoesNotCompile),
            Err(error) => Err(error),
        };
        self.restore(&error.file)?;
        self.build()?;
        seen
    }

    /// The claims or tests that notice an error. The claims are run first, then the tests of the error's
    /// own crate, then those of the others, until a test fails that does not compare with earlier output.
    fn seen(&self, index: usize) -> io::Result<SeenBy> {
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
                return Ok(if by_claims { SeenBy::Claims(failed) } else { SeenBy::Tests(failed) });
            }
        }
        Ok(match (not_ended, frozen.is_empty()) {
            (true, _) => SeenBy::NotEnded,
            (_, false) => SeenBy::Frozen(frozen),
            _ => SeenBy::Unseen,
        })
    }

    /// The tests of a program that reach the switch of an error, directly or through a program that they
    /// run. The switches that each test reaches are recorded once, in a separate run without errors.
    fn reaching(&self, test: &TestProgram, index: usize) -> io::Result<Vec<String>> {
        let program = self.root.join(&test.program);
        let record = program.with_extension("reached");
        // The record is valid for this very program: a program built again from the same source is
        // identical.
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

    /// A run of a program's tests, with a limit on CPU seconds.
    fn run(&self, test: &TestProgram, longest: &str) -> Command {
        let mut run = Command::new("sh");
        run.args(["-c", "ulimit -t $0; exec \"$@\"", longest])
            .arg(self.root.join(&test.program))
            .args(LEFT_OUT.map(|part| format!("--skip={part}")))
            .current_dir(self.root.join("crates").join(&test.of))
            .env("INSTA_UPDATE", "no");
        run
    }

    /// The names of the failing tests, of these tests of a program or of all if `of` is empty; nothing if
    /// the program crashed or ran out of time.
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

/// The limit on CPU seconds: the tests of a program take minutes, and with an error in a formula a search
/// may never end.
const LONGEST: &str = "600";

/// The table with new rows, in the order of the list; other rows are kept if they are still listed.
pub fn table(before: &str, list: &[DeliberateError], new: &BTreeMap<usize, SeenBy>) -> String {
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

impl std::fmt::Display for SeenBy {
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
