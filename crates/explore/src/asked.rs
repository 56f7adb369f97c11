//! What a page asks for, whoever answers: the server, or a worker of the page itself.

use grazing_model::smooth::Stop;
use grazing_source::Mistake;
use serde::de::DeserializeOwned;
use serde_json::{Value, json};

use crate::answer::{Problem, Sheet};
use crate::events::{self, Clock, Events, Listener};
use crate::figure::{ExportRequest, Seen};
use crate::model::Model;
use crate::place::PlaceRequest;
use crate::{cut, diagram, exact, follow, place, tiles};

/// Makes a file of a figure: `svg`, `pdf`, `png` or `csv:TABLE` at a width (`one`, `two`, or that of
/// the paper), unless an end is asked for.
pub type Export = Box<dyn Fn(&Seen, &str, &str, &Stop) -> Result<Sheet, String> + Send + Sync>;

/// What a computation is to those that come after it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Weight {
    /// It takes a moment for any oscillator that people write.
    Light,
    /// It may take long.
    Heavy,
}

/// Computes one value.
type One = dyn Fn(&Stop) -> Result<Value, Problem> + Send;
/// Computes, and tells what is found as it is found.
pub(crate) type Told = dyn Fn(&Events, &Stop) -> Result<(), Problem> + Send;

/// A request that was read.
pub(crate) enum Asked {
    /// Where there is one computation at a time, nobody asks what it weighs.
    One(#[cfg_attr(not(feature = "server"), expect(dead_code))] Weight, Box<One>),
    Told(Box<Told>),
    File(Box<ExportRequest>),
}

type Read = serde_json::Result<Asked>;

/// How the body of a request is read whose path ends so; none if nothing is asked for by that name.
pub(crate) fn reader(name: &str) -> Option<fn(&[u8]) -> Read> {
    Some(match name {
        "check" => |body| one(body, |_| Weight::Light, check),
        "diagram" => |body| told(body, diagram::compute),
        "tiles" => |body| told(body, tiles::compute),
        "place" => |body| one(body, PlaceRequest::weight, place::compute),
        "exact" => |body| one(body, |_| Weight::Light, exact::compute),
        "follow" => |body| one(body, |_| Weight::Light, follow::compute),
        "cut" => |body| told(body, cut::compute),
        "export" => |body| serde_json::from_slice(body).map(Asked::File),
        _ => return None,
    })
}

fn one<T: DeserializeOwned + Send + 'static>(
    body: &[u8],
    weight: fn(&T) -> Weight,
    compute: fn(&T, &Stop) -> Result<Value, Problem>,
) -> Read {
    let request: T = serde_json::from_slice(body)?;
    Ok(Asked::One(weight(&request), Box::new(move |stop| compute(&request, stop))))
}

fn told<T: DeserializeOwned + Send + 'static>(
    body: &[u8],
    compute: fn(&T, &Events, &Stop) -> Result<(), Problem>,
) -> Read {
    let request: T = serde_json::from_slice(body)?;
    Ok(Asked::Told(Box::new(move |events, stop| compute(&request, events, stop))))
}

/// What the program says of a model; a mistake in it is an answer, too.
fn check(model: &Model, stop: &Stop) -> Result<Value, Problem> {
    match model.described(stop) {
        _ if stop.is_asked() => Err(Problem::ended()),
        Ok(described) => Ok(described),
        Err(Mistake { message, line, span }) => {
            Ok(json!({"ok": false, "message": message, "line": line, "span": span}))
        }
    }
}

/// A file of what is seen.
pub(crate) fn file(request: &ExportRequest, export: &Export, stop: &Stop) -> Result<Sheet, Problem> {
    let seen = Seen::compute(request, stop)?;
    export(&seen, &request.what, &request.columns, stop).map_err(Problem::wrong)
}

/// Answers a request here and now, as the server does: its path's last part, and its body. Events
/// go to the listener, one value or a file is returned with its media type.
///
/// # Errors
/// A status of HTTP, and what is said of it as JSON.
pub fn answer(
    name: &str,
    body: &[u8],
    (listener, clock): (&Listener, Clock),
    export: &Export,
    stop: &Stop,
) -> Result<(&'static str, Vec<u8>), (u16, String)> {
    let answered = || {
        let read = reader(name).ok_or_else(|| Problem::new(404, "there is nothing here"))?;
        match read(body).map_err(|error| Problem::unread(&error))? {
            Asked::One(_, compute) => Ok((JSON, compute(stop)?.to_string().into_bytes())),
            Asked::File(request) => {
                file(&request, export, stop).map(|Sheet { kind, content, .. }| (kind, content))
            }
            Asked::Told(compute) => {
                events::tell(&*compute, listener, clock, stop);
                Ok((EVENTS, Vec::new()))
            }
        }
    };
    answered().map_err(|problem: Problem| (problem.status, problem.told().to_string()))
}

/// Media types.
pub(crate) const JSON: &str = "application/json";
pub(crate) const EVENTS: &str = "text/event-stream";
