//! Signals that ask the program to end: Ctrl-C, the end of its terminal, and schedulers.

/// Calls the handler, on a separate thread, each time that the program is asked to end: by Ctrl-C
/// (SIGINT), by a scheduler or the like (SIGTERM), or by a closed terminal (SIGHUP), which may send
/// several signals and counts only if it is the first. Ignored signals stay ignored: `nohup` and
/// shells that run the program in the background rely on that.
///
/// Where no handler can be installed, the program ends as it does by default.
#[cfg(unix)]
pub(crate) fn handle(mut handler: impl FnMut() + Send + 'static) {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
    use signal_hook::iterator::Signals;

    let asking = [SIGINT, SIGTERM, SIGHUP].into_iter().filter(|signal| !is_ignored(*signal));
    let Ok(mut signals) = Signals::new(asking) else { return };
    let listen = move || {
        let mut is_asked = false;
        for signal in signals.forever() {
            if !is_asked || signal != SIGHUP {
                is_asked = true;
                handler();
            }
        }
    };
    let _ = std::thread::Builder::new().name("signals".to_owned()).spawn(listen);
}

/// Whether the signal was ignored when the program began; false where the system does not report it.
#[cfg(unix)]
fn is_ignored(signal: i32) -> bool {
    let mask = crate::limits::status("SigIgn:").and_then(|mask| u64::from_str_radix(&mask, 16).ok());
    mask.is_some_and(|mask| mask >> (signal - 1) & 1 == 1)
}

/// Calls the handler each time that Ctrl-C is pressed, the window is closed or the session ends.
///
/// Where no handler can be installed, the program ends as it does by default.
#[cfg(not(unix))]
pub(crate) fn handle(handler: impl FnMut() + Send + 'static) {
    let _ = ctrlc::set_handler(handler);
}
