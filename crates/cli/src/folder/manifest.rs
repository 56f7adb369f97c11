//! The list of the files of one run, written after them. It tells the next run which files it may
//! replace, whether they come from one run, and whether that run is incomplete.

use std::fmt::Write;
use std::path::{Component, Path, PathBuf};

use grazing_report::FileDigest;

use super::{Change, OutputFile, read, remove, with_slashes, write, written};
use crate::failure::Failure;
use crate::terminal;

/// The list, in the folder of results: lines that `sha256sum --check` reads.
pub(crate) const MANIFEST: &str = "manifest.sha256";
/// The subfolder for incomplete results if the folder holds complete ones.
const UNFINISHED: &str = "unfinished";

/// The first line of the list, of a complete and of an incomplete run.
const HEADS: [&str; 2] = ["# The files of one run.", "# The files of one run, which is incomplete."];

/// The files of one run.
struct FileList {
    incomplete: bool,
    /// The digest and the path of each file.
    files: Vec<(String, String)>,
}

impl FileList {
    fn of(files: &[OutputFile], incomplete: bool) -> Self {
        let line = |file: &OutputFile| {
            let FileDigest { path, sha256, .. } = FileDigest::of(with_slashes(&file.path), &file.content);
            (sha256, path)
        };
        Self { incomplete, files: files.iter().map(line).collect() }
    }

    /// The list in a folder, if there is one that can be read.
    fn read(folder: &Path) -> Option<Self> {
        let text = String::from_utf8(read(&folder.join(MANIFEST)).ok()?).ok()?;
        let (head, lines) = text.split_once('\n')?;
        let incomplete = HEADS.iter().position(|known| *known == head)? == 1;
        let line = |line: &str| {
            let (digest, path) = line.split_once("  ")?;
            // A list never leads out of its folder.
            let is_within = Path::new(path).components().all(|part| matches!(part, Component::Normal(_)));
            is_within.then(|| (digest.to_owned(), path.to_owned()))
        };
        Some(Self { incomplete, files: lines.lines().map(line).collect::<Option<_>>()? })
    }

    fn file(&self) -> OutputFile {
        let mut text = format!("{}\n", HEADS[usize::from(self.incomplete)]);
        for (digest, path) in &self.files {
            // Writing to a string cannot fail.
            let _ = writeln!(text, "{digest}  {path}");
        }
        OutputFile { path: PathBuf::from(MANIFEST), content: text.into_bytes() }
    }

    /// The files that are in the folder as the list has them.
    fn intact(&self, folder: &Path) -> Vec<&str> {
        let is_intact = |(digest, path): &&(String, String)| {
            read(&folder.join(path)).is_ok_and(|content| FileDigest::of("", &content).sha256 == *digest)
        };
        self.files.iter().filter(is_intact).map(|(_, path)| path.as_str()).collect()
    }
}

/// Writes the files of a run, deletes those of the run before that it does not write, and writes
/// the list last; returns the change of each file by its path.
///
/// Incomplete results, such as those of a run that was cut off, go where [`place_to_write`] puts them.
///
/// # Errors
/// Those of [`write`].
pub(crate) fn write_run(
    folder: &Path,
    files: &[OutputFile],
    incomplete: bool,
) -> Result<Vec<(String, Change)>, Failure> {
    let folder = &place_to_write(folder, files, incomplete);
    let mut left = Vec::new();
    if let Some(before) = FileList::read(folder) {
        let intact = before.intact(folder);
        if intact.len() < before.files.len() {
            let (other, all) = (before.files.len() - intact.len(), before.files.len());
            terminal::note(&format!(
                "{}: {other} of {all} files differed from those that {MANIFEST} lists: they were changed, or belong to a run that \
                 did not finish",
                folder.display()
            ));
        }
        let is_left = |path: &&str| files.iter().all(|file| file.path != Path::new(path));
        left.extend(intact.into_iter().filter(is_left).map(|path| folder.join(path)));
    }
    let mut changes = written(folder, files)?;
    for path in left {
        remove(&path)?;
        changes.push((path.display().to_string(), Change::Removed));
    }
    write(folder, &[list(files, incomplete)])?;
    Ok(changes)
}

/// Makes sure that a folder with a list has all files of that run, and that the run was complete.
///
/// # Errors
/// Files are missing or changed, or the run was incomplete.
pub(crate) fn refuse_mixture(folder: &Path) -> Result<(), Failure> {
    let Some(list) = FileList::read(folder) else { return Ok(()) };
    let (intact, all) = (list.intact(folder).len(), list.files.len());
    match (list.incomplete, intact < all) {
        (false, false) => Ok(()),
        (true, _) => Err(Failure::input(format!(
            "{}: the results in it are incomplete: run the command again",
            folder.display()
        ))),
        (_, true) => Err(Failure::input(format!(
            "{}: {} of {all} files differ from those that {MANIFEST} lists: compute them again",
            folder.display(),
            all - intact
        ))),
    }
}

/// The list of the files of a run.
pub(crate) fn list(files: &[OutputFile], incomplete: bool) -> OutputFile {
    FileList::of(files, incomplete).file()
}

/// The folder for the files of a run that were to go to `folder`: incomplete results never replace
/// results that may be complete, but go into a subfolder.
///
/// Results may be complete unless the list has them as the files of an incomplete run.
pub(crate) fn place_of_run(folder: &Path, files: &[OutputFile], incomplete: bool) -> PathBuf {
    let list = FileList::read(folder).filter(|list| list.incomplete);
    let replaceable = list.as_ref().map_or(Vec::new(), |list| list.intact(folder));
    let is_whole = |file: &OutputFile| {
        let is_listed = replaceable.iter().any(|path| file.path == Path::new(path));
        folder.join(&file.path).is_file() && !is_listed
    };
    if incomplete && files.iter().any(is_whole) { folder.join(UNFINISHED) } else { folder.to_owned() }
}

/// The folder that [`place_of_run`] chooses; prints a note if it is another one than `folder`.
pub(crate) fn place_to_write(folder: &Path, files: &[OutputFile], incomplete: bool) -> PathBuf {
    let place = place_of_run(folder, files, incomplete);
    if place != folder {
        terminal::note(&format!(
            "{}: the results there are kept; the finished part of this run goes to {}",
            if folder.as_os_str().is_empty() { Path::new(".") } else { folder }.display(),
            place.display()
        ));
    }
    place
}
