//! Runs the long trials: `grazing-trials regions [OSCILLATORS [SEED]]` and `grazing-trials simulation FILE...`.
#![expect(clippy::print_stdout, clippy::print_stderr, reason = "a program's output")]

use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

use grazing_continuation::curve::Window;
use grazing_description::Description;
use grazing_trials::random::Random;
use grazing_trials::{regions, simulation};

const USAGE: &str = "usage: grazing-trials regions [OSCILLATORS [SEED]]
       grazing-trials simulation FILE...";

/// Random points an oscillator.
const POINTS: usize = 2000;
/// Points of the lattice, each way, and random states at each.
const LATTICE: u32 = 40;
const STATES: u32 = 10;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let number = |place: usize, otherwise: u64| {
        arguments.get(place).map_or(Some(otherwise), |argument| argument.parse().ok())
    };
    let right = match arguments.first().map(String::as_str) {
        Some("regions") => match (number(1, 40), number(2, 1)) {
            (Some(count), Some(seed)) if arguments.len() <= 3 => linear(count, seed),
            _ => return usage(),
        },
        Some("simulation") if arguments.len() > 1 => simulated(&arguments[1..]),
        _ => return usage(),
    };
    if right { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

fn usage() -> ExitCode {
    eprintln!("{USAGE}");
    ExitCode::from(2)
}

/// Linear oscillators with random damping, restitution and greatest amplitude, against the closed form.
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

/// Oscillators from text files against simulation.
fn simulated(files: &[String]) -> bool {
    let mut right = true;
    for file in files {
        let outcome = Description::from_file(Path::new(file)).map_err(|error| error.to_string()).and_then(
            |description| {
                simulation::compare(&description, LATTICE, STATES).map_err(|error| error.to_string())
            },
        );
        match outcome {
            Ok(outcome) => {
                let unexplained = outcome.unexplained.len();
                println!("{file}: {} settled where it is shaded, {unexplained} elsewhere", outcome.explained);
                for (p, point) in outcome.unexplained {
                    println!("    p = {p} at {point:?}");
                    right = false;
                }
            }
            Err(error) => {
                eprintln!("{file}: {error}");
                right = false;
            }
        }
    }
    right
}
