//! What answers carry.

use std::convert::Infallible;

use grazing_source::Mistake;
use http_body_util::combinators::BoxBody;
use http_body_util::{BodyExt, Full};
use hyper::body::Bytes;
use hyper::header::{CONTENT_DISPOSITION, CONTENT_TYPE, HeaderValue};
use hyper::{Response, StatusCode};
use serde_json::{Value, json};

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

impl From<Mistake> for Problem {
    fn from(Mistake { message, line, .. }: Mistake) -> Self {
        let line = line.map_or(String::new(), |line| format!("line {line}: "));
        Self::wrong(format!("{line}{message}"))
    }
}

/// A body of one piece.
pub(crate) fn whole(content: impl Into<Bytes>) -> Body {
    Full::new(content.into()).boxed()
}

/// A value as JSON; numbers that are none are null.
pub(crate) fn json(value: &Value) -> Response<Body> {
    of_kind("application/json", value.to_string())
}

pub(crate) fn of_kind(kind: &'static str, content: impl Into<Bytes>) -> Response<Body> {
    let mut response = Response::new(whole(content));
    response.headers_mut().insert(CONTENT_TYPE, HeaderValue::from_static(kind));
    response
}

/// A file that is exported.
pub struct Sheet {
    /// Its name.
    pub name: String,
    /// Its media type.
    pub kind: &'static str,
    /// Its content.
    pub content: Vec<u8>,
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
