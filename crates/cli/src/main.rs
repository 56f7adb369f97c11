//! The `grazing` program; `grazing --help` tells what it does.

use std::process::ExitCode;

use clap::Parser;
use grazing_cli::arguments::Arguments;
use grazing_cli::{run, terminal};

fn main() -> ExitCode {
    // A wrong command line ends here, with exit code 2.
    match run(&Arguments::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            terminal::report(&failure);
            ExitCode::from(failure.exit_code())
        }
    }
}
