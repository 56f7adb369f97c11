//! Tables as CSV and as Parquet. That other programs read the latter is tested in packaging/python/tests.

use std::io::Cursor;

use grazing_cli::tables::{csv, parquet};
use grazing_results::columns::{BIFURCATION, LOOPS, STABLE, X};
use grazing_results::{Cell, Column, Names, Stability, Table};

const COLUMNS: &[Column] = &[BIFURCATION, LOOPS, X, STABLE];

/// A table of a word, a whole number, a number and a truth value.
fn table(rows: Vec<[Cell; 4]>) -> Table {
    let rows = rows.into_iter().map(Vec::from).collect();
    Table::of_cells("sample", COLUMNS, &Names::of_the_paper(), rows)
}

/// The table of these rows as CSV.
fn written(rows: Vec<[Cell; 4]>) -> String {
    String::from_utf8(csv(&table(rows)).expect("the table can be written")).expect("CSV is text")
}

fn row(number: f64) -> [Cell; 4] {
    ["SN-GZ".into(), 3.into(), number.into(), true.into()]
}

#[test]
fn computed_numbers_have_17_significant_digits_and_come_back_bit_by_bit() {
    let numbers = [1.0 / 3.0, 2.0_f64.sqrt() * 1e-200, -5e-324, f64::MAX, 0.1 + 0.2, 1e22];
    let text = written(numbers.map(row).into());
    let lines: Vec<&str> = text.lines().skip(1).collect();
    assert_eq!(lines.len(), numbers.len());
    for (line, number) in lines.iter().zip(numbers) {
        let cell = line.split(',').nth(2).expect("the number is the third cell");
        let mantissa = cell.split('e').next().unwrap_or_default();
        assert_eq!(mantissa.bytes().filter(u8::is_ascii_digit).count(), 17, "{cell}");
        assert_eq!(cell.parse::<f64>().map(f64::to_bits), Ok(number.to_bits()), "{cell}");
    }
}

#[test]
fn negative_zero_is_zero_and_what_is_not_a_number_is_empty() {
    let text = written([-0.0, f64::NAN, f64::NEG_INFINITY].map(row).into());
    let lines =
        ["kind,p,x,stable", "SN-GZ,3,0.0000000000000000e0,true", "SN-GZ,3,,true", "SN-GZ,3,,true", ""];
    assert_eq!(text, lines.join("\n"));
}

#[test]
fn a_neutral_solution_is_called_so_in_tables() {
    let [stable, neutral] = [true.into(), Stability::Neutral].map(|stability: Stability| {
        let mut cells = row(1.0);
        cells[3] = stability.into();
        cells
    });
    let words = |rows: Vec<[Cell; 4]>| -> Vec<String> {
        written(rows)
            .lines()
            .skip(1)
            .map(|line| line.rsplit(',').next().unwrap_or_default().to_owned())
            .collect()
    };
    assert_eq!(words(vec![stable.clone(), neutral.clone()]), ["true", "neutral"]);
    assert_eq!(words(vec![neutral, stable]), ["neutral", "true"]);
}

#[test]
fn texts_with_commas_and_quotation_marks_stand_between_such_marks_and_empty_ones_are_not_missing() {
    let texts = ["plain", "", "one, two", "a \"word\"", "two\nlines"];
    let rows = texts.map(|text| {
        let mut cells = row(1.0);
        cells[0] = text.into();
        cells
    });
    let wanted = ["plain", "\"\"", "\"one, two\"", "\"a \"\"word\"\"\"", "\"two\nlines\""];
    let lines = wanted.map(|text| format!("{text},3,1.0000000000000000e0,true\n"));
    assert_eq!(written(rows.into()), format!("kind,p,x,stable\n{}", lines.concat()));
}

#[test]
fn a_table_without_rows_has_its_header() {
    assert_eq!(written(Vec::new()), "kind,p,x,stable\n");
}

#[test]
fn parquet_says_what_columns_hold() {
    for rows in [vec![row(1.5), row(f64::NAN), row(-0.0)], Vec::new()] {
        let table = table(rows);
        let bytes = parquet(&table).expect("the table can be written");
        assert_eq!(bytes, parquet(&table).expect("the table can be written"));
        let read = polars_parquet::read::read_metadata(&mut Cursor::new(&bytes)).expect("it is Parquet");
        assert_eq!(read.num_rows, table.rows.len());
        let schema = polars_parquet::read::infer_schema(&read).expect("it has columns");
        assert_eq!(schema.len(), COLUMNS.len());
        for (field, column) in schema.iter_values().zip(COLUMNS) {
            let told =
                |key: &str| field.metadata.as_ref().and_then(|told| told.get(key)).map(|text| text.as_str());
            assert_eq!(field.name.as_str(), column.name);
            assert_eq!(told("meaning"), Some(column.meaning()));
            assert_eq!(told("equations").unwrap_or_default(), column.equations);
        }
    }
}
