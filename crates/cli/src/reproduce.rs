//! `grazing reproduce`: compute first, then write everything or check it.

use std::fmt::Write;
use std::path::PathBuf;
use std::time::Instant;

use grazing_reproduction::Study;
use grazing_reproduction::parameters::Parameters;
use grazing_reproduction::published::Published;

use crate::arguments::Reproduce;
use crate::failure::Failure;
use crate::folder::{self, Change, Kind, MadeFile};
use crate::outputs::edition::Edition;
use crate::outputs::{self, Output, computation, latex};
use crate::progress::Display;
use crate::{codecheck, project, terminal, visual};

/// What belongs in the output folder although the program does not make it.
const KNOWN: [&str; 2] = ["parameters.toml", "data/README.md"];

/// Makes the outputs that were asked for.
///
/// # Errors
/// [`Failure::CheckFailed`] if a check was asked for and files differ; any other [`Failure`] if they could not be made.
pub(crate) fn run(arguments: &Reproduce) -> Result<(), Failure> {
    let start = Instant::now();
    let edition = Edition::new(&arguments.format, arguments.columns, arguments.dpi);
    let parameters = project::parameters(arguments.parameters.file.as_deref())?;
    let output_folder = project::output_folder(arguments.output.as_deref(), &edition)?;
    let chosen: Vec<&Output> =
        outputs::ALL.iter().filter(|output| is_chosen(output, &arguments.only)).collect();
    if !arguments.check {
        let paths: Vec<PathBuf> = chosen.iter().flat_map(|output| output.paths_in(&edition)).collect();
        folder::ensure_writable(&output_folder, &paths)?;
    }
    if let Some(jobs) = arguments.jobs {
        start_threads(jobs)?;
    }
    let (mut files, verdict) = make(&parameters, &chosen, &edition)?;
    if latex::has_snippet(&edition) && arguments.only.is_empty() {
        files.push(snippet(&chosen, &edition, &files));
    }
    let mut places = vec![Place { folder: output_folder, files, complete: false }];
    if edition.is_default() && arguments.only.is_empty() {
        places[0].complete = true;
        if arguments.output.is_none() {
            let manifest = MadeFile {
                path: PathBuf::from(codecheck::FILE),
                content: codecheck::manifest().into_bytes(),
            };
            places.push(Place { folder: project::root_folder()?, files: vec![manifest], complete: false });
        }
    }
    if arguments.check {
        check(&places, arguments, &edition)?;
        let count = places.iter().map(|place| place.files.len()).sum();
        terminal::say(&format!("{} are what the code makes.\n", counted(count)));
    } else {
        terminal::say(&write(&places)?);
    }
    terminal::say(&format!("{verdict}\n{:.1} s\n", start.elapsed().as_secs_f64()));
    Ok(())
}

/// Files that were made, and where they belong.
struct Place {
    folder: PathBuf,
    files: Vec<MadeFile>,
    /// Whether nothing else belongs there.
    complete: bool,
}

/// The LaTeX snippet that includes all outputs.
fn snippet(chosen: &[&Output], edition: &Edition, files: &[MadeFile]) -> MadeFile {
    let rows = |table: &str| {
        let path = latex::table_path(table);
        files.iter().find(|file| file.path == path).map_or(0, |file| latex::rows(&file.content))
    };
    let content = latex::snippet(chosen, edition, rows).into_bytes();
    MadeFile { path: PathBuf::from(latex::SNIPPET), content }
}

/// Writes all files and draws the figures that changed; returns what there is to tell.
fn write(places: &[Place]) -> Result<String, Failure> {
    let mut told = Vec::new();
    for Place { folder, files, .. } in places {
        let changed = visual::changed(folder, files);
        let changes = folder::write(folder, files)?;
        told.extend(files.iter().map(|file| folder.join(&file.path).display().to_string()).zip(changes));
        visual::show(&changed);
    }
    Ok(summary(&told))
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
fn make(
    parameters: &Parameters,
    chosen: &[&Output],
    edition: &Edition,
) -> Result<(Vec<MadeFile>, String), Failure> {
    let display = Display::new();
    let study = Study::new(parameters).with_progress(&display);
    let mut files = Vec::new();
    for output in chosen {
        files.extend(output.files(&study, edition)?);
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

fn check(places: &[Place], arguments: &Reproduce, edition: &Edition) -> Result<(), Failure> {
    let mut differences = Vec::new();
    for place in places {
        differences.extend(folder::differences(&place.folder, &place.files, &KNOWN, place.complete)?);
    }
    if differences.is_empty() {
        return Ok(());
    }
    for difference in &differences {
        terminal::note(&difference.to_string());
    }
    for place in places {
        visual::show(&visual::changed(&place.folder, &place.files));
    }
    let unexpected = differences.iter().filter(|difference| difference.kind == Kind::Unexpected).count();
    Err(Failure::CheckFailed {
        folder: places[0].folder.display().to_string(),
        wrong: differences.len() - unexpected,
        unexpected,
        mend: mending_command(arguments, edition),
    })
}

/// The command that writes what this check compared with.
fn mending_command(arguments: &Reproduce, edition: &Edition) -> String {
    let mut command = "cargo xtask reproduce".to_owned();
    for name in &arguments.only {
        command.push_str(&format!(" --only {name}"));
    }
    command.push_str(&edition.options());
    if let Some(file) = &arguments.parameters.file {
        command.push_str(&format!(" --parameters {}", file.display()));
    }
    if let Some(folder) = &arguments.output {
        command.push_str(&format!(" --output {}", folder.display()));
    }
    command
}

/// A line for each file, and one that counts.
pub(crate) fn summary(told: &[(String, Change)]) -> String {
    let width = told.iter().map(|(name, _)| name.len()).max().unwrap_or(0);
    let mut text = String::new();
    let mut counts = [0; 3];
    for (name, change) in told {
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
    let _ = writeln!(text, "{}: {new} new, {updated} updated, {unchanged} unchanged.", counted(told.len()));
    text
}

fn counted(files: usize) -> String {
    if files == 1 { "1 file".to_owned() } else { format!("{files} files") }
}
