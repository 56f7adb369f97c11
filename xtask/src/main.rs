//! `cargo xtask ...`: builds the `grazing` program in the profile of the tests, which then find
//! it compiled, and starts it with the same arguments.
//!
//! It knows no subcommand: `cargo xtask` accepts whatever `grazing` does, and `grazing` reports
//! errors. Cargo determines the place of the built program, so target folders set by environment or
//! configuration are respected. Exit codes are the program's, or cargo's if the program could not
//! be built.

use std::env;
use std::ffi::OsString;
use std::io::{self, Write};
use std::process::{Command, ExitCode, ExitStatus};

/// The options that name the package and the program.
const PROGRAM: [&str; 4] = ["--package", "grazing-cli", "--bin", "grazing"];

fn main() -> ExitCode {
    let arguments: Vec<OsString> = env::args_os().skip(1).collect();
    match build_and_run(&arguments) {
        Ok(status) => exit_code(status),
        Err(error) => {
            // There is no other place for a message if the error stream is closed.
            let _ = writeln!(io::stderr(), "error: cargo could not be started: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Builds with cargo's output visible, then runs the program without it.
fn build_and_run(arguments: &[OsString]) -> io::Result<ExitStatus> {
    let built = cargo().arg("build").args(PROGRAM).status()?;
    if !built.success() {
        return Ok(built);
    }
    let mut run = cargo();
    // The program then writes its commands as they are typed in a clone.
    run.env("GRAZING_BY_XTASK", "1");
    run.args(["run", "--quiet"]).args(PROGRAM).arg("--").args(arguments);
    handed_over(run)
}

/// Replaces this process by the program, which then receives Ctrl-C.
#[cfg(unix)]
fn handed_over(mut run: Command) -> io::Result<ExitStatus> {
    use std::os::unix::process::CommandExt;
    Err(run.exec())
}

/// Waits for the program.
#[cfg(not(unix))]
fn handed_over(mut run: Command) -> io::Result<ExitStatus> {
    run.status()
}

/// The cargo that runs this program.
fn cargo() -> Command {
    Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
}

/// The exit code of a finished program: 128 plus the signal's number, as in shells, if it was
/// stopped by a signal.
fn exit_code(status: ExitStatus) -> ExitCode {
    match status.code() {
        Some(code) => ExitCode::from(u8::try_from(code).unwrap_or(1)),
        None => ExitCode::from(stopped_by(status)),
    }
}

#[cfg(unix)]
fn stopped_by(status: ExitStatus) -> u8 {
    use std::os::unix::process::ExitStatusExt;
    status.signal().and_then(|signal| u8::try_from(128 + signal).ok()).unwrap_or(1)
}

#[cfg(not(unix))]
fn stopped_by(_: ExitStatus) -> u8 {
    1
}
