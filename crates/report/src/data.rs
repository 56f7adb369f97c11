//! Tables in the form that the page's scripts read.

use std::collections::BTreeMap;

use base64::prelude::{BASE64_STANDARD, Engine};
use grazing_drawing::{PanelMark, Sheet};
use grazing_results::columns::HYPOTHESIS;
use grazing_results::{Cell, Column, DrawnAs, Scientific, Table, brief};
use miniz_oxide::deflate::compress_to_vec;

use crate::columns::name;
use crate::formula::signs;
use crate::html::{Html, json_string};
use crate::outputs::FigureEntry;
use crate::report::Report;

/// Significant digits of numbers that a reader sees.
pub(crate) const SHOWN_DIGITS: usize = 7;
/// Digits of the largest number of a column beside a figure: one more than shown, so that smaller
/// numbers have some, too.
const LEAST_DIGITS: usize = 8;
/// Digits beyond those in which the ends of a panel's axis differ: points keep their places as far
/// as one can zoom.
const DIGITS_ALONG_AXIS: i32 = 5;
/// The most digits of a number.
const MOST_DIGITS: usize = 12;
/// The separator of headers, which none contains.
const SEPARATOR: char = '|';
/// Columns that serve only to keep rows together.
const BOOKKEEPING: [&str; 4] = ["arc", "branch", "curve", "region"];
/// Most of the possible compression, in little time.
const COMPRESSION_LEVEL: u8 = 10;

/// The rounding of the numbers of a table.
#[derive(Clone, Copy)]
enum Rounding {
    /// Each number to this many significant digits.
    Each(usize),
    /// All numbers to the decimals that give the largest of the column this many digits: numbers
    /// along a curve then differ little from line to line.
    Column(usize),
}

/// The figure's tables for the scripts, compressed: those with rows in its panels, in the order in which they tell most, for
/// panels that do not say: marked points come first.
pub(crate) fn of_figure(FigureEntry { sheet, tables, .. }: &FigureEntry) -> String {
    // A panel that names no tables may show rows of any but what bounds areas.
    let shows = |panel: &PanelMark, table: &Table| match panel.tables.as_slice() {
        [] => table.drawn != DrawnAs::Areas,
        named => named.contains(&table.name),
    };
    let shown = tables.iter().filter(|table| sheet.panels().any(|panel| shows(panel, table)));
    let (points, others): (Vec<_>, Vec<_>) = shown.partition(|table| table.drawn == DrawnAs::Points);
    packed(points.into_iter().chain(others), &BOOKKEEPING, Rounding::Column(digits(sheet)))
}

/// A table for the scripts, compressed.
pub(crate) fn of_table(table: &Table) -> String {
    packed([table], &[], Rounding::Each(SHOWN_DIGITS))
}

/// The names of all columns that figures refer to by their headers, for the scripts.
pub(crate) fn column_names(report: &Report<'_>) -> String {
    let columns = report
        .all_figures()
        .flat_map(|figure| &figure.tables)
        .flat_map(|table| table.headers.iter().enumerate().map(move |column| (table, column)));
    let headings: BTreeMap<&str, Html> =
        columns.map(|(table, (place, header))| (header.as_str(), name(table, place))).collect();
    let pairs: Vec<String> = headings
        .iter()
        .map(|(name, heading)| format!("{}:{}", json_string(name), json_string(&heading.0)))
        .collect();
    format!("{{{}}}", pairs.join(","))
}

/// The digits at which a point keeps its place in every panel.
fn digits(sheet: &Sheet) -> usize {
    let along = |[low, high]: [f64; 2]| {
        let powers = Scientific::of(low.abs().max(high.abs()) / (high - low).abs()).exponent;
        usize::try_from(powers + 1 + DIGITS_ALONG_AXIS).unwrap_or(LEAST_DIGITS)
    };
    let ranges = sheet.panels().flat_map(|panel| [panel.frame.x, panel.frame.y]);
    ranges.map(along).max().unwrap_or(LEAST_DIGITS).clamp(LEAST_DIGITS, MOST_DIGITS)
}

/// The tables as JSON, each with whether it is a cloud, compressed, in letters; empty if there are none.
fn packed<'a>(tables: impl IntoIterator<Item = &'a Table>, without: &[&str], rounding: Rounding) -> String {
    let table = |table: &Table| {
        let text = json_string(&by_columns(table, without, rounding));
        format!("{}:[{},{text}]", json_string(table.name), table.drawn == DrawnAs::Cloud)
    };
    let tables: Vec<String> = tables.into_iter().map(table).collect();
    if tables.is_empty() {
        return String::new();
    }
    BASE64_STANDARD.encode(compress_to_vec(format!("{{{}}}", tables.join(",")).as_bytes(), COMPRESSION_LEVEL))
}

/// A line with the headers, one with the codes of the columns, one with the units, then every cell
/// on its own line, column by column, since neighbours in a column are alike. A column without a
/// code is written as it is; one with the code `decimals,order` is written without the decimal
/// point, and `order` times as differences from the cell before.
fn by_columns(table: &Table, without: &[&str], rounding: Rounding) -> String {
    let (mut headers, mut codes, mut units) = (Vec::new(), Vec::new(), Vec::new());
    let mut lines = Vec::new();
    for (place, header) in table.headers.iter().enumerate() {
        let column = &table.columns[place];
        if without.contains(&column.name) {
            continue;
        }
        let cells = || table.rows.iter().map(move |row| &row[place]);
        let differing = match rounding {
            Rounding::Column(digits) => differences(cells(), digits),
            Rounding::Each(_) => None,
        };
        let (Rounding::Each(digits) | Rounding::Column(digits)) = rounding;
        let (code, cells) = differing
            .unwrap_or_else(|| (String::new(), cells().map(|cell| written(cell, column, digits)).collect()));
        headers.push(header.as_str());
        units.push(table.units[place].as_str());
        codes.push(code);
        lines.extend(cells);
    }
    let separator = SEPARATOR.to_string();
    let heads = [headers.join(&separator), codes.join(&separator), units.join(&separator)];
    heads.into_iter().chain(lines).collect::<Vec<_>>().join("\n")
}

/// A column of numbers as differences, or differences of these, whichever is shortest; none if it
/// is not a column of numbers.
fn differences<'a>(cells: impl Iterator<Item = &'a Cell>, digits: usize) -> Option<(String, Vec<String>)> {
    let numbers = |cell: &Cell| matches!(cell, Cell::Number(_)).then(|| cell.number());
    let numbers: Vec<Option<f64>> = cells.map(numbers).collect::<Option<_>>()?;
    let largest = numbers.iter().flatten().fold(0.0_f64, |largest, number| largest.max(number.abs()));
    let decimals =
        usize::try_from(i32::try_from(digits).ok()? - 1 - Scientific::of(largest).exponent).unwrap_or(0);
    let whole = |number: f64| format!("{number:.decimals$}").replace('.', "").parse::<i64>().ok();
    let mut values = Vec::new();
    for number in numbers {
        values.push(match number {
            Some(number) => Some(whole(number)?),
            None => None,
        });
    }
    let candidates = (0..=2).map(|order| {
        if order > 0 {
            let mut before = 0;
            for value in values.iter_mut().flatten() {
                (before, *value) = (*value, value.checked_sub(before)?);
            }
        }
        let cells: Vec<String> =
            values.iter().map(|value| value.map_or_else(String::new, |value| value.to_string())).collect();
        Some((format!("{decimals},{order}"), cells))
    });
    let length = |(_, cells): &(String, Vec<String>)| cells.iter().map(String::len).sum::<usize>();
    candidates.flatten().min_by_key(length)
}

fn written(cell: &Cell, column: &Column, digits: usize) -> String {
    match cell {
        Cell::Text(words) if column.name == HYPOTHESIS.name => signs(words),
        Cell::Text(words) => words.replace('\n', " "),
        Cell::Verdict(word, _) => (*word).to_owned(),
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
    use grazing_drawing::{Bounds, Element};
    use grazing_results::Frame;

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
            by_columns(&table(), &["admissible"], Rounding::Each(7)),
            "kind|p|x\n||\n||\nSN\nSN\nPD\nP D\n1\n1\n1\n2\n0.35\n-567.9445\n\n-1.25e-17"
        );
        assert_eq!(
            by_columns(&table(), &["admissible"], Rounding::Column(7)),
            "kind|p|x\n||4,0\n||\nSN\nSN\nPD\nP D\n1\n1\n1\n2\n3500\n-5679445\n\n0"
        );
    }

    #[test]
    fn a_smooth_column_is_written_by_its_differences() {
        let written = |numbers: &[f64]| {
            let cells: Vec<Cell> = numbers.iter().map(|&number| number.into()).collect();
            differences(cells.iter(), 8).map(|(code, cells)| format!("{code}: {}", cells.join(" ")))
        };
        let line = [1.0, 1.1, 1.2, 1.3, f64::NAN, 1.4];
        assert_eq!(written(&line).as_deref(), Some("7,2: 10000000 -9000000 0 0  0"));
        assert_eq!(written(&[25.0, 25.0, 25.0]).as_deref(), Some("6,1: 25000000 0 0"));
        assert_eq!(written(&[1e-9, 0.0]).as_deref(), Some("16,0: 10000000 0"));
        assert_eq!(written(&[0.0]).as_deref(), Some("7,0: 0"));
        assert_eq!(differences([Cell::from("a")].iter(), 8), None);
    }

    #[test]
    fn what_is_packed_can_be_unpacked() {
        let bytes = BASE64_STANDARD.decode(of_table(&table())).unwrap();
        let text = miniz_oxide::inflate::decompress_to_vec(&bytes).unwrap();
        let text = String::from_utf8(text).unwrap();
        assert!(text.starts_with("{\"sample\":[false,\"kind|p|x|admissible\\n|||\\n|||\\nSN\\n"), "{text}");
    }

    #[test]
    fn a_narrow_panel_gets_more_digits_and_a_sketch_no_data() {
        let drawn = |x: [f64; 2], tables: &[&'static str]| {
            let bounds = Bounds { left: 0.0, top: 0.0, right: 10.0, bottom: 10.0 };
            let (titles, tables, frame) = (Default::default(), tables.to_vec(), Frame { x, y: [0.0, 1.0] });
            let mark = PanelMark { bounds, frame, titles, tables, only: None, columns: None, linear: true };
            Sheet { elements: vec![Element::Panel(mark)], ..Sheet::default() }
        };
        for (range, expected) in
            [([0.0, 4.0], 8), ([0.43, 0.44], 8), ([0.43, 0.4301], 9), ([1.0, 1.000_000_000_1], 12)]
        {
            assert_eq!(digits(&drawn(range, &["sample"])), expected, "{range:?}");
        }
        let is_empty = |sheet| {
            let (name, title, tables) = (String::new(), String::new().into(), vec![table()]);
            of_figure(&FigureEntry { name, title, sheet, tables }).is_empty()
        };
        assert!(is_empty(Sheet::default()) && !is_empty(drawn([0.0, 4.0], &["sample"])));
        assert!(is_empty(drawn([0.0, 4.0], &["other"])) && !is_empty(drawn([0.0, 4.0], &[])));
    }
}
