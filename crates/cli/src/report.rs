//! `grazing report`: all results on one page.

mod links;
mod oscillators;

use std::path::{Path, PathBuf};

use grazing_report::{Counts, FiguresAndTables, FileDigest, Manifest, Report, TableOutput, page};
use grazing_reproduction::Study;
use grazing_reproduction::parameters::Parameters;
use grazing_results::title::TitleSubject;
use grazing_unfold::progress::Progress;

use crate::arguments::ReportArguments;
use crate::compare::published;
use crate::failure::Failure;
use crate::folder::{self, Batch, OutputFile};
use crate::oscillator::{OscillatorFile, file_name, noted};
use crate::outputs::edition::Edition;
use crate::outputs::paper;
use crate::runner::{CommandOutcome, Next, Plan, Running};
use crate::unfold::FIGURES;
use crate::{claims, project, versions};

/// Reads all that the page is computed from. Claims that do not hold are shown on it.
///
/// # Errors
/// Bad input, or the page cannot be written.
pub(crate) fn read(arguments: &ReportArguments) -> Result<Plan<'_>, Failure> {
    let parameters = project::parameters(&arguments.parameters)?;
    paper::refuse_malformed(paper::ALL.iter(), &Study::new(&parameters))?;
    let (folder, name) = place(&arguments.output)?;
    let sources = OscillatorFile::all(project::root().as_deref(), &arguments.oscillators)?;
    let all = paper::ALL.len() + sources.len();
    let compute = move |running: &Running<'_>| assemble(arguments, &parameters, &sources, running);
    let say = move |report: Report<'_>, folder: &Path| {
        let missing = report.missing.len();
        let batch = written(&report, folder, name);
        Ok(CommandOutcome {
            remark: summary(&report, &batch),
            batches: vec![batch],
            next: Next::Look,
            notes: report.missing.iter().map(|reason| format!("error: {reason}")).collect(),
            failure: (missing > 0).then(|| Failure::partial(missing, all)),
            ..CommandOutcome::default()
        })
    };
    Ok(Plan::new(compute, say).writing(folder, []))
}

/// The page in a folder; one with something missing does not replace a complete one.
fn written(report: &Report<'_>, folder: &Path, name: PathBuf) -> Batch {
    let files = vec![OutputFile { path: name, content: page(report).into_bytes() }];
    Batch { incomplete: !report.missing.is_empty(), ..Batch::unlisted(folder, files) }
}

/// The folder and the name of the page, after a check that it can be written.
fn place(output: &Path) -> Result<(PathBuf, PathBuf), Failure> {
    let folder = output.parent().unwrap_or(Path::new("")).to_owned();
    let refuse = |path: &Path, reason: &str| {
        let path = path.display();
        let remedy = "choose another file for the page with --output FILE";
        Err(Failure::input(format!("{path}: cannot be written: {reason}; {remedy}")))
    };
    let Some(name) = output.file_name().filter(|_| !output.is_dir()) else {
        return refuse(output, "it is a folder");
    };
    match folder::obstacle(&folder) {
        Some((path, reason)) => refuse(&path, &reason),
        None => folder::to_write(output).map(|_| (folder, PathBuf::from(name))),
    }
}

/// The content of the page.
fn assemble(
    arguments: &ReportArguments,
    parameters: &Parameters,
    oscillators: &[OscillatorFile],
    running: &Running<'_>,
) -> Result<Report<'static>, Failure> {
    let repository = project::root();
    let root = repository.as_deref().and_then(links::files_at_host);
    let (mut entries, mut missing) = (Vec::new(), Vec::new());
    for source in oscillators {
        match source.entry(repository.as_deref(), root.as_deref(), running) {
            Ok((entry, met)) => {
                entries.push(entry);
                missing.extend(met.map(|met| met.to_string()));
            }
            Err(failure) => missing.push(failure.to_string()),
        }
    }
    oscillators::distinguish(entries.iter_mut().map(|entry| &mut entry.id));
    let study = Study::new(parameters).with_progress(running.progress().clone());
    let (mut of_the_paper, mut beyond, mut digests) =
        (FiguresAndTables::default(), FiguresAndTables::default(), Vec::new());
    let progress: &dyn Progress = &**running.progress();
    progress.begin(FIGURES, paper::ALL.len() as u64);
    for output in paper::ALL {
        let made = output.made(&study, &Edition::default());
        progress.step(FIGURES);
        let (computed, files, _) = match made {
            Ok(made) => made,
            Err(failure) => {
                missing.push(format!("{}: {}", output.name, failure.reason));
                continue;
            }
        };
        missing.extend(computed.gaps.iter().map(|gap| format!("{}: shown, but {gap}", output.name)));
        digests
            .extend(files.iter().map(|file| FileDigest::of(file.path.display().to_string(), &file.content)));
        let part = if output.title.place == TitleSubject::Beyond { &mut beyond } else { &mut of_the_paper };
        if computed.figures.is_empty() {
            let (name, title) = (output.name.to_owned(), output.title.owned());
            part.tables.push(TableOutput { name, title, tables: computed.tables });
        } else {
            part.figures.extend(computed.entries());
        }
    }
    progress.end(FIGURES);
    // Their names are numbered as in the paper; the registry has them in the order in which they
    // are best made.
    let FiguresAndTables { mut figures, tables } = of_the_paper;
    figures.sort_by(|a, b| a.name.cmp(&b.name));
    let published = published(&study).unwrap_or_else(|failure| {
        missing.push(failure.to_string());
        Vec::new()
    });
    let all: Vec<_> = claims::LEDGER.claims.iter().collect();
    let claims = claims::findings(parameters, &all, progress)?;
    let default = arguments.parameters.file.is_none() && arguments.parameters.set.is_empty();
    let (file, text) = project::parameter_file(arguments.parameters.file.as_deref())?;
    Ok(Report {
        figures,
        tables,
        beyond,
        published,
        claims,
        sources: repository.as_deref().map(links::sources).unwrap_or_default(),
        oscillators: entries,
        missing,
        manifest: Manifest {
            parameter_file: if default {
                project::PARAMETERS.to_owned()
            } else {
                file_name(Path::new(&file))
            },
            parameters: noted(&text, &arguments.parameters.set),
            outputs: digests,
            // Other parameters give other files than those in the repository.
            folder: root.as_ref().filter(|_| default).map(|root| format!("{root}{}/", project::FIGURES)),
            ..versions::manifest()
        },
        root,
    })
}

/// A summary of the page, and its path.
fn summary(report: &Report<'_>, batch: &Batch) -> String {
    let (path, size) = match batch.files.as_slice() {
        [file, ..] => (batch.place().join(&file.path), file.content.len()),
        [] => (batch.place(), 0),
    };
    let Counts { published, passed, failed, given, unchecked, errata } = report.counts();
    format!(
        "{path}: {megabytes:.1} MB; it needs no network.\n\
         {published}.\n\
         Claims: {passed} passed, {failed} failed, {given} give parameters, {unchecked} cannot be tested; \
         {errata} errata.\n\
         {figures} figures, {files} output files, {oscillators} other oscillators.\n",
        path = path.display(),
        megabytes = size as f64 / 1e6,
        figures = report.figures.len(),
        files = report.manifest.outputs.len(),
        oscillators = report.oscillators.len(),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_page_with_something_missing_does_not_replace_a_complete_one() {
        use std::fs;

        let folder = tempfile::tempdir().expect("a temporary folder can be made");
        let write = |missing: &[&str]| {
            let missing = missing.iter().map(|reason| (*reason).to_owned()).collect();
            let report = Report { missing, ..Default::default() };
            let batch = written(&report, folder.path(), PathBuf::from("report.html"));
            batch.write().expect("the folder is ours");
            batch.place().join("report.html")
        };
        let whole = write(&[]);
        assert_eq!(whole, folder.path().join("report.html"));
        let page = fs::read(&whole).expect("it is there");
        assert_eq!(write(&["fig10: no theorem"]), folder.path().join("unfinished/report.html"));
        assert_eq!(fs::read(&whole).expect("it is there"), page);
    }
}
