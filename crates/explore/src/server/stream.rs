//! Answers that are sent in pieces while they are computed.

use std::convert::Infallible;
use std::pin::Pin;
use std::sync::{Arc, LazyLock};
use std::task::{Context, Poll};
use std::time::{Duration, Instant};

use grazing_model::smooth::Stop;
use http_body_util::BodyExt;
use hyper::Response;
use hyper::body::{Body as HttpBody, Bytes, Frame};
use tokio::sync::mpsc::{Receiver, channel};

use super::response::{self, Body};
use super::turns::{self, Begun, Cause, StopOnDrop, Turns};
use crate::answer::Problem;
use crate::asked::{EVENTS, Weight};
use crate::events;
use crate::events::Told;
use crate::kept::Kept;

/// The most events that wait for a slow reader; the computation then waits, too.
const WAITING: usize = 64;

/// The time since the first call.
fn clock() -> Duration {
    static BEGAN: LazyLock<Instant> = LazyLock::new(Instant::now);
    BEGAN.elapsed()
}

/// Computes, and sends results as they are found.
pub(super) async fn events(
    turns: &Turns,
    kept: Arc<Kept>,
    compute: Box<Told>,
) -> Result<Response<Body>, Problem> {
    let (sender, receiver) = channel(WAITING);
    let work = move |stop: &Stop, cause: &Cause| {
        let listener = move |text: String| sender.blocking_send(text.into()).is_ok();
        events::tell(&*compute, (&listener, clock), &kept, stop, &|| cause.problem());
    };
    let Begun { guard, .. } = turns::begin(turns, Weight::Heavy, work).await?;
    Ok(response::with_kind(EVENTS, Reading { receiver, _guard: guard }.boxed()))
}

/// The body of an answer in pieces; when the connection ends, so does the computation.
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
