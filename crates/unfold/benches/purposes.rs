//! Steps of integration by their purpose, in the diagrams of ten oscillators: three are not examples, and hard.
//! On a busy machine they tell of two versions what times do not.

#![expect(clippy::print_stdout, clippy::print_stderr, reason = "a program's output")]

use std::fs;
use std::path::{Path, PathBuf};

use grazing_continuation::curve::Window;
use grazing_input::Description;
use grazing_model::smooth::{Purpose, Stop};
use grazing_results::Dimensioned;
use grazing_unfold::{Diagram, Scope};

/// The examples among them.
const EXAMPLES: [&str; 7] =
    ["paper", "duffing", "pendulum", "base-excitation", "leaf-spring", "harvester", "two-harmonics"];

fn main() {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let hard = fs::read_dir(here.join("benches/hard")).expect("the folder is there");
    let mut hard: Vec<PathBuf> = hard.map(|entry| entry.expect("it can be listed").path()).collect();
    hard.sort();
    let examples = EXAMPLES.map(|name| here.join("../../examples").join(name).with_extension("toml"));
    let counts: Vec<(String, Stop)> = examples.into_iter().chain(hard).map(counted).collect();
    let names: Vec<&str> = counts.iter().map(|(name, _)| name.as_str()).collect();
    println!("thousands of steps | {}", names.join(" | "));
    for purpose in Purpose::ALL {
        let of = |stop: &Stop| stop.by_purpose().nth(purpose as usize).map_or(0, |(_, count)| count / 1000);
        let row: Vec<String> = counts.iter().map(|(_, stop)| of(stop).to_string()).collect();
        println!("{} | {}", purpose.name(), row.join(" | "));
    }
    let all: Vec<String> = counts.iter().map(|(_, stop)| (stop.steps() / 1000).to_string()).collect();
    println!("all | {}", all.join(" | "));
}

/// The name of an oscillator, and the steps of its diagram.
fn counted(file: PathBuf) -> (String, Stop) {
    let description = Description::from_file(&file).expect("it is right");
    let window =
        Window { primary: description.primary().range(), secondary: description.secondary().range() };
    let scope = Scope { window, loops: description.loops().to_vec(), start: description.start() };
    let (units, stop) = (description.units(), Stop::default());
    let scope = scope.without_dimensions(&units);
    let oscillator = description.counted(scope.window.parameters([0.5; 2]), &units, &stop);
    if let Err(nothing) = Diagram::compute(&oscillator, &scope, &stop) {
        eprintln!("{}: {nothing}", file.display());
    }
    (file.file_stem().expect("it has a name").to_string_lossy().into_owned(), stop)
}
