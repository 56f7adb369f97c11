//! Files with mistakes, produced from correct ones by a seeded generator: every run of the program
//! ends by itself, with an exit code from 0 to 4, and prints a reason unless it is 0. Damaged parts
//! of families are never merged.
//!
//! The tests try a few. The following tries many, and lists and keeps those that fail:
//!
//! ```text
//! GRAZING_MUTATIONS=1000 cargo test -p grazing-cli --test cli mutations -- --nocapture
//! ```
//!
//! where GRAZING_MUTATIONS_FROM is the number of the first (0), and GRAZING_MUTATIONS_SECONDS the
//! CPU time for each in seconds (60).
#![cfg(unix)]

use std::env;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

use crate::family::{VARY, behind_digest, forged};
use crate::program::{empty_folder, end, grazing, narrow_linear, repository};
use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::Rng;

/// The number of mutations that are tried by default.
const HANDFUL: u64 = 8;
/// The number of damaged parts that are tried by default; many take only seconds.
const PARTS: u64 = 100;
/// The address space of a run in kilobytes, and the memory limit of `unfold` in megabytes: stacks
/// and pools of threads take up addresses that are never filled.
const ADDRESSES: u32 = 1_000_000;
const MEMORY: u32 = 500;

/// Values at the edges of what can be computed, and ordinary ones in the wrong place.
const EXTREMES: [&str; 24] = [
    "0", "-1", "1", "2", "13", "0.5", "0.99", "1e-4", "1e-9", "1e-300", "5e-324", "1e6", "1e30", "1e300",
    "1e308", "-1e308", "1e999", "nan", "inf", "-inf", "-0.0", "3.5", "100", "-1e6",
];
const FACTORS: [f64; 12] = [0.01, 0.1, 0.5, 0.9, 1.1, 2.0, 10.0, 100.0, 1e6, 1e-6, -1.0, 1.0 + 1e-12];
const FUNCTIONS: [&str; 12] =
    ["sin", "cos", "tan", "atan", "sinh", "cosh", "tanh", "exp", "ln", "sqrt", "abs", "gamma"];
const OPERATORS: [&str; 5] = ["+", "-", "*", "/", "^"];
/// Terms that are added to a force.
const TERMS: [&str; 16] = [
    " + 0.01/(x-0.1)^2",
    " - 0.01/(x-0.1)^2",
    " + 1e-3/(x-1e-6)",
    " - 1/x",
    " - x^99",
    " + x^3",
    " + exp(1000*v)",
    " - exp(1000*x)",
    " - 1e6*x",
    " + sqrt(x)",
    " - ln(-x)",
    " - tan(x)",
    " + 2*x - x^3",
    "*0",
    " - 0.3*v^3",
    " + 1e9*sin(1e9*t)",
];
/// Values of the wrong types.
const VALUES: [&str; 12] = [
    "\"text\"",
    "\"\"",
    "[1, 2]",
    "[2, 1]",
    "[1, 1]",
    "[]",
    "{ a = 1 }",
    "true",
    "1979-05-27",
    "[[1]]",
    "1.5",
    "\"x + \"",
];
const LOOPS: [&str; 6] =
    ["[1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12]", "[40]", "[1000000]", "[4294967296]", "[2, 2]", "[-1]"];
/// Control characters, marks that change the direction of writing, and other scripts.
const CHARACTERS: [&str; 12] =
    ["\0", "\u{1b}[2J", "\u{7f}", "\r", "\u{feff}", "\u{202e}", "\u{2066}", "ω", "−", "´", "\"", "#"];
const OUTPUTS: [&str; 21] = [
    "coefficients",
    "fig01",
    "fig02",
    "fig03",
    "fig04",
    "fig05",
    "fig06",
    "fig07",
    "fig08",
    "fig09",
    "fig10",
    "beyond_cascade",
    "beyond_atlas",
    "beyond_loops",
    "beyond_regions",
    "beyond_attractors",
    "beyond_proofs",
    "beyond_generations",
    "beyond_branches",
    "straightened",
    "theorems",
];

/// A seeded generator with the choices that mutations need.
struct Dice(Pcg64Mcg);

impl Dice {
    /// The generator of a trial.
    fn of(number: u64) -> Self {
        let mut dice = Pcg64Mcg::new(0x9e37_79b9_7f4a_7c15 ^ (u128::from(number) << 32));
        // Seeds that differ by one bit begin with similar numbers.
        for _ in 0..8 {
            dice.next_u64();
        }
        Self(dice)
    }

    fn below(&mut self, count: usize) -> usize {
        (self.0.next_u64() % count.max(1) as u64) as usize
    }

    fn one_of<'a>(&mut self, items: &[&'a str]) -> &'a str {
        items[self.below(items.len())]
    }

    /// The index of one of the texts that pass a test, if there are any.
    fn place(&mut self, texts: &[String], test: impl Fn(&str) -> bool) -> Option<usize> {
        let places: Vec<usize> = (0..texts.len()).filter(|index| test(&texts[*index])).collect();
        (!places.is_empty()).then(|| places[self.below(places.len())])
    }
}

/// The words, numbers and single other characters of a text, without comments.
fn tokens(text: &str) -> Vec<String> {
    let mut tokens: Vec<String> = Vec::new();
    for line in text.lines() {
        let line = if line.trim_start().starts_with('#') { "" } else { line };
        let word = |character: char| character.is_alphanumeric() || character == '_' || character == '.';
        let mut fresh = true;
        for character in line.chars() {
            match tokens.last_mut() {
                Some(last) if !fresh && word(character) && last.ends_with(word) => last.push(character),
                _ => tokens.push(character.to_string()),
            }
            fresh = false;
        }
        tokens.push("\n".to_owned());
    }
    tokens
}

fn is_number(token: &str) -> bool {
    token.starts_with(|character: char| character.is_ascii_digit())
}

fn is_visible(token: &str) -> bool {
    !token.trim().is_empty()
}

/// A text with one change; empty if the text has no place for the change that the dice chose.
fn mutate(text: &str, dice: &mut Dice) -> String {
    if dice.below(3) == 0 { mutate_line(text, dice) } else { mutate_token(text, dice) }.unwrap_or_default()
}

/// Changes a number, a name, an operator or a range.
fn mutate_token(text: &str, dice: &mut Dice) -> Option<String> {
    let mut tokens = tokens(text);
    match dice.below(12) {
        // Numbers most often: by a factor, by extremes.
        0..=2 => {
            let index = dice.place(&tokens, is_number)?;
            let value: f64 = tokens[index].parse().unwrap_or(1.0);
            tokens[index] = format!("{}", value * FACTORS[dice.below(FACTORS.len())]);
        }
        3 | 4 => {
            let index = dice.place(&tokens, is_number)?;
            tokens[index] = dice.one_of(&EXTREMES).to_owned();
        }
        5 => {
            let index = dice.place(&tokens, is_visible)?;
            tokens.remove(index);
        }
        6 => {
            let (from, to) = (dice.place(&tokens, is_visible)?, dice.place(&tokens, is_visible)?);
            tokens.insert(to, tokens[from].clone());
        }
        7 => {
            let index = dice.place(&tokens, |token| FUNCTIONS.contains(&token))?;
            tokens[index] = dice.one_of(&FUNCTIONS).to_owned();
        }
        8 => {
            let index = dice.place(&tokens, |token| OPERATORS.contains(&token))?;
            tokens[index] = dice.one_of(&OPERATORS).to_owned();
        }
        9 => {
            let character = dice.one_of(&CHARACTERS);
            let index = dice.place(&tokens, is_visible)?;
            // Occasionally a long one.
            let times = if dice.below(4) == 0 { 100_000 } else { 1 };
            tokens[index].push_str(&character.repeat(times));
        }
        _ => {
            let begin = dice.place(&tokens, |token| token == "[")?;
            let end = begin + tokens[begin..].iter().position(|token| token == "]")?;
            let inside = tokens[begin + 1..end].concat();
            let (a, b) = inside.split_once(',')?;
            let range = match dice.below(3) {
                0 => format!("[{}, {}]", dice.one_of(&EXTREMES), dice.one_of(&EXTREMES)),
                1 => format!("[{b}, {a}]"),
                _ => format!("[{a}, {a}]"),
            };
            tokens.splice(begin..=end, [range]);
        }
    }
    Some(tokens.concat())
}

/// Changes a line as a whole, its value, or the end of a force.
fn mutate_line(text: &str, dice: &mut Dice) -> Option<String> {
    let mut lines: Vec<String> = tokens(text).concat().lines().map(str::to_owned).collect();
    let index = dice.place(&lines, is_visible)?;
    let value = |line: &str, value: &str| Some(format!("{} = {value}", line.split_once(" = ")?.0));
    match dice.below(8) {
        0 => {
            lines.remove(index);
        }
        1 => lines.insert(index, lines[index].clone()),
        2 => {
            let other = dice.place(&lines, is_visible)?;
            lines.swap(index, other);
        }
        3 => lines[index] = value(&lines[index], dice.one_of(&VALUES))?,
        4 => {
            let index = dice.place(&lines, |line| line.starts_with("loops = ["))?;
            lines[index] = value(&lines[index], dice.one_of(&LOOPS))?;
        }
        _ => {
            let index = dice.place(&lines, |line| line.starts_with("force = \""))?;
            // The last quotation mark of the line ends the force.
            let end = lines[index].rfind('"')?;
            lines[index].insert_str(end, dice.one_of(&TERMS));
        }
    }
    Some(lines.join("\n") + "\n")
}

/// The sections of a parameter file whose names a test accepts, with their tables.
fn sections(text: &str, test: impl Fn(&str) -> bool) -> String {
    let mut chosen = false;
    let is_chosen = |line: &&str| {
        if let Some(header) = line.strip_prefix('[') {
            chosen = test(header.trim_start_matches('[').split(['.', ']']).next().unwrap_or_default());
        }
        chosen
    };
    text.lines().filter(is_chosen).flat_map(|line| [line, "\n"]).collect()
}

/// The arguments of a run, and the text of the file that they name.
fn trial(number: u64) -> (Vec<String>, String) {
    let mut dice = Dice::of(number);
    let read = |path: &str| fs::read_to_string(repository().join(path)).expect("it is in the repository");
    let changes = 1 + dice.below(3);
    let (mut text, arguments) = if dice.below(5) < 2 {
        let whole = read("figures/parameters.toml");
        let arguments = "reproduce --parameters o.toml --output out --jobs 1";
        // A change is more likely to matter if the file has only what the output needs.
        match dice.one_of(&OUTPUTS) {
            _ if dice.below(3) == 0 => (whole, arguments.to_owned()),
            name => {
                let also =
                    if matches!(name, "coefficients" | "fig08" | "straightened") { "fig07" } else { name };
                let needed = sections(&whole, |section| ["oscillator", name, also].contains(&section));
                (needed, format!("{arguments} --only {name}"))
            }
        }
    } else {
        let names =
            ["paper", "duffing", "varying-impact", "quadratic-damping", "clearance", "shaking-table", "afm"];
        // Well below the time that the trial waits; short for the default, which should not take long.
        let limit = if asked("GRAZING_MUTATIONS").is_some() { 0.3 * seconds() } else { 2.0 };
        let limits = format!("--time-limit {limit} --memory-limit {MEMORY}");
        let text = read(&format!("examples/{}.toml", dice.one_of(&names)));
        (text, format!("unfold o.toml --output out --jobs 1 {limits}"))
    };
    for _ in 0..changes {
        let changed = mutate(&text, &mut dice);
        text = if changed.is_empty() { text } else { changed };
    }
    (arguments.split(' ').map(str::to_owned).collect(), text)
}

fn seconds() -> f64 {
    asked("GRAZING_MUTATIONS_SECONDS").unwrap_or(60) as f64
}

fn asked(variable: &str) -> Option<u64> {
    env::var(variable).ok()?.parse().ok()
}

/// The end of a run in words, and whether it is as it should be.
fn run(program: &Path, folder: &Path, arguments: &[String], text: &str) -> (String, bool) {
    fs::write(folder.join("o.toml"), text).expect("the folder is ours");
    let messages = folder.join("messages");
    let mut run = Command::new("sh")
        .arg("-c")
        .arg(format!("ulimit -v {ADDRESSES}; ulimit -t {}; exec \"$0\" \"$@\"", seconds()))
        .arg(program)
        .args(arguments)
        .current_dir(folder)
        .stdout(Stdio::null())
        .stderr(fs::File::create(&messages).expect("the folder is ours"))
        .spawn()
        .expect("the program starts");
    let code = end(&mut run);
    let told = String::from_utf8_lossy(&fs::read(&messages).expect("the folder is ours")).into_owned();
    let errors: Vec<&str> = told.lines().filter_map(|line| line.strip_prefix("error: ")).collect();
    match code {
        None => (format!("no end: {}", told.lines().last().unwrap_or_default()), false),
        Some(None) => (format!("ended by a signal, or after {} s of a processor: {told}", seconds()), false),
        _ if told.contains("panicked at") => (format!("panic: {told}"), false),
        Some(Some(0)) => ("exit code 0".to_owned(), errors.is_empty()),
        Some(Some(code)) => (
            format!("exit code {code}: {}", errors.join(" / ")),
            (1..=4).contains(&code) && errors.iter().any(|error| names_a_cause(error)),
        ),
    }
}

/// Whether a sentence names the file or one of its keys.
fn names_a_cause(error: &str) -> bool {
    let key = |word: &str| {
        let section = word.split('.').next().unwrap_or_default();
        word.len() > section.len() + 1 && (section == "oscillator" || OUTPUTS.contains(&section))
    };
    error.contains(".toml:") || error.split([' ', ',', ';']).any(key)
}

#[test]
#[expect(clippy::print_stdout, reason = "of a thousand files one wants to hear before the last")]
fn every_file_leads_to_an_end_with_a_reason() {
    let count = asked("GRAZING_MUTATIONS").unwrap_or(HANDFUL);
    let from = asked("GRAZING_MUTATIONS_FROM").unwrap_or(0);
    // A copy, as a long trial may outlive many builds.
    let place = empty_folder();
    let program = place.path().join("grazing");
    fs::copy(env!("CARGO_BIN_EXE_grazing"), &program).expect("the folder is ours");
    let mut complaints = Vec::new();
    for number in from..from + count {
        let (arguments, text) = trial(number);
        let folder = empty_folder();
        let (end, right) = run(&program, folder.path(), &arguments, &text);
        let mark = if right { "" } else { "WRONG " };
        let told = format!("{mark}{number}: {}: {end}", arguments.join(" "));
        println!("{told}");
        if !right {
            let kept = env::temp_dir().join(format!("grazing-mutation-{number}.toml"));
            fs::write(&kept, &text).expect("the system's folder can be written");
            complaints.push(format!("{}: {told}", kept.display()));
        }
    }
    assert!(complaints.is_empty(), "{} of {count}:\n{}", complaints.len(), complaints.join("\n"));
}

/// The texts of the parts of a family, from a file without comments, which mutations would remove.
fn parts<const COUNT: usize>(folder: &Path) -> [String; COUNT] {
    let text = narrow_linear();
    let lines = text.lines().filter(|line| !line.starts_with('#'));
    fs::write(folder.join("my.toml"), lines.collect::<Vec<_>>().join("\n")).expect("the folder is ours");
    std::array::from_fn(|index| {
        let part = format!("{}/{COUNT}", index + 1);
        let made = grazing(folder, &[&["unfold", "my.toml"], &VARY[..], &["--part", &part]].concat());
        assert_eq!(made.code, Some(0), "{}", made.messages);
        format!("families/my/parts/{}-of-{COUNT}.toml", index + 1)
    })
}

/// Bytes as damaged by a bad disk, an interrupted copy or an editor.
fn damaged(part: &[u8], dice: &mut Dice) -> Vec<u8> {
    let mut bytes = part.to_vec();
    let place = dice.below(bytes.len());
    let other = dice.below(bytes.len());
    match dice.below(6) {
        0 => bytes.truncate(place),
        1 => bytes[place] ^= 1 << dice.below(8),
        2 => drop(bytes.drain(place.min(other)..=place.max(other))),
        3 => bytes.insert(place, part[other]),
        4 => bytes[place.min(other)..=place.max(other)].fill(0),
        // Another digit, like a number changed by hand.
        _ => {
            let digits: Vec<usize> =
                (0..bytes.len()).filter(|index| bytes[*index].is_ascii_digit()).collect();
            let place = digits[dice.below(digits.len())];
            bytes[place] = b'0' + (bytes[place] - b'0' + 1 + dice.below(9) as u8) % 10;
        }
    }
    bytes
}

#[test]
fn no_damaged_part_is_merged() {
    let folder = empty_folder();
    let names = parts::<4>(folder.path());
    let merge = [&["merge", "--output", "out"], &names.each_ref().map(String::as_str)[..]].concat();
    let count = asked("GRAZING_MUTATIONS").unwrap_or(PARTS);
    for number in 0..count {
        let mut dice = Dice::of(number);
        let path = folder.path().join(&names[dice.below(names.len())]);
        let part = fs::read(&path).expect("it was written");
        let damaged = damaged(&part, &mut dice);
        if damaged == part {
            continue;
        }
        fs::write(&path, damaged).expect("the folder is ours");
        let outcome = grazing(folder.path(), &merge);
        assert_eq!((outcome.code, outcome.output.as_str()), (Some(2), ""), "{number}: {}", outcome.messages);
        assert!(!folder.path().join("out").exists(), "{number}");
        fs::write(&path, part).expect("the folder is ours");
    }
    assert_eq!(grazing(folder.path(), &merge).code, Some(0), "those that are whole are merged");
}

/// A part with a correct digest and arbitrary content leads to an exit with a reason.
#[test]
fn parts_that_somebody_else_wrote_lead_to_an_end_with_a_reason() {
    let folder = empty_folder();
    let [name] = parts(folder.path());
    let arguments = ["merge", "--output", "out", &name].map(str::to_owned);
    let path = folder.path().join(&name);
    let part = fs::read_to_string(&path).expect("it was written");
    let count = asked("GRAZING_MUTATIONS").unwrap_or(PARTS / 3);
    let (mut complaints, mut merged) = (Vec::new(), 0);
    for number in 0..count {
        let mut dice = Dice::of(number);
        let mut text = behind_digest(&part).to_owned();
        for _ in 0..=dice.below(3) {
            let changed = mutate(&text, &mut dice);
            text = if changed.is_empty() { text } else { changed };
        }
        fs::write(&path, forged(&text)).expect("the folder is ours");
        let program = Path::new(env!("CARGO_BIN_EXE_grazing"));
        let (end, right) = run(program, folder.path(), &arguments, "");
        merged += u64::from(end == "exit code 0");
        if !right {
            complaints.push(format!("{number}: {end}\n{text}"));
        }
    }
    assert!(complaints.is_empty(), "{} of {count}:\n{}", complaints.len(), complaints.join("\n"));
    assert!(0 < merged && merged < count, "{merged} of {count} were merged");
}

#[test]
fn mutations_differ_and_come_again_the_same() {
    let texts: Vec<_> = (0..50).map(trial).collect();
    assert_eq!(texts, (0..50).map(trial).collect::<Vec<_>>());
    let different =
        (1..texts.len()).filter(|k| !texts[..*k].iter().any(|other| other.1 == texts[*k].1)).count();
    assert!(different > 40, "{different}");
}
