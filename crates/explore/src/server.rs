//! Connections, and the routes of requests.

use std::collections::VecDeque;
use std::convert::Infallible;
use std::io;
use std::net::{Ipv4Addr, TcpListener};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use http_body_util::{BodyExt, LengthLimitError, Limited};
use hyper::body::{Bytes, Incoming};
use hyper::header::CONTENT_TYPE;
use hyper::server::conn::http1;
use hyper::service::service_fn;
use hyper::{Method, Request, Response};
use hyper_util::rt::TokioTimer;
use tokio::runtime::Builder;
use tokio::sync::{OwnedSemaphorePermit, Semaphore, oneshot};
use tokio::time::{interval, timeout};

use crate::answer::Problem;
use crate::asked::{self, Asked, Export, Weight};
use crate::files::{self, Example};
use crate::kept::Kept;

mod guard;
mod patient;
mod response;
mod stream;
mod turns;

use guard::Token;
use patient::Patient;
use response::Body;
pub use turns::Limits;
use turns::Turns;

/// A server that is bound to its port, and does not run yet.
pub struct Server {
    listener: TcpListener,
    shared: Arc<Shared>,
}

/// The state that all requests share.
struct Shared {
    port: u16,
    token: Token,
    /// The command that starts the program, for commands that are copied.
    program: &'static str,
    examples: Vec<Example>,
    export: Export,
    turns: Arc<Turns>,
    kept: Arc<Kept>,
}

impl Server {
    /// Binds to a port of the loopback interface; 0 stands for any free one. `program` is the
    /// command that starts the program, `cargo xtask` or `grazing`.
    ///
    /// # Errors
    /// The port is taken or forbidden.
    pub fn bind(
        port: u16,
        limits: Limits,
        program: &'static str,
        examples: Vec<Example>,
        export: Export,
    ) -> io::Result<Self> {
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, port))?;
        listener.set_nonblocking(true)?;
        let shared = Shared {
            port: listener.local_addr()?.port(),
            token: Token::random()?,
            program,
            examples,
            export,
            turns: Arc::new(Turns::new(limits)?),
            kept: Arc::new(Kept::none()),
        };
        Ok(Self { listener, shared: Arc::new(shared) })
    }

    /// The address of the page.
    pub fn address(&self) -> String {
        format!("http://127.0.0.1:{}/{}/", self.shared.port, self.shared.token.text())
    }

    /// Answers requests until `ended` is true, which is checked several times a second; running
    /// computations then end at once. `held` is the number of megabytes that the process holds, where
    /// the system reports it.
    ///
    /// # Errors
    /// There are no threads.
    pub fn run(self, ended: impl Fn() -> bool, held: impl Fn() -> Option<f64>) -> io::Result<()> {
        let Self { listener, shared } = self;
        let note_memory = || held().into_iter().for_each(|held| shared.turns.note_memory(held));
        note_memory();
        // One thread for connections; computations have theirs, and within them rayon's.
        let runtime = Builder::new_multi_thread()
            .worker_threads(1)
            .max_blocking_threads(shared.turns.limits.connections)
            .enable_all()
            .build()?;
        runtime.block_on(async {
            let listener = tokio::net::TcpListener::from_std(listener)?;
            let places = Arc::new(Semaphore::new(shared.turns.limits.connections));
            let mut strangers = Strangers::new(shared.turns.limits.connections / 2);
            let mut pause = interval(PAUSE);
            loop {
                let accepted = tokio::select! {
                    accepted = listener.accept() => accepted,
                    _ = pause.tick() => {
                        if ended() {
                            break;
                        }
                        note_memory();
                        continue;
                    }
                };
                // A connection that fails does not affect others.
                let Ok((stream, _)) = accepted else { continue };
                let (is_known, closed) = strangers.admit();
                // A connection that is one too many is closed; one that was closed for this one gives its place soon.
                let place = timeout(PAUSE, places.clone().acquire_owned()).await;
                let Ok(Ok(place)) = place else { continue };
                let stream = Patient::new(stream, shared.turns.limits.patience);
                tokio::spawn(connection(stream, shared.clone(), place, is_known, closed));
            }
            shared.turns.end_all();
            Ok::<_, io::Error>(())
        })?;
        runtime.shutdown_timeout(GRACE);
        Ok(())
    }
}

/// The interval at which the end is checked, and the time that computations then have to notice it.
const PAUSE: Duration = Duration::from_millis(50);
const GRACE: Duration = Duration::from_millis(500);

/// Connections that have not shown the token. They get half of the places: the oldest one is closed for one
/// more, so that whoever opens connections without the token never keeps the page from its server.
struct Strangers {
    most: usize,
    /// Whether each has shown the token since, and what closes it when it is dropped.
    waiting: VecDeque<(Arc<AtomicBool>, oneshot::Sender<()>)>,
}

impl Strangers {
    fn new(most: usize) -> Self {
        Self { most: most.max(1), waiting: VecDeque::new() }
    }

    /// The mark of a new connection for having shown the token, and what closes it.
    fn admit(&mut self) -> (Arc<AtomicBool>, oneshot::Receiver<()>) {
        self.waiting.retain(|(is_known, close)| !is_known.load(Ordering::Relaxed) && !close.is_closed());
        if self.waiting.len() >= self.most {
            self.waiting.pop_front();
        }
        let (is_known, (close, closed)) = (Arc::<AtomicBool>::default(), oneshot::channel());
        self.waiting.push_back((is_known.clone(), close));
        (is_known, closed)
    }
}

async fn connection(
    stream: Patient,
    shared: Arc<Shared>,
    _place: OwnedSemaphorePermit,
    is_known: Arc<AtomicBool>,
    closed: oneshot::Receiver<()>,
) {
    let patience = shared.turns.limits.patience;
    let shown = is_known.clone();
    let service = service_fn(move |request: Request<Incoming>| {
        let (shared, shown) = (shared.clone(), shown.clone());
        async move {
            if shared.token.rest(request.uri().path()).is_some() {
                shown.store(true, Ordering::Relaxed);
            }
            let mut response =
                respond(&shared, request).await.unwrap_or_else(|problem| response::refused(&problem));
            guard::headers(response.headers_mut());
            Ok::<_, Infallible>(response)
        }
    });
    let served = http1::Builder::new()
        .timer(TokioTimer::new())
        .header_read_timeout(patience)
        .max_buf_size(HEAD)
        .serve_connection(stream, service);
    let as_a_stranger = async {
        let _ = closed.await;
        if is_known.load(Ordering::Relaxed) {
            std::future::pending::<()>().await;
        }
    };
    // A client that disconnects in the middle of an answer needs no error.
    tokio::select! {
        _ = served => {}
        () = as_a_stranger => {}
    }
}

/// The most bytes of the head of a request.
const HEAD: usize = 16 * 1024;

async fn respond(shared: &Arc<Shared>, request: Request<Incoming>) -> Result<Response<Body>, Problem> {
    if !guard::is_own(request.uri(), request.headers(), shared.port) {
        return Err(Problem::new(403, "this page is not allowed to send requests here"));
    }
    let nothing = || Problem::new(404, "not found");
    let path = request.uri().path().to_owned();
    let rest = shared.token.rest(&path).ok_or_else(nothing)?;
    if request.method() == Method::GET {
        return match rest {
            files::EXAMPLES => Ok(response::json(files::examples(shared.program, &shared.examples))),
            file => {
                let (kind, content) = files::page(file).ok_or_else(nothing)?;
                Ok(response::of_kind(kind, content))
            }
        };
    }
    if request.method() != Method::POST {
        return Err(Problem::new(405, "only GET and POST are supported"));
    }
    // Forms of foreign pages cannot send this type.
    let json = request.headers().get(CONTENT_TYPE).is_some_and(|kind| kind == asked::JSON);
    if !json {
        return Err(Problem::new(415, "requests must be application/json"));
    }
    let read = asked::reader(rest).ok_or_else(nothing)?;
    let body = body(shared, request).await?;
    match read(&body).map_err(|error| Problem::unread(&error))? {
        Asked::One(weight, compute) => {
            Ok(response::json(turns::computed(&shared.turns, weight, compute).await?))
        }
        Asked::Told(compute) => stream::events(&shared.turns, shared.kept.clone(), compute).await,
        Asked::File(request) => {
            let own = shared.clone();
            let made = turns::computed(&shared.turns, Weight::Heavy, move |stop| {
                asked::file(&request, &own.export, stop)
            });
            response::file(made.await?)
        }
    }
}

/// The body of a request.
async fn body(shared: &Shared, request: Request<Incoming>) -> Result<Bytes, Problem> {
    let Limits { body: most, patience, .. } = shared.turns.limits;
    let collected = timeout(patience, Limited::new(request.into_body(), most).collect()).await;
    let late = |_| Problem::new(408, "the request did not arrive in time");
    let broken = |error: Box<dyn std::error::Error + Send + Sync>| {
        if error.is::<LengthLimitError>() {
            Problem::new(413, "the request is too large")
        } else {
            Problem::new(400, "the request does not arrive whole")
        }
    };
    Ok(collected.map_err(late)?.map_err(broken)?.to_bytes())
}
