//! Tables as the page's scripts read them.

use base64::prelude::{BASE64_STANDARD, Engine};
use grazing_results::columns::HYPOTHESIS;
use grazing_results::{Cell, Column, Table, brief};
use miniz_oxide::deflate::compress_to_vec;

use crate::formula::signs;
use crate::html::json_string;
use crate::svg::Marks;

/// Significant digits of numbers that a reader sees.
pub(crate) const DIGITS: usize = 7;
/// Significant digits of what is only shown beside a figure.
const DIGITS_BESIDE: usize = 6;
/// Digits beyond those that tell one end of a panel's axis from the other: points stay in place as far as one can zoom.
const DIGITS_ALONG_AXIS: i32 = 5;
/// No number has more.
const MOST_DIGITS: usize = 12;
/// What stands between headers; none has it.
const SEPARATOR: char = '|';
/// Columns that only keep rows together.
const BOOKKEEPING: [&str; 3] = ["arc", "branch", "region"];
/// How hard to look for repetitions: most of what there is to be had, in little time.
const EFFORT: u8 = 10;

/// The figure's tables for the scripts, compressed: those of which its panels show rows.
pub(crate) fn of_figure(tables: &[Table], marks: &Marks<'_>) -> String {
    let shown = tables.iter().filter(|table| marks.show(table.name));
    let (axes, digits) = (marks.columns(), digits(marks));
    packed(
        shown,
        &BOOKKEEPING,
        |column| if axes.iter().any(|axis| axis == column) { digits } else { DIGITS_BESIDE },
    )
}

/// A table for the scripts, compressed.
pub(crate) fn of_table(table: &Table) -> String {
    packed([table], &[], |_| DIGITS)
}

/// Digits at which a point keeps its place in every panel.
fn digits(marks: &Marks<'_>) -> usize {
    let along = |[low, high]: [f64; 2]| {
        let ratio = low.abs().max(high.abs()) / (high - low).abs();
        // Ratios are small numbers of powers of ten, however they are rounded.
        let powers = format!("{ratio:e}").split_once('e').and_then(|(_, power)| power.parse::<i32>().ok());
        usize::try_from(powers.unwrap_or(0) + 1 + DIGITS_ALONG_AXIS).unwrap_or(DIGITS)
    };
    marks.ranges().map(along).max().unwrap_or(DIGITS).clamp(DIGITS, MOST_DIGITS)
}

/// The tables as JSON, compressed, in letters; nothing if there are none.
fn packed<'a>(
    tables: impl IntoIterator<Item = &'a Table>,
    without: &[&str],
    digits: impl Fn(&str) -> usize,
) -> String {
    let table = |table: &Table| {
        format!("{}:{}", json_string(table.name), json_string(&by_columns(table, without, &digits)))
    };
    let tables: Vec<String> = tables.into_iter().map(table).collect();
    if tables.is_empty() {
        return String::new();
    }
    BASE64_STANDARD.encode(compress_to_vec(format!("{{{}}}", tables.join(",")).as_bytes(), EFFORT))
}

/// A line with the headers, then every cell on a line of its own, column by column: neighbours in a column are alike.
fn by_columns(table: &Table, without: &[&str], digits: &impl Fn(&str) -> usize) -> String {
    let kept: Vec<usize> =
        (0..table.headers.len()).filter(|&place| !without.contains(&table.columns[place].name)).collect();
    let headers: Vec<&str> = kept.iter().map(|&place| table.headers[place].as_str()).collect();
    let mut text = headers.join(&SEPARATOR.to_string());
    for place in kept {
        let digits = digits(&table.headers[place]);
        for row in &table.rows {
            text.push('\n');
            text.push_str(&written(&row[place], &table.columns[place], digits));
        }
    }
    text
}

fn written(cell: &Cell, column: &Column, digits: usize) -> String {
    match cell {
        Cell::Text(words) if column.name == HYPOTHESIS.name => signs(words),
        Cell::Text(words) => words.replace('\n', " "),
        Cell::Integer(value) => value.to_string(),
        Cell::Flag(value) => value.to_string(),
        Cell::Number(_) => cell.number().map_or_else(String::new, |number| brief(number, digits)),
    }
}

#[cfg(test)]
mod tests {
    use grazing_results::columns::{ADMISSIBLE, BIFURCATION, LOOPS, X};
    use grazing_results::{Column, Names};

    use super::*;

    const COLUMNS: &[Column] = &[BIFURCATION, LOOPS, X, ADMISSIBLE];

    fn table() -> Table {
        let rows = [
            ("SN", 1, 0.349_999_999_999),
            ("SN", 1, -5.679_445_287_380_571e2),
            ("PD", 1, f64::NAN),
            ("P\nD", 2, -1.25e-17),
        ];
        let rows = rows.map(|(kind, p, x)| vec![kind.into(), p.into(), x.into(), true.into()]);
        Table::of_cells("sample", COLUMNS, &Names::of_the_paper(), rows.into())
    }

    #[test]
    fn columns_follow_each_other_with_numbers_rounded() {
        assert_eq!(
            by_columns(&table(), &["admissible"], &|_| 7),
            "kind|p|x\nSN\nSN\nPD\nP D\n1\n1\n1\n2\n0.35\n-567.9445\n\n-1.25e-17"
        );
    }

    #[test]
    fn what_is_packed_can_be_unpacked() {
        let bytes = BASE64_STANDARD.decode(of_table(&table())).unwrap();
        let text = miniz_oxide::inflate::decompress_to_vec(&bytes).unwrap();
        let text = String::from_utf8(text).unwrap();
        assert!(text.starts_with("{\"sample\":\"kind|p|x|admissible\\nSN\\n"), "{text}");
    }

    #[test]
    fn a_narrow_panel_gets_more_digits_and_a_sketch_no_data() {
        let mark = |range: &str| {
            format!(
                "<rect class=\"panel\" x=\"0\" data-x=\"{range}\" data-y=\"0 1\" data-tables=\"sample\"/>"
            )
        };
        for (range, expected) in [("0 4", 7), ("0.43 0.44", 7), ("0.43 0.4301", 9), ("1 1.0000000001", 12)] {
            assert_eq!(digits(&Marks::of(&mark(range))), expected, "{range}");
        }
        let of = |svg: &str| of_figure(&[table()], &Marks::of(svg)).is_empty();
        assert!(of("<path d=\"M0,0\"/>") && !of(&mark("0 4")));
        assert!(of(&mark("0 4").replace("sample", "other")));
    }
}
