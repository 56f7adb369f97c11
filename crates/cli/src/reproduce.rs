//! `grazing reproduce`: compute first, then write everything or check it.

use std::collections::BTreeSet;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::time::Instant;

use grazing_reproduction::{Coefficients, Study};

use crate::arguments::{ParameterFile, Reproduce};
use crate::compare::published;
use crate::failure::Failure;
use crate::folder::{self, Change, Differences, MadeFile};
use crate::outputs::edition::{Edition, Format};
use crate::outputs::latex::{self, Float};
use crate::outputs::{self, Output};
use crate::progress::Display;
use crate::{codecheck, data_page, project, terminal, visual};

/// The file that says what was set over the parameter file.
const SETTINGS: &str = "settings.txt";
/// What belongs in the output folder although the program does not make it.
const KNOWN: [&str; 1] = ["parameters.toml"];

/// Makes the outputs that were asked for.
///
/// # Errors
/// A check was asked for and files differ, or they could not be made.
pub(crate) fn run(arguments: &Reproduce) -> Result<(), Failure> {
    crate::limits::leave_nothing_behind();
    let start = Instant::now();
    let edition = Edition::new(&arguments.look);
    let (parameters, set) = (project::parameters(&arguments.parameters)?, &arguments.parameters.set);
    let output_folder = project::output_folder(arguments.output.as_deref(), &edition, !set.is_empty())?;
    let chosen: Vec<&Output> =
        outputs::ALL.iter().filter(|output| is_chosen(output, &arguments.only)).collect();
    outputs::refuse_malformed(chosen.iter().copied(), &parameters)?;
    if !arguments.check {
        let mut paths: Vec<PathBuf> = chosen.iter().flat_map(|output| output.paths(&edition)).collect();
        paths.extend(arguments.only.is_empty().then(data_page::path));
        paths.extend(edition.has(Format::Tex).then(|| PathBuf::from(latex::SNIPPET)));
        paths.extend((!set.is_empty()).then(|| PathBuf::from(SETTINGS)));
        folder::ensure_writable(&output_folder, &paths)?;
    }
    arguments.threads.start()?;
    let display = Display::new();
    let study = Study::new(&parameters).with_progress(&display);
    let mut made = Outcome::of(&study, &chosen, &edition)?;
    if made.outputs.is_empty() {
        return made.tell_missing(&chosen, &output_folder);
    }
    let mut files = std::mem::take(&mut made.files);
    if edition.has(Format::Tex) && arguments.only.is_empty() {
        files.push(latex::snippet(&made.floats));
    }
    if !set.is_empty() {
        files.push(settings(&arguments.parameters));
    }
    if arguments.only.is_empty() {
        files.push(data_page::of_the_paper(chosen.iter().flat_map(|output| output.tables).copied()));
    }
    let mut places = vec![MadeFolder { folder: output_folder, files, complete: false }];
    if edition.is_default() && arguments.only.is_empty() {
        places[0].complete = made.missing.is_empty();
        if arguments.output.is_none() && set.is_empty() {
            let manifest = MadeFile {
                path: PathBuf::from(codecheck::FILE),
                content: codecheck::manifest().into_bytes(),
            };
            places.push(MadeFolder {
                folder: project::root_folder()?,
                files: vec![manifest],
                complete: false,
            });
        }
    }
    if arguments.check {
        if let Err(failure) = check(&places, arguments, &edition) {
            made.tell_missing(&chosen, &places[0].folder)?;
            return Err(failure);
        }
        let count = places.iter().map(|place| place.files.len()).sum();
        terminal::say(&format!("{} are what the code makes.\n", counted(count)));
    } else {
        terminal::say(&write(&places)?);
    }
    if arguments.only.is_empty() {
        terminal::say(&verdict(&study));
    }
    terminal::say(&format!("{:.1} s\n", start.elapsed().as_secs_f64()));
    made.tell_missing(&chosen, &places[0].folder)?;
    let told = chosen.iter().any(|output| output.name == outputs::COEFFICIENTS.name);
    match study.coefficients() {
        Ok(table) if told && table.rows.iter().any(Coefficients::contradict) => Err(Failure::check(
            "coefficients: the theorem is contradicted, as told above; everything is written",
        )),
        _ => Ok(()),
    }
}

/// What was made of the outputs that were asked for.
#[derive(Default)]
struct Outcome<'a> {
    files: Vec<MadeFile>,
    /// Figures and tables for LaTeX.
    floats: Vec<Float>,
    outputs: Vec<&'a Output>,
    /// Why outputs could not be made, or not wholly, with their names.
    missing: Vec<(String, Vec<&'static str>)>,
}

impl<'a> Outcome<'a> {
    /// All outputs that can be made; the failure if the only one cannot.
    fn of(study: &Study<'_>, chosen: &[&'a Output], edition: &Edition) -> Result<Self, Failure> {
        let mut all = Self::default();
        for output in chosen {
            match output.files(study, edition) {
                Ok((made, files)) => {
                    made.notes.iter().for_each(|note| terminal::note(&format!("{}: {note}", output.name)));
                    all.files.extend(files);
                    all.floats.extend(made.floats);
                    for gap in made.gaps {
                        all.add_missing(output.name, format!("it is written, but {gap}"));
                    }
                    all.outputs.push(output);
                }
                Err(failure) if chosen.len() == 1 => return Err(failure),
                Err(failure) => all.add_missing(output.name, failure.reason),
            }
        }
        Ok(all)
    }

    fn add_missing(&mut self, output: &'static str, reason: String) {
        match self.missing.iter_mut().find(|(known, _)| *known == reason) {
            Some((_, outputs)) => outputs.push(output),
            None => self.missing.push((reason, vec![output])),
        }
    }

    /// Tells which outputs are missing and why.
    fn tell_missing(&self, chosen: &[&Output], folder: &Path) -> Result<(), Failure> {
        for (reason, outputs) in &self.missing {
            terminal::note(&format!("error: {}: {reason}", outputs.join(", ")));
        }
        let names: BTreeSet<&str> = self.missing.iter().flat_map(|(_, outputs)| outputs).copied().collect();
        if names.is_empty() {
            return Ok(());
        }
        let absent = chosen.iter().filter(|output| self.outputs.iter().all(|made| made.name != output.name));
        let paths = absent.flat_map(|output| output.paths(&Edition::default()));
        let left = paths.filter(|path| folder.join(path).exists()).count();
        if left > 0 {
            terminal::note(&format!(
                "{} from earlier runs, of outputs that could not be made now, left in {}",
                counted(left),
                folder.display()
            ));
        }
        Err(Failure::partly_made(names.len(), chosen.len()))
    }
}

/// What was set, for the folder in which the files do not tell.
fn settings(parameters: &ParameterFile) -> MadeFile {
    let file = parameters.file.as_deref().unwrap_or(Path::new(project::PARAMETERS));
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    let set = parameters.set.iter().map(|setting| format!("--set {setting}\n"));
    let content =
        [format!("made from {name} with\n")].into_iter().chain(set).collect::<String>().into_bytes();
    MadeFile { path: PathBuf::from(SETTINGS), content }
}

/// Files that were made, and where they belong.
struct MadeFolder {
    folder: PathBuf,
    files: Vec<MadeFile>,
    /// Whether nothing else belongs there.
    complete: bool,
}

/// Writes all files and draws the figures that changed; returns what there is to tell.
fn write(places: &[MadeFolder]) -> Result<String, Failure> {
    let mut told = Vec::new();
    for MadeFolder { folder, files, .. } in places {
        let changed = visual::changed(folder, files);
        told.extend(folder::written(folder, files)?);
        visual::show(folder, &changed);
    }
    Ok(summary(&told))
}

fn is_chosen(output: &Output, only: &[String]) -> bool {
    only.is_empty() || only.iter().any(|name| name == output.name)
}

/// A line that says whether the published values are met.
fn verdict(study: &Study<'_>) -> String {
    let Ok(comparisons) = published(study) else {
        // Why not is told of the outputs that need the same.
        return "Published values could not be compared.\n".to_owned();
    };
    let met = comparisons.iter().filter(|comparison| comparison.is_met()).count();
    if met == comparisons.len() {
        format!("All {met} published values are met.\n")
    } else {
        format!("Only {met} of {} published values are met: see `cargo xtask compare`.\n", comparisons.len())
    }
}

fn check(places: &[MadeFolder], arguments: &Reproduce, edition: &Edition) -> Result<(), Failure> {
    let mut found = Differences::default();
    for place in places {
        folder::compare(&place.folder, &place.files, &KNOWN, place.complete, &mut found)?;
    }
    let Differences { differing, unexpected } = found;
    if differing.is_empty() && unexpected.is_empty() {
        return Ok(());
    }
    differing.iter().chain(&unexpected).for_each(|difference| terminal::note(difference));
    for place in places {
        visual::show(&place.folder, &visual::changed(&place.folder, &place.files));
    }
    let mut remedies = Vec::new();
    if !differing.is_empty() {
        let mend = mending_command(arguments, edition);
        remedies.push(format!("mend {} with `{mend}`", counted(differing.len())));
    }
    if !unexpected.is_empty() {
        remedies.push(format!("remove {} that it does not make", counted(unexpected.len())));
    }
    let folder = places[0].folder.display();
    Err(Failure::check(format!("{folder} is not what the code makes: {}", remedies.join(", "))))
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
    for setting in &arguments.parameters.set {
        command.push_str(&format!(" --set '{setting}'"));
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
