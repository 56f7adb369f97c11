//! Chromium without a window, driven by its own protocol as a person drives it: by mouse and keys.

use std::io::{BufRead, BufReader, Write};
use std::net::TcpStream;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use serde_json::{Value, json};
use tempfile::TempDir;
use tungstenite::stream::MaybeTlsStream;
use tungstenite::{Message, WebSocket};

/// The names under which systems have the browser.
const NAMES: [&str; 4] = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"];
/// Longer than anything takes on a busy machine.
const PATIENCE: Duration = Duration::from_secs(90);

/// A browser with one page.
pub(crate) struct Browser {
    process: Child,
    socket: WebSocket<MaybeTlsStream<TcpStream>>,
    session: String,
    count: u64,
    _profile: TempDir,
}

impl Browser {
    /// Opens a page in a window of this size; nothing where there is no browser, which is said on the error stream.
    pub(crate) fn open(address: &str, [width, height]: [u32; 2]) -> Option<Self> {
        let profile = tempfile::tempdir().unwrap();
        let start = |name: &&str| {
            Command::new(name)
                .args(["--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage"])
                .args(["--no-first-run", "--disable-background-networking", "--remote-debugging-port=0"])
                .arg(format!("--user-data-dir={}", profile.path().display()))
                .stdout(Stdio::null())
                .stderr(Stdio::piped())
                .spawn()
                .ok()
        };
        let Some(mut process) = NAMES.iter().find_map(start) else {
            let line = "\nskipped: no Chromium here, so the page was not walked in\n";
            let _ = std::io::stderr().write_all(line.as_bytes());
            return None;
        };
        let lines = BufReader::new(process.stderr.take().unwrap()).lines();
        let endpoint = lines
            .map_while(Result::ok)
            .find_map(|line| Some(line.split_once("DevTools listening on ")?.1.to_owned()))
            .unwrap();
        let (socket, _) = tungstenite::connect(endpoint).unwrap();
        let mut browser = Self { process, socket, session: String::new(), count: 0, _profile: profile };
        let target = browser.call("Target.createTarget", json!({"url": "about:blank"}));
        let attached = json!({"targetId": target["targetId"], "flatten": true});
        browser.session =
            browser.call("Target.attachToTarget", attached)["sessionId"].as_str().unwrap().to_owned();
        let mobile = width < 500;
        let screen = json!({"width": width, "height": height, "deviceScaleFactor": 1, "mobile": mobile});
        browser.call("Emulation.setDeviceMetricsOverride", screen);
        browser.go(address);
        Some(browser)
    }

    pub(crate) fn go(&mut self, address: &str) {
        self.call("Page.navigate", json!({ "url": address }));
    }

    fn call(&mut self, method: &str, parameters: Value) -> Value {
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
                assert!(answer.get("error").is_none(), "{method}: {}", answer["error"]);
                return answer["result"].clone();
            }
        }
    }

    /// The value of an expression in the page.
    #[track_caller]
    pub(crate) fn value(&mut self, expression: &str) -> Value {
        self.evaluated(expression).unwrap_or_else(|exception| panic!("{expression}: {exception}"))
    }

    fn evaluated(&mut self, expression: &str) -> Result<Value, Value> {
        let asked = json!({"expression": expression, "returnByValue": true, "awaitPromise": true});
        let found = self.call("Runtime.evaluate", asked);
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
            // While the page is being loaded, what is asked about is not there.
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
            sleep(Duration::from_millis(50));
        }
    }

    /// The middle of an element.
    fn middle(&mut self, selector: &str) -> [f64; 2] {
        let expression = format!(
            "(() => {{ const e = document.querySelector({selector:?}); e.scrollIntoView({{block: \"nearest\"}}); const b = \
             e.getBoundingClientRect(); return [b.left + b.width / 2, b.top + b.height / 2]; }})()"
        );
        let found = self.value(&expression);
        [0, 1].map(|index| found[index].as_f64().unwrap())
    }

    fn mouse(&mut self, kind: &str, [x, y]: [f64; 2]) {
        let button = if kind == "mouseMoved" { "none" } else { "left" };
        let event = json!({"type": kind, "x": x, "y": y, "button": button, "clickCount": 1});
        self.call("Input.dispatchMouseEvent", event);
    }

    /// Clicks on the middle of an element, or so far from there.
    pub(crate) fn click(&mut self, selector: &str, [across, down]: [f64; 2]) {
        let [x, y] = self.middle(selector);
        let spot = [x + across, y + down];
        for kind in ["mouseMoved", "mousePressed", "mouseReleased"] {
            self.mouse(kind, spot);
        }
    }

    /// Turns the wheel over the middle of an element.
    pub(crate) fn wheel(&mut self, selector: &str, by: f64) {
        let [x, y] = self.middle(selector);
        let event = json!({"type": "mouseWheel", "x": x, "y": y, "deltaX": 0, "deltaY": by});
        self.call("Input.dispatchMouseEvent", event);
    }

    /// Presses a key, as `ArrowRight` or `h`.
    pub(crate) fn press(&mut self, key: &str) {
        let text = if key.chars().count() == 1 { key } else { "" };
        for kind in ["keyDown", "keyUp"] {
            let text = if kind == "keyDown" { text } else { "" };
            self.call("Input.dispatchKeyEvent", json!({"type": kind, "key": key, "text": text}));
        }
    }
}

impl Drop for Browser {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}
