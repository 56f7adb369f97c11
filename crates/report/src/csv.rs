//! Tables as text: reading CSV, and writing it compactly for the page's scripts.

use std::borrow::Cow;

/// A table of words and numbers.
pub(crate) struct Cells<'a> {
    pub(crate) header: Vec<Cow<'a, str>>,
    pub(crate) rows: Vec<Vec<Cow<'a, str>>>,
}

/// The cells of a line; one that begins with a quote ends at the next single one, and two stand for one.
fn split(line: &str) -> Vec<Cow<'_, str>> {
    if !line.contains('"') {
        return line.split(',').map(Cow::Borrowed).collect();
    }
    let mut cells = Vec::new();
    let mut cell = String::new();
    let mut quoted = false;
    let mut characters = line.chars().peekable();
    while let Some(character) = characters.next() {
        match character {
            '"' if quoted && characters.peek() == Some(&'"') => {
                characters.next();
                cell.push('"');
            }
            '"' => quoted = !quoted,
            ',' if !quoted => cells.push(std::mem::take(&mut cell)),
            other => cell.push(other),
        }
    }
    cells.push(cell);
    cells.into_iter().map(Cow::Owned).collect()
}

impl<'a> Cells<'a> {
    pub(crate) fn read(csv: &'a str) -> Self {
        let mut lines = csv.lines().map(split);
        Cells { header: lines.next().unwrap_or_default(), rows: lines.collect() }
    }

    pub(crate) fn column(&self, name: &str) -> Option<usize> {
        self.header.iter().position(|header| *header == name)
    }
}

/// Significant digits of numbers on the page: more than a screen can show at any zoom.
const DIGITS: usize = 9;
/// What a cell says that equals the one above it.
const SAME: &str = "=";
/// What stands between cells; JSON need not escape it.
const SEPARATOR: char = '|';

/// The same table with bars between the cells, rounded numbers, and `=` in the place of a cell that equals the one above it.
pub(crate) fn compact(csv: &str) -> String {
    let cells = Cells::read(csv);
    let mut text = cells.header.join(&SEPARATOR.to_string());
    let mut above: Vec<String> = Vec::new();
    for row in &cells.rows {
        let row: Vec<String> = row.iter().map(|cell| rounded(cell)).collect();
        text.push('\n');
        for (index, cell) in row.iter().enumerate() {
            if index > 0 {
                text.push(SEPARATOR);
            }
            text.push_str(if above.get(index) == Some(cell) && cell.len() > 1 { SAME } else { cell });
        }
        above = row;
    }
    text
}

/// The cell with fewer digits, if it is a number that is not whole.
fn rounded(cell: &str) -> String {
    let number = cell.parse::<f64>().ok().filter(|number| number.is_finite() && cell.contains('.'));
    let Some(number) = number else {
        return cell.replace(SEPARATOR, "/");
    };
    let rounded: f64 = format!("{number:.*e}", DIGITS - 1).parse().unwrap_or(number);
    if rounded == 0.0 || (1e-4..1e9).contains(&rounded.abs()) {
        format!("{rounded}")
    } else {
        format!("{rounded:e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_rounded_words_kept_and_repetitions_marked() {
        let csv = "kind,p,x\nSN,1,3.4999999999999998e-1\nSN,1,3.5000000000000001e-1\nPD,1,\nPD,1,-1.25e-17\n";
        assert_eq!(compact(csv), "kind|p|x\nSN|1|0.35\n=|1|=\nPD|1|\n=|1|-1.25e-17");
    }

    #[test]
    fn commas_and_quotes_in_words_are_no_separators() {
        let cells = Cells::read("verdict,reason,p\nexplained,\"no orbit, \"\"virtual\"\"\",2\n");
        assert_eq!(cells.rows[0], ["explained", "no orbit, \"virtual\"", "2"]);
    }

    #[test]
    fn nine_digits_survive() {
        assert_eq!(compact("x\n-5.6794452873805710e2"), "x\n-567.944529");
    }
}
