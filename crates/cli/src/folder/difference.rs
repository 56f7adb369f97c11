//! How a file differs from what the code makes, in words.

use std::fmt;
use std::path::PathBuf;

/// The most characters of a line that a message quotes.
const QUOTED: usize = 80;

/// In what way a file is not what the code makes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// It is not there.
    Missing,
    /// It has another content.
    Content,
    /// It is there and the code does not make it.
    Unexpected,
}

/// A file that is not what the code makes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Difference {
    /// The file.
    pub path: PathBuf,
    /// In what way it differs.
    pub kind: Kind,
    /// What is wrong with it, to follow its name.
    pub what: String,
}

impl fmt::Display for Difference {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{}: {}", self.path.display(), self.what)
    }
}

impl Difference {
    pub(super) fn missing(path: PathBuf) -> Difference {
        Difference { path, kind: Kind::Missing, what: "missing".to_owned() }
    }

    pub(super) fn unexpected(path: PathBuf) -> Difference {
        let what = "not made by the code; remove it if it is left over from an earlier version or an interrupted run";
        Difference { path, kind: Kind::Unexpected, what: what.to_owned() }
    }

    pub(super) fn content(path: PathBuf, here: &[u8], made: &[u8]) -> Difference {
        let is_table = path.extension().is_some_and(|extension| extension == "csv");
        let what = first_difference(is_table, &String::from_utf8_lossy(here), &String::from_utf8_lossy(made));
        Difference { path, kind: Kind::Content, what }
    }
}

/// The first line in which the contents differ; for tables the first column with both values.
fn first_difference(is_table: bool, here: &str, made: &str) -> String {
    let header = made.lines().next().unwrap_or_default();
    let (mut here_lines, mut made_lines) = (here.lines(), made.lines());
    let mut number = 0;
    loop {
        number += 1;
        match (here_lines.next(), made_lines.next()) {
            (Some(here), Some(made)) if here == made => {}
            (Some(_), Some(_)) if !is_table => {
                return format!("differs from what the code makes, first in line {number}");
            }
            (Some(here), Some(made)) => {
                return match first_cell(header, here, made) {
                    Some((column, here, made)) => {
                        format!(
                            "line {number}, {column}: {} here, {} made by the code",
                            cell(here),
                            cell(made)
                        )
                    }
                    None => {
                        format!("line {number}: `{}` here, `{}` made by the code", quote(here), quote(made))
                    }
                };
            }
            (Some(_), None) => return format!("more lines here than the {} made by the code", number - 1),
            (None, Some(_)) => return format!("ends after line {}, the code makes more", number - 1),
            (None, None) => return "differs from what the code makes in its line ends only".to_owned(),
        }
    }
}

/// The first column in which two lines of a table differ, if both have as many cells as the header.
fn first_cell<'a>(header: &'a str, here: &'a str, made: &'a str) -> Option<(&'a str, &'a str, &'a str)> {
    let columns = header.split(',').count();
    if header == made || here.split(',').count() != columns || made.split(',').count() != columns {
        return None;
    }
    header
        .split(',')
        .zip(here.split(',').zip(made.split(',')))
        .find(|(_, (here, made))| here != made)
        .map(|(column, (here, made))| (column, here, made))
}

fn cell(text: &str) -> &str {
    if text.is_empty() { "nothing" } else { text }
}

fn quote(line: &str) -> String {
    if line.chars().count() <= QUOTED {
        return line.to_owned();
    }
    format!("{}...", line.chars().take(QUOTED).collect::<String>())
}
