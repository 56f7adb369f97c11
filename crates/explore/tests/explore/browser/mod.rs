//! The page in a real browser: each of its functions by mouse, by keys alone, and on a phone's screen.

mod access;
mod beside;
mod chromium;
mod constants;
mod crowd;
mod file;
mod film;
mod load;
mod overlay;
mod places;
mod plane;

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, LazyLock};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use self::chromium::Browser;
use grazing_explore::{Example, ExportedFile, Limits, Server};
use serde_json::Value;

/// The windows of a desktop computer and of a phone.
const DESK: [u32; 2] = [1400, 900];
const PHONE: [u32; 2] = [360, 740];
/// A time longer than any computation takes on a busy machine.
const HOUR: Duration = Duration::from_secs(3600);

/// A server with the paper's oscillator and a file.
struct Running {
    address: String,
    ended: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

impl Running {
    /// The server of all tests for which it does not matter that a diagram is known already: it sends the whole
    /// diagram at once that many of them begin with.
    fn shared() -> &'static Self {
        static SHARED: LazyLock<Running> = LazyLock::new(Running::new);
        &SHARED
    }

    /// A server that knows no diagram yet.
    fn new() -> Self {
        Self::with(Limits { time: HOUR, patience: HOUR, ..Limits::default() })
    }

    fn with(limits: Limits) -> Self {
        // With one number of loops it is soon there.
        let text =
            include_str!("../../../../../examples/duffing.toml").replace("loops = [1, 2, 3]", "loops = [1]");
        let examples = vec![
            Example { name: "Paper".to_owned(), file: String::new(), text: None },
            Example { name: "Duffing".to_owned(), file: "duffing.toml".to_owned(), text: Some(text) },
        ];
        let export = |_: &_, what: &str, _: &str, _: &_| {
            Ok(ExportedFile { name: "taken".to_owned(), kind: "text/csv", content: what.as_bytes().to_vec() })
        };
        let server = Server::bind(0, limits, "cargo xtask", examples, Box::new(export)).unwrap();
        let address = server.address();
        let ended = Arc::new(AtomicBool::new(false));
        let asked = ended.clone();
        let thread = thread::spawn(move || server.run(|| asked.load(Ordering::Relaxed), || None).unwrap());
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

/// The page is idle: no timer runs, no answer is expected, no frame is to be drawn.
const QUIET: &str = "!document.documentElement.hasAttribute('data-busy')";
/// The text about the diagram, once the diagram is complete and the page idle.
const WHOLE: &str = "!document.documentElement.hasAttribute('data-busy') && /curves? and \\d+ points? in/.test(document.getElementById('progress-text').textContent) && \
                     document.getElementById('progress-text').textContent";
/// Holds back diagrams that are requested from now on, once there are curves and work to do, until `letGo()`.
const HOLD: &str = "(() => { const held = new Promise((go) => (window.letGo = go)); const ask = window.fetch.bind(window); \
                    window.fetch = async (path, options) => { const answer = await ask(path, options); if (path !== './diagram') return answer; \
                    let [rest, curves] = ['', false]; const [to, from] = [new TextEncoder(), new TextDecoder()]; \
                    const gate = new TransformStream({ async transform(chunk, out) { const events = (rest + from.decode(chunk, {stream: true})).split('\\n\\n'); \
                    rest = events.pop(); for (const event of events) { out.enqueue(to.encode(`${event}\\n\\n`)); curves ||= event.startsWith('event: curves'); \
                    if (curves && /^event: progress/.test(event) && /\"all\":[1-9]/.test(event)) await held; } } }); \
                    return new Response(answer.body.pipeThrough(gate), {status: answer.status}); }; })()";
/// The text about the place, once it is known and the page is idle.
const PLACE: &str = "!document.documentElement.hasAttribute('data-busy') && use('state').then(([s]) => !document.querySelector('.place[aria-busy]') && \
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

/// The place on the screen of a place of the plane.
fn spot(page: &mut Browser, [primary, secondary]: [f64; 2]) -> [f64; 2] {
    page.value("document.getElementById('stage').scrollIntoView({block: 'nearest', behavior: 'instant'})");
    page.point(&format!(
        "use('plane', 'model', 'state').then(([p, m, s]) => {{ const b = document.getElementById('plane').getBoundingClientRect(); \
         const [x, y] = p.project(m.viewOf(s.get()))([{primary}, {secondary}]); return [b.left + x, b.top + y]; }})"
    ))
}

/// The curves that are continued: key, kind and points of each.
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
