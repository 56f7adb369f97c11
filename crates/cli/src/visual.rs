//! Pictures of figures that change: before, after and the difference.

use std::fs;
use std::path::{Path, PathBuf};

use grazing_report::{Drawing, comparison};

use crate::folder::{self, OutputFile, TemporaryFolder};
use crate::terminal;

/// A figure that has changed: the old content of its file, and the new file.
pub(crate) type Changed<'a> = (Vec<u8>, &'a OutputFile);

/// The figures among the files that differ from those in the folder.
pub(crate) fn changed<'a>(folder: &Path, files: &'a [OutputFile]) -> Vec<Changed<'a>> {
    let figures =
        files.iter().filter(|file| file.path.extension().is_some_and(|extension| extension == "svg"));
    let changed = figures.filter_map(|after| {
        // A figure that is missing or cannot be read has no picture from before.
        let before = folder::read(&folder.join(&after.path)).ok()?;
        (before != after.content).then_some((before, after))
    });
    changed.collect()
}

/// Draws each changed figure before, after and the difference, in a new folder for temporary files,
/// and prints its path. It stays until a later run draws changes in the same output folder.
///
/// A picture that cannot be drawn is only named: pictures are a help and not the result.
pub(crate) fn show(output: &Path, changes: &[Changed<'_>]) {
    if changes.is_empty() {
        return;
    }
    let folder = match TemporaryFolder::for_changes(output) {
        Ok(folder) => folder,
        Err(error) => return terminal::note(&format!("the changed figures could not be compared: {error}")),
    };
    for (before, after) in changes {
        let name = after.path.display();
        match draw(before, after, folder.path()) {
            Ok(picture) => {
                terminal::note(&format!("{name}: before, after and difference: {}", picture.display()));
            }
            Err(reason) => terminal::note(&format!("{name}: the change could not be drawn: {reason}")),
        }
    }
    folder.keep();
}

fn draw(before: &[u8], after: &OutputFile, folder: &Path) -> Result<PathBuf, String> {
    let read = |svg: &[u8]| Drawing::read(&String::from_utf8_lossy(svg)).map_err(|error| error.to_string());
    let before = read(before).map_err(|error| format!("the figure before: {error}"))?;
    let picture = comparison(&before, &read(&after.content)?).map_err(|error| error.to_string())?;
    let path = folder.join(after.path.with_extension("png"));
    fs::write(&path, picture).map_err(|error| error.to_string())?;
    Ok(path)
}
