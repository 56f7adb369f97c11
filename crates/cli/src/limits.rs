//! Limits of an analysis: time, memory, steps, and interruption.
//!
//! A separate thread watches the CPU time that the process has taken and the memory that it holds,
//! and cancels the computation ([`Stop`]) when either is used up, when the address space that the system
//! allows (`ulimit -v`) is nearly used up, or when Ctrl-C or another signal of `signals` arrives. Finished
//! results are then written. A second Ctrl-C ends the program at once.
//!
//! The CPU time of all threads counts, so that a busy machine finishes what an idle one does. Where
//! the system has no clock of it, wall-clock time is used.

use std::path::{Path, PathBuf};
use std::process;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};
use std::sync::{Arc, OnceLock};
use std::thread;
use std::time::Duration;

use grazing_input::AnalysisLimits;
use grazing_model::smooth::Stop;

use crate::failure::{self, Failure};
use crate::system::{CLOCK, address_space, clock, held, megabytes};
use crate::{folder, signals, terminal};

/// The interval at which clock and memory are read: memory can grow by some ten megabytes in between.
const PAUSE: Duration = Duration::from_millis(20);

/// The number of times that Ctrl-C was pressed.
static INTERRUPTIONS: AtomicU32 = AtomicU32::new(0);

/// The part of the address space that an analysis may use: the rest is for drawing and writing. Much of what is
/// taken is only reserved, by each thread.
const ANALYSIS: f64 = 0.9;

/// The cause that ended an analysis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum EndCause {
    /// The time is used up, in seconds.
    Time(f64),
    /// The process holds more than this many megabytes.
    Memory(f64),
    /// The address space that the system allows is nearly used up, in megabytes.
    AddressSpace(f64),
    /// The steps of integration are used up, of which there were this many.
    Steps(f64),
    /// Ctrl-C was pressed.
    Interruption,
}

impl std::fmt::Display for EndCause {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let (limit, key) = match self {
            EndCause::Time(seconds) => (format!("time limit of {seconds} s {CLOCK}"), "time"),
            EndCause::Memory(megabytes) => (format!("memory limit of {megabytes} MB"), "memory"),
            EndCause::AddressSpace(megabytes) => {
                let limit = format!("system's limit of {megabytes:.0} MB of address space (ulimit -v)");
                return write!(
                    formatter,
                    "the {limit} was nearly reached (raise it, or use fewer threads with --jobs)"
                );
            }
            EndCause::Steps(steps) => (format!("limit of {steps} integration steps"), "step"),
            EndCause::Interruption => return formatter.write_str("interrupted"),
        };
        let remedy = format!("raise it with {key}_limit in [analysis] or --{key}-limit");
        write!(formatter, "the {limit} was reached ({remedy})")
    }
}

/// Whether Ctrl-C makes computations end with what they have.
static FINISHES: AtomicBool = AtomicBool::new(false);

/// Makes Ctrl-C end the program without leaving unfinished files behind; or, once [`finish_when_interrupted`] says so, the first
/// one the computation and the second one the program.
pub(crate) fn listen() {
    signals::handle(|| {
        if !FINISHES.load(Ordering::Relaxed) {
            leave("error: interrupted: nothing more is written");
        }
        if INTERRUPTIONS.fetch_add(1, Ordering::Relaxed) > 0 {
            leave("error: interrupted twice: cancelled at once; nothing more is written");
        }
        terminal::note(
            "interrupted: writing the finished results; Ctrl-C once more, after two seconds, cancels at once",
        );
    });
}

/// Makes the first Ctrl-C end computations with what they have, or not.
pub(crate) fn finish_when_interrupted(finishes: bool) {
    FINISHES.store(finishes, Ordering::Relaxed);
}

/// Makes Ctrl-C visible to [`is_interrupted`], and a second one end the program.
pub(crate) fn end_when_interrupted() {
    signals::handle(|| {
        if INTERRUPTIONS.fetch_add(1, Ordering::Relaxed) > 0 {
            leave("interrupted twice");
        }
    });
}

/// Ends the program with a last message, without leaving unfinished files behind.
fn leave(words: &str) -> ! {
    folder::remove_own_temporaries();
    terminal::last_note(words, || process::exit(failure::INCOMPLETE.into()))
}

/// Whether Ctrl-C was pressed.
pub(crate) fn is_interrupted() -> bool {
    INTERRUPTIONS.load(Ordering::Relaxed) > 0
}

/// Watches over one analysis, or over the reading of its file, as long as the value lives.
pub(crate) struct Watch(Arc<Watched>);

/// The state that the thread watches.
struct Watched {
    stop: Stop,
    limits: AnalysisLimits,
    began: Duration,
    /// The time that was taken before.
    taken: Duration,
    met: OnceLock<EndCause>,
    /// The megabytes of address space that the system allows, if it limits them.
    address_space: Option<f64>,
}

impl Watch {
    /// Begins to watch over something that has already taken this time.
    pub(crate) fn begin(limits: AnalysisLimits, taken: Duration) -> Self {
        // The number of steps is a whole number, and a limit beyond all counts is no limit.
        let stop = Stop::after(limits.steps as u64);
        let (met, address_space) = (OnceLock::new(), address_space());
        let watched = Arc::new(Watched { stop, limits, began: clock(), taken, met, address_space });
        let weak = Arc::downgrade(&watched);
        let look = move || {
            // The thread ends with the watch.
            while let Some(watched) = weak.upgrade() {
                if let Some(met) = watched.look() {
                    watched.met.get_or_init(|| met);
                    return watched.stop.ask();
                }
                drop(watched);
                thread::sleep(PAUSE);
            }
        };
        // Without a thread only the limit of the steps applies.
        let _ = thread::Builder::new().name("limits".to_owned()).spawn(look);
        Self(watched)
    }

    /// The mark that is set when a limit is reached.
    pub(crate) fn stop(&self) -> Stop {
        self.0.stop.clone()
    }

    /// The time that has been taken.
    pub(crate) fn taken(&self) -> Duration {
        self.0.taken()
    }

    /// The cause that has ended the analysis, if it was ended.
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
        let AnalysisLimits { time, memory, .. } = self.limits;
        if is_interrupted() {
            Some(EndCause::Interruption)
        } else if self.taken().as_secs_f64() > time {
            Some(EndCause::Time(time))
        } else if holds_more_than(memory) {
            Some(EndCause::Memory(memory))
        } else {
            let is_used_up = |limit: &f64| megabytes("VmSize:").is_some_and(|taken| taken > ANALYSIS * limit);
            self.address_space.filter(is_used_up).map(EndCause::AddressSpace)
        }
    }
}

/// Reads a file within limits, before those in the file are known, and returns the time taken.
/// Steps of integration are not counted yet.
///
/// # Errors
/// The file is wrong, or a limit was reached.
pub(crate) fn reading<T>(
    file: &Path,
    limits: AnalysisLimits,
    read: impl FnOnce(&Stop) -> Result<T, Failure>,
) -> Result<(T, Duration), Failure> {
    let watch = Watch::begin(AnalysisLimits { steps: f64::INFINITY, ..limits }, Duration::ZERO);
    match read(&watch.stop()) {
        Ok(read) => Ok((read, watch.taken())),
        Err(failure) => Err(match watch.end_cause() {
            Some(cause) => {
                ended(file, Some(cause), "nothing is written, because the file was still being read")
            }
            None => failure,
        }),
    }
}

/// Whether the process may hold so many megabytes more.
pub(crate) fn has_room(limits: Option<AnalysisLimits>, megabytes: f64) -> bool {
    limits.is_none_or(|limits| held().is_none_or(|held| held + megabytes <= limits.memory))
}

/// The failure of a run without these pictures, for which there is no room.
pub(crate) fn no_room(file: &Path, limits: Option<AnalysisLimits>, pictures: &[PathBuf]) -> Failure {
    let names: Vec<String> = pictures.iter().map(|path| path.display().to_string()).collect();
    Failure::incomplete(format!(
        "{}: {} would take more than the memory limit of {} MB and {} not drawn (choose a lower --dpi, or raise it with memory_limit in [analysis] or --memory-limit); everything else is written",
        file.display(),
        names.join(", "),
        limits.map_or(f64::INFINITY, |limits| limits.memory),
        if names.len() == 1 { "is" } else { "are" },
    ))
}

/// A note if drawing and writing, which limits do not end, took more than these allow.
pub(crate) fn note_excess(file: &Path, limits: AnalysisLimits, taken: Duration) {
    let (seconds, file) = (taken.as_secs_f64(), file.display());
    let what = "drawing and writing, which limits do not end";
    if seconds > limits.time {
        terminal::note(&format!(
            "{file}: {seconds:.1} s of CPU time with {what}: more than the limit of {} s",
            limits.time
        ));
    }
    if let Some(held) = held().filter(|held| *held > limits.memory) {
        terminal::note(&format!(
            "{file}: {held:.0} MB with {what}: more than the limit of {} MB",
            limits.memory
        ));
    }
}

/// The failure of an analysis that was ended, with the cause, a limit or Ctrl-C, if it is known.
pub(crate) fn ended(file: &Path, met: Option<EndCause>, outcome: &str) -> Failure {
    let cause = met.map_or(String::new(), |met| format!("{met}; "));
    Failure::incomplete(format!("{}: {cause}{outcome}", file.display()))
}

/// Whether the process holds more than this many megabytes; false where the system does not report it.
fn holds_more_than(megabytes: f64) -> bool {
    held().is_some_and(|held| held > megabytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    const AMPLE: AnalysisLimits = AnalysisLimits { time: 1e6, memory: 1e9, steps: 1e18 };

    /// The limit that is reached, and the time taken until then.
    #[track_caller]
    fn met(limits: AnalysisLimits) -> (EndCause, f64) {
        let watch = Watch::begin(limits, Duration::ZERO);
        // Only computation takes CPU time.
        while !watch.stop().is_asked() {
            assert!(watch.taken() < Duration::from_secs(600), "nothing is met");
        }
        (watch.end_cause().expect("what is met is known before the mark is set"), watch.taken().as_secs_f64())
    }

    #[test]
    fn time_and_memory_end_an_analysis_and_are_named() {
        let (cause, taken) = met(AnalysisLimits { time: 0.05, ..AMPLE });
        assert!(cause == EndCause::Time(0.05) && taken > 0.05, "{cause:?} {taken}");
        assert!(cause.to_string().contains("0.05 s of CPU time") || cfg!(not(unix)), "{cause}");
        if held().is_some() {
            assert_eq!(met(AnalysisLimits { memory: 0.1, ..AMPLE }).0, EndCause::Memory(0.1));
        }
    }

    #[test]
    fn time_that_was_taken_before_counts() {
        let watch = Watch::begin(AnalysisLimits { time: 100.0, ..AMPLE }, Duration::from_secs(101));
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
