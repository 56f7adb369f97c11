//! `grazing unfold`: the resonant grazing bifurcations of an oscillator that a text file describes.

pub(crate) mod analysis;
pub(crate) mod explanation;
mod keeper;
pub(crate) mod listing;
mod measured;
pub(crate) mod numbers;
pub(crate) mod page;
pub(crate) mod places;
pub(crate) mod reason;

use std::path::{Path, PathBuf};
use std::time::Instant;

use grazing_analysis::place::at_place;
use grazing_analysis::unfolded::AtResonance;
use grazing_description::Limits;
use grazing_measured::{NOT_FINISHED, Observation, compare, read};
use grazing_model::smooth::SmoothOscillator;
use grazing_results::place::AtPlace;
use grazing_unfold::progress::Progress;

use crate::arguments;
use crate::commands::CommandLine;
use crate::failure::Failure;
use crate::folder::{self, OutputFile, summary};
use crate::limits::{self, Watch, ended};
use crate::oscillator::{OscillatorFile, parameter_names, settings, with_loops};
use crate::outputs::edition::{Edition, Format};
use crate::outputs::latex;
use crate::outputs::oscillator::{self, AnalysedOscillator};
use crate::progress::Display;
use crate::{data_page, terminal};
use analysis::analyse;
use keeper::Keeper;
use page::PAGE;

/// The folder of the results, with a folder in it for each file.
const RESULTS: &str = "unfolded";

/// The work at the end of a run, in reports of progress.
pub(crate) const FIGURES: &str = "figures and tables";
const FILES: &str = "conversion of figures and tables";

/// A file that is to be unfolded.
struct Task {
    of: OscillatorFile,
    measured: Option<Vec<Observation>>,
    /// Places at which motion is simulated.
    at: Vec<[f64; 2]>,
    folder: PathBuf,
    limits: Limits,
}

/// Unfolds every file, one after the other, after checks that all are right and their folders writable.
///
/// # Errors
/// Bad input, before anything is computed; the failure of a single file, or how many of several failed.
pub(crate) fn run(arguments: &arguments::Unfold) -> Result<(), Failure> {
    let edition = arguments.look.edition();
    if arguments.data.is_some() && arguments.files.len() > 1 {
        return Err(Failure::input(
            "--data belongs to one oscillator: name one file, and run the command again for the next",
        ));
    }
    let tasks = tasks(arguments)?;
    for task in &tasks {
        let mut paths: Vec<PathBuf> =
            oscillator::ALL.iter().flat_map(|output| output.paths(&edition)).collect();
        paths.extend([
            PathBuf::from(PAGE),
            data_page::path(),
            PathBuf::from(folder::MANIFEST),
            keeper::path(),
        ]);
        folder::ensure_writable(&task.folder, &paths)?;
    }
    arguments.threads.start()?;
    limits::listen();
    let (mut failing, mut code) = (0, None);
    for (number, task) in tasks.iter().enumerate() {
        if number > 0 {
            terminal::say("\n");
        }
        if limits::is_interrupted() {
            terminal::note(&format!("{}: not started", task.of.file.display()));
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
        // The exit code of the first failure.
        Some(code) => {
            Err(Failure::new(code, format!("{failing} of {} files failed, see above", tasks.len())))
        }
        None => Ok(()),
    }
}

/// The files with what they describe, and the folders of their results, all of them different.
fn tasks(arguments: &arguments::Unfold) -> Result<Vec<Task>, Failure> {
    let mut tasks: Vec<Task> = Vec::new();
    for file in &arguments.files {
        let settings = settings(&arguments.changes.set);
        let mut of = OscillatorFile::read(file, &settings, arguments.limits.over(Limits::USUAL))?;
        of.description = with_loops(of.description, arguments.changes.loops.as_deref())?;
        let named = folder::name_for(file);
        let folder = match &arguments.output {
            Some(folder) if arguments.files.len() == 1 => folder.clone(),
            Some(folder) => folder.join(&named),
            None => Path::new(RESULTS).join(&named),
        };
        if let Some(other) = tasks.iter().find(|other| other.folder == folder) {
            return Err(Failure::input(format!(
                "the results of {} and {} would both go to {}: unfold one file at a time, with --output DIR",
                other.of.file.display(),
                file.display(),
                folder.display()
            )));
        }
        let limits = arguments.limits.over(of.description.limits());
        let names = parameter_names(&of.description);
        let renamed = arguments.named.of(arguments.data.as_deref())?;
        let measured = arguments.data.as_ref().map(|data| read::points(data, names, renamed)).transpose();
        let measured = measured.map_err(|error| Failure::input(error.to_string()))?;
        for &[mu, eta] in &arguments.at {
            let frequency = of.description.forcing_frequency(mu, eta);
            if !(frequency > 0.0 && frequency.is_finite()) {
                let problem = format!(
                    "--at {mu},{eta}: the forcing frequency is {frequency} there; it must be positive"
                );
                return Err(Failure::input(format!("{}: {problem}", file.display())));
            }
        }
        tasks.push(Task { of, measured, at: arguments.at.clone(), folder, limits });
    }
    Ok(tasks)
}

impl Task {
    /// Computes, writes and lists everything.
    fn run(&self, edition: &Edition, explain: bool) -> Result<(), Failure> {
        let start = Instant::now();
        let OscillatorFile { file, description, .. } = &self.of;
        let layout = terminal::layout();
        terminal::say(&listing::oscillator(layout, description, file));
        let keeper = Keeper::new(&self.folder);
        let of_analysis = Watch::begin(self.limits, self.of.taken);
        let motion = of_analysis.stop();
        // The time of the analysis is not available for the comparison.
        let watch = Watch::begin(self.limits, self.of.taken);
        let (unfolded, met) = analyse(&self.of, of_analysis, &|table| keeper.keep(table))?;
        let progress = Display::counting(watch.stop());
        let progress: &dyn Progress = &progress;
        let compared = self.measured.as_ref().map(|measured| {
            let other = unfolded.other.as_ref().map(|other| &other.diagram);
            let known = (&unfolded.diagram, other, &*unfolded.sequences.solutions);
            compare(measured, &unfolded.axes, known, progress, &watch.stop())
        });
        let mut unfinished = compared.iter().flat_map(|compared| &compared.points);
        let unfinished = unfinished.any(|point| point.reason == NOT_FINISHED);
        let (diagram, units) = (&unfolded.diagram, &unfolded.axes.units);
        let place = |(number, at): (u32, &[f64; 2])| {
            let found = at_place(&diagram.oscillator, &diagram.scope, units, (number, *at), progress)?;
            Some(AtPlace { from_the_wall: !description.wall().is_usual(), ..found })
        };
        let found: Vec<AtPlace> = (1..).zip(&self.at).map_while(place).collect();
        let unfinished = unfinished || found.len() < self.at.len();
        let met = met.or_else(|| watch.end_cause().filter(|_| unfinished));
        let analysed = AnalysedOscillator::new(file, description, unfolded).measured(compared).at(found);
        let ((files, left_out), unfolded) = (self.files(&analysed, edition, progress)?, &analysed.unfolded);
        let written = folder::write_run(&self.folder, &files, met.is_some() || !left_out.is_empty())?;
        keeper.clear()?;
        if met.is_none() {
            limits::note_excess(file, self.limits, watch.taken());
        }
        terminal::say(&listing::results(layout, description, unfolded));
        if let Some((other, seen)) = unfolded.other.as_deref().zip(description.from_each_wall().nth(1)) {
            let heading = "As the second wall sees it, without one-parameter diagrams; motion without impacts is the same";
            terminal::say(&format!("\n{}", layout.wrapped("", heading)));
            terminal::say(&listing::results(layout, &seen, other));
        }
        if let Some(compared) = &analysed.compared {
            terminal::say(&measured::listing(layout, compared));
        }
        let missing = &self.at[analysed.places.len()..];
        terminal::say(&places::listing(layout, &analysed.places, missing, &unfolded.axes.names));
        if explain {
            terminal::say(&explanation::all(layout, description, unfolded));
            terminal::say(&explanation::steps(layout, motion.by_purpose()));
        }
        terminal::say(&format!("\n{}", summary(&written)));
        terminal::say(&format!("{:.1} s\n", start.elapsed().as_secs_f64()));
        if let Some((page, _)) = written.iter().find(|(path, _)| path.ends_with(PAGE)) {
            terminal::say_next(&CommandLine::of(&["open"]).with(page));
        }
        if met.is_some() {
            let outcome = "the unfinished parts are named above; everything else is written";
            return Err(ended(file, met, outcome));
        }
        if !left_out.is_empty() {
            return Err(limits::no_room(file, self.limits, &left_out));
        }
        let missing = unfolded.from_each_wall().find_map(|unfolded| listing::incomplete(&unfolded.diagram));
        let all: Vec<AtResonance> =
            unfolded.from_each_wall().flat_map(|unfolded| unfolded.resonances.clone()).collect();
        verdict(file, &all, missing)
    }

    /// Figures, tables and the page that shows them; and the pictures for which there is no room.
    fn files(
        &self,
        of: &AnalysedOscillator,
        edition: &Edition,
        progress: &dyn Progress,
    ) -> Result<(Vec<OutputFile>, Vec<PathBuf>), Failure> {
        let computed = progress.during(FIGURES, 1, || of.computed(edition.columns))?;
        let room = |megabytes| limits::has_room(self.limits, megabytes);
        let made = progress.during(FILES, 1, || computed.files_within(edition, &room));
        let (mut files, floats, left_out) = made?;
        if edition.has(Format::Tex) {
            files.extend(latex::files(&floats, self.of.description.constants()));
        }
        let tables = of.outputs().flat_map(|output| output.tables).copied();
        files.push(data_page::of_an_oscillator(tables, &of.unfolded.axes.names));
        files.push(page::page(&self.of, &of.unfolded, &computed, &files));
        Ok((files, left_out))
    }
}

/// The failure in spite of which results are written: a contradiction of the theorem, or something missing.
fn verdict(file: &Path, resonances: &[AtResonance], missing: Option<String>) -> Result<(), Failure> {
    let (file, contradictions) = (file.display(), listing::contradictions(resonances));
    if !contradictions.is_empty() {
        let what = contradictions.join("; ");
        return Err(Failure::check(format!(
            "{file}: theorem and computation contradict each other: {what}; everything is written"
        )));
    }
    match missing {
        Some(missing) => {
            Err(Failure::incomplete(format!("{file}: {missing}, see above; everything else is written")))
        }
        None => Ok(()),
    }
}
