//! Tables, which leave by Arrow's C interface.

use std::iter::once;
use std::sync::Arc;

use grazing_results::{Cell, Table as Rows};
use polars_arrow::array::{
    Array, BooleanArray, Float64Array, NullArray, StructArray, UInt32Array, Utf8Array,
};
use polars_arrow::datatypes::{ArrowDataType, Field};
use polars_arrow::ffi::export_iterator;
use pyo3::exceptions::PyKeyError;
use pyo3::prelude::*;
use pyo3::types::{PyCapsule, PyList};

/// A table: ``polars.DataFrame(table)`` and ``pyarrow.table(table)`` take its columns without copying them.
///
/// ``table["omega"]`` is a column as a list. Cells without a value are null, and NaN in lists.
#[pyclass(frozen, module = "grazing")]
pub(crate) struct Table {
    rows: Rows,
    columns: StructArray,
}

impl Table {
    pub(crate) fn new(rows: Rows) -> Self {
        let arrays: Vec<Box<dyn Array>> = (0..rows.columns.len()).map(|place| column(&rows, place)).collect();
        let field = |place: usize| {
            let told = [
                ("unit", rows.units[place].as_str()),
                ("symbol", &rows.symbols[place]),
                ("meaning", rows.columns[place].meaning()),
                ("equations", rows.columns[place].equations),
            ];
            let told = told.into_iter().filter(|(_, text)| !text.is_empty());
            let metadata = told.map(|(key, text)| (key.into(), text.into())).collect();
            let field = Field::new(rows.headers[place].as_str().into(), arrays[place].dtype().clone(), true);
            Field { metadata: Some(Arc::new(metadata)), ..field }
        };
        let fields = (0..arrays.len()).map(field).collect();
        let columns = StructArray::new(ArrowDataType::Struct(fields), rows.rows.len(), arrays, None);
        Self { rows, columns }
    }
}

/// A column as an array; its first cell tells of what.
fn column(table: &Rows, place: usize) -> Box<dyn Array> {
    let cells = table.rows.iter().map(|row| &row[place]);
    match cells.clone().next() {
        None => NullArray::new(ArrowDataType::Null, 0).boxed(),
        Some(Cell::Text(_)) => {
            let text = cells.map(|cell| if let Cell::Text(text) = cell { Some(&**text) } else { None });
            Utf8Array::<i64>::from_iter(text).boxed()
        }
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

#[pymethods]
impl Table {
    /// The name of its CSV file, without ending.
    #[getter]
    fn name(&self) -> &'static str {
        self.rows.name
    }

    /// The headers of its columns.
    #[getter]
    fn columns(&self) -> Vec<&str> {
        self.rows.headers.iter().map(String::as_str).collect()
    }

    /// What a column holds: its symbol in LaTeX, unit, meaning and labels of equations in the paper.
    fn about(&self, column: &str) -> PyResult<[&str; 4]> {
        let place = self.place(column)?;
        let about = &self.rows.columns[place];
        Ok([&self.rows.symbols[place], &self.rows.units[place], about.meaning(), about.equations])
    }

    fn __len__(&self) -> usize {
        self.rows.rows.len()
    }

    fn __contains__(&self, column: &str) -> bool {
        self.rows.position(column).is_some()
    }

    fn __getitem__<'py>(&self, py: Python<'py>, column: &str) -> PyResult<Bound<'py, PyList>> {
        let place = self.place(column)?;
        let cell = |row: &Vec<Cell>| match &row[place] {
            Cell::Text(text) => text.as_ref().into_pyobject(py).map(Bound::into_any).map_err(PyErr::from),
            Cell::Integer(count) => Ok(count.into_pyobject(py)?.into_any()),
            Cell::Flag(yes) => Ok(yes.into_pyobject(py)?.to_owned().into_any()),
            number => Ok(number.number().unwrap_or(f64::NAN).into_pyobject(py)?.into_any()),
        };
        PyList::new(py, self.rows.rows.iter().map(cell).collect::<PyResult<Vec<_>>>()?)
    }

    fn __repr__(&self) -> String {
        format!(
            "<grazing.Table {}: {} rows of {}>",
            self.rows.name,
            self.__len__(),
            self.columns().join(", ")
        )
    }

    /// The table as an Arrow stream of one batch: https://arrow.apache.org/docs/format/CDataInterface/PyCapsuleInterface.html
    #[pyo3(signature = (requested_schema=None))]
    fn __arrow_c_stream__<'py>(
        &self,
        py: Python<'py>,
        requested_schema: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyCapsule>> {
        // Whoever wants other types may convert them: a producer need not.
        let _ = requested_schema;
        let field = Field::new(self.rows.name.into(), self.columns.dtype().clone(), false);
        let stream = export_iterator(Box::new(once(Ok(self.columns.clone().boxed()))), field);
        PyCapsule::new_with_value(py, stream, c"arrow_array_stream")
    }

    /// The table as ``polars.DataFrame``.
    fn to_polars<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        slf.py().import("polars")?.call_method1("DataFrame", (slf,))
    }

    /// The table as ``pandas.DataFrame``, by way of pyarrow.
    fn to_pandas<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        slf.py().import("pyarrow")?.call_method1("table", (slf,))?.call_method0("to_pandas")
    }
}

impl Table {
    fn place(&self, column: &str) -> PyResult<usize> {
        let unknown =
            || PyKeyError::new_err(format!("{column}: the columns are {}", self.columns().join(", ")));
        self.rows.position(column).ok_or_else(unknown)
    }
}
