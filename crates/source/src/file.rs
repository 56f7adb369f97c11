//! Reading files: only regular ones, of a plausible size, and without waiting.

use std::fs::{FileType, Metadata, OpenOptions};
use std::io::{self, Read};
use std::path::Path;

use crate::error::SourceError;

/// The largest number of bytes of a file: a longer one was not written by a person.
const MOST_BYTES: u64 = 1_000_000;

/// The text of a file of reasonable size.
///
/// # Errors
/// [`SourceError::Unreadable`].
pub fn read_file(path: &Path) -> Result<String, SourceError> {
    let text = read_bytes(path, MOST_BYTES)
        .and_then(|bytes| String::from_utf8(bytes).map_err(|_| io::Error::other("it is not UTF-8 text")));
    text.map_err(|reason| SourceError::Unreadable {
        file: path.display().to_string(),
        reason: reason.to_string(),
    })
}

/// The content of a regular file of at most `most` bytes. Anything else is rejected at once:
/// devices may never end, and a named pipe waits for a writer.
///
/// # Errors
/// The file does not exist, is not a regular file, is longer, or cannot be read.
pub fn read_bytes(path: &Path, most: u64) -> io::Result<Vec<u8>> {
    regular(&path.metadata()?)?;
    let mut options = OpenOptions::new();
    options.read(true);
    #[cfg(unix)]
    {
        use std::os::unix::fs::OpenOptionsExt;
        options.custom_flags(libc::O_NONBLOCK | libc::O_NOCTTY);
    }
    let file = options.open(path)?;
    // The file may have been replaced in between.
    let data = file.metadata()?;
    regular(&data)?;
    let mut bytes = Vec::new();
    if data.len() <= most {
        file.take(most + 1).read_to_end(&mut bytes)?;
    }
    if data.len().max(bytes.len() as u64) > most {
        let what = format!("it is longer than {most} bytes, far longer than files of this kind are");
        return Err(io::Error::other(what));
    }
    Ok(bytes)
}

fn regular(data: &Metadata) -> io::Result<()> {
    if data.is_file() {
        return Ok(());
    }
    Err(io::Error::other(format!("it is {}, not a regular file", what_is(data.file_type()))))
}

/// The name of a type of file, in words.
pub fn what_is(kind: FileType) -> &'static str {
    #[cfg(unix)]
    {
        use std::os::unix::fs::FileTypeExt;
        if kind.is_fifo() {
            return "a named pipe";
        } else if kind.is_socket() {
            return "a socket";
        } else if kind.is_block_device() || kind.is_char_device() {
            return "a device";
        }
    }
    if kind.is_dir() { "a folder" } else { "something else" }
}
