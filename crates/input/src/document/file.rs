//! Reading files: only regular ones, of a plausible size, and without waiting.

use std::fs::{FileType, Metadata, OpenOptions};
use std::io::{self, Read};
use std::path::Path;

use super::error::SourceError;

/// The largest number of bytes of a file: a longer one was not written by a person.
const MOST_BYTES: u64 = 1_000_000;

/// The text of a file of reasonable size.
///
/// # Errors
/// [`SourceError::Unreadable`].
pub fn read_file(path: &Path) -> Result<String, SourceError> {
    read_text(path, |bytes| String::from_utf8(bytes).map_err(|_| "it is not UTF-8 text"))
}

/// Reads a file that another program has written, of at most a megabyte: a text in UTF-8, in UTF-16 if it begins with that mark, or
/// else in Latin-1, of which every byte is a character.
///
/// # Errors
/// The file cannot be read, is longer, or is not a text.
pub fn read_foreign(path: &Path) -> Result<String, SourceError> {
    read_text(path, |bytes| decoded(bytes).ok_or("it is not text: save its table as CSV"))
}

/// The text of a file.
fn decoded(bytes: Vec<u8>) -> Option<String> {
    let units = |unit: fn([u8; 2]) -> u16| {
        let pairs = bytes[2..].chunks(2).map(|pair| <[u8; 2]>::try_from(pair).ok().map(unit));
        String::from_utf16(&pairs.collect::<Option<Vec<u16>>>()?).ok()
    };
    match bytes[..] {
        [0xff, 0xfe, ..] => units(u16::from_le_bytes),
        [0xfe, 0xff, ..] => units(u16::from_be_bytes),
        _ => String::from_utf8(bytes).map_or_else(|error| latin(error.as_bytes()), Some),
    }
}

/// A text in Latin-1; none if there are bytes that no text has.
fn latin(bytes: &[u8]) -> Option<String> {
    let is_text = |byte: &u8| *byte >= b' ' || byte.is_ascii_whitespace();
    bytes.iter().all(is_text).then(|| bytes.iter().copied().map(char::from).collect())
}

fn read_text(
    path: &Path,
    decode: impl FnOnce(Vec<u8>) -> Result<String, &'static str>,
) -> Result<String, SourceError> {
    let text = read_bytes(path, MOST_BYTES).and_then(|bytes| decode(bytes).map_err(io::Error::other));
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
