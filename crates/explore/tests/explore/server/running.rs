//! A server for tests, and requests to it.

use std::io::{Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use grazing_explore::{Example, Export, ExportedFile, Limits, Server};
use grazing_model::smooth::Stop;
use serde_json::Value;

/// A server that runs until it is dropped.
pub(crate) struct Running {
    pub(crate) address: SocketAddr,
    pub(crate) path: String,
    ended: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

/// A time far longer than anything takes on a busy machine, which ends what hangs.
pub(crate) const BACKSTOP: Duration = Duration::from_secs(600);

/// Small limits, so that they are reached, except those of time, which a busy machine must not reach.
pub(crate) const LIMITS: Limits = Limits {
    connections: 64,
    computations: 2,
    light: 2,
    body: 100_000,
    patience: BACKSTOP,
    time: Duration::from_secs(3600),
    grace: Duration::from_secs(3600),
    steps: 1_000_000_000,
    memory: 1000.0,
    growth: 100.0,
};

impl Running {
    pub(crate) fn new(limits: Limits) -> Self {
        Self::with_memory(limits, || None)
    }

    pub(crate) fn with_memory(limits: Limits, held: impl Fn() -> Option<f64> + Send + 'static) -> Self {
        let export = |_: &_, what: &str, _: &str, _: &Stop| match what {
            "csv:a" => {
                Ok(ExportedFile { name: "a.csv".to_owned(), kind: "text/csv", content: b"1\n".to_vec() })
            }
            other => Err(format!("{other} is not made")),
        };
        Self::with(limits, Box::new(export), held)
    }

    pub(crate) fn with(
        limits: Limits,
        export: Export,
        held: impl Fn() -> Option<f64> + Send + 'static,
    ) -> Self {
        let example = Example { name: "Paper".to_owned(), file: String::new(), text: None };
        let server = Server::bind(0, limits, "cargo xtask", vec![example], export).unwrap();
        let address = server.address();
        let rest = address.strip_prefix("http://").unwrap();
        let (host, path) = rest.split_once('/').unwrap();
        let (address, path) = (host.parse().unwrap(), format!("/{path}"));
        let ended = Arc::new(AtomicBool::new(false));
        let asked = ended.clone();
        let thread = thread::spawn(move || server.run(|| asked.load(Ordering::Relaxed), held).unwrap());
        Self { address, path, ended, thread: Some(thread) }
    }

    pub(crate) fn connect(&self) -> TcpStream {
        let stream = TcpStream::connect(self.address).unwrap();
        stream.set_read_timeout(Some(BACKSTOP)).unwrap();
        stream
    }

    pub(crate) fn head(&self, method: &str, path: &str, more: &str) -> String {
        format!("{method} {path} HTTP/1.1\r\nHost: {}\r\nConnection: close\r\n{more}\r\n", self.address)
    }

    /// Sends a request and reads the answer: its status, head and body.
    pub(crate) fn ask(&self, request: &[u8]) -> (u16, String, String) {
        let mut stream = self.connect();
        // A request that is rejected need not be read to its end.
        let _ = stream.write_all(request);
        let mut answer = Vec::new();
        let _ = stream.read_to_end(&mut answer);
        let text = String::from_utf8_lossy(&answer).into_owned();
        let (head, body) = text.split_once("\r\n\r\n").unwrap_or((&text, ""));
        let status = head.split(' ').nth(1).and_then(|code| code.parse().ok()).unwrap_or(0);
        let body = if head.contains("transfer-encoding: chunked") { chunks(body) } else { body.to_owned() };
        (status, head.to_owned(), body)
    }

    pub(crate) fn post(&self, name: &str, body: &str) -> (u16, String) {
        let (status, _, body) = self.ask(self.request(name, body).as_bytes());
        (status, body)
    }

    /// A request for a computation.
    pub(crate) fn request(&self, name: &str, body: &str) -> String {
        let more = format!("Content-Type: application/json\r\nContent-Length: {}\r\n", body.len());
        format!("{}{body}", self.head("POST", &format!("{}{name}", self.path), &more))
    }

    /// Sends a request without reading the answer.
    pub(crate) fn begin(&self, name: &str, body: &str) -> TcpStream {
        let mut stream = self.connect();
        stream.write_all(self.request(name, body).as_bytes()).unwrap();
        stream
    }

    pub(crate) fn get(&self, path: &str) -> u16 {
        self.ask(self.head("GET", path, "").as_bytes()).0
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

/// A body that was sent in pieces.
fn chunks(mut body: &str) -> String {
    let mut whole = String::new();
    while let Some((length, rest)) = body.split_once("\r\n") {
        let Ok(length) = usize::from_str_radix(length.trim(), 16) else { break };
        let Some(piece) = rest.get(..length) else { break };
        whole.push_str(piece);
        body = rest.get(length + 2..).unwrap_or("");
    }
    whole
}

/// The data of the events with a name.
pub(crate) fn events(stream: &str, name: &str) -> Vec<Value> {
    let event = |text: &str| {
        let (first, data) = text.split_once('\n')?;
        (first == format!("event: {name}")).then(|| data.strip_prefix("data: ")?.parse().ok())?
    };
    stream.split("\n\n").filter_map(event).collect()
}
