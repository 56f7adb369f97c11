//! Answers in HTTP.

use std::convert::Infallible;

use http_body_util::combinators::BoxBody;
use http_body_util::{BodyExt, Full};
use hyper::body::Bytes;
use hyper::header::{CONTENT_DISPOSITION, CONTENT_TYPE, HeaderValue};
use hyper::{Response, StatusCode};

use crate::answer::{ExportedFile, Problem, written};
use crate::asked::JSON;

/// The body of an answer.
pub(super) type Body = BoxBody<Bytes, Infallible>;

/// The answer to a request that has failed.
pub(super) fn refused(problem: &Problem) -> Response<Body> {
    let mut response = json(written(problem));
    *response.status_mut() =
        StatusCode::from_u16(problem.status).unwrap_or(StatusCode::INTERNAL_SERVER_ERROR);
    response
}

/// An answer in JSON.
pub(super) fn json(answer: String) -> Response<Body> {
    of_kind(JSON, answer)
}

/// Content in one piece.
pub(super) fn of_kind(kind: &'static str, content: impl Into<Bytes>) -> Response<Body> {
    with_kind(kind, Full::new(content.into()).boxed())
}

pub(super) fn with_kind(kind: &'static str, body: Body) -> Response<Body> {
    let mut response = Response::new(body);
    response.headers_mut().insert(CONTENT_TYPE, HeaderValue::from_static(kind));
    response
}

/// A file for download.
pub(super) fn file(sheet: ExportedFile) -> Result<Response<Body>, Problem> {
    let ExportedFile { name, kind, content } = sheet;
    let mut response = of_kind(kind, content);
    let disposition = HeaderValue::from_str(&format!("attachment; filename=\"{name}\""))
        .map_err(|_| Problem::wrong("the file name is not valid"))?;
    response.headers_mut().insert(CONTENT_DISPOSITION, disposition);
    Ok(response)
}
