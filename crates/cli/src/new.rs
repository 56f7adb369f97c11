//! `grazing new`: a description to edit, with comments, which can be unfolded as it is.

use std::fs::OpenOptions;
use std::io::{ErrorKind, Write};
use std::path::Path;

use crate::arguments;
use crate::commands::{self, CommandLine};
use crate::examples::kinds;
use crate::failure::Failure;
use crate::terminal;

/// Writes the file and prints how to use it.
///
/// # Errors
/// The file exists already, or it cannot be written.
pub(crate) fn run(arguments: &arguments::NewArguments) -> Result<(), Failure> {
    let file = &arguments.file;
    let kind = kinds().find(|kind| kind.name == arguments.kind);
    let kind =
        kind.ok_or_else(|| Failure::input(format!("--kind {}: there is no such kind", arguments.kind)))?;
    write_new(file, &kind.text(commands::program()))?;
    let shown = file.display();
    terminal::say(&format!(
        "{shown} is written. Its comments explain every key; it can be unfolded as it is.\n"
    ));
    terminal::say_next("edit it, then ", &CommandLine::own("unfold").with(shown));
    Ok(())
}

/// Writes a file that does not exist yet; if it cannot be written whole, nothing of it is left.
fn write_new(path: &Path, text: &str) -> Result<(), Failure> {
    let mut file = OpenOptions::new().write(true).create_new(true).open(path).map_err(|error| {
        let path = path.display();
        match error.kind() {
            ErrorKind::AlreadyExists => Failure::input(format!(
                "{path}: already exists and is not replaced: move it away or choose another file"
            )),
            ErrorKind::NotFound => Failure::input(format!(
                "{path}: cannot be written: its folder does not exist; create it or choose another file"
            )),
            _ => Failure::input(format!("{path}: cannot be written: {error}; choose another file")),
        }
    })?;
    file.write_all(text.as_bytes()).and_then(|()| file.sync_all()).map_err(|error| {
        // The failure to write is reported; the rest of the file is useless.
        let _ = std::fs::remove_file(path);
        Failure::file(path, &error)
    })
}
