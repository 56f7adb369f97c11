//! Tables, which are exported by Arrow's C interface.

use std::iter::once;

use grazing_cli::tables::columns;
use grazing_results::{Cell, Table as Rows};
use polars_arrow::array::{Array, StructArray};
use polars_arrow::datatypes::Field;
use polars_arrow::ffi::export_iterator;
use pyo3::exceptions::PyKeyError;
use pyo3::prelude::*;
use pyo3::types::{PyCapsule, PyList};

/// A table. ``polars.DataFrame(table)`` and ``pyarrow.table(table)`` use its columns without copying them.
///
/// ``table["omega"]`` is a column as a list. Cells without a value are null in frames and NaN in lists.
#[pyclass(frozen, module = "grazing")]
pub(crate) struct Table {
    rows: Rows,
    columns: StructArray,
}

impl Table {
    pub(crate) fn new(rows: Rows) -> Self {
        Self { columns: columns(&rows), rows }
    }
}

#[pymethods]
impl Table {
    /// The name of the table's CSV file, without ending.
    #[getter]
    fn name(&self) -> &'static str {
        self.rows.name
    }

    /// The headers of the columns.
    #[getter]
    fn columns(&self) -> Vec<&str> {
        self.rows.headers.iter().map(String::as_str).collect()
    }

    /// A column's symbol in LaTeX, unit, meaning and labels of equations in the paper.
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
            Cell::Verdict(word, _) => word.into_pyobject(py).map(Bound::into_any).map_err(PyErr::from),
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
        // The consumer may convert the types: a producer need not.
        let _ = requested_schema;
        let field = Field::new(self.rows.name.into(), self.columns.dtype().clone(), false);
        let stream = export_iterator(Box::new(once(Ok(self.columns.clone().boxed()))), field);
        PyCapsule::new_with_value(py, stream, c"arrow_array_stream")
    }

    /// The table as a ``polars.DataFrame``.
    fn to_polars<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        slf.py().import("polars")?.call_method1("DataFrame", (slf,))
    }

    /// The table as a ``pandas.DataFrame``, through pyarrow.
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
