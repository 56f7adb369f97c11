//! The `grazing` program; see `grazing --help`.

use std::process::ExitCode;

use clap::Parser;
use grazing_cli::arguments::Arguments;
use grazing_cli::{run, terminal};

fn main() -> ExitCode {
    let code = match Arguments::try_parse() {
        Ok(arguments) => match run(&arguments) {
            Ok(()) => 0,
            Err(failure) => {
                terminal::report(&failure);
                failure.exit_code()
            }
        },
        // Help, which is not an error, or a wrong command line, which ends here with exit code 2.
        Err(answer) => terminal::answer(&answer),
    };
    match terminal::output_failure() {
        Some(failure) => {
            terminal::report(&failure);
            ExitCode::from(failure.exit_code())
        }
        None => ExitCode::from(code),
    }
}
