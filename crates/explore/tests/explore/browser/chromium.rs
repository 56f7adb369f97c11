//! Chromium without a window, driven by its own protocol as a user drives it: by mouse and keys.

use std::fs;
use std::io::{BufRead, BufReader, Write};
use std::net::TcpStream;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::sync::{Arc, Mutex, PoisonError, Weak};
use std::thread::sleep;
use std::time::{Duration, Instant};

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde_json::{Value, json};
use tempfile::TempDir;
use tungstenite::stream::MaybeTlsStream;
use tungstenite::{Message, WebSocket};

/// The names under which systems have the browser.
const NAMES: [&str; 4] = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"];
/// Makes the page's modules available by name in expressions.
const USE: &str = "window.use ??= (...names) => Promise.all(names.map((name) => import(new URL(`./${name}.js`, document.baseURI))));";
/// Keys that do more than write a letter: name, number, and the text that they write.
const KEYS: [(&str, u32, &str); 10] = [
    ("Tab", 9, ""),
    ("Enter", 13, "\r"),
    ("Escape", 27, ""),
    (" ", 32, " "),
    ("End", 35, ""),
    ("Home", 36, ""),
    ("ArrowLeft", 37, ""),
    ("ArrowUp", 38, ""),
    ("ArrowRight", 39, ""),
    ("ArrowDown", 40, ""),
];
/// Keys that are held at the same time, in the protocol's numbers.
pub(crate) const CONTROL: u32 = 2;
pub(crate) const SHIFT: u32 = 8;

/// The time limit for conditions that tests wait for, far longer than anything takes on a busy machine.
const PATIENCE: Duration = Duration::from_secs(600);

/// The browser's process, which tests that run at once share.
struct Process {
    child: Child,
    endpoint: String,
    _profile: TempDir,
}

static RUNNING: Mutex<Weak<Process>> = Mutex::new(Weak::new());

impl Process {
    /// The running process, or a new one; none without a browser, with a message on the error stream.
    fn shared() -> Option<Arc<Self>> {
        let mut running = RUNNING.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(process) = running.upgrade() {
            return Some(process);
        }
        let profile = tempfile::tempdir().unwrap();
        let start = |name: &&str| {
            Command::new(name)
                .args(["--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage"])
                .args(["--no-first-run", "--disable-background-networking", "--remote-debugging-port=0"])
                // Every page is drawn as if it were in the foreground.
                .args(["--disable-background-timer-throttling", "--disable-renderer-backgrounding"])
                .arg("--disable-backgrounding-occluded-windows")
                .arg(format!("--user-data-dir={}", profile.path().display()))
                .stdout(Stdio::null())
                .stderr(Stdio::piped())
                .spawn()
                .ok()
        };
        let Some(mut child) = NAMES.iter().find_map(start) else {
            let line = "\nskipped: no Chromium here, so the page was not walked in\n";
            let _ = std::io::stderr().write_all(line.as_bytes());
            return None;
        };
        let lines = BufReader::new(child.stderr.take().unwrap()).lines();
        let endpoint = lines
            .map_while(Result::ok)
            .find_map(|line| Some(line.split_once("DevTools listening on ")?.1.to_owned()))
            .unwrap();
        let process = Arc::new(Self { child, endpoint, _profile: profile });
        *running = Arc::downgrade(&process);
        Some(process)
    }
}

impl Drop for Process {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// A page in a context of its own, which shares nothing with others.
pub(crate) struct Browser {
    socket: WebSocket<MaybeTlsStream<TcpStream>>,
    context: Value,
    session: String,
    count: u64,
    _process: Arc<Process>,
}

impl Browser {
    /// Opens a page in a window of this size; none without a browser.
    pub(crate) fn open(address: &str, [width, height]: [u32; 2]) -> Option<Self> {
        let process = Process::shared()?;
        let (socket, _) = tungstenite::connect(&process.endpoint).unwrap();
        if let MaybeTlsStream::Plain(stream) = socket.get_ref() {
            stream.set_read_timeout(Some(PATIENCE)).unwrap();
        }
        let (context, session) = (Value::Null, String::new());
        let mut browser = Self { socket, context, session, count: 0, _process: process };
        let context = json!({"disposeOnDetach": true});
        browser.context = browser.call("Target.createBrowserContext", context)["browserContextId"].clone();
        let target = json!({"url": "about:blank", "browserContextId": browser.context});
        let target = browser.call("Target.createTarget", target);
        let attached = json!({"targetId": target["targetId"], "flatten": true});
        browser.session =
            browser.call("Target.attachToTarget", attached)["sessionId"].as_str().unwrap().to_owned();
        let mobile = width < 500;
        let screen = json!({"width": width, "height": height, "deviceScaleFactor": 1, "mobile": mobile});
        browser.call("Emulation.setDeviceMetricsOverride", screen);
        browser.call("Emulation.setTouchEmulationEnabled", json!({"enabled": mobile, "maxTouchPoints": 2}));
        browser.call("Emulation.setScrollbarsHidden", json!({"hidden": true}));
        // As if its window had the focus.
        browser.call("Emulation.setFocusEmulationEnabled", json!({"enabled": true}));
        browser.go(address);
        Some(browser)
    }

    /// Leaves the page, and opens an address.
    pub(crate) fn go(&mut self, address: &str) {
        self.call("Page.navigate", json!({"url": "about:blank"}));
        self.call("Page.navigate", json!({ "url": address }));
    }

    fn call(&mut self, method: &str, parameters: Value) -> Value {
        self.answer(method, parameters).unwrap_or_else(|error| panic!("{method}: {error}"))
    }

    fn answer(&mut self, method: &str, parameters: Value) -> Result<Value, Value> {
        self.count += 1;
        let mut message = json!({"id": self.count, "method": method, "params": parameters});
        if !self.session.is_empty() {
            message["sessionId"] = json!(self.session);
        }
        self.socket.send(Message::text(message.to_string())).unwrap();
        loop {
            let Message::Text(text) = self.socket.read().unwrap() else { continue };
            let answer: Value = text.parse().unwrap();
            if answer["id"] == self.count {
                return answer
                    .get("error")
                    .map_or_else(|| Ok(answer["result"].clone()), |error| Err(error.clone()));
            }
        }
    }

    /// The value of an expression in the page.
    #[track_caller]
    pub(crate) fn value(&mut self, expression: &str) -> Value {
        self.evaluated(expression).unwrap_or_else(|exception| panic!("{expression}: {exception}"))
    }

    fn evaluated(&mut self, expression: &str) -> Result<Value, Value> {
        let expression = format!("{USE} {expression}");
        let asked = json!({"expression": expression, "returnByValue": true, "awaitPromise": true});
        let found = self.answer("Runtime.evaluate", asked)?;
        match found.get("exceptionDetails") {
            Some(exception) => Err(exception.clone()),
            None => Ok(found["result"]["value"].clone()),
        }
    }

    /// Waits until an expression is true, or anything that counts as true, and returns it.
    #[track_caller]
    pub(crate) fn wait(&mut self, expression: &str) -> Value {
        let began = Instant::now();
        loop {
            // While the page is being loaded, the expression fails.
            let found = self.evaluated(expression).unwrap_or(Value::Null);
            let true_enough = match &found {
                Value::Null | Value::Bool(false) => false,
                Value::String(text) => !text.is_empty(),
                _ => true,
            };
            if true_enough {
                return found;
            }
            if began.elapsed() > PATIENCE {
                let seen = self.value("document.body.innerText.slice(0, 2000)");
                panic!("{expression} is not true: {seen}");
            }
            sleep(Duration::from_millis(20));
        }
    }

    /// Records all texts that an element shows from now on in `noted`.
    pub(crate) fn note_words(&mut self, id: &str) {
        self.value(&format!(
            "(() => {{ const e = document.getElementById({id:?}); window.noted = []; \
             new MutationObserver(() => noted.push(e.textContent)).observe(e, {{childList: true, characterData: true, subtree: true}}); }})()"
        ));
    }

    /// The middle of an element.
    pub(crate) fn middle(&mut self, selector: &str) -> [f64; 2] {
        let expression = format!(
            "(() => {{ const e = document.querySelector({selector:?}); e.scrollIntoView({{block: \"nearest\", behavior: \"instant\"}}); const b = \
             e.getBoundingClientRect(); return [b.left + b.width / 2, b.top + b.height / 2]; }})()"
        );
        self.point(&expression)
    }

    /// The value of an expression that is a point.
    #[track_caller]
    pub(crate) fn point(&mut self, expression: &str) -> [f64; 2] {
        let found = self.value(expression);
        [0, 1].map(|index| found[index].as_f64().unwrap())
    }

    fn mouse(&mut self, kind: &str, [x, y]: [f64; 2], held: u32) {
        let button = if kind == "mouseMoved" { "none" } else { "left" };
        let event =
            json!({"type": kind, "x": x, "y": y, "button": button, "clickCount": 1, "modifiers": held});
        self.call("Input.dispatchMouseEvent", event);
    }

    /// Clicks on the middle of an element, or at an offset from there.
    pub(crate) fn click(&mut self, selector: &str, [across, down]: [f64; 2]) {
        let [x, y] = self.middle(selector);
        self.click_at([x + across, y + down]);
    }

    pub(crate) fn click_at(&mut self, spot: [f64; 2]) {
        for kind in ["mouseMoved", "mousePressed", "mouseReleased"] {
            self.mouse(kind, spot, 0);
        }
    }

    /// Moves the pointer.
    pub(crate) fn hover(&mut self, spot: [f64; 2]) {
        self.mouse("mouseMoved", spot, 0);
    }

    /// Drags from one spot to another in steps, with keys held, and does something after each.
    pub(crate) fn drag(
        &mut self,
        [from, to]: [[f64; 2]; 2],
        steps: u32,
        held: u32,
        mut each: impl FnMut(&mut Self),
    ) {
        self.mouse("mouseMoved", from, held);
        self.mouse("mousePressed", from, held);
        for step in 1..=steps {
            let part = f64::from(step) / f64::from(steps);
            let spot = [0, 1].map(|index| from[index] + part * (to[index] - from[index]));
            let event = json!({"type": "mouseMoved", "x": spot[0], "y": spot[1], "button": "left", "buttons": 1, "modifiers": held});
            self.call("Input.dispatchMouseEvent", event);
            each(self);
        }
        self.mouse("mouseReleased", to, held);
    }

    /// Puts a finger down, moves it in steps, and lifts it.
    pub(crate) fn touch(&mut self, [from, to]: [[f64; 2]; 2], steps: u32) {
        let at = |part: f64| json!([{"x": from[0] + part * (to[0] - from[0]), "y": from[1] + part * (to[1] - from[1])}]);
        self.call("Input.dispatchTouchEvent", json!({"type": "touchStart", "touchPoints": at(0.0)}));
        for step in 1..=steps {
            let points = at(f64::from(step) / f64::from(steps));
            self.call("Input.dispatchTouchEvent", json!({"type": "touchMove", "touchPoints": points}));
        }
        self.call("Input.dispatchTouchEvent", json!({"type": "touchEnd", "touchPoints": []}));
    }

    /// Puts fingers down, one after the other or at once, and moves them.
    pub(crate) fn fingers(&mut self, steps: &[&[[f64; 2]]]) {
        let mut down = 0;
        for fingers in steps {
            let points = fingers.iter().map(|[x, y]| json!({ "x": x, "y": y })).collect::<Vec<_>>();
            let kind = if points.len() > down { "touchStart" } else { "touchMove" };
            down = points.len();
            self.call("Input.dispatchTouchEvent", json!({"type": kind, "touchPoints": points}));
        }
        self.call("Input.dispatchTouchEvent", json!({"type": "touchEnd", "touchPoints": []}));
    }

    /// Turns the wheel at a spot.
    pub(crate) fn wheel(&mut self, [x, y]: [f64; 2], by: f64) {
        let event = json!({"type": "mouseWheel", "x": x, "y": y, "deltaX": 0, "deltaY": by});
        self.call("Input.dispatchMouseEvent", event);
    }

    /// Presses a key, as `ArrowRight` or `h`.
    pub(crate) fn press(&mut self, key: &str) {
        self.press_with(key, 0);
    }

    /// Presses a key while others are held.
    pub(crate) fn press_with(&mut self, key: &str, held: u32) {
        let known = KEYS.iter().find(|(name, ..)| *name == key);
        let (number, text) = known
            .map_or((0, if key.chars().count() == 1 { key } else { "" }), |(_, number, text)| {
                (*number, *text)
            });
        for kind in ["keyDown", "keyUp"] {
            let text = if kind == "keyDown" { text } else { "" };
            let event = json!({"type": kind, "key": key, "text": text, "modifiers": held, "windowsVirtualKeyCode": number});
            self.call("Input.dispatchKeyEvent", event);
        }
    }

    /// Types a text where the focus is.
    pub(crate) fn write(&mut self, text: &str) {
        self.call("Input.insertText", json!({ "text": text }));
    }

    /// Sets a preference of the user: `prefers-color-scheme`, `prefers-reduced-motion`.
    pub(crate) fn prefer(&mut self, name: &str, value: &str) {
        self.call("Emulation.setEmulatedMedia", json!({"features": [{"name": name, "value": value}]}));
    }

    /// The tree of a screen reader: role, name and value of all visible elements.
    pub(crate) fn told(&mut self) -> Vec<[String; 3]> {
        let tree = self.call("Accessibility.getFullAXTree", json!({}));
        let text = |value: &Value| match &value["value"] {
            Value::String(text) => text.clone(),
            Value::Null => String::new(),
            other => other.to_string(),
        };
        let nodes = tree["nodes"].as_array().unwrap().iter().filter(|node| node["ignored"] != true);
        nodes.map(|node| ["role", "name", "value"].map(|key| text(&node[key]))).collect()
    }

    /// Allows reading the clipboard, and saves downloads in a folder.
    pub(crate) fn permit(&mut self, folder: &Path) {
        let permissions = ["clipboardReadWrite", "clipboardSanitizedWrite"];
        let granted = json!({"permissions": permissions, "browserContextId": self.context});
        self.call("Browser.grantPermissions", granted);
        let saved = json!({"behavior": "allow", "downloadPath": folder, "browserContextId": self.context});
        self.call("Browser.setDownloadBehavior", saved);
    }

    /// The printed page, as PDF.
    #[allow(dead_code)] // Where only the explorer is tested.
    pub(crate) fn printed(&mut self) -> Vec<u8> {
        let printed = self.call("Page.printToPDF", json!({}));
        STANDARD.decode(printed["data"].as_str().unwrap()).unwrap()
    }

    /// A picture of the window, as WebP.
    pub(crate) fn picture(&mut self) -> Vec<u8> {
        let taken = self.call("Page.captureScreenshot", json!({"format": "webp", "quality": 80}));
        STANDARD.decode(taken["data"].as_str().unwrap()).unwrap()
    }
}

/// A file in a folder, as soon as it is there; the browser gives it another name until it is complete.
#[track_caller]
pub(crate) fn saved(folder: &Path, name: &str) -> Vec<u8> {
    let began = Instant::now();
    loop {
        match fs::read(folder.join(name)) {
            Ok(content) => return content,
            Err(error) => assert!(began.elapsed() < PATIENCE, "{name}: {error}"),
        }
        sleep(Duration::from_millis(20));
    }
}
