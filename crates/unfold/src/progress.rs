//! Reports of the progress of long computations.

use grazing_model::smooth::Stop;

/// A receiver of the progress of a computation; called from any thread.
pub trait Progress: Sync {
    /// Called when work in a number of steps begins.
    fn begin(&self, what: &str, steps: u64);
    /// Called when one step is complete.
    fn step(&self, what: &str);
    /// Called when the work is complete.
    fn end(&self, what: &str);
    /// Whether nothing more is to be started, as when time is up: long loops check this and end
    /// with the results that they have.
    fn stopped(&self) -> bool {
        false
    }
}

impl dyn Progress + '_ {
    /// Performs work in a number of steps, each of which is reported when it is complete.
    pub fn during<T>(&self, what: &str, steps: u64, work: impl FnOnce() -> T) -> T {
        self.begin(what, steps);
        let done = work();
        self.end(what);
        done
    }
}

/// A receiver that ignores all reports.
#[derive(Clone, Copy, Debug)]
pub struct Silent;

impl Progress for Silent {
    fn begin(&self, _: &str, _: u64) {}
    fn step(&self, _: &str) {}
    fn end(&self, _: &str) {}
}

/// Ignores all reports; long loops end once the computation is cancelled.
impl Progress for Stop {
    fn begin(&self, _: &str, _: u64) {}
    fn step(&self, _: &str) {}
    fn end(&self, _: &str) {}
    fn stopped(&self) -> bool {
        self.is_asked()
    }
}
