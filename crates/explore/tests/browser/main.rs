//! The page in a real browser, by mouse, by keys, and on a phone's screen.

mod chromium;

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::{self, JoinHandle};

use chromium::Browser;
use grazing_explore::{Example, Limits, Server, Sheet};

/// A server with the paper's oscillator and a file.
struct Running {
    address: String,
    ended: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

impl Running {
    fn new() -> Self {
        let text = include_str!("../../../../examples/duffing.toml").to_owned();
        let examples = vec![
            Example { name: "Paper".to_owned(), file: String::new(), text: None },
            Example { name: "Duffing".to_owned(), file: "duffing.toml".to_owned(), text: Some(text) },
        ];
        let export = |_: &_, _: &_, what: &str, _: &str, _: &_| {
            Ok(Sheet { name: "taken".to_owned(), kind: "text/csv", content: what.as_bytes().to_vec() })
        };
        let server = Server::bind(0, Limits::default(), examples, Box::new(export)).unwrap();
        let address = server.address();
        let ended = Arc::new(AtomicBool::new(false));
        let asked = ended.clone();
        let thread = thread::spawn(move || server.run(|| asked.load(Ordering::Relaxed), || false).unwrap());
        Self { address, ended, thread: Some(thread) }
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

/// The diagram is whole.
const WHOLE: &str = "/curves and \\d+ points in/.test(document.getElementById('progress-text').textContent) && \
                     document.getElementById('progress-text').textContent";
/// What is said of the place, once it is known.
const PLACE: &str = "/\\d %/.test(document.getElementById('places').textContent) && document.getElementById('places').textContent";

#[test]
fn the_plane_is_walked_in_by_mouse() {
    let server = Running::new();
    let Some(mut page) = Browser::open(&server.address, [1400, 900]) else { return };
    page.wait(WHOLE);
    assert_eq!(page.value("document.getElementById('resonances-count').textContent"), "15");
    // Far above grazing, at a high frequency, everything comes to a solution of one loop.
    page.click("#plane", [200.0, -200.0]);
    let place = page.wait(PLACE);
    assert!(place.as_str().unwrap().contains("MPS, 1 loop"), "{place}");
    // Below grazing nothing hits the wall.
    page.click("#plane", [-350.0, 100.0]);
    page.wait(&format!("/No impacts/.test({PLACE})"));
    let before = page.value("location.hash");
    page.wheel("#plane", -300.0);
    page.wait(&format!("location.hash !== {before} && {WHOLE}"));
    page.click("[data-command=whole]", [0.0, 0.0]);
    page.wait(WHOLE);
    // Simulation is laid under the curves and agrees with the shading.
    page.click("[data-command=overlay]", [0.0, 0.0]);
    page.wait("/[1-9]/.test(document.getElementById('tiles-status').textContent)");
}

#[test]
fn keys_alone_are_enough_and_the_address_holds_what_is_seen() {
    let server = Running::new();
    let Some(mut page) = Browser::open(&server.address, [1000, 800]) else { return };
    page.wait(WHOLE);
    page.value("document.getElementById('plane').focus()");
    for _ in 0..3 {
        page.press("ArrowRight");
    }
    let place = page.wait(PLACE);
    page.press("h");
    page.wait(
        "!document.getElementById('cut-panel').hidden && document.getElementById('cut-message').hidden",
    );
    page.press("+");
    page.wait(WHOLE);
    page.wait("location.hash.length > 20");
    // The address follows once what is seen has come to rest.
    let seen = page.value("new Promise(told => setTimeout(() => told(location.hash), 1500))");
    let seen = seen.as_str().unwrap().to_owned();
    // The same address somewhere else shows the same.
    let heading =
        page.value("document.querySelector('#places h3, #places .at, #places')?.textContent.slice(0, 24)");
    page.go("about:blank");
    page.wait("location.href === 'about:blank'");
    page.go(&format!("{}{seen}", server.address));
    page.wait(WHOLE);
    page.wait(PLACE);
    let again =
        page.value("document.querySelector('#places h3, #places .at, #places')?.textContent.slice(0, 24)");
    assert_eq!(heading, again, "{place}");
    assert_eq!(page.value("location.hash"), seen.as_str());
    page.value("document.getElementById('plane').focus()");
    page.press("?");
    page.wait("document.getElementById('help').open");
    page.press("Escape");
}

#[test]
fn on_a_phone_nothing_is_wider_than_the_screen() {
    let server = Running::new();
    let Some(mut page) = Browser::open(&server.address, [360, 740]) else { return };
    page.wait(WHOLE);
    assert_eq!(page.value("document.documentElement.scrollWidth"), 360);
    let small = "[...document.querySelectorAll('button')].filter(b => b.offsetParent && Math.min(b.offsetWidth, \
                 b.offsetHeight) < 24).length";
    assert_eq!(page.value(small), 0);
}

#[test]
fn a_mistake_in_the_file_is_told_with_its_line() {
    let server = Running::new();
    let Some(mut page) = Browser::open(&server.address, [1400, 900]) else { return };
    page.wait(WHOLE);
    page.value(
        "(() => { const s = document.getElementById('oscillator'); s.selectedIndex = [...s.options].findIndex(o => \
         o.textContent.includes('Duffing')); s.dispatchEvent(new Event('change', {bubbles: true})); })()",
    );
    page.click("[data-command=edit]", [0.0, 0.0]);
    page.wait("document.getElementById('text').value.includes('kappa*x^3')");
    page.value(
        "(() => { const t = document.getElementById('text'); t.value = t.value.replace('kappa*x^3', 'kapa*x^3'); \
         t.dispatchEvent(new Event('input', {bubbles: true})); })()",
    );
    page.wait("/unknown name kapa/.test(document.getElementById('verdict').textContent)");
}
