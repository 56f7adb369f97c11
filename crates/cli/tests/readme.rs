//! The commands that the README shows are commands that exist.

mod program;

use std::fs;

use clap::Parser;
use clap::error::ErrorKind;
use grazing_cli::arguments::Arguments;
use program::repository;

/// The lines of the README that begin with `cargo xtask`, as in a block of commands.
fn commands() -> Vec<String> {
    let readme = fs::read_to_string(repository().join("README.md")).expect("there is a README.md");
    readme
        .lines()
        .map(|line| line.trim().trim_start_matches("$ ").to_owned())
        .filter(|line| line.starts_with("cargo xtask"))
        .collect()
}

#[test]
fn the_readme_shows_all_commands() {
    let commands = commands();
    for wanted in ["cargo xtask reproduce", "cargo xtask compare", "cargo xtask report"] {
        assert!(
            commands.iter().any(|command| command.starts_with(wanted)),
            "no line `{wanted}` in README.md"
        );
    }
}

#[test]
fn every_command_of_the_readme_is_understood() {
    for command in commands() {
        let words = command.split('#').next().unwrap_or_default().split_whitespace().skip(2);
        match Arguments::try_parse_from(std::iter::once("grazing").chain(words)) {
            Ok(_) => {}
            Err(error) if matches!(error.kind(), ErrorKind::DisplayHelp | ErrorKind::DisplayVersion) => {}
            Err(error) => panic!("README.md: `{command}`: {error}"),
        }
    }
}
