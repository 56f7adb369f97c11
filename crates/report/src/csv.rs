//! Tables as text: reading CSV, and writing it compactly for the page's scripts.

/// A table of words and numbers; cells with commas or quotes do not occur in it.
pub(crate) struct Cells<'a> {
    pub(crate) header: Vec<&'a str>,
    pub(crate) rows: Vec<Vec<&'a str>>,
}

impl<'a> Cells<'a> {
    pub(crate) fn read(csv: &'a str) -> Self {
        let mut lines = csv.lines().map(|line| line.split(',').collect::<Vec<_>>());
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

/// The same table with rounded numbers, and `=` in the place of a cell that equals the one above it.
pub(crate) fn compact(csv: &str) -> String {
    let cells = Cells::read(csv);
    let mut text = cells.header.join(",");
    let mut above: Vec<String> = Vec::new();
    for row in &cells.rows {
        let row: Vec<String> = row.iter().map(|cell| rounded(cell)).collect();
        text.push('\n');
        for (index, cell) in row.iter().enumerate() {
            if index > 0 {
                text.push(',');
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
        return cell.to_owned();
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
        assert_eq!(compact(csv), "kind,p,x\nSN,1,0.35\n=,1,=\nPD,1,\n=,1,-1.25e-17");
    }

    #[test]
    fn nine_digits_survive() {
        assert_eq!(compact("x\n-5.6794452873805710e2"), "x\n-567.944529");
    }
}
