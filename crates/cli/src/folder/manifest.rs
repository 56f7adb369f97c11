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

/// What the files of a list come from.
#[derive(Clone, Debug, PartialEq)]
enum Origin {
    /// One run.
    Run,
    /// One run, which is incomplete.
    Incomplete,
    /// Runs of some outputs, all of them computed from the same, which has this digest.
    Part(String),
    /// Several runs, whose files need not belong together.
    Several,
}

/// The first lines of lists; that of outputs computed from the same ends with its digest.
const RUN: &str = "# The files of one run.";
const INCOMPLETE: &str = "# The files of one run, which is incomplete.";
const PART: &str = "# The files of some outputs, computed from ";
const SEVERAL: &str = "# The files of several runs.";

impl Origin {
    fn head(&self) -> String {
        match self {
            Self::Run => RUN.to_owned(),
            Self::Incomplete => INCOMPLETE.to_owned(),
            Self::Part(digest) => format!("{PART}{digest}"),
            Self::Several => SEVERAL.to_owned(),
        }
    }

    fn of_head(head: &str) -> Option<Self> {
        let known = [Self::Run, Self::Incomplete, Self::Several];
        let part = || head.strip_prefix(PART).map(|digest| Self::Part(digest.to_owned()));
        known.into_iter().find(|known| known.head() == head).or_else(part)
    }
}

/// The files of one run.
struct FileList {
    origin: Origin,
    /// The digest and the path of each file.
    files: Vec<(String, String)>,
}

impl FileList {
    fn of<'f>(files: impl IntoIterator<Item = &'f OutputFile>, origin: Origin) -> Self {
        let line = |file: &OutputFile| {
            let FileDigest { path, sha256, .. } = FileDigest::of(with_slashes(&file.path), &file.content);
            (sha256, path)
        };
        Self { origin, files: files.into_iter().map(line).collect() }
    }

    /// The list in a folder, if there is one that can be read.
    fn read(folder: &Path) -> Option<Self> {
        let text = String::from_utf8(read(&folder.join(MANIFEST)).ok()?).ok()?;
        let (head, lines) = text.split_once('\n')?;
        let origin = Origin::of_head(head)?;
        let line = |line: &str| {
            let (digest, path) = line.split_once("  ")?;
            // A list never leads out of its folder.
            let is_within = Path::new(path).components().all(|part| matches!(part, Component::Normal(_)));
            is_within.then(|| (digest.to_owned(), path.to_owned()))
        };
        Some(Self { origin, files: lines.lines().map(line).collect::<Option<_>>()? })
    }

    fn file(&self) -> OutputFile {
        let mut text = format!("{}\n", self.origin.head());
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
    let mut changes = written(folder, files).map_err(|failure| kept(folder, files, failure))?;
    for path in left {
        remove(&path)?;
        changes.push((path.display().to_string(), Change::Removed));
    }
    write(folder, &[list(files, incomplete)])?;
    Ok(changes)
}

/// Writes the files of some outputs beside those that are in the folder, and the list last, which says whether all
/// of them belong together; `from` is a digest of what the outputs are computed from.
///
/// # Errors
/// Those of [`write`].
pub(crate) fn write_part(
    folder: &Path,
    files: &[OutputFile],
    from: &str,
    incomplete: bool,
) -> Result<Vec<(String, Change)>, Failure> {
    let folder = &place_to_write(folder, files, incomplete);
    let before = FileList::read(folder);
    let changes = written(folder, files).map_err(|failure| kept(folder, files, failure))?;
    let is_unchanged = changes.iter().all(|(_, change)| *change == Change::Unchanged);
    let mut list =
        FileList::of(files, if incomplete { Origin::Incomplete } else { Origin::Part(from.to_owned()) });
    if let Some(mut before) = before {
        if before.origin == Origin::Run && is_unchanged {
            return Ok(changes);
        }
        before.files.retain(|(_, path)| list.files.iter().all(|(_, written)| written != path));
        if !before.files.is_empty() && before.origin != list.origin {
            list.origin = Origin::Several;
        }
        list.files.append(&mut before.files);
        list.files.sort_by(|(_, one), (_, other)| one.cmp(other));
    }
    write(folder, &[list.file()])?;
    Ok(changes)
}

/// Saves what can be saved of a run whose files could not be written: each file that can be goes to the subfolder
/// for incomplete results. Returns the failure with what was saved.
fn kept(folder: &Path, files: &[OutputFile], failure: Failure) -> Failure {
    let place = if folder.ends_with(UNFINISHED) { folder.to_owned() } else { folder.join(UNFINISHED) };
    let is_kept = |file: &&OutputFile| write(&place, std::slice::from_ref(*file)).is_ok();
    let kept: Vec<&OutputFile> = files.iter().filter(is_kept).collect();
    let count = kept.len();
    match write(&place, &[FileList::of(kept, Origin::Incomplete).file()]) {
        Ok(_) if count > 0 => {
            failure.but(&format!("{count} of {} files are in {}", files.len(), place.display()))
        }
        _ => failure,
    }
}

/// Makes sure that a folder with a list has all files of that run, and that the run was complete.
///
/// # Errors
/// Files are missing or changed, or the run was incomplete.
pub(crate) fn refuse_mixture(folder: &Path) -> Result<(), Failure> {
    let Some(list) = FileList::read(folder) else { return Ok(()) };
    let (intact, all) = (list.intact(folder).len(), list.files.len());
    match (list.origin, intact < all) {
        (Origin::Several, _) => Err(Failure::input(format!(
            "{}: the results in it come from several runs, by {MANIFEST}: compute all of them again",
            folder.display()
        ))),
        (Origin::Run | Origin::Part(_), false) => Ok(()),
        (Origin::Incomplete, _) => Err(Failure::input(format!(
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
    let origin = if incomplete { Origin::Incomplete } else { Origin::Run };
    FileList::of(files, origin).file()
}

/// The folder for the files of a run that were to go to `folder`: incomplete results never replace
/// results that may be complete, but go into a subfolder.
///
/// Results may be complete unless the list has them as the files of an incomplete run.
pub(crate) fn place_of_run(folder: &Path, files: &[OutputFile], incomplete: bool) -> PathBuf {
    let list = FileList::read(folder).filter(|list| list.origin == Origin::Incomplete);
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
