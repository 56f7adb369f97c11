//! Requests of a page, which the server or a worker of the page itself answers.

use grazing_model::smooth::Stop;
use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::answer::{ExportedFile, Problem, written};
use crate::events::{self, Clock, Events, Listener, Told};
use crate::figure::{ExportRequest, Seen};
use crate::kept::Kept;
use crate::place::PlaceRequest;
use crate::{cut, diagram, exact, follow, measured, model, place, tiles};

/// Writes a figure as a file: `svg`, `pdf`, `png` or `csv:TABLE` at a width (`one`, `two`, or that
/// of the paper), unless it is cancelled.
pub type Export = Box<dyn Fn(&Seen, &str, &str, &Stop) -> Result<ExportedFile, String> + Send + Sync>;

/// The weight of a computation, by which later ones wait for it or not.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Weight {
    /// A computation that takes a moment for any oscillator that people write.
    Light,
    /// A computation that may take long.
    Heavy,
}

/// A computation with one value as its result, in JSON.
type One = dyn Fn(&Stop) -> Result<String, Problem> + Send;

/// A request that has been read.
pub(crate) enum Asked {
    /// Without the server there is one computation at a time, and its weight does not matter.
    One(#[cfg_attr(not(feature = "server"), expect(dead_code))] Weight, Box<One>),
    Told(Box<Told>),
    File(Box<ExportRequest>),
}

type Read = serde_json::Result<Asked>;

/// The function that reads the body of a request whose path ends with this name; none for an unknown name.
pub(crate) fn reader(name: &str) -> Option<fn(&[u8]) -> Read> {
    Some(match name {
        "check" => |body| one(body, |_| Weight::Light, model::check),
        "diagram" => |body| told(body, diagram::compute),
        "tiles" => |body| told(body, tiles::compute),
        "place" => |body| one(body, weight, place::compute),
        "exact" => |body| one(body, |_| Weight::Light, exact::compute),
        "follow" => |body| one(body, |_| Weight::Light, follow::compute),
        "cut" => |body| told(body, cut::compute),
        "measured" => |body| one(body, |_| Weight::Light, measured::read),
        "compare" => |body| told(body, measured::compute),
        "export" => |body| serde_json::from_slice(body).map(Asked::File),
        _ => return None,
    })
}

fn one<T: DeserializeOwned + Send + 'static, A: Serialize + 'static>(
    body: &[u8],
    weight: fn(&T) -> Weight,
    compute: fn(&T, &Stop) -> Result<A, Problem>,
) -> Read {
    let request: T = serde_json::from_slice(body)?;
    let weight = weight(&request);
    Ok(Asked::One(weight, Box::new(move |stop| Ok(written(&compute(&request, stop)?)))))
}

fn told<T: DeserializeOwned + Send + 'static>(
    body: &[u8],
    compute: fn(&T, &Events, &Stop) -> Result<(), Problem>,
) -> Read {
    let request: T = serde_json::from_slice(body)?;
    Ok(Asked::Told(Box::new(move |events, stop| compute(&request, events, stop))))
}

fn weight(request: &PlaceRequest) -> Weight {
    if request.nearby.is_some() { Weight::Light } else { Weight::Heavy }
}

/// A file of what the page shows.
pub(crate) fn file(request: &ExportRequest, export: &Export, stop: &Stop) -> Result<ExportedFile, Problem> {
    let seen = Seen::compute(request, stop)?;
    export(&seen, &request.what, &request.columns, stop).map_err(Problem::wrong)
}

/// The last diagrams where there is no server.
static KEPT: Kept = Kept::none();

/// Answers a request at once, as the server does, from the last part of its path and its body.
/// Events go to the listener; one value or a file is returned with its media type.
///
/// # Errors
/// A status of HTTP, and a message as JSON.
pub fn answer(
    name: &str,
    body: &[u8],
    (listener, clock): (&Listener, Clock),
    export: &Export,
    stop: &Stop,
) -> Result<(&'static str, Vec<u8>), (u16, String)> {
    let answered = || {
        let read = reader(name).ok_or_else(|| Problem::new(404, "not found"))?;
        match read(body).map_err(|error| Problem::unread(&error))? {
            Asked::One(_, compute) => Ok((JSON, compute(stop)?.into_bytes())),
            Asked::File(request) => {
                file(&request, export, stop).map(|ExportedFile { kind, content, .. }| (kind, content))
            }
            Asked::Told(compute) => {
                events::tell(&*compute, (listener, clock), &KEPT, stop, &Problem::ended);
                Ok((EVENTS, Vec::new()))
            }
        }
    };
    answered().map_err(|problem: Problem| (problem.status, written(&problem)))
}

/// The media type of values; that of events follows.
pub(crate) const JSON: &str = "application/json";
pub(crate) const EVENTS: &str = "text/event-stream";
