//! How far long work has come.

use grazing_model::smooth::Stop;

/// Hears of the progress of a computation; called from any thread.
pub trait Progress: Sync {
    /// Work of a number of steps begins.
    fn begin(&self, what: &str, steps: u64);
    /// One step is done.
    fn step(&self, what: &str);
    /// The work is done.
    fn end(&self, what: &str);
    /// Whether nothing more is to be begun, as when time is up: long loops ask this and end with
    /// what they have.
    fn stopped(&self) -> bool {
        false
    }
}

impl dyn Progress + '_ {
    /// Does work of a number of steps, each of which is reported when it is done.
    pub fn during<T>(&self, what: &str, steps: u64, work: impl FnOnce() -> T) -> T {
        self.begin(what, steps);
        let done = work();
        self.end(what);
        done
    }
}

/// Hears nothing.
#[derive(Clone, Copy, Debug)]
pub struct Silent;

impl Progress for Silent {
    fn begin(&self, _: &str, _: u64) {}
    fn step(&self, _: &str) {}
    fn end(&self, _: &str) {}
}

/// Nobody hears of the progress, and long loops end when an end is asked for.
impl Progress for Stop {
    fn begin(&self, _: &str, _: u64) {}
    fn step(&self, _: &str) {}
    fn end(&self, _: &str) {}
    fn stopped(&self) -> bool {
        self.is_asked()
    }
}
