//! Computations in a separate thread, while this one handles signals and reports progress.

use std::panic::resume_unwind;
use std::sync::mpsc::{self, RecvTimeoutError, Sender};
use std::thread;
use std::time::Duration;

use grazing_cli::failure::Failure;
use grazing_cli::library::StartProgress;
use grazing_model::smooth::Stop;
use grazing_unfold::progress::Progress;
use pyo3::exceptions::{PyOSError, PyRuntimeError, PyValueError};
use pyo3::prelude::*;

/// The interval at which signals are handled.
const PAUSE: Duration = Duration::from_millis(20);

/// An event of a computation.
enum Event {
    /// A computation begins, which this mark cancels.
    Mark(Stop),
    /// Work of a number of steps begins.
    Begin(String, u64),
    /// One of the steps of the work is done.
    Step(String),
    /// The work is done.
    End(String),
}

/// Reports the progress of a computation.
struct Reporter {
    events: Sender<Event>,
    stop: Stop,
}

impl Reporter {
    fn tell(&self, event: Event) {
        // There is no receiver any more when the interpreter ends.
        let _ = self.events.send(event);
    }
}

impl Progress for Reporter {
    fn begin(&self, what: &str, steps: u64) {
        self.tell(Event::Begin(what.to_owned(), steps));
    }

    fn step(&self, what: &str) {
        self.tell(Event::Step(what.to_owned()));
    }

    fn end(&self, what: &str) {
        self.tell(Event::End(what.to_owned()));
    }

    fn stopped(&self) -> bool {
        self.stop.is_asked()
    }
}

/// Does work with the interpreter's lock released. An exception of a signal, or of `progress(what,
/// done, all)`, cancels it.
///
/// # Errors
/// The exception that was raised, or the failure with the message of the command line.
pub(crate) fn compute<T: Send>(
    py: Python<'_>,
    progress: Option<&Bound<'_, PyAny>>,
    work: impl FnOnce(StartProgress<'_>) -> Result<T, Failure> + Send,
) -> PyResult<T> {
    let (events, mut heard) = mpsc::channel();
    let work = move || {
        work(&|stop| {
            let reporter = Reporter { events: events.clone(), stop };
            reporter.tell(Event::Mark(reporter.stop.clone()));
            Box::new(reporter)
        })
    };
    thread::scope(|scope| {
        let worker = scope.spawn(work);
        let (mut marks, mut works, mut raised) = (Vec::new(), Vec::new(), None);
        loop {
            let events = &mut heard;
            match py.detach(move || events.recv_timeout(PAUSE)) {
                Ok(Event::Mark(mark)) => marks.push(mark),
                Ok(_) if raised.is_some() => {}
                Ok(event) => raised = progress.and_then(|call| told(call, &mut works, event).err()),
                Err(RecvTimeoutError::Timeout) => {}
                Err(RecvTimeoutError::Disconnected) => break,
            }
            raised = raised.or_else(|| py.check_signals().err());
            if raised.is_some() {
                marks.iter().for_each(Stop::ask);
            }
        }
        let found = py.detach(|| worker.join()).unwrap_or_else(|panic| resume_unwind(panic));
        match raised {
            Some(raised) => Err(raised),
            None => found.map_err(|failure| error(&failure)),
        }
    })
}

/// Reports the progress of work; the list holds the work under way, with the steps done and all steps.
fn told(call: &Bound<'_, PyAny>, works: &mut Vec<(String, u64, u64)>, event: Event) -> PyResult<()> {
    let (what, done, all) = match event {
        Event::Mark(_) => return Ok(()),
        Event::Begin(what, all) => {
            works.push((what.clone(), 0, all));
            (what, 0, all)
        }
        Event::Step(what) => {
            let Some((_, done, all)) = works.iter_mut().find(|(known, ..)| *known == what) else {
                return Ok(());
            };
            *done += 1;
            (what, *done, *all)
        }
        Event::End(what) => {
            let Some(place) = works.iter().position(|(known, ..)| *known == what) else { return Ok(()) };
            let (what, _, all) = works.remove(place);
            (what, all, all)
        }
    };
    call.call1((what, done, all)).map(drop)
}

/// A failure as an exception: ValueError for bad input, OSError for files that cannot be read,
/// otherwise RuntimeError.
pub(crate) fn error(failure: &Failure) -> PyErr {
    let text = failure.to_string();
    match failure.exit_code() {
        2 => PyValueError::new_err(text),
        4 => PyOSError::new_err(text),
        _ => PyRuntimeError::new_err(text),
    }
}
