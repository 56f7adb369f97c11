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

use grazing_input::AnalysisLimits;
use grazing_measured::{NOT_FINISHED, Observation, compare, read};
use grazing_model::smooth::{SmoothOscillator, Stop};
use grazing_results::place::AtPlace;
use grazing_unfold::described::Prepared;
use grazing_unfold::place::at_place;
use grazing_unfold::progress::Progress;
use grazing_unfold::unfolded::{AtResonance, Keep};

use crate::arguments;
use crate::failure::Failure;
use crate::folder::{self, Batch, OutputFile};
use crate::layout::Layout;
use crate::limits::{self, EndCause, ended};
use crate::oscillator::{OscillatorFile, setup};
use crate::outputs::accompanying;
use crate::outputs::edition::Edition;
use crate::outputs::oscillator::{self, AnalysedOscillator};
use crate::runner::{CommandOutcome, Next, Plan, Running};
use crate::{data_page, terminal};
use analysis::analyse;
use keeper::Keeper;
use page::PAGE;

/// The folder of the results, with a folder in it for each file.
const RESULTS: &str = "unfolded";

/// The work at the end of a run, in reports of progress.
pub(crate) const FIGURES: &str = "figures and tables";
const FILES: &str = "conversion of figures and tables";

/// An oscillator that is to be unfolded.
pub(crate) struct UnfoldTask {
    pub(crate) of: OscillatorFile,
    pub(crate) measured: Option<Vec<Observation>>,
    /// Places at which motion is simulated.
    pub(crate) at: Vec<[f64; 2]>,
}

/// An oscillator that was unfolded.
pub(crate) struct UnfoldResults {
    pub(crate) analysed: AnalysedOscillator,
    /// The cause that ended the computation, if anything is missing.
    pub(crate) met: Option<EndCause>,
    /// The places at which motion was not finished.
    missing: Vec<[f64; 2]>,
    /// The mark of the analysis, which has counted its steps.
    motion: Stop,
}

/// Reads every file that is to be unfolded, one after the other.
///
/// # Errors
/// Bad input.
pub(crate) fn read(arguments: &arguments::UnfoldArguments) -> Result<Vec<Plan<'_>>, Failure> {
    if arguments.data.is_some() && arguments.files.len() > 1 {
        return Err(Failure::input(
            "--data belongs to one oscillator: name one file, and run the command again for the next",
        ));
    }
    Ok(tasks(arguments)?.into_iter().map(|(task, folder)| plan(task, folder, arguments)).collect())
}

fn plan(task: UnfoldTask, folder: PathBuf, arguments: &arguments::UnfoldArguments) -> Plan<'_> {
    let edition = arguments.look.edition();
    let paths = oscillator::ALL.iter().flat_map(|output| output.paths(&edition));
    let paths: Vec<PathBuf> = paths.chain([PathBuf::from(PAGE)]).chain(keeper::paths()).collect();
    let OscillatorFile { file, description, taken, .. } = &task.of;
    let (file, heading) = (file.clone(), listing::oscillator(terminal::layout(), description, file));
    let of = (file.clone(), description.clone());
    let limits = (arguments.limits.over(description.limits()), *taken);
    let to = folder.clone();
    let compute = move |running: &Running<'_>| {
        let keeper = Keeper::new(&to, (&of.0, of.1), edition.columns, keeper::PAUSE);
        let prepare = |of: &OscillatorFile, stop: &Stop| Ok(of.prepared(stop));
        let diagram = unfold(task, &prepare, running, &|draft| keeper.keep(draft))?;
        let (files, left_out) = diagram.files(&edition, running)?;
        let failure = if diagram.met.is_some() {
            let outcome = "the unfinished parts are named above; everything else is written";
            Some(ended(&diagram.analysed.oscillator.file, diagram.met, outcome))
        } else if left_out.is_empty() {
            diagram.verdict().err()
        } else {
            Some(limits::no_room(&diagram.analysed.oscillator.file, running.limits(), &left_out))
        };
        let incomplete = diagram.met.is_some() || !left_out.is_empty();
        Ok((diagram, files, incomplete, failure))
    };
    let say = |(diagram, files, incomplete, failure): (UnfoldResults, _, _, _), folder: &Path| {
        let layout = terminal::layout();
        let mut text = diagram.listing(layout);
        if arguments.explain {
            let AnalysedOscillator { oscillator, unfolded, .. } = &diagram.analysed;
            text.push_str(&explanation::all(layout, &oscillator.description, unfolded));
            text.push_str(&explanation::steps(layout, diagram.motion.by_purpose()));
        }
        Ok(CommandOutcome {
            text,
            batches: vec![Batch { incomplete, ..Batch::run(folder, files) }],
            obsolete: keeper::paths().map(|path| folder.join(path)).into(),
            next: Next::Look,
            failure,
            ..CommandOutcome::default()
        })
    };
    Plan::new(compute, say).within(&file, limits).headed(heading).writing_run(folder, paths)
}

/// The files with what they describe, and the folders of their results, all of them different.
fn tasks(arguments: &arguments::UnfoldArguments) -> Result<Vec<(UnfoldTask, PathBuf)>, Failure> {
    let mut tasks: Vec<(UnfoldTask, PathBuf)> = Vec::new();
    for file in &arguments.files {
        let (changes, limits) = (&arguments.changes, arguments.limits.over(AnalysisLimits::USUAL));
        let of = OscillatorFile::read(file, &changes.set, limits)?;
        let of = of.looped(changes.loops.as_deref())?;
        let named = folder::name_for(file);
        let folder = match &arguments.output {
            Some(folder) if arguments.files.len() == 1 => folder.clone(),
            Some(folder) => folder.join(&named),
            None => Path::new(RESULTS).join(&named),
        };
        if let Some((other, _)) = tasks.iter().find(|(_, other)| *other == folder) {
            return Err(Failure::input(format!(
                "the results of {} and {} would both go to {}: unfold one file at a time, with --output DIR",
                other.of.file.display(),
                file.display(),
                folder.display()
            )));
        }
        let renamed = arguments.named.of(arguments.data.as_deref())?;
        let measured = arguments.data.as_ref();
        let measured =
            measured.map(|data| read::points(data, setup(&of.description), renamed)).transpose()?;
        for &[mu, eta] in &arguments.at {
            let frequency = of.description.forcing_frequency(mu, eta);
            if !(frequency > 0.0 && frequency.is_finite()) {
                let problem = format!(
                    "--at {mu},{eta}: the forcing frequency is {frequency} there; it must be positive"
                );
                return Err(Failure::input(format!("{}: {problem}", file.display())));
            }
        }
        tasks.push((UnfoldTask { of, measured, at: arguments.at.clone() }, folder));
    }
    Ok(tasks)
}

/// Unfolds an oscillator, compares measurements with its diagram, and follows motion at places; `prepare` makes it ready for an
/// analysis that a mark cancels.
///
/// # Errors
/// There is nothing to unfold.
pub(crate) fn unfold(
    task: UnfoldTask,
    prepare: &dyn Fn(&OscillatorFile, &Stop) -> Result<Prepared, Failure>,
    running: &Running<'_>,
    keep: Keep<'_>,
) -> Result<UnfoldResults, Failure> {
    let UnfoldTask { of, measured, at, .. } = task;
    // The mark of the analysis is not set by what comes after it, so that its oscillator still moves.
    let analysis = running.another(None);
    let motion = analysis.stop();
    let (unfolded, met) = analyse(&of, prepare(&of, &motion)?, &analysis, keep)?;
    drop(analysis);
    let progress: &dyn Progress = &**running.progress();
    let compared = measured
        .map(|measured| compare(&measured, &unfolded.axes, unfolded.known(), progress, &running.stop()));
    let mut unfinished = compared.iter().flat_map(|compared| &compared.points);
    let unfinished = unfinished.any(|point| point.reason == NOT_FINISHED);
    let (diagram, units) = (&unfolded.diagram, &unfolded.axes.units);
    let place = |(number, at): (u32, &[f64; 2])| {
        let found = at_place(&diagram.oscillator, &diagram.scope, units, (number, *at), progress)?;
        Some(AtPlace { from_the_wall: !of.description.wall().is_usual(), ..found })
    };
    let places: Vec<AtPlace> = (1..).zip(&at).map_while(place).collect();
    let missing = at[places.len()..].to_vec();
    let met = met.or_else(|| running.end_cause().filter(|_| unfinished || !missing.is_empty()));
    let analysed = AnalysedOscillator::new(of, unfolded).measured(compared).at(places);
    Ok(UnfoldResults { analysed, met, missing, motion })
}

impl UnfoldResults {
    /// All that was found, as lines.
    pub(crate) fn listing(&self, layout: Layout) -> String {
        let Self { analysed, missing, .. } = self;
        let (description, unfolded) = (&analysed.oscillator.description, &analysed.unfolded);
        let mut text = listing::results(layout, description, unfolded);
        if let Some((other, seen)) = unfolded.other.as_deref().zip(description.from_each_wall().nth(1)) {
            let heading = "As the second wall sees it, without one-parameter diagrams; motion without impacts is the same";
            text.push_str(&format!("\n{}", layout.wrapped("", heading)));
            text.push_str(&listing::results(layout, &seen, other));
        }
        text.extend(analysed.compared.iter().map(|compared| measured::listing(layout, compared)));
        text + &places::listing(layout, &analysed.places, missing, &unfolded.axes.names)
    }

    /// Figures, tables and the page that shows them; and the pictures for which there is no room.
    fn files(
        &self,
        edition: &Edition,
        running: &Running<'_>,
    ) -> Result<(Vec<OutputFile>, Vec<PathBuf>), Failure> {
        let (of, progress): (_, &dyn Progress) = (&self.analysed, &**running.progress());
        let computed = progress.during(FIGURES, 1, || of.computed(edition.columns))?;
        let room = |megabytes| limits::has_room(running.limits(), megabytes);
        let made = progress.during(FILES, 1, || computed.files_within(edition, &room));
        let (mut files, floats, left_out) = made?;
        let tables = of.outputs().flat_map(|output| output.tables).copied();
        let about = data_page::of_an_oscillator(tables, &of.unfolded.axes.names);
        files.extend(accompanying(edition, &floats, of.oscillator.description.constants(), about));
        files.push(page::page(of, &computed, &files));
        Ok((files, left_out))
    }

    /// A contradiction of the theorem, or something missing.
    fn verdict(&self) -> Result<(), Failure> {
        let unfolded = &self.analysed.unfolded;
        let missing = unfolded.from_each_wall().find_map(|seen| listing::incomplete(&seen.diagram));
        let resonances = unfolded.from_each_wall().flat_map(|seen| seen.resonances.clone());
        verdict(&self.analysed.oscillator.file, &resonances.collect::<Vec<_>>(), missing)
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
