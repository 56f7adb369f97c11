//! `grazing manual`: manual pages.

use std::path::PathBuf;

use clap::Command;
use clap_mangen::Man;

use crate::arguments::{ManualArguments, command_line};
use crate::commands::INSTALLED;
use crate::failure::Failure;
use crate::folder::OutputFile;
use crate::runner::{CommandOutcome, Plan};

/// Renders the manual pages, `grazing.1` and `grazing-COMMAND.1`.
///
/// # Errors
/// A page cannot be rendered.
pub(crate) fn read(arguments: &ManualArguments) -> Result<Plan<'_>, Failure> {
    let mut program = command_line(INSTALLED);
    program.build();
    let pages =
        std::iter::once(&program).chain(program.get_subcommands().filter(|it| it.get_name() != "help"));
    let files = pages.map(page).collect::<Result<Vec<OutputFile>, Failure>>()?;
    let paths: Vec<_> = files.iter().map(|file| file.path.clone()).collect();
    Ok(Plan::new(|_| Ok(files), CommandOutcome::unlisted).writing(arguments.folder.clone(), paths))
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
