//! The place of a file that is written: only regular files are replaced, and only in the folder
//! that was named.

use std::ffi::{OsStr, OsString};
use std::io;
use std::path::Path;

use grazing_input::what_is;

use crate::failure::Failure;

/// What is said of a name that the system does not take.
pub(super) const TOO_LONG: &str = "the name is too long for the file system";

/// Checks that a file can be written to a place: nothing is there, or a regular file. Symbolic links are not
/// followed: whoever may write into a folder could lead the content to any file of the user.
///
/// # Errors
/// Something else is there: a folder, a device, a link; or the system does not report what is there.
pub(crate) fn to_write(path: &Path) -> Result<(), Failure> {
    match path.symlink_metadata() {
        Ok(here) if here.is_file() => Ok(()),
        Ok(here) => {
            let what = if here.is_symlink() { "a symbolic link" } else { what_is(here.file_type()) };
            let remedy = "is not replaced: move it away, or choose another place with --output";
            Err(Failure::unwritten(format!(
                "{}: is {what}, not a regular file, and {remedy}",
                path.display()
            )))
        }
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(()),
        Err(error) if error.kind() == io::ErrorKind::InvalidFilename => {
            Err(Failure::input(format!("{}: {TOO_LONG}; choose a shorter one with --output", path.display())))
        }
        Err(error) => Err(Failure::file(path, &error)),
    }
}

/// The name of a folder for the results of a file: its name without ending and without leading
/// dots, which would hide the folder or lead out of its parent.
pub fn name_for(file: &Path) -> OsString {
    const NAMELESS: &str = "oscillator";
    let stem = file.file_stem().unwrap_or_default();
    let name = stem.to_string_lossy();
    match name.trim_start_matches('.') {
        "" => OsString::from(NAMELESS),
        rest if rest.len() < name.len() => OsString::from(rest),
        _ => OsStr::to_owned(stem),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_name_leads_out_of_the_folder() {
        for (file, name) in [
            ("a/duffing.toml", "duffing"),
            ("...toml", "oscillator"),
            ("..toml", "oscillator"),
            (".toml", "toml"),
            ("....b.toml", "b"),
            ("..", "oscillator"),
            ("two.dots.toml", "two.dots"),
        ] {
            assert_eq!(name_for(Path::new(file)), name, "{file}");
        }
    }
}
