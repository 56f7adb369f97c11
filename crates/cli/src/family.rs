//! `grazing unfold --vary` and `grazing merge`: the resonances of an oscillator as constants of its
//! file vary.

mod listing;
mod origin;

use std::ops::Range;
use std::path::{Path, PathBuf};
use std::time::Instant;

use grazing_analysis::family::{Plan, Record, assemble, names, records};
use grazing_analysis::nothing::Nothing;
use grazing_description::{Description, Limits};
use grazing_model::smooth::Stop;
use grazing_results::brief;
use grazing_source::{nearest, suggestion};

use crate::arguments;
use crate::attractors::{self, MapWork};
use crate::commands::CommandLine;
use crate::failure::Failure;
use crate::folder::{self, summary};
use crate::layout::Layout;
use crate::limits::{self, Watch, ended, reading};
use crate::outputs::edition::{Edition, Format};
use crate::outputs::family::{FAMILY, NamedFamily};
use crate::outputs::latex;
use crate::part::{self, Joined};
use crate::progress::Display;
use crate::variation::{MOST_MEMBERS, Part, Variation};
use crate::{data_page, terminal};
use origin::FamilyWork;
pub(crate) use origin::Origin;

/// Computes a family, or a part of it.
///
/// # Errors
/// Bad input, before anything is computed; or a cancelled computation, whose finished part is written.
pub(crate) fn run(arguments: &arguments::Unfold) -> Result<(), Failure> {
    let [file] = arguments.files.as_slice() else {
        return Err(Failure::input(
            "--vary takes one file at a time: name one file, and run the command again for the next",
        ));
    };
    arguments.named.of(None)?;
    let origin = Origin::of_file(file, arguments)?;
    let read = |stop: &Stop| read(&origin, &arguments.vary, arguments.part, stop);
    // Members have more time together, but their number is not known yet.
    let ((description, plan, members), taken) = reading(file, arguments.limits.over(Limits::USUAL), read)?;
    let folder = arguments.output.clone().unwrap_or_else(|| origin.folder());
    let edition = arguments.look.edition();
    let paths = match arguments.part {
        Some(part) => vec![part::path(part)],
        None => paths(&edition),
    };
    folder::ensure_writable(&folder, &paths)?;
    arguments.threads.start()?;
    limits::listen();
    let began = Instant::now();
    terminal::say(&listing::plan(
        terminal::layout(),
        &description,
        file,
        &plan,
        arguments.part,
        members.len(),
    ));
    let watch = Watch::begin(arguments.limits.over(limits(&description, members.len())), taken);
    let display = Display::counting(watch.stop());
    let tell = |description: &Description, error: &_| Nothing::new(error, description).to_string();
    let found = records(&plan, &members, &tell, &watch.stop(), &display);
    let cause = watch.end_cause().filter(|_| found.iter().any(Option::is_none));
    match arguments.part {
        Some(part) => {
            let records = found.into_iter().collect::<Option<Vec<Record>>>();
            let Some(records) = records else {
                let outcome = "a part is written only if it is complete; nothing is written";
                return Err(ended(file, cause, outcome));
            };
            let made = part::made(part, FamilyWork { vary: arguments.vary.clone(), origin }, records)?;
            terminal::say(&summary(&folder::written(&folder, &[made])?));
            part::say_next(part, &folder);
            Ok(())
        }
        None => {
            let missing = found.iter().filter(|record| record.is_none()).count();
            if missing == plan.count() {
                return Err(ended(file, cause, "no member is finished; nothing is written"));
            }
            finish(&Task { file, folder: &folder, edition: &edition, began }, &plan, &description, found)?;
            if missing > 0 {
                let outcome =
                    format!("{missing} of {} members are missing; the others are written", plan.count());
                return Err(ended(file, cause, &outcome));
            }
            Ok(())
        }
    }
}

/// Joins the parts of a family, and writes the same files as one run does.
///
/// # Errors
/// A file is not a part or belongs to another family, or a part is missing or given twice.
pub(crate) fn merge(arguments: &arguments::Merge) -> Result<(), Failure> {
    let began = Instant::now();
    limits::leave_nothing_behind();
    if arguments.parts.first().is_some_and(|first| part::is_of::<MapWork>(first)) {
        return attractors::merge(arguments);
    }
    let Joined { work, task, records } = part::joined::<FamilyWork>(&arguments.parts)?;
    let (FamilyWork { origin, .. }, (description, plan)) = (work, task);
    let folder = arguments.output.clone().unwrap_or_else(|| origin.folder());
    let edition = arguments.look.edition();
    folder::ensure_writable(&folder, &paths(&edition))?;
    let file = PathBuf::from(&origin.file);
    let task = Task { file: &file, folder: &folder, edition: &edition, began };
    finish(&task, &plan, &description, records.into_iter().map(Some).collect())
}

/// A family, and all its members or those in a part of it.
type Members = (Description, Plan, Vec<(usize, Description)>);

/// Reads and checks all that a family, or a part of it, is computed from.
pub(crate) fn read(
    origin: &Origin,
    vary: &[Variation],
    part: Option<Part>,
    stop: &Stop,
) -> Result<Members, Failure> {
    let description = origin.description(&[], stop)?;
    let plan = plan(vary, &description)?;
    let which = part.map_or(Ok(0..plan.count()), |part| part::items::<FamilyWork>(part, plan.count()))?;
    let members = members(origin, &plan, which, stop)?;
    Ok((description, plan, members))
}

/// The constants that vary, checked.
fn plan(vary: &[Variation], description: &Description) -> Result<Plan, Failure> {
    const MOST: usize = grazing_results::VARIED;
    if !(1..=MOST).contains(&vary.len()) {
        let count = vary.len();
        return Err(Failure::input(format!(
            "--vary: given for {count} constants; at most {MOST} can vary, because the tables have {MOST} columns for them"
        )));
    }
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
            return Err(Failure::input(format!("--vary {name}: given twice: name every constant once")));
        }
    }
    let plan = Plan { varied: vary.iter().map(|Variation(varied)| varied.clone()).collect() };
    let count = plan.varied.iter().try_fold(1_usize, |count, varied| count.checked_mul(varied.values.len()));
    match count {
        Some(count) if count <= MOST_MEMBERS => Ok(plan),
        _ => Err(Failure::input(format!("--vary: the family has more than {MOST_MEMBERS} members"))),
    }
}

/// Some members, each with its number; all are read and checked before anything is computed.
fn members(
    origin: &Origin,
    plan: &Plan,
    which: Range<usize>,
    stop: &Stop,
) -> Result<Vec<(usize, Description)>, Failure> {
    let member = |index: usize| {
        let names = plan.varied.iter().map(|varied| varied.name.as_str());
        let values: Vec<(&str, f64)> = names.zip(plan.values(index)).collect();
        match origin.description(&values, stop) {
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

/// The limits of a family: those of time and steps in the file apply to a member on average.
pub(crate) fn limits(description: &Description, members: usize) -> Limits {
    let Limits { time, memory, steps } = description.limits();
    let members = members.max(1) as f64;
    Limits { time: time * members, memory, steps: steps * members }
}

/// A family of all records, with its names.
pub(crate) fn named(
    file: &Path,
    plan: &Plan,
    description: &Description,
    records: Vec<Option<Record>>,
) -> NamedFamily {
    NamedFamily {
        file: file.to_owned(),
        name: description.name().to_owned(),
        names: names(plan, description),
        family: assemble(plan, description, records),
    }
}

/// Its contents as lines on the terminal.
pub(crate) fn listed(layout: Layout, of: &NamedFamily, plan: &Plan) -> String {
    listing::results(layout, &of.family, &of.names, plan)
}

/// A family that is to be written: its file and folder, the edition, and when the run began.
struct Task<'a> {
    file: &'a Path,
    folder: &'a Path,
    edition: &'a Edition,
    began: Instant,
}

/// Writes the figure and tables of all records, and prints the results.
fn finish(
    task: &Task<'_>,
    plan: &Plan,
    description: &Description,
    records: Vec<Option<Record>>,
) -> Result<(), Failure> {
    let cut_off = records.iter().any(Option::is_none);
    let of = named(task.file, plan, description, records);
    let (_, mut files, floats) = FAMILY.made(&of, task.edition)?;
    if task.edition.has(Format::Tex) {
        files.extend(latex::files(&floats, []));
    }
    files.push(data_page::of_an_oscillator(FAMILY.tables.iter().copied(), &of.names));
    let written = folder::write_run(task.folder, &files, cut_off)?;
    terminal::say(&listed(terminal::layout(), &of, plan));
    terminal::say(&format!("\n{}", summary(&written)));
    terminal::say(&format!("{:.1} s\n", task.began.elapsed().as_secs_f64()));
    terminal::say_next(&CommandLine::of(&["open"]).with(folder::first(&written)));
    if of.family.incomplete > 0 {
        return Err(Failure::incomplete(format!(
            "{}: results are missing for {} members, see above; everything else is written",
            task.file.display(),
            of.family.incomplete
        )));
    }
    Ok(())
}

/// The paths of all files of a family whose figure has one sheet.
fn paths(edition: &Edition) -> Vec<PathBuf> {
    let mut paths = FAMILY.paths(edition);
    paths.extend([data_page::path(), PathBuf::from(folder::MANIFEST)]);
    paths
}
