//! `grazing unfold`: the resonant grazing bifurcations of an oscillator that a text file describes.

mod explanation;
mod keeper;
pub(crate) mod layout;
mod listing;
pub(crate) mod numbers;
pub(crate) mod reason;
pub(crate) mod sheets;

use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;

use grazing_description::{Description, Limits};
use grazing_reproduction::StudyError;
use grazing_reproduction::unfolded::{Described, Keep, Rows, Unfolded};
use grazing_results::branches::OneParameterRows;
use grazing_source::Setting;
use grazing_unfold::UnfoldError;

use crate::arguments;
use crate::failure::Failure;
use crate::folder::{self, MadeFile};
use crate::limits::{self, Met, Watch};
use crate::outputs::computation;
use crate::outputs::edition::{Edition, Format};
use crate::progress::Display;
use crate::report::oscillators::{Material, OscillatorFile, PAGE};
use crate::reproduce::summary;
use crate::{data_page, tables, terminal};
use keeper::Keeper;

/// The folder of the results, with a folder in it for each file.
const RESULTS: &str = "unfolded";

/// What the analysis of an oscillator from a text file comes to.
pub(crate) type Analysis = Unfolded<Described>;

/// A file that is to be unfolded.
struct Task {
    of: OscillatorFile,
    folder: PathBuf,
    limits: Limits,
}

/// Unfolds every file, one after the other, once all are known to be right and their folders to be writable.
///
/// # Errors
/// Bad input, before anything is computed; what went wrong with a single file, or with how many of several.
pub(crate) fn run(arguments: &arguments::Unfold) -> Result<(), Failure> {
    let edition = Edition::new(&arguments.look);
    let tasks = tasks(arguments)?;
    for task in &tasks {
        let figures = sheets::FILES.iter().flat_map(|file| edition.figure_paths(file));
        let tables =
            Rows::TABLES.iter().chain(OneParameterRows::TABLES).map(|table| tables::path(table.name));
        let pages = [PathBuf::from(PAGE), data_page::path()];
        folder::ensure_writable(&task.folder, &figures.chain(tables).chain(pages).collect::<Vec<_>>())?;
    }
    arguments.threads.start()?;
    limits::listen();
    let (mut failing, mut code) = (0, None);
    for (number, task) in tasks.iter().enumerate() {
        if number > 0 {
            terminal::say("\n");
        }
        if limits::is_interrupted() {
            terminal::note(&format!("{}: not begun", task.of.file.display()));
            failing += 1;
            continue;
        }
        match task.run(&edition, arguments.explain) {
            Err(failure) if tasks.len() == 1 => return Err(failure),
            Err(failure) => {
                terminal::report(&failure);
                failing += 1;
                code.get_or_insert(failure.exit_code());
            }
            Ok(()) => {}
        }
    }
    match code {
        // As the first that failed.
        Some(code) => {
            Err(Failure::new(code, format!("{failing} of {} files failed, as told above", tasks.len())))
        }
        None => Ok(()),
    }
}

/// The files with what they describe, and the folders of their results, no two of which are the same.
fn tasks(arguments: &arguments::Unfold) -> Result<Vec<Task>, Failure> {
    let mut tasks: Vec<Task> = Vec::new();
    for file in &arguments.files {
        let settings = settings(&arguments.set);
        let mut of = OscillatorFile::read(file, &settings)?;
        of.description = with_loops(of.description, arguments.loops.as_deref())?;
        let named = folder::name_for(file);
        let folder = match &arguments.output {
            Some(folder) if arguments.files.len() == 1 => folder.clone(),
            Some(folder) => folder.join(&named),
            None => Path::new(RESULTS).join(&named),
        };
        if let Some(other) = tasks.iter().find(|other| other.folder == folder) {
            return Err(Failure::input(format!(
                "{} and {} would both go to {}: unfold them one by one, with --output DIR",
                other.of.file.display(),
                file.display(),
                folder.display()
            )));
        }
        let limits = arguments.limits(of.description.limits());
        tasks.push(Task { of, folder, limits });
    }
    Ok(tasks)
}

/// The oscillator with the numbers of loops that were named, if any were.
pub(crate) fn with_loops(description: Description, loops: Option<&[u32]>) -> Result<Description, Failure> {
    let Some(loops) = loops else { return Ok(description) };
    description.with_loops(loops).map_err(|reason| Failure::input(format!("--loops {reason}")))
}

/// What was set: `kappa` alone is a constant, `parameters.kappa`.
pub(crate) fn settings(set: &[Setting]) -> Vec<Setting> {
    let full = |setting: &Setting| {
        let named = setting.key().contains('.') || ["name", "diagrams"].contains(&setting.key());
        if named { setting.clone() } else { setting.within("parameters") }
    };
    set.iter().map(full).collect()
}

/// Analyses an oscillator up to its limits; with what has ended the analysis, if anything is missing in it.
///
/// # Errors
/// There is nothing to unfold.
pub(crate) fn analyse(
    of: &OscillatorFile,
    limits: Limits,
    keep: Keep<'_>,
) -> Result<(Analysis, Option<Met>), Failure> {
    let watch = Watch::begin(limits);
    let display = Display::counting(watch.stop());
    let unfolded = Unfolded::described(&of.description, &display, &watch.stop(), keep)
        .map_err(|error| failure(of, &error, watch.met()))?;
    let met = watch.met().filter(|_| !unfolded.diagram.unfinished.is_empty());
    Ok((unfolded, met))
}

/// The failure that tells, with the file's names of the parameters, why there is nothing to unfold, or what has ended the search.
fn failure(of: &OscillatorFile, error: &StudyError, met: Option<Met>) -> Failure {
    let OscillatorFile { file, description, .. } = of;
    match (error, met) {
        (StudyError::Unfold(UnfoldError::Stopped { stage }), Some(met)) => {
            let outcome = "nothing is written, for nothing was found up to then, in the stage";
            ended(file, met, &format!("{outcome} `{stage}`"))
        }
        (StudyError::Unfold(error), _) => {
            Failure::incomplete(format!("{}: {}", file.display(), reason::of(error, description)))
        }
        (error, _) => computation("unfold", error),
    }
}

/// The failure of an analysis that was ended by a limit or by Ctrl-C.
pub(crate) fn ended(file: &Path, met: Met, outcome: &str) -> Failure {
    Failure::incomplete(format!("{}: {met}; {outcome}", file.display()))
}

impl Task {
    /// Computes, writes and tells everything.
    fn run(&self, edition: &Edition, explain: bool) -> Result<(), Failure> {
        let start = Instant::now();
        let OscillatorFile { file, description, .. } = &self.of;
        terminal::say(&listing::oscillator(description, file));
        let keeper = Keeper::new(&self.folder);
        let (unfolded, met) = analyse(&self.of, self.limits, &|table| keeper.keep(table))?;
        let files = self.files(&unfolded, edition)?;
        let written = folder::written(&self.folder, &files)?;
        self.remove_other_sheets(&files, edition)?;
        keeper.clear()?;
        terminal::say(&listing::results(description, &unfolded));
        if explain {
            terminal::say(&explanation::all(description, &unfolded));
        }
        terminal::say(&format!("\n{}", summary(&written)));
        terminal::say(&format!("{:.1} s\n", start.elapsed().as_secs_f64()));
        if let Some(met) = met {
            let outcome = "what was not finished is named above; everything else is written";
            return Err(ended(file, met, outcome));
        }
        let (file, contradictions) = (file.display(), listing::contradictions(&unfolded.entries()));
        if !contradictions.is_empty() {
            let what = contradictions.join("; ");
            return Err(Failure::check(format!(
                "{file}: the theorem is contradicted: {what}; everything is written"
            )));
        }
        match listing::incomplete(&unfolded.diagram) {
            Some(missing) => Err(Failure::incomplete(format!(
                "{file}: {missing}, as told above; everything else is written"
            ))),
            None => Ok(()),
        }
    }

    /// Figures, tables and the page that shows them.
    fn files(&self, unfolded: &Analysis, edition: &Edition) -> Result<Vec<MadeFile>, Failure> {
        let material = Material::new(&self.of, unfolded, edition.columns)?;
        let mut files = material.files(edition)?;
        if edition.has(Format::Tex) {
            files.extend(material.latex().map_err(|error| computation("figures", &error))?);
        }
        files.push(data_page::of_an_oscillator(material.plans.iter().copied(), &unfolded.axes.names));
        files.push(material.page(&files));
        Ok(files)
    }

    /// Removes sheets of magnifications that an earlier run made of more resonances, and one-parameter diagrams that are not asked for any
    /// more.
    fn remove_other_sheets(&self, made: &[MadeFile], edition: &Edition) -> Result<(), Failure> {
        let sheets =
            sheets::possible_names().flat_map(|name| edition.figure_paths(&name).collect::<Vec<_>>());
        let tables = OneParameterRows::TABLES.iter().map(|table| tables::path(table.name));
        for path in sheets.chain(tables).filter(|path| made.iter().all(|file| file.path != *path)) {
            let path = self.folder.join(path);
            if path.is_file() {
                fs::remove_file(&path).map_err(|reason| Failure::file(&path, &reason))?;
            }
        }
        Ok(())
    }
}
