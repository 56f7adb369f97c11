//! `grazing identify`: constants of an oscillator from measurements.

use std::path::{Path, PathBuf};
use std::time::Instant;

use grazing_analysis::unfolded::{axes, prepared};
use grazing_description::{Description, Limits};
use grazing_measured::{Fit, Measurements, Seen, Task, identify, read};
use grazing_model::smooth::Stop;
use grazing_results::measured::Identified;
use grazing_results::{Names, Tables, brief};
use grazing_source::{nearest, suggestion};

use crate::arguments;
use crate::failure::Failure;
use crate::folder::{self, summary};
use crate::layout::{aligned, wrapped};
use crate::limits::{self, Watch, ended};
use crate::oscillator::{OscillatorFile, parameter_names, settings, with_loops};
use crate::progress::Display;
use crate::unfold::numbers::significant;
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
    let mut of = OscillatorFile::read(file, &settings(&arguments.changes.set), Limits::USUAL)?;
    of.description = with_loops(of.description, arguments.changes.loops.as_deref())?;
    let names = parameter_names(&of.description);
    let read_file =
        |path: &PathBuf| read::points(path, names).map_err(|error| Failure::input(error.to_string()));
    let points = data.as_ref().map(read_file).transpose()?.unwrap_or_default();
    let read_record =
        |path: &PathBuf| read::record(path, names).map_err(|error| Failure::input(error.to_string()));
    let record = record.as_ref().map(read_record).transpose()?.unwrap_or_default();
    let start = starts(free, &of.description)?;
    let measured = Measurements { points, record };
    let bifurcations =
        measured.points.iter().filter(|point| matches!(point.seen, Seen::Bifurcation { .. })).count();
    if bifurcations == 0 && measured.record.is_empty() {
        let remedy = "what was merely seen at a place tells no constant: measure where something changes (seen = graz, SN, PD, ...), or give a --record of impacts";
        return Err(Failure::input(format!(
            "{}: there is no bifurcation among the measurements: {remedy}",
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
    let watch = Watch::begin(of.description.limits(), of.taken);
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
    terminal::say(&listing(file, &names, &fit, &identified, unused));
    terminal::say(&format!("\n{}{:.1} s\n", summary(&written), began.elapsed().as_secs_f64()));
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
            return Err(Failure::input(format!(
                "--free {name}: it is free already: name every constant once"
            )));
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
/// A sum of squares this many standard deviations above its mean indicates that errors are larger
/// than stated, or that the oscillator is another one.
const UNLIKELY: f64 = 3.0;

fn listing(file: &Path, names: &Names, fit: &Fit, found: &Identified, unused: usize) -> String {
    let mut text = String::from("identified, with standard errors\n");
    let row = |row: &grazing_results::measured::IdentifiedConstant| {
        vec![
            row.constant.clone(),
            significant(row.value, VALUE),
            brief(row.error, DIGITS),
            brief(row.start, VALUE),
        ]
    };
    text.push_str(&aligned(&["constant", "value", "error", "in the file"], found.constants.iter().map(row)));
    for row in &found.correlations {
        text.push_str(&format!(
            "  correlation of {} and {}: {}\n",
            row.constant,
            row.other,
            brief(row.correlation, DIGITS)
        ));
    }
    let (freedom, squares) = (fit.freedom as f64, fit.chi_squared);
    let numbers = found.residuals.len();
    if fit.scattered {
        text.push_str(&wrapped(
            "\n  ",
            &format!(
                "No errors are stated: those of the constants come from the scatter of {numbers} numbers."
            ),
        ));
    } else {
        text.push_str(&format!(
            "\n  chi^2 = {} for {} degrees of freedom, {numbers} measured numbers\n",
            brief(squares, DIGITS + 1),
            fit.freedom
        ));
        if squares > freedom + UNLIKELY * (2.0 * freedom).sqrt() {
            let doubt = "that is more than errors as stated leave: they are larger, or the rig is not this oscillator";
            text.push_str(&wrapped("  ", doubt));
        }
    }
    let mut worst: Vec<_> = found.residuals.iter().collect();
    worst.sort_by(|a, b| b.residual.abs().total_cmp(&a.residual.abs()));
    text.push_str("\nlargest residuals, in standard errors; all are in data/residuals.csv\n");
    let row = |row: &&grazing_results::measured::Residual| {
        vec![row.source.clone(), row.line.to_string(), row.quantity.clone(), brief(row.residual, DIGITS)]
    };
    text.push_str(&aligned(&["file", "line", "measured", "residual"], worst.iter().take(5).map(row)));
    if unused > 0 {
        text.push_str(&wrapped("  ", &format!("{unused} places where no bifurcation was seen tell no constant, and are left out; unfold --data compares them")));
    }
    text.push_str("\nresonances, with standard errors that follow\n");
    let row = |row: &grazing_results::measured::IdentifiedResonance| {
        let error = |error: f64| if error.is_nan() { "not known".to_owned() } else { brief(error, DIGITS) };
        vec![
            row.loops.to_string(),
            row.n.to_string(),
            significant(row.secondary, VALUE),
            error(row.secondary_error),
            significant(row.primary, VALUE),
            error(row.primary_error),
        ]
    };
    let heads = ["p", "n", names.secondary.as_str(), "error", names.primary.as_str(), "error"];
    text.push_str(&aligned(&heads, found.resonances.iter().map(row)));
    let set: Vec<String> =
        found.constants.iter().map(|row| format!("--set {}={}", row.constant, row.value)).collect();
    text.push_str(&format!("\nthe diagram:  cargo xtask unfold {} {}\n", file.display(), set.join(" ")));
    text
}
