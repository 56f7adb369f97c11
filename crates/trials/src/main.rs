//! Runs the long trials: `grazing-trials regions`, `nonlinear`, `damped` and `errors`.
#![expect(clippy::print_stdout, clippy::print_stderr, reason = "a program's output")]

use std::collections::BTreeMap;
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

use grazing_continuation::curve::Window;
use grazing_input::Description;
use grazing_trials::nonlinear::{self, Disagreement};
use grazing_trials::random::Random;
use grazing_trials::{damped, errors, lines, oscillators, parts, regions};

const USAGE: &str = "usage: grazing-trials regions [OSCILLATORS [SEED]]      linear ones against the closed form
       grazing-trials windows [OSCILLATORS [SEED]]      the same in parts of windows, along lines, however narrow regions are
       grazing-trials windows FILE...                   diagrams of parts of windows against those of the whole
       grazing-trials nonlinear [OSCILLATORS [SEED]]    the examples and random ones against continuation and simulation
       grazing-trials nonlinear FILE...                 the same for those of files
       grazing-trials damped [OSCILLATORS [SEED]]       hardly damped and overdamped ones, under slow and fast forcing: time, and what is undecided
       grazing-trials damped FILE...                    the same for those of files
       grazing-trials describe NUMBER [SEED]            a random oscillator as a file for `grazing unfold`
       grazing-trials errors [NUMBER...]                deliberate errors, and which claims and tests see them
SEED may also be given as `--seed SEED`.";

/// The number of random points for each oscillator.
const POINTS: usize = 2000;
/// The number of lattice points in each direction, and of random states at each point.
const LATTICE: usize = 40;
const STATES: u32 = 10;
/// The number of parts of a window, and of lines in each.
const PARTS: usize = 20;
const LINES: usize = 500;
/// The numbers of loops.
const LOOPS: [u32; 3] = [1, 2, 3];

fn main() -> ExitCode {
    let mut arguments: Vec<String> = std::env::args().skip(1).collect();
    let named = arguments.windows(2).position(|pair| pair[0] == "--seed");
    let named = named.map(|at| arguments.drain(at..at + 2).next_back().unwrap_or_default());
    let number = |place: usize, otherwise: u64| {
        arguments.get(place).map_or(Some(otherwise), |argument| argument.parse().ok())
    };
    let seed = named.as_ref().map_or_else(|| number(2, 1), |seed| seed.parse().ok());
    let right = match arguments.first().map(String::as_str) {
        Some("regions") => match (number(1, 40), seed) {
            (Some(count), Some(seed)) if arguments.len() <= 3 => linear(count, seed),
            _ => return usage(),
        },
        Some("windows") => match (number(1, 10), seed) {
            (Some(count), Some(seed)) if arguments.len() <= 3 => windows(count, seed),
            _ => arguments[1..].iter().all(|file| windows_of(file)),
        },
        Some("nonlinear") => match (number(1, 10), seed) {
            (Some(count), Some(seed)) if arguments.len() <= 3 => examples_and_random(count, seed),
            _ => files(&arguments[1..]),
        },
        Some("damped") => match (number(1, 20), seed) {
            (Some(count), Some(seed)) if arguments.len() <= 3 => {
                let texts = (1..=count).map(|number| damped::Damped::new(seed, number).description());
                unfolded(texts.collect())
            }
            _ => unfolded(
                arguments[1..].iter().map(|file| std::fs::read_to_string(file).unwrap_or_default()).collect(),
            ),
        },
        Some("describe") => match (number(1, 1), seed) {
            (Some(number), Some(seed)) if arguments.len() > 1 => {
                print!("{}", oscillators::description(seed, number));
                true
            }
            _ => return usage(),
        },
        Some("errors") => match arguments[1..].iter().map(|argument| argument.parse()).collect() {
            Ok(numbers) => deliberate_errors(numbers),
            Err(_) => return usage(),
        },
        _ => return usage(),
    };
    if right { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

fn usage() -> ExitCode {
    eprintln!("{USAGE}");
    ExitCode::from(2)
}

/// Tries the deliberate errors with these numbers, or all, and writes the table; returns whether each is
/// noticed.
fn deliberate_errors(numbers: Vec<usize>) -> bool {
    let tried = || -> std::io::Result<bool> {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
        let list = errors::list(&root)?;
        let mut copy = errors::Copy::of(&root, &list)?;
        let (mut seen, mut right) = (BTreeMap::new(), true);
        for (number, error) in (1..).zip(&list).filter(|(n, _)| numbers.is_empty() || numbers.contains(n)) {
            let start = Instant::now();
            let by = copy.try_out(number - 1)?;
            println!("{number:3} {}: {by}, {:.0} s", error.meaning, start.elapsed().as_secs_f64());
            right &= by != errors::SeenBy::Unseen;
            seen.insert(number, by);
            let table = root.join(errors::TABLE);
            let before = std::fs::read_to_string(&table).unwrap_or_default();
            std::fs::write(table, errors::table(&before, &list, &seen))?;
        }
        Ok(right)
    };
    tried().unwrap_or_else(|error| {
        eprintln!("{error}");
        false
    })
}

/// Compares linear oscillators with random damping, restitution and window with the closed form.
fn linear(count: u64, seed: u64) -> bool {
    let mut random = Random::new(seed);
    let (mut wrong, mut hatched) = (0, Vec::new());
    for number in 1..=count {
        let (zeta, epsilon) = (random.logarithmic(0.003, 0.3), random.uniform(0.3, 1.0));
        let window = Window { primary: [0.0, random.uniform(1.0, 3.0)], secondary: [0.25, 1.3] };
        let start = Instant::now();
        let outcome = regions::compare(zeta, epsilon, window, &[1, 2, 3, 4], POINTS, &mut random);
        let (missed, shaded) = (outcome.missed.len(), outcome.false_shading.len());
        println!(
            "{number:3} zeta {zeta:.5} epsilon {epsilon:.4} A < {:.3}: {} right, {missed} missed, {shaded} falsely shaded, \
             {:.4} hatched, {:.2} s",
            window.primary[1],
            outcome.shaded,
            outcome.hatched,
            start.elapsed().as_secs_f64(),
        );
        for (name, list) in [("missed", &outcome.missed), ("falsely shaded", &outcome.false_shading)] {
            for (p, [amplitude, omega]) in list {
                println!("    {name}: p = {p} at A = {amplitude:.5}, omega = {omega:.5}");
            }
        }
        for doubt in &outcome.doubts {
            println!("    {doubt}");
        }
        wrong += missed + shaded;
        hatched.push(outcome.hatched);
    }
    hatched.sort_by(f64::total_cmp);
    let (median, most) = (hatched.get(hatched.len() / 2), hatched.last());
    println!(
        "{wrong} wrong; hatched: median {:.4}, most {:.4}",
        median.unwrap_or(&0.0),
        most.unwrap_or(&0.0)
    );
    wrong == 0
}

/// Compares linear oscillators with random damping and restitution, in a window and in parts of it, with
/// the closed form on lines. The first one is the paper's.
fn windows(count: u64, seed: u64) -> bool {
    let mut random = Random::new(seed);
    let mut right = true;
    for number in 1..=count {
        let mut parameters = [random.logarithmic(0.003, 0.3), random.uniform(0.3, 1.0)];
        let mut window = Window { primary: [0.0, random.uniform(1.0, 3.0)], secondary: [0.25, 1.3] };
        if number == 1 {
            parameters = of_the_paper();
            window = Window { primary: [0.0, 1.3], secondary: [0.35, 1.02] };
        }
        for part in 0..=PARTS {
            let window = if part == 0 { window } else { lines::part(window, &mut random) };
            let start = Instant::now();
            let outcome = lines::compare(parameters, window, &LOOPS, LINES, &mut random);
            let ([zeta, epsilon], seconds) = (parameters, start.elapsed().as_secs_f64());
            println!(
                "{number:3} zeta {zeta:.5} epsilon {epsilon:.4} {:?} x {:?}: {} of {LINES} lines wrong, {:.5} hatched, {seconds:.2} s",
                window.primary,
                window.secondary,
                outcome.wrong.len(),
                outcome.hatched
            );
            outcome.wrong.iter().take(5).for_each(|wrong| println!("    {wrong:?}"));
            right &= outcome.wrong.is_empty();
        }
    }
    right
}

/// Damping ratio and restitution of the paper's oscillator; NaN if the example lacks them.
fn of_the_paper() -> [f64; 2] {
    let example = Description::parse(include_str!("../../../examples/paper.toml"), "examples/paper.toml");
    ["zeta", "epsilon"].map(|wanted| {
        let constants = example.iter().flat_map(Description::constants);
        constants.filter(|(name, _)| *name == wanted).map(|(_, value)| value).next().unwrap_or(f64::NAN)
    })
}

/// Compares the diagram of an oscillator from a file in its window with those in parts of the window.
fn windows_of(file: &str) -> bool {
    let described = Description::from_file(Path::new(file)).map_err(|error| error.to_string());
    let whole = described.and_then(|it| nonlinear::unfolded(&it).map_err(|error| error.to_string()));
    let whole = match whole {
        Ok(whole) => whole,
        Err(error) => {
            println!("{file}: {error}");
            return false;
        }
    };
    let mut random = Random::new(1);
    let mut right = true;
    for _ in 0..PARTS {
        let window = lines::part(whole.scope.window, &mut random);
        let start = Instant::now();
        let part = parts::part(&whole, window);
        let outcome = parts::compare(&whole, window, part.as_ref(), POINTS, &mut random);
        let [more, less] = outcome.hatched;
        println!(
            "{file} {:?} x {:?}: {} verdicts and {:.2} of curves agree, {} differences, {more:.4} more hatched, {less:.4} less, \
             {:.1} s",
            window.primary,
            window.secondary,
            outcome.agreed,
            outcome.common,
            outcome.differences.len(),
            start.elapsed().as_secs_f64(),
        );
        outcome.differences.iter().take(8).for_each(|difference| println!("    {difference}"));
        part.iter().flat_map(regions::doubts).for_each(|doubt| println!("    {doubt}"));
        right &= outcome.differences.is_empty();
    }
    right
}

/// Compares the examples and a number of random oscillators with continuation and simulation.
fn examples_and_random(count: u64, seed: u64) -> bool {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples");
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path());
    let mut examples: Vec<_> = entries.filter(|path| path.extension().is_some_and(|e| e == "toml")).collect();
    examples.sort();
    let examples: Vec<String> = examples.iter().map(|path| path.display().to_string()).collect();
    let mut right = !examples.is_empty() && files(&examples);
    for number in 1..=count {
        let text = oscillators::description(seed, number);
        let name = format!("random {number} of seed {seed}");
        right &= compared(&name, Description::parse(&text, &name).map_err(|error| error.to_string()));
    }
    right
}

/// Unfolds oscillators that are described by texts; returns whether each was in time.
fn unfolded(texts: Vec<String>) -> bool {
    let unfolded = (1..).zip(texts).map(|(number, text)| {
        let outcome = damped::unfold(&text, damped::LONGEST);
        println!("{number:3} {outcome}");
        if !outcome.passes() {
            println!("{text}");
        }
        outcome.passes()
    });
    unfolded.filter(|passes| !passes).count() == 0
}

/// Compares oscillators from text files with continuation and simulation.
fn files(files: &[String]) -> bool {
    let mut right = true;
    for file in files {
        let path = Path::new(file);
        let name = path.file_name().map_or(file.as_str().into(), |name| name.to_string_lossy());
        right &= compared(&name, Description::from_file(path).map_err(|error| error.to_string()));
    }
    right
}

/// Compares one oscillator with continuation and simulation.
fn compared(from: &str, description: Result<Description, String>) -> bool {
    let start = Instant::now();
    let outcome = description.and_then(|description| {
        let diagram = nonlinear::unfolded(&description).map_err(|error| error.to_string())?;
        let mut outcome = nonlinear::compare(&diagram, LATTICE, STATES);
        for (_, place, _) in &mut outcome.wrong {
            *place = description.units().parameters(*place);
        }
        Ok((description.name().to_owned(), outcome))
    });
    let (name, outcome) = match outcome {
        Ok(both) => both,
        Err(error) => {
            println!("{from}: {error}");
            return false;
        }
    };
    println!(
        "{from}, {name}: {:.4} shaded, {:.4} hatched; {} motions seen where it is shaded, {} elsewhere; \
         {} continued solutions are come back to, {} are not, {} shaded without one, {} elsewhere; {:.0} s",
        outcome.shaded,
        outcome.hatched,
        outcome.seen,
        outcome.count(Disagreement::SeenUnshaded),
        outcome.confirmed,
        outcome.count(Disagreement::LeavesIt),
        outcome.count(Disagreement::NotFound),
        outcome.count(Disagreement::FoundUnshaded),
        start.elapsed().as_secs_f64(),
    );
    for (p, point, kind) in &outcome.wrong {
        println!("    p = {p} at {point:?}: {kind}");
    }
    for doubt in &outcome.doubts {
        println!("    {doubt}");
    }
    outcome.wrong.is_empty()
}
