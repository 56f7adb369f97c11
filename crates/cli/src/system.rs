//! What the system reports of this process: CPU time and memory.

use std::fs;
use std::time::Duration;

/// The CPU time that the process has taken.
#[cfg(unix)]
pub(crate) fn clock() -> Duration {
    let time = rustix::time::clock_gettime(rustix::time::ClockId::ProcessCPUTime);
    Duration::new(time.tv_sec.cast_unsigned(), u32::try_from(time.tv_nsec).unwrap_or_default())
}

/// The kind of time that is counted, in messages.
pub(crate) const CLOCK: &str =
    if cfg!(unix) { "of CPU time" } else { "of wall-clock time (this system does not report CPU time)" };

/// The time since the first call, where the system has no clock of CPU time.
#[cfg(not(unix))]
pub(crate) fn clock() -> Duration {
    static FIRST: std::sync::OnceLock<std::time::Instant> = std::sync::OnceLock::new();
    FIRST.get_or_init(std::time::Instant::now).elapsed()
}

/// The megabytes of address space that the system allows the process, if it limits them.
#[cfg(unix)]
pub(crate) fn address_space() -> Option<f64> {
    use rustix::process::{Resource, getrlimit};
    getrlimit(Resource::As).current.map(|bytes| bytes as f64 / 1e6)
}

/// The system has no such limit.
#[cfg(not(unix))]
pub(crate) fn address_space() -> Option<f64> {
    None
}

/// The memory that the process holds, in megabytes, where the system reports it as Linux does.
pub(crate) fn held() -> Option<f64> {
    megabytes("VmRSS:")
}

/// A quantity of memory that the system reports under a name, in megabytes.
pub(crate) fn megabytes(name: &str) -> Option<f64> {
    let kilobytes: f64 = status(name)?.parse().ok()?;
    Some(1.024e-3 * kilobytes)
}

/// A value of this process that the system reports under a name, where it does so as Linux does.
pub(crate) fn status(name: &str) -> Option<String> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix(name))?;
    line.split_whitespace().next().map(str::to_owned)
}
