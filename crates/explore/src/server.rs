//! Connections, their limits, and where requests go.

use std::convert::Infallible;
use std::io;
use std::net::{Ipv4Addr, TcpListener};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use grazing_unfold::stop::Stop;
use http_body_util::{BodyExt, Limited};
use hyper::body::Incoming;
use hyper::header::CONTENT_TYPE;
use hyper::server::conn::http1;
use hyper::service::service_fn;
use hyper::{Method, Request, Response, StatusCode};
use hyper_util::rt::{TokioIo, TokioTimer};
use rayon::{ThreadPool, ThreadPoolBuilder};
use serde::Deserialize;
use serde::de::DeserializeOwned;
use tokio::runtime::Builder;
use tokio::sync::{OwnedSemaphorePermit, Semaphore, watch};
use tokio::time::{interval, sleep, timeout};

use crate::answer::{self, Body, Problem, StopOnDrop};
use crate::files::{self, Example};
use crate::guard::{self, Token};
use crate::model::{Model, View};
use crate::{cut, diagram, place, stream, tiles};

/// What the server allows. None of it is felt by people at browsers; all of it is by whoever wants to bring the server down.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// Connections at once; more are closed.
    pub connections: usize,
    /// Computations at once; more wait, in the order in which they came. By default so many as one page asks for: diagram, place, cut, simulation.
    pub computations: usize,
    /// Bytes of a request's body: ten times the largest file that is no generated one.
    pub body: usize,
    /// For the head of a request to come, and then for its body.
    pub patience: Duration,
    /// For a computation, with the time that it waits.
    pub time: Duration,
    /// Steps of integration of a computation.
    pub steps: u64,
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            connections: 256,
            computations: 4,
            body: 200_000,
            patience: Duration::from_secs(10),
            time: Duration::from_secs(120),
            steps: 2_000_000_000,
        }
    }
}

/// A file that is taken home.
pub struct Sheet {
    /// Its name.
    pub name: String,
    /// Its media type.
    pub kind: &'static str,
    /// Its content.
    pub content: Vec<u8>,
}

/// Makes a file of what is seen: of a model in a view `svg`, `pdf`, `png` or `csv:TABLE` at a width (`paper`, `one`, `two`).
pub type Export = Box<dyn Fn(&Model, &View, &str, &str, &Stop) -> Result<Sheet, String> + Send + Sync>;

/// A server that is bound to its port, and not running yet.
pub struct Server {
    listener: TcpListener,
    shared: Arc<Shared>,
}

/// What all requests share.
pub(crate) struct Shared {
    port: u16,
    token: Token,
    examples: Vec<Example>,
    export: Export,
    pub(crate) limits: Limits,
    computations: Arc<Semaphore>,
    /// Each computation has threads of its own: those of one that takes long would not look after another before its end.
    threads: Mutex<Vec<Arc<ThreadPool>>>,
    /// Changes when all computations are to end.
    ending: watch::Sender<u64>,
}

impl Server {
    /// Binds to a port of the loopback interface; 0 stands for any that is free.
    ///
    /// # Errors
    /// The port is taken or forbidden.
    pub fn bind(port: u16, limits: Limits, examples: Vec<Example>, export: Export) -> io::Result<Self> {
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, port))?;
        listener.set_nonblocking(true)?;
        let pool = |_| ThreadPoolBuilder::new().build().map(Arc::new).map_err(io::Error::other);
        let threads = (0..limits.computations).map(pool).collect::<io::Result<_>>()?;
        let shared = Shared {
            port: listener.local_addr()?.port(),
            token: Token::random()?,
            examples,
            export,
            limits,
            computations: Arc::new(Semaphore::new(limits.computations)),
            threads: Mutex::new(threads),
            ending: watch::Sender::new(0),
        };
        Ok(Self { listener, shared: Arc::new(shared) })
    }

    /// The address of the page.
    pub fn address(&self) -> String {
        format!("http://127.0.0.1:{}/{}/", self.shared.port, self.shared.token.text())
    }

    /// Answers requests until `ended` says so, which is asked several times a second; what is being computed then ends at once. So it does
    /// when the process is `too_large`, which goes on.
    ///
    /// # Errors
    /// There are no threads.
    pub fn run(self, ended: impl Fn() -> bool, too_large: impl Fn() -> bool) -> io::Result<()> {
        let Self { listener, shared } = self;
        // A thread for connections; computations have theirs, and within them rayon's.
        let runtime = Builder::new_multi_thread()
            .worker_threads(1)
            .max_blocking_threads(shared.limits.computations + 2)
            .enable_all()
            .build()?;
        runtime.block_on(async {
            let listener = tokio::net::TcpListener::from_std(listener)?;
            let places = Arc::new(Semaphore::new(shared.limits.connections));
            let mut pause = interval(PAUSE);
            loop {
                let accepted = tokio::select! {
                    accepted = listener.accept() => accepted,
                    _ = pause.tick() => {
                        if ended() {
                            break;
                        }
                        if too_large() {
                            shared.ending.send_modify(|endings| *endings += 1);
                        }
                        continue;
                    }
                };
                // A connection that cannot be had, or is one too many, is nobody's trouble but its own.
                let (Ok((stream, _)), Ok(place)) = (accepted, places.clone().try_acquire_owned()) else {
                    continue;
                };
                tokio::spawn(connection(TokioIo::new(stream), shared.clone(), place));
            }
            shared.ending.send_modify(|endings| *endings += 1);
            Ok::<_, io::Error>(())
        })?;
        runtime.shutdown_timeout(GRACE);
        Ok(())
    }
}

/// How often it is asked whether to end, and what computations have then to notice it.
const PAUSE: Duration = Duration::from_millis(50);
const GRACE: Duration = Duration::from_millis(500);

async fn connection(
    stream: TokioIo<tokio::net::TcpStream>,
    shared: Arc<Shared>,
    _place: OwnedSemaphorePermit,
) {
    let patience = shared.limits.patience;
    let service = service_fn(move |request| {
        let shared = shared.clone();
        async move {
            let mut response = respond(&shared, request).await.unwrap_or_else(Problem::response);
            guard::headers(response.headers_mut());
            Ok::<_, Infallible>(response)
        }
    });
    // Whoever goes away in the middle of an answer needs none.
    let _ = http1::Builder::new()
        .timer(TokioTimer::new())
        .header_read_timeout(patience)
        .max_buf_size(HEAD)
        .serve_connection(stream, service)
        .await;
}

/// Bytes of a request's head, at most.
const HEAD: usize = 16 * 1024;

async fn respond(shared: &Arc<Shared>, request: Request<Incoming>) -> Result<Response<Body>, Problem> {
    if !guard::is_own(request.headers(), shared.port) {
        return Err(Problem::new(StatusCode::FORBIDDEN, "this page may not ask here"));
    }
    let nothing = || Problem::new(StatusCode::NOT_FOUND, "there is nothing here");
    let path = request.uri().path().to_owned();
    let rest = shared.token.rest(&path).ok_or_else(nothing)?;
    if request.method() == Method::GET {
        return match rest {
            "examples" => Ok(answer::json(&shared.examples)),
            file => files::page(file).ok_or_else(nothing),
        };
    }
    if request.method() != Method::POST {
        return Err(Problem::new(StatusCode::METHOD_NOT_ALLOWED, "GET and POST are understood"));
    }
    // Forms of foreign pages cannot send this type.
    let json = request.headers().get(CONTENT_TYPE).is_some_and(|kind| kind == "application/json");
    if !json {
        return Err(Problem::new(StatusCode::UNSUPPORTED_MEDIA_TYPE, "requests are application/json"));
    }
    match rest {
        "check" => {
            let model: Model = read(shared, request).await?;
            Ok(match model.described() {
                Ok(described) => answer::json(&described),
                Err(wrong) => answer::json(&wrong.told()),
            })
        }
        "diagram" => stream::events(shared, read(shared, request).await?, diagram::compute).await,
        "tiles" => stream::events(shared, read(shared, request).await?, tiles::compute).await,
        "place" => answer::computed(shared, read(shared, request).await?, place::compute).await,
        "cut" => stream::events(shared, read(shared, request).await?, cut::compute).await,
        "export" => {
            let Wanted { model, view, what, columns } = read(shared, request).await?;
            let (own, limits) = (shared.clone(), shared.limits);
            let made = answer::blocking(shared, limits, move |stop| {
                (own.export)(&model, &view, &what, &columns, stop).map_err(Problem::wrong)
            });
            answer::file(made.await?)
        }
        _ => Err(nothing()),
    }
}

/// What is taken home.
#[derive(Deserialize)]
struct Wanted {
    model: Model,
    view: View,
    what: String,
    #[serde(default = "paper")]
    columns: String,
}

fn paper() -> String {
    "paper".to_owned()
}

/// The body of a request.
async fn read<T: DeserializeOwned>(shared: &Shared, request: Request<Incoming>) -> Result<T, Problem> {
    let Limits { body: most, patience, .. } = shared.limits;
    let collected = timeout(patience, Limited::new(request.into_body(), most).collect()).await;
    let late = |_| Problem::new(StatusCode::REQUEST_TIMEOUT, "the request did not come in time");
    let large = |_| Problem::new(StatusCode::PAYLOAD_TOO_LARGE, "the request is too large");
    let bytes = collected.map_err(late)?.map_err(large)?.to_bytes();
    serde_json::from_slice(&bytes).map_err(|error| {
        Problem::new(StatusCode::BAD_REQUEST, format!("the request is not understood: {error}"))
    })
}

/// The right to compute, and the threads to do it with.
pub(crate) struct Turn {
    shared: Arc<Shared>,
    pool: Arc<ThreadPool>,
    _permit: OwnedSemaphorePermit,
}

impl Turn {
    /// Computes, and gives the right back.
    pub(crate) fn take<T: Send>(self, work: impl FnOnce() -> T + Send) -> T {
        self.pool.install(work)
    }
}

impl Drop for Turn {
    fn drop(&mut self) {
        self.shared.threads().push(self.pool.clone());
    }
}

impl Shared {
    fn threads(&self) -> MutexGuard<'_, Vec<Arc<ThreadPool>>> {
        self.threads.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The right to compute, once it is there; none if it takes too long.
    pub(crate) async fn turn(self: &Arc<Self>) -> Result<Turn, Problem> {
        let refused = |why| Problem::new(StatusCode::SERVICE_UNAVAILABLE, why);
        let turn = timeout(self.limits.time, self.computations.clone().acquire_owned()).await;
        let permit = turn.map_err(|_| refused("the server is busy"))?;
        let permit = permit.map_err(|_| refused("the server is closing"))?;
        let pool = self.threads().pop().ok_or_else(|| refused("the server is busy"))?;
        Ok(Turn { shared: self.clone(), pool, _permit: permit })
    }

    /// A mark that ends a computation when its time or its steps are used up, when all are to end, and when what is returned beside it is
    /// dropped.
    pub(crate) fn mark(&self, limits: Limits) -> (Stop, StopOnDrop) {
        let stop = Stop::after(limits.steps);
        let (guard, mut ending) = (StopOnDrop::new(stop.clone()), self.ending.subscribe());
        let (ended, gone) = (stop.clone(), guard.gone());
        tokio::spawn(async move {
            tokio::select! {
                () = sleep(limits.time) => ended.ask(),
                _ = ending.changed() => ended.ask(),
                () = gone.notified() => {}
            }
        });
        (stop, guard)
    }
}
