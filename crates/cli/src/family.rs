//! `grazing unfold --vary` and `grazing merge`: the resonances of an oscillator as constants of its file vary.

mod listing;
mod part;

use std::ops::Range;
use std::path::{Path, PathBuf};
use std::str::FromStr;
use std::time::Instant;

use grazing_description::{Description, Limits};
use grazing_drawing::draw_family;
use grazing_reproduction::family::{Plan, Record, Varied, assemble, names, records};
use grazing_results::brief;
use grazing_results::family::Family;
use grazing_source::{Setting, nearest, suggestion};

use crate::arguments;
use crate::failure::Failure;
use crate::folder;
use crate::limits::{self, Met, Watch};
use crate::outputs::computation;
use crate::outputs::edition::{Edition, Format};
use crate::outputs::latex::{self, Float};
use crate::progress::Display;
use crate::reproduce::summary;
use crate::unfold::{self, reason};
use crate::{data_page, tables, terminal};
use part::{Origin, PartFile};

/// The folder of the results, with a folder in it for each file.
const RESULTS: &str = "families";
/// The figure, if there is room for it on one sheet.
const FIGURE: &str = "family.svg";
/// What it shows.
const FAMILY: &str = "resonant grazing bifurcations of a family";
/// More members than this make tables that nobody reads and files that fill a disk.
const MOST_MEMBERS: usize = 1_000_000;

/// A constant with the values that it takes: `zeta=0.01:0.1:10`.
#[derive(Debug, Clone, PartialEq)]
pub struct Variation(Varied);

impl FromStr for Variation {
    type Err = String;

    fn from_str(written: &str) -> Result<Self, String> {
        let form = "write NAME=FROM:TO:COUNT, as zeta=0.01:0.1:10 for ten values of zeta from 0.01 to 0.1";
        let (name, range) = written.split_once('=').ok_or(form)?;
        let parts: Vec<&str> = range.split(':').map(str::trim).collect();
        let [from, to, count] = parts[..] else { return Err(form.to_owned()) };
        let number = |text: &str| {
            let value: f64 = text.parse().map_err(|_| format!("{text} is not a number: {form}"))?;
            if value.is_finite() { Ok(value) } else { Err(format!("{text} is not a finite number")) }
        };
        let (from, to) = (number(from)?, number(to)?);
        let count: usize = count.parse().map_err(|_| format!("{count} is not a count: {form}"))?;
        if !(2..=MOST_MEMBERS).contains(&count) {
            return Err(format!("{count} values: at least 2 and at most {MOST_MEMBERS} are possible"));
        }
        if from == to {
            return Err(format!(
                "{from} is both ends: a constant that is to have one value is set with --set"
            ));
        }
        let last = (count - 1) as f64;
        let value = |index: usize| match index as f64 {
            share if share == last => to,
            share => from + (to - from) * (share / last),
        };
        let values = (0..count).map(value).collect();
        Ok(Self(Varied { name: name.trim().to_owned(), values }))
    }
}

/// A part of a family: `7/200` is the seventh of two hundred.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Part {
    part: usize,
    parts: usize,
}

impl FromStr for Part {
    type Err = String;

    fn from_str(written: &str) -> Result<Self, String> {
        let form = "write K/N with K from 1 to N, as 7/200";
        let (part, parts) = written.split_once('/').ok_or(form)?;
        let number = |text: &str| text.trim().parse::<usize>().map_err(|_| form.to_owned());
        let (part, parts) = (number(part)?, number(parts)?);
        if (1..=parts).contains(&part) { Ok(Self { part, parts }) } else { Err(form.to_owned()) }
    }
}

/// Computes a family, or a part of it.
///
/// # Errors
/// Bad input, before anything is computed; a computation that was ended, with what is finished written.
pub(crate) fn run(arguments: &arguments::Unfold) -> Result<(), Failure> {
    let [file] = arguments.files.as_slice() else {
        return Err(Failure::input(
            "--vary takes one file at a time: name one, and run it again for the next",
        ));
    };
    let origin = Origin::new(file, arguments)?;
    let description = origin.description(&[])?;
    let plan = plan(&arguments.vary, &description)?;
    let which = arguments.part.map_or(0..plan.count(), |Part { part, parts }| plan.part(part, parts));
    let members = members(&origin, &plan, which)?;
    let folder = arguments.output.clone().unwrap_or_else(|| origin.folder());
    let edition = Edition::new(&arguments.look);
    let paths = match arguments.part {
        Some(part) => vec![part::path(part)],
        None => paths(&edition),
    };
    folder::ensure_writable(&folder, &paths)?;
    arguments.threads.start()?;
    limits::listen();
    let began = Instant::now();
    terminal::say(&listing::plan(&description, file, &plan, arguments.part, members.len()));
    let watch = Watch::begin(limits(&description, arguments, members.len()));
    let display = Display::counting(watch.stop());
    let tell = |description: &Description, error: &_| reason::of(error, description);
    let found = records(&plan, &members, &tell, &watch.stop(), &display);
    let met = watch.met().filter(|_| found.iter().any(Option::is_none));
    match arguments.part {
        Some(part) => {
            let records = found.into_iter().collect::<Option<Vec<Record>>>();
            let Some(records) = records else {
                let outcome = "a part is written only if it is whole: nothing is written";
                return Err(ended(file, met, outcome));
            };
            let made = PartFile::new(part, origin, plan, records).made()?;
            terminal::say(&summary(&folder::written(&folder, &[made])?));
            Ok(())
        }
        None => {
            let missing = found.iter().filter(|record| record.is_none()).count();
            finish(&Task { file, folder: &folder, edition: &edition, began }, &plan, &description, found)?;
            if missing > 0 {
                let outcome =
                    format!("{missing} of {} members are missing; the others are written", plan.count());
                return Err(ended(file, met, &outcome));
            }
            Ok(())
        }
    }
}

fn ended(file: &Path, met: Option<Met>, outcome: &str) -> Failure {
    match met {
        Some(met) => unfold::ended(file, met, outcome),
        None => Failure::incomplete(format!("{}: {outcome}", file.display())),
    }
}

/// Joins parts to a family, with the same files as one run makes.
///
/// # Errors
/// A file is no part, or of another family, or a part is missing or there twice.
pub(crate) fn merge(arguments: &arguments::Merge) -> Result<(), Failure> {
    let began = Instant::now();
    let PartFile { origin, plan, records, .. } = part::joined(&arguments.parts)?;
    let description = origin.description(&[])?;
    let folder = arguments.output.clone().unwrap_or_else(|| origin.folder());
    let edition = Edition::new(&arguments.look);
    folder::ensure_writable(&folder, &paths(&edition))?;
    let file = PathBuf::from(&origin.file);
    let task = Task { file: &file, folder: &folder, edition: &edition, began };
    finish(&task, &plan, &description, records.into_iter().map(Some).collect())
}

/// The constants that vary, checked.
fn plan(vary: &[Variation], description: &Description) -> Result<Plan, Failure> {
    let known: Vec<&str> = description.constants().map(|(name, _)| name).collect();
    for (place, Variation(varied)) in vary.iter().enumerate() {
        let name = varied.name.as_str();
        if !known.contains(&name) {
            let near = suggestion(nearest(name, &known));
            return Err(Failure::input(format!(
                "--vary {name}: no constant in [parameters] has this name{near} Known: {}",
                known.join(", ")
            )));
        }
        if vary[..place].iter().any(|Variation(other)| other.name == name) {
            return Err(Failure::input(format!(
                "--vary {name}: it varies already: name every constant once"
            )));
        }
    }
    if vary.len() > grazing_results::VARIED {
        let most = grazing_results::VARIED;
        return Err(Failure::input(format!("--vary: {} constants vary; at most {most} can", vary.len())));
    }
    let plan = Plan { varied: vary.iter().map(|Variation(varied)| varied.clone()).collect() };
    let count = plan.varied.iter().try_fold(1_usize, |count, varied| count.checked_mul(varied.values.len()));
    match count {
        Some(count) if count <= MOST_MEMBERS => Ok(plan),
        _ => Err(Failure::input(format!("--vary: the family has more than {MOST_MEMBERS} members"))),
    }
}

/// Some members, each with its number; all are read and checked before anything is computed.
fn members(origin: &Origin, plan: &Plan, which: Range<usize>) -> Result<Vec<(usize, Description)>, Failure> {
    let member = |index: usize| {
        let names = plan.varied.iter().map(|varied| varied.name.as_str());
        let values: Vec<(&str, f64)> = names.zip(plan.values(index)).collect();
        match origin.description(&values) {
            Ok(description) => Ok((index, description)),
            Err(mut failure) => {
                let set = values.iter().map(|(name, value)| format!("{name} = {}", brief(*value, 6)));
                let set = set.collect::<Vec<_>>().join(", ");
                failure.reason = format!("--vary: with {set}: {}", failure.reason);
                Err(failure)
            }
        }
    };
    which.map(member).collect()
}

/// Of a family the file's limits of time and steps are those of a member on average.
fn limits(description: &Description, arguments: &arguments::Unfold, members: usize) -> Limits {
    let Limits { time, memory, steps } = description.limits();
    let members = members.max(1) as f64;
    arguments.limits(Limits { time: time * members, memory, steps: steps * members })
}

/// Where a family is written, and for whom.
struct Task<'a> {
    file: &'a Path,
    folder: &'a Path,
    edition: &'a Edition,
    began: Instant,
}

/// Makes tables and figures of all records, writes them and tells what they hold.
fn finish(
    task: &Task<'_>,
    plan: &Plan,
    description: &Description,
    records: Vec<Option<Record>>,
) -> Result<(), Failure> {
    let family = assemble(plan, description, records);
    let names = names(plan, description);
    let title = format!("{}: {FAMILY}", description.name());
    let sheets = draw_family(&family, &names, &title, task.edition.columns)
        .map_err(|error| computation("figures", &error))?;
    let (mut files, mut floats) = (Vec::new(), Vec::new());
    let count = sheets.len();
    for (svg, number) in sheets.into_iter().zip(1..) {
        let file = if count == 1 { FIGURE.to_owned() } else { format!("family-{number}.svg") };
        let told = |error| computation("figures", &error);
        let label = Float::label("fig", task.file, file.trim_end_matches(".svg"));
        floats.push(Float::figure(&file, &svg, FAMILY, &label).map_err(told)?);
        files.extend(task.edition.figure_files(&file, svg).map_err(told)?);
    }
    files.extend(task.edition.has(Format::Tex).then(|| latex::snippet(&floats)));
    for table in family.tables(&names) {
        files.push(tables::file(&table, "tables")?);
    }
    files.push(data_page::of_an_oscillator(Family::TABLES.iter().copied(), &names));
    let written = folder::written(task.folder, &files)?;
    terminal::say(&listing::results(&family, &names, plan));
    terminal::say(&format!("\n{}", summary(&written)));
    terminal::say(&format!("{:.1} s\n", task.began.elapsed().as_secs_f64()));
    if family.incomplete > 0 {
        return Err(Failure::incomplete(format!(
            "{}: something is missing at {} members, as told above; everything else is written",
            task.file.display(),
            family.incomplete
        )));
    }
    Ok(())
}

/// All files of a family that has one sheet.
fn paths(edition: &Edition) -> Vec<PathBuf> {
    let tables = Family::TABLES.iter().map(|table| tables::path(table.name));
    edition.figure_paths(FIGURE).chain(tables).chain([data_page::path()]).collect()
}

/// What a setting of a constant is on the command line.
fn setting(name: &str, value: f64) -> Result<Setting, Failure> {
    format!("parameters.{name}={value:?}")
        .parse()
        .map_err(|error: grazing_source::SettingError| Failure::input(format!("--vary {name}: {error}")))
}
