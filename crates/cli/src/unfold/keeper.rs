//! Keeping the curves that are finished while others are still being followed.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use grazing_reproduction::unfolded::Observer;
use grazing_results::Table;
use grazing_unfold::progress::Progress;
use grazing_unfold::stop::Stop;

use crate::failure::Failure;
use crate::folder::{self, MadeFile};
use crate::outputs::table_path;
use crate::progress::Display;
use crate::{tables, terminal};

/// The table of the curves that are finished, while the run lasts or after it was interrupted.
const UNFINISHED: &str = "curves.unfinished";

/// Shows progress, and writes the curves of resonances into a file as they finish.
pub(super) struct Keeper<'a> {
    display: Display,
    folder: &'a Path,
    /// Whether it has been told that the file cannot be written.
    complained: Mutex<bool>,
}

impl<'a> Keeper<'a> {
    /// Keeps curves in the folder until the mark is set, and tells if an interrupted run left some there.
    pub(super) fn new(folder: &'a Path, stop: Stop) -> Self {
        let keeper = Self { display: Display::counting(stop), folder, complained: Mutex::new(false) };
        let path = keeper.path();
        if path.is_file() {
            let path = path.display();
            terminal::note(&format!(
                "{path}: finished curves of an interrupted run; they are computed again, then the file goes"
            ));
        }
        keeper
    }

    fn path(&self) -> PathBuf {
        self.folder.join(table_path(UNFINISHED))
    }

    /// Removes the file: everything is written.
    pub(super) fn clear(&self) -> Result<(), Failure> {
        match fs::remove_file(self.path()) {
            Err(reason) if reason.kind() != io::ErrorKind::NotFound => {
                Err(Failure::file(&self.path(), &reason))
            }
            _ => Ok(()),
        }
    }

    fn write(&self, finished: &Table) -> Result<(), String> {
        let content = tables::csv(finished).map_err(|error| error.to_string())?;
        let file = MadeFile { path: table_path(UNFINISHED), content };
        folder::write(self.folder, &[file]).map(drop).map_err(|failure| failure.to_string())
    }
}

impl Progress for Keeper<'_> {
    fn begin(&self, what: &str, steps: u64) {
        self.display.begin(what, steps);
    }

    fn step(&self, what: &str) {
        self.display.step(what);
    }

    fn end(&self, what: &str) {
        self.display.end(what);
    }

    fn stopped(&self) -> bool {
        self.display.stopped()
    }
}

impl Observer for Keeper<'_> {
    fn stop(&self) -> Stop {
        self.display.stop().clone()
    }

    fn curves(&self, finished: &Table) {
        let Err(reason) = self.write(finished) else { return };
        // The computation goes on: in the end all files may well be written.
        let mut complained = self.complained.lock().unwrap_or_else(PoisonError::into_inner);
        if !*complained {
            terminal::note(&format!("finished curves are not kept: {reason}"));
            *complained = true;
        }
    }
}
