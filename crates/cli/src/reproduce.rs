//! `grazing reproduce`: computes the outputs first, then writes or checks all files.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use grazing_claims::published::Tally;
use grazing_report::FileDigest;
use grazing_reproduction::{ComparedCoefficients, Study};
use grazing_unfold::progress::{Progress, Silent};

use crate::arguments::{ParameterFile, ReproduceArguments};
use crate::commands::CommandLine;
use crate::compare::published;
use crate::failure::Failure;
use crate::folder::{self, Batch, Listed, OutputFile, counted};
use crate::outputs::edition::{Edition, Format};
use crate::outputs::latex::{self, Float};
use crate::outputs::{Output, paper};
use crate::runner::{CommandOutcome, Next, Plan, Running};
use crate::unfold::FIGURES;
use crate::{codecheck, data_page, project, readme, terminal};

/// The file that lists the settings over the parameter file.
const SETTINGS: &str = "settings.txt";
/// The files in the output folder beside the outputs: the parameters, and the list of files.
const KNOWN: &[&str] = &["parameters.toml", folder::MANIFEST];

/// Reads which outputs are to be computed, and written or checked.
///
/// # Errors
/// Bad input.
pub(crate) fn read(arguments: &ReproduceArguments) -> Result<Plan<'_>, Failure> {
    let (edition, set) = (arguments.look.edition(), &arguments.parameters.set);
    let parameters = project::parameters(&arguments.parameters)?;
    let folder = project::output_folder(arguments.output.as_deref(), &edition, !set.is_empty())?;
    let is_chosen = |name: &str| arguments.only.is_empty() || arguments.only.iter().any(|only| only == name);
    let chosen: Vec<&Output<Study>> = paper::ALL.iter().filter(|output| is_chosen(output.name)).collect();
    paper::refuse_malformed(chosen.iter().copied(), &Study::new(&parameters))?;
    let mut paths: Vec<PathBuf> = chosen.iter().flat_map(|output| output.paths(&edition)).collect();
    paths.extend(latex::FILES.iter().filter(|_| edition.has(Format::Tex)).map(PathBuf::from));
    paths.extend((!set.is_empty()).then(|| PathBuf::from(SETTINGS)));
    let of = chosen.clone();
    let compute = move |running: &Running<'_>| {
        let study = Study::new(&parameters).with_progress(running.progress().clone());
        // A single output has phases of its own, and a bar if there are any.
        let has_phases = of.len() == 1 && !terminal::is_watched();
        let progress: &dyn Progress = if has_phases { &Silent } else { &**running.progress() };
        let outputs = Outputs::of(&study, &of, &arguments.look.edition(), progress)?;
        Ok((study, outputs))
    };
    let say = move |(study, outputs): (Study, Outputs), folder: &Path| {
        outputs.outcome(arguments, &chosen, &study, folder)
    };
    Ok(Plan::new(compute, say).writing_run(folder, paths).checking(arguments.check))
}

/// The files of all outputs of a study in an edition. Contents of figures are computed once, for whatever editions.
///
/// # Errors
/// Some output cannot be computed.
pub fn files(study: &Study, edition: &Edition) -> Result<Vec<OutputFile>, Failure> {
    let chosen: Vec<&Output<Study>> = paper::ALL.iter().collect();
    let outcome = Outputs::of(study, &chosen, edition, &Silent)?;
    match outcome.missing.first() {
        Some((reason, _)) => Err(Failure::input(reason.clone())),
        None => Ok(outcome.files),
    }
}

/// The failure if theorem and curve contradict each other at a resonance.
fn verdict_on_theorem(rows: &[ComparedCoefficients]) -> Result<(), Failure> {
    if !rows.iter().any(ComparedCoefficients::contradict) {
        return Ok(());
    }
    Err(Failure::check(
        "coefficients: theorem and computation contradict each other, see the table; everything is written",
    ))
}

/// The results of the selected outputs.
#[derive(Default)]
struct Outputs {
    files: Vec<OutputFile>,
    /// Figures and tables for LaTeX.
    floats: Vec<Float>,
    /// The outputs that were computed.
    computed: Vec<&'static str>,
    /// The reasons why outputs failed or are incomplete, with the names of the outputs.
    missing: Vec<(String, Vec<&'static str>)>,
}

impl Outputs {
    /// All outputs that can be computed, and the files for LaTeX if none was left out; the failure if the only output
    /// cannot be computed.
    fn of(
        study: &Study,
        chosen: &[&Output<Study>],
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
                    all.computed.push(output.name);
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

    /// The files of all that was computed, and of a whole run also those at the root of the repository.
    fn outcome(
        self,
        arguments: &ReproduceArguments,
        chosen: &[&Output<Study>],
        study: &Study,
        folder: &Path,
    ) -> Result<CommandOutcome, Failure> {
        let ReproduceArguments { only, check, parameters, look, output, .. } = arguments;
        let (edition, is_varied) = (look.edition(), !parameters.set.is_empty());
        let (is_run, incomplete) = (only.is_empty(), !self.missing.is_empty());
        let mut files = self.files.clone();
        files.extend(is_varied.then(|| settings(parameters)));
        if is_run {
            files.push(data_page::of_the_paper(chosen.iter().flat_map(|output| output.tables).copied()));
        }
        let listed = if is_run { Listed::Run } else { Listed::Part(origin(parameters)?) };
        let beside = (is_run && edition.is_default() && !incomplete).then_some(KNOWN);
        let results = Batch { listed, incomplete, beside, ..Batch::run(folder, files) };
        let (notes, failure) = self.missing(chosen, &results.place());
        if self.computed.is_empty() {
            return Ok(CommandOutcome { notes, failure, ..CommandOutcome::default() });
        }
        let mut batches = vec![results];
        if is_run && edition.is_default() && output.is_none() && !is_varied {
            let (path, content) = (PathBuf::from(codecheck::FILE), codecheck::manifest().into_bytes());
            let folder = project::root_folder()?;
            let mut files = vec![OutputFile { path, content }];
            // Of incomplete results there are no counts.
            files.extend(if incomplete { None } else { readme::file(&folder, study)? });
            batches.push(Batch::unlisted(&folder, files));
        }
        // Coefficients are not computed for this alone.
        let has_coefficients = chosen.iter().any(|output| output.name == paper::COEFFICIENTS.name);
        let coefficients = if has_coefficients { study.coefficients().ok() } else { None };
        let theorem = coefficients.and_then(|table| verdict_on_theorem(&table.rows).err());
        Ok(CommandOutcome {
            batches,
            check: check.then(|| mending_command(arguments, &edition)),
            pictures: true,
            remark: if is_run { verdict(study) } else { String::new() },
            next: match self.computed.len() {
                1 => Next::Look,
                _ => CommandLine::own("report").options(parameters.options()).into(),
            },
            notes,
            failure: failure.or(theorem),
            ..CommandOutcome::default()
        })
    }

    /// Messages that say which outputs are missing and why, and the failure if there are any.
    fn missing(&self, chosen: &[&Output<Study>], folder: &Path) -> (Vec<String>, Option<Failure>) {
        let message =
            |(reason, outputs): &(String, Vec<_>)| format!("error: {}: {reason}", outputs.join(", "));
        let mut notes: Vec<String> = self.missing.iter().map(message).collect();
        let names: BTreeSet<&str> = self.missing.iter().flat_map(|(_, outputs)| outputs).copied().collect();
        if names.is_empty() {
            return (notes, None);
        }
        let failure = Failure::partial(names.len(), chosen.len());
        let absent = chosen.iter().filter(|output| !self.computed.contains(&output.name));
        let paths = absent.flat_map(|output| output.paths(&Edition::default()));
        let left = paths.filter(|path| folder.join(path).exists()).count();
        if left > 0 {
            notes.push(format!(
                "{} from earlier runs, of outputs that failed now, remain in {}",
                counted(left),
                folder.display()
            ));
        }
        (notes, Some(failure))
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

/// A digest of what outputs are computed from: the parameters, the settings over them, and the program's version.
fn origin(parameters: &ParameterFile) -> Result<String, Failure> {
    let (_, text) = project::parameter_file(parameters.file.as_deref())?;
    let set: String = parameters.set.iter().map(|setting| format!("{setting}\n")).collect();
    let all = format!("{text}\n{set}{}", env!("CARGO_PKG_VERSION"));
    Ok(FileDigest::of("", all.as_bytes()).sha256)
}

/// The command that writes the files of this check.
fn mending_command(arguments: &ReproduceArguments, edition: &Edition) -> CommandLine {
    let folder = arguments.output.iter().map(|folder| ("--output", folder.display()));
    CommandLine::own("reproduce")
        .options(arguments.only.iter().map(|name| ("--only", name)))
        .options(edition.options())
        .options(arguments.parameters.options())
        .options(folder)
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
        let row = |measured| ComparedCoefficients {
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
