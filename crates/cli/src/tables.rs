//! Tables as CSV by way of data frames, the same bytes on every machine.

use std::path::{Path, PathBuf};

use grazing_results::{Cell, Table};
use polars::prelude::{AnyValue, Column, CsvWriter, DataFrame, PolarsResult, SerWriter, Series};

use crate::failure::{Failure, computation};
use crate::folder::{DATA, OutputFile};

/// The digits after the point: with the one before it 17 significant digits, enough to tell any two
/// numbers apart.
const DECIMALS: usize = 16;

/// The table as CSV: a header, `.` decimals, computed numbers with 17 significant digits, `-0.0` as
/// `0.0`, and an empty cell for what is missing or not a finite number.
pub fn csv(table: &Table) -> PolarsResult<Vec<u8>> {
    let column = |(place, name): (usize, &String)| {
        let values: Vec<AnyValue<'_>> = table.rows.iter().map(|row| value(&row[place])).collect();
        Series::from_any_values(name.into(), &values, true).map(Column::from)
    };
    let columns = table.headers.iter().enumerate().map(column).collect::<PolarsResult<_>>()?;
    let mut bytes = Vec::new();
    CsvWriter::new(&mut bytes)
        .include_header(true)
        .with_float_scientific(Some(true))
        .with_float_precision(Some(DECIMALS))
        .finish(&mut DataFrame::new_infer_height(columns)?)?;
    Ok(bytes)
}

/// The file of a table, made for this output.
pub(crate) fn file(table: &Table, output: &'static str) -> Result<OutputFile, Failure> {
    let content = csv(table).map_err(|error| computation(output, &error))?;
    Ok(OutputFile { path: path(table.name), content })
}

/// Where a table lies in the output folder.
pub(crate) fn path(name: &str) -> PathBuf {
    Path::new(DATA).join(format!("{name}.csv"))
}

fn value(cell: &Cell) -> AnyValue<'_> {
    match cell {
        Cell::Text(words) => AnyValue::String(words),
        Cell::Integer(count) => AnyValue::UInt32(*count),
        Cell::Number(_) => cell.number().map_or(AnyValue::Null, AnyValue::Float64),
        Cell::Flag(yes) => AnyValue::Boolean(*yes),
    }
}
