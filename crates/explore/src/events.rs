//! Events that are sent during a computation, as server-sent events.

use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

use grazing_model::smooth::Stop;
use grazing_unfold::progress::Progress;
use serde::Serialize;

use crate::answer::{Problem, answers, written};
use crate::kept::Kept;

/// The shortest interval between reports of progress.
const PAUSE: Duration = Duration::from_millis(80);

/// The time since an arbitrary instant, used for durations only.
pub type Clock = fn() -> Duration;

/// Takes the text of an event, and returns whether there still is a listener.
pub type Listener = dyn Fn(String) -> bool + Send + Sync;

/// A computation that sends results as it finds them.
pub(crate) type Told = dyn Fn(&Events, &Stop) -> Result<(), Problem> + Send;

/// The channel into which a computation sends its results.
pub(crate) struct Events<'a> {
    listener: &'a Listener,
    pub(crate) clock: Clock,
    /// The last diagrams.
    pub(crate) kept: &'a Kept,
    stop: &'a Stop,
    stages: Mutex<Stages>,
}

/// The progress that is reported.
#[derive(Default)]
struct Stages {
    /// Stages under way, with the steps done and the steps to do.
    running: BTreeMap<String, [u64; 2]>,
    /// The time of the last report.
    last: Option<Duration>,
}

answers! {
    /// A stage that is under way, with the steps done and all steps.
    Stage<'a> { stage: &'a str, done: u64, all: u64, }

    /// All is told, after this time.
    Done { seconds: f64, }
}

/// The text of an event.
pub(crate) fn event(name: &str, data: &impl Serialize) -> String {
    format!("event: {name}\ndata: {}\n\n", written(data))
}

/// Computes, and sends results as they are found; at the end that it is done, or why it is not: `ended` says why
/// it was asked to stop.
pub(crate) fn tell(
    compute: &Told,
    (listener, clock): (&Listener, Clock),
    kept: &Kept,
    stop: &Stop,
    ended: &dyn Fn() -> Problem,
) {
    let began = clock();
    let events = Events { listener, clock, kept, stop, stages: Mutex::default() };
    match compute(&events, stop) {
        _ if stop.is_asked() => events.send("error", &ended()),
        Ok(()) => events.send("done", &Done { seconds: (clock() - began).as_secs_f64() }),
        Err(problem) => events.send("error", &problem),
    }
}

impl Events<'_> {
    /// Sends an event.
    pub(crate) fn send(&self, name: &str, data: &impl Serialize) {
        self.say(event(name, data));
    }

    /// Sends the text of an event; once there is no listener, the computation is cancelled.
    pub(crate) fn say(&self, event: String) {
        if !(self.listener)(event) {
            self.stop.ask();
        }
    }

    fn report(&self, what: &str, change: impl FnOnce(&mut Stages), always: bool) {
        let mut stages = self.stages.lock().unwrap_or_else(PoisonError::into_inner);
        change(&mut stages);
        let now = (self.clock)();
        if !always && stages.last.is_some_and(|last| now - last < PAUSE) {
            return;
        }
        stages.last = Some(now);
        let running = stages.running.get(what).copied();
        drop(stages);
        if let Some([done, all]) = running {
            self.send("progress", &Stage { stage: what, done, all });
        }
    }
}

impl Progress for Events<'_> {
    fn begin(&self, what: &str, steps: u64) {
        let begun = |stages: &mut Stages| _ = stages.running.insert(what.to_owned(), [0, steps]);
        self.report(what, begun, true);
    }

    fn step(&self, what: &str) {
        let step = |stages: &mut Stages| {
            if let Some([done, _]) = stages.running.get_mut(what) {
                *done += 1;
            }
        };
        self.report(what, step, false);
    }

    fn end(&self, what: &str) {
        self.stages.lock().unwrap_or_else(PoisonError::into_inner).running.remove(what);
    }

    fn stopped(&self) -> bool {
        self.stop.is_asked()
    }
}
