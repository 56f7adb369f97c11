//! The text of a file, with settings.

use std::fs::File as OpenFile;
use std::io::{self, Read};
use std::path::Path;

use crate::error::SourceError;
use crate::setting::Setting;

/// A file with more bytes than this was not written by a person.
const MOST_BYTES: u64 = 1_000_000;

/// The text of a file of reasonable size.
///
/// # Errors
/// [`SourceError::Unreadable`].
pub fn read_file(path: &Path) -> Result<String, SourceError> {
    let read = || -> io::Result<String> {
        let file = OpenFile::open(path)?;
        if !file.metadata()?.is_file() {
            return Err(io::Error::other("it is not a file"));
        }
        let mut bytes = Vec::new();
        file.take(MOST_BYTES + 1).read_to_end(&mut bytes)?;
        if bytes.len() as u64 > MOST_BYTES {
            return Err(io::Error::other(format!(
                "it is longer than {MOST_BYTES} bytes; files of this kind are far shorter"
            )));
        }
        String::from_utf8(bytes).map_err(|_| io::Error::other("it is not a text in UTF-8"))
    };
    read().map_err(|reason| SourceError::Unreadable {
        file: path.display().to_string(),
        reason: reason.to_string(),
    })
}

/// The text of a file with the settings that take the place of some of its values.
#[derive(Debug, Clone)]
pub struct Text {
    /// The file's text, and after it a line for each setting.
    pub(crate) whole: String,
    /// Where the file's text ends.
    pub(crate) end: usize,
    /// The settings, with the places at which they stand in the whole text.
    pub(crate) settings: Vec<(usize, Setting)>,
}

impl Text {
    /// The text of a file, with settings of which later ones go before earlier ones.
    pub fn new(text: &str, settings: &[Setting]) -> Text {
        let mut whole = text.to_owned();
        let mut placed = Vec::new();
        for setting in settings {
            whole.push('\n');
            placed.push((whole.len(), setting.clone()));
            whole.push_str(&setting.to_string());
        }
        Text { whole, end: text.len(), settings: placed }
    }
}
