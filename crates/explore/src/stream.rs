//! Answers that come in pieces, as server-sent events, while they are computed.

use std::collections::BTreeMap;
use std::convert::Infallible;
use std::pin::Pin;
use std::sync::{Mutex, PoisonError};
use std::task::{Context, Poll};
use std::time::{Duration, Instant};

use grazing_model::smooth::Stop;
use grazing_unfold::progress::Progress;
use http_body_util::BodyExt;
use hyper::Response;
use hyper::body::{Body as HttpBody, Bytes, Frame};
use hyper::header::{CONTENT_TYPE, HeaderValue};
use serde::Serialize;
use serde_json::json;
use tokio::sync::mpsc::{Receiver, Sender, channel};

use crate::answer::{Body, Problem};
use crate::turns::{self, Begun, StopOnDrop, Turns, Weight};

/// Events that wait for a slow reader; the computation waits then, too.
const WAITING: usize = 64;
/// Progress is sent no more often than this.
const PAUSE: Duration = Duration::from_millis(80);

/// Where a computation sends what it finds.
pub(crate) struct Events {
    sender: Sender<Bytes>,
    stop: Stop,
    stages: Mutex<Stages>,
}

/// The progress that is reported.
#[derive(Default)]
struct Stages {
    /// Stages under way, with what is done of them and what there is to do.
    running: BTreeMap<String, [u64; 2]>,
    /// When something was sent last.
    last: Option<Instant>,
}

impl Events {
    /// Sends an event; once nobody reads any more, the computation ends.
    pub(crate) fn send(&self, name: &str, data: &impl Serialize) {
        // What cannot be written as JSON is not sent: all of it is numbers and words.
        let Ok(data) = serde_json::to_string(data) else { return };
        let text = format!("event: {name}\ndata: {data}\n\n");
        if self.sender.blocking_send(text.into()).is_err() {
            self.stop.ask();
        }
    }

    fn report(&self, what: &str, change: impl FnOnce(&mut Stages), always: bool) {
        let mut stages = self.stages.lock().unwrap_or_else(PoisonError::into_inner);
        change(&mut stages);
        let now = Instant::now();
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

impl Progress for Events {
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

/// Computes, and sends what is found as it is found.
pub(crate) async fn events<T: Send + Sync + 'static>(
    turns: &Turns,
    request: T,
    compute: fn(&T, &Events, &Stop) -> Result<(), Problem>,
) -> Result<Response<Body>, Problem> {
    let (sender, receiver) = channel(WAITING);
    let work = move |stop: &Stop| {
        let began = Instant::now();
        let events = Events { sender, stop: stop.clone(), stages: Mutex::default() };
        match compute(&request, &events, stop) {
            _ if stop.is_asked() => events.send("error", &json!({ "message": Problem::ended().message() })),
            Ok(()) => events.send("done", &json!({ "seconds": began.elapsed().as_secs_f64() })),
            Err(problem) => events.send("error", &json!({ "message": problem.message() })),
        }
    };
    let Begun { guard, .. } = turns::begin(turns, Weight::Heavy, work).await?;
    let mut response = Response::new(Reading { receiver, _guard: guard }.boxed());
    response.headers_mut().insert(CONTENT_TYPE, HeaderValue::from_static("text/event-stream"));
    Ok(response)
}

/// The body of an answer in pieces; when the connection goes, so does the computation.
struct Reading {
    receiver: Receiver<Bytes>,
    _guard: StopOnDrop,
}

impl HttpBody for Reading {
    type Data = Bytes;
    type Error = Infallible;

    fn poll_frame(
        mut self: Pin<&mut Self>,
        context: &mut Context<'_>,
    ) -> Poll<Option<Result<Frame<Bytes>, Infallible>>> {
        self.receiver.poll_recv(context).map(|bytes| bytes.map(|bytes| Ok(Frame::data(bytes))))
    }
}
