//! What is told while something is computed, as server-sent events.

use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

use grazing_model::smooth::Stop;
use grazing_unfold::progress::Progress;
use serde::Serialize;
use serde_json::json;

use crate::answer::Problem;
use crate::asked::Told;

/// Progress is told no more often than this.
const PAUSE: Duration = Duration::from_millis(80);

/// The time since whenever; nothing but how long something took is read off it.
pub type Clock = fn() -> Duration;

/// Takes an event's text, and says whether anybody still listens.
pub type Listener = dyn Fn(String) -> bool + Send + Sync;

/// Where a computation tells what it finds.
pub(crate) struct Events<'a> {
    listener: &'a Listener,
    pub(crate) clock: Clock,
    stop: &'a Stop,
    stages: Mutex<Stages>,
}

/// The progress that is told.
#[derive(Default)]
struct Stages {
    /// Stages under way, with what is done of them and what there is to do.
    running: BTreeMap<String, [u64; 2]>,
    /// When something was told last.
    last: Option<Duration>,
}

/// Computes, and tells what is found as it is found; at last that it is done, or why it is not.
pub(crate) fn tell(compute: &Told, listener: &Listener, clock: Clock, stop: &Stop) {
    let began = clock();
    let events = Events { listener, clock, stop, stages: Mutex::default() };
    match compute(&events, stop) {
        _ if stop.is_asked() => events.send("error", &Problem::ended().told()),
        Ok(()) => events.send("done", &json!({ "seconds": (clock() - began).as_secs_f64() })),
        Err(problem) => events.send("error", &problem.told()),
    }
}

impl Events<'_> {
    /// Tells an event; once nobody listens any more, the computation ends.
    pub(crate) fn send(&self, name: &str, data: &impl Serialize) {
        // What cannot be written as JSON is not sent: all of it is numbers and words.
        let Ok(data) = serde_json::to_string(data) else { return };
        if !(self.listener)(format!("event: {name}\ndata: {data}\n\n")) {
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
        let stage =
            stages.running.get(what).map(|[done, all]| json!({"stage": what, "done": done, "all": all}));
        drop(stages);
        if let Some(stage) = stage {
            self.send("progress", &stage);
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
