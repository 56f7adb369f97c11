//! Data frames as CSV, the same bytes on every machine.

use polars::prelude::{ChunkApply, CsvWriter, DataFrame, DataType, IntoSeries, PolarsResult, SerWriter};

/// The digits after the point: with the one before it 17 significant digits, enough to tell any two numbers apart.
const DECIMALS: usize = 16;

/// The frame as CSV: a header, `.` decimals, computed numbers with 17 significant digits, `-0.0` as `0.0`, and an empty
/// cell for what is missing or not a number.
///
/// # Errors
/// Whatever the tables library finds wrong with the frame.
pub fn csv(frame: &DataFrame) -> PolarsResult<Vec<u8>> {
    let mut frame = canonical(frame)?;
    let mut bytes = Vec::new();
    CsvWriter::new(&mut bytes)
        .include_header(true)
        .with_float_scientific(Some(true))
        .with_float_precision(Some(DECIMALS))
        .finish(&mut frame)?;
    Ok(bytes)
}

/// The frame without negative zeros and NaN.
fn canonical(frame: &DataFrame) -> PolarsResult<DataFrame> {
    let mut canonical = frame.clone();
    for column in frame.columns() {
        if column.dtype() == &DataType::Float64 {
            let numbers = column.f64()?;
            // Adding 0.0 turns -0.0 into 0.0 and changes nothing else.
            let tidy =
                numbers.apply(|number| number.filter(|number| !number.is_nan()).map(|number| number + 0.0));
            canonical.with_column(tidy.into_series().into())?;
        }
    }
    Ok(canonical)
}
