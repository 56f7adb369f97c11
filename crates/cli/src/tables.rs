//! Tables as data frames and as CSV, the same bytes on every machine.

use grazing_results::{Cell, Table};
use polars::prelude::{Column, CsvWriter, DataFrame, PolarsResult, SerWriter};

/// The digits after the point: with the one before it 17 significant digits, enough to tell any two numbers apart.
const DECIMALS: usize = 16;

/// The table as a data frame, whose columns have the types of the first row; what is not a finite number is missing.
///
/// # Errors
/// Whatever the tables library finds wrong.
pub fn frame(table: &Table) -> PolarsResult<DataFrame> {
    let column = |(place, name): (usize, &String)| {
        let cells = || table.rows.iter().map(|row| &row[place]);
        let name = name.into();
        match cells().next() {
            Some(Cell::Text(_)) => Column::new(name, cells().map(text).collect::<Vec<_>>()),
            Some(Cell::Integer(_)) => Column::new(name, cells().map(integer).collect::<Vec<_>>()),
            Some(Cell::Flag(_)) => Column::new(name, cells().map(flag).collect::<Vec<_>>()),
            Some(Cell::Number(_)) | None => Column::new(name, cells().map(Cell::number).collect::<Vec<_>>()),
        }
    };
    DataFrame::new_infer_height(table.headers.iter().enumerate().map(column).collect())
}

fn text(cell: &Cell) -> Option<&str> {
    if let Cell::Text(words) = cell { Some(words) } else { None }
}

fn integer(cell: &Cell) -> Option<u32> {
    if let Cell::Integer(value) = cell { Some(*value) } else { None }
}

fn flag(cell: &Cell) -> Option<bool> {
    if let Cell::Flag(value) = cell { Some(*value) } else { None }
}

/// The table as CSV: a header, `.` decimals, computed numbers with 17 significant digits, `-0.0` as `0.0`, and an empty
/// cell for what is missing or NaN.
///
/// # Errors
/// Whatever the tables library finds wrong.
pub fn csv(table: &Table) -> PolarsResult<Vec<u8>> {
    let mut bytes = Vec::new();
    CsvWriter::new(&mut bytes)
        .include_header(true)
        .with_float_scientific(Some(true))
        .with_float_precision(Some(DECIMALS))
        .finish(&mut frame(table)?)?;
    Ok(bytes)
}
