//! The `grazing` program; see `grazing --help`.

use std::process::ExitCode;

use clap::FromArgMatches;
use grazing_cli::arguments::{Arguments, command_line};
use grazing_cli::{commands, run, terminal};

fn main() -> ExitCode {
    let command = command_line(commands::program());
    let code = match command.try_get_matches().and_then(|matches| Arguments::from_arg_matches(&matches)) {
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
