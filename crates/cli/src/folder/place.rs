//! The place of a file that is written: only regular files are replaced, and only in the folder
//! that was named.

use std::ffi::{OsStr, OsString};
use std::io;
use std::path::{Path, PathBuf};

use grazing_source::what_is;

use crate::failure::Failure;

/// What is said of a name that the system does not take.
pub(super) const TOO_LONG: &str = "the name is too long for the file system";

/// The place of a file that is to be written: its path, or through symbolic links the regular file
/// that they name, so that the links stay.
///
/// # Errors
/// Something else is there: a folder, a device, a link that leads nowhere; or the system does not
/// report what is there.
pub(crate) fn to_write(path: &Path) -> Result<PathBuf, Failure> {
    let refuse = |what: &str| {
        let remedy = "is not replaced: move it away, or choose another place with --output";
        Failure::unwritten(format!("{}: is {what}, not a regular file, and {remedy}", path.display()))
    };
    let failed = |reason: io::Error| match reason.kind() {
        io::ErrorKind::InvalidFilename => {
            Failure::input(format!("{}: {TOO_LONG}; choose a shorter one with --output", path.display()))
        }
        _ => Failure::file(path, &reason),
    };
    let here = match path.symlink_metadata() {
        Ok(here) => here,
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(path.to_owned()),
        Err(error) => return Err(failed(error)),
    };
    if !here.is_symlink() {
        return if here.is_file() { Ok(path.to_owned()) } else { Err(refuse(what_is(here.file_type()))) };
    }
    match path.metadata() {
        Ok(named) if named.is_file() => path.canonicalize().map_err(failed),
        Ok(named) => Err(refuse(what_is(named.file_type()))),
        // A link to nothing, or one that leads to itself.
        Err(_) => Err(refuse("a symbolic link that leads to no file")),
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
