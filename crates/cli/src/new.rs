//! `grazing new`: a description to edit, with comments, which can be unfolded as it is.

use std::fs::OpenOptions;
use std::io::{ErrorKind, Write};
use std::path::Path;

use crate::arguments::{self, Template};
use crate::failure::Failure;
use crate::terminal;

impl Template {
    /// What is written.
    pub fn text(self) -> &'static str {
        match self {
            Self::Plain => include_str!("new/plain.toml"),
            Self::MovingWall => include_str!("new/moving-wall.toml"),
            Self::Si => include_str!("new/si.toml"),
        }
    }
}

/// Writes the file and prints what to do with it.
///
/// # Errors
/// Something is in its place already, or it cannot be written.
pub(crate) fn run(arguments: &arguments::New) -> Result<(), Failure> {
    let file = &arguments.file;
    write_new(file, arguments.kind.text())?;
    let shown = file.display();
    terminal::say(&format!(
        "{shown}: written; edit it, then\n\n  \
         cargo xtask unfold {shown}            find and unfold its resonant grazing bifurcations\n\n\
         It can be unfolded as it is. Its comments explain every key; examples/ has more oscillators.\n"
    ));
    Ok(())
}

/// Writes a file that is not there yet; of one that cannot be written whole nothing is left.
fn write_new(path: &Path, text: &str) -> Result<(), Failure> {
    let mut file = OpenOptions::new().write(true).create_new(true).open(path).map_err(|error| {
        let path = path.display();
        match error.kind() {
            ErrorKind::AlreadyExists => Failure::input(format!(
                "{path}: is there already, and is not replaced: move it away, or name another file"
            )),
            ErrorKind::NotFound => Failure::input(format!(
                "{path}: cannot be written: its folder does not exist; make it, or name another file"
            )),
            _ => Failure::input(format!("{path}: cannot be written: {error}; name another file")),
        }
    })?;
    file.write_all(text.as_bytes()).and_then(|()| file.sync_all()).map_err(|error| {
        // The failure to write is what is reported; what is left of the file is worth nothing.
        let _ = std::fs::remove_file(path);
        Failure::file(path, &error)
    })
}
