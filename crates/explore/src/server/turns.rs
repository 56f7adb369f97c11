//! Computations: how many at once, for how long, and their end when nobody waits for them.

use std::io;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use grazing_model::smooth::Stop;
use rayon::{ThreadPool, ThreadPoolBuilder};
use tokio::sync::{OwnedSemaphorePermit, Semaphore, oneshot, watch};
use tokio::task::{JoinHandle, spawn_blocking};
use tokio::time::{sleep, timeout};

use crate::answer::Problem;
use crate::asked::Weight;

/// What the server allows. None of it is felt by people at browsers; all of it is by whoever wants
/// to bring the server down.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// Connections at once; more are closed.
    pub connections: usize,
    /// Heavy computations at once; more wait, in the order in which they came. By default so many
    /// as one page asks for: diagram, place, cut, simulation.
    pub computations: usize,
    /// Light ones, which do not wait for these.
    pub light: usize,
    /// Bytes of a request's body: ten times the largest file that is no generated one.
    pub body: usize,
    /// For the head of a request to come, and then for its body; and for whoever asked to take more
    /// of the answer.
    pub patience: Duration,
    /// For a computation, with the time that it waits. It is that of the clock on the wall, since
    /// the process computes for several at once.
    pub time: Duration,
    /// For a computation to notice that its end is asked for. One that does not loses its turn to
    /// whoever comes next.
    pub grace: Duration,
    /// Steps of integration of a computation.
    pub steps: u64,
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            connections: 256,
            computations: 4,
            light: 2,
            body: 200_000,
            patience: Duration::from_secs(10),
            time: Duration::from_secs(120),
            grace: Duration::from_secs(10),
            steps: 2_000_000_000,
        }
    }
}

/// What all computations share.
pub(crate) struct Turns {
    pub(crate) limits: Limits,
    light: Arc<Lane>,
    heavy: Arc<Lane>,
    /// Changes when all computations are to end.
    ending: watch::Sender<u64>,
}

/// Computations of one weight.
struct Lane {
    turns: Arc<Semaphore>,
    /// Each computation has threads of its own: those of one that takes long would not look after
    /// another before its end.
    threads: Mutex<Vec<Arc<ThreadPool>>>,
}

fn threads() -> io::Result<Arc<ThreadPool>> {
    ThreadPoolBuilder::new().build().map(Arc::new).map_err(io::Error::other)
}

impl Lane {
    fn new(turns: usize) -> io::Result<Arc<Self>> {
        let threads = (0..turns).map(|_| threads()).collect::<io::Result<_>>()?;
        Ok(Arc::new(Self { turns: Arc::new(Semaphore::new(turns)), threads: Mutex::new(threads) }))
    }

    fn threads(&self) -> MutexGuard<'_, Vec<Arc<ThreadPool>>> {
        self.threads.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// The right to compute, as long as nobody has taken it back.
struct Seat {
    lane: Arc<Lane>,
    permit: Mutex<Option<OwnedSemaphorePermit>>,
}

impl Seat {
    /// Gives the right back, with threads for whoever comes next; once.
    fn vacate(&self, threads: impl FnOnce() -> io::Result<Arc<ThreadPool>>) {
        let permit = self.permit.lock().unwrap_or_else(PoisonError::into_inner).take();
        let Some(permit) = permit else { return };
        match threads() {
            Ok(threads) => self.lane.threads().push(threads),
            // There is one turn less.
            Err(_) => permit.forget(),
        }
    }
}

/// A turn to compute, and the threads to do it with.
struct Turn {
    seat: Arc<Seat>,
    pool: Arc<ThreadPool>,
}

impl Drop for Turn {
    fn drop(&mut self) {
        self.seat.vacate(|| Ok(self.pool.clone()));
    }
}

impl Turns {
    /// For these limits.
    ///
    /// # Errors
    /// There are no threads.
    pub(crate) fn new(limits: Limits) -> io::Result<Self> {
        let [light, heavy] = [Lane::new(limits.light)?, Lane::new(limits.computations)?];
        Ok(Self { limits, light, heavy, ending: watch::Sender::new(0) })
    }

    /// Ends all computations.
    pub(crate) fn end_all(&self) {
        self.ending.send_modify(|endings| *endings += 1);
    }

    /// A turn, once it is there; none if it takes too long.
    async fn turn(&self, weight: Weight) -> Result<Turn, Problem> {
        let lane = if weight == Weight::Light { &self.light } else { &self.heavy };
        let refused = |why| Problem::new(503, why);
        let turn = timeout(self.limits.time, lane.turns.clone().acquire_owned()).await;
        let permit = turn.map_err(|_| refused("the server is busy"))?;
        let permit = permit.map_err(|_| refused("the server is closing"))?;
        let pool = lane.threads().pop().ok_or_else(|| refused("the server is busy"))?;
        Ok(Turn { seat: Arc::new(Seat { lane: lane.clone(), permit: Mutex::new(Some(permit)) }), pool })
    }

    /// A mark that ends a computation when its time or its steps are used up, when all are to end,
    /// and when what is returned beside it is dropped. One that goes on all the same loses its turn.
    fn mark(&self, turn: &Turn) -> (Stop, StopOnDrop) {
        let stop = Stop::after(self.limits.steps);
        let Limits { time, grace, .. } = self.limits;
        let (guarded, dropped) = oneshot::channel::<()>();
        let (asked, mut ending, seat) = (stop.clone(), self.ending.subscribe(), Arc::downgrade(&turn.seat));
        tokio::spawn(async move {
            tokio::select! {
                () = sleep(time) => {}
                _ = ending.changed() => {}
                _ = dropped => {}
            }
            asked.ask();
            // One that has ended has no seat any more.
            if seat.strong_count() > 0 {
                sleep(grace).await;
                if let Some(seat) = seat.upgrade() {
                    seat.vacate(threads);
                }
            }
        });
        (stop.clone(), StopOnDrop { stop, _guarded: guarded })
    }
}

/// Asks a computation to end when it is dropped, as the answer that nobody waits for any more is.
pub(crate) struct StopOnDrop {
    stop: Stop,
    _guarded: oneshot::Sender<()>,
}

impl Drop for StopOnDrop {
    fn drop(&mut self) {
        self.stop.ask();
    }
}

/// A computation that has begun in a thread of its own.
pub(crate) struct Begun<T> {
    pub(crate) result: JoinHandle<T>,
    /// It ends when this is dropped.
    pub(crate) guard: StopOnDrop,
}

/// Begins to compute something when it is its turn.
pub(crate) async fn begin<T: Send + 'static>(
    turns: &Turns,
    weight: Weight,
    work: impl FnOnce(&Stop) -> T + Send + 'static,
) -> Result<Begun<T>, Problem> {
    let turn = turns.turn(weight).await?;
    let (stop, guard) = turns.mark(&turn);
    let result = spawn_blocking(move || turn.pool.install(|| work(&stop)));
    Ok(Begun { result, guard })
}

/// Computes something when it is its turn.
pub(crate) async fn computed<T: Send + 'static>(
    turns: &Turns,
    weight: Weight,
    work: impl FnOnce(&Stop) -> Result<T, Problem> + Send + 'static,
) -> Result<T, Problem> {
    let Begun { result, guard: _guard } = begin(turns, weight, work).await?;
    let Limits { time, grace, .. } = turns.limits;
    let failed = |_| Problem::new(500, "the computation failed");
    timeout(time + grace, result).await.map_err(|_| Problem::ended())?.map_err(failed)?
}
