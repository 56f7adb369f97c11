//! Temporary files and folders, which a run finishes or deletes: its own, and those left by runs that died.

use std::collections::BTreeSet;
use std::ffi::OsStr;
use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io;
use std::path::{Path, PathBuf};
use std::process;
use std::sync::{Mutex, PoisonError};

use tempfile::{Builder, NamedTempFile, TempDir};

/// The beginning of the names of unfinished files; the number of the process follows.
pub(super) const UNFINISHED: &str = ".grazing-";
/// The beginning of the names of folders with pictures of changes; a number for the changed folder
/// and that of the process follow.
const CHANGES: &str = "grazing-changes-";

/// The temporary files and folders that this run has begun; a finished one no longer exists under this name.
static OWN: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

fn change_own<T>(change: impl FnOnce(&mut BTreeSet<PathBuf>) -> T) -> T {
    change(&mut OWN.lock().unwrap_or_else(PoisonError::into_inner))
}

/// Deletes everything that this run has begun and not finished, for a run that is ended from outside.
pub fn remove_own_temporaries() {
    for path in change_own(std::mem::take) {
        remove(&path);
    }
}

/// Deletes a file or a folder. If that fails, it stays: the next run tries again.
fn remove(path: &Path) {
    let is_folder = path.symlink_metadata().is_ok_and(|data| data.is_dir());
    let _ = if is_folder { fs::remove_dir_all(path) } else { fs::remove_file(path) };
}

/// Begins a file or folder under a name of this run, with the permissions of other new ones.
fn begun<T>(mode: u32, begin: impl FnOnce(&Builder<'_, '_>) -> io::Result<T>) -> io::Result<T> {
    let prefix = format!("{UNFINISHED}{}-", process::id());
    let mut builder = Builder::new();
    builder.prefix(&prefix);
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(fs::Permissions::from_mode(mode));
    }
    #[cfg(not(unix))]
    let _ = mode;
    begin(&builder)
}

/// An empty file in the folder, with the permissions of other new files; it is deleted with the
/// value unless it is moved into place.
pub(super) fn unfinished(folder: &Path) -> io::Result<NamedTempFile> {
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let file = begun(0o666, |builder| builder.tempfile_in(folder))?;
    change_own(|own| own.insert(file.path().to_owned()));
    Ok(file)
}

/// A folder that is deleted with the value, unless it is kept.
pub(crate) struct TemporaryFolder(TempDir);

impl TemporaryFolder {
    /// A folder beside the free place of a new one, to which it may be moved once it is filled.
    pub(super) fn for_place(place: &Path) -> io::Result<Self> {
        if place.symlink_metadata().is_ok() {
            return Err(io::ErrorKind::AlreadyExists.into());
        }
        let beside = place.parent().filter(|above| !above.as_os_str().is_empty()).unwrap_or(Path::new("."));
        fs::create_dir_all(beside)?;
        sweep(beside);
        Ok(Self::own(begun(0o777, |builder| builder.tempdir_in(beside))?))
    }

    /// A folder for pictures of what changed in an output folder, in the system's folder for temporary files; stale ones for the
    /// same output folder are deleted.
    pub(crate) fn for_changes(output: &Path) -> io::Result<Self> {
        let place = std::env::temp_dir();
        let mut hasher = DefaultHasher::new();
        output.canonicalize().unwrap_or_else(|_| output.to_owned()).hash(&mut hasher);
        let kind = format!("{CHANGES}{:016x}-", hasher.finish());
        sweep_kind(&place, &kind);
        Ok(Self::own(Builder::new().prefix(&format!("{kind}{}-", process::id())).tempdir_in(place)?))
    }

    fn own(folder: TempDir) -> Self {
        change_own(|own| own.insert(folder.path().to_owned()));
        Self(folder)
    }

    /// The path of the folder.
    pub(crate) fn path(&self) -> &Path {
        self.0.path()
    }

    /// Keeps the folder where it is now.
    pub(crate) fn keep(self) {
        let path = self.0.keep();
        change_own(|own| own.remove(&path));
    }

    /// Moves the folder to its place.
    pub(super) fn move_to(self, place: &Path) -> io::Result<()> {
        fs::rename(self.path(), place)?;
        self.keep();
        Ok(())
    }
}

/// Deletes unfinished files that runs which died have left in a folder.
pub(crate) fn sweep(folder: &Path) {
    sweep_kind(folder, UNFINISHED);
}

fn sweep_kind(folder: &Path, kind: &str) {
    // A folder that cannot be read is reported as soon as something is written to it.
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        if process_of(kind, &entry.file_name()).is_some_and(|process| is_left(process, &path)) {
            remove(&path);
        }
    }
}

/// The process that created a file or folder of this name, if it is one of the kind.
fn process_of(kind: &str, name: &OsStr) -> Option<u32> {
    name.to_str()?.strip_prefix(kind)?.split_once('-')?.0.parse().ok()
}

/// Whether a file or folder is stale: its process no longer runs, or had the number of this one, as
/// happens in containers, and this run did not begin it.
fn is_left(process: u32, path: &Path) -> bool {
    if process == process::id() {
        return change_own(|own| !own.contains(path));
    }
    !is_running(process)
}

/// Whether a process is running; assumed of every other process where the system has no `/proc`.
fn is_running(process: u32) -> bool {
    let processes = Path::new("/proc");
    !processes.join(process::id().to_string()).exists() || processes.join(process.to_string()).exists()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_our_own_names_tell_a_process() {
        for (name, process) in [
            (".grazing-17-ab3", Some(17)),
            (".grazing-8-x-y", Some(8)),
            (".grazing-8fHq", None),
            ("grazing-17-a", None),
            (".grazing--a", None),
            (".grazing-1x-a", None),
        ] {
            assert_eq!(process_of(UNFINISHED, OsStr::new(name)), process, "{name}");
        }
    }

    #[test]
    fn what_is_begun_goes_when_the_run_is_ended_and_what_is_finished_stays() {
        let folder = tempfile::tempdir().expect("a temporary folder can be made");
        let [begun, finished] = [(); 2].map(|()| unfinished(folder.path()).expect("the folder is ours"));
        finished.persist(folder.path().join("place")).expect("the folder is ours");
        sweep(folder.path());
        assert!(begun.path().exists(), "a run does not sweep away what it works on");
        remove_own_temporaries();
        let left: Vec<_> = fs::read_dir(folder.path()).expect("it is there").flatten().collect();
        assert_eq!(left.len(), 1);
        assert_eq!(left[0].file_name(), "place");
    }
}
