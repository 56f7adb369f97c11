//! Keeping the curves that are finished while others are still being followed.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use grazing_results::Table;

use crate::folder::{self, OutputFile};
use crate::{tables, terminal};

/// The table of the finished curves, which exists during a run or after an interruption.
const UNFINISHED: &str = "curves.unfinished";

/// The path of the table in the folder of the results.
pub(super) fn path() -> PathBuf {
    tables::path(UNFINISHED)
}

/// Writes the curves of resonances into a file as they finish.
pub(super) struct Keeper<'a> {
    folder: &'a Path,
    /// Whether a message has said that the file cannot be written.
    complained: AtomicBool,
}

impl<'a> Keeper<'a> {
    /// Keeps curves in the folder, and prints a note if an interrupted run left some there.
    pub(super) fn new(folder: &'a Path) -> Self {
        let keeper = Self { folder, complained: AtomicBool::new(false) };
        let path = keeper.path();
        if path.is_file() {
            let path = path.display();
            terminal::note(&format!(
                "{path}: finished curves of an interrupted run; they are computed again, and the file is deleted at the end"
            ));
        }
        keeper
    }

    fn path(&self) -> PathBuf {
        self.folder.join(path())
    }

    /// Writes the finished curves. The computation goes on if that fails: in the end all files may
    /// well be written.
    pub(super) fn keep(&self, finished: &Table) {
        let written = tables::csv(finished).map_err(|error| error.to_string()).and_then(|content| {
            let file = OutputFile { path: path(), content };
            folder::write(self.folder, &[file]).map_err(|failure| failure.to_string())
        });
        if let Err(reason) = written
            && !self.complained.swap(true, Ordering::Relaxed)
        {
            terminal::note(&format!("the finished curves cannot be saved: {reason}"));
        }
    }
}
