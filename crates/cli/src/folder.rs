//! The output folder: writing files whole, and telling how it differs from what the code makes.

mod difference;

use std::ffi::OsStr;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

pub use difference::{Difference, Kind};

use crate::failure::Failure;

/// How the names of files that are not finished begin.
const UNFINISHED: &str = ".grazing-";
/// The subfolder of the tables.
pub(crate) const DATA: &str = "data";

/// A file that the code made: its path in the output folder, and its content.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MadeFile {
    /// The path from the output folder, as `data/coefficients.csv`.
    pub path: PathBuf,
    /// The content.
    pub content: Vec<u8>,
}

/// What writing did to a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Change {
    /// It was not there before.
    New,
    /// It had another content before.
    Updated,
    /// It had this content already and was left alone.
    Unchanged,
}

/// Makes sure that files can be written into the folder and its subfolder for data, and leaves no trace of the trial.
///
/// A folder that is not there yet is not made: the trial is held in the nearest one above that is.
///
/// # Errors
/// [`Failure::Unwritable`].
pub fn ensure_writable(folder: &Path, files: &[PathBuf]) -> Result<(), Failure> {
    for place in [folder.to_owned(), folder.join(DATA)] {
        obstacle(&place).map_or(Ok(()), |(path, reason)| Err(Failure::Unwritable { path, reason }))?;
    }
    match files.iter().map(|file| folder.join(file)).find(|file| file.is_dir()) {
        Some(path) => {
            Err(Failure::Unwritable { path, reason: "a folder is in the place of the file".to_owned() })
        }
        None => Ok(()),
    }
}

/// What keeps files from being written into the folder, or into the nearest one above that is there: where, and why.
pub(crate) fn obstacle(folder: &Path) -> Option<(PathBuf, String)> {
    let existing = folder
        .ancestors()
        .map(|path| if path.as_os_str().is_empty() { Path::new(".") } else { path })
        .find(|path| path.symlink_metadata().is_ok())
        .unwrap_or(Path::new("."));
    let reason = if existing.is_dir() {
        plain(&unfinished_file(existing).err()?)
    } else {
        "it is not a folder".to_owned()
    };
    Some((existing.to_owned(), reason))
}

/// Writes all files, or none: each goes into a temporary file beside its place first, and only when all are complete
/// they are moved into their places.
///
/// # Errors
/// [`Failure::File`]. Temporary files are removed; a file is old or new, never in between.
pub fn write(folder: &Path, files: &[MadeFile]) -> Result<Vec<Change>, Failure> {
    let mut staged = Vec::new();
    for file in files {
        let path = folder.join(&file.path);
        staged.push((stage(&path, &file.content).map_err(|reason| failed(&path, reason))?, path));
    }
    staged
        .into_iter()
        .map(|((change, unfinished), path)| {
            if let Some(unfinished) = unfinished {
                unfinished.persist(&path).map_err(|error| failed(&path, error.error))?;
            }
            Ok(change)
        })
        .collect()
}

/// How the folder differs from the files: missing ones, other contents, and, if the files are `complete`, files in the
/// folder that the code does not make; `known` are those that belong there all the same.
///
/// # Errors
/// [`Failure::File`] if the folder or a file in it cannot be read.
pub fn differences(
    folder: &Path,
    files: &[MadeFile],
    known: &[&str],
    complete: bool,
) -> Result<Vec<Difference>, Failure> {
    let mut found = Vec::new();
    for file in files {
        let path = folder.join(&file.path);
        match fs::read(&path) {
            Ok(content) if content == file.content => {}
            Ok(content) => found.push(Difference::content(path, &content, &file.content)),
            Err(error) if error.kind() == io::ErrorKind::NotFound => found.push(Difference::missing(path)),
            Err(error) => return Err(failed(&path, error)),
        }
    }
    if complete {
        let expected = |path: &Path| {
            files.iter().any(|file| file.path == path) || known.iter().any(|known| Path::new(known) == path)
        };
        for path in listed(folder)? {
            if !expected(&path) {
                found.push(Difference::unexpected(folder.join(path)));
            }
        }
    }
    Ok(found)
}

/// The paths of everything in the folder and its subfolder for data, in order; hidden files only if we began them.
fn listed(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let mut paths = Vec::new();
    for subfolder in [Path::new(""), Path::new(DATA)] {
        let place = folder.join(subfolder);
        let entries = match fs::read_dir(&place) {
            Ok(entries) => entries,
            Err(error) if error.kind() == io::ErrorKind::NotFound => continue,
            Err(error) => return Err(failed(&place, error)),
        };
        for entry in entries {
            let name = entry.map_err(|error| failed(&place, error))?.file_name();
            let path = subfolder.join(&name);
            if path != Path::new(DATA) && !is_foreign(&name) {
                paths.push(path);
            }
        }
    }
    paths.sort();
    Ok(paths)
}

/// Whether the name is that of a hidden file of somebody else, as desktops and editors make them.
fn is_foreign(name: &OsStr) -> bool {
    let name = name.to_string_lossy();
    name.starts_with('.') && !name.starts_with(UNFINISHED)
}

/// What writing will do to the file, with the temporary file that holds its content if it has to be written.
fn stage(path: &Path, content: &[u8]) -> io::Result<(Change, Option<NamedTempFile>)> {
    let change = match fs::read(path) {
        Ok(present) if present == content => return Ok((Change::Unchanged, None)),
        Ok(_) => Change::Updated,
        Err(error) if error.kind() == io::ErrorKind::NotFound => Change::New,
        Err(error) => return Err(error),
    };
    let folder = path.parent().unwrap_or(Path::new(""));
    fs::create_dir_all(folder)?;
    let mut unfinished = unfinished_file(folder)?;
    unfinished.write_all(content)?;
    // The content must be on the disk before the name is, or a crash could leave an empty file under it.
    unfinished.as_file().sync_all()?;
    Ok((change, Some(unfinished)))
}

/// A temporary file in the folder, readable as other new files are.
fn unfinished_file(folder: &Path) -> io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(UNFINISHED);
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    builder.tempfile_in(if folder.as_os_str().is_empty() { Path::new(".") } else { folder })
}

/// The system's reason without the name of the temporary file.
fn plain(error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::PermissionDenied => "permission denied".to_owned(),
        io::ErrorKind::ReadOnlyFilesystem => "the file system is read-only".to_owned(),
        io::ErrorKind::StorageFull => "the disk is full".to_owned(),
        kind => kind.to_string(),
    }
}

fn failed(path: &Path, reason: io::Error) -> Failure {
    Failure::File { path: path.to_owned(), reason }
}
