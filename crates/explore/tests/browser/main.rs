//! The page in a real browser: each of its abilities by mouse, by keys alone, and on a phone's screen.

mod access;
mod chromium;
mod constants;
mod file;
mod film;
mod overlay;
mod places;
mod plane;

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::{self, JoinHandle};

use chromium::Browser;
use grazing_explore::{Example, Limits, Server, Sheet};
use serde_json::Value;

/// A window on a desk, and a phone's.
const DESK: [u32; 2] = [1400, 900];
const PHONE: [u32; 2] = [360, 740];

/// A server with the paper's oscillator and a file.
struct Running {
    address: String,
    ended: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

impl Running {
    fn new() -> Self {
        Self::with(Limits::default())
    }

    fn with(limits: Limits) -> Self {
        let text = include_str!("../../../../examples/duffing.toml").to_owned();
        let examples = vec![
            Example { name: "Paper".to_owned(), file: String::new(), text: None },
            Example { name: "Duffing".to_owned(), file: "duffing.toml".to_owned(), text: Some(text) },
        ];
        let export = |_: &_, _: &_, what: &str, _: &str, _: &_| {
            Ok(Sheet { name: "taken".to_owned(), kind: "text/csv", content: what.as_bytes().to_vec() })
        };
        let server = Server::bind(0, limits, examples, Box::new(export)).unwrap();
        let address = server.address();
        let ended = Arc::new(AtomicBool::new(false));
        let asked = ended.clone();
        let thread = thread::spawn(move || server.run(|| asked.load(Ordering::Relaxed), || false).unwrap());
        Self { address, ended, thread: Some(thread) }
    }

    /// The page, once the paper's diagram is whole.
    fn open(&self, window: [u32; 2]) -> Option<Browser> {
        let mut page = Browser::open(&self.address, window)?;
        page.wait(WHOLE);
        Some(page)
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        self.ended.store(true, Ordering::Relaxed);
        if let Some(thread) = self.thread.take() {
            thread.join().unwrap();
        }
    }
}

/// The diagram is whole, and what is said of it.
const WHOLE: &str = "/curves? and \\d+ points? in/.test(document.getElementById('progress-text').textContent) && \
                     document.getElementById('progress-text').textContent";
/// What is said of the place, once it is known.
const PLACE: &str = "use('state').then(([s]) => !document.querySelector('.place[aria-busy]') && \
                     /\\d %/.test(document.getElementById('places').textContent) && s.get().place && \
                     document.getElementById('places').textContent)";

/// An entry of the page's state.
fn state(page: &mut Browser, name: &str) -> Value {
    page.value(&format!("use('state').then(([s]) => s.get().{name})"))
}

/// Numbers of the page's state.
fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect()
}

/// Where on the screen a place of the plane is.
fn spot(page: &mut Browser, [primary, secondary]: [f64; 2]) -> [f64; 2] {
    page.value("document.getElementById('stage').scrollIntoView({block: 'nearest', behavior: 'instant'})");
    page.point(&format!(
        "use('plane', 'model', 'state').then(([p, m, s]) => {{ const b = document.getElementById('plane').getBoundingClientRect(); \
         const [x, y] = p.project(m.viewOf(s.get()))([{primary}, {secondary}]); return [b.left + x, b.top + y]; }})"
    ))
}

/// What is known of the curves that are continued: key, kind and points of each.
const CURVES: &str = "use('diagram').then(([d]) => [...d.diagram.curves.values()].filter(({source}) => source !== 'quadratic')\
                      .map(({key, kind, n, points}) => ({key, kind, n, points})).sort((a, b) => (a.key < b.key ? -1 : 1)))";

/// The keys of these curves.
fn keys(curves: &Value) -> Vec<&str> {
    curves.as_array().unwrap().iter().map(|curve| curve["key"].as_str().unwrap()).collect()
}

/// Presses a key of the plane.
fn plane_key(page: &mut Browser, key: &str) {
    page.value("document.getElementById('plane').focus()");
    page.press(key);
}

/// Chooses the file in the menu, which begins with the paper.
fn choose_duffing(page: &mut Browser) {
    page.value("document.getElementById('oscillator').focus()");
    page.press("ArrowDown");
    page.wait("/Duffing/.test(document.title)");
}
