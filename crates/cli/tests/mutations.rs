//! Files with mistakes, made from those that are right by a seeded generator: every run of the program ends by itself, with an exit
//! code from 0 to 4, and says why if it is not 0.
//!
//! The tests try a handful. Many are tried, and what is wrong is listed and kept, by
//!
//! ```text
//! GRAZING_MUTATIONS=1000 cargo test --release -p grazing-cli --test mutations -- --nocapture
//! ```
//!
//! where GRAZING_MUTATIONS_FROM is the number of the first (0), and GRAZING_MUTATIONS_SECONDS the time for each (60).
#![cfg(unix)]

mod program;

use std::env;
use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use program::{empty_folder, repository};
use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::Rng;

/// What is tried where nobody asks for more.
const HANDFUL: u64 = 8;
/// Memory in kilobytes that the system gives a run; the program's own limit is a little below 1 GB.
const MEMORY: u32 = 2_000_000;

/// Values at the edges of what can be computed, and ordinary ones in the wrong place.
const EXTREMES: [&str; 24] = [
    "0", "-1", "1", "2", "13", "0.5", "0.99", "1e-4", "1e-9", "1e-300", "5e-324", "1e6", "1e30", "1e300",
    "1e308", "-1e308", "1e999", "nan", "inf", "-inf", "-0.0", "3.5", "100", "-1e6",
];
const FUNCTIONS: [&str; 12] =
    ["sin", "cos", "tan", "atan", "sinh", "cosh", "tanh", "exp", "ln", "sqrt", "abs", "gamma"];
/// What is added to a force.
const TERMS: [&str; 14] = [
    " + 0.01/(x-0.1)^2",
    " - 0.01/(x-0.1)^2",
    " - x^99",
    " + x^3",
    " + exp(1000*v)",
    " - exp(1000*x)",
    " - 1e6*x",
    " + sqrt(x)",
    " - ln(-x)",
    " - 1/x",
    " - tan(x)",
    " + 2*x - x^3",
    "*0",
    " - 0.3*v^3",
];
const OUTPUTS: [&str; 12] = [
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
    "theorems",
];

/// A seeded generator with what mutations need.
struct Dice(Pcg64Mcg);

impl Dice {
    fn below(&mut self, count: usize) -> usize {
        (self.0.next_u64() % count.max(1) as u64) as usize
    }

    fn one_of<'a>(&mut self, items: &[&'a str]) -> &'a str {
        items[self.below(items.len())]
    }
}

/// A text in words, numbers, and single other characters, comments left out.
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

/// Changes one thing.
fn mutate(text: &str, dice: &mut Dice) -> String {
    let mut tokens = tokens(text);
    let places = |test: &dyn Fn(&str) -> bool, tokens: &[String]| -> Vec<usize> {
        (0..tokens.len()).filter(|index| test(&tokens[*index])).collect()
    };
    let visible = |token: &str| !token.trim().is_empty();
    match dice.below(10) {
        // Numbers, most of all: by a factor, by extremes.
        0..=2 => {
            let numbers = places(&is_number, &tokens);
            let index = numbers[dice.below(numbers.len())];
            let factor = [0.01, 0.1, 0.5, 0.9, 1.1, 2.0, 10.0, 100.0][dice.below(8)];
            let value: f64 = tokens[index].parse().unwrap_or(1.0);
            tokens[index] = format!("{}", value * factor);
        }
        3 | 4 => {
            let numbers = places(&is_number, &tokens);
            let index = numbers[dice.below(numbers.len())];
            tokens[index] = dice.one_of(&EXTREMES).to_owned();
        }
        5 => {
            let all = places(&visible, &tokens);
            tokens.remove(all[dice.below(all.len())]);
        }
        6 => {
            let all = places(&visible, &tokens);
            let (from, to) = (all[dice.below(all.len())], all[dice.below(all.len())]);
            tokens.insert(to, tokens[from].clone());
        }
        7 => {
            let functions = places(&|token| FUNCTIONS.contains(&token), &tokens);
            if !functions.is_empty() {
                tokens[functions[dice.below(functions.len())]] = dice.one_of(&FUNCTIONS).to_owned();
            }
        }
        8 => {
            // The end of a force, as the last quotation mark of its line.
            let text = tokens.concat();
            let Some(start) = text.find("force = \"") else { return text };
            let end = start + text[start..].find('\n').unwrap_or(0) - 1;
            return format!("{}{}{}", &text[..end], dice.one_of(&TERMS), &text[end..]);
        }
        _ => {
            let ranges = places(&|token| token == "[", &tokens);
            let index = ranges[dice.below(ranges.len())];
            let end =
                tokens[index..].iter().position(|token| token == "]").map_or(index, |length| index + length);
            let [a, b] = [dice.one_of(&EXTREMES), dice.one_of(&EXTREMES)];
            tokens.splice(index..=end, [format!("[{a}, {b}]")]);
        }
    }
    tokens.concat()
}

/// The arguments of a run, and the text of the file that they name.
fn trial(number: u64) -> (Vec<String>, String) {
    let mut dice = Dice(Pcg64Mcg::new(0x9e37_79b9_7f4a_7c15 ^ (u128::from(number) << 32)));
    // Numbers that differ by one bit begin alike.
    for _ in 0..8 {
        dice.0.next_u64();
    }
    let read = |path: &str| fs::read_to_string(repository().join(path)).expect("it is in the repository");
    let changes = 1 + dice.below(3);
    let parameters = dice.below(4) == 0;
    let mut text = if parameters {
        read("figures/parameters.toml")
    } else {
        let names = ["paper", "duffing", "varying-impact", "quadratic-damping", "clearance"];
        read(&format!("examples/{}.toml", dice.one_of(&names)))
    };
    for _ in 0..changes {
        text = mutate(&text, &mut dice);
    }
    let arguments = if parameters {
        format!("reproduce --only {} --parameters o.toml --output out --jobs 1", dice.one_of(&OUTPUTS))
    } else {
        // Before the time that the trial waits; little for the handful, in which nobody asked for patience.
        let seconds = if asked("GRAZING_MUTATIONS").is_some() { 0.7 * seconds() } else { 2.0 };
        format!("unfold o.toml --output out --jobs 1 --time-limit {seconds} --memory-limit 1000")
    };
    (arguments.split(' ').map(str::to_owned).collect(), text)
}

fn seconds() -> f64 {
    asked("GRAZING_MUTATIONS_SECONDS").unwrap_or(60) as f64
}

fn asked(variable: &str) -> Option<u64> {
    env::var(variable).ok()?.parse().ok()
}

/// Waits for the end; none comes in time from a run that is ended here.
fn code(run: &mut Child) -> Option<Option<i32>> {
    let began = Instant::now();
    loop {
        if let Some(status) = run.try_wait().expect("it is ours") {
            return Some(status.code());
        }
        if began.elapsed().as_secs_f64() > seconds() {
            run.kill().expect("it still runs");
            run.wait().expect("it ends");
            return None;
        }
        thread::sleep(Duration::from_millis(5));
    }
}

/// What is wrong with how a run ends, if anything.
fn complaint(folder: &Path, arguments: &[String], text: &str) -> Option<String> {
    fs::write(folder.join("o.toml"), text).expect("the folder is ours");
    let messages = folder.join("messages");
    let mut run = Command::new("sh")
        .arg("-c")
        .arg(format!("ulimit -v {MEMORY}; exec \"$0\" \"$@\""))
        .arg(env!("CARGO_BIN_EXE_grazing"))
        .args(arguments)
        .current_dir(folder)
        .stdout(Stdio::null())
        .stderr(fs::File::create(&messages).expect("the folder is ours"))
        .spawn()
        .expect("the program starts");
    let code = code(&mut run);
    let told = String::from_utf8_lossy(&fs::read(&messages).expect("the folder is ours")).into_owned();
    let last = || told.lines().rev().take(3).collect::<Vec<_>>().join(" / ");
    let sentence = told.lines().any(|line| line.starts_with("error: ") && line.len() > "error: ".len() + 10);
    match code {
        None => Some(format!("no end: {}", last())),
        Some(None) => Some(format!("ended by a signal: {}", last())),
        _ if told.contains("panicked at") => Some(format!("panic: {told}")),
        Some(Some(0)) => None,
        Some(Some(1..=4)) if sentence => None,
        Some(Some(code)) => Some(format!("exit code {code} with: {}", last())),
    }
}

#[test]
#[expect(clippy::print_stdout, reason = "of a thousand files one wants to hear before the last")]
fn every_file_leads_to_an_end_with_a_reason() {
    let count = asked("GRAZING_MUTATIONS").unwrap_or(HANDFUL);
    let from = asked("GRAZING_MUTATIONS_FROM").unwrap_or(0);
    let mut complaints = Vec::new();
    for number in from..from + count {
        let (arguments, text) = trial(number);
        let folder = empty_folder();
        if let Some(complaint) = complaint(folder.path(), &arguments, &text) {
            let kept = env::temp_dir().join(format!("grazing-mutation-{number}.toml"));
            fs::write(&kept, &text).expect("the system's folder can be written");
            let complaint = format!("{number}: {}: {}\n  {complaint}", kept.display(), arguments.join(" "));
            println!("{complaint}");
            complaints.push(complaint);
        }
    }
    assert!(complaints.is_empty(), "{} of {count}:\n{}", complaints.len(), complaints.join("\n"));
}

#[test]
fn mutations_differ_and_come_again_the_same() {
    let texts: Vec<_> = (0..50).map(trial).collect();
    assert_eq!(texts, (0..50).map(trial).collect::<Vec<_>>());
    let different =
        (1..texts.len()).filter(|k| !texts[..*k].iter().any(|other| other.1 == texts[*k].1)).count();
    assert!(different > 40, "{different}");
}
