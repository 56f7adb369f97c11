//! The program for a page without a server: it answers the requests of `grazing explore` in a
//! worker of the page itself.
//!
//! A request is written to the memory that [`room`] returns, with the last part of its path first,
//! and [`answer`]ed. All output goes through `tell` while it is computed.

use core::mem;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use grazing_explore::Export;
use grazing_model::smooth::Stop;

#[link(wasm_import_module = "page")]
unsafe extern "C" {
    /// Takes a part of the output: an event (0), or the answer's media type (1) or content (2).
    fn tell(what: u32, at: *const u8, length: usize);
    /// Seconds since an arbitrary instant.
    safe fn now() -> f64;
}

/// The request that is answered next.
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

/// Memory for a request of this many bytes.
#[unsafe(no_mangle)]
pub extern "C" fn room(length: usize) -> *mut u8 {
    let mut request = request();
    request.clear();
    request.resize(length, 0);
    request.as_mut_ptr()
}

/// Answers the request, whose first `name` bytes are the name of the computation; returns a status of HTTP.
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
