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
mod completions;
mod data_page;
pub mod examples;
mod explore;
mod export;
pub mod failure;
pub mod family;
pub mod folder;
mod identify;
pub mod layout;
pub mod library;
mod limits;
mod manual;
mod new;
mod oscillator;
pub mod outputs;
mod part;
mod progress;
mod project;
mod readme;
mod report;
pub mod reproduce;
mod runner;
mod schema;
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
        Command::Reproduce(arguments) => runner::run(|| reproduce::read(arguments), arguments.threads.jobs),
        Command::Compare(arguments) => runner::run(|| compare::read(arguments), arguments.threads.jobs),
        Command::Claims(arguments) => runner::run(|| claims::read(arguments), None),
        Command::Certify(arguments) => runner::run(|| certify::read(arguments), arguments.threads.jobs),
        Command::Report(arguments) => runner::run(|| report::read(arguments), arguments.threads.jobs),
        Command::Unfold(arguments) if !arguments.vary.is_empty() => {
            runner::run(|| family::read(arguments), arguments.threads.jobs)
        }
        Command::Unfold(arguments) => runner::run_each(|| unfold::read(arguments), arguments.threads.jobs),
        Command::Attractors(arguments) => runner::run(|| attractors::read(arguments), arguments.threads.jobs),
        Command::Explore(arguments) => explore::run(arguments),
        Command::Identify(arguments) => runner::run(|| identify::read(arguments), arguments.threads.jobs),
        Command::Merge(arguments) if attractors::has_part(arguments) => {
            runner::run(|| attractors::merge(arguments), None)
        }
        Command::Merge(arguments) => runner::run(|| family::merge(arguments), None),
        Command::Schema(arguments) => {
            schema::run(arguments);
            Ok(())
        }
        Command::Export(arguments) => runner::run(|| export::read(arguments), None),
        Command::New(arguments) => new::run(arguments),
        Command::Archive(arguments) => archive::run(arguments),
        Command::Completions(arguments) => {
            completions::run(arguments);
            Ok(())
        }
        Command::Manual(arguments) => runner::run(|| manual::read(arguments), None),
    }
}
