//! `grazing new`: a description to edit, with comments, which can be unfolded as it is.

use std::fs::OpenOptions;
use std::io::{ErrorKind, Write};
use std::path::Path;

use crate::arguments;
use crate::failure::Failure;
use crate::project::EXAMPLE_FILES;
use crate::terminal;

/// A description that a user begins with.
pub struct Kind {
    /// The name on the command line; of an example, its file name without the ending.
    pub name: &'static str,
    /// A line about the oscillator that it describes.
    pub about: &'static str,
    /// The text of the file.
    pub text: &'static str,
}

/// The kinds that are not examples.
const PLAIN: [Kind; 3] = [
    Kind {
        name: "plain",
        about: "A mass on a spring beside a wall at x = 0, without units",
        text: include_str!("new/plain.toml"),
    },
    Kind {
        name: "moving-wall",
        about: "A mass over a table that shakes: the wall moves",
        text: include_str!("new/moving-wall.toml"),
    },
    Kind {
        name: "si",
        about: "A rig in metres, kilograms and seconds, its stop at a distance",
        text: include_str!("new/si.toml"),
    },
];

/// All kinds: the plain ones, and the examples.
pub fn kinds() -> impl Iterator<Item = Kind> {
    let example = |(file, text): &(&'static str, &'static str)| Kind {
        name: file.trim_end_matches(".toml"),
        about: text.lines().find_map(|line| line.strip_prefix("name = \"")?.split('"').next()).unwrap_or(""),
        text,
    };
    PLAIN.into_iter().chain(EXAMPLE_FILES.iter().map(example))
}

/// Writes the file and prints how to use it.
///
/// # Errors
/// The file exists already, or it cannot be written.
pub(crate) fn run(arguments: &arguments::New) -> Result<(), Failure> {
    let file = &arguments.file;
    let kind = kinds().find(|kind| kind.name == arguments.kind);
    let kind =
        kind.ok_or_else(|| Failure::input(format!("--kind {}: there is no such kind", arguments.kind)))?;
    write_new(file, &terminal::as_started(kind.text))?;
    let shown = file.display();
    terminal::say(&format!(
        "{shown} is written. Its comments explain every key; it can be unfolded as it is.\n"
    ));
    terminal::say_next(&format!("edit it, then cargo xtask unfold {shown}"));
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
