//! The `grazing` program: runs the reproduction, writes figures, tables and a report, and compares
//! with the paper.
//!
//! It is also a library, so that the tests can compare the README's commands with the definition of
//! the command line.

mod archive;
pub mod arguments;
mod attractors;
mod certify;
mod claims;
pub mod codecheck;
pub mod commands;
pub mod compare;
mod data_page;
pub mod examples;
mod explore;
mod exported;
pub mod failure;
pub mod family;
pub mod folder;
mod identify;
mod installed;
pub mod layout;
pub mod library;
mod limits;
mod new;
mod oscillator;
pub mod outputs;
mod part;
mod progress;
mod project;
mod readme;
mod report;
pub mod reproduce;
mod signals;
mod system;
pub mod tables;
mod template;
pub mod terminal;
mod unfold;
pub mod variation;
mod versions;
mod visual;

use arguments::{Arguments, Command};
use failure::Failure;

/// Runs the command that the command line names.
///
/// # Errors
/// [`Failure`], which knows its message and its exit code.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    signals::soften_limits();
    match &arguments.command {
        Command::Reproduce(arguments) => reproduce::run(arguments),
        Command::Compare(arguments) => compare::run(arguments),
        Command::Claims(arguments) => claims::run(arguments),
        Command::Certify(arguments) => certify::run(arguments),
        Command::Report(arguments) => report::run(arguments),
        Command::Unfold(arguments) if !arguments.vary.is_empty() => family::run(arguments),
        Command::Unfold(arguments) => unfold::run(arguments),
        Command::Attractors(arguments) => attractors::run(arguments),
        Command::Explore(arguments) => explore::run(arguments),
        Command::Identify(arguments) => identify::run(arguments),
        Command::Merge(arguments) => family::merge(arguments),
        Command::New(arguments) => new::run(arguments),
        Command::Export(arguments) => exported::run(arguments),
        Command::Archive(arguments) => archive::run(arguments),
        Command::Completions(arguments) => {
            installed::completions(arguments);
            Ok(())
        }
        Command::Manual(arguments) => installed::manual(arguments),
    }
}
