//! Files that accompany an installed program: completions for shells, schemas for editors, and manual pages.

use std::path::PathBuf;

use clap::Command;
use clap_mangen::Man;
use grazing_beyond::parameters;
use grazing_input::Description;

use crate::arguments::{Completions, Manual, Schema, Written, command_line};
use crate::commands::INSTALLED;
use crate::failure::Failure;
use crate::folder::OutputFile;
use crate::runner::{Outcome, Plan};
use crate::terminal;

/// Prints the script with which a shell completes commands and options.
pub(crate) fn completions(arguments: &Completions) {
    let mut script = Vec::new();
    clap_complete::generate(arguments.shell, &mut command_line(INSTALLED), INSTALLED, &mut script);
    terminal::say_coloured(&String::from_utf8_lossy(&script));
}

/// Prints the JSON schema of a kind of file.
pub(crate) fn schema(arguments: &Schema) {
    let schema = match arguments.of {
        Written::Oscillator => Description::requirements().schema("An impact oscillator"),
        Written::Parameters => parameters::requirements().schema("Parameters of the figures of the paper"),
    };
    terminal::say_coloured(&format!("{:#}\n", serde_json::json!(schema)));
}

/// Renders the manual pages, `grazing.1` and `grazing-COMMAND.1`.
///
/// # Errors
/// A page cannot be rendered.
pub(crate) fn manual(arguments: &Manual) -> Result<Plan<'_>, Failure> {
    let mut program = command_line(INSTALLED);
    program.build();
    let pages =
        std::iter::once(&program).chain(program.get_subcommands().filter(|it| it.get_name() != "help"));
    let files = pages.map(page).collect::<Result<Vec<OutputFile>, Failure>>()?;
    let paths: Vec<_> = files.iter().map(|file| file.path.clone()).collect();
    Ok(Plan::new(|_| Ok(files), Outcome::unlisted).writing(arguments.folder.clone(), paths))
}

/// The manual page of a command.
fn page(command: &Command) -> Result<OutputFile, Failure> {
    let (manual, mut content) = (Man::new(command.clone()), Vec::new());
    let path = PathBuf::from(manual.get_filename());
    manual
        .render(&mut content)
        .map_err(|reason| Failure::unwritten(format!("{}: {reason}", path.display())))?;
    Ok(OutputFile { path, content })
}
