//! Tables as the page's scripts read them.

use grazing_results::{Cell, Table, brief};

/// Significant digits of numbers on the page: more than a screen can show at any zoom.
const DIGITS: usize = 9;
/// What a cell says that equals the one above it.
const SAME: &str = "=";
/// What stands between cells; JSON need not escape it.
const SEPARATOR: char = '|';

/// The table as lines of cells with bars between them, numbers rounded, and `=` in the place of a cell that equals the one above it.
pub(crate) fn compact(table: &Table) -> String {
    let mut text = table.headers.join(&SEPARATOR.to_string());
    let mut above: Vec<String> = Vec::new();
    for row in &table.rows {
        let row: Vec<String> = row.iter().map(written).collect();
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

fn written(cell: &Cell) -> String {
    match cell {
        Cell::Text(words) => words.replace(SEPARATOR, "/"),
        Cell::Integer(value) => value.to_string(),
        Cell::Flag(value) => value.to_string(),
        Cell::Number(_) => cell.number().map_or_else(String::new, |number| brief(number, DIGITS)),
    }
}

#[cfg(test)]
mod tests {
    use grazing_results::columns::{BIFURCATION, LOOPS, X};
    use grazing_results::{Column, Names};

    use super::*;

    const COLUMNS: &[Column] = &[BIFURCATION, LOOPS, X];

    fn table(rows: &[(&'static str, u32, f64)]) -> Table {
        let rows = rows.iter().map(|(kind, p, x)| vec![(*kind).into(), (*p).into(), (*x).into()]);
        Table::of_cells("sample", COLUMNS, &Names::of_the_paper(), rows.collect())
    }

    #[test]
    fn numbers_are_rounded_words_kept_and_repetitions_marked() {
        let table = table(&[
            ("SN", 1, 0.349_999_999_999),
            ("SN", 1, 0.35),
            ("SN", 1, -5.679_445_287_380_571e2),
            ("PD", 1, f64::NAN),
            ("P|D", 1, -1.25e-17),
        ]);
        assert_eq!(compact(&table), "kind|p|x\nSN|1|0.35\n=|1|=\n=|1|-567.944529\nPD|1|\nP/D|1|-1.25e-17");
    }
}
