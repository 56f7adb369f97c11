//! What people see: results on the output stream, messages on the error stream.

use std::env;
use std::io::{self, IsTerminal, Write};

use crate::failure::Failure;

/// Writes to the output stream. Nobody is left to tell when it is closed, as by `| head`; the exit code still counts.
pub(crate) fn say(text: &str) {
    let mut stream = io::stdout().lock();
    let _ = stream.write_all(text.as_bytes()).and_then(|()| stream.flush());
}

/// Writes a line to the error stream.
pub(crate) fn note(line: &str) {
    let _ = writeln!(io::stderr().lock(), "{line}");
}

/// Writes the one line that tells why the program ends.
pub fn report(failure: &Failure) {
    note(&format!("error: {failure}"));
}

/// Whether results may be coloured: on a terminal that knows colours, unless NO_COLOR is set (<https://no-color.org>).
pub(crate) fn is_coloured() -> bool {
    io::stdout().is_terminal()
        && env::var_os("NO_COLOR").is_none_or(|value| value.is_empty())
        && env::var_os("TERM").is_none_or(|terminal| terminal != "dumb")
}
