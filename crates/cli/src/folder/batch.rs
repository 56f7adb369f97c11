//! The computed files of a folder: written as those of a run or of a part of one, or compared with what is there.

use std::path::{Path, PathBuf};
use std::slice;

use super::manifest::{FileList, MANIFEST, ManifestOrigin, UNFINISHED, list, place_of_run};
use super::temporaries::TemporaryFolder;
use super::{Change, Differences, OutputFile, compare, remove, write, written};
use crate::failure::Failure;
use crate::terminal;

/// Computed files, and the folder that they belong to.
#[derive(Default)]
pub(crate) struct Batch {
    pub(crate) folder: PathBuf,
    pub(crate) files: Vec<OutputFile>,
    pub(crate) listed: Listed,
    /// Whether something failed or is incomplete.
    pub(crate) incomplete: bool,
    /// Other files that belong in the folder, if it is to hold nothing else.
    pub(crate) beside: Option<&'static [&'static str]>,
}

/// How files are listed in their folder.
#[derive(Default, PartialEq)]
pub(crate) enum Listed {
    /// As all files of a run.
    #[default]
    Run,
    /// As those of some outputs, with a digest of what these are computed from.
    Part(String),
    No,
}

/// The change of each file, by its path.
pub(crate) type PathChanges = Vec<(String, Change)>;

impl Batch {
    /// The files of a run in a folder.
    pub(crate) fn run(folder: &Path, files: Vec<OutputFile>) -> Self {
        Self { folder: folder.to_owned(), files, ..Self::default() }
    }

    /// Files that no list names, as others may lie beside them.
    pub(crate) fn unlisted(folder: &Path, files: Vec<OutputFile>) -> Self {
        Self { listed: Listed::No, ..Self::run(folder, files) }
    }

    /// The folder that holds the files, or to which they go.
    pub(crate) fn place(&self) -> PathBuf {
        place_of_run(&self.folder, &self.files, self.incomplete)
    }

    /// Writes the files, and the list of them last, to [`place`](Self::place), of which a note says if it is not the folder.
    /// Those of a run replace the ones of the run before, of which it deletes what it does not write.
    ///
    /// # Errors
    /// Those of [`write`]. What can be saved of files that are listed is saved beside the results.
    pub(crate) fn write(&self) -> Result<PathChanges, Failure> {
        let place = self.place();
        if place != self.folder {
            let here = if self.folder.as_os_str().is_empty() { Path::new(".") } else { &self.folder };
            terminal::note(&format!(
                "{}: the results there are kept; the finished part of this run goes to {}",
                here.display(),
                place.display()
            ));
        }
        match &self.listed {
            Listed::Run => match self.written_whole(&place) {
                Some(changes) => Ok(changes),
                None => self.replaced(&place),
            },
            Listed::Part(from) => {
                let before = FileList::read(&place);
                let changes = self.written(&place)?;
                if let Some(list) = self.joined(before, from, &changes) {
                    write(&place, &[list.file()])?;
                }
                Ok(changes)
            }
            Listed::No => written(&place, &self.files),
        }
    }

    /// Writes a folder that does not exist yet under another name, with its list, and renames it, so that all of its files appear at
    /// once; none if that cannot be done.
    fn written_whole(&self, place: &Path) -> Option<PathChanges> {
        let whole = TemporaryFolder::for_place(place).ok()?;
        write(whole.path(), &self.files).ok()?;
        write(whole.path(), &[self.list()]).ok()?;
        whole.move_to(place).ok()?;
        let new = |file: &OutputFile| (place.join(&file.path).display().to_string(), Change::New);
        Some(self.files.iter().map(new).collect())
    }

    /// Writes the files, file by file, into a folder that may hold those of another run, and the list last.
    fn replaced(&self, place: &Path) -> Result<PathChanges, Failure> {
        let left = self.left(place);
        let mut changes = self.written(place)?;
        for path in left {
            remove(&path)?;
            changes.push((path.display().to_string(), Change::Removed));
        }
        write(place, &[self.list()])?;
        Ok(changes)
    }

    /// Writes the files, or saves what can be saved of them: each file that can be goes to the subfolder for incomplete results.
    fn written(&self, folder: &Path) -> Result<PathChanges, Failure> {
        let failure = match written(folder, &self.files) {
            Ok(changes) => return Ok(changes),
            Err(failure) => failure,
        };
        let place = if folder.ends_with(UNFINISHED) { folder.to_owned() } else { folder.join(UNFINISHED) };
        let is_kept = |file: &&OutputFile| write(&place, slice::from_ref(*file)).is_ok();
        let kept: Vec<&OutputFile> = self.files.iter().filter(is_kept).collect();
        let count = kept.len();
        Err(match write(&place, &[FileList::of(kept, ManifestOrigin::Incomplete).file()]) {
            Ok(_) if count > 0 => {
                failure.but(&format!("{count} of {} files are in {}", self.files.len(), place.display()))
            }
            _ => failure,
        })
    }

    /// The list of the files as those of a run.
    fn list(&self) -> OutputFile {
        list(&self.files, self.incomplete)
    }

    /// The files of the run before that this one does not write.
    fn left(&self, place: &Path) -> Vec<PathBuf> {
        let Some(before) = FileList::read(place) else { return Vec::new() };
        let intact = before.intact(place);
        if intact.len() < before.files.len() {
            let (other, all) = (before.files.len() - intact.len(), before.files.len());
            terminal::note(&format!(
                "{}: {other} of {all} files differed from those that {MANIFEST} lists: they were changed, or belong to a run that \
                 did not finish",
                place.display()
            ));
        }
        let is_left = |path: &&str| self.files.iter().all(|file| file.path != Path::new(path));
        intact.into_iter().filter(is_left).map(|path| place.join(path)).collect()
    }

    /// The list of these files and of those that were there before, which says whether all belong together; none if it stays.
    fn joined(&self, before: Option<FileList>, from: &str, changes: &PathChanges) -> Option<FileList> {
        let origin =
            if self.incomplete { ManifestOrigin::Incomplete } else { ManifestOrigin::Part(from.to_owned()) };
        let mut list = FileList::of(&self.files, origin);
        let Some(mut before) = before else { return Some(list) };
        if before.origin == ManifestOrigin::Run
            && changes.iter().all(|(_, change)| *change == Change::Unchanged)
        {
            return None;
        }
        before.files.retain(|(_, path)| list.files.iter().all(|(_, written)| written != path));
        if !before.files.is_empty() && before.origin != list.origin {
            list.origin = ManifestOrigin::Several;
        }
        list.files.append(&mut before.files);
        list.files.sort_by(|(_, one), (_, other)| one.cmp(other));
        Some(list)
    }

    /// Adds how the folder differs from the files, and from the list of a run.
    ///
    /// # Errors
    /// The folder or a file in it cannot be read.
    pub(crate) fn compare(&self, found: &mut Differences) -> Result<(), Failure> {
        let place = self.place();
        compare(&place, &self.files, self.beside.unwrap_or_default(), self.beside.is_some(), found)?;
        let list = (self.listed == Listed::Run).then(|| self.list());
        compare(&place, list.as_slice(), &[], false, found)
    }
}
