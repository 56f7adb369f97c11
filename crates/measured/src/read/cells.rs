//! The cells of a CSV file, as many programs write it.
//!
//! Quotation marks are read strictly, as RFC 4180 has them: a lenient reader would take a mark without its
//! partner as the beginning of a cell that swallows the lines below, without a word.

/// What separates cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Separator {
    Comma,
    Semicolon,
    Tab,
    /// Any number of blanks and tabs.
    Blanks,
}

/// A row of the file, with its line number.
#[derive(Clone, Debug)]
pub(super) struct FileRow {
    pub(super) line: u32,
    pub(super) cells: Vec<String>,
    /// Whether the first cell is in quotation marks.
    pub(super) quoted: bool,
}

impl FileRow {
    /// The cell in a column; empty if there is no such cell.
    pub(super) fn cell(&self, position: Option<usize>) -> &str {
        position.and_then(|place| self.cells.get(place)).map_or("", String::as_str)
    }
}

/// A mistake in a line.
pub(super) type LineMistake = (u32, String);

/// The rows of a text, and the last comment before them, which may name the columns.
pub(super) struct Rows {
    pub(super) comment: Option<FileRow>,
    pub(super) rows: Vec<FileRow>,
}

/// The most lines of a cell in quotation marks.
const MOST_LINES: usize = 20;

impl Separator {
    pub(super) const ALL: [Self; 4] = [Self::Comma, Self::Semicolon, Self::Tab, Self::Blanks];

    /// The separator in words.
    pub(super) const fn name(self) -> &'static str {
        match self {
            Self::Comma => "commas",
            Self::Semicolon => "semicolons",
            Self::Tab => "tabs",
            Self::Blanks => "blanks",
        }
    }

    /// Whether a text is this separator.
    pub(super) fn is(self, text: &str) -> bool {
        self != Self::Blanks && text.chars().count() == 1 && text.chars().all(|letter| self.separates(letter))
    }

    fn separates(self, letter: char) -> bool {
        match self {
            Self::Comma => letter == ',',
            Self::Semicolon => letter == ';',
            Self::Tab => letter == '\t',
            Self::Blanks => letter == ' ' || letter == '\t',
        }
    }

    /// The rows of a text with lines that end in `\n`. Empty lines and comments are left out.
    ///
    /// # Errors
    /// The first line with a quotation mark that has no partner or stands within a cell.
    pub(super) fn rows(self, text: &str) -> Result<Rows, LineMistake> {
        let mut lines = (1..).zip(text.split('\n'));
        let (mut comment, mut rows) = (None, Vec::<FileRow>::new());
        let of_auto = text.split('\n').any(|line| line.split_whitespace().take(AUTO.len()).eq(AUTO));
        while let Some((line, first)) = lines.next() {
            let unmarked = first.trim_start();
            if unmarked.is_empty() {
                continue;
            }
            if let Some(words) = commented(unmarked, of_auto) {
                if rows.is_empty()
                    && let Ok(Some(cells)) = self.cells(words)
                {
                    comment = Some(FileRow { line, cells, quoted: false });
                }
                continue;
            }
            let mut whole = first.to_owned();
            let cells = loop {
                match self.cells(&whole).map_err(|reason| (line, reason))? {
                    Some(cells) => break cells,
                    None => {
                        let next = lines.next().map(|(_, next)| next);
                        // A line that looks like a row is one: a quotation mark above has no partner.
                        let width = rows.first().map_or(2, |row| row.cells.len());
                        let is_part =
                            |next: &&str| next.split(|letter| self.separates(letter)).count() < width;
                        let next = next.filter(is_part).filter(|_| whole.lines().count() < MOST_LINES);
                        let open = || (line, "a quotation mark has no partner on this line".to_owned());
                        whole = format!("{whole}\n{}", next.ok_or_else(open)?);
                    }
                }
            };
            rows.push(FileRow { line, cells, quoted: unmarked.starts_with('"') });
        }
        Ok(Rows { comment, rows })
    }

    /// The cells of a line without surrounding blanks and quotation marks; none if a mark is not closed.
    ///
    /// # Errors
    /// Something follows a quotation mark that ends a cell.
    pub(super) fn cells(self, line: &str) -> Result<Option<Vec<String>>, String> {
        let is_blank = |letter: char| letter.is_whitespace() && !(self == Self::Tab && letter == '\t');
        let mut rest = if self == Self::Blanks { line.trim() } else { line };
        let mut cells = Vec::new();
        loop {
            rest = rest.trim_start_matches(is_blank);
            let after = if let Some(quoted) = rest.strip_prefix('"') {
                let Some((cell, after)) = unquoted(quoted) else { return Ok(None) };
                cells.push(cell.trim().to_owned());
                let trimmed = after.trim_start_matches(is_blank);
                let is_parted = self == Self::Blanks && trimmed.len() < after.len();
                if !(trimmed.is_empty() || is_parted || trimmed.starts_with(|letter| self.separates(letter)))
                {
                    let remedy = "write a quotation mark within quotation marks twice";
                    return Err(format!(
                        "something follows the quotation mark that ends cell {}: {remedy}",
                        cells.len()
                    ));
                }
                if is_parted { after } else { trimmed }
            } else {
                let end = rest.find(|letter| self.separates(letter)).unwrap_or(rest.len());
                cells.push(rest[..end].trim().to_owned());
                &rest[end..]
            };
            match after.chars().next() {
                Some(separator) => rest = &after[separator.len_utf8()..],
                None => return Ok(Some(cells)),
            }
        }
    }
}

/// The words with which AUTO-07p begins the line above the numbers of a branch; the lines of its heads begin with the number 0.
const AUTO: [&str; 4] = ["0", "PT", "TY", "LAB"];

/// The words of a comment, or of a head of AUTO-07p.
fn commented(line: &str, of_auto: bool) -> Option<&str> {
    let is_head = of_auto && line.split_whitespace().next() == Some(AUTO[0]);
    let words = line.strip_prefix(['#', '%']).map(|words| words.trim_start_matches(['#', '%']));
    words.or(is_head.then_some(line))
}

/// What stands before the quotation mark that ends a cell, and what stands after it; a doubled mark is one
/// of the cell's.
fn unquoted(text: &str) -> Option<(String, &str)> {
    let (mut cell, mut rest) = (String::new(), text);
    loop {
        let (before, after) = rest.split_once('"')?;
        cell.push_str(before);
        match after.strip_prefix('"') {
            Some(more) => {
                cell.push('"');
                rest = more;
            }
            None => return Some((cell, after)),
        }
    }
}
