//! The output folder: writing files whole, and reporting how it differs from what the code produces.

mod batch;
mod difference;
mod manifest;
mod place;
mod temporaries;

use std::collections::{BTreeMap, BTreeSet};
use std::ffi::OsStr;
use std::fmt::Write as _;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

pub(crate) use batch::{Batch, Listed};
pub use difference::Differences;
pub(crate) use manifest::{MANIFEST, list, refuse_mixture};
pub use place::name_for;
pub(crate) use place::to_write;
pub use temporaries::remove_own_temporaries;
pub(crate) use temporaries::{TemporaryFolder, sweep};

use crate::failure::Failure;
use tempfile::NamedTempFile;
use temporaries::{UNFINISHED, unfinished};

/// The most bytes of a file that the program writes, and so of one that it reads again.
pub(crate) const MOST_BYTES: u64 = 1_000_000_000;
/// The subfolder of the tables.
pub(crate) const DATA: &str = "data";

/// A file that the code writes: its path in the output folder, and its content.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OutputFile {
    /// The path from the output folder, as `data/coefficients.csv`.
    pub path: PathBuf,
    /// The content.
    pub content: Vec<u8>,
}

/// The effect of writing on a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Change {
    /// The file was not there before.
    New,
    /// The file had another content before.
    Updated,
    /// The file had this content already and was left alone.
    Unchanged,
    /// The run before wrote the file, and this one does not.
    Removed,
}

/// Checks that files can be written into the folder and its subfolders, and that those that are there
/// can be read, which decides whether they change; leaves no trace of the test.
///
/// A folder that does not exist is not created: the nearest one above it that exists is tested.
/// Stale files are deleted.
///
/// # Errors
/// The folder is not writable, or something other than a regular file is in a file's place.
pub fn ensure_writable(folder: &Path, files: &[PathBuf]) -> Result<(), Failure> {
    let within = files.iter().filter_map(|file| Some(folder.join(file).parent()?.to_owned()));
    for place in within.chain([folder.to_owned()]).collect::<BTreeSet<_>>() {
        if let Some((path, reason)) = obstacle(&place) {
            let path = path.display();
            let remedy = "choose a folder for the outputs with --output DIR";
            return Err(Failure::input(format!("{path}: cannot be written: {reason}; {remedy}")));
        }
        sweep(&place);
    }
    files.iter().try_for_each(|file| {
        let path = folder.join(file);
        to_write(&path)?;
        readable(&path).map_err(|reason| {
            let remedy = "move it away, or choose another folder with --output";
            Failure::unwritten(format!("{}: cannot be read: {reason}; {remedy}", path.display()))
        })
    })
}

/// Checks that a file, if it is there, can be read and is no longer than those that the program writes.
fn readable(path: &Path) -> io::Result<()> {
    match fs::File::open(path).and_then(|file| file.metadata()) {
        Ok(data) if data.len() > MOST_BYTES => {
            Err(io::Error::other(format!("it is longer than {MOST_BYTES} bytes")))
        }
        Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
        _ => Ok(()),
    }
}

/// The obstacle to writing files into the folder, or into the nearest existing one above it: where, and why.
pub(crate) fn obstacle(folder: &Path) -> Option<(PathBuf, String)> {
    let existing = folder
        .ancestors()
        .map(|path| if path.as_os_str().is_empty() { Path::new(".") } else { path })
        .find(|path| path.symlink_metadata().is_ok())
        .unwrap_or(Path::new("."));
    // The folders that are to be created: the system decides whether it accepts each name.
    let below = folder.strip_prefix(existing).unwrap_or(folder).components();
    let is_too_long = |name: &Path| {
        let error = existing.join(name).symlink_metadata().err();
        error.is_some_and(|error| error.kind() == io::ErrorKind::InvalidFilename)
    };
    if below.map(|name| Path::new(name.as_os_str())).any(is_too_long) {
        return Some((folder.to_owned(), place::TOO_LONG.to_owned()));
    }
    let reason =
        if existing.is_dir() { plain(&unfinished(existing).err()?) } else { "it is not a folder".to_owned() };
    Some((existing.to_owned(), reason))
}

/// Writes all files or none, and never through symbolic links: each file is first written to a temporary file
/// beside its place, and all are moved into place once all are complete.
///
/// # Errors
/// A file cannot be written. Temporary files are removed; a file is old or new, never in between.
pub fn write(folder: &Path, files: &[OutputFile]) -> Result<Vec<Change>, Failure> {
    let folders: BTreeSet<PathBuf> =
        files.iter().filter_map(|file| Some(folder.join(&file.path).parent()?.to_owned())).collect();
    folders.iter().for_each(|folder| sweep(folder));
    let mut staged = Vec::new();
    for file in files {
        let place = folder.join(&file.path);
        to_write(&place)?;
        staged.push((stage(&place, &file.content).map_err(|reason| Failure::file(&place, &reason))?, place));
    }
    let finish = |((change, unfinished), place): ((Change, Option<NamedTempFile>), PathBuf)| {
        if let Some(unfinished) = unfinished {
            unfinished.persist(&place).map_err(|error| Failure::file(&place, &error.error))?;
        }
        Ok(change)
    };
    staged.into_iter().map(finish).collect()
}

/// Writes all files with [`write`], and returns the change of each by its path.
pub(crate) fn written(folder: &Path, files: &[OutputFile]) -> Result<Vec<(String, Change)>, Failure> {
    let names = files.iter().map(|file| folder.join(&file.path).display().to_string());
    Ok(names.zip(write(folder, files)?).collect())
}

/// The content of a file that the program wrote, or of one in its place.
pub(crate) fn read(path: &Path) -> io::Result<Vec<u8>> {
    grazing_input::read_bytes(path, MOST_BYTES)
}

/// Removes a file if it is there.
pub(crate) fn remove(path: &Path) -> Result<(), Failure> {
    if path.is_file() { fs::remove_file(path).map_err(|reason| Failure::file(path, &reason)) } else { Ok(()) }
}

impl Change {
    /// The word for it.
    fn word(self) -> &'static str {
        match self {
            Self::New => "new",
            Self::Updated => "updated",
            Self::Unchanged => "unchanged",
            Self::Removed => "removed",
        }
    }
}

/// The most new or unchanged files of a folder that are listed one by one.
const LISTED: usize = 5;

/// A line for each file, or for the many new or unchanged ones of a folder, and one that counts them all.
pub(crate) fn summary(changes: &[(String, Change)]) -> String {
    let folder = |name: &str| name.rfind(['/', '\\']).map_or(String::new(), |end| name[..=end].to_owned());
    let mut groups: BTreeMap<(String, &str), Vec<&str>> = BTreeMap::new();
    for (name, change) in changes {
        groups.entry((folder(name), change.word())).or_default().push(name);
    }
    let mut lines: Vec<(String, String)> = Vec::new();
    for ((folder, word), names) in &groups {
        let alike = names.len() > LISTED && ["new", "unchanged"].contains(word);
        match alike {
            true => lines.push((folder.clone(), format!("{} files {word}", names.len()))),
            false => lines.extend(names.iter().map(|name| ((*name).to_owned(), (*word).to_owned()))),
        }
    }
    let width = lines.iter().map(|(name, _)| name.chars().count()).max().unwrap_or(0);
    let mut text: String = lines.iter().map(|(name, word)| format!("{name:width$}  {word}\n")).collect();
    let count = |wanted: Change| changes.iter().filter(|(_, change)| *change == wanted).count();
    let [new, updated, unchanged, removed] =
        [Change::New, Change::Updated, Change::Unchanged, Change::Removed].map(count);
    let removed = if removed > 0 { format!(", {removed} removed") } else { String::new() };
    let files = counted(changes.len());
    let _ = writeln!(text, "{files}: {new} new, {updated} updated, {unchanged} unchanged{removed}.");
    text
}

/// The page among the files, or else the first figure, or else the first file: what a user looks at next.
pub(crate) fn first(changes: &[(String, Change)]) -> &str {
    let written = || changes.iter().filter(|(_, change)| *change != Change::Removed);
    let with = |ends: &[&str]| written().find(|(path, _)| ends.iter().any(|end| path.ends_with(end)));
    let shown = with(&[".html"]).or_else(|| with(&[".svg", ".pdf", ".png"]));
    shown.or(changes.first()).map_or("", |(path, _)| path)
}

/// A number of files, in words.
pub(crate) fn counted(files: usize) -> String {
    if files == 1 { "1 file".to_owned() } else { format!("{files} files") }
}

/// The path with slashes between its parts, on any system.
pub(crate) fn with_slashes(path: &Path) -> String {
    path.components().map(|part| part.as_os_str().to_string_lossy()).collect::<Vec<_>>().join("/")
}

/// Adds how the folder differs from the files: missing ones, other contents, and, if the files are
/// `complete`, files in the folder that the code does not produce; `known` are files that belong
/// there anyway.
///
/// # Errors
/// The folder or a file in it cannot be read.
pub fn compare(
    folder: &Path,
    files: &[OutputFile],
    known: &[&str],
    complete: bool,
    found: &mut Differences,
) -> Result<(), Failure> {
    for file in files {
        let path = folder.join(&file.path);
        let what = match read(&path) {
            Ok(content) if content == file.content => continue,
            Ok(content) => difference::of_content(&path, &content, &file.content),
            Err(error) if error.kind() == io::ErrorKind::NotFound => "missing".to_owned(),
            Err(error) => return Err(Failure::file(&path, &error)),
        };
        found.differing.push(format!("{}: {what}", path.display()));
    }
    let expected = |path: &Path| {
        files.iter().any(|file| file.path == path) || known.iter().any(|known| Path::new(known) == path)
    };
    for path in if complete { listed(folder)? } else { Vec::new() } {
        if !expected(&path) {
            let what = "not produced by the code; remove it if it is left over from an earlier version or an interrupted run";
            found.unexpected.push(format!("{}: {what}", folder.join(path).display()));
        }
    }
    Ok(())
}

/// The paths of everything in the folder and its subfolder for data, in order; hidden files only if
/// they are unfinished files of the program.
fn listed(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let mut paths = Vec::new();
    for subfolder in [Path::new(""), Path::new(DATA)] {
        let place = folder.join(subfolder);
        let entries = match fs::read_dir(&place) {
            Ok(entries) => entries,
            Err(error) if error.kind() == io::ErrorKind::NotFound => continue,
            Err(error) => return Err(Failure::file(&place, &error)),
        };
        for entry in entries {
            let name = entry.map_err(|error| Failure::file(&place, &error))?.file_name();
            let path = subfolder.join(&name);
            if path != Path::new(DATA) && !is_foreign(&name) {
                paths.push(path);
            }
        }
    }
    paths.sort();
    Ok(paths)
}

/// Whether a name is that of a hidden file of another program, such as a desktop or an editor.
fn is_foreign(name: &OsStr) -> bool {
    let name = name.to_string_lossy();
    name.starts_with('.') && !name.starts_with(UNFINISHED)
}

/// The change that writing will make to the file at a place, with the temporary file that holds its
/// content if it has to be written.
fn stage(place: &Path, content: &[u8]) -> io::Result<(Change, Option<NamedTempFile>)> {
    let change = match read(place) {
        Ok(present) if present == content => return Ok((Change::Unchanged, None)),
        Ok(_) => Change::Updated,
        Err(error) if error.kind() == io::ErrorKind::NotFound => Change::New,
        Err(error) => return Err(error),
    };
    let folder = place.parent().unwrap_or(Path::new(""));
    fs::create_dir_all(folder)?;
    let mut file = unfinished(folder)?;
    if change == Change::Updated {
        // The permissions of the file stay as they were.
        file.as_file().set_permissions(place.metadata()?.permissions())?;
    }
    file.write_all(content)?;
    // The content must be on the disk before the name is, or a crash could leave an empty file
    // under it.
    file.as_file().sync_all()?;
    Ok((change, Some(file)))
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
