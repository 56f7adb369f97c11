//! Signals that ask the program to end, and what the system's own limits send.

use std::time::{Duration, Instant};

/// `timeout` and schedulers signal twice, to the process and to its group: what comes within this time of a
/// request to end belongs to it.
const SAME: Duration = Duration::from_secs(2);

/// Requests to end, of which one may arrive as several signals.
#[derive(Default)]
struct Requests {
    last: Option<Instant>,
}

impl Requests {
    /// Whether a signal that arrives now is a new request. One that `may_repeat` is a request only if it is
    /// the first.
    fn is_new(&mut self, now: Instant, may_repeat: bool) -> bool {
        let is_new = self.last.is_none_or(|last| !may_repeat && now.saturating_duration_since(last) >= SAME);
        if is_new {
            self.last = Some(now);
        }
        is_new
    }
}

/// Calls the handler, on a separate thread, each time that the program is asked to end: by Ctrl-C
/// (SIGINT), by a scheduler or the like (SIGTERM), by a closed terminal (SIGHUP) or by a limit of CPU time
/// (SIGXCPU, from `ulimit -t`). The last two send several signals and count only if they are the first.
/// Ignored signals stay ignored: `nohup` and shells that run the program in the background rely on that.
///
/// Where no handler can be installed, the program ends as it does by default.
#[cfg(unix)]
pub(crate) fn handle(mut handler: impl FnMut() + Send + 'static) {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM, SIGXCPU};
    use signal_hook::iterator::Signals;

    let asking = [SIGINT, SIGTERM, SIGHUP, SIGXCPU].into_iter().filter(|signal| !is_ignored(*signal));
    let Ok(mut signals) = Signals::new(asking) else { return };
    let listen = move || {
        let mut requests = Requests::default();
        for signal in signals.forever() {
            if requests.is_new(Instant::now(), signal == SIGHUP || signal == SIGXCPU) {
                handler();
            }
        }
    };
    let _ = std::thread::Builder::new().name("signals".to_owned()).spawn(listen);
}

/// Makes writing beyond `ulimit -f` an error of that file, instead of the end of the program, and, under
/// `ulimit -v` or `-d`, a failed allocation end the program with the code of a limit after its message.
#[cfg(unix)]
pub(crate) fn soften_limits() {
    use std::sync::Arc;
    use std::sync::atomic::AtomicBool;

    use rustix::process::{Resource, getrlimit};
    use signal_hook::consts::{SIGABRT, SIGXFSZ};
    use signal_hook::flag;

    // Without the handlers the system's limits end the program as they do by default.
    let _ = flag::register(SIGXFSZ, Arc::new(AtomicBool::new(false)));
    if [Resource::As, Resource::Data].into_iter().any(|of| getrlimit(of).current.is_some()) {
        let _ = flag::register_conditional_shutdown(
            SIGABRT,
            i32::from(crate::failure::INCOMPLETE),
            Arc::new(AtomicBool::new(true)),
        );
    }
}

/// Nothing: this system has no such limits.
#[cfg(not(unix))]
pub(crate) fn soften_limits() {}

/// Whether the signal was ignored when the program began; false where the system does not report it.
#[cfg(unix)]
fn is_ignored(signal: i32) -> bool {
    let mask = crate::system::status("SigIgn:").and_then(|mask| u64::from_str_radix(&mask, 16).ok());
    mask.is_some_and(|mask| mask >> (signal - 1) & 1 == 1)
}

/// Calls the handler each time that Ctrl-C is pressed, the window is closed or the session ends.
///
/// Where no handler can be installed, the program ends as it does by default.
#[cfg(not(unix))]
pub(crate) fn handle(mut handler: impl FnMut() + Send + 'static) {
    let mut requests = Requests::default();
    let _ = ctrlc::set_handler(move || {
        if requests.is_new(Instant::now(), false) {
            handler();
        }
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn signals_within_two_seconds_are_one_request() {
        let (began, mut requests) = (Instant::now(), Requests::default());
        let mut at = |milliseconds, may_repeat| {
            requests.is_new(began + Duration::from_millis(milliseconds), may_repeat)
        };
        assert!(at(0, false));
        assert!(!at(0, false) && !at(1, false) && !at(1999, false) && !at(5000, true));
        assert!(at(5000, false));
        assert!(!at(6999, false) && at(7000, false));
        assert!(Requests::default().is_new(began, true));
    }
}
