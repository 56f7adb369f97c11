//! Tables as arrays of Arrow, and from these as CSV and as Parquet, the same bytes on every machine.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use grazing_results::{Cell, Table};
use polars::prelude::{Column, CsvWriter, DataFrame, PolarsResult, SerWriter, Series};
use polars_arrow::array::{
    Array, BooleanArray, Float64Array, NullArray, StructArray, UInt32Array, Utf8Array,
};
use polars_arrow::datatypes::{ArrowDataType, ArrowSchema, Field};
use polars_arrow::record_batch::RecordBatchT;
use polars_parquet::write::{
    CompressionOptions, Encoding, FileWriter, StatisticsOptions, Version, WriteOptions, row_group_iter,
};

use crate::failure::{Failure, computation};
use crate::folder::{DATA, OutputFile};

/// The digits after the point: with the one before it 17 significant digits, enough to tell any two
/// numbers apart.
const DECIMALS: usize = 16;

/// The columns as arrays, each with unit, symbol, meaning and equations as metadata of its field.
/// Missing and non-finite numbers are null.
pub fn columns(table: &Table) -> StructArray {
    let arrays: Vec<Box<dyn Array>> = (0..table.columns.len()).map(|place| array(table, place)).collect();
    let field = |place: usize| {
        let told = [
            ("unit", table.units[place].as_str()),
            ("symbol", &table.symbols[place]),
            ("meaning", table.columns[place].meaning()),
            ("equations", table.columns[place].equations),
        ];
        let told = told.into_iter().filter(|(_, text)| !text.is_empty());
        let metadata = told.map(|(key, text)| (key.into(), text.into())).collect();
        let field = Field::new(table.headers[place].as_str().into(), arrays[place].dtype().clone(), true);
        Field { metadata: Some(Arc::new(metadata)), ..field }
    };
    let fields = (0..arrays.len()).map(field).collect();
    StructArray::new(ArrowDataType::Struct(fields), table.rows.len(), arrays, None)
}

/// A column as an array, whose type is that of its first cell.
fn array(table: &Table, place: usize) -> Box<dyn Array> {
    let cells = table.rows.iter().map(|row| &row[place]);
    let flags = |cell: &Cell| if let Cell::Flag(yes) = cell { Some(yes.to_string()) } else { None };
    let is_text = |cell: &Cell| cell.text().is_some();
    match cells.clone().next() {
        // Flags, and words where the answer is neither yes nor no.
        Some(Cell::Flag(_) | Cell::Text(_) | Cell::Verdict(..))
            if cells.clone().any(is_text) && cells.clone().any(|cell| flags(cell).is_some()) =>
        {
            let words = cells.map(|cell| cell.text().map(str::to_owned).or_else(|| flags(cell)));
            Utf8Array::<i64>::from_iter(words).boxed()
        }
        None => NullArray::new(ArrowDataType::Null, 0).boxed(),
        Some(Cell::Text(_) | Cell::Verdict(..)) => Utf8Array::<i64>::from_iter(cells.map(Cell::text)).boxed(),
        Some(Cell::Integer(_)) => {
            let count = cells.map(|cell| if let Cell::Integer(count) = cell { Some(*count) } else { None });
            UInt32Array::from_iter(count).boxed()
        }
        Some(Cell::Number(_)) => Float64Array::from_iter(cells.map(Cell::number)).boxed(),
        Some(Cell::Flag(_)) => {
            let flag = cells.map(|cell| if let Cell::Flag(yes) = cell { Some(*yes) } else { None });
            BooleanArray::from_iter(flag).boxed()
        }
    }
}

/// Starts polars' threads, which it would otherwise start with the first table: under a limit of the system that is nearly
/// reached by then, they could not be started, and polars would panic.
pub(crate) fn start_threads() {
    let _ = CsvWriter::new(std::io::sink());
}

/// The table as CSV: a header, `.` decimals, computed numbers with 17 significant digits, `-0.0` as
/// `0.0`, and an empty cell for null.
pub fn csv(table: &Table) -> PolarsResult<Vec<u8>> {
    let (fields, _, arrays, _) = columns(table).into_data();
    let column = |(field, array)| Series::try_from((field, vec![array])).map(Column::from);
    let columns = fields.iter().zip(arrays).map(column).collect::<PolarsResult<_>>()?;
    let mut bytes = Vec::new();
    CsvWriter::new(&mut bytes)
        .include_header(true)
        .with_float_scientific(Some(true))
        .with_float_precision(Some(DECIMALS))
        .finish(&mut DataFrame::new_infer_height(columns)?)?;
    Ok(bytes)
}

/// The table as Parquet, not compressed: that would need a C compiler, and a table has a few thousand rows.
pub fn parquet(table: &Table) -> PolarsResult<Vec<u8>> {
    let (fields, length, arrays, _) = columns(table).into_data();
    let options = WriteOptions {
        statistics: StatisticsOptions::default(),
        version: Version::V1,
        compression: CompressionOptions::Uncompressed,
        data_page_size: None,
    };
    let encodings = vec![vec![Encoding::Plain]; fields.len()].into();
    let schema: ArrowSchema = fields.into_iter().map(|field| (field.name.clone(), field)).collect();
    let mut writer = FileWriter::try_new(Vec::new(), schema.clone(), options)?;
    let types = writer.parquet_schema().fields().to_vec();
    let rows = RecordBatchT::new(length, Arc::new(schema), arrays);
    writer.write(length as u64, row_group_iter(rows, encodings, types, options))?;
    writer.end(None)?;
    Ok(writer.into_inner())
}

/// The CSV file of a table, computed for this output.
pub(crate) fn file(table: &Table, output: &'static str) -> Result<OutputFile, Failure> {
    let content = csv(table).map_err(|error| computation(output, &error))?;
    Ok(OutputFile { path: path(table.name), content })
}

/// The Parquet file of a table, computed for this output.
pub(crate) fn parquet_file(table: &Table, output: &'static str) -> Result<OutputFile, Failure> {
    let content = parquet(table).map_err(|error| computation(output, &error))?;
    Ok(OutputFile { path: parquet_path(table.name), content })
}

/// The path of a table's CSV file in the output folder.
pub(crate) fn path(name: &str) -> PathBuf {
    Path::new(DATA).join(format!("{name}.csv"))
}

/// The path of a table's Parquet file in the output folder.
pub(crate) fn parquet_path(name: &str) -> PathBuf {
    path(name).with_extension("parquet")
}
