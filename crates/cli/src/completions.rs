//! `grazing completions`: the script with which a shell completes commands and options.

use crate::arguments::{CompletionsArguments, command_line};
use crate::commands::INSTALLED;
use crate::terminal;

/// Prints the script for a shell.
pub(crate) fn run(arguments: &CompletionsArguments) {
    let mut script = Vec::new();
    clap_complete::generate(arguments.shell, &mut command_line(INSTALLED), INSTALLED, &mut script);
    terminal::say_coloured(&String::from_utf8_lossy(&script));
}
