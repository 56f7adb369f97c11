//! `grazing identify`: constants of an oscillator from measurements.

use std::path::Path;

use grazing_continuation::bifurcation::Bifurcation;
use grazing_input::{AnalysisLimits, Description};
use grazing_measured::{Behaviour, Fit, IdentificationTask, Measurements, identify, read};
use grazing_model::smooth::SmoothOscillator;
use grazing_results::measured::Identified;
use grazing_results::{Names, Tables, brief};
use grazing_unfold::described::{Axes, Prepared};

use crate::arguments::IdentifyArguments;
use crate::commands::CommandLine;
use crate::failure::Failure;
use crate::folder::{self, Batch};
use crate::layout::Layout;
use crate::oscillator::{OscillatorFile, constants, setup};
use crate::runner::{CommandOutcome, Next, Plan, Running};
use crate::unfold::numbers::{heads, with_error};
use crate::{data_page, tables, terminal};

/// The folder of the results, with a folder in it for each file.
const RESULTS: &str = "identified";
/// The output, in messages.
const OUTPUT: &str = "identify";

/// Reads an oscillator with measurements, from which constants are to be identified.
///
/// # Errors
/// Bad input.
pub(crate) fn read(arguments: &IdentifyArguments) -> Result<Plan<'_>, Failure> {
    let IdentifyArguments { file, data, record, free, changes, limits, .. } = arguments;
    let of = OscillatorFile::read(file, &changes.set, limits.over(AnalysisLimits::USUAL))?;
    let of = of.looped(changes.loops.as_deref())?;
    let setup = setup(&of.description);
    let renamed = arguments.named.of(data.as_deref().or(record.as_deref()))?;
    if !renamed.is_empty() && data.is_some() && record.is_some() {
        return Err(Failure::input("--column names columns of one CSV: give --data or --record, not both"));
    }
    let points = data.as_ref().map(|path| read::points(path, setup, renamed)).transpose()?;
    let impacts = record.as_ref().map(|path| read::record(path, setup, renamed)).transpose()?;
    let measured = Measurements { points: points.unwrap_or_default(), record: impacts.unwrap_or_default() };
    refuse_gains(record.as_deref().unwrap_or(file), &of.description, &measured)?;
    let start = constants("--free", free.iter().map(String::as_str), &of.description)?;
    let unused = unused(&measured);
    if unused == measured.points.len() && measured.record.is_empty() {
        let remedy = format!(
            "measurements without a bifurcation do not constrain the constants: measure where the motion changes (seen = {}), or give a --record of impacts",
            Bifurcation::NAMES
        );
        return Err(Failure::input(format!(
            "{}: no bifurcation among the measurements: {remedy}",
            file.display()
        )));
    }
    let usual = || Path::new(RESULTS).join(folder::name_for(file));
    let folder = arguments.output.clone().unwrap_or_else(usual);
    let limits = (limits.over(of.description.limits()), of.taken);
    let names = Axes::of(&of.description).names;
    let compute = move |running: &Running<'_>| {
        identified(&of.description, (free, &start), &measured, running).map_err(|reason| {
            let otherwise = || Failure::incomplete(format!("{}: {reason}", file.display()));
            running.failure(file, "nothing is written", otherwise)
        })
    };
    let say = move |(fit, identified): (Fit, Identified), folder: &Path| {
        let files = identified.tables(&names).into_iter().map(|table| tables::file(&table, OUTPUT));
        let about = data_page::of_an_oscillator(Identified::TABLES.iter().copied(), &names);
        let files = files.chain([Ok(about)]).collect::<Result<_, _>>()?;
        let failure = fit.is_refuted().then(|| Failure::check(format!(
            "{}: the oscillator does not fit the measurements: chi^2 = {} for {} degrees of freedom; everything is written",
            file.display(),
            brief(fit.chi_squared, DIGITS + 1),
            fit.freedom
        )));
        let set = identified.constants.iter();
        let set = set.map(|row| ("--set", format!("{}={}", row.constant, brief(row.value, VALUE))));
        let next = CommandLine::own("unfold").with(file.display()).options(set);
        Ok(CommandOutcome {
            text: listing(terminal::layout(), &names, &fit, &identified, unused),
            batches: vec![Batch::run(folder, files)],
            next: if failure.is_none() { next.into() } else { Next::Nothing },
            failure,
            ..CommandOutcome::default()
        })
    };
    let paths = Identified::TABLES.iter().map(|table| tables::path(table.name));
    Ok(Plan::new(compute, say).within(file, limits).writing_run(folder, paths))
}

/// The number of measurements without a bifurcation.
fn unused(measured: &Measurements) -> usize {
    measured.points.iter().filter(|point| !matches!(point.seen, Behaviour::Bifurcation { .. })).count()
}

/// Refuses a record in which impacts speed the motion up, unless the restitution in the file does so.
fn refuse_gains(file: &Path, description: &Description, measured: &Measurements) -> Result<(), Failure> {
    let seen: Vec<Description> = description.from_each_wall().collect();
    for series in &measured.record {
        let Some(impact) = series.gaining() else { continue };
        let ([mu, eta], [time, speed, _]) = (series.at, impact.values);
        let description = &seen[impact.stop()];
        let phase = description.forcing_frequency(mu, eta) * time;
        if description.restitution(speed, phase, mu, eta) <= 1.0 {
            let remedy = "are velocity_before and velocity_after exchanged? If impacts drive the rig, start from a restitution above 1";
            return Err(Failure::input(format!(
                "{}:{}: speeds after the impacts of this series exceed those before: {remedy}",
                file.display(),
                impact.line
            )));
        }
    }
    Ok(())
}

fn identified(
    description: &Description,
    (names, start): (&[String], &[f64]),
    measured: &Measurements,
    running: &Running<'_>,
) -> Result<(Fit, Identified), String> {
    let stop = &running.stop();
    let Prepared { scope, axes: Axes { units, .. }, .. } = Prepared::of(description, stop);
    let at = [scope.window.primary[0], scope.window.secondary[0]];
    let rig = |values: &[f64]| {
        let mut own = description.clone();
        for (name, value) in names.iter().zip(values) {
            own = own.with_constant(name, *value).ok()?;
        }
        Some(own.counted(at, &units, stop))
    };
    let task = IdentificationTask { rig: &rig, names, start, scope: &scope, units };
    identify(&task, measured, &**running.progress()).map_err(|error| error.to_string())
}

/// Digits of residuals, and of values beside their errors.
const DIGITS: usize = 3;
const VALUE: usize = 8;

fn listing(layout: Layout, names: &Names, fit: &Fit, found: &Identified, unused: usize) -> String {
    let mut text = String::from("Identified constants, value ± standard error\n");
    let row = |row: &grazing_results::measured::IdentifiedConstant| {
        let value = format!("{} = {}", row.constant, with_error(row.value, row.error));
        vec![value, brief(row.start, VALUE)]
    };
    text.push_str(&layout.aligned(&["<constant", "in the file"], found.constants.iter().map(row)));
    for row in &found.correlations {
        let correlation = brief(row.correlation, DIGITS);
        text.push_str(&format!("  correlation of {} and {}: {correlation}\n", row.constant, row.other));
    }
    text.push_str(&quality(layout, fit, found.residuals.len()));
    let mut worst: Vec<_> = found.residuals.iter().collect();
    worst.sort_by(|a, b| b.residual.abs().total_cmp(&a.residual.abs()));
    text.push_str("\nLargest residuals, in standard errors (all are in data/residuals.csv)\n");
    let row = |row: &&grazing_results::measured::Residual| {
        vec![row.source.clone(), row.line.to_string(), row.quantity.clone(), brief(row.residual, DIGITS)]
    };
    text.push_str(&layout.aligned(&["file", "line", "measured", "residual"], worst.iter().take(5).map(row)));
    if unused > 0 {
        let unused = format!(
            "{unused} measurements without a bifurcation do not constrain the constants and are left out; \
             `unfold --data` compares them."
        );
        text.push_str(&layout.wrapped("  ", &unused));
    }
    text.push_str("\nResonances, value ± standard error that follows from the constants\n");
    if found.resonances.is_empty() {
        text.push_str("  none on the grazing curve\n");
        return text;
    }
    let walls = found.resonances.iter().any(|row| row.wall > 0);
    let row = |row: &grazing_results::measured::IdentifiedResonance| {
        let numbers = [Some(row.loops), walls.then_some(row.wall), Some(row.n)];
        let place =
            [with_error(row.secondary, row.secondary_error), with_error(row.primary, row.primary_error)];
        numbers.into_iter().flatten().map(|number| number.to_string()).chain(place).collect()
    };
    let [primary, secondary] = heads(names);
    let header = [Some("p"), walls.then_some("wall"), Some("n"), Some(&secondary), Some(&primary)];
    let header: Vec<&str> = header.into_iter().flatten().collect();
    text.push_str(&layout.aligned(&header, found.resonances.iter().map(row)));
    text
}

/// How well the identified oscillator fits the measurements.
fn quality(layout: Layout, fit: &Fit, numbers: usize) -> String {
    if fit.scattered {
        let scatter = format!(
            "The measurements state no errors: those of the constants come from the scatter of {numbers} numbers."
        );
        return format!("\n{}", layout.wrapped("  ", &scatter));
    }
    let fitted = format!(
        "chi^2 = {} for {} degrees of freedom ({numbers} measured numbers)",
        brief(fit.chi_squared, DIGITS + 1),
        fit.freedom
    );
    let mut text = format!("\n{}", layout.wrapped("  ", &fitted));
    if fit.is_refuted() {
        let doubt = "The oscillator does not fit: this is more than the stated errors explain. They are too small, or the rig is another one. \
             The errors of the constants are scaled to the scatter.";
        text.push_str(&layout.wrapped("  ", doubt));
    }
    text
}
