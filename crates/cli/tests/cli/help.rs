//! Help is everywhere and tells what a person needs.

use crate::program::{empty_folder, grazing};
use clap::CommandFactory;
use grazing_cli::arguments::Arguments;
use grazing_cli::outputs;

/// The widest line of help that fits a usual terminal.
const WIDTH: usize = 100;

fn help(arguments: &[&str]) -> String {
    let outcome = grazing(empty_folder().path(), arguments);
    assert_eq!((outcome.code, outcome.messages.as_str()), (Some(0), ""), "{arguments:?}");
    outcome.output
}

#[test]
fn the_command_line_is_well_defined() {
    Arguments::command().debug_assert();
}

#[test]
fn help_tells_of_commands_and_exit_codes() {
    let text = help(&["--help"]);
    for told in [
        "reproduce",
        "compare",
        "report",
        "unfold",
        "cargo xtask",
        "2602.22797",
        "Exit codes:",
        "\n  1  ",
        "\n  2  ",
    ] {
        assert!(text.contains(told), "`{told}` is missing in\n{text}");
    }
}

#[test]
fn every_command_has_help_with_examples_and_every_option_is_explained() {
    for command in Arguments::command().get_subcommands() {
        let text = help(&[command.get_name(), "--help"]);
        assert!(text.contains("Examples:\n  cargo xtask "), "{text}");
        assert!(text.contains("Exit codes:"), "{text}");
        for option in command.get_arguments() {
            let explained = option.get_help().is_some_and(|help| help.to_string().len() > 10);
            assert!(explained, "{} {} is not explained", command.get_name(), option.get_id());
        }
    }
}

#[test]
fn help_of_reproduce_lists_every_output_with_its_title() {
    let text = help(&["reproduce", "--help"]);
    for output in outputs::ALL {
        assert!(text.contains(output.name) && text.contains(output.title), "{} is missing", output.name);
    }
}

#[test]
fn help_fits_a_terminal() {
    let commands = Arguments::command();
    let pages = commands.get_subcommands().map(|command| vec![command.get_name(), "--help"]);
    for arguments in pages.chain([vec!["--help"]]) {
        for line in help(&arguments).lines() {
            assert!(line.chars().count() <= WIDTH, "{} characters: {line}", line.chars().count());
        }
    }
}
