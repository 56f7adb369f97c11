//! `grazing reproduce`: compute first, then write everything or check it.

use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::time::Instant;

use grazing_reproduction::Study;
use grazing_reproduction::parameters::Parameters;
use grazing_reproduction::published::Published;

use crate::arguments::Reproduce;
use crate::failure::Failure;
use crate::folder::{self, Change, Kind, MadeFile};
use crate::outputs::{self, Output, computation};
use crate::progress::Display;
use crate::{project, terminal};

/// What belongs in the output folder although the program does not make it.
const KNOWN: [&str; 1] = ["parameters.toml"];

/// Makes the outputs that were asked for.
///
/// # Errors
/// [`Failure::CheckFailed`] if a check was asked for and files differ; any other [`Failure`] if they could not be made.
pub(crate) fn run(arguments: &Reproduce) -> Result<(), Failure> {
    let start = Instant::now();
    let parameters = project::parameters(arguments.parameters.file.as_deref())?;
    let output_folder = project::output_folder(arguments.output.as_deref())?;
    let chosen: Vec<&Output> =
        outputs::ALL.iter().filter(|output| is_chosen(output, &arguments.only)).collect();
    if !arguments.check {
        let paths: Vec<PathBuf> = chosen.iter().flat_map(|output| output.paths()).collect();
        folder::ensure_writable(&output_folder, &paths)?;
    }
    if let Some(jobs) = arguments.jobs {
        start_threads(jobs)?;
    }
    let (files, verdict) = make(&parameters, &chosen)?;
    if arguments.check {
        check(&output_folder, &files, arguments)?;
        terminal::say(&format!("{} are what the code makes.\n", counted(files.len())));
    } else {
        let changes = folder::write(&output_folder, &files)?;
        terminal::say(&summary(&output_folder, &files, &changes));
    }
    terminal::say(&format!("{verdict}\n{:.1} s\n", start.elapsed().as_secs_f64()));
    Ok(())
}

fn is_chosen(output: &Output, only: &[String]) -> bool {
    only.is_empty() || only.iter().any(|name| name == output.name)
}

/// Sets the number of threads.
///
/// # Errors
/// [`Failure::Threads`].
pub(crate) fn start_threads(jobs: u16) -> Result<(), Failure> {
    rayon::ThreadPoolBuilder::new()
        .num_threads(usize::from(jobs))
        .build_global()
        .map_err(|error| Failure::Threads { jobs, reason: error.to_string() })
}

/// All files of the outputs, and a line that says whether the published values are met.
fn make(parameters: &Parameters, chosen: &[&Output]) -> Result<(Vec<MadeFile>, String), Failure> {
    let display = Display::new();
    let study = Study::new(parameters).with_progress(&display);
    let mut files = Vec::new();
    for output in chosen {
        files.extend(output.files(&study)?);
    }
    let published = Published::printed()?;
    let computed = study.published_values().map_err(|error| computation("published values", &error))?;
    let comparisons = published.compare(&computed);
    let met = comparisons.iter().filter(|comparison| comparison.is_met()).count();
    let verdict = if met == comparisons.len() {
        format!("All {met} published values are met.")
    } else {
        format!("Only {met} of {} published values are met: see `cargo xtask compare`.", comparisons.len())
    };
    Ok((files, verdict))
}

fn check(output_folder: &Path, files: &[MadeFile], arguments: &Reproduce) -> Result<(), Failure> {
    let complete = arguments.only.is_empty();
    let differences = folder::differences(output_folder, files, &KNOWN, complete)?;
    if differences.is_empty() {
        return Ok(());
    }
    for difference in &differences {
        terminal::note(&difference.to_string());
    }
    let unexpected = differences.iter().filter(|difference| difference.kind == Kind::Unexpected).count();
    Err(Failure::CheckFailed {
        folder: output_folder.display().to_string(),
        wrong: differences.len() - unexpected,
        unexpected,
        mend: mending_command(arguments),
    })
}

/// The command that writes what this check compared with.
fn mending_command(arguments: &Reproduce) -> String {
    let mut command = "cargo xtask reproduce".to_owned();
    for name in &arguments.only {
        command.push_str(&format!(" --only {name}"));
    }
    if let Some(file) = &arguments.parameters.file {
        command.push_str(&format!(" --parameters {}", file.display()));
    }
    if let Some(folder) = &arguments.output {
        command.push_str(&format!(" --output {}", folder.display()));
    }
    command
}

/// A line for each file, and one that counts.
fn summary(output_folder: &Path, files: &[MadeFile], changes: &[Change]) -> String {
    let names: Vec<String> =
        files.iter().map(|file| output_folder.join(&file.path).display().to_string()).collect();
    let width = names.iter().map(String::len).max().unwrap_or(0);
    let mut text = String::new();
    let mut counts = [0; 3];
    for (name, change) in names.iter().zip(changes) {
        let (index, word) = match change {
            Change::New => (0, "new"),
            Change::Updated => (1, "updated"),
            Change::Unchanged => (2, "unchanged"),
        };
        counts[index] += 1;
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{name:width$}  {word}");
    }
    let [new, updated, unchanged] = counts;
    let _ = writeln!(text, "{}: {new} new, {updated} updated, {unchanged} unchanged.", counted(files.len()));
    text
}

fn counted(files: usize) -> String {
    if files == 1 { "1 file".to_owned() } else { format!("{files} files") }
}
