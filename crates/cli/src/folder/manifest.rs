//! The list of the files of one run, written after them. It tells the next run which files it may
//! replace, whether they come from one run, and whether that run is incomplete.

use std::fmt::Write;
use std::path::{Component, Path, PathBuf};

use grazing_report::FileDigest;

use super::{OutputFile, read, with_slashes};
use crate::failure::Failure;

/// The list, in the folder of results: lines that `sha256sum --check` reads.
pub(crate) const MANIFEST: &str = "manifest.sha256";
/// The subfolder for incomplete results if the folder holds complete ones.
pub(super) const UNFINISHED: &str = "unfinished";

/// What the files of a list come from.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum ManifestOrigin {
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

impl ManifestOrigin {
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
pub(super) struct FileList {
    pub(super) origin: ManifestOrigin,
    /// The digest and the path of each file.
    pub(super) files: Vec<(String, String)>,
}

impl FileList {
    pub(super) fn of<'f>(files: impl IntoIterator<Item = &'f OutputFile>, origin: ManifestOrigin) -> Self {
        let line = |file: &OutputFile| {
            let FileDigest { path, sha256, .. } = FileDigest::of(with_slashes(&file.path), &file.content);
            (sha256, path)
        };
        Self { origin, files: files.into_iter().map(line).collect() }
    }

    /// The list in a folder, if there is one that can be read.
    pub(super) fn read(folder: &Path) -> Option<Self> {
        let text = String::from_utf8(read(&folder.join(MANIFEST)).ok()?).ok()?;
        let (head, lines) = text.split_once('\n')?;
        let origin = ManifestOrigin::of_head(head)?;
        let line = |line: &str| {
            let (digest, path) = line.split_once("  ")?;
            // A list never leads out of its folder.
            let is_within = Path::new(path).components().all(|part| matches!(part, Component::Normal(_)));
            is_within.then(|| (digest.to_owned(), path.to_owned()))
        };
        Some(Self { origin, files: lines.lines().map(line).collect::<Option<_>>()? })
    }

    pub(super) fn file(&self) -> OutputFile {
        let mut text = format!("{}\n", self.origin.head());
        for (digest, path) in &self.files {
            // Writing to a string cannot fail.
            let _ = writeln!(text, "{digest}  {path}");
        }
        OutputFile { path: PathBuf::from(MANIFEST), content: text.into_bytes() }
    }

    /// The files that are in the folder as the list has them.
    pub(super) fn intact(&self, folder: &Path) -> Vec<&str> {
        let is_intact = |(digest, path): &&(String, String)| {
            read(&folder.join(path)).is_ok_and(|content| FileDigest::of("", &content).sha256 == *digest)
        };
        self.files.iter().filter(is_intact).map(|(_, path)| path.as_str()).collect()
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
        (ManifestOrigin::Several, _) => Err(Failure::input(format!(
            "{}: the results in it come from several runs, by {MANIFEST}: compute all of them again",
            folder.display()
        ))),
        (ManifestOrigin::Run | ManifestOrigin::Part(_), false) => Ok(()),
        (ManifestOrigin::Incomplete, _) => Err(Failure::input(format!(
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
    let origin = if incomplete { ManifestOrigin::Incomplete } else { ManifestOrigin::Run };
    FileList::of(files, origin).file()
}

/// The folder for the files of a run that were to go to `folder`: incomplete results never replace
/// results that may be complete, but go into a subfolder.
///
/// Results may be complete unless the list has them as the files of an incomplete run.
pub(crate) fn place_of_run(folder: &Path, files: &[OutputFile], incomplete: bool) -> PathBuf {
    let list = FileList::read(folder).filter(|list| list.origin == ManifestOrigin::Incomplete);
    let replaceable = list.as_ref().map_or(Vec::new(), |list| list.intact(folder));
    let is_whole = |file: &OutputFile| {
        let is_listed = replaceable.iter().any(|path| file.path == Path::new(path));
        folder.join(&file.path).is_file() && !is_listed
    };
    if incomplete && files.iter().any(is_whole) { folder.join(UNFINISHED) } else { folder.to_owned() }
}
