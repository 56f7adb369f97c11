//! Computations: how many at once, for how long, and their end when nobody waits for them.

use std::io;
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};
use std::time::Duration;

use grazing_model::smooth::Stop;
use rayon::{ThreadPool, ThreadPoolBuilder};
use tokio::sync::{OwnedSemaphorePermit, Semaphore, oneshot, watch};
use tokio::task::{JoinHandle, spawn_blocking};
use tokio::time::{sleep, timeout};

use crate::answer::Problem;
use crate::asked::Weight;

/// The limits of the server. People at browsers notice none of them; attempts to overload the
/// server meet all of them.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// Connections at once; more are closed.
    pub connections: usize,
    /// Heavy computations at once; more wait, in the order of their arrival. By default as many as
    /// one page requests: diagram, place, cut, simulation.
    pub computations: usize,
    /// Light computations at once, which do not wait for heavy ones.
    pub light: usize,
    /// The most bytes of a request's body: ten times the largest file that was not generated.
    pub body: usize,
    /// The time for the head of a request to arrive, and then for its body; and for a client to
    /// read more of the answer.
    pub patience: Duration,
    /// The time for a computation, with the time that it waits: wall-clock time, since the process
    /// computes for several clients at once.
    pub time: Duration,
    /// The time for a computation to notice that it is cancelled. One that does not loses its turn
    /// to the next.
    pub grace: Duration,
    /// The most steps of integration of a computation.
    pub steps: u64,
    /// The most megabytes of the process. When it holds more, computations that have grown by `growth` since
    /// they began are cancelled, and no others: memory that was freed may stay with the process.
    pub memory: f64,
    /// The megabytes by which the process may grow while a computation runs even if it is too large.
    pub growth: f64,
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
            memory: grazing_input::AnalysisLimits::USUAL.memory,
            growth: 250.0,
        }
    }
}

/// The state that all computations share.
pub(crate) struct Turns {
    pub(crate) limits: Limits,
    light: Arc<Lane>,
    heavy: Arc<Lane>,
    /// The number of times that all computations were ended; they end when it changes.
    ending: watch::Sender<u64>,
    /// The megabytes that the process holds.
    held: watch::Sender<f64>,
}

/// The cause that has ended a computation, once there is one.
#[derive(Clone, Default)]
pub(crate) struct Cause(Arc<OnceLock<fn() -> Problem>>);

impl Cause {
    /// The reason why there is no result.
    pub(crate) fn problem(&self) -> Problem {
        self.0.get().map_or_else(Problem::ended, |problem| problem())
    }
}

/// Computations of one weight.
struct Lane {
    turns: Arc<Semaphore>,
    /// The threads of each computation: shared ones would be held by a long computation until its end.
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

/// The right to compute, unless it has been taken back.
struct Seat {
    lane: Arc<Lane>,
    permit: Mutex<Option<OwnedSemaphorePermit>>,
}

impl Seat {
    /// Gives the right back once, with threads for the next computation.
    fn vacate(&self, threads: impl FnOnce() -> io::Result<Arc<ThreadPool>>) {
        let permit = self.permit.lock().unwrap_or_else(PoisonError::into_inner).take();
        let Some(permit) = permit else { return };
        match threads() {
            Ok(threads) => self.lane.threads().push(threads),
            // Without threads there is one turn less.
            Err(_) => permit.forget(),
        }
    }
}

/// A turn to compute, with threads.
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
    /// Turns with these limits.
    ///
    /// # Errors
    /// No threads can be started.
    pub(crate) fn new(limits: Limits) -> io::Result<Self> {
        let [light, heavy] = [Lane::new(limits.light)?, Lane::new(limits.computations)?];
        let (ending, held) = (watch::Sender::new(0), watch::Sender::new(0.0));
        Ok(Self { limits, light, heavy, ending, held })
    }

    /// Takes note of the megabytes that the process holds.
    pub(crate) fn note_memory(&self, megabytes: f64) {
        self.held.send_replace(megabytes);
    }

    /// Ends all computations.
    pub(crate) fn end_all(&self) {
        self.ending.send_modify(|endings| *endings += 1);
    }

    /// A turn as soon as one is free; an error if that takes too long.
    async fn turn(&self, weight: Weight) -> Result<Turn, Problem> {
        let lane = if weight == Weight::Light { &self.light } else { &self.heavy };
        let refused = |why| Problem::new(503, why);
        let turn = timeout(self.limits.time, lane.turns.clone().acquire_owned()).await;
        let permit = turn.map_err(|_| refused("the server is busy"))?;
        let permit = permit.map_err(|_| refused("the server is closing"))?;
        let pool = lane.threads().pop().ok_or_else(|| refused("the server is busy"))?;
        Ok(Turn { seat: Arc::new(Seat { lane: lane.clone(), permit: Mutex::new(Some(permit)) }), pool })
    }

    /// A mark that ends a computation when its time, its steps or its memory are used up, when all are to
    /// end, or when the guard returned with it is dropped. A computation that goes on regardless loses its
    /// turn.
    fn mark(&self, turn: &Turn) -> (Stop, StopOnDrop) {
        let stop = Stop::after(self.limits.steps);
        let Limits { time, grace, memory, growth, .. } = self.limits;
        let (guarded, dropped) = oneshot::channel::<()>();
        let (mut held, cause) = (self.held.subscribe(), Cause::default());
        let before = *held.borrow_and_update();
        let of_memory = cause.clone();
        let (asked, mut ending, seat) = (stop.clone(), self.ending.subscribe(), Arc::downgrade(&turn.seat));
        tokio::spawn(async move {
            tokio::select! {
                () = sleep(time) => {}
                _ = ending.changed() => {}
                _ = held.wait_for(|now| *now > memory && now - before > growth) => {
                    let _ = of_memory.0.set(Problem::too_large);
                }
                _ = dropped => {}
            }
            asked.ask();
            // A computation that has ended no longer has a seat.
            if seat.strong_count() > 0 {
                sleep(grace).await;
                if let Some(seat) = seat.upgrade() {
                    seat.vacate(threads);
                }
            }
        });
        (stop.clone(), StopOnDrop { stop, cause, _guarded: guarded })
    }
}

/// A guard that cancels a computation when it is dropped, as it is with an answer that nobody waits for.
pub(crate) struct StopOnDrop {
    stop: Stop,
    cause: Cause,
    _guarded: oneshot::Sender<()>,
}

impl Drop for StopOnDrop {
    fn drop(&mut self) {
        self.stop.ask();
    }
}

/// A computation that has begun in a separate thread.
pub(crate) struct Begun<T> {
    pub(crate) result: JoinHandle<T>,
    /// The guard that ends the computation when it is dropped.
    pub(crate) guard: StopOnDrop,
}

/// Begins a computation at its turn.
pub(crate) async fn begin<T: Send + 'static>(
    turns: &Turns,
    weight: Weight,
    work: impl FnOnce(&Stop, &Cause) -> T + Send + 'static,
) -> Result<Begun<T>, Problem> {
    let turn = turns.turn(weight).await?;
    let (stop, guard) = turns.mark(&turn);
    let cause = guard.cause.clone();
    let result = spawn_blocking(move || turn.pool.install(|| work(&stop, &cause)));
    Ok(Begun { result, guard })
}

/// Runs a computation at its turn.
pub(crate) async fn computed<T: Send + 'static>(
    turns: &Turns,
    weight: Weight,
    work: impl FnOnce(&Stop) -> Result<T, Problem> + Send + 'static,
) -> Result<T, Problem> {
    let Begun { result, guard } = begin(turns, weight, move |stop, _| work(stop)).await?;
    let Limits { time, grace, .. } = turns.limits;
    let failed = |_| Problem::new(500, "the computation failed");
    let result = timeout(time + grace, result).await.map_err(|_| guard.cause.problem())?.map_err(failed)?;
    result.map_err(|problem| if guard.stop.is_asked() { guard.cause.problem() } else { problem })
}
