//! Keeping what is finished while the rest is still being computed: the curves as a table, and a picture.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use grazing_drawing::SheetWidth;
use grazing_input::Description;
use grazing_results::Names;
use grazing_unfold::described::Axes;
use grazing_unfold::unfolded::Draft;

use crate::folder::{self, OutputFile};
use crate::outputs::oscillator::NamedOscillator;
use crate::{tables, terminal};

/// The table of the finished curves, which exists during a run or after an interruption.
const UNFINISHED: &str = "curves.unfinished";
/// The picture of what is known, which exists likewise, unless the run is short.
const PICTURE: &str = "diagram.unfinished.svg";

/// The paths of table and picture in the folder of the results.
pub(super) fn paths() -> [PathBuf; 2] {
    [tables::path(UNFINISHED), PathBuf::from(PICTURE)]
}

/// The time between two pictures, and before the first: so long that drawing them costs little.
pub(super) const PAUSE: Duration = Duration::from_secs(3);

/// Writes what is known of a diagram as it becomes known.
pub(super) struct Keeper {
    folder: PathBuf,
    file: PathBuf,
    description: Description,
    names: Names,
    width: SheetWidth,
    pause: Duration,
    /// When the last picture was begun, or the run.
    last: Mutex<Instant>,
    /// Whether a message has said that there is a picture, or that files cannot be written.
    shown: AtomicBool,
    complained: AtomicBool,
}

impl Keeper {
    /// Keeps what is known of the oscillator from a file in the folder, with pictures of this width no more often
    /// than after each pause, and prints a note if an interrupted run left something there.
    pub(super) fn new(
        folder: &Path,
        (file, description): (&Path, Description),
        width: SheetWidth,
        pause: Duration,
    ) -> Self {
        let path = folder.join(tables::path(UNFINISHED));
        if path.is_file() {
            let path = path.display();
            terminal::note(&format!(
                "{path}: finished curves of an interrupted run; they are computed again, and the file is deleted at the end"
            ));
        }
        Self {
            folder: folder.to_owned(),
            file: file.to_owned(),
            names: Axes::of(&description).names,
            description,
            width,
            pause,
            last: Mutex::new(Instant::now()),
            shown: AtomicBool::new(false),
            complained: AtomicBool::new(false),
        }
    }

    /// Writes what is known. The computation goes on if that fails: in the end all files may well be
    /// written.
    pub(super) fn keep(&self, draft: &Draft<'_>) {
        let is_due = self.is_due();
        let written = self
            .files(draft, is_due)
            .and_then(|files| folder::write(&self.folder, &files).map_err(|failure| failure.to_string()));
        match written {
            Ok(_) if is_due && !self.shown.swap(true, Ordering::Relaxed) => {
                let picture = self.folder.join(PICTURE);
                terminal::note(&format!(
                    "{}: the diagram so far; it is drawn again as more is known, and deleted at the end",
                    picture.display()
                ));
            }
            Err(reason) if !self.complained.swap(true, Ordering::Relaxed) => {
                terminal::note(&format!("what is finished cannot be saved: {reason}"));
            }
            Ok(_) | Err(_) => {}
        }
    }

    /// Whether it is time for a picture.
    fn is_due(&self) -> bool {
        let mut last = self.last.lock().unwrap_or_else(PoisonError::into_inner);
        let is_due = last.elapsed() >= self.pause;
        if is_due {
            *last = Instant::now();
        }
        is_due
    }

    fn files(&self, draft: &Draft<'_>, with_picture: bool) -> Result<Vec<OutputFile>, String> {
        let [table, picture] = paths();
        let content = tables::csv(&draft.curves).map_err(|error| error.to_string())?;
        let mut files = vec![OutputFile { path: table, content }];
        if with_picture {
            let (of, name) = (self.file.as_path(), self.description.name());
            let named = NamedOscillator { of, name, names: &self.names, width: self.width };
            let drawn = named.plane(&(draft.plane)(), self.description.figure().clone());
            let figures = drawn.map_err(|error| error.to_string())?.figures.into_iter();
            files.extend(figures.map(|figure| OutputFile {
                path: picture.clone(),
                content: figure.sheet.svg().into_bytes(),
            }));
        }
        Ok(files)
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use grazing_model::smooth::Stop;
    use grazing_unfold::progress::Silent;
    use grazing_unfold::unfolded::Unfolded;

    use super::*;

    #[test]
    fn pictures_of_what_is_known_are_drawn_once_a_pause_is_over() {
        let text = include_str!("../../../../examples/paper.toml");
        let narrow = text
            .replace("range = [0.3, 1.1]", "range = [0.6, 0.7]")
            .replace("loops = [1, 2, 3]", "loops = [1]");
        let file = Path::new("paper.toml");
        let description = Description::parse(&narrow, "paper.toml").unwrap_or_else(|error| panic!("{error}"));
        assert_eq!((description.loops(), description.secondary().range()), (&[1][..], [0.6, 0.7]));
        for (pause, is_drawn) in [(Duration::ZERO, true), (Duration::MAX, false)] {
            let folder = tempfile::tempdir().expect("a temporary folder can be made");
            let of = (file, description.clone());
            let keeper = Keeper::new(folder.path(), of, SheetWidth::default(), pause);
            let pictures = Mutex::new(Vec::new());
            let keep = |draft: &Draft<'_>| {
                keeper.keep(draft);
                let picture = fs::read_to_string(folder.path().join(PICTURE)).unwrap_or_default();
                pictures.lock().expect("nobody panics").push(picture);
            };
            Unfolded::described(&description, &Silent, &Stop::default(), &keep).expect("it grazes");
            let pictures = pictures.into_inner().expect("nobody panicked");
            assert!(folder.path().join(tables::path(UNFINISHED)).is_file());
            if is_drawn {
                // Hatched until the regions are decided, and then not.
                let hatched: Vec<bool> = pictures.iter().map(|svg| svg.contains("undecided")).collect();
                let [before @ .., last] = hatched.as_slice() else { panic!("there are pictures") };
                assert!(!before.is_empty() && before.iter().all(|hatched| *hatched) && !last);
            } else {
                assert!(pictures.iter().all(String::is_empty));
            }
        }
    }
}
