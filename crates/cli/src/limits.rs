//! Limits of an analysis: time, memory, steps, and whoever interrupts it.
//!
//! A thread of its own looks at the CPU time that the process has taken and at the memory that it
//! holds, and asks the computation to end ([`Stop`]) when either is used up or Ctrl-C was pressed,
//! or anything that `signals` takes for it. What is finished is written then. A second Ctrl-C ends
//! the program at once.
//!
//! It is CPU time that counts, of all threads together, so that a busy machine finishes what an
//! idle one does. Where the system has no clock of it, the clock on the wall has to do.

use std::fs;
use std::io;
use std::path::Path;
use std::process;
use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::{Arc, OnceLock};
use std::thread;
use std::time::Duration;

use grazing_description::Limits;
use grazing_model::smooth::Stop;

use crate::failure::Failure;
use crate::{folder, signals, terminal};

/// How often clock and memory are looked at: memory can grow by some ten megabytes in between.
const PAUSE: Duration = Duration::from_millis(20);

/// How often Ctrl-C was pressed.
static INTERRUPTIONS: AtomicU32 = AtomicU32::new(0);

/// The exit code of a computation that was ended.
const ENDED: i32 = 3;

/// What ended an analysis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum EndCause {
    /// The time is used up, in seconds.
    Time(f64),
    /// The process holds more than so many megabytes.
    Memory(f64),
    /// So many steps of integration were made.
    Steps(f64),
    /// Ctrl-C was pressed.
    Interruption,
}

impl std::fmt::Display for EndCause {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let (limit, key) = match self {
            EndCause::Time(seconds) => (format!("time limit of {seconds} s {CLOCK}"), "time"),
            EndCause::Memory(megabytes) => (format!("memory limit of {megabytes} MB"), "memory"),
            EndCause::Steps(steps) => (format!("limit of {steps} steps of integration"), "step"),
            EndCause::Interruption => return formatter.write_str("interrupted"),
        };
        let remedy = format!("raise it by {key}_limit in [analysis] or --{key}-limit");
        write!(formatter, "the {limit} was reached ({remedy})")
    }
}

/// Lets the first Ctrl-C end analyses with what they have, and the second one the program.
pub(crate) fn listen() {
    signals::handle(|| {
        if INTERRUPTIONS.fetch_add(1, Ordering::Relaxed) > 0 {
            leave("error: interrupted twice: ended at once, nothing more is written");
        }
        terminal::note("interrupted: writing what is finished; press Ctrl-C again to end at once");
    });
}

/// Lets Ctrl-C be seen by whoever asks [`is_interrupted`], and a second one end the program.
pub(crate) fn end_when_interrupted() {
    signals::handle(|| {
        if INTERRUPTIONS.fetch_add(1, Ordering::Relaxed) > 0 {
            leave("interrupted twice");
        }
    });
}

/// Lets Ctrl-C end the program at once, without leaving unfinished files behind.
pub(crate) fn leave_nothing_behind() {
    signals::handle(|| {
        leave("error: interrupted: what was not written yet is not written");
    });
}

/// Ends the program with last words, without leaving unfinished files behind.
fn leave(words: &str) -> ! {
    folder::remove_own_temporaries();
    // Other threads that report their progress wait for this, and so say nothing more.
    let _silence = io::stderr().lock();
    terminal::note(words);
    process::exit(ENDED)
}

/// Whether Ctrl-C was pressed.
pub(crate) fn is_interrupted() -> bool {
    INTERRUPTIONS.load(Ordering::Relaxed) > 0
}

/// The CPU time that the process has taken.
#[cfg(unix)]
fn clock() -> Duration {
    let time = rustix::time::clock_gettime(rustix::time::ClockId::ProcessCPUTime);
    Duration::new(time.tv_sec.cast_unsigned(), u32::try_from(time.tv_nsec).unwrap_or_default())
}

/// What is counted, in messages.
const CLOCK: &str =
    if cfg!(unix) { "of CPU time" } else { "by the clock, as this system has none of CPU time," };

/// The time since this was asked for first, where the system has no clock of CPU time.
#[cfg(not(unix))]
fn clock() -> Duration {
    static FIRST: OnceLock<std::time::Instant> = OnceLock::new();
    FIRST.get_or_init(std::time::Instant::now).elapsed()
}

/// Watches over one analysis, or over the reading of its file, as long as it lives.
pub(crate) struct Watch(Arc<Watched>);

/// What the thread looks at.
struct Watched {
    stop: Stop,
    limits: Limits,
    began: Duration,
    /// What was taken before.
    taken: Duration,
    met: OnceLock<EndCause>,
}

impl Watch {
    /// Begins to watch over something for which so much time has been taken before.
    pub(crate) fn begin(limits: Limits, taken: Duration) -> Self {
        // A count of steps is a whole number, and one beyond all counts is none.
        let stop = Stop::after(limits.steps as u64);
        let watched = Arc::new(Watched { stop, limits, began: clock(), taken, met: OnceLock::new() });
        let weak = Arc::downgrade(&watched);
        let look = move || {
            // It ends with the watch.
            while let Some(watched) = weak.upgrade() {
                if let Some(met) = watched.look() {
                    watched.met.get_or_init(|| met);
                    return watched.stop.ask();
                }
                drop(watched);
                thread::sleep(PAUSE);
            }
        };
        // Without a thread there are no limits but that of the steps.
        let _ = thread::Builder::new().name("limits".to_owned()).spawn(look);
        Self(watched)
    }

    /// The mark that is set when a limit is met.
    pub(crate) fn stop(&self) -> Stop {
        self.0.stop.clone()
    }

    /// The time that has been taken.
    pub(crate) fn taken(&self) -> Duration {
        self.0.taken()
    }

    /// What has ended the analysis, if something has.
    pub(crate) fn end_cause(&self) -> Option<EndCause> {
        let Watched { stop, limits, met, .. } = &*self.0;
        met.get().copied().or_else(|| stop.is_used_up().then_some(EndCause::Steps(limits.steps)))
    }
}

impl Watched {
    fn taken(&self) -> Duration {
        clock().saturating_sub(self.began) + self.taken
    }

    fn look(&self) -> Option<EndCause> {
        let Limits { time, memory, .. } = self.limits;
        if is_interrupted() {
            Some(EndCause::Interruption)
        } else if self.taken().as_secs_f64() > time {
            Some(EndCause::Time(time))
        } else if holds_more_than(memory) {
            Some(EndCause::Memory(memory))
        } else {
            None
        }
    }
}

/// Reads a file within limits, which it may say more exactly itself; and the time that this has
/// taken. Steps of integration are not counted yet.
///
/// # Errors
/// The file is not right, or a limit was reached.
pub(crate) fn reading<T>(
    file: &Path,
    limits: Limits,
    read: impl FnOnce(&Stop) -> Result<T, Failure>,
) -> Result<(T, Duration), Failure> {
    let watch = Watch::begin(Limits { steps: f64::INFINITY, ..limits }, Duration::ZERO);
    match read(&watch.stop()) {
        Ok(read) => Ok((read, watch.taken())),
        Err(failure) => Err(match watch.end_cause() {
            Some(cause) => ended(file, Some(cause), "nothing is written, for the file was still being read"),
            None => failure,
        }),
    }
}

/// The failure of an analysis that was ended, by a limit or by Ctrl-C if that is known.
pub(crate) fn ended(file: &Path, met: Option<EndCause>, outcome: &str) -> Failure {
    let cause = met.map_or(String::new(), |met| format!("{met}; "));
    Failure::incomplete(format!("{}: {cause}{outcome}", file.display()))
}

/// Whether the process holds more than so many megabytes; not where the system does not say.
pub(crate) fn holds_more_than(megabytes: f64) -> bool {
    held().is_some_and(|held| held > megabytes)
}

/// The memory that the process holds, in megabytes, where the system reports it as Linux does.
fn held() -> Option<f64> {
    let kilobytes: f64 = status("VmRSS:")?.parse().ok()?;
    Some(kilobytes / 1000.0)
}

/// What the system says of this process under a name, where it does so as Linux does.
pub(crate) fn status(name: &str) -> Option<String> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix(name))?;
    line.split_whitespace().next().map(str::to_owned)
}

#[cfg(test)]
mod tests {
    use super::*;

    const AMPLE: Limits = Limits { time: 1e6, memory: 1e9, steps: 1e18 };

    /// What is met, and the time that was taken for it.
    #[track_caller]
    fn met(limits: Limits) -> (EndCause, f64) {
        let watch = Watch::begin(limits, Duration::ZERO);
        // Only what computes takes time.
        while !watch.stop().is_asked() {
            assert!(watch.taken() < Duration::from_secs(600), "nothing is met");
        }
        (watch.end_cause().expect("what is met is known before the mark is set"), watch.taken().as_secs_f64())
    }

    #[test]
    fn time_and_memory_end_an_analysis_and_are_named() {
        let (cause, taken) = met(Limits { time: 0.05, ..AMPLE });
        assert!(cause == EndCause::Time(0.05) && taken > 0.05, "{cause:?} {taken}");
        assert!(cause.to_string().contains("0.05 s of CPU time") || cfg!(not(unix)), "{cause}");
        if held().is_some() {
            assert_eq!(met(Limits { memory: 0.1, ..AMPLE }).0, EndCause::Memory(0.1));
        }
    }

    #[test]
    fn time_that_was_taken_before_counts() {
        let watch = Watch::begin(Limits { time: 100.0, ..AMPLE }, Duration::from_secs(101));
        while !watch.stop().is_asked() {
            thread::sleep(PAUSE);
        }
        assert_eq!(watch.end_cause(), Some(EndCause::Time(100.0)));
    }

    #[test]
    fn within_all_limits_nothing_ends() {
        let watch = Watch::begin(AMPLE, Duration::ZERO);
        thread::sleep(5 * PAUSE);
        assert_eq!(watch.end_cause(), None);
        assert!(!watch.stop().is_asked());
    }
}
