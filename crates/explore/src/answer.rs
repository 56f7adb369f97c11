//! Answers of one piece, and computations that end when nobody waits for them.

use std::convert::Infallible;
use std::sync::Arc;

use grazing_unfold::stop::Stop;
use http_body_util::combinators::BoxBody;
use http_body_util::{BodyExt, Full};
use hyper::body::Bytes;
use hyper::header::{CONTENT_DISPOSITION, CONTENT_TYPE, HeaderValue};
use hyper::{Response, StatusCode};
use serde::Serialize;
use serde_json::json;
use tokio::sync::Notify;
use tokio::task::spawn_blocking;

use crate::model::Wrong;
use crate::server::{Limits, Shared, Sheet};

/// What answers carry.
pub(crate) type Body = BoxBody<Bytes, Infallible>;

/// Why there is no answer.
#[derive(Debug)]
pub(crate) struct Problem {
    status: StatusCode,
    message: String,
}

impl Problem {
    pub(crate) fn new(status: StatusCode, message: impl Into<String>) -> Self {
        Self { status, message: message.into() }
    }

    /// What was asked for cannot be: the model is wrong, or there is nothing to show.
    pub(crate) fn wrong(message: impl Into<String>) -> Self {
        Self::new(StatusCode::UNPROCESSABLE_ENTITY, message)
    }

    /// The computation was ended.
    pub(crate) fn ended() -> Self {
        Self::new(StatusCode::SERVICE_UNAVAILABLE, "the computation was ended: it took too long")
    }

    pub(crate) fn message(&self) -> &str {
        &self.message
    }

    pub(crate) fn response(self) -> Response<Body> {
        let mut response = json(&json!({ "message": self.message }));
        *response.status_mut() = self.status;
        response
    }
}

impl From<Wrong> for Problem {
    fn from(wrong: Wrong) -> Self {
        let line = wrong.line.map_or(String::new(), |line| format!("line {line}: "));
        Self::wrong(format!("{line}{}", wrong.message))
    }
}

impl Wrong {
    /// As an answer.
    pub(crate) fn told(&self) -> serde_json::Value {
        json!({"ok": false, "message": self.message, "line": self.line, "span": self.span})
    }
}

/// A body of one piece.
pub(crate) fn whole(content: impl Into<Bytes>) -> Body {
    Full::new(content.into()).boxed()
}

/// A value as JSON; numbers that are none are null.
pub(crate) fn json(value: &impl Serialize) -> Response<Body> {
    match serde_json::to_vec(value) {
        Ok(bytes) => of_kind("application/json", bytes),
        Err(error) => {
            let mut response = of_kind("text/plain; charset=utf-8", error.to_string().into_bytes());
            *response.status_mut() = StatusCode::INTERNAL_SERVER_ERROR;
            response
        }
    }
}

pub(crate) fn of_kind(kind: &'static str, content: impl Into<Bytes>) -> Response<Body> {
    let mut response = Response::new(whole(content));
    response.headers_mut().insert(CONTENT_TYPE, HeaderValue::from_static(kind));
    response
}

/// A file to be saved.
pub(crate) fn file(sheet: Sheet) -> Result<Response<Body>, Problem> {
    let Sheet { name, kind, content } = sheet;
    let mut response = of_kind(kind, content);
    let disposition = HeaderValue::from_str(&format!("attachment; filename=\"{name}\""))
        .map_err(|_| Problem::wrong("the file has no name"))?;
    response.headers_mut().insert(CONTENT_DISPOSITION, disposition);
    Ok(response)
}

/// Asks a computation to end when it is dropped, as the answer that nobody waits for any more is.
pub(crate) struct StopOnDrop {
    stop: Stop,
    gone: Arc<Notify>,
}

impl StopOnDrop {
    pub(crate) fn new(stop: Stop) -> Self {
        Self { stop, gone: Arc::default() }
    }

    /// Tells when it is dropped.
    pub(crate) fn gone(&self) -> Arc<Notify> {
        self.gone.clone()
    }
}

impl Drop for StopOnDrop {
    fn drop(&mut self) {
        self.stop.ask();
        self.gone.notify_one();
    }
}

/// Computes something in a thread of its own, when it is its turn.
pub(crate) async fn blocking<T: Send + 'static>(
    shared: &Arc<Shared>,
    limits: Limits,
    work: impl FnOnce(&Stop) -> Result<T, Problem> + Send + 'static,
) -> Result<T, Problem> {
    let turn = shared.turn().await?;
    let (stop, guard) = shared.mark(limits);
    let computed = spawn_blocking(move || turn.take(|| work(&stop)));
    let failed = |_| Problem::new(StatusCode::INTERNAL_SERVER_ERROR, "the computation failed");
    let outcome = computed.await.map_err(failed)?;
    drop(guard);
    outcome
}

/// Computes an answer.
pub(crate) async fn computed<T: Send + 'static, V: Serialize + Send + 'static>(
    shared: &Arc<Shared>,
    request: T,
    compute: fn(&T, &Stop) -> Result<V, Problem>,
) -> Result<Response<Body>, Problem> {
    let value = blocking(shared, shared.limits, move |stop| compute(&request, stop)).await?;
    Ok(json(&value))
}
