//! The commands that the README shows are commands that exist.

mod program;

use std::fs;

use clap::Parser;
use clap::error::ErrorKind;
use grazing_claims::ledger::Ledger;
use grazing_cli::arguments::Arguments;
use grazing_cli::outputs;
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
    for wanted in ["cargo xtask reproduce", "cargo xtask compare", "cargo xtask report", "cargo xtask unfold"]
    {
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

#[test]
fn every_column_of_the_data_is_explained() {
    let folder = repository().join("figures/data");
    let page = fs::read_to_string(folder.join("README.md")).expect("the data have a page");
    let mut tables = 0;
    for entry in fs::read_dir(&folder).expect("the folder can be read") {
        let path = entry.expect("the folder can be read").path();
        if path.extension().is_none_or(|extension| extension != "csv") {
            continue;
        }
        let table = fs::read_to_string(&path).expect("a table is text");
        for column in table.lines().next().expect("a table has a header").split(',') {
            assert!(page.contains(&format!("`{column}`")), "{}: {column} is not explained", path.display());
        }
        tables += 1;
    }
    assert!(tables > 20, "the tables were found");
}

#[test]
fn the_readme_counts_the_claims() {
    let ledger = Ledger::of_the_paper().unwrap_or_else(|error| panic!("{error}"));
    let readme = fs::read_to_string(repository().join("README.md")).expect("there is a README.md");
    let count = format!("{} claims", ledger.claims.len());
    assert!(readme.contains(&count), "README.md does not say `{count}`");
}

#[test]
fn the_readme_shows_every_figure() {
    let readme = fs::read_to_string(repository().join("README.md")).expect("there is a README.md");
    for figure in outputs::ALL.iter().filter_map(|output| output.figure()) {
        assert!(readme.contains(&format!("](figures/{figure})")), "README.md does not show {figure}");
    }
}
