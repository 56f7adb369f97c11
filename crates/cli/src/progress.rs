//! The progress of computations on the error stream: bars on a terminal, plain lines otherwise.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use grazing_model::smooth::Stop;
use grazing_unfold::progress::Progress;
use indicatif::{MultiProgress, ProgressBar, ProgressStyle};

use crate::terminal;

/// The interval at which a bar moves without a step, so that a long step looks alive.
const HEARTBEAT: Duration = Duration::from_millis(200);
/// The interval of lines on long work, where there are no bars.
const SIGN_OF_LIFE: Duration = Duration::from_secs(10);
/// As wide as the terminal: the bar takes what the rest leaves.
const TEMPLATE: &str = "{spinner} {msg} [{wide_bar}] {pos}/{len} {elapsed}{prefix}";

/// Shows the steps of a computation.
#[derive(Default)]
pub(crate) struct Display {
    bars: Option<MultiProgress>,
    tasks: Arc<Mutex<Tasks>>,
    stop: Stop,
}

/// The running tasks, by name.
type Tasks = BTreeMap<String, Task>;

struct Task {
    began: Instant,
    bar: Option<ProgressBar>,
    done: u64,
    all: u64,
}

impl Display {
    /// A display with bars if the error stream is a terminal, with lines otherwise.
    pub(crate) fn new() -> Display {
        Display { bars: terminal::is_watched().then(MultiProgress::new), ..Display::default() }
    }

    /// The same with the number of steps of integration, which go on within the longest work. An
    /// analysis that reports to it ends when the mark is set.
    pub(crate) fn counting(stop: Stop) -> Display {
        let display = Display { stop: stop.clone(), ..Self::new() };
        let tasks = Arc::downgrade(&display.tasks);
        let pause = if display.bars.is_some() { HEARTBEAT } else { SIGN_OF_LIFE };
        let report = move || {
            // The thread ends with the display.
            while let Some(tasks) = tasks.upgrade() {
                locked(&tasks).iter().for_each(|(what, task)| task.report(what, &stop, pause));
                drop(tasks);
                thread::sleep(pause);
            }
        };
        // Without a thread there are fewer lines, but nothing else changes.
        let _ = thread::Builder::new().name("progress".to_owned()).spawn(report);
        display
    }
}

fn locked(tasks: &Mutex<Tasks>) -> MutexGuard<'_, Tasks> {
    tasks.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Task {
    /// Reports the progress of the task, as a line if it takes long.
    fn report(&self, what: &str, stop: &Stop, pause: Duration) {
        // A number with one digit after the point is easier to follow than all digits; closed forms have none.
        let steps = match stop.steps() {
            0 => String::new(),
            steps => format!(", {:.1e} integration steps", steps as f64),
        };
        match &self.bar {
            Some(bar) => bar.set_prefix(steps),
            None if self.began.elapsed() >= pause => {
                let (done, all, time) = (self.done, self.all, self.began.elapsed().as_secs());
                terminal::note(&format!("{what}: {done} of {all} after {time} s{steps}"));
            }
            None => {}
        }
    }
}

impl Progress for Display {
    fn begin(&self, what: &str, steps: u64) {
        let bar = self.bars.as_ref().map(|bars| {
            let style =
                ProgressStyle::with_template(TEMPLATE).unwrap_or_else(|_| ProgressStyle::default_bar());
            let bar = bars.add(ProgressBar::new(steps).with_style(style).with_message(what.to_owned()));
            bar.enable_steady_tick(HEARTBEAT);
            bar
        });
        if bar.is_none() {
            terminal::note(&format!("{what}: started"));
        }
        let task = Task { began: Instant::now(), bar, done: 0, all: steps };
        locked(&self.tasks).insert(what.to_owned(), task);
    }

    fn step(&self, what: &str) {
        if let Some(task) = locked(&self.tasks).get_mut(what) {
            task.done += 1;
            if let Some(bar) = &task.bar {
                bar.inc(1);
            }
        }
    }

    fn end(&self, what: &str) {
        let Some(task) = locked(&self.tasks).remove(what) else { return };
        match task.bar {
            Some(bar) => bar.finish_and_clear(),
            None => terminal::note(&format!("{what}: done in {:.2} s", task.began.elapsed().as_secs_f64())),
        }
    }

    fn stopped(&self) -> bool {
        self.stop.is_asked()
    }
}
