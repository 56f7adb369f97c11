//! The run of a command: it reads, computes and says, and everything that runs have in common stands here, once: signals, folders that
//! can be written, threads, limits, progress, files and their summary, the seconds, the next command and the exit code.
//!
//! To add a command, declare its arguments ([`crate::arguments`]), write a function that reads and checks all that is asked for and
//! returns a [`Plan`] of what computes and what says, and add a line to [`crate::run`].

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};

use grazing_input::AnalysisLimits;
use grazing_model::smooth::Stop;
use grazing_unfold::progress::Progress;

use crate::commands::CommandLine;
use crate::failure::{Failure, INCOMPLETE};
use crate::folder::{self, Batch, Change, Differences, OutputFile, counted, summary};
use crate::limits::{self, EndCause, Watch, ended};
use crate::progress::Display;
use crate::{data_page, tables, terminal, visual};

/// A task that was read and checked, before anything is computed.
pub(crate) struct Plan<'a> {
    work: Work<'a>,
    /// The file that the task is about, for messages.
    file: PathBuf,
    /// A text to begin with.
    heading: String,
    /// The folder of the results, and the paths of files in it that must be writable.
    folder: PathBuf,
    paths: Option<Vec<PathBuf>>,
    limits: Option<Spent>,
    /// Whether Ctrl-C makes the computation end with what is finished, instead of the program at once.
    finishes: bool,
}

/// Computes results and presents them, for a folder.
type Work<'a> = Box<dyn FnOnce(&Running<'_>, &Path) -> Result<CommandOutcome, Failure> + 'a>;

/// Limits, and the time of which reading has taken from them.
pub(crate) type Spent = (AnalysisLimits, Duration);

impl<'a> Plan<'a> {
    /// A task that `compute` does and of which `say` presents the results, for the folder in which they are to be written. It has no
    /// limits, and writes no files.
    pub(crate) fn new<R>(
        compute: impl FnOnce(&Running<'_>) -> Result<R, Failure> + 'a,
        say: impl FnOnce(R, &Path) -> Result<CommandOutcome, Failure> + 'a,
    ) -> Self {
        let work = |running: &Running<'_>, folder: &Path| say(compute(running)?, folder);
        Self {
            work: Box::new(work),
            file: PathBuf::new(),
            heading: String::new(),
            folder: PathBuf::new(),
            paths: None,
            limits: None,
            finishes: false,
        }
    }

    /// The plan for a file, with limits, at which as at Ctrl-C the computation ends with what is finished.
    pub(crate) fn within(self, file: &Path, limits: Spent) -> Self {
        Self { file: file.to_owned(), limits: Some(limits), finishes: true, ..self }
    }

    /// The plan with a computation that Ctrl-C ends with what is finished.
    pub(crate) fn finishing(self) -> Self {
        Self { finishes: true, ..self }
    }

    /// The plan with a text to begin with.
    pub(crate) fn headed(self, heading: String) -> Self {
        Self { heading, ..self }
    }

    /// The plan with a folder for results, and files that must be writable there.
    pub(crate) fn writing(self, folder: PathBuf, paths: impl IntoIterator<Item = PathBuf>) -> Self {
        Self { folder, paths: Some(paths.into_iter().collect()), ..self }
    }

    /// The same for the files of a run, with the page about its tables and the list of all.
    pub(crate) fn writing_run(self, folder: PathBuf, paths: impl IntoIterator<Item = PathBuf>) -> Self {
        self.writing(folder, paths.into_iter().chain([data_page::path(), folder::MANIFEST.into()]))
    }

    /// The plan with files that are only to be compared, if this is so.
    pub(crate) fn checking(self, check: bool) -> Self {
        Self { paths: self.paths.filter(|_| !check), ..self }
    }
}

/// Receives the mark that cancels the computation that begins, and returns the receiver of its progress.
pub type StartProgress<'a> = &'a dyn Fn(Stop) -> Box<dyn Progress + Send>;

/// A computation under way: its limits, and the receiver of its progress.
pub(crate) struct Running<'a> {
    limits: Option<Spent>,
    report: StartProgress<'a>,
    watch: Option<Watch>,
    progress: Arc<dyn Progress + Send>,
}

impl<'a> Running<'a> {
    /// Begins a computation within limits, or without.
    pub(crate) fn begin(limits: Option<Spent>, report: StartProgress<'a>) -> Self {
        let watch = limits.map(|(limits, taken)| Watch::begin(limits, taken));
        let progress = Arc::from(report(watch.as_ref().map_or(Stop::default(), Watch::stop)));
        Self { limits, report, watch, progress }
    }

    /// Another computation, within the same limits or within its own; what comes after it does not set its mark.
    pub(crate) fn another(&self, limits: Option<Spent>) -> Self {
        Self::begin(limits.or(self.limits), self.report)
    }

    /// The mark that is set when a limit is reached.
    pub(crate) fn stop(&self) -> Stop {
        self.watch.as_ref().map_or(Stop::default(), Watch::stop)
    }

    pub(crate) fn progress(&self) -> &Arc<dyn Progress + Send> {
        &self.progress
    }

    /// The limits, if there are any.
    pub(crate) fn limits(&self) -> Option<AnalysisLimits> {
        self.limits.map(|(limits, _)| limits)
    }

    /// The cause that has ended the computation, if it was ended.
    pub(crate) fn end_cause(&self) -> Option<EndCause> {
        self.watch.as_ref().and_then(Watch::end_cause)
    }

    /// The failure of a computation without results: because it was ended, or for another reason.
    pub(crate) fn failure(&self, file: &Path, outcome: &str, otherwise: impl FnOnce() -> Failure) -> Failure {
        self.end_cause().map_or_else(otherwise, |cause| ended(file, Some(cause), outcome))
    }
}

/// Text and files in which a command ends.
#[derive(Default)]
pub(crate) struct CommandOutcome {
    /// Results that are laid out and may have colours.
    pub(crate) coloured: String,
    /// Results.
    pub(crate) text: String,
    /// Files with their folders.
    pub(crate) batches: Vec<Batch>,
    /// Files of the computation under way, which are deleted once everything is written.
    pub(crate) obsolete: Vec<PathBuf>,
    /// The command that writes the files, if they are only to be compared.
    pub(crate) check: Option<CommandLine>,
    /// Whether figures that change are drawn before and after.
    pub(crate) pictures: bool,
    /// Text after the summary of the files.
    pub(crate) remark: String,
    pub(crate) next: Next,
    /// Messages before the failure.
    pub(crate) notes: Vec<String>,
    /// The failure in spite of which there are results.
    pub(crate) failure: Option<Failure>,
}

/// The next command to type.
#[derive(Default)]
pub(crate) enum Next {
    #[default]
    Nothing,
    /// A look at the page or the first figure or table that was written.
    Look,
    /// A command, after something else to do.
    Command(String, CommandLine),
}

impl From<CommandLine> for Next {
    fn from(command: CommandLine) -> Self {
        Self::Command(String::new(), command)
    }
}

/// Runs a command that reads a task, with a number of threads.
///
/// # Errors
/// Bad input, before anything is computed; or the failure of the task.
pub(crate) fn run<'a>(
    read: impl FnOnce() -> Result<Plan<'a>, Failure>,
    jobs: Option<u16>,
) -> Result<(), Failure> {
    run_each(|| Ok(vec![read()?]), jobs)
}

/// Runs a command that reads several tasks, one after the other, with a number of threads.
///
/// # Errors
/// Bad input, before anything is computed; the failure of a single task, or how many of several failed.
pub(crate) fn run_each<'a>(
    read: impl FnOnce() -> Result<Vec<Plan<'a>>, Failure>,
    jobs: Option<u16>,
) -> Result<(), Failure> {
    let mut began = Instant::now();
    limits::listen();
    let plans = read()?;
    for Plan { folder, paths, .. } in &plans {
        paths.iter().try_for_each(|paths| folder::ensure_writable(folder, paths))?;
    }
    start_threads(jobs)?;
    let (all, mut failing, mut code) = (plans.len(), 0, None);
    for (number, plan) in plans.into_iter().enumerate() {
        if number > 0 {
            terminal::say("\n");
            began = Instant::now();
        }
        if limits::is_interrupted() {
            terminal::note(&format!("{}: not started", plan.file.display()));
            failing += 1;
            code.get_or_insert(INCOMPLETE);
            continue;
        }
        match plan.run(began) {
            Err(failure) if all == 1 => return Err(failure),
            Err(failure) => {
                terminal::report(&failure);
                failing += 1;
                code.get_or_insert(failure.exit_code());
            }
            Ok(()) => {}
        }
    }
    // The exit code of the first failure.
    let failure = |code| Failure::new(code, format!("{failing} of {all} files failed, see above"));
    code.map_or(Ok(()), |code| Err(failure(code)))
}

/// Sets the number of threads.
fn start_threads(jobs: Option<u16>) -> Result<(), Failure> {
    let Some(jobs) = jobs else { return Ok(()) };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(usize::from(jobs));
    // What the system refuses may be refused because of its limits, and not because of the number.
    pool.build_global().map_err(|error| {
        Failure::incomplete(format!(
            "--jobs {jobs}: the threads could not be started: {error} (choose fewer, or raise what the system allows: ulimit -v, ulimit -u)"
        ))
    })
}

impl Plan<'_> {
    /// Does the task, and writes and says its results.
    fn run(self, began: Instant) -> Result<(), Failure> {
        terminal::say(&self.heading);
        tables::start_threads();
        limits::finish_when_interrupted(self.finishes);
        let running = Running::begin(self.limits, &|stop| Box::new(Display::counting(stop)));
        let outcome = (self.work)(&running, &self.folder)?;
        let changes = if outcome.check.is_some() { Vec::new() } else { outcome.write()? };
        let whole = outcome.batches.iter().all(|batch| !batch.incomplete);
        if let Some((watch, limits)) = running.watch.as_ref().zip(running.limits()).filter(|_| whole) {
            limits::note_excess(&self.file, limits, watch.taken());
        }
        drop(running);
        outcome.say(&changes, began)
    }
}

impl CommandOutcome {
    /// The outcome of files alone, which no list names.
    ///
    /// # Errors
    /// None.
    pub(crate) fn unlisted(files: Vec<OutputFile>, folder: &Path) -> Result<Self, Failure> {
        Ok(Self { batches: vec![Batch::unlisted(folder, files)], ..Self::default() })
    }

    /// Writes all files.
    fn write(&self) -> Result<Vec<(String, Change)>, Failure> {
        let mut changes = Vec::new();
        for batch in &self.batches {
            let place = batch.place();
            let changed = if self.pictures { visual::changed(&place, &batch.files) } else { Vec::new() };
            changes.extend(batch.write()?);
            visual::show(&place, &changed);
        }
        self.obsolete.iter().try_for_each(|path| folder::remove(path))?;
        Ok(changes)
    }

    /// Says everything, with the changes of the files that were written, and ends with the failure if there is one.
    fn say(self, changes: &[(String, Change)], began: Instant) -> Result<(), Failure> {
        terminal::say_coloured(&self.coloured);
        terminal::say(&self.text);
        let compared = self.check.as_ref().map(|mend| self.compare(mend)).transpose();
        if compared.is_ok() && !self.batches.is_empty() {
            let files = match compared {
                Ok(Some(files)) => {
                    format!("{} checked: all are what the code produces.\n", counted(files))
                }
                _ => summary(changes),
            };
            let blank = if self.coloured.is_empty() && self.text.is_empty() { "" } else { "\n" };
            let seconds = began.elapsed().as_secs_f64();
            terminal::say(&format!("{blank}{files}{}{seconds:.1} s\n", self.remark));
            match &self.next {
                _ if self.check.is_some() => {}
                Next::Nothing => {}
                Next::Look => {
                    terminal::say_next("", &CommandLine::of(&["open"]).with(folder::first(changes)));
                }
                Next::Command(first, command) => terminal::say_next(first, command),
            }
        }
        self.notes.iter().for_each(|note| terminal::note(note));
        self.failure.map_or(compared.map(drop), Err)
    }

    /// Compares the files with those in their folders, and returns their number; `mend` is the command that writes them.
    fn compare(&self, mend: &CommandLine) -> Result<usize, Failure> {
        let mut found = Differences::default();
        self.batches.iter().try_for_each(|batch| batch.compare(&mut found))?;
        let Differences { differing, unexpected } = found;
        if differing.is_empty() && unexpected.is_empty() {
            return Ok(self.batches.iter().map(|batch| batch.files.len()).sum());
        }
        differing.iter().chain(&unexpected).for_each(|difference| terminal::note(difference));
        for batch in self.batches.iter().filter(|_| self.pictures) {
            visual::show(&batch.place(), &visual::changed(&batch.place(), &batch.files));
        }
        let update = format!("update {} with `{mend}`", counted(differing.len()));
        let remove = format!("remove {} that it does not produce", counted(unexpected.len()));
        let remedies = [(differing, update), (unexpected, remove)].into_iter();
        let remedies = remedies.filter(|(files, _)| !files.is_empty()).map(|(_, remedy)| remedy);
        let (place, remedies) = (self.batches[0].place(), remedies.collect::<Vec<_>>().join(", "));
        Err(Failure::check(format!("{} is not what the code produces: {remedies}", place.display())))
    }
}
