//! How a file differs from what the code produces, in words.

use std::path::Path;

use grazing_measured::read::cells;

/// The most characters of a line that a message quotes.
const QUOTED: usize = 80;

/// Files that differ from what the code produces, each with the difference.
#[derive(Debug, Default, PartialEq, Eq)]
pub struct Differences {
    /// Files that are missing or have another content.
    pub differing: Vec<String>,
    /// Files that the code does not produce.
    pub unexpected: Vec<String>,
}

/// How the content of a file differs from what the code produces.
pub(super) fn of_content(path: &Path, here: &[u8], made: &[u8]) -> String {
    let is_table = path.extension().is_some_and(|extension| extension == "csv");
    first_difference(is_table, &String::from_utf8_lossy(here), &String::from_utf8_lossy(made))
}

/// The first line in which the contents differ; for tables the first column with both values.
fn first_difference(is_table: bool, here: &str, made: &str) -> String {
    let header = made.lines().next().unwrap_or_default();
    let [here, made] = [here, made].map(|text| text.lines().collect::<Vec<_>>());
    let same = here.iter().zip(&made).take_while(|(here, made)| here == made).count();
    let number = same + 1;
    match (here.get(same), made.get(same)) {
        (Some(_), Some(_)) if !is_table => {
            format!("differs from what the code produces, first in line {number}")
        }
        (Some(here), Some(made)) => {
            let (place, [here, made]) = match first_cell(header, here, made) {
                Some((column, cells)) => (format!("line {number}, {column}"), cells.map(cell)),
                None => (format!("line {number}"), [here, made].map(|line| quote(line))),
            };
            format!("{place}: {here} in the file, {made} from the code")
        }
        (Some(_), None) => format!("the file has more lines than the {same} that the code produces"),
        (None, Some(_)) => format!("ends after line {same}; the code produces more lines"),
        (None, None) => "differs from what the code produces in its line ends only".to_owned(),
    }
}

/// The first column in which two lines of a table differ, with both cells, if both lines have as
/// many cells as the header.
fn first_cell(header: &str, here: &str, made: &str) -> Option<(String, [String; 2])> {
    if header == made {
        return None;
    }
    let (names, here, made) = (cells(header)?, cells(here)?, cells(made)?);
    if [&here, &made].map(Vec::len) != [names.len(); 2] {
        return None;
    }
    let cells = here.into_iter().zip(made).map(|(here, made)| [here, made]);
    names.into_iter().zip(cells).find(|(_, [here, made])| here != made)
}

fn cell(text: String) -> String {
    if text.is_empty() { "nothing".to_owned() } else { text }
}

fn quote(line: &str) -> String {
    let more = if line.chars().count() > QUOTED { "..." } else { "" };
    format!("`{}{more}`", line.chars().take(QUOTED).collect::<String>())
}
