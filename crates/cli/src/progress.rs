//! How far the computation is: bars on a terminal, plain lines otherwise, on the error stream.

use std::collections::BTreeMap;
use std::io::{self, IsTerminal};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use grazing_unfold::progress::Progress;
use indicatif::{MultiProgress, ProgressBar, ProgressStyle};

use crate::terminal;

/// How often a bar moves though no step was made, so that a long step looks alive.
const HEARTBEAT: Duration = Duration::from_millis(200);
const TEMPLATE: &str = "{spinner} {msg:32} [{bar:30}] {pos}/{len} {elapsed}";

/// Shows the steps of a computation.
pub(crate) struct Display {
    bars: Option<MultiProgress>,
    running: Mutex<BTreeMap<String, Task>>,
}

struct Task {
    began: Instant,
    bar: Option<ProgressBar>,
}

impl Display {
    /// Bars if the error stream is a terminal, lines otherwise.
    pub(crate) fn new() -> Display {
        let bars = io::stderr().is_terminal().then(MultiProgress::new);
        Display { bars, running: Mutex::new(BTreeMap::new()) }
    }

    fn change<T>(&self, change: impl FnOnce(&mut BTreeMap<String, Task>) -> T) -> T {
        change(&mut self.running.lock().unwrap_or_else(PoisonError::into_inner))
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
        self.change(|running| running.insert(what.to_owned(), Task { began: Instant::now(), bar }));
    }

    fn step(&self, what: &str) {
        self.change(|running| {
            if let Some(bar) = running.get(what).and_then(|task| task.bar.as_ref()) {
                bar.inc(1);
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
}
