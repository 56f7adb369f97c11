//! Computations: how many at once, for how long, and their end when nobody waits for them.

use std::io;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use grazing_model::smooth::Stop;
use hyper::StatusCode;
use rayon::{ThreadPool, ThreadPoolBuilder};
use tokio::sync::{OwnedSemaphorePermit, Semaphore, watch};
use tokio::task::{AbortHandle, spawn_blocking};
use tokio::time::timeout;

use crate::answer::Problem;

/// What the server allows. None of it is felt by people at browsers; all of it is by whoever wants
/// to bring the server down.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// Connections at once; more are closed.
    pub connections: usize,
    /// Computations at once; more wait, in the order in which they came. By default so many as one
    /// page asks for: diagram, place, cut, simulation.
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

/// What all computations share.
pub(crate) struct Turns {
    pub(crate) limits: Limits,
    computations: Arc<Semaphore>,
    /// Each computation has threads of its own: those of one that takes long would not look after
    /// another before its end.
    threads: Mutex<Vec<Arc<ThreadPool>>>,
    /// Changes when all computations are to end.
    ending: watch::Sender<u64>,
}

/// The right to compute, and the threads to do it with.
pub(crate) struct Turn {
    turns: Arc<Turns>,
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
        self.turns.threads().push(self.pool.clone());
    }
}

impl Turns {
    /// For these limits.
    ///
    /// # Errors
    /// There are no threads.
    pub(crate) fn new(limits: Limits) -> io::Result<Self> {
        let pool = |_| ThreadPoolBuilder::new().build().map(Arc::new).map_err(io::Error::other);
        Ok(Self {
            limits,
            computations: Arc::new(Semaphore::new(limits.computations)),
            threads: Mutex::new((0..limits.computations).map(pool).collect::<io::Result<_>>()?),
            ending: watch::Sender::new(0),
        })
    }

    /// Ends all computations.
    pub(crate) fn end_all(&self) {
        self.ending.send_modify(|endings| *endings += 1);
    }

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
        Ok(Turn { turns: self.clone(), pool, _permit: permit })
    }

    /// A mark that ends a computation when its time or its steps are used up, when all are to end,
    /// and when what is returned beside it is dropped.
    pub(crate) fn mark(&self) -> (Stop, StopOnDrop) {
        let stop = Stop::after(self.limits.steps);
        let (time, ended, mut ending) = (self.limits.time, stop.clone(), self.ending.subscribe());
        let watch = tokio::spawn(async move {
            let _ = timeout(time, ending.changed()).await;
            ended.ask();
        });
        (stop.clone(), StopOnDrop { stop, watch: watch.abort_handle() })
    }
}

/// Asks a computation to end when it is dropped, as the answer that nobody waits for any more is.
pub(crate) struct StopOnDrop {
    stop: Stop,
    /// What waits for the end of its time.
    watch: AbortHandle,
}

impl Drop for StopOnDrop {
    fn drop(&mut self) {
        self.stop.ask();
        self.watch.abort();
    }
}

/// Computes something in a thread of its own, when it is its turn.
pub(crate) async fn blocking<T: Send + 'static>(
    turns: &Arc<Turns>,
    work: impl FnOnce(&Stop) -> Result<T, Problem> + Send + 'static,
) -> Result<T, Problem> {
    let turn = turns.turn().await?;
    let (stop, _guard) = turns.mark();
    let computed = spawn_blocking(move || turn.take(|| work(&stop)));
    let failed = |_| Problem::new(StatusCode::INTERNAL_SERVER_ERROR, "the computation failed");
    computed.await.map_err(failed)?
}
