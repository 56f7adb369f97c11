//! The program for a page that has no server: what `grazing explore` answers, in a worker of the
//! page itself.
//!
//! A request is put into the room that [`room`] makes, its path's last part first, and [`answer`]ed.
//! All that comes of it is told through `tell` while it is computed.

use core::mem;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use grazing_explore::Export;
use grazing_model::smooth::Stop;

#[link(wasm_import_module = "page")]
unsafe extern "C" {
    /// Takes a part of what is told: an event (0), or the answer's media type (1) or content (2).
    fn tell(what: u32, at: *const u8, length: usize);
    /// Seconds since whenever.
    safe fn now() -> f64;
}

/// The request that is to be answered next.
static REQUEST: Mutex<Vec<u8>> = Mutex::new(Vec::new());

fn request() -> MutexGuard<'static, Vec<u8>> {
    REQUEST.lock().unwrap_or_else(PoisonError::into_inner)
}

fn told(what: u32, content: &[u8]) {
    // SAFETY: the page reads these bytes before it returns, and nothing else.
    unsafe { tell(what, content.as_ptr(), content.len()) }
}

fn clock() -> Duration {
    Duration::from_secs_f64(now())
}

/// Room for a request of so many bytes.
#[unsafe(no_mangle)]
pub extern "C" fn room(length: usize) -> *mut u8 {
    let mut request = request();
    request.clear();
    request.resize(length, 0);
    request.as_mut_ptr()
}

/// Answers the request, of which so many bytes are the name of what is asked for; a status of HTTP.
#[unsafe(no_mangle)]
pub extern "C" fn answer(name: usize) -> u32 {
    let request = mem::take(&mut *request());
    let (name, body) = request.split_at(name.min(request.len()));
    let listener = |event: String| {
        told(0, event.as_bytes());
        true
    };
    let export: Export = Box::new(|_, _, _, _| Err(NO_FIGURES.to_owned()));
    let name = String::from_utf8_lossy(name);
    let answered = grazing_explore::answer(&name, body, (&listener, clock), &export, &Stop::default());
    let (status, kind, content) = match answered {
        Ok((kind, content)) => (200, kind, content),
        Err((status, said)) => (status, "application/json", said.into_bytes()),
    };
    told(1, kind.as_bytes());
    told(2, &content);
    u32::from(status)
}

const NO_FIGURES: &str =
    "this page cannot make files of figures: the program can, by the command that is copied";
