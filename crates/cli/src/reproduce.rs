//! `grazing reproduce`: computes the outputs first, then writes or checks all files.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Instant;

use grazing_claims::published::Tally;
use grazing_report::FileDigest;
use grazing_reproduction::{Coefficients, Study};
use grazing_unfold::progress::{Progress, Silent};

use crate::arguments::{ParameterFile, Reproduce};
use crate::commands::CommandLine;
use crate::compare::published;
use crate::failure::Failure;
use crate::folder::{self, Differences, OutputFile, counted, summary};
use crate::outputs::edition::{Edition, Format};
use crate::outputs::latex::{self, Float};
use crate::outputs::{Output, paper};
use crate::progress::Display;
use crate::unfold::FIGURES;
use crate::{codecheck, data_page, project, readme, terminal, visual};

/// The file that lists the settings over the parameter file.
const SETTINGS: &str = "settings.txt";
/// The files in the output folder beside the outputs: the parameters, and the list of files.
const KNOWN: [&str; 2] = ["parameters.toml", folder::MANIFEST];

/// Computes the selected outputs, and writes or checks their files.
///
/// # Errors
/// The files that are checked differ, or outputs could not be computed.
pub(crate) fn run(arguments: &Reproduce) -> Result<(), Failure> {
    crate::limits::leave_nothing_behind();
    let start = Instant::now();
    let edition = arguments.look.edition();
    let (parameters, set) = (project::parameters(&arguments.parameters)?, &arguments.parameters.set);
    let display = Arc::new(Display::new());
    let study = Study::new(&parameters).with_progress(display.clone());
    let output_folder = project::output_folder(arguments.output.as_deref(), &edition, !set.is_empty())?;
    let chosen: Vec<&Output<Study>> =
        paper::ALL.iter().filter(|output| is_chosen(output, &arguments.only)).collect();
    paper::refuse_malformed(chosen.iter().copied(), &study)?;
    if !arguments.check {
        let mut paths: Vec<PathBuf> = chosen.iter().flat_map(|output| output.paths(&edition)).collect();
        paths.push(PathBuf::from(folder::MANIFEST));
        if arguments.only.is_empty() {
            paths.push(data_page::path());
        }
        paths.extend(latex::FILES.iter().filter(|_| edition.has(Format::Tex)).map(PathBuf::from));
        paths.extend((!set.is_empty()).then(|| PathBuf::from(SETTINGS)));
        folder::ensure_writable(&output_folder, &paths)?;
    }
    arguments.threads.start()?;
    // A single output has phases of its own, and a bar if there are any.
    let progress: &dyn Progress = if chosen.len() > 1 || display.has_bars() { &*display } else { &Silent };
    let mut outcome = Outcome::of(&study, &chosen, &edition, progress)?;
    if outcome.outputs.is_empty() {
        return outcome.report_missing(&chosen, &output_folder);
    }
    let mut files = std::mem::take(&mut outcome.files);
    if !set.is_empty() {
        files.push(settings(&arguments.parameters));
    }
    if arguments.only.is_empty() {
        files.push(data_page::of_the_paper(chosen.iter().flat_map(|output| output.tables).copied()));
    }
    let (is_run, incomplete) = (arguments.only.is_empty(), !outcome.missing.is_empty());
    let complete = is_run && edition.is_default() && !incomplete;
    let folder = folder::place_of_run(&output_folder, &files, incomplete);
    let listed = if is_run { Listed::Run } else { Listed::Part(origin(&arguments.parameters)?) };
    let mut places = vec![OutputFolder { folder: output_folder, files, listed, incomplete, complete }];
    if is_run && edition.is_default() && arguments.output.is_none() && set.is_empty() {
        let (path, content) = (PathBuf::from(codecheck::FILE), codecheck::manifest().into_bytes());
        let folder = project::root_folder()?;
        let mut files = vec![OutputFile { path, content }];
        // Of incomplete results there are no counts.
        files.extend(if incomplete { None } else { readme::file(&folder, &study)? });
        places.push(OutputFolder { folder, files, listed: Listed::No, incomplete: false, complete: false });
    }
    if arguments.check {
        if let Err(failure) = check(&places, arguments, &edition) {
            outcome.report_missing(&chosen, &folder)?;
            return Err(failure);
        }
        let count = places.iter().map(|place| place.files.len()).sum();
        terminal::say(&format!("{} checked: all are what the code produces.\n", counted(count)));
    } else {
        terminal::say(&write(&places)?);
    }
    if arguments.only.is_empty() {
        terminal::say(&verdict(&study));
    }
    terminal::say(&format!("{:.1} s\n", start.elapsed().as_secs_f64()));
    if let Some(step) = next(arguments, &outcome, &folder) {
        terminal::say_next(&step);
    }
    outcome.report_missing(&chosen, &folder)?;
    let listed = chosen.iter().any(|output| output.name == paper::COEFFICIENTS.name);
    // Coefficients are not computed for this alone.
    if !listed {
        return Ok(());
    }
    study.coefficients().map_or(Ok(()), |table| verdict_on_theorem(&table.rows))
}

/// The files of all outputs of a study in an edition. Contents of figures are computed once, for whatever editions.
///
/// # Errors
/// Some output cannot be computed.
pub fn files(study: &Study, edition: &Edition) -> Result<Vec<OutputFile>, Failure> {
    let chosen: Vec<&Output<Study>> = paper::ALL.iter().collect();
    let outcome = Outcome::of(study, &chosen, edition, &Silent)?;
    match outcome.missing.first() {
        Some((reason, _)) => Err(Failure::input(reason.clone())),
        None => Ok(outcome.files),
    }
}

/// The failure if theorem and curve contradict each other at a resonance.
fn verdict_on_theorem(rows: &[Coefficients]) -> Result<(), Failure> {
    if !rows.iter().any(Coefficients::contradict) {
        return Ok(());
    }
    Err(Failure::check(
        "coefficients: theorem and computation contradict each other, see the table; everything is written",
    ))
}

/// The results of the selected outputs.
#[derive(Default)]
struct Outcome<'a> {
    files: Vec<OutputFile>,
    /// Figures and tables for LaTeX.
    floats: Vec<Float>,
    outputs: Vec<&'a Output<Study>>,
    /// The reasons why outputs failed or are incomplete, with the names of the outputs.
    missing: Vec<(String, Vec<&'static str>)>,
}

impl<'a> Outcome<'a> {
    /// All outputs that can be computed, and the files for LaTeX if none was left out; the failure if the only output
    /// cannot be computed.
    fn of(
        study: &Study,
        chosen: &[&'a Output<Study>],
        edition: &Edition,
        progress: &dyn Progress,
    ) -> Result<Self, Failure> {
        let mut all = Self::default();
        progress.begin(FIGURES, chosen.len() as u64);
        for output in chosen {
            let made = output.made(study, edition);
            progress.step(FIGURES);
            match made {
                Ok((computed, files, floats)) => {
                    all.files.extend(files);
                    all.floats.extend(floats);
                    for gap in computed.gaps {
                        all.add_missing(output.name, format!("written, but {gap}"));
                    }
                    all.outputs.push(output);
                }
                Err(failure) if chosen.len() == 1 => {
                    progress.end(FIGURES);
                    return Err(failure);
                }
                Err(failure) => all.add_missing(output.name, failure.reason),
            }
        }
        progress.end(FIGURES);
        if edition.has(Format::Tex) && chosen.len() == paper::ALL.len() {
            let oscillator = study.parameters.oscillator()?;
            let constants =
                [("zeta", oscillator.damping_ratio()), ("epsilon", oscillator.coefficient_of_restitution())];
            all.files.extend(latex::files(&all.floats, constants));
        }
        Ok(all)
    }

    fn add_missing(&mut self, output: &'static str, reason: String) {
        match self.missing.iter_mut().find(|(known, _)| *known == reason) {
            Some((_, outputs)) => outputs.push(output),
            None => self.missing.push((reason, vec![output])),
        }
    }

    /// Reports which outputs are missing and why.
    fn report_missing(&self, chosen: &[&Output<Study>], folder: &Path) -> Result<(), Failure> {
        for (reason, outputs) in &self.missing {
            terminal::note(&format!("error: {}: {reason}", outputs.join(", ")));
        }
        let names: BTreeSet<&str> = self.missing.iter().flat_map(|(_, outputs)| outputs).copied().collect();
        if names.is_empty() {
            return Ok(());
        }
        let absent =
            chosen.iter().filter(|output| self.outputs.iter().all(|computed| computed.name != output.name));
        let paths = absent.flat_map(|output| output.paths(&Edition::default()));
        let left = paths.filter(|path| folder.join(path).exists()).count();
        if left > 0 {
            terminal::note(&format!(
                "{} from earlier runs, of outputs that failed now, remain in {}",
                counted(left),
                folder.display()
            ));
        }
        Err(Failure::partial(names.len(), chosen.len()))
    }
}

/// The file of the settings, which the other files do not contain.
fn settings(parameters: &ParameterFile) -> OutputFile {
    let file = parameters.file.as_deref().unwrap_or(Path::new(project::PARAMETERS));
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    let set = parameters.set.iter().map(|setting| format!("--set {setting}\n"));
    let content =
        [format!("computed from {name} with\n")].into_iter().chain(set).collect::<String>().into_bytes();
    OutputFile { path: PathBuf::from(SETTINGS), content }
}

/// How files are listed in their folder.
#[derive(PartialEq)]
enum Listed {
    /// As all files of a run.
    Run,
    /// As those of some outputs, with the digest of what these are computed from.
    Part(String),
    No,
}

/// A digest of what outputs are computed from: the parameters, the settings over them, and the program's version.
fn origin(parameters: &ParameterFile) -> Result<String, Failure> {
    let (_, text) = project::parameter_file(parameters.file.as_deref())?;
    let set: String = parameters.set.iter().map(|setting| format!("{setting}\n")).collect();
    let all = format!("{text}\n{set}{}", env!("CARGO_PKG_VERSION"));
    Ok(FileDigest::of("", all.as_bytes()).sha256)
}

/// Computed files, and the folder that they belong to.
struct OutputFolder {
    folder: PathBuf,
    files: Vec<OutputFile>,
    /// How the files are listed there.
    listed: Listed,
    /// Whether something failed or is incomplete.
    incomplete: bool,
    /// Whether nothing else belongs in the folder.
    complete: bool,
}

impl OutputFolder {
    /// The folder that holds the files, or to which they go.
    fn place(&self) -> PathBuf {
        folder::place_of_run(&self.folder, &self.files, self.incomplete)
    }
}

/// What to do after a run that has written: look at the only figure, or read everything on one page.
fn next(arguments: &Reproduce, outcome: &Outcome<'_>, folder: &Path) -> Option<CommandLine> {
    if arguments.check {
        return None;
    }
    match outcome.outputs.as_slice() {
        [output] if output.is_figure => {
            let edition = arguments.look.edition();
            let figure = edition.figure_paths(&output.figure_file()).next()?;
            Some(CommandLine::of(&["open"]).with(folder.join(figure).display()))
        }
        [output] => {
            let table = output.paths(&Edition::default()).into_iter().next()?;
            Some(CommandLine::of(&["open"]).with(folder.join(table).display()))
        }
        _ => Some(CommandLine::own("report").options(parameter_options(&arguments.parameters))),
    }
}

/// Writes all files and draws the figures that changed; returns the summary.
fn write(places: &[OutputFolder]) -> Result<String, Failure> {
    let mut changes = Vec::new();
    for place in places {
        let OutputFolder { folder, files, listed, incomplete, .. } = place;
        let changed = visual::changed(&place.place(), files);
        changes.extend(match listed {
            Listed::Run => folder::write_run(folder, files, *incomplete)?,
            Listed::Part(from) => folder::write_part(folder, files, from, *incomplete)?,
            Listed::No => folder::written(&folder::place_to_write(folder, files, *incomplete), files)?,
        });
        visual::show(&place.place(), &changed);
    }
    Ok(summary(&changes))
}

fn is_chosen(output: &Output<Study>, only: &[String]) -> bool {
    only.is_empty() || only.iter().any(|name| name == output.name)
}

/// A line that says whether the published values are met.
fn verdict(study: &Study) -> String {
    let Ok(comparisons) = published(study) else {
        // The outputs that need the same say why.
        return "The published values could not be compared.\n".to_owned();
    };
    let tally = Tally::of(&comparisons);
    let more =
        if tally.is_complete() { String::new() } else { format!(": see `{}`", CommandLine::own("compare")) };
    format!("{tally}{more}.\n")
}

fn check(places: &[OutputFolder], arguments: &Reproduce, edition: &Edition) -> Result<(), Failure> {
    let mut found = Differences::default();
    for place in places {
        let (folder, files) = (place.place(), &place.files);
        folder::compare(&folder, files, &KNOWN, place.complete, &mut found)?;
        let list = (place.listed == Listed::Run).then(|| folder::list(files, place.incomplete));
        folder::compare(&folder, list.as_slice(), &[], false, &mut found)?;
    }
    let Differences { differing, unexpected } = found;
    if differing.is_empty() && unexpected.is_empty() {
        return Ok(());
    }
    differing.iter().chain(&unexpected).for_each(|difference| terminal::note(difference));
    for place in places {
        visual::show(&place.place(), &visual::changed(&place.place(), &place.files));
    }
    let mut remedies = Vec::new();
    if !differing.is_empty() {
        let mend = mending_command(arguments, edition);
        remedies.push(format!("update {} with `{mend}`", counted(differing.len())));
    }
    if !unexpected.is_empty() {
        remedies.push(format!("remove {} that it does not produce", counted(unexpected.len())));
    }
    let folder = places[0].place();
    let folder = folder.display();
    Err(Failure::check(format!("{folder} is not what the code produces: {}", remedies.join(", "))))
}

/// The command that writes the files of this check.
fn mending_command(arguments: &Reproduce, edition: &Edition) -> CommandLine {
    let folder = arguments.output.iter().map(|folder| ("--output", folder.display()));
    CommandLine::own("reproduce")
        .options(arguments.only.iter().map(|name| ("--only", name)))
        .options(edition.options())
        .options(parameter_options(&arguments.parameters))
        .options(folder)
}

/// The options that name these parameters.
fn parameter_options(parameters: &ParameterFile) -> impl Iterator<Item = (&'static str, String)> {
    let file = parameters.file.iter().map(|file| ("--parameters", file.display().to_string()));
    file.chain(parameters.set.iter().map(|setting| ("--set", setting.to_string())))
}

#[cfg(test)]
mod tests {
    use grazing_continuation::bifurcation::Pair;
    use grazing_continuation::fit::{Estimate, Measurement};
    use grazing_theorems::unfolding::StabilityCoefficients;
    use grazing_unfold::verdict::Coefficient;

    use super::*;

    #[test]
    fn a_contradiction_at_one_resonance_is_exit_code_1_and_none_is_success() {
        let known = |theorem, measured| Coefficient {
            stability: 1.0,
            theorem: Estimate { value: theorem, error: 1e-9 },
            fit: Ok(Measurement {
                coefficient: Estimate { value: measured, error: 1e-9 },
                eta: [1.0, 0.0],
                mu: [measured, 0.0],
                velocity: 0.01,
            }),
        };
        let row = |measured| Coefficients {
            loops: 1,
            n: 3,
            frequency: 0.5,
            amplitude: 0.25,
            stability: StabilityCoefficients { plus: 1.0, minus: 1.0 },
            closed_form: Pair { saddle_node: 2.0, period_doubling: 3.0 },
            measured: Pair { saddle_node: known(2.0, 2.0), period_doubling: known(3.0, measured) },
        };
        assert!(verdict_on_theorem(&[row(3.0), row(3.0)]).is_ok());
        let failure = verdict_on_theorem(&[row(3.0), row(3.1)]).expect_err("they differ");
        assert_eq!(failure.exit_code(), 1);
    }
}
