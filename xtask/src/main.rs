//! `cargo xtask ...`: builds the `grazing` program in release mode and starts it with the same
//! arguments.
//!
//! It knows no subcommand: whatever `grazing` understands, `cargo xtask` does too, and `grazing`
//! answers for the rest. Where the built program lies is left to cargo, so target folders set by
//! environment or configuration are honoured. Exit codes are the program's; those of cargo if the
//! program could not be built.

use std::env;
use std::ffi::OsString;
use std::io::{self, Write};
use std::process::{Command, ExitCode, ExitStatus};

/// The package that holds the program, and the program.
const PROGRAM: [&str; 4] = ["--package", "grazing-cli", "--bin", "grazing"];

fn main() -> ExitCode {
    let arguments: Vec<OsString> = env::args_os().skip(1).collect();
    match build_and_run(&arguments) {
        Ok(status) => exit_code(status),
        Err(error) => {
            // Nobody is left to tell when the error stream is gone.
            let _ = writeln!(io::stderr(), "error: cargo could not be started: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Builds where it can be watched, then runs without cargo's own lines between.
fn build_and_run(arguments: &[OsString]) -> io::Result<ExitStatus> {
    let built = cargo().args(["build", "--release"]).args(PROGRAM).status()?;
    if !built.success() {
        return Ok(built);
    }
    let mut run = cargo();
    // The program's texts then have its commands as they were typed.
    run.env("GRAZING_BY_XTASK", "1");
    run.args(["run", "--release", "--quiet"]).args(PROGRAM).arg("--").args(arguments);
    handed_over(run)
}

/// Becomes the program, which then is the one that Ctrl-C reaches.
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

/// The exit code of a finished program; as shells have it, 128 and the signal's number for one that
/// was stopped.
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
