//! `grazing identify`: constants of an oscillator from measurements.

use std::path::{Path, PathBuf};
use std::time::Instant;

use grazing_analysis::unfolded::{axes, prepared};
use grazing_description::{Description, Limits};
use grazing_measured::{Fit, Measurements, Seen, Task, identify, read};
use grazing_model::smooth::{SmoothOscillator, Stop};
use grazing_results::measured::Identified;
use grazing_results::{Names, Tables, brief};
use grazing_source::{nearest, suggestion};

use crate::arguments;
use crate::commands::CommandLine;
use crate::failure::Failure;
use crate::folder::{self, summary};
use crate::layout::Layout;
use crate::limits::{self, Watch, ended};
use crate::oscillator::{AS_ONE_WALL, OscillatorFile, parameter_names, settings, with_loops, with_one_wall};
use crate::progress::Display;
use crate::unfold::numbers::{heads, with_error};
use crate::{data_page, tables, terminal};

/// The folder of the results, with a folder in it for each file.
const RESULTS: &str = "identified";
/// The output, in messages.
const OUTPUT: &str = "identify";

/// Identifies constants and writes them, with the residual of each measured number.
///
/// # Errors
/// Bad input, before anything is computed; nothing was identified.
pub(crate) fn run(arguments: &arguments::Identify) -> Result<(), Failure> {
    let began = Instant::now();
    let arguments::Identify { file, data, record, free, .. } = arguments;
    let mut of =
        OscillatorFile::read(file, &settings(&arguments.changes.set), arguments.limits.over(Limits::USUAL))?;
    with_one_wall(file, &of.description, "identify", AS_ONE_WALL)?;
    of.description = with_loops(of.description, arguments.changes.loops.as_deref())?;
    let names = parameter_names(&of.description);
    let renamed = arguments.named.of(data.as_deref().or(record.as_deref()))?;
    if !renamed.is_empty() && data.is_some() && record.is_some() {
        return Err(Failure::input("--column names columns of one CSV: give --data or --record, not both"));
    }
    let read_file = |path: &PathBuf| {
        read::points(path, names, renamed).map_err(|error| Failure::input(error.to_string()))
    };
    let points = data.as_ref().map(read_file).transpose()?.unwrap_or_default();
    let read_record = |path: &PathBuf| {
        read::record(path, names, renamed).map_err(|error| Failure::input(error.to_string()))
    };
    let record = record.as_ref().map(read_record).transpose()?.unwrap_or_default();
    for series in &record {
        let Some(impact) = series.gaining() else { continue };
        let ([mu, eta], [time, speed, _]) = (series.at, impact.values);
        let phase = of.description.forcing_frequency(mu, eta) * time;
        if of.description.restitution(speed, phase, mu, eta) <= 1.0 {
            let remedy = "are velocity_before and velocity_after exchanged? If impacts drive the rig, start from a restitution above 1";
            return Err(Failure::input(format!(
                "{}:{}: speeds after the impacts of this series exceed those before: {remedy}",
                arguments.record.as_deref().unwrap_or(file).display(),
                impact.line
            )));
        }
    }
    let start = starts(free, &of.description)?;
    let measured = Measurements { points, record };
    let bifurcations =
        measured.points.iter().filter(|point| matches!(point.seen, Seen::Bifurcation { .. })).count();
    if bifurcations == 0 && measured.record.is_empty() {
        let remedy = "measurements without a bifurcation do not constrain the constants: measure where the motion changes (seen = graz, SN, PD, ...), or give a --record of impacts";
        return Err(Failure::input(format!(
            "{}: no bifurcation among the measurements: {remedy}",
            file.display()
        )));
    }
    let folder = match &arguments.output {
        Some(folder) => folder.clone(),
        None => Path::new(RESULTS).join(folder::name_for(file)),
    };
    let mut paths: Vec<PathBuf> = Identified::TABLES.iter().map(|table| tables::path(table.name)).collect();
    paths.extend([data_page::path(), PathBuf::from(folder::MANIFEST)]);
    folder::ensure_writable(&folder, &paths)?;
    arguments.threads.start()?;
    limits::listen();
    let watch = Watch::begin(arguments.limits.over(of.description.limits()), of.taken);
    let found = identified(&of.description, (free, &start), &measured, &watch.stop());
    let (fit, identified) = found.map_err(|reason| match watch.end_cause() {
        Some(cause) => ended(file, Some(cause), "nothing is written"),
        None => Failure::incomplete(format!("{}: {reason}", file.display())),
    })?;
    let names = axes(&of.description).names;
    let mut files = Vec::new();
    for table in identified.tables(&names) {
        files.push(tables::file(&table, OUTPUT)?);
    }
    files.push(data_page::of_an_oscillator(Identified::TABLES.iter().copied(), &names));
    let written = folder::write_run(&folder, &files, false)?;
    let unused = measured.points.len() - bifurcations;
    terminal::say(&listing(terminal::layout(), &names, &fit, &identified, unused));
    terminal::say(&format!("\n{}{:.1} s\n", summary(&written), began.elapsed().as_secs_f64()));
    if fit.is_refuted() {
        return Err(Failure::check(format!(
            "{}: the oscillator does not fit the measurements: chi^2 = {} for {} degrees of freedom; everything is written",
            file.display(),
            brief(fit.chi_squared, DIGITS + 1),
            fit.freedom
        )));
    }
    let set = identified.constants.iter();
    let set = set.map(|row| ("--set", format!("{}={}", row.constant, brief(row.value, VALUE))));
    terminal::say_next(&CommandLine::own("unfold").with(file.display()).options(set));
    Ok(())
}

/// The values of the constants that are free, as the file has them.
fn starts(free: &[String], description: &Description) -> Result<Vec<f64>, Failure> {
    let known: Vec<(&str, f64)> = description.constants().collect();
    let names: Vec<&str> = known.iter().map(|(name, _)| *name).collect();
    let mut values = Vec::new();
    for (place, name) in free.iter().enumerate() {
        let Some((_, value)) = known.iter().find(|(known, _)| known == name) else {
            let near = suggestion(nearest(name, &names));
            let list = names.join(", ");
            return Err(Failure::input(format!(
                "--free {name}: no constant in [parameters] has this name{near} Known: {list}"
            )));
        };
        if free[..place].contains(name) {
            return Err(Failure::input(format!("--free {name}: named twice: name every constant once")));
        }
        values.push(*value);
    }
    Ok(values)
}

fn identified(
    description: &Description,
    (names, start): (&[String], &[f64]),
    measured: &Measurements,
    stop: &Stop,
) -> Result<(Fit, Identified), String> {
    let units = axes(description).units;
    let (_, scope) = prepared(description, &units, stop);
    let at = [scope.window.primary[0], scope.window.secondary[0]];
    let rig = |values: &[f64]| {
        let mut own = description.clone();
        for (name, value) in names.iter().zip(values) {
            own = own.with_constant(name, *value).ok()?;
        }
        Some(own.counted(at, &units, stop))
    };
    let task = Task { rig: &rig, names, start, scope: &scope, units };
    let display = Display::counting(stop.clone());
    identify(&task, measured, &display).map_err(|error| error.to_string())
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
    let row = |row: &grazing_results::measured::IdentifiedResonance| {
        vec![
            row.loops.to_string(),
            row.n.to_string(),
            with_error(row.secondary, row.secondary_error),
            with_error(row.primary, row.primary_error),
        ]
    };
    let [primary, secondary] = heads(names);
    text.push_str(&layout.aligned(&["p", "n", &secondary, &primary], found.resonances.iter().map(row)));
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
