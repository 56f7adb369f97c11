//! How far the computation is: bars on a terminal, plain lines otherwise, on the error stream.

use std::collections::BTreeMap;
use std::io::{self, IsTerminal};
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use grazing_unfold::progress::Progress;
use grazing_unfold::stop::Stop;
use indicatif::{MultiProgress, ProgressBar, ProgressStyle};

use crate::terminal;

/// How often a bar moves though no step was made, so that a long step looks alive.
const HEARTBEAT: Duration = Duration::from_millis(200);
/// How often a line tells how far long work has come, where there are no bars.
const SIGN_OF_LIFE: Duration = Duration::from_secs(10);
const TEMPLATE: &str = "{spinner} {msg:32} [{bar:30}] {pos}/{len} {elapsed} {prefix}";

/// Shows the steps of a computation.
pub(crate) struct Display {
    bars: Option<MultiProgress>,
    running: Guard,
    stop: Stop,
}

/// Ends the telling when it goes.
#[derive(Default)]
struct Guard(Arc<Running>);

#[derive(Default)]
struct Running {
    tasks: Mutex<Tasks>,
    /// Nothing more is to be shown.
    over: Condvar,
}

#[derive(Default)]
struct Tasks {
    by_name: BTreeMap<String, Task>,
    over: bool,
}

struct Task {
    began: Instant,
    bar: Option<ProgressBar>,
    done: u64,
    all: u64,
}

impl Display {
    /// Bars if the error stream is a terminal, lines otherwise.
    pub(crate) fn new() -> Display {
        let bars = io::stderr().is_terminal().then(MultiProgress::new);
        Display { bars, running: Guard::default(), stop: Stop::default() }
    }

    /// The same, which tells also how many steps of integration were made: these go on within the longest work.
    /// An analysis that hears of it ends when the mark is set.
    pub(crate) fn counting(stop: Stop) -> Display {
        let display = Display { stop: stop.clone(), ..Self::new() };
        let running = display.running.0.clone();
        let pause = if display.bars.is_some() { HEARTBEAT } else { SIGN_OF_LIFE };
        // Without a thread there are only fewer lines.
        let _ = thread::Builder::new().name("progress".to_owned()).spawn(move || running.tell(&stop, pause));
        display
    }

    /// The mark by which the computation can be ended.
    pub(crate) fn stop(&self) -> &Stop {
        &self.stop
    }

    fn change<T>(&self, change: impl FnOnce(&mut BTreeMap<String, Task>) -> T) -> T {
        change(&mut self.running.0.tasks.lock().unwrap_or_else(PoisonError::into_inner).by_name)
    }
}

impl Drop for Guard {
    fn drop(&mut self) {
        self.0.tasks.lock().unwrap_or_else(PoisonError::into_inner).over = true;
        self.0.over.notify_all();
    }
}

impl Running {
    /// Tells of what runs, time after time until it is over.
    fn tell(&self, stop: &Stop, pause: Duration) {
        let mut tasks = self.tasks.lock().unwrap_or_else(PoisonError::into_inner);
        while !tasks.over {
            tasks = self.over.wait_timeout(tasks, pause).unwrap_or_else(PoisonError::into_inner).0;
            for (what, task) in &tasks.by_name {
                // A number with one digit after the point is easier to follow than all digits.
                let steps = format!("{:.1e} steps of integration", stop.steps() as f64);
                match &task.bar {
                    Some(bar) => bar.set_prefix(steps),
                    None if task.began.elapsed() >= pause && !tasks.over => {
                        let (done, all, time) = (task.done, task.all, task.began.elapsed().as_secs());
                        terminal::note(&format!("{what}: {done} of {all} after {time} s, {steps}"));
                    }
                    None => {}
                }
            }
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
            terminal::note(&format!("{what}: begun"));
        }
        let task = Task { began: Instant::now(), bar, done: 0, all: steps };
        self.change(|running| running.insert(what.to_owned(), task));
    }

    fn step(&self, what: &str) {
        self.change(|running| {
            if let Some(task) = running.get_mut(what) {
                task.done += 1;
                if let Some(bar) = &task.bar {
                    bar.inc(1);
                }
            }
        });
    }

    fn end(&self, what: &str) {
        let Some(task) = self.change(|running| running.remove(what)) else {
            return;
        };
        match task.bar {
            Some(bar) => bar.finish_and_clear(),
            None => terminal::note(&format!("{what}: done in {:.2} s", task.began.elapsed().as_secs_f64())),
        }
    }

    fn stopped(&self) -> bool {
        self.stop.is_asked()
    }
}
