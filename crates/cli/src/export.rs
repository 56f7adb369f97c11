//! `grazing export`: a problem for AUTO-07p that begins at a periodic solution.

use std::path::{Path, PathBuf};

use askama::Template;
use grazing_input::{AnalysisLimits, Description};
use grazing_model::smooth::{SmoothOscillator as _, Stop};
use grazing_model::{ImpactOscillator as _, State};
use grazing_results::Stability;
use grazing_unfold::described::Prepared;
use grazing_unfold::place::{Place, Solution, Starts};
use grazing_unfold::progress::Silent;

use crate::arguments::ExportArguments;
use crate::failure::Failure;
use crate::folder::{self, OutputFile};
use crate::oscillator::OscillatorFile;
use crate::runner::{CommandOutcome, Plan, Running};
use crate::template::rendered;

/// The folder of the results, with a folder in it for each file.
const RESULTS: &str = "exported";
/// The number of points of the flight that are written.
const POINTS: u32 = 200;

/// The equations, in Fortran.
#[derive(Template)]
#[template(path = "auto.f90", escape = "none")]
struct Equations<'a> {
    title: &'a str,
    loops: u32,
    names: [&'a str; 2],
    functions: [String; 4],
    /// The values of the parameters at the start.
    start: [String; 4],
}

/// AUTO's constants.
#[derive(Template)]
#[template(path = "auto.constants", escape = "none")]
struct Constants<'a> {
    name: &'a str,
    range: [f64; 2],
    step: f64,
    least: f64,
    most: f64,
}

/// The script of AUTO's runs.
#[derive(Template)]
#[template(path = "auto.script", escape = "none")]
struct Script<'a> {
    name: &'a str,
    /// The range of the secondary parameter, in Python's notation.
    range: String,
}

/// Reads the oscillator, of which a solution is written as a problem.
///
/// # Errors
/// Bad input.
pub(crate) fn read(arguments: &ExportArguments) -> Result<Plan<'_>, Failure> {
    let ExportArguments { file, at, changes, output } = arguments;
    let of = OscillatorFile::read(file, &changes.set, AnalysisLimits::USUAL)?;
    let of = of.looped(changes.loops.as_deref())?;
    // AUTO reads the name in quotes, and the system as that of an object file.
    let plain = |letter: char| if letter.is_ascii_alphanumeric() { letter } else { '_' };
    let name: String = folder::name_for(file).to_string_lossy().chars().map(plain).collect();
    let folder = output.clone().unwrap_or_else(|| Path::new(RESULTS).join(&name));
    let names = [format!("{name}.f90"), format!("{name}.dat"), format!("c.{name}"), format!("{name}.auto")];
    let paths = names.map(PathBuf::from);
    let places = paths.clone();
    let limits = (AnalysisLimits::USUAL, of.taken);
    let compute = move |running: &Running<'_>| {
        best(&of.description, *at, &running.stop())
            .map_err(|failure| running.failure(file, "nothing was written", || failure))
    };
    let say = move |best: Best, folder: &Path| {
        let Best { description, wall, solution, flight } = best;
        let [velocity, phase] = impact_of(&solution);
        let contents = problem(&description, &name, *at, &solution, flight);
        let file = |(path, content): (PathBuf, String)| OutputFile { path, content: content.into_bytes() };
        let files = paths.into_iter().zip(contents).map(file).collect();
        let stability = Stability::of(solution.multipliers).name();
        let of_wall = wall.map_or_else(String::new, |wall| format!(", at wall {wall}"));
        let remark = format!(
            "p = {}{of_wall}, {stability}, impact velocity {velocity}, phase {phase}; in {}: auto {name}.auto\n",
            solution.loops,
            folder.display()
        );
        Ok(CommandOutcome { remark, ..CommandOutcome::unlisted(files, folder)? })
    };
    Ok(Plan::new(compute, say).within(file, limits).writing(folder, places))
}

/// Equations, flight, constants and script of the problem with this name.
fn problem(
    description: &Description,
    name: &str,
    [mu, eta]: [f64; 2],
    solution: &Solution,
    flight: String,
) -> [String; 4] {
    let axes = [description.primary(), description.secondary()];
    let [[lower, upper], secondary] = axes.map(|axis| axis.range());
    let formula = |(formula, name): (&grazing_input::Expression, &str)| formula.fortran(name);
    let [force, frequency, restitution, duration] = description.formulas();
    let [velocity, phase] = impact_of(solution);
    let equations = Equations {
        title: description.name(),
        loops: solution.loops,
        names: axes.map(|axis| axis.name()),
        functions: [
            (force, "grazing_force"),
            (frequency, "grazing_frequency"),
            (restitution, "grazing_restitution"),
            (duration, "grazing_duration"),
        ]
        .map(formula),
        start: [mu, eta, phase, velocity].map(|value| format!("{value:e}").replace('e', "d")),
    };
    let step = 1e-2 * (upper - lower);
    let constants = Constants { name, range: [lower, upper], step, least: 1e-5 * step, most: 5.0 * step };
    let script = Script { name, range: format!("{secondary:?}") };
    [rendered(&equations), flight, rendered(&constants), rendered(&script)]
}

/// The solution that is written, with the oscillator as its wall sees it.
struct Best {
    description: Description,
    /// The number of the wall, where there are two.
    wall: Option<usize>,
    solution: Solution,
    flight: String,
}

/// The solution at a place: a stable one at either wall comes before one that is not at the first.
fn best(description: &Description, at: [f64; 2], stop: &Stop) -> Result<Best, Failure> {
    let walls: Vec<Description> = description.from_each_wall().collect();
    let count = walls.len();
    let mut best: Option<Result<Best, Failure>> = None;
    let rank = |found: &Result<Best, Failure>| {
        found.as_ref().map_or(2, |best| u8::from(!best.solution.multipliers.stable()))
    };
    for (number, description) in (1..).zip(walls) {
        let wall = (count > 1).then_some(number);
        let found = solution(&description, at, stop).map(|(solution, flight)| Best {
            description,
            wall,
            solution,
            flight,
        });
        // What could not be looked for may be better.
        if stop.is_asked() && found.is_err() {
            return found;
        }
        if best.as_ref().is_none_or(|best| rank(&found) < rank(best)) {
            best = Some(found);
        }
    }
    best.expect("there is a wall")
}

/// Velocity and phase of the only impact of a solution.
fn impact_of(solution: &Solution) -> [f64; 2] {
    solution.impacts.first().copied().unwrap_or([f64::NAN; 2])
}

/// An admissible solution with one impact at a place, if possible a stable one, in the units of the file;
/// and its flight as lines `s u v t`.
fn solution(description: &Description, at: [f64; 2], stop: &Stop) -> Result<(Solution, String), Failure> {
    let units = description.units();
    let [mu, eta] = at;
    let Prepared { oscillator, scope, .. } = Prepared::of(description, stop);
    let oscillator = oscillator.with_parameters(units.without_dimensions([mu, eta]));
    let starts = Starts { states: 0, ..Starts::default() };
    let found = Place::compute(&oscillator, &scope, &starts, &Silent);
    let mut solutions = found.map_or(Vec::new(), |place| place.solutions);
    solutions.retain(|solution| {
        solution.impacts.len() == 1 && solution.admissible && !solution.stops.contains(&1)
    });
    solutions.sort_by_key(|solution| !solution.multipliers.stable());
    let Some(mut chosen) = solutions.into_iter().next() else {
        return Err(Failure::input(format!(
            "--at {mu},{eta}: no admissible solution with an impact was found there for p = {:?}: choose another place",
            description.loops()
        )));
    };
    let [y, z] = impact_of(&chosen);
    let y = y * units.velocity();
    chosen.impacts = vec![[y, z]];
    let omega = description.forcing_frequency(mu, eta);
    let waits = description.impact_duration(y, z, mu, eta) * y;
    let recoil = State {
        position: 0.0,
        velocity: -description.restitution(y, z, mu, eta) * y / units.velocity(),
        phase: z + waits,
    };
    let duration = (f64::from(chosen.loops) * core::f64::consts::TAU - waits) / omega;
    let line = |k: u32| {
        let s = f64::from(k) / f64::from(POINTS);
        let [u, v] = oscillator.flow::<1>(recoil, s * duration / units.time).value.into();
        let [u, v, t] = [u * units.length, v * units.velocity(), (z + waits) / omega + s * duration];
        format!("{s:e} {u:e} {v:e} {t:e}\n")
    };
    let flight = (0..=POINTS).map(line).collect();
    Ok((chosen, flight))
}
