//! Every command has help, with all that a user needs.

use std::fs;
use std::process::Command;

use crate::program::{empty_folder, grazing, listing, repository};
use clap::CommandFactory;
use grazing_cli::arguments::Arguments;
use grazing_cli::outputs;

/// The widest line of help that fits a usual terminal.
const WIDTH: usize = 80;

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
        let words = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
        let told = words(&text).contains(&words(&output.title.to_string()));
        assert!(text.contains(output.name) && told, "{} is missing", output.name);
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

#[test]
fn a_program_that_is_installed_names_itself() {
    let mut run = Command::new(env!("CARGO_BIN_EXE_grazing"));
    let run = run.args(["unfold", "--help"]).env_remove("GRAZING_BY_XTASK").output();
    let text = String::from_utf8(run.expect("the program starts").stdout).expect("it is text");
    assert!(text.contains("Examples:\n  grazing unfold ") && !text.contains("xtask"), "{text}");
}

#[test]
fn there_are_completions_for_all_shells_and_a_manual_page_for_each_command() {
    let folder = empty_folder();
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let script = grazing(folder.path(), &["completions", shell]);
        assert!(
            script.code == Some(0) && script.output.contains("time-limit"),
            "{shell}: {}",
            script.messages
        );
    }
    assert_eq!(grazing(folder.path(), &["manual", "man1"]).code, Some(0));
    let commands = Arguments::command();
    for command in
        commands.get_subcommands().map(|command| format!("-{}", command.get_name())).chain([String::new()])
    {
        let path = folder.path().join(format!("man1/grazing{command}.1"));
        let page = fs::read_to_string(path).expect("it was written");
        assert!(
            page.contains("\n.TH grazing") && page.contains("Exit codes") && !page.contains("xtask "),
            "{page}"
        );
    }
}

#[test]
fn outside_a_clone_everything_is_at_hand() {
    let folder = empty_folder();
    let made = grazing(folder.path(), &["reproduce", "--only", "coefficients", "--output", "out"]);
    assert_eq!(made.code, Some(0), "{}", made.messages);
    let file = "data/coefficients.csv";
    let [ours, there] =
        [folder.path().join("out"), repository().join("figures")].map(|it| fs::read(it.join(file)));
    assert_eq!(ours.expect("it was written"), there.expect("it is there"));
    assert_eq!(grazing(folder.path(), &["compare"]).code, Some(0));
    let nowhere = grazing(folder.path(), &["reproduce"]);
    assert!(nowhere.code == Some(2) && nowhere.errors().contains("--output DIR"), "{}", nowhere.messages);
    assert_eq!(listing(folder.path()).iter().filter(|path| !path.contains('/')).collect::<Vec<_>>(), ["out"]);
}
